/** The lines that reproduce the numbers of a scene with the program `heatwalk`. */
import { Failure } from '../error';
import type { DistanceField, InnerPoint, OpenedMesh, Source } from '../protocol';
import { AUTOMATIC, DEFAULT_PARAMETERS } from '../wasm/contract';
import { costOf, EVEN, type Ground, isPainted, isWall } from './ground';
import type { LengthUnit } from '../length';
import { triangleOfFile } from './parts';
import type { SceneState } from './scene';
import { allSources } from './sources';
import { count, t, type Words } from '../texts';

/** Sources that a command line holds: Windows allows 32,767 characters. */
const MOST_SOURCES = 2000;

/** What holds sources. */
const PLACES = { command: t('A command line'), program: t('A program') };

/** The file that tetrahedra are written to which a surface is filled with. */
const FILLED = 'filled.msh';

/** What is measured: of the scene, the mesh that it has, and the field that is shown. */
export interface Measured {
  state: SceneState;
  /** A file name, or `shape:NAME`. */
  mesh: string;
  /** What is to be known of the file, for a reader of the lines; null for nothing. */
  origin: Words | null;
  opened: Pick<OpenedMesh, 'simplified' | 'interior' | 'report' | 'active' | 'parts' | 'clips' | 'drawTransform'>;
  field: Pick<DistanceField, 'exactBelow' | 'windows' | 'timeFactor' | 'refineMs'>;
  /** In which lengths are shown; the program has those of the file. */
  unit: LengthUnit;
}

/** What there is to do: files to write, then commands to run. */
interface Steps {
  comments: Words[];
  files: { name: string; rows: string[] }[];
  commands: string[][];
}

/**
 * Lines of a shell that write the distances to a CSV file.
 *
 * @throws Error where the program cannot be asked for the same, with the reason.
 */
export function commandLines(measured: Measured): string {
  const { comments, files, commands } = stepsOf(measured);
  return [
    ...comments.map(commented),
    ...files.flatMap(({ name, rows }) => [`cat > ${name} <<'END'`].concat(rows, 'END')),
    ...commands.map((words) => words.map(quoted).join(' ')),
  ].join('\n');
}

/** The same from Python, by the program, as an array of NumPy. */
export function pythonLines(measured: Measured): string {
  const { comments, files, commands } = stepsOf(measured);
  const { scale, symbol } = measured.unit;
  const factor = scale === 1 ? '' : `${scale} * `;
  const last = `distances = ${factor}numpy.loadtxt('distances.csv', delimiter=',', skiprows=1)[:, 1]`;
  return [
    ...comments.map(commented),
    'import pathlib',
    'import subprocess',
    'import numpy',
    ...files.map(({ name, rows }) => `pathlib.Path('${name}').write_text(${literal(rows.concat('').join('\n'))})`),
    ...commands.map((words) => `subprocess.run([${words.map(literal).join(', ')}], check=True)`),
    symbol ? `${last}  # ${symbol}` : last,
  ].join('\n');
}

function stepsOf(measured: Measured): Steps {
  const { state, mesh, origin, opened, field } = measured;
  const { scale, symbol } = measured.unit;
  const steps: Steps = { comments: [], files: [], commands: [] };
  if (origin) steps.comments.push(origin);
  if (scale !== 1)
    steps.comments.push(t`Lengths are in the unit of the file, which is ${String(scale)} ${symbol || t('units')}.`);
  if (field.refineMs > 0 && field.exactBelow < Infinity)
    steps.comments.push(
      t`The page has refined distances below ${String(field.exactBelow)} to exact ones; these are of the method alone.`,
    );
  const parts =
    opened.active.length < opened.parts.length ? opened.active.flatMap((part) => ['--part', `${part}`]) : [];
  const sources = sourcesOf(measured, 'command').flatMap((source) => ['--source', sourceWord(source)]);
  // A name that begins like an option is none.
  const file = mesh.startsWith('-') ? `./${mesh}` : mesh;
  const given = ['--output', 'distances.csv'];
  if (opened.interior) {
    const isFilled = state.fill !== null && opened.interior.report.isFilled;
    if (isFilled)
      steps.commands.push(['heatwalk', 'fill', file, ...parts, '--tetrahedra', `${state.fill}`, '--output', FILLED]);
    const method = field.timeFactor === undefined ? ['--method', 'march'] : heatWords(state);
    steps.commands.push(['heatwalk', 'distance', isFilled ? FILLED : file, ...sources, ...method, ...given]);
    return steps;
  }
  const words = ['heatwalk', 'distance', file, ...parts];
  if (state.unit !== AUTOMATIC && state.scale === 1) words.push('--unit', state.unit);
  const { clip, seconds, live } = state.animation;
  if (live && clip !== null) words.push('--animation', `${clip}`, '--time', `${seconds}`);
  words.push(...sources);
  if (state.bridge !== AUTOMATIC) words.push('--bridge', `${state.bridge}`);
  if (state.links > 0) words.push('--link', `${state.links}`);
  words.push(...groundWords(measured, steps), ...methodWords(state, field), ...given);
  steps.commands.push(words);
  return steps;
}

