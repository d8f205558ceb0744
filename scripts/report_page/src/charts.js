// Curves over time (uPlot): a unit on every axis, a line at the time of the clock, a click goes there.

import uPlot from 'uplot';
import { extremes, finite, sampleAt } from './data.js';
import { h } from './dom.js';
import { colour, onPaper, onTheme } from './theme.js';
import { numberText, unitText } from './words.js';

const paperWidth = 325; // CSS pixels: two beside each other on A4
const all = [];
const styles = [undefined, [8, 4], [2, 3], [10, 3, 2, 3]];

const marks = ['solid', 'dashed', 'dotted', 'double'];
const font = (size) => `${size}px system-ui, sans-serif`;

function axis(label, size) {
  return {
    label,
    size,
    labelSize: 22,
    font: font(12),
    labelFont: font(12),
    stroke: () => colour('text'),
    grid: { stroke: () => colour('grid'), width: 1 },
    ticks: { stroke: () => colour('grid'), width: 1 },
    values: (_, splits) => splits.map((v) => (v === null ? '' : numberText(v, 6))),
  };
}

/** Series on their own times, as columns over all times. */
function columns(series) {
  const same = series.every((s) => s.time === series[0].time);
  if (same) return [Array.from(series[0].time), ...series.map((s) => finite(s.values))];
  const times = Float64Array.from(new Set(series.flatMap((s) => Array.from(s.time)))).sort();
  const inside = (s, t) => t >= s.time[0] - 1e-9 && t <= s.time[s.time.length - 1] + 1e-9;
  return [Array.from(times), ...series.map((s) => finite(Array.from(times, (t) => (inside(s, t) ? sampleAt(s.time, s.values, t) : NaN))))];
}

/** What a reader who does not see the curves is told. */
function inWords(title, unit, series) {
  const of = series.map((s) => {
    const [low, high] = extremes(s.values);
    return `${s.label} from ${numberText(low)} to ${numberText(high)} ${unitText(unit)}`;
  });
  return `${title} over time: ${of.join('; ')}`;
}

const grown = (low, high) => {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const room = 0.06 * (high - low || Math.abs(high) || 1);
  return [low - room, high + room];
};

function clockLine(plot, clock) {
  const line = h('div', { class: 'now', 'aria-hidden': 'true' });
  plot.over.append(line);
  const times = plot.data[0];
  const places = times.map((_, i) => i);
  const place = () => {
    line.style.transform = `translateX(${plot.valToPos(clock.time, 'x')}px)`;
    if (!(plot.cursor.left >= 0)) plot.setLegend({ idx: Math.round(sampleAt(times, places, clock.time)) }, false);
  };
  clock.onTime(place);
  plot.over.addEventListener('click', (event) => {
    if (plot.select.width > 2) return;
    clock.pause();
    clock.seek(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'));
  });
  return place;
}

/** series: [{label, time, values, colour, style?, width?, band?}]; a band lies between two series of that name. */
export function chart(parent, { title, unit, series, clock, height = 210, zero = false }) {
  const host = h('div', { class: 'plot', role: 'img', 'aria-label': inWords(title, unit, series) });
  const figure = h('figure', { class: 'chart' }, h('figcaption', null, title), host);
  parent.append(figure);
  const bands = [];
  series.forEach((s, i) => {
    if (s.band) bands.push({ series: [i + 1, i + 2], fill: () => colour(s.band) });
  });
  const options = {
    width: 300,
    height,
    padding: [8, 10, 0, 0],
    scales: { x: { time: false }, y: { range: (_, low, high) => grown(zero ? Math.min(0, low) : low, zero ? Math.max(0, high) : high) } },
    axes: [axis('time (s)', 34), axis(unitText(unit) || 'share, 0 to 1', 52)],
    cursor: { sync: clock ? { key: 'time' } : undefined, y: false, points: { size: 6 } },
    legend: { live: true, markers: { width: 3, dash: (_, i) => marks[series[i - 1]?.style ?? 0], stroke: (_, i) => `var(--${series[i - 1]?.colour})`, fill: () => 'none' } },
    bands,
    series: [
      { label: 'time', value: (_, v) => (v === null || v === undefined ? '–' : `${numberText(v, 4)} s`) },
      ...series.map((s) => ({
        label: s.label,
        class: s.unnamed ? 'unnamed' : undefined,
        stroke: () => colour(s.colour),
        width: s.width ?? 2,
        dash: styles[s.style ?? 0],
        points: { show: false },
        value: (_, v) => (v === null || v === undefined ? '–' : `${numberText(v, 4)} ${unitText(unit)}`),
      })),
    ],
  };
  const plot = new uPlot(options, columns(series), host);
  const place = clock ? clockLine(plot, clock) : () => {};
  const fit = () => {
    const width = onPaper() ? paperWidth : Math.max(240, Math.floor(host.clientWidth));
    if (width !== plot.width) plot.setSize({ width, height });
    place();
  };
  all.push({ plot, fit });
  new ResizeObserver(fit).observe(figure);
  fit();
  return plot;
}

onTheme(() => {
  for (const { plot, fit } of all) {
    fit();
    plot.redraw(false, true);
  }
});
