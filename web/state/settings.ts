/** The settings of the solver, and how a link writes them. */
import type { Parameters } from '../protocol';
import {
  BOUNDARY,
  EXACT_RADIUS_EDGES,
  LINEAR_SOLVER,
  MEMORY_LIMIT_MEBIBYTES,
  METHOD,
  type Method,
  MULTI_SOURCE,
  OPERATOR,
  TIME_STEP_FACTORS,
  WINDOWS,
} from '../wasm/contract';
import { keysOf } from './keys';
import { automaticOr, choiceOf, FLAG, oneOf, within } from './text';

/** Windows of each half-edge, as many as propagation keeps. */
export type Windows = (typeof WINDOWS)[number];

export interface Settings {
  /** How distance is found. */
  method: Method;
  /** Of methods other than heat. */
  windows: Windows;
  /** Of the heat method. */
  parameters: Parameters;
  /** Whether a field at rest is made exact, where the method leaves it open. */
  refine: boolean;
}

const { whole, part } = keysOf<Settings>();

/** Their keys in a link, in the order in which it has them. */
export const SETTINGS = [
  whole('method', 'method', choiceOf(METHOD)),
  whole('windows', 'windows', oneOf(WINDOWS)),
  part('t', 'parameters', 'timeStep', automaticOr(within(TIME_STEP_FACTORS))),
  part('b', 'parameters', 'boundary', choiceOf(BOUNDARY)),
  part('multi', 'parameters', 'sources', choiceOf(MULTI_SOURCE)),
  part('near', 'parameters', 'exactRadius', automaticOr(within(EXACT_RADIUS_EDGES))),
  part('memory', 'parameters', 'memory', automaticOr(within(MEMORY_LIMIT_MEBIBYTES))),
  part('op', 'parameters', 'operator', choiceOf(OPERATOR)),
  part('solver', 'parameters', 'solver', choiceOf(LINEAR_SOLVER)),
  whole('refine', 'refine', FLAG),
] as const;
export type SettingKey = (typeof SETTINGS)[number]['key'];