/** What the ground costs, and its walls, in files that the steps write. */
function groundWords({ state: { ground }, opened }: Measured, { comments, files }: Steps): string[] {
  const words: string[] = [];
  const rows = rowsOf(ground, opened);
  if (rows === null) comments.push(t('Triangles of the file were left out, so what is painted is not in these lines.'));
  const written = (name: string, heading: string, its: string[]) => {
    if (its.length > 0) files.push({ name, rows: [heading, ...its] });
    return its.length > 0;
  };
  if (rows && written('weights.csv', 'triangle,cost', rows.weights)) words.push('--weights', 'weights.csv');
  if (rows && written('walls.csv', 'wall', rows.walls)) words.push('--walls', 'walls.csv');
  if (ground.slope) words.push('--slope-cost', 'tobler');
  if (ground.highest !== 1) words.push('--height-cost', String(ground.highest));
  if (ground.slope || ground.highest !== 1) words.push('--up', opened.drawTransform.up);
  return words;
}

/** Triangles of the file with their costs, and triangles and edges that are walls; null where triangles are not found again. */
function rowsOf({ faces, lines }: Ground, opened: Measured['opened']): { weights: string[]; walls: string[] } | null {
  const { degenerateFaces, duplicateFaces } = opened.report;
  if (faces.length > 0 && degenerateFaces + duplicateFaces > 0) return null;
  const [weights, walls]: [string[], string[]] = [[], []];
  faces.forEach((code, face) => {
    if (isWall(code)) walls.push(`${triangleOfFile(opened, face)}`);
    else if (costOf(code) !== costOf(EVEN)) weights.push(`${triangleOfFile(opened, face)},${costOf(code)}`);
  });
  for (const { vertices, open } of lines) {
    if (!open) walls.push(...vertices.slice(1).map((vertex, index) => `${vertices[index]},${vertex}`));
  }
  return { weights, walls };
}

/**
 * The sources of what is measured, where the program and the crate can be asked for the same. `place`: what holds them.
 *
 * @throws Error with the reason.
 */
function sourcesOf({ state, opened }: Measured, place: keyof typeof PLACES): Source[] {
  if (opened.simplified)
    throw new Failure(t('The mesh was simplified on this page; save it, and open the saved mesh.'));
  const sources = allSources(state);
  if (sources.length > MOST_SOURCES)
    throw new Failure(
      t`${PLACES[place]} has room for ${count(MOST_SOURCES)} sources, and these are ${count(sources.length)}.`,
    );
  const isInside = opened.interior !== null;
  // Triangles count among those that were kept, with the corners that they have since; tetrahedra as in the file.
  const { degenerateFaces, duplicateFaces, flippedFaces } = opened.report;
  const isAsInFile = isInside || degenerateFaces + duplicateFaces + flippedFaces === 0;
  return sources.map((source) => {
    if ('vertex' in source) return source;
    if ('tetrahedron' in source !== isInside)
      throw new Failure(
        t('A source is on the boundary, where the program has no places inside of tetrahedra. Move it inside.'),
      );
    if (!isAsInFile)
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

/** A source that is on a surface. */
export type SurfaceSource = Exclude<Source, InnerPoint>;

/**
 * The same of level surfaces alone, for a program in Rust.
 *
 * @throws Error with the reason.
 */
export function surfaceSources(measured: Measured): SurfaceSource[] {
  const { slope, highest } = measured.state.ground;
  if (measured.opened.interior || isPainted(measured.state.ground) || slope || highest !== 1)
    throw new Failure(t('Lines of Rust are for surfaces without costs and walls. Choose the command line or Python.'));
  return sourcesOf(measured, 'program').filter((source): source is SurfaceSource => !('tetrahedron' in source));
}

function methodWords(state: SceneState, field: Measured['field']): string[] {
  const { method, windows } = state;
  if (field.exactBelow === Infinity) return ['--method', 'exact'];
  if (method !== 'heat' || field.windows !== undefined)
    return ['--method', 'propagation', '--windows', `${field.windows || windows}`];
  return heatWords(state);
}

function heatWords({ parameters }: SceneState): string[] {
  const words = ['--method', 'heat'];
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
    if (value !== DEFAULT_PARAMETERS[key]) words.push(`--${option}`, value === Infinity ? 'inf' : `${value}`);
  }
  return words;
}

function sourceWord(source: Source): string {
  const from = source.offset ? `@${source.offset}` : '';
  if ('vertex' in source) return `${source.vertex}${from}`;
  const element = 'face' in source ? source.face : source.tetrahedron;
  return `${element}:${source.weights.join(',')}${from}`;
}

/** On one line, whatever names it has. */
function commented(words: Words): string {
  return `# ${String(words).replaceAll(/\s/g, ' ')}`;
}

/** A word of a shell. */
function quoted(word: string): string {
  return /^[\w./:,@-]+$/.test(word) ? word : `'${word.replaceAll("'", String.raw`'\''`)}'`;
}

/** A string of Python. */
function literal(text: string): string {
  return JSON.stringify(text);
}
