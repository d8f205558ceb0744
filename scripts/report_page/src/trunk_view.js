// A trunk on the page: its canvas, what is visible, how it is coloured, and readouts at the time shown.

import { sizeColour, signColour, gradient } from './colours.js';
import { curveNamed, extremes, sampleAt } from './data.js';
import { h, note } from './dom.js';
import { onPaper, onTheme } from './theme.js';
import { TrunkScene } from './trunk_scene.js';
import { fixed, unitText } from './words.js';

const colourings = {
  anatomy: { label: 'parts' },
  distance: { label: 'distance from rest', map: sizeColour, low: () => 0, unit: 'mm from rest' },
  side: { label: 'measured surface', map: signColour, low: (most) => -most, unit: 'mm above it (+), below (−), grey: beyond it' },
  rise: { label: 'rise and fall', map: signColour, low: (most) => -most, unit: 'mm up (+) or down (−) from rest' },
};

function checkboxes(scene) {
  const entries = scene.surfaces.map(({ key, label, colour: name }) => [key, label, name]);
  if (scene.fibres) entries.push(['fibres', 'fibres', 'fibre']);
  if (scene.contact) entries.push(['contact', 'contact with the ribs', 'contact']);
  if (scene.target) entries.push(['target', `measured: ${scene.run.surface.name}`, 'target']);
  entries.push(['ghost', 'rest shape', 'ghost']);
  return h(
    'fieldset',
    { class: 'parts' },
    h('legend', null, 'Show'),
    entries.map(([key, label, name]) => {
      const box = h('input', { type: 'checkbox', checked: true, 'data-part': key, onchange: () => scene.setShown(key, box.checked) });
      return h('label', null, box, h('span', { class: `swatch swatch-${name}` }), label);
    }),
  );
}

function colouringChoice(scenes) {
  const bar = h('span', { class: 'gradient' });
  const [low, high, meaning] = [h('span'), h('span'), h('span')];
  const legend = h('div', { class: 'legend', hidden: true }, low, bar, high, meaning);
  const show = (name) => {
    const { map, low: lowest, unit } = colourings[name];
    const text = name === 'side' ? `${unit}, at ${fixed(scenes[0].run.surface.time_s, 2)} s` : unit;
    for (const scene of scenes) scene.setColouring(name);
    legend.hidden = !map;
    if (!map) return;
    const most = scenes[0].limits[name];
    bar.style.background = gradient(map);
    low.textContent = fixed(lowest(most), 1);
    high.textContent = fixed(most, 1);
    meaning.textContent = text;
  };
  const select = h(
    'select',
    { 'aria-label': 'colour by', onchange: () => show(select.value) },
    Object.entries(colourings)
      .filter(([name]) => name !== 'side' || scenes[0].target)
      .map(([name, { label }]) => h('option', { value: name }, label)),
  );
  if (scenes[0].target) {
    select.value = 'side'; // that is what the page was made for
    show('side');
  }
  return [h('label', null, 'Colour by ', select), legend];
}

const views = (scenes) =>
  h(
    'span',
    { class: 'views', role: 'group', 'aria-label': 'view' },
    ['oblique', 'front', 'side', 'top'].map((name) =>
      h('button', { type: 'button', onclick: () => scenes.forEach((scene) => scene.look(name)) }, name),
    ),
  );

/** Volume, pressure, activation and contact at the time of the clock; gauges of all runs reach as far. */
function readouts(run, runs, scene, clock) {
  const rows = [];
  for (const [name, label, decimals] of [['dV_model', 'ΔV', 0], ['abdominal_pressure', 'abdominal pressure', 2], ['activation', 'activation', 2]]) {
    const curve = curveNamed(run, name);
    if (!curve) continue;
    const most = Math.max(...runs.map((r) => extremes(curveNamed(r.run, name)?.values ?? [0])[1]));
    const bar = h('span', { class: 'fill' });
    const value = h('output', { 'data-readout': name, 'aria-live': 'off' });
    rows.push(h('div', { class: `readout readout-${name}` }, h('span', null, label), value, h('span', { class: 'gauge', 'aria-hidden': 'true' }, bar)));
    clock.onTime((time) => {
      const now = sampleAt(run.curves.time, curve.values, time);
      value.textContent = `${fixed(now, decimals)} ${unitText(curve.unit)}`;
      bar.style.width = `${Math.max(0, Math.min(100, (100 * now) / (most || 1)))}%`;
    });
  }
  if (scene.contact) {
    const of = run.trajectory.contact.particles.length;
    const bar = h('span', { class: 'fill' });
    const value = h('output', { 'data-readout': 'contact', 'aria-live': 'off' });
    rows.push(h('div', { class: 'readout readout-contact' }, h('span', null, 'particles on the ribs'), value, h('span', { class: 'gauge', 'aria-hidden': 'true' }, bar)));
    clock.onTime((time) => {
      const touching = scene.touching(time).length;
      value.textContent = `${touching} of ${of}`;
      bar.style.width = `${(100 * touching) / of}%`;
    });
  }
  return h('div', { class: 'readouts' }, rows);
}

