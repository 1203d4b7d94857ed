/** What scripts and the page around the frame can have done: the page tells nobody but them when it cannot be. */
import type { Distances, MeshFigures, Openable, Options, Path, Source, Place, State } from '../../embed';
import { Failure } from '../../error';
import { convertible } from '../../length';
import type { MeshPoint } from '../../protocol';
import type { Notifier } from '../../session/notifier';
import { Opener } from '../../session/opener';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import { entry } from '../../state/entry';
import { fits } from '../../state/ground';
import { PRESETS } from '../../state/presets';
import { decodeLink, isOpenedWith, isUndoable } from '../../state/link';
import type { SceneState } from '../../state/scene';
import { onceEach } from '../../state/sources';
import { startOf, startOfFile } from '../../state/start';
import type { Tape } from '../../state/tapes';
import type { Heatwalk } from '../scripting';
import { distancesOf, meshFigures, pathOf, stateOf } from './figures';
import { sentences, type Words } from '../../texts';

export interface ActionsOptions {
  session: Session;
  /** Where what is opened is reported. */
  messages: Notifier;
  /** To the present scene. */
  link: () => string;
}

export class Actions {
  readonly #o: ActionsOptions;
  readonly #api: Heatwalk;

  constructor(options: ActionsOptions, api: Heatwalk) {
    this.#o = options;
    this.#api = api;
  }

  async open(what: Openable): Promise<MeshFigures> {
    const { session, messages } = this.#o;
    // What is in the address of the page would come back over it.
    await this.#api.ready;
    const before = session.shown.value?.opened;
    let reason: Words | null = null;
    const notifier = quiet(messages, (failure) => (reason = failure));
    await openWith(new Opener(session, notifier), what);
    const { value: shown } = session.shown;
    if (reason !== null) throw new Failure(reason);
    if (!shown || shown.opened === before) throw new Error('The opening was cancelled.');
    return meshFigures(shown, session.scene.state);
  }

  async set(options: Options): Promise<void> {
    const { session } = this.#o;
    const { state } = session.scene;
    // The scene as it is is what the options change.
    const wanted = decoded(`m=${state.mesh.kind}&${written(options)}`, () => state);
    const changed = (Object.keys(wanted) as (keyof SceneState)[]).filter(
      (key) => JSON.stringify(wanted[key]) !== JSON.stringify(state[key]),
    );
    const ofMesh = changed.filter(isOpenedWith);
    if (ofMesh.length > 0) throw new Error(`${ofMesh.join(', ')} belong to the mesh: give them to open.`);
    this.#requireAll(wanted);
    if (changed.includes('sets')) wanted.sets = await this.#found(wanted.sets);
    const part = (isWanted: (key: keyof SceneState) => boolean) =>
      Object.fromEntries(changed.filter(isWanted).map((key) => [key, wanted[key]]));
    if (changed.some(isUndoable)) session.scene.edit(part(isUndoable));
    if (changed.some((key) => !isUndoable(key))) session.scene.set(part((key) => !isUndoable(key)));
    if (changed.includes('camera') && wanted.camera) session.view.camera = wanted.camera;
  }

