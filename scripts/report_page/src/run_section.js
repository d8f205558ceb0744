// One simulated breath, or two laid over each other: the trunk, curves over time, measures, parameters.

import { chart } from './charts.js';
import { curveNamed, frameSeries, numberNamed } from './data.js';
import { h, note, section, table } from './dom.js';
import { trunkViews } from './trunk_view.js';
import { nameText, numberText, unitText, words } from './words.js';

const inks = ['blue', 'orange', 'green', 'purple'];

/** The curve of that name in each run that has it. */
const overlaid = (runs, name, label) =>
  runs.flatMap(({ run, label: of }, i) => {
    const curve = curveNamed(run, name);
    return curve ? [{ label: of ? `${of}${label ? `, ${label}` : ''}` : label ?? nameText(name), time: run.curves.time, values: curve.values, colour: inks[i], style: i }] : [];
  });

/** What was sampled with the frames: of one run the members by colour, of two the runs by colour, the members by style. */
function moved(runs, members) {
  return runs.flatMap(({ run, label: of }, i) =>
    members.flatMap(({ name, label, ink, style }) => {
      const series = frameSeries(run, name);
      if (!series) return [];
      return [{
        label: of ? `${of}, ${label}` : label,
        time: run.frames.time,
        values: series.values,
        colour: members.length > 1 && runs.length === 1 ? ink : inks[i],
        style: members.length > 1 ? style : i,
      }];
    }),
  );
}

function volumeCharts(parent, runs, clock) {
  const volume = overlaid(runs, 'dV_model', 'model');
  runs.forEach(({ run, label: of }) => {
    const measured = curveNamed(run, 'dV_measured');
    if (measured) volume.push({ label: of ? `${of}, measured` : 'measured', time: run.curves.time, values: measured.values, colour: 'grey', style: 2 });
  });
  if (volume.length > 0) chart(parent, { title: 'Lung volume above end-expiration, ΔV', unit: 'ml', series: volume, clock, zero: true });
  const residual = overlaid(runs, 'residual', 'model − measured');
  if (residual.length > 0) chart(parent, { title: 'Residual of ΔV', unit: 'ml', series: residual, clock, zero: true });
}

function curves(parent, runs, clock, withVolume) {
  const grid = h('div', { class: 'charts' });
  parent.append(grid);
  if (withVolume) volumeCharts(grid, runs, clock);
  const one = (title, unit, series) => {
    if (series.length > 0) chart(grid, { title, unit, series, clock, zero: true });
  };
  one('Muscle activation', '', overlaid(runs, 'activation', 'activation'));
  one('Abdominal pressure above rest', 'cmH2O', overlaid(runs, 'abdominal_pressure', 'pressure'));
  one('Pleural pressure above rest', 'cmH2O', overlaid(runs, 'pleural_pressure', 'pressure'));
  one('Zone of apposition: it shortens by ΔL, widens by ΔR', 'mm', moved(runs, [
    { name: 'dL', label: 'ΔL', ink: 'blue', style: 0 },
    { name: 'dR', label: 'ΔR', ink: 'green', style: 2 },
  ]));
  one('Domes flatten by ΔH', 'mm', moved(runs, [{ name: 'dH', label: 'ΔH', ink: 'blue', style: 0 }]));
  one('Descent of the domes (up is descent)', 'mm', moved(runs, [
    { name: 'excursion_right', label: 'right dome', ink: 'blue', style: 0 },
    { name: 'excursion_left', label: 'left dome', ink: 'orange', style: 1 },
  ]));
  for (const { run, label } of runs) if (!run.frames) parent.append(note(`${label ?? 'This file'} does not say how ΔL, ΔH, ΔR and the domes change over time.`));
  if (!runs.some(({ run }) => run.curves)) parent.append(note('There are no curves in this file.'));
  for (const { run, label } of runs)
    if (run.curves?.every > 1) parent.append(note(`${label ? `${label}: ` : ''}Every ${run.curves.every}th sample of the curves is drawn.`));
}

/** Heights of the activation's shape are 1 unless they were estimated. */
const isPlain = (name, values) => name.startsWith('shape_') && values.every((v) => v === 1);

/** Names that any of the lists has, in their order. */
const namesIn = (lists) => [...new Map(lists.flat().map((v) => [v.name, v.unit]))];

function comparison(runs, member, caption) {
  const lists = runs.map(({ run }) => run[member]);
  const all = namesIn(lists);
  const names = all.filter(([name]) => !isPlain(name, lists.map((list) => numberNamed(list, name))));
  if (names.length === 0) return note(`There are no ${member} in this file.`);
  const heads = runs.length > 1 ? ['', ...runs.map(({ label }) => label), 'difference', ''] : ['', 'value', 'unit'];
  const rows = names.map(([name, unit]) => {
    const values = lists.map((list) => numberNamed(list, name));
    const cells = values.map((v) => numberText(v, 4));
    if (values.length > 1) cells.push(numberText(values[1] - values[0], 3));
    return [nameText(name), ...cells, unitText(unit)];
  });
  const shown = table(heads, rows, { caption, numeric: runs.length > 1 ? [1, 2, 3] : [1] });
  if (names.length < all.length) shown.append(note('All heights of the activation’s shape (shape_…) are 1.'));
  return shown;
}

/** How far the run is from the surface that it was held against. */
function beside(parent, { name, region, time_s: time, triangles, covered_percent: covered, distances }) {
  const columns = ['mean_mm', 'rms_mm', 'median_mm', 'percentile95_mm', 'hausdorff_mm'];
  const rows = distances
    .filter((d, i) => i !== 1 || (covered > 0 && covered < 99.5))
    .map((d) => [d.name, ...columns.map((column) => numberText(d[column], 3))]);
  section(
    parent,
    `Beside ${name}`,
    table(['mm', 'mean', 'RMS', 'median', '95 %', 'Hausdorff'], rows, { caption: `Distances of the ${region} at ${numberText(time, 3)} s to the measured surface of ${triangles} triangles`, numeric: [1, 2, 3, 4, 5] }),
    h('p', { class: 'small' }, `${numberText(covered, 3)} % of the ${region} is over the surface, the rest beyond its border.`),
  );
}

/** runs: [{run, label}], one or two. */
export function runSection(parent, runs, clock, withVolume = true) {
  const one = runs.length === 1;
  const status = runs.map(({ run, label }) => (run.status && run.status !== 'completed' ? note(`${label ?? 'This run'} did not complete: ${run.message || words(run.status)}`) : null));
  const stage = section(parent, one ? 'The trunk as it breathes' : 'The trunks as they breathe', ...status);
  trunkViews(stage, runs, clock);
  for (const { run } of runs) if (run.surface) beside(parent, run.surface);
  curves(section(parent, 'Over time'), runs, clock, withVolume);
  section(
    parent,
    one ? 'Measures and parameters' : 'Measures and parameters, side by side',
    h('div', { class: one ? 'tables' : 'tables wide' }, comparison(runs, 'measures', 'Measures from end-expiration to end-inspiration'), comparison(runs, 'parameters', 'Parameters')),
  );
}

