/** The lines that reproduce the numbers of a scene with the program `heatwalk`. */
import { Failure } from '../error';
import type { DistanceField, InnerPoint, OpenedMesh, Source } from '../protocol';
import { AUTOMATIC, DEFAULT_PARAMETERS } from '../wasm/contract';
import { isPainted } from './ground';
import type { LengthUnit } from '../length';
import { triangleOfFile } from './parts';
import type { SceneState } from './scene';
import { allSources } from './sources';
import { count, t } from '../texts';

/** Sources that a command line holds: Windows allows 32,767 characters. */
const MOST_SOURCES = 2000;

/** What holds sources. */
const PLACES = { command: t('A command line'), program: t('A program') };

/** A source that is on a surface. */
export type SurfaceSource = Exclude<Source, InnerPoint>;

/** What is measured: of the scene, the mesh that it has, and the field that is shown. */
export interface Measured {
  state: SceneState;
  /** A file name, or `shape:NAME`. */
  mesh: string;
  opened: Pick<OpenedMesh, 'simplified' | 'interior' | 'report' | 'active' | 'parts' | 'clips'>;
  field: Pick<DistanceField, 'exactBelow' | 'windows'>;
  /** In which lengths are shown; the program has those of the file. */
  unit: LengthUnit;
}

/**
 * The command that writes the distances to a CSV file.
 *
 * @throws Error where the program cannot be asked for the same, with the reason.
 */
export function commandLine(measured: Measured): string {
  const { state, mesh, opened, field } = measured;
  const sources = reproducedSources(measured, 'command');
  const words = ['heatwalk', 'distance', quoted(mesh)];
  if (opened.active.length < opened.parts.length) words.push(...opened.active.map((part) => `--part ${part}`));
  const { clip, seconds, live } = state.animation;
  if (live && clip !== null) words.push(`--animation ${clip} --time ${seconds}`);
  words.push(...sources.map((source) => `--source ${sourceWord(source)}`));
  if (state.bridge !== AUTOMATIC) words.push(`--bridge ${state.bridge}`);
  if (state.links > 0) words.push(`--link ${state.links}`);
  words.push(...methodWords(state, field), '--output distances.csv');
  return words.join(' ');
}

/**
 * The sources of what is measured, where the program and the crate can be asked for the same. `place`: what holds them.
 *
 * @throws Error with the reason.
 */
export function reproducedSources({ state, opened }: Measured, place: keyof typeof PLACES): SurfaceSource[] {
  if (opened.interior) throw new Failure(t('Distances inside of tetrahedra made on this page have no lines.'));
  if (opened.simplified)
    throw new Failure(t('The mesh was simplified on this page; save it, and open the saved mesh.'));
  const { slope, highest } = state.ground;
  if (isPainted(state.ground) || slope || highest !== 1)
    throw new Failure(t('Paint, walls and slopes of this page have no lines.'));
  const sources = allSources(state);
  if (sources.length > MOST_SOURCES)
    throw new Failure(
      t`${PLACES[place]} has room for ${count(MOST_SOURCES)} sources, and these are ${count(sources.length)}.`,
    );
  // The page counts the triangles that were kept, with the corners that they have since.
  const { degenerateFaces, duplicateFaces, flippedFaces } = opened.report;
  const isAsInFile = degenerateFaces + duplicateFaces + flippedFaces === 0;
  return sources.map((source) => {
    if ('tetrahedron' in source) throw new Failure(t('A source inside of tetrahedra has no place on a surface.'));
    if ('face' in source && !isAsInFile)
      throw new Failure(
        t('Triangles of the file were left out or flipped, so sources are only found again at vertices.'),
      );
    return 'face' in source ? inFile(opened, source) : source;
  });
}

/** A source inside a triangle, which counts as in the file. */
function inFile<S extends { face: number }>(opened: Measured['opened'], source: S): S {
  return { ...source, face: triangleOfFile(opened, source.face) };
}

/** The same after a comment that says how lengths of the file are shown, where that is in another unit. */
export function commandLines(measured: Measured): string {
  const { scale, symbol } = measured.unit;
  const comment = scale === 1 ? [] : [`# Lengths are in the unit of the file, which is ${scale} ${symbol || 'units'}.`];
  return [...comment, commandLine(measured)].join('\n');
}

/** The same from Python, by the program, as an array of NumPy. */
export function pythonLines(measured: Measured): string {
  const { scale, symbol } = measured.unit;
  const factor = scale === 1 ? '' : `${scale} * `;
  return [
    'import subprocess',
    'import numpy',
    `subprocess.run(${pythonText(commandLine(measured))}, shell=True, check=True)`,
    `distances = ${factor}numpy.loadtxt('distances.csv', delimiter=',', skiprows=1)[:, 1]${symbol && `  # ${symbol}`}`,
  ].join('\n');
}

function methodWords({ method, parameters, windows }: SceneState, field: Measured['field']): string[] {
  if (field.exactBelow === Infinity) return ['--method exact'];
  if (method !== 'heat' || field.windows !== undefined)
    return [`--method propagation --windows ${field.windows || windows}`];
  const words = ['--method heat'];
  const options = [
    ['operator', 'operator'],
    ['solver', 'solver'],
    ['boundary', 'boundary'],
    ['t', 'timeStep'],
    ['near', 'exactRadius'],
    ['multi', 'sources'],
  ] as const;
  for (const [option, key] of options) {
    const value = parameters[key];
    if (value !== DEFAULT_PARAMETERS[key]) words.push(`--${option} ${value === Infinity ? 'inf' : value}`);
  }
  return words;
}

function sourceWord(source: SurfaceSource): string {
  const from = source.offset ? `@${source.offset}` : '';
  return 'vertex' in source ? `${source.vertex}${from}` : `${source.face}:${source.weights.join(',')}${from}`;
}

function quoted(name: string): string {
  return /^[\w./:#-]+$/.test(name) && !name.startsWith('-') ? name : `'${name.replaceAll("'", String.raw`'\''`)}'`;
}

function pythonText(text: string): string {
  return JSON.stringify(text);
}