/** Names of the sides and a length to compare with, over the canvas. */
function overlay(scene, stage) {
  const [right, left] = [h('span', { class: 'side' }, 'right'), h('span', { class: 'side' }, 'left')];
  const scale = h('span', { class: 'scale' });
  stage.append(right, left, scale);
  return () => {
    const { centre, radius } = scene;
    for (const [label, sign] of [[right, 1], [left, -1]]) {
      const [x, y] = scene.pixel([centre.x + sign * radius * 0.6, centre.y, centre.z + radius * 0.8]);
      label.style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
    }
    const mm = scene.mmPerPixel();
    const length = [10, 20, 50, 100, 200, 500].find((l) => l / mm > 50) ?? 1000;
    scale.style.width = `${length / mm}px`;
    scale.textContent = `${length} mm`;
  };
}

function orbitKeys(canvas, scenes) {
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
  const zooms = { '+': 1.1, '=': 1.1, '-': 1 / 1.1 };
  canvas.addEventListener('keydown', (event) => {
    const turn = turns[event.key];
    const zoom = zooms[event.key];
    if ((!turn && !zoom) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    for (const scene of scenes) turn ? scene.turn(...turn) : scene.zoom(zoom);
  });
}

/** One or two runs beside each other: the same camera, the same colours, the same clock. */
export function trunkViews(parent, runs, clock) {
  const moving = runs.filter(({ run }) => run.trajectory);
  const box = h('div', { class: moving.length > 1 ? 'stages two' : 'stages' });
  const scenes = [];
  for (const { run, label } of runs) {
    if (!run.trajectory) {
      box.append(note(`${label ?? 'This file'} holds no trajectory: the trunk cannot be shown.`));
      continue;
    }
    const scene = new TrunkScene(run);
    const canvas = h('canvas', {
      tabindex: 0,
      role: 'application',
      class: 'trunk',
      'aria-label': `The trunk${label ? ` of ${label}` : ''} in three dimensions, ${run.trajectory.particles} particles; drag or use the arrow keys to turn it, + and − to zoom`,
    });
    const stage = h('div', { class: 'stage' }, canvas);
    const figure = h('figure', { class: 'view' }, label ? h('figcaption', null, label) : null, stage, h('div', { class: 'beside' }, readouts(run, runs, scene, clock)));
    box.append(figure);
    scenes.push({ scene, canvas, stage });
  }
  parent.append(box);
  start(moving.length > 1 ? parent : box.querySelector('.beside') ?? parent, scenes, clock);
  for (const { run, label } of runs) {
    if (run.trajectory?.every > 1) parent.append(note(`${label ? `${label}: ` : ''}Every ${run.trajectory.every}th stored frame is shown.`));
    if (run.trajectory && !run.trajectory.contact) parent.append(note(`${label ?? 'This file'} says nothing of contact with the ribs.`));
  }
}

/** Browsers print a picture drawn in two dimensions as it is, one in three not always. */
function copyForPaper(canvas, stage) {
  stage.querySelector('.paper')?.remove();
  const copy = h('canvas', { class: 'paper', width: canvas.width, height: canvas.height });
  copy.getContext('2d').drawImage(canvas, 0, 0);
  stage.append(copy);
}

function start(parent, views3d, clock) {
  const scenes = views3d.map(({ scene }) => scene);
  if (scenes.length === 0) return;
  const largest = { ...scenes[0].moves, distance: Math.max(...scenes.map((s) => s.moves.distance)), rise: Math.max(...scenes.map((s) => s.moves.rise)) };
  for (const { scene, canvas, stage } of views3d) {
    scene.limits = largest;
    const label = overlay(scene, stage);
    const others = scenes.filter((s) => s !== scene);
    try {
      scene.attach(canvas, () => {
        if (scene.size) label();
        if (document.activeElement === canvas || stage.matches(':hover')) others.forEach((s) => s.follow(scene));
      });
    } catch {
      stage.replaceChildren(note('This browser cannot draw in three dimensions (no WebGL); the curves below do not need it.'));
      continue;
    }
    orbitKeys(canvas, [scene]);
    const fit = () => {
      if (onPaper()) scene.resize(scenes.length > 1 ? 325 : 660, 380);
      else scene.resize(stage.clientWidth, stage.clientHeight);
      label();
      if (onPaper()) copyForPaper(canvas, stage);
    };
    new ResizeObserver(fit).observe(stage);
    clock.onTime((time) => scene.show(time));
    onTheme(() => {
      scene.paint();
      if (scene.size) fit();
    });
  }
  const toggles = checkboxes(scenes[0]);
  for (const box of toggles.querySelectorAll('input'))
    box.addEventListener('change', () => scenes.slice(1).forEach((s) => s.setShown(box.dataset.part, box.checked)));
  const drawn = scenes.filter((s) => s.renderer);
  if (drawn.length > 0) parent.append(h('div', { class: 'controls' }, toggles, h('div', null, colouringChoice(drawn), views(drawn))));
}

