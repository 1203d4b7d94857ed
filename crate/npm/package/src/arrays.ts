import { HeatwalkError } from './errors.ts';

/** Numbers in double precision, copied; `name` is what errors call them, `each` how many belong together. */
export function floats(values: ArrayLike<number>, name: string, each = 1): Float64Array {
  require(values, name, each);
  return Float64Array.from(values);
}

/** Whole numbers from 0 on, copied; `name` is what errors call one. */
export function integers(values: ArrayLike<number>, name: string, each = 1): Uint32Array {
  require(values, name, each);
  if (!(values instanceof Uint32Array || values instanceof Uint16Array || values instanceof Uint8Array)) {
    for (let k = 0; k < values.length; k++) {
      const value = values[k];
      if (!Number.isInteger(value)) throw new HeatwalkError(`the ${name} ${k} is ${value}, no whole number`, 'bad-parameter');
      if (Number(value) < 0) throw new HeatwalkError(`the ${name} ${k} is ${value}; vertices and faces count from 0`, 'negative-index');
      if (Number(value) > 0xffff_ffff) throw new HeatwalkError(`the ${name} ${k} is ${value}, more than any mesh has`, 'no-such-vertex');
    }
  }
  return Uint32Array.from(values);
}

function require(values: unknown, name: string, each: number) {
  const isList = Array.isArray(values) || (ArrayBuffer.isView(values) && !(values instanceof DataView));
  if (!isList) throw new HeatwalkError(`the ${name} are no list of numbers`, 'bad-parameter');
  const { length } = values as ArrayLike<number>;
  if (length % each) throw new HeatwalkError(`there are ${length} numbers of the ${name}; give ${each} for each`, 'bad-shape');
}
