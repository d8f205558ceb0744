// What the program put into the page: JSON, and the long arrays it refers to in one compressed block.

const arrays = { f8: Float64Array, f4: Float32Array, i4: Int32Array, i2: Int16Array, u1: Uint8Array };

async function unzipped(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

/** Puts typed arrays where the JSON refers to them. */
function resolved(value, block) {
  if (value === null || typeof value !== 'object') return value;
  if (value.as in arrays && 'at' in value && 'n' in value) return new arrays[value.as](block, value.at, value.n);
  for (const key of Object.keys(value)) value[key] = resolved(value[key], block);
  return value;
}

/** {files: [{name, kind, title, run?, fit?, sweep?}]} */
export async function loadContents() {
  const contents = JSON.parse(document.getElementById('contents').textContent);
  return resolved(contents, await unzipped(document.getElementById('numbers').textContent));
}

/** Positions of all frames, mm, [frames * particles * 3], from differences between frames modulo 2^16. */
export function positionsMm(trajectory) {
  const { differences, origin_m: origin, step_m: step } = trajectory.positions;
  const width = 3 * trajectory.particles;
  const now = new Int16Array(width);
  return Float32Array.from(differences, (difference, i) => {
    const k = i % width;
    now[k] += difference;
    return 1e3 * (origin[k % 3] + step * now[k]);
  });
}

export const finite = (values) => Array.from(values, (v) => (Number.isFinite(v) ? v : null));

export function extremes(values) {
  let low = Infinity;
  let high = -Infinity;
  for (const v of values) {
    if (v === null || !Number.isFinite(v)) continue;
    if (v < low) low = v;
    if (v > high) high = v;
  }
  return [low, high];
}

/** Linear between samples, held outside of them. */
export function sampleAt(times, values, time) {
  let low = 0;
  let high = times.length - 1;
  if (high < 0) return NaN;
  if (time <= times[0]) return values[0];
  if (time >= times[high]) return values[high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  const share = (time - times[low]) / (times[high] - times[low]);
  return values[low] + share * (values[high] - values[low]);
}

export const curveNamed = (run, name) => run.curves?.series.find((s) => s.name === name);
export const frameSeries = (run, name) => run.frames?.series.find((s) => s.name === name);

export function numberNamed(list, name) {
  const found = list?.find((v) => v.name === name);
  return found === undefined || found.value === null ? NaN : found.value;
}
