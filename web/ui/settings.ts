/** What the panel calls the values of the solver's settings. */
import type { Boundary, LinearSolver, Method, MultiSource, Operator } from '../wasm/contract';
import { t } from '../texts';

export const METHODS: Record<Method, string> = {
  auto: t('Automatic'),
  propagation: t('Propagation'),
  heat: t('Heat method'),
  exact: t('Exact'),
};
export const BOUNDARIES: Record<Boundary, string> = {
  neumann: t('Insulated (Neumann)'),
  dirichlet: t('Cold (Dirichlet)'),
  average: t('Average of both'),
};
export const MULTI_SOURCES: Record<MultiSource, string> = {
  exact: t('Exact'),
  summed: t('Summed'),
};
export const OPERATORS: Record<Operator, string> = {
  delaunay: t('Intrinsic Delaunay'),
  plain: t('As in the file'),
  relocate: t('Relocated vertices'),
};
export const SOLVERS: Record<LinearSolver, string> = {
  cholesky: t('Cholesky'),
  cg: t('Conjugate gradients'),
};

/** A time factor as its slider gives it, in two digits. */
export function fromLogarithm(value: number): number {
  return Number((10 ** value).toPrecision(2));
}
