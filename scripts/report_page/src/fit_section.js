// A fit: its verdict, parameters with intervals, the curve against the measurement, the likelihood, the search.

import { chart } from './charts.js';
import { numberNamed } from './data.js';
import { h, note, section, svg, table } from './dom.js';
import { frame, key, path, roomy, scale } from './drawing.js';
import { surfaceDrawing } from './surface.js';
import { nameText, numberText, quantity, shortName, unitText, withUnit, words } from './words.js';

function verdict(parent, fit, status) {
  const { result } = fit;
  const text = result.verdict || 'This file holds no verdict.';
  const { first, second, agree } = result.cross_check;
  const good = result.grade ? ['determined', 'assumption'].includes(result.grade) : result.identifiable;
  const facts = [
    status && `Status: ${words(status)}`,
    result.grade && `grade: ${words(result.grade)}`,
    result.gates.length > 0 && `gates: ${result.gates.map(({ name }) => words(name)).join(', ')}`,
    result.input && `recording: ${result.input}`,
    result.algorithm && `search: ${words(result.algorithm)}`,
    result.stop_reason,
    second && `${first} and ${second} ${agree ? 'agree' : 'do not agree'}`,
  ].filter(Boolean);
  section(
    parent,
    'Verdict',
    h('p', { class: good ? 'verdict' : 'verdict warned' }, text),
    h('p', null, `${facts.join('; ')}.`),
    ...result.gates.filter(({ sentence }) => sentence !== text).map(({ name, sentence }) => note(`Gate ${words(name)}: ${sentence}`)),
    ...result.notes.map((text) => note(text)),
    baseline(result.statistics),
  );
}

function baseline(statistics) {
  const [ours, theirs] = ['nrmse_percent', 'baseline_nrmse_percent'].map((name) => numberNamed(statistics, name));
  if (!Number.isFinite(ours) || !Number.isFinite(theirs)) return note('This file holds no baseline to compare with.');
  const most = Math.max(ours, theirs) || 1;
  const row = (label, value, ink) => {
    const fill = h('span', { class: `fill swatch-${ink}` });
    fill.style.width = `${(100 * value) / most}%`;
    return h('div', { class: 'readout' }, h('span', null, label), h('output', null, quantity(value, 'percent', 3)), h('span', { class: 'gauge' }, fill));
  };
  const [bic, baseBic] = ['bic', 'baseline_bic'].map((name) => numberNamed(statistics, name));
  const better = Number.isFinite(bic - baseBic) ? ` BIC ${numberText(bic, 5)} against ${numberText(baseBic, 5)}: ${bic < baseBic ? 'the trunk' : 'the one-compartment model'} explains the trace better for its number of parameters.` : '';
  return h('div', { class: 'baseline' }, h('h3', null, 'Residual (RMS, of the tidal volume) against the baseline'), h('div', { class: 'readouts' }, row('this trunk', ours, 'blue'), row('one-compartment model', theirs, 'grey')), better ? h('p', null, better) : null);
}

const grades = { determined: 'determined', assumption: 'assumes', not_determined: 'not determined', not_converged: 'not converged' };

/** "0.503 (0.202 to 1.7) s"; a number that a gate withholds is null. */
function resultText({ value, lower95, upper95, unit }) {
  if (value === null) return 'withheld';
  if (lower95 > 0 && upper95 > 1e4 * lower95) return `${numberText(value, 2)} ${unitText(unit)} (not known)`;
  const end = (v) => (v === null ? 'no limit' : numberText(v, 3));
  return `${numberText(value, 3)} (${end(lower95)} to ${end(upper95)}) ${unitText(unit)}`.trim();
}

/** Results with grades; what they stand on, or why they are not determined, stands once below the table. */
function results(parent, fit) {
  if (fit.results.length === 0) return;
  const notes = [];
  const marks = (parts) => {
    const numbers = parts.map((part) => {
      if (!notes.includes(part)) notes.push(part);
      return notes.indexOf(part) + 1;
    });
    return `(${numbers.sort((a, b) => a - b).join(', ')})`;
  };
  const straight = new Map(fit.straight.map((r) => [r.name, r]));
  const rows = fit.results.map((r) => {
    const why = r.reason ? [r.reason] : r.grade === 'assumption' ? r.assumption.split('; ') : [];
    const cells = [nameText(r.name), resultText(r), [grades[r.grade] ?? words(r.grade), why.length > 0 && marks(why)].filter(Boolean).join(' ')];
    if (straight.size > 0) cells.push(straight.has(r.name) ? resultText(straight.get(r.name)) : '');
    return [...cells, r.meaning];
  });
  const heads = ['result', 'value (95 % interval)', 'grade', ...(straight.size > 0 ? ['if the activation is made of straight lines'] : []), 'what it says'];
  section(
    parent,
    'Results',
    table(heads, rows, { caption: 'Results with 95 % intervals and grades' }),
    h('ol', { class: 'small' }, notes.map((text) => h('li', null, text))),
    straight.size > 0 ? note(`Straight lines are what the paper assumes of the activation; their residual is ${quantity(fit.straight_nrmse_percent, 'percent', 2)} of the tidal volume.`) : null,
  );
}

