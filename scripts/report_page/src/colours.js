// Colour maps that colour-blind readers can tell apart: dark blue to yellow for sizes (in the manner of cividis),
// blue through grey to orange for what has a sign.

const size = [[0, 34, 78], [53, 69, 108], [102, 105, 112], [148, 142, 119], [200, 184, 102], [254, 232, 56]];
const sign = [[5, 85, 165], [86, 160, 211], [222, 222, 218], [232, 150, 60], [175, 75, 0]];

function between(stops, share) {
  const place = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const first = Math.min(Math.floor(place), stops.length - 2);
  return stops[first].map((c, k) => c + (place - first) * (stops[first + 1][k] - c));
}

export const sizeColour = (share) => between(size, share);
export const signColour = (share) => between(sign, share);
export const css = ([r, g, b]) => `rgb(${Math.round(r)} ${Math.round(g)} ${Math.round(b)})`;

export function gradient(map) {
  const stops = [];
  for (let i = 0; i <= 10; ++i) stops.push(css(map(i / 10)));
  return `linear-gradient(to right, ${stops.join(', ')})`;
}
