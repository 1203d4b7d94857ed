import { floats } from './arrays.ts';

/** Options with the distances that sources start from as an array. */
export function withInitial<O extends { initial?: ArrayLike<number> | undefined }>(options: O): O {
  return options.initial ? { ...options, initial: floats(options.initial, 'initial distances') } : options;
}
