// Puts the page together from what the program wrote into it.

import 'uplot/dist/uPlot.min.css';
import './page.css';
import { Clock } from './clock.js';
import { curveNamed, loadContents } from './data.js';
import { h, note, section, table } from './dom.js';
import { fitSections } from './fit_section.js';
import { player } from './player.js';
import { runSection } from './run_section.js';
import { sweepSections } from './sweep_section.js';
import { followTheme, onPaper, onTheme, themeSwitch } from './theme.js';
import { words } from './words.js';

const kinds = { run: 'simulated breath', fit: 'fit', sweep: 'sweep' };

function header(files) {
  const button = h('button', { type: 'button', class: 'theme' });
  themeSwitch(button);
  const titles = [...new Set(files.map((f) => f.title || f.name))];
  document.title = `${titles.join(' · ')} – trunk report`;
  return h(
    'header',
    null,
    h('div', null, h('h1', null, titles.join(' · ')), ...files.map((f) => h('p', { class: 'file' }, `${f.name}: ${kinds[f.kind] ?? f.kind}${f.status ? `, ${words(f.status)}` : ''}`))),
    button,
  );
}

/** The frame the clock starts at: where a surface was measured, else the largest volume, where there is most to see. */
function openingTime({ curves, surface }) {
  if (surface) return surface.time_s;
  const volume = curves && curveNamed({ curves }, 'dV_model');
  if (!volume) return 0;
  let at = 0;
  volume.values.forEach((v, i) => {
    if (v > volume.values[at]) at = i;
  });
  return curves.time[at];
}

function clockOf(runs) {
  const times = runs.map((run) => run.trajectory?.time ?? run.curves?.time).filter((t) => t?.length > 1);
  if (times.length === 0) return new Clock(0, 0.01);
  return new Clock(Math.max(...times.map((t) => t[t.length - 1])), times[0][1] - times[0][0]);
}

function breathing(parent, files) {
  const many = files.length > 1;
  const stems = files.map((file) => file.name.replace(/\.h5$/, ''));
  const same = many && stems[0] === stems[1];
  const runs = files.map((file, i) => ({ run: file.run, label: many ? (same ? ['first', 'second'][i] : stems[i]) : undefined }));
  const clock = clockOf(files.map((file) => file.run));
  for (const file of files) {
    if (!file.fit) continue;
    if (many) parent.append(h('h2', { class: 'of' }, file.name));
    fitSections(parent, file, clock);
  }
  runSection(parent, runs, clock, many || !files[0].fit?.measured?.measured); // a lone fit shows its volume already
  return clock;
}

function origin(parent, files) {
  for (const file of files) {
    const rows = Object.entries(file.provenance ?? {}).map(([name, text]) => [words(name), h('code', null, text)]);
    const made = h('details', null, h('summary', null, 'Program, libraries, inputs'), table(['', ''], rows));
    onTheme(() => (made.open = onPaper()));
    const text = file.run?.scenario || file.sweep?.sweep_toml;
    section(
      parent,
      files.length > 1 ? `Where ${file.name} comes from` : 'Where this comes from',
      rows.length > 0 ? made : note('This file does not say.'),
      text ? h('details', null, h('summary', null, file.sweep ? 'The sweep' : 'The scenario'), h('pre', { tabindex: 0 }, text)) : null,
    );
  }
}

async function start() {
  const { files } = await loadContents();
  followTheme();
  const main = h('main');
  document.body.append(header(files), main);
  for (const file of files) if (file.sweep) sweepSections(main, file);
  const runs = files.filter((file) => file.run);
  const clock = runs.length > 0 ? breathing(main, runs) : null;
  origin(main, files);
  if (clock?.duration > 0) main.append(player(clock)); // last, so that it stays in sight all along
  clock?.seek(openingTime(runs[0].run));
  document.body.append(h('footer', null, 'Made by trunk report. This page needs no network. Drawn with three.js and uPlot (MIT licence, in the source of this page).'));
  document.documentElement.dataset.ready = 'yes';
}

start().catch((error) => {
  console.error(error);
  document.body.prepend(h('p', { class: 'note', role: 'alert' }, `This page could not be drawn: ${error.message}`));
});
