/**
 * Takes what is placed on a mesh to the same file with other parts active, or with its inside filled: by where it is in the file.
 * Fetched when that is asked for.
 */
import type { MeshPoint } from '../protocol';
import { Places } from '../state/places';
import type { SceneState } from '../state/scene';
import { onceEach, type SetShape, type SourceSet, withOffset } from '../state/sources';
import { found, type Mesh } from './found';
import { drawnPlace, filePlace, nearestPlace } from './nearest';
import type { Transfer, Shown } from './prepare';
import { t } from '../texts';

/** Where a place is on the other mesh; null where it has none there. */
type Take = (point: MeshPoint) => MeshPoint | null;

/** `reach`: how far a place may be from where it was, as a share of the diameter. What is farther stays behind. */
export function transfer({ opened }: Shown, state: SceneState, reach: number): Transfer {
  // In the pose of the file, in which meshes are opened.
  const before = new Places(opened);
  return async (mesh) => {
    const take: Take = (point) => {
      const place = before.at(point);
      if (!place) return null;
      const inFile = filePlace(place.position, opened.drawTransform);
      const there = drawnPlace(inFile, mesh.opened.drawTransform);
      const { point: nearest, away } = nearestPlace(mesh.opened.surface, mesh.opened.inputVertices, there);
      return away <= reach * mesh.places.drawnDiameter ? nearest : null;
    };
    const sets = state.sets.map((set) => taken(set, mesh, take));
    return {
      sources: onceEach(all(state.sources, take)),
      sets: await found(
        mesh,
        sets.filter((set) => set !== null),
      ),
      walker: state.walker && (take(state.walker) ?? undefined),
      tapes: state.tapes
        .map((tape) => ({ ...tape, points: all(tape.points, take) }))
        .filter(({ points }, index) => points.length === state.tapes[index]?.points.length),
      decals: state.decals.flatMap((decal) => {
        const place = take(decal.place);
        return place ? { ...decal, place } : [];
      }),
    };
  };
}

function taken(set: SourceSet, mesh: Mesh, take: Take): SourceSet | null {
  const shape = shapeOn(set.shape, mesh, take);
  return shape && { ...set, shape, points: all(set.points, take) };
}

/** Lines along edges, boundaries, components and parts are of surfaces: inside of tetrahedra their places are kept. */
function shapeOn(shape: SetShape, { opened, places }: Mesh, take: Take): SetShape | null {
  const isInside = opened.interior !== null;
  const vertexAt = (vertex: number) => {
    const point = take({ vertex });
    return point && places.nearestVertex(point);
  };
  switch (shape.kind) {
    case 'stroke':
    case 'list':
      return shape;
    case 'line': {
      if (isInside) return { kind: 'stroke', closed: shape.closed };
      const corners = shape.corners.map(vertexAt).filter((vertex) => vertex !== null);
      return corners.length === shape.corners.length ? { ...shape, corners } : null;
    }
    case 'boundary':
    case 'component': {
      if (isInside) {
        return shape.kind === 'boundary'
          ? { kind: 'stroke', closed: true }
          : { kind: 'list', name: String(t('Component')) };
      }
      const vertex = vertexAt(shape.vertex);
      return vertex === null ? null : { ...shape, vertex };
    }
    case 'part':
      return isInside
        ? { kind: 'list', name: opened.parts[shape.part]?.name || String(t`Part ${shape.part + 1}`) }
        : shape;
  }
}

function all<P extends MeshPoint & { offset?: number }>(points: readonly P[], take: Take): MeshPoint[] {
  return points.flatMap((point) => {
    const there = take(point);
    return there ? [withOffset(there, point.offset ?? 0)] : [];
  });
}
