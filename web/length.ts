/**
 * Lengths, areas and volumes. Meshes, links and the solver have them in the unit of the model's coordinates; what people read, type
 * and save has them in the unit that is shown. Numbers of the model are no numbers that texts take, so that each passes through here.
 */
import { AUTOMATIC } from './wasm/contract';

/** A length, an area or a volume in the unit of the model's coordinates, by the power of that unit. */
export type OfModel<Power extends 1 | 2 | 3> = number & { readonly ofModel: Power };
export type ModelLength = OfModel<1>;
export type ModelArea = OfModel<2>;
export type ModelVolume = OfModel<3>;

/** `T` with some of its numbers as lengths and areas of the model. */
export type WithLengths<T, Lengths extends keyof T, Areas extends keyof T = never> = Omit<T, Lengths | Areas> & {
  [Key in Lengths]: ModelLength;
} & { [Key in Areas]: ModelArea };

/** How long the units are in micrometers: quotients of whole numbers are rounded once. */
const MICROMETERS: Readonly<Record<string, number>> = {
  µm: 1,
  mm: 1e3,
  cm: 1e4,
  in: 25_400,
  ft: 304_800,
  m: 1e6,
  km: 1e9,
};

/** Units of lengths. */
export const SHOWN_UNITS = ['mm', 'cm', 'm', 'km', 'in', 'ft'] as const;
export type ShownUnit = (typeof SHOWN_UNITS)[number];

/** What the unit of a file can be said to be. */
export const UNITS = [...SHOWN_UNITS, 'none'] as const;

/** The unit of the file, or the one that its size suggests; or one of these. */
export type UnitChoice = (typeof UNITS)[number] | typeof AUTOMATIC;

/** The unit that lengths are shown in: a symbol, or nothing; and whether only the size of the mesh suggests it. */
export interface LengthUnit {
  symbol: string;
  assumed: boolean;
  /** Length of the model's unit in it. */
  scale: number;
}

/** That of the model itself. */
export const MODEL: LengthUnit = { symbol: '', assumed: false, scale: 1 };

/** Digits of a number that was converted there and back. */
const DIGITS = 12;

/** What the model's unit is, and in which one lengths are shown. */
export interface Units {
  /** What the lengths in the file are. Another choice corrects the size of the model. */
  unit: UnitChoice;
  /** Length of the file's unit in `unit`; 1 unless a known length says otherwise. */
  scale: number;
  /** What lengths are converted to, which leaves the size of the model as it is; null: they are shown in `unit`. */
  shownUnit: ShownUnit | null;
}

/** What a file says of its unit, or its size suggests. */
interface UnitOfFile {
  unit: string;
  unitAssumed: boolean;
}

/** The unit in which lengths of a mesh are shown. */
export function unitOf(units: Units, opened: UnitOfFile): LengthUnit {
  const own = ownUnitOf(units, opened);
  return units.shownUnit ? inUnit(own, units.shownUnit) : own;
}

/** The unit that the model is said to have, whatever it is shown in. */
export function ownUnitOf({ unit, scale }: Units, opened: UnitOfFile): LengthUnit {
  if (unit === AUTOMATIC) return { symbol: opened.unit, assumed: opened.unitAssumed, scale };
  return { symbol: unit === 'none' ? '' : unit, assumed: false, scale };
}

/** Units without a conversion where nothing is known that could be converted. */
export function convertible({ unit, scale, shownUnit }: Units, opened: UnitOfFile): Units {
  const own = ownUnitOf({ unit, scale, shownUnit }, opened);
  return { unit, scale, shownUnit: isKnown(own) ? shownUnit : null };
}

/** The same lengths in another unit; in their own where nothing says what that is. */
export function inUnit(unit: LengthUnit, symbol: string): LengthUnit {
  const [from, to] = [MICROMETERS[unit.symbol], MICROMETERS[symbol]];
  return from && to ? { ...unit, symbol, scale: (unit.scale * from) / to } : unit;
}

/** Whether lengths in it can be converted into other units. */
export function isKnown({ symbol }: LengthUnit): boolean {
  return symbol in MICROMETERS;
}

/** Kinds of files of drawings, which programs that cut and print take for millimeters. */
const DRAWINGS: ReadonlySet<string> = new Set(['svg', 'dxf', 'pdf']);

/** The unit of a file that is saved: glTF has meters, drawings have millimeters, all others have the one that is shown. */
export function unitOfFile(kind: string, unit: LengthUnit): LengthUnit {
  const format = kind.slice(kind.lastIndexOf('.') + 1);
  if (format === 'glb') return inUnit(unit, 'm');
  return DRAWINGS.has(format) ? inUnit(unit, 'mm') : unit;
}

/** Whether lengths are shown in the same unit. */
export function isSameUnit(one: Units, other: Units): boolean {
  return one.unit === other.unit && one.scale === other.scale && one.shownUnit === other.shownUnit;
}

/** A length in the unit that is shown. */
export function told(value: ModelLength, { scale }: LengthUnit): number {
  return value * scale;
}

export function toldArea(value: ModelArea, { scale }: LengthUnit): number {
  return value * scale ** 2;
}

export function toldVolume(value: ModelVolume, { scale }: LengthUnit): number {
  return value * scale ** 3;
}

/** A length that was typed, or that a field shows: without the digits of rounding. */
export function typed(value: ModelLength, unit: LengthUnit): number {
  return unit.scale === 1 ? value : Number(told(value, unit).toPrecision(DIGITS));
}

/** A length that was typed, or read from a table. */
export function inModel(value: number, { scale }: LengthUnit): ModelLength {
  return ofModel(value / scale);
}

/** What a mesh, a link or the solver gives as a length, an area or a volume. */
export function ofModel<Power extends 1 | 2 | 3 = 1>(value: number): OfModel<Power> {
  return value as OfModel<Power>;
}

/** Heads of columns of lengths in a file. */
export function headOf(names: readonly string[], { symbol }: LengthUnit): string {
  return names.map((name) => (symbol ? `${name} (${symbol})` : name)).join(',');
}
