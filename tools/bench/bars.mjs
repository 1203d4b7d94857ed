// What is to be reached, and what was.

const GIBIBYTE = 2 ** 30;

/** What counts as nothing: one percent. */
const FREE = 0.01;

/** Smaller is better unless `more`. Infinity is what failed; a bar of null asks no more than an answer. */
export function compare(row, what, mesh, reached, bar, aim, { more = false, unit = '' } = {}) {
  const meets = (goal) => (more ? reached >= goal : reached <= goal);
  const passes = bar === null ? reached < Infinity : meets(bar);
  const verdict = aim !== bar && meets(aim) ? 'aim' : passes ? 'pass' : 'miss';
  return { row, what, mesh, reached, bar, aim, unit, verdict };
}

export function bars({ meshes, growth, drags, painted, live, firstPicture }) {
  const all = [
    ...meshes.flatMap(ofMesh),
    ...(growth ? [compare(7, 'growth of native precompute, exponent', growth.name, growth.exponent, 1.3, 1.3)] : []),
    ...meshes.filter(({ queries }) => queries).flatMap(ofQueries),
    ...drags.flatMap(({ preset, fields, longest }) => [
      compare(9, 'fields while a source is dragged', preset, fields, 30, 60, { more: true, unit: '/s' }),
      compare(9, "longest answer on the page's thread", preset, longest, 16, 16, { unit: ' ms' }),
    ]),
    compare(11, 'fields of a playing animation', live.preset, live.fields, 30, 60, { more: true, unit: '/s' }),
    compare(12, 'fields while the ground is painted', painted.preset, painted.fields, 15, 30, {
      more: true,
      unit: '/s',
    }),
    compare(10, 'bytes to the first picture', 'WebGPU', firstPicture.webgpu.bytes / 1e6, 1.08, 0.9, { unit: ' MB' }),
    compare(10, 'bytes to the first picture', 'WebGL2', firstPicture.webgl2.bytes / 1e6, 1.08, 0.9, { unit: ' MB' }),
  ];
  return all.toSorted((a, b) => a.row - b.row);
}

function ofMesh({ name, isLarge, memory, times }) {
  const { native, page, robust, cholmod } = times;
  const rows = [];
  const add = (row, what, own, other, key, bar, aim) => {
    // A peer that failed or did not run leaves nothing to compare with.
    if (own && other && !other.failed) rows.push(compare(row, what, name, of(own, key) / other[key], bar, aim));
  };
  add(1, 'page precompute / pp3d robust', page, robust, 'precompute', 1.0, 0.6);
  add(1, 'page solve / pp3d robust', page, robust, 'solve', 0.8, 0.4);
  add(2, 'native precompute / pp3d robust', native, robust, 'precompute', 0.6, 0.3);
  add(2, 'native solve / pp3d robust', native, robust, 'solve', 0.5, 0.25);
  add(3, 'native factors / CHOLMOD', native, cholmod, 'factors', 1.5, 1.0);
  add(4, 'native solve / two CHOLMOD substitutions', native, cholmod, 'solve', 2.5, 1.2);
  if (isLarge) add(5, 'native precompute / pp3d robust, large', native, robust, 'precompute', 0.3, 0.2);
  if (memory) {
    rows.push(
      compare(6, 'page memory', name, of(page, 'memory') / GIBIBYTE, 2, 2, { unit: ' GiB' }),
      compare(6, 'page precompute', name, of(page, 'precompute') / 1000, null, 10, { unit: ' s' }),
      compare(6, 'page solve', name, of(page, 'solve') / 1000, null, 0.35, { unit: ' s' }),
    );
  }
  return rows;
}

function of(times, key) {
  return times.failed ? Infinity : times[key];
}

function ofQueries({ name, queries }) {
  const { precompute, solve, source_added_to_20: added, line_of_100: line, time, boundary } = queries;
  const change = (what, { first, again }) => [
    compare(8, `${what} / precompute`, name, first / precompute, 0.5, 0.5),
    compare(8, `${what} again / precompute`, name, again / precompute, FREE, FREE),
  ];
  return [
    compare(8, 'a source added to 20 / solve', name, added / solve, 2, 1.2),
    compare(8, 'a line of 100 sources / solve', name, line / solve, 12, 5),
    ...change('another time', time),
    ...(boundary ? change('another boundary condition', boundary) : []),
  ];
}

/** The exponent e of `time ~ triangles^e` over the spheres, by least squares of the logarithms. */
export function growthOf(meshes) {
  const spheres = meshes.filter(({ sphere }) => sphere);
  if (spheres.length < 3) return null;
  const points = spheres.map(({ triangles, times }) => [Math.log(triangles), Math.log(times.native.precompute)]);
  const mean = (k) => points.reduce((sum, point) => sum + point[k], 0) / points.length;
  const [x, y] = [mean(0), mean(1)];
  const slope = (over) => points.reduce((sum, point) => sum + (point[0] - x) * over(point), 0);
  const exponent = slope((point) => point[1] - y) / slope((point) => point[0] - x);
  return { name: `${spheres[0].name} to ${spheres.at(-1).name}`, exponent };
}
