// The likelihood over two parameters: colour by deviance, the joint 95 % region, the ridge, the best point.

import { css, sizeColour } from './colours.js';
import { h, svg } from './dom.js';
import { frame, key, path } from './drawing.js';
import { numberText, withUnit } from './words.js';

/** Level lines by marching squares over cells of the grid: segments in grid coordinates. */
function contour(value, rows, columns, level) {
  const segments = [];
  const crossing = (a, b, va, vb) => {
    const share = (level - va) / (vb - va);
    return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
  };
  for (let i = 0; i + 1 < rows; ++i)
    for (let j = 0; j + 1 < columns; ++j) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const values = corners.map(([r, c]) => value(r, c));
      if (!values.every(Number.isFinite)) continue;
      const cuts = corners.flatMap((a, k) => {
        const b = (k + 1) % 4;
        return values[k] < level !== values[b] < level ? [crossing(a, corners[b], values[k], values[b])] : [];
      });
      for (let k = 0; k + 1 < cuts.length; k += 2) segments.push([cuts[k], cuts[k + 1]]);
    }
  return segments;
}

/** A place between grid points, as a value of the axis. */
function along(axis, place) {
  const first = Math.min(Math.floor(place), axis.length - 2);
  return axis[first] + (place - first) * (axis[first + 1] - axis[first]);
}

/** Borders between grid points: each point has a cell around it. */
function borders(axis) {
  const middle = axis.slice(1).map((v, i) => (v + axis[i]) / 2);
  return [2 * axis[0] - middle[0], ...middle, 2 * axis[axis.length - 1] - middle[middle.length - 1]];
}

function bestOf(name, fit) {
  const at = fit.parameters.name.indexOf(name);
  if (at >= 0) return fit.parameters.best[at];
  const [muscle, elasticity] = ['k_muscle', 'k_elasticity'].map((n) => fit.parameters.best[fit.parameters.name.indexOf(n)]);
  return name === 'k_muscle/k_elasticity' ? muscle / elasticity : NaN;
}

export function surfaceDrawing(surface, fit) {
  const [first, second] = [surface.first.values, surface.second.values];
  const level = surface.threshold95[0] ?? 5.991;
  const at = (i, j) => surface.deviance[i * second.length + j];
  const most = 6 * level; // beyond this all is far
  const [x0, y0] = [borders(first), borders(second)];
  const ridge = first.map((_, i) => {
    let low = 0;
    for (let j = 1; j < second.length; ++j) if (!(at(i, j) >= at(i, low))) low = j;
    return low;
  });
  const best = [bestOf(surface.first.name, fit), bestOf(surface.second.name, fit)];
  const bar = [0, level / most, 0.5, 1].map((share) => numberText(share * most, 3));
  const figure = frame(
    {
      title: 'Likelihood surface',
      summary: `deviance over ${surface.first.name} and ${surface.second.name}, best at ${numberText(best[0])} and ${numberText(best[1])}`,
      x: { label: withUnit(surface.first.name, surface.first.unit), range: [x0[0], x0[x0.length - 1]] },
      y: { label: withUnit(surface.second.name, surface.second.unit), range: [y0[0], y0[y0.length - 1]] },
      width: 520,
      height: 400,
    },
    (inner, x, y) => {
      for (let i = 0; i < first.length; ++i)
        for (let j = 0; j < second.length; ++j) {
          if (!Number.isFinite(at(i, j))) continue;
          const [left, right, bottom, top] = [x(x0[i]), x(x0[i + 1]), y(y0[j]), y(y0[j + 1])];
          inner.append(svg('rect', { x: left, y: top, width: right - left + 0.4, height: bottom - top + 0.4, fill: css(sizeColour(1 - Math.sqrt(Math.min(1, at(i, j) / most)))) }));
        }
      for (const ends of contour(at, first.length, second.length, level))
        for (const kind of ['region under', 'region'])
          inner.append(path(ends.map(([i, j]) => [x(along(first, i)), y(along(second, j))]), { class: kind }));
      const course = ridge.map((j, i) => [x(first[i]), y(second[j])]);
      inner.append(path(course, { class: 'ridge under' }), path(course, { class: 'ridge' }));
      if (best.every(Number.isFinite)) inner.append(svg('circle', { cx: x(best[0]), cy: y(best[1]), r: 5.5, class: 'best-point' }));
    },
  );
  const strip = h('span', { class: 'gradient' });
  strip.style.background = `linear-gradient(to right, ${Array.from({ length: 11 }, (_, i) => css(sizeColour(1 - Math.sqrt(i / 10)))).join(', ')})`;
  figure.append(
    h('div', { class: 'legend' }, bar[0], strip, `${bar[3]} and more`, h('span', null, 'deviance, −2 log likelihood above its best')),
    key([
      { label: `joint 95 % region (deviance ${numberText(level, 3)})`, colour: 'region', style: 'solid' },
      { label: 'ridge: the best second parameter for each first', colour: 'ridge', style: 'dashed' },
      { label: 'best', colour: 'best', style: 'dot' },
    ]),
  );
  return figure;
}