const fitted = (parameters) => parameters.filter((p) => p.free || p.beside);

/** The best value in its interval, drawn. */
function interval(p) {
  const { best, lower95: low, upper95: high } = p;
  if (![best, low, high].every(Number.isFinite)) return 'interval not known';
  const room = 0.35 * (high - low) || Math.abs(best) * 0.1 || 1;
  const x = scale([Math.min(low, p.best) - room, Math.max(high, p.best) + room], [0, 180]);
  return svg(
    'svg',
    { viewBox: '0 0 180 20', class: 'interval', 'aria-hidden': 'true' },
    svg('line', { x1: 0, x2: 180, y1: 10, y2: 10, class: 'thin' }),
    svg('line', { x1: x(low), x2: x(high), y1: 10, y2: 10, class: 'thick' }),
    svg('circle', { cx: x(best), cy: 10, r: 4.5, class: 'best' }),
  );
}

function parameters(parent, fit) {
  const rows = fitted(fit.parameters).map((p) => [
    p.name,
    numberText(p.best, 5),
    numberText(p.stderr, 3),
    `${numberText(p.lower95, 4)} to ${numberText(p.upper95, 4)}`,
    unitText(p.unit),
    interval(p),
    [p.at_bound ? 'AT ITS BOUND' : '', p.beside ? 'estimated beside' : ''].filter(Boolean).join(', '),
  ]);
  const statistics = fit.result.statistics.map((s) => [nameText(s.name), numberText(s.value, 5), unitText(s.unit)]);
  section(
    parent,
    'Parameters',
    table(['parameter', 'best', 'standard error', '95 % interval', 'unit', 'best and interval', ''], rows, { caption: 'Parameters with 95 % intervals (each drawn on its own scale)', numeric: [1, 2, 3] }),
    h('details', null, h('summary', null, 'All statistics'), table(['', 'value', 'unit'], statistics, { numeric: [1] })),
  );
}

/** The two edges of the band of one standard deviation about a measured curve. */
function deviations(time, values, sigma) {
  const edge = (sign) => ({ time, values: values.map((v, i) => v + sign * sigma[i]), colour: 'band-edge', width: 0.5 });
  return [{ ...edge(1), label: 'measured + 1 SD', band: 'band', unnamed: true }, { ...edge(-1), label: 'measured − 1 SD', unnamed: true }];
}

/** What was recorded beside the volume, and the model of it. */
function channelChart(grid, { unit, meaning, measured, sigma, model }, time, clock) {
  const series = [...deviations(time, measured, sigma), { label: 'measured', time, values: measured, colour: 'grey' }];
  if (model) series.push({ label: 'model', time, values: model, colour: 'blue', style: 1 });
  chart(grid, { title: meaning[0].toUpperCase() + meaning.slice(1), unit, series, clock, zero: true, height: 260 });
}

function curves(parent, fit, clock) {
  const { measured, result } = fit;
  const box = section(parent, 'Model against measurement');
  if (!measured?.measured || !result.dV_fit) {
    box.append(note('This file holds no measured curve.'));
    return;
  }
  const grid = h('div', { class: 'charts' });
  box.append(grid);
  const series = measured.sigma ? deviations(measured.time, measured.measured, measured.sigma) : [];
  series.push({ label: 'measured', time: measured.time, values: measured.measured, colour: 'grey' }, { label: 'model', time: result.time, values: result.dV_fit, colour: 'blue', style: 1 });
  if (result.dV_baseline) series.push({ label: 'one compartment', time: result.time, values: result.dV_baseline, colour: 'green', style: 2 });
  chart(grid, { title: 'Lung volume above end-expiration, ΔV', unit: 'ml', series, clock, zero: true, height: 260 });
  const residuals = [{ label: 'model − measured', time: result.time, values: result.residual, colour: 'orange' }];
  if (result.dV_baseline) residuals.push({ label: 'one compartment − measured', time: result.time, values: result.dV_baseline.map((v, i) => v - measured.measured[i]), colour: 'green', style: 2 });
  chart(grid, { title: 'Residual of ΔV', unit: 'ml', series: residuals, clock, zero: true, height: 260 });
  for (const channel of fit.channels) channelChart(grid, channel, measured.time, clock);
  if (measured.sigma) box.append(note('Shaded: measured ± 1 standard deviation over the breaths.'));
  if (fit.channels.length > 0) box.append(note('What was recorded beside the volume is its change from end-expiration. The model has the offset, the drift, or the gain and delay of an EMG that fit best.'));
  if (!result.dV_baseline) box.append(note('The curve of the one-compartment model is not in this file; its residual stands in the verdict.'));
}

