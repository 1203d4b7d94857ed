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
import { automaticOr, choiceOf, flag, number, oneOf, option, within } from './text';

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

/** Their keys in a link. */
export const SETTINGS = ['method', 'windows', 't', 'b', 'multi', 'near', 'memory', 'op', 'solver', 'refine'] as const;
export type SettingKey = (typeof SETTINGS)[number];

export function encodeSettings({ method, windows, parameters, refine }: Settings): Record<SettingKey, string> {
  return {
    method,
    windows: number(windows),
    t: option(parameters.timeStep),
    b: parameters.boundary,
    multi: parameters.sources,
    near: option(parameters.exactRadius),
    memory: option(parameters.memory),
    op: parameters.operator,
    solver: parameters.solver,
    refine: flag(refine),
  };
}

/** Settings with another value of one of them. */
type Apply = (settings: Settings) => Settings;
type Parser = (text: string) => Apply | null;

/** Reads the value of a key: what it makes of settings, or null for text that is none. */
export function parserOf(key: SettingKey): Parser {
  return PARSERS[key];
}

const PARSERS: Record<SettingKey, Parser> = {
  method: plain('method', choiceOf(METHOD)),
  windows: plain('windows', (text) => WINDOWS.find((count) => String(count) === text) ?? null),
  t: parameter('timeStep', automaticOr(within(...TIME_STEP_FACTORS))),
  b: parameter('boundary', choiceOf(BOUNDARY)),
  multi: parameter('sources', choiceOf(MULTI_SOURCE)),
  near: parameter('exactRadius', automaticOr(within(...EXACT_RADIUS_EDGES))),
  memory: parameter('memory', automaticOr(within(...MEMORY_LIMIT_MEBIBYTES))),
  op: parameter('operator', choiceOf(OPERATOR)),
  solver: parameter('solver', choiceOf(LINEAR_SOLVER)),
  refine: (text) => {
    const refine = oneOf(['0', '1'])(text);
    return refine && ((settings) => ({ ...settings, refine: refine === '1' }));
  },
};

function plain<K extends 'method' | 'windows'>(name: K, parse: (text: string) => Settings[K] | null): Parser {
  return (text) => {
    const value = parse(text);
    return value === null ? null : (settings) => ({ ...settings, [name]: value });
  };
}

function parameter<K extends keyof Parameters>(name: K, parse: (text: string) => Parameters[K] | null): Parser {
  return (text) => {
    const value = parse(text);
    const apply: Apply = (settings) => ({ ...settings, parameters: { ...settings.parameters, [name]: value } });
    return value === null ? null : apply;
  };
}
