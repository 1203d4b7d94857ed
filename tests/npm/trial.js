// What somebody does with the package; `heatwalk` is the entry that is tried.
import { HeatwalkError, Mesh } from 'heatwalk';

/** A square of two by two unit squares, in the plane. */
const positions = Array.from({ length: 9 }, (_, vertex) => [vertex % 3, Math.floor(vertex / 3), 0]).flat();
const indices = [0, 1, 3, 4].flatMap((corner) => [corner, corner + 1, corner + 4, corner, corner + 4, corner + 3]);
const SQUARE = 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n';
/** An archive with that square as OBJ, and a text beside it. */
const ZIP =
  'UEsDBBQAAAAIAAAAIVD/WIy5KAAAADoAAAAMAAAAYS9zcXVhcmUub2Jqyy3JyclMUijOzszTyy3J4SpTMABBIG0Ipw3BtAGYTgOS' +
  'RgrGCiZcAFBLAwQUAAAAAAAAACFQAAAAAAAAAAAAAAAACgAAAHJlYWRtZS50eHRQSwECFAMUAAAACAAAACFQ/1iMuSgAAAA6AAAA' +
  'DAAAAAAAAAAAAAAAgAEAAAAAYS9zcXVhcmUub2JqUEsBAhQDFAAAAAAAAAAhUAAAAAAAAAAAAAAAAAoAAAAAAAAAAAAAAIABUgAA' +
  'AHJlYWRtZS50eHRQSwUGAAAAAAIAAgByAAAAegAAAAAA';

async function gzip(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function tried() {
  // At once: workers of both may be looked for where there are none.
  const [mesh] = await Promise.all([
    Mesh.from({ positions: Float32Array.from(positions), indices: Uint16Array.from(indices) }),
    Mesh.from({ positions, indices }).then((other) => other.dispose()),
  ]);
  const distances = Array.from(await mesh.distance(0));
  const path = await mesh.path({ x: 2, y: 2, z: 0 }, 0);
  const controller = new AbortController();
  const ended = mesh.matrix(undefined, undefined, { signal: controller.signal }).catch((error) => error.name);
  controller.abort();
  const file = await Mesh.from(new TextEncoder().encode(SQUARE), { name: 'square.off', precision: 'float32' });
  const single = await file.distance({ face: 0, weights: [0, 0, 1] });
  const refused = await mesh.distance(9).catch((error) => [error instanceof HeatwalkError, error.code]);
  const again = (await mesh.distance(8))[0];
  const agents = mesh.agents();
  await agents.add([8, { x: 2, y: 1, z: 0 }], 0.05, [1, 0.5]);
  await agents.follow(0);
  let poses = await agents.update(0);
  const start = Array.from(poses.positions);
  for (let k = 0; k < 30; k++) poses = await agents.update(1 / 30);
  // The worker has begun with it when its progress comes, and is replaced.
  const other = new AbortController();
  const replaced = mesh
    .matrix(undefined, undefined, { signal: other.signal, progress: () => other.abort() })
    .catch((error) => error.name);
  const stayed = [await replaced, String((await agents.update(0)).matrices) === String(poses.matrices)];
  while (poses.arrived.length < 2) poses = await agents.update(1 / 30);
  const lost = await agents.put([2], 0).catch((error) => error.code);
  const packed = await Promise.all([
    Mesh.from(await gzip(SQUARE), { name: 'square.off.gz' }),
    Mesh.from(
      Uint8Array.from(atob(ZIP), (letter) => letter.charCodeAt(0)),
      { name: 'square.zip' },
    ),
  ]);
  const torn = await Mesh.from((await gzip(SQUARE)).subarray(0, 40), { name: 'a.off.gz' }).catch((error) => error.code);
  const bomb = await gzip('#'.repeat(80 << 20));
  const filled = await Mesh.from(bomb, { name: 'bomb.off.gz' }).catch((error) => error.code);
  for (const each of [mesh, file, ...packed]) each.dispose();
  return {
    distances,
    length: path.length,
    ended: await ended,
    polygons: file.report.polygons,
    single: [single.constructor.name, single[0]],
    refused,
    again,
    start,
    matrices: poses.matrices.length,
    lost,
    stayed,
    packed: [...packed.map(({ report }) => report.polygons), torn, filled],
  };
}