function profileDrawing(profile) {
  const { value, deviance } = profile;
  const [low, high] = profile.interval95;
  const drawn = value.map((v, i) => [v, deviance[i]]).filter(([v, d]) => v !== null && d !== null);
  const threshold = profile.threshold95;
  const ends = [low, high].map((v) => (Number.isFinite(v) ? numberText(v, 4) : 'not closed'));
  const log = Math.min(...drawn.map(([v]) => v)) > 0;
  return frame(
    {
      title: `Profile of ${profile.name}`,
      summary: `95 % interval ${ends.join(' to ')} ${unitText(profile.unit)}`,
      x: { label: withUnit(profile.name, profile.unit), range: roomy(drawn.map(([v]) => v), { log }), log },
      y: { label: 'deviance above its best', range: [0, Math.max(1.4 * threshold, Math.min(20, 1.05 * Math.max(...drawn.map(([, d]) => d))))] },
      width: 380,
      height: 260,
    },
    (inner, x, y) => {
      const [from, to] = [low ?? x.domain[0], high ?? x.domain[1]];
      inner.append(
        svg('rect', { class: 'inside', x: x(from), width: Math.max(0, x(to) - x(from)), y: 0, height: 260 }),
        svg('line', { class: 'threshold', x1: 0, x2: 380, y1: y(threshold), y2: y(threshold) }),
        path(drawn.map(([v, d]) => [x(v), y(d)]), { class: 'line blue' }),
        ...drawn.map(([v, d], i) => svg('circle', { cx: x(v), cy: y(d), r: 3, class: profile.at_bound[i] ? 'dot orange' : 'dot blue' })),
      );
    },
  );
}

function likelihood(parent, fit) {
  const box = section(parent, 'Likelihood');
  const few = fit.surface && fit.profiles.length <= 2;
  const drawings = h('div', { class: few ? 'drawings beside-each-other' : 'drawings' });
  box.append(drawings);
  if (fit.surface) drawings.append(surfaceDrawing(fit.surface, fit));
  else box.append(note('The likelihood surface is not in this file: it is made where two parameters are free.'));
  const profiles = h('div', { class: 'drawings profiles' }, fit.profiles.map(profileDrawing));
  (few ? drawings : box).append(profiles);
  if (fit.profiles.length === 0) box.append(note('Profiles are not in this file.'));
  else {
    box.append(
      key([
        { label: 'profile: the fit as one parameter is moved and the others follow', colour: 'blue' },
        { label: `95 % level, ${numberText(fit.profiles[0].threshold95, 3)}`, colour: 'grey', style: 'dashed' },
        { label: 'shaded: 95 % interval', colour: 'inside', style: 'block' },
        { label: 'another parameter sat on its bound', colour: 'orange', style: 'dot' },
      ]),
    );
  }
}

function convergence(parent, fit) {
  const box = section(parent, 'Convergence');
  if (fit.objective.length === 0) {
    box.append(note('The evaluations of the search are not in this file.'));
    return;
  }
  const { objective } = fit;
  const tried = Array.from(objective, (v, i) => [i + 1, v]);
  const done = tried.filter(([, v]) => Number.isFinite(v) && v > 0);
  if (done.length === 0) {
    box.append(note('Every simulation of this search failed.'));
    return;
  }
  let best = Infinity;
  const steps = done.flatMap(([i, v]) => {
    const before = best;
    best = Math.min(best, v);
    return Number.isFinite(before) ? [[i, before], [i, best]] : [[i, best]];
  });
  const failed = tried.length - done.length;
  box.append(
    frame(
      {
        title: 'The objective over the search',
        summary: `${tried.length} simulations, ${failed} failed, best ${numberText(best)}`,
        x: { label: 'simulation', range: [0, tried.length + 1] },
        y: { label: 'objective (no unit)', range: roomy(done.map(([, v]) => v), { log: true }), log: true },
        width: 720,
        height: 260,
        wide: true,
      },
      (inner, x, y) =>
        inner.append(
          ...done.map(([i, v]) => svg('circle', { cx: x(i), cy: y(v), r: 2, class: 'dot grey' })),
          path(steps.map(([i, v]) => [x(i), y(v)]), { class: 'line blue' }),
        ),
    ),
    key([{ label: 'each simulation', colour: 'grey', style: 'dot' }, { label: 'the best so far', colour: 'blue' }]),
    h('p', null, `${tried.length} simulations, ${failed} failed; the best objective is ${numberText(best, 6)}.`),
  );
}

