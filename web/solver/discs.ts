/** Points as discs, which are drawn in the place of the surface that joins them; loaded with the first cloud. */
import type { Discs, DrawMesh } from '../protocol';
import { entry } from '../state/entry';
import { cross, dot, minus, moved, normalized, scaled, type Vector, vectorAt } from '../state/vector';

/** Corners of a disc around its middle: as many triangles as a leaf of the renderer's hierarchy has. */
export const SIDES = 8;
/** Radius of a disc as a share of the mean distance of its point to its neighbors: discs touch, and points can be told apart. */
const RADIUS = 0.5;
/** Boxes reach beyond their triangles by this share of their coordinates, as depths along a ray are rounded. */
const MARGIN = 1e-5;

/** A triangle at a point: its other two corners as seen in the plane at the point. */
interface Wedge {
  corner: number;
  ahead: readonly [number, number];
  behind: readonly [number, number];
}

/** The discs of the points of a surface; `points`: of each drawn vertex its point. */
export function discsOf(surface: DrawMesh, points: Uint32Array): Discs {
  const around = cornersOfPoints(surface, points);
  const vertices = (SIDES + 1) * around.length;
  const discs: Discs = {
    mesh: emptyMesh(surface, vertices, SIDES * around.length),
    triangles: new Uint32Array(vertices),
    weights: new Float32Array(3 * vertices),
  };
  around.forEach((corners, disc) => addDisc(discs, surface, corners, disc));
  discs.mesh.boxes = boxesAround(discs.mesh.positions);
  return discs;
}

/** Of each point with triangles, these as corners that are there, in an order in which neighbors are near each other. */
function cornersOfPoints({ triangles, order }: DrawMesh, points: Uint32Array): number[][] {
  const around = new Map<number, number[]>();
  for (const triangle of order) {
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      const point = entry(points, entry(triangles, corner));
      const corners = around.get(point);
      if (corners) corners.push(corner);
      else around.set(point, [corner]);
    }
  }
  return [...around.values()];
}

function emptyMesh({ texcoords, colors, runs }: DrawMesh, vertices: number, triangles: number): DrawMesh {
  return {
    positions: new Float32Array(3 * vertices),
    normals: new Float32Array(3 * vertices),
    triangles: new Uint32Array(3 * triangles),
    texcoords: new Float32Array(texcoords.length > 0 ? 4 * vertices : 0),
    colors: new Uint16Array(colors.length > 0 ? 4 * vertices : 0),
    runs: runs.length > 0 ? Uint32Array.of(0, triangles, entry(runs, 2)) : runs,
    order: Uint32Array.from({ length: triangles }, (_, triangle) => triangle),
    boxes: new Float32Array(),
  };
}

function addDisc(
  { mesh, triangles, weights }: Discs,
  surface: DrawMesh,
  corners: readonly number[],
  disc: number,
): void {
  const vertexOf = (corner: number) => entry(surface.triangles, corner);
  const drawn = vertexOf(entry(corners, 0));
  const middle = vectorAt(surface.positions, drawn);
  const sides = corners.map((corner) => {
    const [ahead, behind] = [1, 2].map((step) =>
      minus(vectorAt(surface.positions, vertexOf(turned(corner, step))), middle),
    ) as [Vector, Vector];
    return { corner, ahead, behind };
  });
  const normal = normalized(
    sides.reduce((sum: Vector, { ahead, behind }) => moved(sum, cross(ahead, behind), 1), [0, 0, 0]),
  );
  const lengths = sides.flatMap(({ ahead, behind }) => [Math.hypot(...ahead), Math.hypot(...behind)]);
  const radius = (RADIUS * lengths.reduce((sum, length) => sum + length, 0)) / lengths.length;
  const [right, up] = frameOf(normal);
  const inPlane = (vector: Vector) => [dot(vector, right), dot(vector, up)] as const;
  const wedges = sides.map(({ corner, ahead, behind }) => ({
    corner,
    ahead: inPlane(ahead),
    behind: inPlane(behind),
  }));
  const first = (SIDES + 1) * disc;
  for (let k = 0; k <= SIDES; k++) {
    const vertex = first + k;
    const angle = (2 * Math.PI * k) / SIDES;
    const [x, y] = k === 0 ? [0, 0] : [radius * Math.cos(angle), radius * Math.sin(angle)];
    mesh.positions.set(moved(moved(middle, right, x), up, y), 3 * vertex);
    mesh.normals.set(normal, 3 * vertex);
    if (mesh.colors.length > 0) mesh.colors.set(surface.colors.subarray(4 * drawn, 4 * drawn + 4), 4 * vertex);
    if (mesh.texcoords.length > 0) mesh.texcoords.set(surface.texcoords.subarray(4 * drawn, 4 * drawn + 4), 4 * vertex);
    const { corner, shares } = placeIn(wedges, x, y);
    triangles[vertex] = Math.floor(corner / 3);
    shares.forEach((share, step) => (weights[3 * vertex + (turned(corner, step) % 3)] = share));
    if (k > 0) mesh.triangles.set([first, vertex, first + (k % SIDES) + 1], 3 * (SIDES * disc + k - 1));
  }
}

