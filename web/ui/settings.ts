/** What the panel calls the values of the solver's settings. */
import type { Parameters } from '../protocol';
import {
  AUTOMATIC,
  type Boundary,
  type LinearSolver,
  type Method,
  type MultiSource,
  type Operator,
  TIME_STEP_FACTORS,
} from '../wasm/contract';
import { type AutomaticControl, automaticSlider } from './widgets';
import { threeDigits } from '../state/measures';
import { t, type Words } from '../texts';

export const METHODS: Record<Method, Words> = {
  auto: t('Automatic'),
  propagation: t('Propagation'),
  heat: t('Heat method'),
  exact: t('Exact'),
};
export const BOUNDARIES: Record<Boundary, Words> = {
  neumann: t('Insulated (Neumann)'),
  dirichlet: t('Cold (Dirichlet)'),
  average: t('Average of both'),
};
export const MULTI_SOURCES: Record<MultiSource, Words> = {
  exact: t('Exact'),
  summed: t('Summed'),
};
export const OPERATORS: Record<Operator, Words> = {
  delaunay: t('Intrinsic Delaunay'),
  plain: t('As in the file'),
  relocate: t('Relocated vertices'),
};
export const SOLVERS: Record<LinearSolver, Words> = {
  cholesky: t('Cholesky'),
  cg: t('Conjugate gradients'),
};

/** A slider of the time factor, over its logarithm. */
export function timeFactor(change: (timeStep: Parameters['timeStep'], gesture: object) => void): AutomaticControl {
  const [least, most] = TIME_STEP_FACTORS;
  const { element, show } = automaticSlider({
    label: t('Time factor m'),
    min: Math.log10(least),
    max: Math.log10(most),
    step: 0.05,
    describe: (value) => threeDigits(inTwoDigits(value)),
    change: (value, gesture) => change(value === AUTOMATIC ? value : inTwoDigits(value), gesture),
  });
  return {
    element,
    show: (value, chosen) => show(value === AUTOMATIC ? value : Math.log10(value), Math.log10(chosen)),
  };
}

function inTwoDigits(logarithm: number): number {
  return Number((10 ** logarithm).toPrecision(2));
}
