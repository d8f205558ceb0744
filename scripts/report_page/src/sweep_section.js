// A sweep: small multiples with the scenarios laid over each other, one number against a parameter, a table to sort.

import { extremes } from './data.js';
import { h, note, section, svg } from './dom.js';
import { frame, key, path, roomy, scale, ticks } from './drawing.js';
import { nameText, numberText, shortName, unitText, withUnit, words } from './words.js';

const inks = ['blue', 'orange', 'green', 'purple', 'grey'];
const dashes = ['solid', 'wide', 'dashed', 'dotted', 'mixed']; // so that lines on each other are seen, as of mirror images
const mostCells = 60;

/** What was varied carries the key of a scenario, with a dot; what came out does not. */
const isVaried = (column) => column.name.includes('.');

function looks(sweep) {
  const scenarios = [...new Set(sweep.scenario)];
  return new Map(scenarios.map((s, i) => [s, { ink: inks[i % inks.length], dash: dashes[i % dashes.length] }]));
}

/** Runs that differ in their scenario only: [{values, subject, runs}], in the order of the values. */
function cellsOf(sweep, varied) {
  const cells = new Map();
  for (let run = 0; run < sweep.rows; ++run) {
    const values = varied.map((c) => c.values[run]);
    const subject = sweep.subject?.[run];
    const id = [subject, ...values].join();
    if (!cells.has(id)) cells.set(id, { values, subject, runs: [] });
    cells.get(id).runs.push(run);
  }
  return [...cells.values()].sort((a, b) => {
    const k = a.values.findIndex((v, i) => v !== b.values[i]);
    return k < 0 ? 0 : a.values[k] - b.values[k];
  });
}

/** One small plot; all have the same axes. */
function cell(sweep, { values, subject, runs }, varied, look, range) {
  const { time, samples, values: volumes } = sweep.curves;
  const [width, height, left, bottom] = [170, 116, 34, 18];
  const x = scale([time[0], time[samples - 1]], [left, width - 4]);
  const y = scale(range, [height - bottom, 6]);
  const picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true' });
  for (const v of ticks(range, 3)) picture.append(svg('line', { class: 'rule', x1: left, x2: width, y1: y(v), y2: y(v) }), svg('text', { x: left - 4, y: y(v) + 3, 'text-anchor': 'end' }, numberText(v, 3)));
  for (const v of ticks(x.domain, 3)) picture.append(svg('text', { x: x(v), y: height - 5, 'text-anchor': 'middle' }, `${numberText(v, 3)}`));
  picture.append(svg('text', { x: 2, y: 10 }, 'ml'), svg('text', { x: width - 2, y: height - 5, 'text-anchor': 'end' }, 's'));
  const failed = [];
  for (const run of runs) {
    const curve = volumes.subarray(run * samples, (run + 1) * samples);
    if (sweep.status[run] !== 'completed') failed.push(sweep.scenario?.[run] ?? run);
    const { ink, dash } = look.get(sweep.scenario?.[run]) ?? { ink: 'blue', dash: 'solid' };
    picture.append(path(Array.from(curve, (v, i) => [x(time[i]), y(v)]), { class: `line ${ink} ${dash}` }));
  }
  const settings = varied.map((c, i) => `${shortName(c.name)} ${numberText(values[i], 4)} ${unitText(c.unit)}`.trim());
  if (subject) settings.unshift(subject);
  const name = settings.join(', ');
  const peaks = runs.map((run) => `${words(sweep.scenario?.[run] ?? '')} ${numberText(extremes(volumes.subarray(run * samples, (run + 1) * samples))[1], 4)} ml`);
  return h(
    'figure',
    { class: 'cell', role: 'img', 'aria-label': `${name}: largest ΔV ${peaks.join(', ')}` },
    h('figcaption', null, settings.length > 0 ? settings.map((s) => h('span', null, s)) : 'all runs'),
    picture,
    failed.length > 0 ? h('p', { class: 'failed' }, `failed: ${failed.map((s) => words(String(s))).join(', ')}`) : null,
  );
}

