/** What the panel calls the values of the solver's settings. */
import type { Boundary, LinearSolver, Method, MultiSource, Operator } from '../wasm/contract';

export const METHODS: Record<Method, string> = {
  auto: 'Automatic',
  propagation: 'Propagation',
  heat: 'Heat method',
  exact: 'Exact',
};
export const BOUNDARIES: Record<Boundary, string> = {
  neumann: 'Insulated (Neumann)',
  dirichlet: 'Cold (Dirichlet)',
  average: 'Average of both',
};
export const MULTI_SOURCES: Record<MultiSource, string> = {
  exact: 'Exact',
  summed: 'Summed',
};
export const OPERATORS: Record<Operator, string> = {
  delaunay: 'Intrinsic Delaunay',
  plain: 'As in the file',
  relocate: 'Relocated vertices',
};
export const SOLVERS: Record<LinearSolver, string> = {
  cholesky: 'Cholesky',
  cg: 'Conjugate gradients',
};

/** A time factor as its slider gives it, in two digits. */
export function fromLogarithm(value: number): number {
  return Number((10 ** value).toPrecision(2));
}