  setSources(given: readonly Source[]): void {
    const sources = [...given] as MeshPoint[];
    sources.forEach((source, index) => this.#require(source, `sources[${index}]`));
    this.#o.session.scene.edit({ sources: onceEach(sources), selected: -1 });
  }

  setWalker(given: Place | null): void {
    const walker = given as MeshPoint | null;
    if (walker) this.#require(walker, 'walker');
    this.#o.session.scene.edit({ walker });
  }

  setTapes(tapes: readonly Tape[]): void {
    this.#requireTapes(tapes, 'tapes');
    this.#o.session.scene.edit({ tapes });
  }

  state(): State {
    const { session, link } = this.#o;
    return stateOf(session, this.#api, link());
  }

  async distances(): Promise<Distances | null> {
    await this.#api.settled();
    return distancesOf(this.#shown);
  }

  async path(): Promise<Path | null> {
    await this.#api.settled();
    return pathOf(this.#shown);
  }

  get #shown(): Shown {
    const { value: shown } = this.#o.session.shown;
    if (!shown) throw new Error('No mesh is open: wait until the page is ready, or open one.');
    return shown;
  }

  #require(place: MeshPoint, name: string): void {
    const { places, opened } = this.#shown;
    if (!places.has(place)) throw new Error(`${name}, ${JSON.stringify(place)}, is not on ${opened.name}.`);
  }

  #requireTapes(tapes: readonly Tape[], name: string): void {
    tapes.forEach(({ points }, index) =>
      points.forEach((point, i) => this.#require(point, `${name}[${index}].points[${i}]`)),
    );
  }

  #requireAll({ sources, walker, tapes, ground, ...units }: SceneState): void {
    sources.forEach((source, index) => this.#require(source, `s[${index}]`));
    if (walker) this.#require(walker, 'w');
    this.#requireTapes(tapes, 'tape');
    const { opened } = this.#shown;
    const { name, report } = opened;
    if (convertible(units, opened).shownUnit !== units.shownUnit)
      throw new Error(`shown=${units.shownUnit}: lengths of ${name} have no unit; give unit too.`);
    if (!fits(ground, { triangles: report.faces, inputVertices: report.inputVertices }))
      throw new Error(`ground is of another mesh than ${name}.`);
  }

  /** @throws where the mesh does not have all of them. */
  async #found(sets: SceneState['sets']): Promise<SceneState['sets']> {
    const { engine } = this.#o.session;
    const { opened, places } = this.#shown;
    if (!engine) throw new Error('The solver is being restarted: wait until the page has settled.');
    const { found } = await import('../../session/found');
    const all = await found({ engine, opened, places }, sets);
    if (all.length < sets.length)
      throw new Error(`sets has ${sets.length} entries; ${all.length} are on ${opened.name}.`);
    return all;
  }
}

/** Tells what was opened as ever, and leaves it to whoever asked to show what was not. */
function quiet(notifier: Notifier, failed: (reason: Words) => void): Notifier {
  return {
    opened: (title, shown, state) => notifier.opened(title, shown, state),
    notice: (text, action) => notifier.notice(text, action),
    remark: (text, action) => notifier.remark(text, action),
    refused: (values) => notifier.refused(values),
    choice: (shown, meshes, open) => notifier.choice(shown, meshes, open),
    fail: failed,
    askForFile: (name) => notifier.askForFile(name),
    offer: (address, open) => notifier.offer(address, open),
    forget: () => notifier.forget(),
  };
}

async function openWith(opener: Opener, what: Openable): Promise<void> {
  if ('link' in what) return openLink(opener, what.link);
  const options = what.options ? `&${written(what.options)}` : '';
  if ('preset' in what) {
    if (!PRESETS.some(({ id }) => id === what.preset))
      throw new Error(`${what.preset} is no preset: see window.heatwalk.presets.`);
    return opener.preset(what.preset, decoded(`m=${encodeURIComponent(what.preset)}${options}`));
  }
  if ('url' in what) {
    const { mesh, ...state } = decoded(`model=${encodeURIComponent(what.url)}${options}`);
    if (mesh.kind !== 'address') throw new Error(`${what.url} is no http or https address.`);
    return opener.address(mesh.address, options ? { mesh, ...state } : null);
  }
  const { name: title } = entry(what.files, 0);
  const files = what.files.map((file) => ({
    path: file.name,
    content: file instanceof File ? file : new Blob([file.content]),
  }));
  const state = options ? decoded(`m=file&name=${encodeURIComponent(title)}${options}`, startOfFile) : null;
  return opener.files({ title, files: Promise.resolve(files) }, state);
}

async function openLink(opener: Opener, link: string): Promise<void> {
  const state = decoded(link.slice(link.indexOf('#') + 1));
  const { mesh } = state;
  if (mesh.kind === 'file') throw new Error(`The link needs the file ${mesh.name}: give it in files, with options.`);
  return mesh.kind === 'preset' ? opener.preset(mesh.id, state) : opener.address(mesh.address, state);
}

/** Throws what a link would be forgiven. */
function decoded(fragment: string, start: typeof startOf = startOf): SceneState {
  const { state, notices, refused, unknown } = decodeLink(fragment, start);
  if (refused.length > 0) throw new Error(`${refused.join(', ')}: no such value.`);
  if (notices.length > 0) throw new Failure(sentences(...notices));
  if (unknown.length > 0) throw new Error(`There is no option ${unknown.join(', ')}.`);
  if (!state) throw new Error('The link names no mesh.');
  return state;
}

function written(options: Options): string {
  return Object.entries(options)
    .map(([key, value]) => `${encodeURIComponent(key)}=${encodeURIComponent(value)}`)
    .join('&');
}