const legend = (look) => key([...look].map(([name, { ink, dash }]) => ({ label: words(name), colour: ink, style: dash })));

function smallMultiples(parent, sweep, varied, look) {
  const box = section(parent, 'ΔV over time (ml over s), the scenarios laid over each other');
  if (!sweep.curves) {
    box.append(note('There are no curves in this file.'));
    return;
  }
  box.append(legend(look));
  const [low, high] = extremes(sweep.curves.values);
  const range = Number.isFinite(low) ? [Math.min(0, low), high + 0.05 * (high - low || 1)] : [0, 1];
  const cells = cellsOf(sweep, varied);
  const last = varied[varied.length - 1];
  const columns = last ? new Set(last.values).size : 1;
  const grid = h('div', { class: 'cells' });
  if (varied.length > 1 && columns <= 6 && cells.length % columns === 0) grid.style.setProperty('--columns', columns);
  let shown = 0;
  const more = h('button', { type: 'button', onclick: () => show() });
  const show = () => {
    for (const one of cells.slice(shown, shown + mostCells)) grid.append(cell(sweep, one, varied, look, range));
    shown = Math.min(cells.length, shown + mostCells);
    more.hidden = shown === cells.length;
    more.textContent = `Show more: ${shown} of ${cells.length} are drawn`;
  };
  show();
  box.append(grid, more);
}

function select(label, columns, chosen, change) {
  const element = h(
    'select',
    { onchange: () => change(columns[element.selectedIndex]) },
    columns.map((c) => h('option', { selected: c === chosen }, withUnit(nameText(c.name) === c.name ? shortName(c.name) : nameText(c.name), c.unit))),
  );
  return h('label', null, label, element);
}

function against(parent, sweep, varied, look) {
  const box = section(parent, 'One number against a parameter');
  const outcomes = sweep.columns.filter((c) => !isVaried(c) && c.values.some((v) => v !== null));
  if (varied.length === 0 || outcomes.length === 0) {
    box.append(note('Nothing was varied, or nothing came out.'));
    return;
  }
  let [x, y] = [varied[0], outcomes.find((c) => c.name === 'delta_v_ml') ?? outcomes[0]];
  const place = h('div');
  const draw = () => {
    const log = x.values.every((v) => v > 0) && Math.max(...x.values) / Math.min(...x.values) > 8;
    place.replaceChildren(
      frame(
        {
          title: `${nameText(y.name)} against ${shortName(x.name)}`,
          x: { label: withUnit(shortName(x.name), x.unit), range: roomy(x.values, { log }), log },
          y: { label: withUnit(nameText(y.name), y.unit), range: roomy(y.values, { zero: true }) },
          width: 720,
          height: 340,
          wide: true,
        },
        (inner, sx, sy) => drawPoints(inner, sweep, varied, look, x, y, sx, sy),
      ),
    );
  };
  draw();
  box.append(
    h('div', { class: 'controls' }, select('Over ', varied, x, (c) => ((x = c), draw())), select('show ', outcomes, y, (c) => ((y = c), draw()))),
    legend(look),
    place,
    varied.length > 1 ? note('A line joins runs that differ in this parameter alone.') : '',
  );
}

function drawPoints(inner, sweep, varied, look, x, y, sx, sy) {
  const others = varied.filter((c) => c !== x);
  const lines = new Map();
  for (let run = 0; run < sweep.rows; ++run) {
    if (y.values[run] === null || x.values[run] === null) continue;
    const id = [sweep.scenario?.[run], sweep.subject?.[run], ...others.map((c) => c.values[run])].join();
    if (!lines.has(id)) lines.set(id, []);
    lines.get(id).push(run);
  }
  for (const runs of lines.values()) {
    runs.sort((a, b) => x.values[a] - x.values[b]);
    const { ink, dash } = look.get(sweep.scenario?.[runs[0]]) ?? { ink: 'blue', dash: 'solid' };
    inner.append(path(runs.map((run) => [sx(x.values[run]), sy(y.values[run])]), { class: `line ${ink} ${dash}` }));
    for (const run of runs) {
      const dot = svg('circle', { cx: sx(x.values[run]), cy: sy(y.values[run]), r: 3.5, class: `dot ${ink}` });
      dot.append(svg('title', null, `run ${run}: ${numberText(y.values[run], 5)} ${unitText(y.unit)}`));
      inner.append(dot);
    }
  }
}

