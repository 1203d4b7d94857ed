/** What scripts and the page around the frame get, in the types of web/embed.ts. */
import type { Distances, FieldFigures, MeshFigures, Path, State } from '../../embed';
import type { DistanceField } from '../../protocol';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import { unitOf } from '../../length';
import type { SceneState } from '../../state/scene';
import type { Heatwalk } from '../scripting';
import { entry } from '../../state/entry';

export function meshFigures({ opened, places }: Shown, state: SceneState): MeshFigures {
  const { name, report } = opened;
  const { symbol: unit, scale } = unitOf(state, opened);
  return {
    name,
    triangles: report.faces,
    vertices: report.vertices,
    inputVertices: report.inputVertices,
    components: report.components,
    diameter: places.diameter,
    unit,
    scale,
  };
}

export function fieldFigures({ maxDistance, unreachableVertices, exactShare }: DistanceField): FieldFigures {
  return { maxDistance, unreachableVertices, exactShare };
}

export function placesOf({ sources, walker }: SceneState): Pick<State, 'sources' | 'walker'> {
  return {
    sources: structuredClone(sources) as State['sources'],
    walker: (structuredClone(walker) ?? null) as State['walker'],
  };
}

export function stateOf({ scene, shown: { value: shown } }: Session, api: Heatwalk, link: string): State {
  const field = shown?.answer.field;
  return {
    mesh: shown && meshFigures(shown, scene.state),
    field: field ? fieldFigures(field) : null,
    refining: api.refining,
    ...placesOf(scene.state),
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
    const vertex = entry(inputVertices, drawn);
    if (!(entry(values, vertex) <= value)) values[vertex] = value;
  };
  if (field.byCorner) surface.triangles.forEach((drawn, corner) => take(drawn, entry(field.distance, corner)));
  else field.distance.forEach((value, drawn) => take(drawn, value));
  return { ...fieldFigures(field), values };
}

/** Null without a walker, and where no source reaches it. */
export function pathOf({ answer: { path, pathKind } }: Pick<Shown, 'answer'>): Path | null {
  if (!path) return null;
  const { places, length, cost } = path;
  return { points: places.slice(), length, cost, kind: pathKind };
}
