/** What the page around a frame asks, looked through before anything is done: it may be anything. */
import type { Method, Request, Version } from '../../embed';
import { type Fields, isObject, openable, optionsOf, shown, sourcesOf, walkerOf } from '../control/arguments';

export const VERSION: Version = 1;

/** Of pictures: a larger one would not fit into a canvas everywhere. */
const SCALES = [1, 4] as const;

/** What of a message concerns this page; null where it is none of ours. */
export function addressed(data: unknown): { id: number; version: unknown } | null {
  if (!isObject(data) || !('heatwalk' in data)) return null;
  return typeof data['id'] === 'number' ? { id: data['id'], version: data['heatwalk'] } : null;
}

/** Throws a sentence that names what is wrong. */
export function parseRequest(data: unknown): Request {
  if (!isObject(data)) throw new Error('A request is an object.');
  const { heatwalk, id, method } = data;
  if (heatwalk !== VERSION)
    throw new Error(`This page speaks version ${VERSION} of the messages, and the request is of ${shown(heatwalk)}.`);
  if (typeof method !== 'string' || !Object.hasOwn(PARSERS, method))
    throw new Error(`There is no method ${shown(method)}; there are ${Object.keys(PARSERS).join(', ')}.`);
  const wanted = PARSERS[method as Method](data);
  return { ...wanted, heatwalk: VERSION, id, method } as Request;
}

const PARSERS: { [M in Method]: (given: Fields) => object } = {
  hello: () => ({}),
  open: openable,
  set: ({ options }) => ({ options: optionsOf(options) }),
  setSources: ({ sources }) => ({ sources: sourcesOf(sources) }),
  setWalker: ({ walker }) => ({ walker: walkerOf(walker) }),
  state: () => ({}),
  distances: () => ({}),
  path: () => ({}),
  picture: ({ scale = 1, clear = false, legend = false }) => {
    const [least, most] = SCALES;
    if (typeof scale !== 'number' || !(scale >= least && scale <= most))
      throw new Error(`scale is ${shown(scale)}; a number from ${least} to ${most} is needed.`);
    if (typeof clear !== 'boolean') throw new Error(`clear is ${shown(clear)}; true or false is needed.`);
    if (typeof legend !== 'boolean') throw new Error(`legend is ${shown(legend)}; true or false is needed.`);
    return { scale, clear, legend };
  },
};
