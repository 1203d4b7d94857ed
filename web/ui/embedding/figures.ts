/** What the page around the frame gets, in the types of web/embed.ts. */
import type { Distances, FieldFigures, MeshFigures, Path, State } from '../../embed';
import type { DistanceField, DrawTransform } from '../../protocol';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import { type SceneState, unitOf } from '../../state/scene';
import type { Up } from '../../wasm/contract';
import type { Heatwalk } from '../scripting';

export function meshFigures({ opened, places }: Shown, state: SceneState): MeshFigures {
  const { name, report } = opened;
  return {
    name,
    triangles: report.faces,
    vertices: report.vertices,
    inputVertices: report.inputVertices,
    components: report.components,
    diameter: places.diameter,
    unit: unitOf(state, opened).symbol,
  };
}

export function fieldFigures({ maxDistance, unreachableVertices, exactShare }: DistanceField): FieldFigures {
  return { maxDistance, unreachableVertices, exactShare };
}

export function stateOf({ scene, shown: { value: shown } }: Session, api: Heatwalk, link: string): State {
  const { sources, walker } = scene.state;
  const field = shown?.answer.field;
  return {
    mesh: shown && meshFigures(shown, scene.state),
    field: field ? fieldFigures(field) : null,
    refining: api.refining,
    sources: structuredClone(sources) as State['sources'],
    walker: structuredClone(walker) as State['walker'],
    link,
    backend: api.backend,
  };
}

/** Null where there is no source. */
export function distancesOf({ opened, answer: { field } }: Pick<Shown, 'opened' | 'answer'>): Distances | null {
  if (!field) return null;
  const { inputVertices, surface, report } = opened;
  if (field.inner) return { ...fieldFigures(field), values: Float64Array.from(field.inner) };
  const values = new Float64Array(report.inputVertices).fill(Number.NaN);
  // Where walls part a vertex, the nearest side of it counts.
  const take = (drawn: number, value: number) => {
    const vertex = inputVertices[drawn];
    if (!(values[vertex] <= value)) values[vertex] = value;
  };
  if (field.byCorner) surface.triangles.forEach((drawn, corner) => take(drawn, field.distance[corner]));
  else inputVertices.forEach((_, drawn) => take(drawn, field.distance[drawn]));
  return { ...fieldFigures(field), values };
}

/** Null without a walker, and where no source reaches it. */
export function pathOf({ opened, answer: { path, pathKind } }: Pick<Shown, 'opened' | 'answer'>): Path | null {
  if (!path) return null;
  const { points, length, cost } = path;
  return { points: inFile(points, opened.drawTransform), length, cost, kind: pathKind };
}

/** For each axis of the file, the drawn axis that it lies along, and the sign: the inverse of `Up::turned` of the solver. */
const TURNED: Readonly<Record<Up, readonly (readonly [axis: number, sign: number])[]>> = {
  y: [
    [0, 1],
    [1, 1],
    [2, 1],
  ],
  z: [
    [0, 1],
    [2, -1],
    [1, 1],
  ],
  x: [
    [1, 1],
    [0, -1],
    [2, 1],
  ],
  '-y': [
    [0, 1],
    [1, -1],
    [2, -1],
  ],
  '-z': [
    [0, 1],
    [2, 1],
    [1, -1],
  ],
  '-x': [
    [1, -1],
    [0, 1],
    [2, 1],
  ],
};

/** Points × 3 as they are drawn, in the axes and the unit of the file. */
export function inFile(drawn: Float32Array, { center, scale, up }: DrawTransform): Float64Array {
  const axes = TURNED[up];
  return Float64Array.from(drawn, (_, index) => {
    const [axis, sign] = axes[index % 3];
    return (sign * drawn[index - (index % 3) + axis]) / scale + center[index % 3];
  });
}
