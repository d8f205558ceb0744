// The likelihood over two parameters: colour by deviance, the joint 95 % region, the best point.

import { css, sizeColour } from './colours.js';
import { h, note, svg } from './dom.js';
import { frame, key, path } from './drawing.js';
import { numberText, quantity, withUnit } from './words.js';

const finer = 8; // steps between grid points

/** A row of values in finer steps, straight between them. */
function refined(values) {
  return Array.from({ length: finer * (values.length - 1) + 1 }, (_, k) => {
    const [at, share] = [Math.floor(k / finer), (k % finer) / finer];
    return values[at] + share * ((values[at + 1] ?? 0) - values[at]);
  });
}

/** Level lines by marching squares: segments in places of the grid. */
function contour(grid, level) {
  const segments = [];
  const corner = (i, j) => [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
  for (let i = 0; i + 1 < grid.length; ++i)
    for (let j = 0; j + 1 < grid[0].length; ++j) {
      const corners = corner(i, j);
      const values = corners.map(([r, c]) => grid[r][c] - level);
      const cuts = [];
      for (let k = 0; k < 4; ++k) {
        const [from, to] = [values[k], values[(k + 1) % 4]];
        if (from < 0 === to < 0) continue;
        const share = from / (from - to);
        const [a, b] = [corners[k], corners[(k + 1) % 4]];
        cuts.push([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
      }
      for (let k = 0; k + 1 < cuts.length; k += 2) segments.push([cuts[k], cuts[k + 1]]);
    }
  return segments;
}

/** The grid as a picture, one pixel a place; the second axis upward. */
function picture(grid, shade) {
  const [width, height] = [grid.length, grid[0].length];
  const canvas = h('canvas', { width, height });
  const context = canvas.getContext('2d');
  const pixels = context.createImageData(width, height);
  grid.forEach((column, i) =>
    column.forEach((value, j) => pixels.data.set([...shade(value), 255], 4 * ((height - 1 - j) * width + i))),
  );
  context.putImageData(pixels, 0, 0);
  return canvas.toDataURL();
}

function bestOf(name, fit) {
  const best = (n) => fit.parameters.find((p) => p.name === n)?.best ?? NaN;
  return name === 'k_muscle/k_elasticity' ? best('k_muscle') / best('k_elasticity') : best(name);
}

/** What the joint region spans. */
function regionText(surface) {
  const spans = [surface.first, surface.second].map(({ name, unit, region95 }) => `${name} ${numberText(region95[0])} to ${quantity(region95[1], unit, 4)}`);
  return `The joint region spans ${spans.join(', ')}${surface.closed ? '' : '; it reaches the edge of the grid'}.`;
}

/** Whether a grid is even in its logarithm rather than in itself. */
function isLog(axis) {
  const [first, last] = [axis[0], axis[axis.length - 1]];
  if (!(first > 0)) return false;
  const middle = axis[(axis.length - 1) / 2] ?? Math.sqrt(first * last);
  return Math.abs(middle - Math.sqrt(first * last)) < Math.abs(middle - (first + last) / 2);
}

export function surfaceDrawing(surface, fit) {
  const axes = [surface.first.values, surface.second.values];
  const level = surface.threshold95 ?? 5.991;
  const most = 6 * level; // beyond this all is far
  // The root of the deviance is nearly straight between the points of the grid; the fit finds its region in this way too.
  const coarse = axes[0].map((_, i) => Array.from(surface.deviance.subarray(i * axes[1].length, (i + 1) * axes[1].length), (d) => Math.sqrt(Math.max(0, d))));
  if (axes.some((a) => a.length < 3) || !coarse.flat().every(Number.isFinite))
    return note('The likelihood surface cannot be drawn: points of its grid failed.');
  const columns = coarse.map(refined); // along the second axis, then along the first
  const rows = columns[0].map((_, j) => refined(columns.map((column) => column[j])));
  const grid = rows[0].map((_, i) => rows.map((row) => row[i]));
  const [first, second] = axes.map(refined);
  const best = [bestOf(surface.first.name, fit), bestOf(surface.second.name, fit)];
  const shade = (deviance) => sizeColour(1 - Math.sqrt(Math.min(1, Math.max(0, deviance) / most)));
  const place = (axis, at) => axis[Math.floor(at)] + (at % 1) * ((axis[Math.floor(at) + 1] ?? 0) - axis[Math.floor(at)]);
  const figure = frame(
    {
      title: 'Likelihood surface',
      summary: `deviance over ${surface.first.name} and ${surface.second.name}, best at ${numberText(best[0])} and ${numberText(best[1])}`,
      x: { label: withUnit(surface.first.name, surface.first.unit), range: [first[0], first[first.length - 1]], log: isLog(axes[0]) },
      y: { label: withUnit(surface.second.name, surface.second.unit), range: [second[0], second[second.length - 1]], log: isLog(axes[1]) },
      width: 560,
      height: 420,
      large: true,
    },
    (inner, x, y) => {
      const half = (from, to, n) => (0.5 * (to - from)) / (n - 1); // a pixel has its place in its middle
      const pad = [half(x(first[0]), x(first[first.length - 1]), first.length), half(y(second[0]), y(second[second.length - 1]), second.length)];
      const [left, right] = [x(first[0]) - pad[0], x(first[first.length - 1]) + pad[0]];
      const [bottom, top] = [y(second[0]) - pad[1], y(second[second.length - 1]) + pad[1]];
      inner.append(svg('image', { href: picture(grid, (root) => shade(root * root)), x: left, y: top, width: right - left, height: bottom - top, preserveAspectRatio: 'none' }));
      const lines = contour(grid, Math.sqrt(level)).map((ends) => ends.map(([i, j]) => [x(place(first, i)), y(place(second, j))]));
      for (const kind of ['region under', 'region']) inner.append(...lines.map((ends) => path(ends, { class: kind })));
      if (best.every(Number.isFinite)) inner.append(svg('circle', { cx: x(best[0]), cy: y(best[1]), r: 5.5, class: 'best-point' }));
    },
  );
  const strip = h('span', { class: 'gradient' });
  strip.style.background = `linear-gradient(to right, ${Array.from({ length: 11 }, (_, i) => css(shade((most * i) / 10))).join(', ')})`;
  figure.append(
    h('div', { class: 'legend' }, '0', strip, `${numberText(most, 3)} and more`, h('span', null, 'deviance: −2 log likelihood above its best')),
    key([
      { label: `joint 95 % region (deviance ${numberText(level, 3)})`, colour: 'region', style: 'solid' },
      { label: 'best', colour: 'best', style: 'dot' },
    ]),
    h('p', { class: 'small' }, regionText(surface)),
    h('p', { class: 'small' }, `The root of the deviance is drawn straight between the ${axes[0].length} × ${axes[1].length} points that the fit computed.`),
  );
  return figure;
}
