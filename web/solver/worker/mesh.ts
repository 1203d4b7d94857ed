/** What a mesh is asked: a surface by the module of the solver, tetrahedra by theirs. */
import type { InnerCut, Plain } from '../../protocol';
import type * as interior from '../../wasm/interior/heatwalk_interior';
import type { EdgeKind, FaceField, Parameters, PathKind } from '../../wasm/contract';
import type * as wasm from '../../wasm/solver/heatwalk_worker';

/** Places as both take them. Its solver rejects a place that a mesh does not have. */
type MeshPoint = wasm.SurfacePoint;
type Source = wasm.Source;

/** A field as it comes from a module. */
type FieldObject = wasm.Field | interior.InnerField;

/** What both can be asked. */
export interface MeshSolver {
  configure(parameters: Parameters, progress: (stage: string, fraction: number) => void): void;
  factor_nonzeros(): number;
  solve(sources: readonly Source[], quick: boolean): FieldObject;
  propagate(sources: readonly Source[], windows: number, quick: boolean): FieldObject;
  path(from: MeshPoint, kind: PathKind): wasm.SurfacePath | interior.InnerPath;
  tangents(): Int8Array;
  gradients(kind: FaceField): Float32Array;
  edges(kind: EdgeKind): Float32Array;
  heat(): Float32Array;
  neighbors(): Uint32Array;
  line(from: number, to: number): Uint32Array;
  set_crowd(count: number, height: number): void;
  step_crowd(step: number): Float32Array;
}

/** A field of either as a message. */
export type SolvedField = Plain<wasm.Field> & Partial<Pick<interior.InnerField, 'inner'>>;

export function messageOf(field: FieldObject): SolvedField {
  const message = field.toJSON() as SolvedField;
  field.free();
  return message;
}

/** A mesh that can be asked. */
export interface Mesh {
  solver: MeshSolver;
  /** The same of a surface; null for tetrahedra. */
  surface: wasm.Solver | null;
  /** The same of tetrahedra, and how they are looked into; null for a surface. */
  inside: { solver: interior.InnerSolver; cut: InnerCut | null; hasField: boolean } | null;
}

export function surfaceMesh(solver: wasm.Solver): Mesh {
  return { solver, surface: solver, inside: null };
}

export function innerMesh(solver: interior.InnerSolver): Mesh {
  return { solver, surface: null, inside: { solver, cut: null, hasField: false } };
}