function breaths(parent, { breaths: found }) {
  if (!found) return;
  const column = (name) => found.columns.find((c) => c.name === name);
  const [number, muscle, low, high] = ['number', 'k_muscle', 'k_muscle_lower95', 'k_muscle_upper95'].map(column);
  const box = section(parent, 'Breath by breath');
  if (number && muscle && low && high)
    box.append(
      frame(
        {
          title: 'k_muscle of each breath, with 95 % interval',
          x: { label: 'breath', range: roomy(number.values) },
          y: { label: withUnit('k_muscle', muscle.unit), range: roomy([...low.values, ...high.values, ...muscle.values]) },
          width: 720,
          wide: true,
        },
        (inner, x, y) =>
          number.values.forEach((n, i) => {
            if (muscle.values[i] === null) return;
            if (low.values[i] !== null && high.values[i] !== null) inner.append(svg('line', { class: 'line blue', x1: x(n), x2: x(n), y1: y(low.values[i]), y2: y(high.values[i]) }));
            inner.append(svg('circle', { cx: x(n), cy: y(muscle.values[i]), r: 4, class: 'dot blue' }));
          }),
      ),
    );
  const heads = [...found.columns.map((c) => withUnit(shortName(c.name), c.unit)), 'status'];
  const rows = found.status.map((status, i) => [...found.columns.map((c) => numberText(c.values[i], 5)), status]);
  box.append(table(heads, rows, { caption: 'Fitted breaths', numeric: found.columns.map((_, i) => i) }));
}

const PREDICTED = {
  delta_v_ml: 'ΔV there (ml)',
  own_delta_v_ml: 'ΔV in its own scenario (ml)',
  ratio_percent: 'ratio (%)',
  excursion_right_mm: 'right dome (mm)',
  excursion_left_mm: 'left dome (mm)',
  excursion_right_most_risen_mm: 'right dome, most risen (mm)',
  excursion_left_most_risen_mm: 'left dome, most risen (mm)',
  delta_l_mm: 'ΔL (mm)',
  delta_h_mm: 'ΔH (mm)',
};

function predictions(parent, fit) {
  if (fit.predictions.length === 0) return;
  const structural = fit.predictions.some((p) => p.structure !== null);
  const rows = fit.predictions.flatMap(({ name, numbers }) =>
    Object.entries(PREDICTED).filter(([number]) => numbers.some((n) => n.name === number)).map(([number, label], i) => {
      const at = (end) => numberText(numberNamed(numbers, number + end), 4);
      const range = (kind) => `${at(`${kind}_lower95`)} to ${at(`${kind}_upper95`)}`;
      return [i === 0 ? name : '', label, at(''), range(''), ...(structural ? [range('_structural')] : [])];
    }),
  );
  section(
    parent,
    'What the fit makes of other scenarios',
    table(['scenario', 'number', 'value', 'of the fit', ...(structural ? ['over choices of the model'] : [])], rows, { caption: 'Predictions with 95 % intervals', numeric: [2, 3, 4] }),
    ...fit.predictions.filter((p) => p.structure !== null).flatMap(choices),
  );
}

/** The choices of the model behind a prediction, and the part of the variance that each makes up. */
function choices({ name, structure }) {
  const notes = structure.left_out.map((sentence) => note(sentence));
  if (structure.choices.length === 0) return notes;
  const measures = Object.keys(PREDICTED).filter((m) => structure.measures.includes(m) && !m.includes('delta_v'));
  const rows = structure.choices.map((choice, i) => {
    const unit = choice.unit === '1' ? '' : ` ${choice.unit}`;
    const share = (measure) => structure.shares[structure.measures.indexOf(measure) * structure.choices.length + i];
    const part = (of) => (of === null ? '' : `${Math.round(100 * of)} %`);
    return [choice.name.replaceAll('_', ' '), `${numberText(choice.low, 4)} to ${numberText(choice.high, 4)}${unit}`, ...measures.map((m) => part(share(m))), choice.source];
  });
  const heads = ['choice', 'range', ...measures.map((m) => PREDICTED[m].replace(/ \(.*/, '')), 'source of the range'];
  return [table(heads, rows, { caption: `Choices of the model behind ${name}, and their part of the variance`, numeric: measures.map((_, i) => i + 2) }), ...notes];
}

export function fitSections(parent, file, clock) {
  const { fit } = file;
  verdict(parent, fit, file.status);
  results(parent, fit);
  curves(parent, fit, clock);
  if (fit.result.gates.length > 0) section(parent, 'Parameters', note('A gate stands against this recording. The file holds the parameters of the simulation, but they are no results.'));
  else {
    parameters(parent, fit);
    likelihood(parent, fit);
  }
  convergence(parent, fit);
  breaths(parent, fit);
  predictions(parent, fit);
}
