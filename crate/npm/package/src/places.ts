import { HeatwalkError } from './errors.ts';

/** A vertex by its number; a point of a face by weights of its corners, of sum 1; or the place nearest to a point in space. */
export type Place =
  | number
  | { readonly face: number; readonly weights: ArrayLike<number> }
  | { readonly x: number; readonly y: number; readonly z: number };

/** One place or several; vertices may be a typed array. */
export type Places = Place | readonly Place[] | Uint32Array | Uint16Array | Int32Array;

/** A vector in space: three numbers, or an object with x, y and z. */
export type Vector = ArrayLike<number> | { readonly x: number; readonly y: number; readonly z: number };

/** Numbers of a place, as the module wants them. */
const PER_PLACE = 5;
const [VERTEX, FACE, POINT] = [0, 1, 2];

const isPlace = (value: unknown): value is Exclude<Place, number> =>
  typeof value === 'object' && value !== null && ('face' in value || 'x' in value);

/** Several places, in one array; `name` is what an error calls one. */
export function encodePlaces(places: Places, name: string): Float64Array {
  const list = typeof places === 'number' || isPlace(places) ? [places] : places;
  if (typeof list !== 'object' || list === null || !('length' in list)) refuse(name, places);
  const numbers = new Float64Array(list.length * PER_PLACE);
  for (let k = 0; k < list.length; k++) {
    const called = list.length === 1 ? name : `${name} ${k}`;
    numbers.set(encoded(list[k] as Place, called), k * PER_PLACE);
  }
  return numbers;
}

/** One place. */
export function encodePlace(place: Place, name: string): Float64Array {
  return Float64Array.from(encoded(place, name));
}

function encoded(place: Place, name: string): number[] {
  if (typeof place === 'number') return [VERTEX, index(place, name), 0, 0, 0];
  if (!isPlace(place)) refuse(name, place);
  if ('face' in place) {
    const { face, weights } = place;
    if (weights?.length !== 3) throw new HeatwalkError(`the ${name} has no three weights`, 'bad-place');
    return [FACE, index(face, `face of the ${name}`), ...Array.from(weights, Number)];
  }
  return [POINT, Number(place.x), Number(place.y), Number(place.z), 0];
}

/** A whole number that counts something from 0. */
export function index(value: unknown, name: string): number {
  if (typeof value !== 'number' || !Number.isInteger(value)) refuse(name, value);
  if (value < 0) throw new HeatwalkError(`the ${name} is ${value}; vertices and faces count from 0`, 'negative-index');
  return value;
}

/** Three numbers of a vector. */
export function encodeVector(vector: Vector, name: string): Float64Array {
  const numbers = 'x' in vector ? [vector.x, vector.y, vector.z] : Array.from(vector);
  if (numbers.length !== 3) throw new HeatwalkError(`the ${name} is not three numbers`, 'bad-shape');
  return Float64Array.from(numbers);
}

function refuse(name: string, value: unknown): never {
  const given = Array.isArray(value) ? 'a list' : typeof value === 'object' ? 'an object' : String(value);
  const sentence = `the ${name} is ${given}; give a vertex, { face, weights } or { x, y, z }`;
  throw new HeatwalkError(sentence, 'bad-place');
}
