// The surfaces of a trunk, as triangles of what a reader would name, and its fibres as courses of particles.

const diaphragm = new Set(['costal_insertion', 'zone_of_apposition', 'muscular_dome', 'central_tendon']);

/** In the order they are listed; `through`: seen through. */
export const parts = [
  { key: 'lungs', label: 'lungs', colour: 'lung', through: true },
  { key: 'muscle', label: 'diaphragm, muscle', colour: 'muscle' },
  { key: 'tendon', label: 'central tendon', colour: 'tendon' },
  { key: 'abdomen', label: 'abdominal wall', colour: 'abdomen', through: true },
  { key: 'pelvis', label: 'pelvis', colour: 'pelvis', through: true },
];

function partOf(regions, component) {
  if (!regions) return component === 'lung' ? 'lungs' : 'abdomen';
  if (regions.every((r) => r === 'central_tendon')) return 'tendon';
  if (regions.every((r) => diaphragm.has(r))) return 'muscle';
  if (regions.some((r) => r === 'lung_wall' || r === 'lung_top')) return 'lungs';
  return regions.every((r) => r === 'pelvis') ? 'pelvis' : 'abdomen';
}

/** Map of part -> corner indices; a triangle that two surfaces share is there once. */
export function surfaces(trajectory) {
  const corners = trajectory.triangles.particles;
  const region = trajectory.region;
  const found = new Map(parts.map(({ key }) => [key, []]));
  const seen = new Set();
  for (let t = 0; t < corners.length; t += 3) {
    const three = [corners[t], corners[t + 1], corners[t + 2]];
    const key = [...three].sort((a, b) => a - b).join();
    if (seen.has(key)) continue;
    seen.add(key);
    const component = trajectory.component && trajectory.component.names[trajectory.component.codes[t / 3]];
    const regions = region && three.map((i) => region.names[region.codes[i]]);
    found.get(partOf(regions, component)).push(...three);
  }
  return found;
}

export function edgesOf(corners) {
  const edges = new Map();
  for (let t = 0; t < corners.length; t += 3)
    for (const [a, b] of [[0, 1], [1, 2], [2, 0]]) {
      const ends = [corners[t + a], corners[t + b]].sort((i, j) => i - j);
      edges.set(ends.join(), ends);
    }
  return [...edges.values()].flat();
}

/** [{course: [particle, …], activity 0 to 1}]: along the muscle's lines where a fibre begins and ends on one. */
export function fibreCourses(trajectory) {
  const { fibre_activity: activity } = trajectory;
  const strongest = activity ? Math.max(...activity) || 1 : 1;
  const { each, particles } = trajectory.muscle_lines;
  const lines = [];
  for (let i = 0; each > 0 && i < particles.length; i += each) lines.push(Array.from(particles.slice(i, i + each)));
  const ends = trajectory.fibres.particles;
  const courses = [];
  for (let f = 0; f < ends.length; f += 2) {
    const [from, to] = [ends[f], ends[f + 1]];
    const line = lines.find((l) => l.includes(from) && l.includes(to));
    const [a, b] = line ? [line.indexOf(from), line.indexOf(to)].sort((i, j) => i - j) : [];
    courses.push({ course: line ? line.slice(a, b + 1) : [from, to], activity: activity ? activity[f / 2] / strongest : 1 });
  }
  return courses;
}
