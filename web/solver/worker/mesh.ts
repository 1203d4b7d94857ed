/** The open mesh, the only one of this worker: a surface answers by the module of the solver, tetrahedra by theirs. */
import type { DrawTransform, InnerCut, MeshInput, MeshPoint, Timings } from '../../protocol';
import type * as interior from '../../wasm/interior/heatwalk_interior';
import type * as wasm from '../../wasm/solver/heatwalk_worker';
import type { Between } from './between';
import { isOutOfMemory, isTrap } from '../trap';

/** What both can be asked alike. */
type Shared = Exclude<keyof wasm.Solver & keyof interior.InnerSolver, 'measure'>;

/** A mesh that can be asked. */
export interface Mesh {
  solver: Pick<wasm.Solver, Shared>;
  /** The same of a surface; null for tetrahedra. */
  surface: wasm.Solver | null;
  /** The same of tetrahedra, and how they are looked into; null for a surface. */
  inside: { solver: interior.InnerSolver; cut: InnerCut | null; hasField: boolean } | null;
  shownAs: ShownAs;
  timings: Timings;
  /** Windows of the next slice of refining. */
  work: number;
  /** Whether the field is by heat: each slice of refining then ends with a solve. */
  isByHeat: boolean;
  solveMs: number;
  refineMs: number;
  /** When the last slice of refining ended. */
  refinedAt: number;
}

/** How a mesh is drawn. */
export interface ShownAs {
  transform: DrawTransform;
  /** The file and its parts that it is; null where it was simplified or filled. */
  from: { input: MeshInput; parts: Uint32Array } | null;
  /** The inactive parts that move. */
  moving: { part: number; scenery: wasm.Scenery }[];
  /** Where more distances are drawn than those of vertices: finds them. */
  between?: Between;
}

/** Windows of the first slice. */
export const FIRST_WORK = 20_000;

let current: Mesh | undefined;

/** `asked`: a solver on a surface, or else one on tetrahedra. */
export function setMesh(
  asked: { surface: wasm.Solver } | { inside: interior.InnerSolver },
  shownAs: ShownAs,
  timings: Timings,
): Mesh {
  const solver =
    'surface' in asked
      ? { solver: asked.surface, surface: asked.surface, inside: null }
      : { solver: asked.inside, surface: null, inside: { solver: asked.inside, cut: null, hasField: false } };
  current = { ...solver, shownAs, timings, work: FIRST_WORK, isByHeat: false, solveMs: 0, refineMs: 0, refinedAt: 0 };
  return current;
}

export function openMesh(): Mesh {
  if (!current) throw new Error('No mesh is open.');
  return current;
}

export function openSurface(): wasm.Solver {
  const { surface } = openMesh();
  if (!surface) throw new Error('Only a surface can be asked this, and the mesh is one of tetrahedra.');
  return surface;
}

/** The solver rejects a place that the mesh does not have. */
export function known(place: MeshPoint): wasm.Source {
  return place as wasm.Source;
}

/** Null where there is no path: no source is reached from there. Undefined where none is found yet. */
export function pathOf<T>(find: () => T | undefined): T | null | undefined {
  try {
    return find();
  } catch (error) {
    if (error instanceof Error && (isTrap(error) || isOutOfMemory(error))) throw error;
    return null;
  }
}
