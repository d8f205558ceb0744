// Play, scrub and speed; the same by keys anywhere on the page.

import { defaultSpeed } from './clock.js';
import { h } from './dom.js';
import { fixed } from './words.js';

const takesKeys = (element) =>
  element instanceof HTMLElement && (element.isContentEditable || /^(INPUT|SELECT|TEXTAREA|BUTTON|SUMMARY|A)$/.test(element.tagName));

function keys(clock) {
  const actions = {
    ' ': () => clock.toggle(),
    k: () => clock.toggle(),
    ArrowRight: () => clock.step(1),
    ArrowLeft: () => clock.step(-1),
    Home: () => clock.seek(0),
    End: () => clock.seek(clock.duration),
  };
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || takesKeys(event.target)) return;
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

export function player(clock) {
  const button = h('button', { type: 'button', class: 'play', onclick: () => clock.toggle() }, 'Play');
  const slider = h('input', {
    type: 'range',
    min: 0,
    max: clock.duration,
    step: clock.frame,
    'aria-label': 'time within the breath, seconds',
    oninput: () => {
      clock.pause();
      clock.seek(slider.valueAsNumber);
    },
  });
  const time = h('output', { class: 'time', 'aria-live': 'off' });
  const speed = h(
    'select',
    { 'aria-label': 'speed', onchange: () => (clock.speed = Number(speed.value)) },
    [0.1, 0.25, 0.5, 1, 2].map((s) => h('option', { value: s, selected: s === defaultSpeed() }, `${s} ×`)),
  );
  clock.speed = defaultSpeed();
  clock.onState((playing) => (button.textContent = playing ? 'Pause' : 'Play'));
  clock.onTime((t) => {
    slider.value = t;
    slider.setAttribute('aria-valuetext', `${fixed(t, 2)} seconds`);
    time.textContent = `${fixed(t, 2)} s of ${fixed(clock.duration, 2)} s`;
  });
  keys(clock);
  return h(
    'div',
    { class: 'player', role: 'group', 'aria-label': 'player' },
    button,
    slider,
    time,
    speed,
    h('span', { class: 'keys' }, 'keys: space plays, ← → step, Home and End'),
  );
}