function sortable(parent, sweep) {
  const columns = [
    { head: 'run', value: (run) => run, text: (run) => String(run), numeric: true },
    { head: 'scenario', value: (run) => sweep.scenario?.[run] ?? '', text: (run) => sweep.scenario?.[run] ?? '' },
    ...(sweep.subject ? [{ head: 'subject', value: (run) => sweep.subject[run], text: (run) => sweep.subject[run] }] : []),
    ...sweep.columns.map((c) => ({
      head: withUnit(isVaried(c) ? shortName(c.name) : words(shortName(c.name)), c.unit),
      title: `${nameText(c.name)}`,
      value: (run) => c.values[run],
      text: (run) => (c.values[run] === null ? '–' : numberText(c.values[run], 5)),
      numeric: true,
    })),
    { head: 'status', value: (run) => sweep.status[run], text: (run) => words(sweep.status[run] + (sweep.error?.[run] ? `: ${sweep.error[run]}` : '')) },
  ];
  const body = h('tbody');
  const order = Array.from({ length: sweep.rows }, (_, i) => i);
  const fill = () => body.replaceChildren(...order.map((run) => h('tr', null, columns.map((c) => h('td', { class: c.numeric ? 'number' : undefined }, c.text(run))))));
  const heads = columns.map((c) => h('th', { scope: 'col', class: c.numeric ? 'number' : undefined }));
  columns.forEach((c, i) => {
    heads[i].append(
      h('button', { type: 'button', title: c.title ? `sort by ${c.title}` : 'sort', onclick: () => {
        const down = heads[i].getAttribute('aria-sort') === 'ascending';
        for (const head of heads) head.removeAttribute('aria-sort');
        heads[i].setAttribute('aria-sort', down ? 'descending' : 'ascending');
        const compare = (a, b) => (typeof a === 'string' ? a.localeCompare(b, 'en') : a - b);
        order.sort((a, b) => {
          const [va, vb] = [c.value(a), c.value(b)];
          if (va === null || vb === null) return (va === null) - (vb === null); // what is not known comes last
          return (down ? -1 : 1) * compare(va, vb) || a - b;
        });
        fill();
      } }, c.head),
    );
  });
  fill();
  const shown = sweep.rows < sweep.runs ? note(`The first ${sweep.rows} of ${sweep.runs} runs are shown.`) : null;
  section(
    parent,
    'All runs',
    h('p', null, 'Press a heading to sort by it.'),
    h('div', { class: 'scrolls', tabindex: 0, role: 'region', 'aria-label': 'all runs' }, h('table', { class: 'sortable' }, h('thead', null, h('tr', null, heads)), body)),
    shown,
  );
}

function counts(parent, sweep) {
  const found = new Map();
  for (const status of sweep.status) found.set(status, (found.get(status) ?? 0) + 1);
  const text = [...found].map(([status, n]) => `${n} ${words(status)}`).join(', ');
  parent.append(h('p', { class: 'verdict' }, `${sweep.runs} runs: ${text}.`));
}

export function sweepSections(parent, { sweep }) {
  const varied = sweep.columns.filter(isVaried).filter((c) => new Set(c.values).size > 1);
  const look = looks(sweep);
  counts(parent, sweep);
  smallMultiples(parent, sweep, varied, look);
  against(parent, sweep, varied, look);
  sortable(parent, sweep);
}

