/** The places of sets of sources on a mesh. Fetched when a scene has some. */
import { Failure } from '../error';
import type { OpenedMesh, Source } from '../protocol';
import type { Engine } from '../solver/engine';
import { Cancelled, WorkerLost } from '../solver/remote';
import type { Places } from '../state/places';
import { MOST_POINTS, placesOf, type SetShape, type SourceSet } from '../state/sources';
import { boundaryThrough, componentOf, type Outlined, verticesOfPart } from './outlines';
import { count, t } from '../texts';
import { entry } from '../state/entry';

/** A mesh that can be asked. */
export interface Mesh {
  engine: Engine;
  opened: OpenedMesh;
  places: Places;
}

/** Sets with their places on a mesh. What the mesh does not have is left out, and what a scene may not have beside the sets before it. */
export async function found(mesh: Mesh, sets: readonly SourceSet[]): Promise<SourceSet[]> {
  const all: SourceSet[] = [];
  let left = MOST_POINTS;
  for (const set of sets) {
    try {
      const placed = { ...set, points: await pointsOf(mesh, set.shape, set.points) };
      left -= placesOf(placed);
      if (left < 0) break;
      all.push(placed);
    } catch (error) {
      if (error instanceof Cancelled || error instanceof WorkerLost) throw error;
    }
  }
  return all.filter(({ points }) => points.length > 0);
}

/** @throws where a set has more places than distance can be measured from, and where the mesh has no such vertex. */
export async function pointsOf(mesh: Mesh, shape: SetShape, given: readonly Source[]): Promise<readonly Source[]> {
  switch (shape.kind) {
    case 'stroke':
    case 'list':
      return given.filter((point) => mesh.places.has(point));
    case 'line':
      return atVertices(await lineThrough(mesh.engine, shape.corners, shape.closed));
    case 'boundary':
      return atVertices(boundaryThrough(await outlined(mesh), shape.vertex));
    case 'component':
      return atVertices(componentOf(await outlined(mesh), shape.vertex));
    case 'part':
      return atVertices(verticesOfPart(await outlined(mesh), shape.part));
  }
}

export function atVertices(vertices: readonly number[]): Source[] {
  if (vertices.length > MOST_POINTS) {
    throw new Failure(t`This has ${count(vertices.length)} vertices; up to ${count(MOST_POINTS)} can be sources.`);
  }
  return vertices.map((vertex) => ({ vertex }));
}

export async function outlined({ engine, opened }: Mesh): Promise<Outlined> {
  return { ...opened, neighbors: await engine.queries.neighbors() };
}

export async function lineThrough(engine: Engine, corners: readonly number[], closed: boolean): Promise<number[]> {
  const line = corners.slice(0, 1);
  const [, ...ends] = closed ? [...corners, ...line] : corners;
  for (const [index, end] of ends.entries()) {
    line.push(...(await engine.queries.line(entry(corners, index), end)).subarray(1));
  }
  // The first vertex is not repeated.
  return closed && line.length > 1 ? line.slice(0, -1) : line;
}