/** The corner of the same triangle that is so many steps ahead. */
function turned(corner: number, steps: number): number {
  return corner - (corner % 3) + ((corner + steps) % 3);
}

/** Two directions that are square to a normal and to each other, counterclockwise. */
function frameOf(normal: Vector): [Vector, Vector] {
  const axis: Vector = Math.abs(normal[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const right = normalized(minus(axis, scaled(normal, dot(axis, normal))));
  return [right, cross(normal, right)];
}

/** The triangle in which a place of the plane lies, by its corner at the point, and its weights from there; beyond a border, a place on it nearby. */
function placeIn(wedges: readonly Wedge[], x: number, y: number): { corner: number; shares: Vector } {
  let best = { corner: entry(wedges, 0).corner, shares: [1, 0, 0] as Vector, least: Number.NEGATIVE_INFINITY };
  for (const { corner, ahead, behind } of wedges) {
    const area = ahead[0] * behind[1] - ahead[1] * behind[0];
    const [u, v] = [(x * behind[1] - y * behind[0]) / area, (ahead[0] * y - ahead[1] * x) / area];
    const least = Math.min(u, v);
    if (!(least > best.least)) continue;
    const [a, b] = [Math.max(0, u), Math.max(0, v)];
    const most = Math.max(1, a + b);
    best = { corner, shares: [1 - (a + b) / most, a / most, b / most], least };
  }
  return best;
}

/** The boxes of the renderer's hierarchy: a complete tree, whose leaves are the discs in their order. */
function boxesAround(positions: Float32Array): Float32Array {
  const vertices = SIDES + 1;
  const discs = positions.length / (3 * vertices);
  const boxes = new Float32Array(6 * (2 * discs - 1));
  for (let disc = 0; disc < discs; disc++) {
    const box = 6 * (discs - 1 + disc);
    for (let axis = 0; axis < 3; axis++) {
      let [low, high] = [Infinity, -Infinity];
      for (let vertex = vertices * disc; vertex < vertices * (disc + 1); vertex++) {
        const at = entry(positions, 3 * vertex + axis);
        [low, high] = [Math.min(low, at), Math.max(high, at)];
      }
      const margin = MARGIN * Math.max(Math.abs(low), Math.abs(high));
      boxes[box + axis] = low - margin;
      boxes[box + 3 + axis] = high + margin;
    }
  }
  for (let node = discs - 2; node >= 0; node--) {
    for (let axis = 0; axis < 6; axis++) {
      const [one, other] = [entry(boxes, 6 * (2 * node + 1) + axis), entry(boxes, 6 * (2 * node + 2) + axis)];
      boxes[6 * node + axis] = axis < 3 ? Math.min(one, other) : Math.max(one, other);
    }
  }
  return boxes;
}
