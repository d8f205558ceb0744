// Plots that are not over time, as SVG: they follow the theme by themselves, and print sharp.

import { extremes } from './data.js';
import { h, svg } from './dom.js';
import { numberText } from './words.js';

const logOf = (v) => Math.log10(v);
let frames = 0;

export function scale([low, high], [from, to], log = false) {
  const [a, b] = log ? [logOf(low), logOf(high)] : [low, high];
  const of = (v) => from + (((log ? logOf(v) : v) - a) / (b - a || 1)) * (to - from);
  of.domain = [low, high];
  of.log = log;
  return of;
}

/** Round numbers, about `count` of them. */
export function ticks([low, high], count = 5, log = false) {
  if (log && high / low > 30) {
    const found = [];
    for (let e = Math.ceil(logOf(low) - 1e-9); e <= Math.floor(logOf(high) + 1e-9); ++e) found.push(10 ** e);
    if (found.length > 1) return found;
  }
  const rough = (high - low) / count;
  if (!(rough > 0)) return [low];
  const power = 10 ** Math.floor(logOf(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough * 0.999);
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) found.push(i * step);
  return found;
}

/** A frame with axes. draw(inner, x, y) fills it. */
export function frame({ title, summary, x: xAxis, y: yAxis, width = 460, height = 300, wide, large }, draw) {
  const [left, right, top, bottom] = [76, 14, 10, 46];
  const x = scale(xAxis.range, [left, width - right], xAxis.log);
  const y = scale(yAxis.range, [height - bottom, top], yAxis.log);
  const picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `${title}. ${summary ?? ''}` });
  const grid = svg('g', { class: 'grid' });
  const labels = svg('g', { class: 'ticks' });
  for (const v of ticks(x.domain, 5, x.log)) {
    grid.append(svg('line', { x1: x(v), x2: x(v), y1: top, y2: height - bottom }));
    labels.append(svg('text', { x: x(v), y: height - bottom + 16, 'text-anchor': 'middle' }, numberText(v, 4)));
  }
  for (const v of ticks(y.domain, 5, y.log)) {
    grid.append(svg('line', { x1: left, x2: width - right, y1: y(v), y2: y(v) }));
    labels.append(svg('text', { x: left - 7, y: y(v) + 4, 'text-anchor': 'end' }, numberText(v, 4)));
  }
  const middle = (top + height - bottom) / 2;
  labels.append(
    svg('text', { class: 'axis', x: (left + width - right) / 2, y: height - 8, 'text-anchor': 'middle' }, xAxis.label),
    svg('text', { class: 'axis', transform: `translate(14 ${middle}) rotate(-90)`, 'text-anchor': 'middle' }, yAxis.label),
  );
  const clip = `clip-${++frames}`;
  const inner = svg('g', { 'clip-path': `url(#${clip})` });
  picture.append(
    svg('clipPath', { id: clip }, svg('rect', { x: left, y: top, width: width - left - right, height: height - top - bottom })),
    grid,
    inner,
    labels,
  );
  draw(inner, x, y);
  return h('figure', { class: `drawing${wide ? ' wide' : ''}${large ? ' large' : ''}` }, h('figcaption', null, title), picture);
}

export function path(points, attributes) {
  let d = '';
  let pen = 'M';
  for (const [x, y] of points) {
    if (!Number.isFinite(x) || !Number.isFinite(y)) {
      pen = 'M';
      continue;
    }
    d += `${pen}${x.toFixed(2)} ${y.toFixed(2)}`;
    pen = 'L';
  }
  return svg('path', { d, fill: 'none', ...attributes });
}

/** With some room at both ends. */
export function roomy(values, { log = false, zero = false } = {}) {
  let [low, high] = extremes(values);
  if (!Number.isFinite(low)) return log ? [1, 10] : [0, 1];
  if (zero) [low, high] = [Math.min(0, low), Math.max(0, high)];
  if (log) {
    const room = (high / low) ** 0.05 || 1.1;
    return low === high ? [low / 1.2, high * 1.2] : [low / room, high * room];
  }
  const room = 0.05 * (high - low || Math.abs(high) || 1);
  return [low - room, high + room];
}

/** entries: [{label, colour, style}] */
export const key = (entries) =>
  h('ul', { class: 'key' }, entries.map(({ label, colour, style }) => h('li', null, h('span', { class: `stroke stroke-${style ?? 'solid'} swatch-${colour}` }), label)));
