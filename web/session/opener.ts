/** Decides what to open: a preset, files from the user, or what a link names. */
import { collect, collectArchive, type Collection, NoMesh } from '../files/collection';
import { nameOf } from '../files/address';
import { fetchCollection, type FetchListener } from '../files/fetch';
import { fileName, isArchive, isImage, isTable } from '../files/paths';
import type { SceneFile } from '../files/scene';
import { detailsOf, messageOf, toError } from '../error';
import type { GivenInput } from './kept';
import type { InputFile, MeshInput } from '../protocol';
import { Cancelled, WorkerLost } from '../solver/remote';
import { isOutOfMemory } from '../solver/trap';
import { isPainted, LEVEL } from '../state/ground';
import { HALVED, isWhole, WHOLE } from '../state/inside';
import { type Decoded, decodeLink, isOpenedAlike, refusedBy, undoableOf, withoutOwn } from '../state/link';
import { LANDING_VIEW, findPreset, FIRST_PRESET, titleOf } from '../state/presets';
import { emptyScene, type MeshReference, type SceneState, TRIANGLES } from '../state/scene';
import { NEW_FILE_DEFAULTS, startOf } from '../state/start';
import { type SourceSet, UNCHOSEN } from '../state/sources';
import { AUTOMATIC, DEFAULT_WINDOWS, MESH_TOO_LARGE, TOO_MANY_WINDOWS, TRIANGLE_BYTES } from '../wasm/contract';
import type { LoadingListener } from './loading';
import type { Action, Notifier } from './notifier';
import type { OpenRequest, Shown } from './prepare';
import type { Session } from './session';
import { count, sentences, t, type Words } from '../texts';

/** Files of one drop, paste or dialog. `title` names them while they are read; `at`: where they were dropped, in the window. */
export interface InputFiles {
  title: Words;
  files: Promise<readonly InputFile[]>;
  at?: readonly [number, number];
}

/** What came together, and how the scene refers to a mesh of it. */
interface Origin extends Collection {
  reference: (mesh: string) => MeshReference;
}

const USE_CONJUGATE_GRADIENTS = t('Use conjugate gradients');
const USE_ONE_WINDOW = t('Use one window');

/** Triangles of a simplified model at most, where memory allows as many: more than a screen shows. */
const MOST_SIMPLIFIED = 2_000_000;
/** What wasm32 can address, in MiB. */
const ADDRESS_SPACE = 4096;

/** How far a place may be from where it was, as a share of the diameter: what is the same place differs by rounding to single precision alone. */
const SAME_PLACE = 1e-4;
const ANYWHERE = Infinity;

/** What means nothing on a mesh whose vertices and triangles are counted otherwise. */
const NO_PLACES = { sources: UNCHOSEN, sets: [], walker: undefined, tapes: [], decals: [], links: 0 } as const;

export class Opener {
  readonly #session: Session;
  readonly #notifier: Notifier;
  /** What a link wants to see of a file that only the user can give, or of an address that only the user may open. */
  #awaited: SceneState | null = null;
  /** What could not be used of the link that wants this state. */
  #refused: { state: SceneState | null; values: readonly string[] } = { state: null, values: [] };
  /** How often a mesh was begun to be opened: what takes time to find is not opened once another one is. */
  #begun = 0;

  constructor(session: Session, notifier: Notifier) {
    this.#session = session;
    this.#notifier = notifier;
  }

  /** What a link waits for: the address must not change before. */
  get awaited(): SceneState | null {
    return this.#awaited;
  }

  async preset(id: string, state?: SceneState): Promise<void> {
    const preset = findPreset(id);
    if (!preset) return;
    this.#begun += 1;
    const { title, load, view } = preset;
    const request: OpenRequest = { title, load, state: state ?? preset.start, choosePlaces: true, view };
    if (!state) request.asAuthored = true;
    await this.#open(request, () => this.#forget());
  }

  /** Opens a mesh of files, in a state that is `wanted`; tables or images alone are for the mesh on screen. */
  async files({ title, files, at }: InputFiles, wanted: SceneState | null = null): Promise<void> {
    const given = await files.catch(() => []);
    const [only, ...more] = given;
    if (only && given.every(({ content }) => content.size === 0)) {
      this.#notifier.fail(t`${title} is empty: nothing is in it. Save or copy it again.`, only.path);
      return;
    }
    if (only && given.every(({ path }) => isTable(path))) {
      const { takeTable } = await import('./texts');
      await takeTable(this.#session, this.#notifier, given);
      return;
    }
    if (only && given.every(({ path }) => isImage(path))) {
      const { layFiles } = await import('./laying');
      await layFiles(this.#session, given, at);
      return;
    }
    if (only && more.length === 0 && isArchive(only.path) && (await this.#scene(title, only.content))) return;
    const collected = async () => collect(await files);
    await this.#gather(title, collected, (collection) => {
      if (wanted) return this.#from(fromFiles(collection), collection.meshes[0], wanted);
      const awaited = this.#awaited;
      const name = awaited && titleOf(awaited.mesh);
      const mesh = collection.meshes.find((path) => fileName(path) === name);
      const origin = fromFiles(collection);
      return mesh === undefined ? this.#from(origin, origin.meshes[0]) : this.#from(origin, mesh, awaited);
    });
  }

  /** Opens a scene that was saved as a file; false where an archive holds none. */
  async #scene(title: Words, content: Blob): Promise<boolean> {
    let scene: SceneFile | null;
    try {
      const { sceneIn } = await import('../files/scene');
      scene = await sceneIn(content);
    } catch (error) {
      this.#notifier.fail(t`${title} was not opened: ${messageOf(error)}`, detailsOf(error));
      return true;
    }
    if (!scene) return false;
    const { mesh, images } = scene;
    if (images.length > 0) await (await import('./images')).keepImages(images);
    const { state } = this.#told(decodeLink(scene.link, startOf));
    if (state?.mesh.kind === 'preset') await this.preset(state.mesh.id, state);
    else if (state && mesh !== null)
      await this.#gather(
        title,
        () => collectArchive(content),
        (collection) => this.#from(fromFiles(collection), mesh, state),
      );
    else this.#notifier.fail(t`${title} was not opened: it names no mesh; save the scene again`, scene.link);
    return true;
  }

  /** Takes text for what it is: a link, or a list of sources for the mesh on screen. */
  async pasted(text: string): Promise<void> {
    const { takePasted } = await import('./texts');
    await takePasted(this.#session, this.#notifier, text);
  }

  /** Fetches what is at an address, in the state that a link wants for it. */
  async address(address: string, awaited: SceneState | null = null): Promise<void> {
    const fetched = (progress: LoadingListener, signal: AbortSignal) => {
      const listener: FetchListener = (bytes, fraction) =>
        progress({ stage: 'Fetching', fraction, vertices: 0, bytes });
      return fetchCollection(address, listener, signal);
    };
    await this.#gather(nameOf(address), fetched, (collection) => {
      const [first] = collection.meshes;
      const isPacked = collection.input(first).kind === 'archive';
      const reference = (mesh: string): MeshReference => ({
        kind: 'address',
        address,
        path: isPacked ? mesh : '',
        hash: '',
      });
      const path = awaited?.mesh.kind === 'address' ? awaited.mesh.path : '';
      const mesh = collection.meshes.find((other) => other === path) ?? first;
      return this.#from({ ...collection, reference }, mesh, awaited);
    });
  }

  /** Opens once more what a mesh was opened from. */
  async again(input: GivenInput, wanted: SceneState | null = null): Promise<void> {
    const { mesh } = input;
    const collected = () => (input.kind === 'archive' ? collectArchive(input.archive) : collect(input.files));
    await this.#gather(fileName(mesh), collected, (collection) => {
      const reference = wanted ? () => wanted.mesh : fileReference;
      return this.#from({ ...collection, reference }, mesh, wanted);
    });
  }

  /** So that the way back, a reload and another visit find it. */
  async #keep(input: MeshInput): Promise<void> {
    if (!('mesh' in input)) return;
    const { keep } = await import('./kept');
    await keep(this.#session.scene.state.mesh, input);
  }

  /** One mesh of those that came together, in the state that a link wants for it. */
  async #from(origin: Origin, mesh: string, awaited: SceneState | null = null): Promise<void> {
    const title = fileName(mesh);
    const state = awaited ?? { ...emptyScene(origin.reference(mesh)), ...NEW_FILE_DEFAULTS };
    const load = () => Promise.resolve(origin.input(mesh));
    const request: OpenRequest = { title, load, state, choosePlaces: true, view: LANDING_VIEW };
    if (!awaited) request.asAuthored = true;
    await this.#open(request, ({ opened }) => {
      const wanted = awaited && 'hash' in awaited.mesh ? awaited.mesh.hash : '';
      this.#forget();
      void this.#keep(origin.input(mesh));
      if (wanted && wanted !== opened.hash) {
        this.#notifier.notice(
          t`This ${title} is not the file the link was made with, so sources and walker may be in the wrong place.`,
        );
      }
      if (origin.meshes.length > 1) {
        this.#notifier.choice(mesh, origin.meshes, (other) => void this.#from(origin, other));
      }
    });
  }

  /** Opens one of the meshes of an input; reports why there is none. */
  async #gather(
    title: Words,
    collected: (progress: LoadingListener, signal: AbortSignal) => Promise<Collection>,
    open: (collection: Collection) => Promise<void>,
  ): Promise<void> {
    this.#begun += 1;
    try {
      await this.#session.gather(title, async (progress, signal) => {
        const collection = await collected(progress, signal);
        signal.throwIfAborted();
        await open(collection);
      });
    } catch (error) {
      if (error instanceof Cancelled) return;
      const reason = messageOf(error);
      this.#notifier.fail(error instanceof NoMesh ? reason : t`${title} was not opened: ${reason}`, detailsOf(error));
    }
  }

  /** A shared scene, or the first preset when the fragment names none. */
  async link(fragment: string): Promise<void> {
    const { state } = this.#told(decodeLink(fragment, startOf));
    if (state && (await this.#find(state))) return;
    if (!state || !this.#session.shown.value) await this.preset(FIRST_PRESET.id);
    if (state) this.#await(state);
  }

  /** Tells what of a link cannot be used. */
  #told(decoded: Decoded): Decoded {
    const { state, notices, refused } = decoded;
    if (notices.length > 0) this.#notifier.notice(sentences(...notices));
    this.#refused = { state, values: refused };
    this.#notifier.refused(refused);
    return decoded;
  }

  /** A scene that was shown before: at once where the mesh is the same. */
  async restore(state: SceneState): Promise<void> {
    const { scene, view } = this.#session;
    if (isOpenedAlike(state, scene.state)) {
      scene.edit({ ...undoableOf(state), selected: -1 });
      const { hidden, camera, animation } = state;
      scene.set({ hidden, camera, animation });
      if (camera) view.camera = camera;
    } else if (!(await this.#find(state))) this.#await(state);
  }

  /** Opens the mesh of a state; false where only the user can give it, or allow that it is fetched. */
  async #find(state: SceneState): Promise<boolean> {
    if (state.mesh.kind === 'preset') {
      await this.preset(state.mesh.id, state);
      return true;
    }
    const before = ++this.#begun;
    const { findKept } = await import('./kept');
    const input = await findKept(state.mesh);
    if (this.#begun !== before) return true;
    if (!input) return false;
    const opening = this.again(input, state);
    const own = this.#begun;
    await opening;
    // Whatever was wrong with it, there is a scene.
    if (!this.#session.shown.value && this.#begun === own) await this.preset(FIRST_PRESET.id);
    return true;
  }

  #await(state: SceneState): void {
    this.#awaited = state;
    const { mesh } = state;
    if (mesh.kind === 'file') this.#notifier.askForFile(mesh.name);
    else if (mesh.kind === 'address') this.#notifier.offer(mesh.address, () => void this.address(mesh.address, state));
  }

  /** Walks on other parts of the same file. What is placed on parts that stay active stays where it is. */
  async parts(parts: readonly number[]): Promise<void> {
    await this.#carried({ ...this.#session.scene.state, ...NO_PLACES, parts, ground: LEVEL }, SAME_PLACE);
  }

  /**
   * Fills what the surface encloses with about `wanted` tetrahedra; null shows the surface again. What is placed stays about where
   * it is.
   */
  async fill(wanted: number | null): Promise<void> {
    const { state } = this.#session.scene;
    const inside = wanted === null ? WHOLE : isWhole(state.inside) ? HALVED : state.inside;
    const method = state.fill === null && wanted !== null ? 'auto' : state.method;
    const girth = wanted === null ? state.girth : null;
    await this.#carried({ ...state, ...NO_PLACES, fill: wanted, inside, girth, method, ground: LEVEL }, ANYWHERE);
    if (isPainted(state.ground) && this.#session.scene.state.ground === LEVEL) {
      this.#notifier.notice(
        t('Costs and walls of the triangles before are not those of others: Back brings them back.'),
      );
    }
  }

  /** What can be done when a question to the mesh on screen has failed. */
  remedy(failure: Error): Action | undefined {
    const { state } = this.#session.scene;
    const lighter = lighterOf(state, failure);
    if (lighter) return { name: lighter.name, run: () => void this.#again(lighter.state) };
    if (failure instanceof WorkerLost && !this.#session.engine)
      return { name: t('Open the mesh again'), run: () => void this.#again(state) };
    return undefined;
  }

  /** The same file with another mesh of it. What is placed is taken there as far as `reach`: see `transfer`. */
  async #carried(state: SceneState, reach: number): Promise<void> {
    const { scene, shown } = this.#session;
    const { transfer } = await import('./transfer');
    await this.#again(state, shown.value ? { transfer: transfer(shown.value, scene.state, reach) } : {});
  }

  /** The same mesh once more, in a worker of its own. */
  async #again(state: SceneState, more: Pick<OpenRequest, 'transfer'> = {}): Promise<void> {
    const { request } = this.#session;
    if (request) await this.#open({ ...request, state, choosePlaces: true, view: null, ...more });
  }

  /** Reports why nothing is opened. */
  async #open(request: OpenRequest, done: (shown: Shown) => void = () => undefined): Promise<void> {
    try {
      const shown = await this.#session.open(request);
      const { state } = this.#session.scene;
      const wanted = withoutOwn(request.state, startOf(request.state.mesh));
      const refused = refusedBy(wanted, state);
      if (refused.length > 0) {
        const before = request.state === this.#refused.state ? this.#refused.values : [];
        this.#notifier.refused([...before, ...refused]);
      }
      if (hasLost(wanted, state)) {
        this.#notifier.notice(
          hasChosen(wanted, state)
            ? t('No source of the link is on this mesh; one was chosen.')
            : t('Some sources of the link are not on this mesh and were removed.'),
        );
      }
      if (wanted.links > state.links) {
        this.#notifier.notice(t`The link asks for links=${wanted.links}; no more than ${state.links} can be made.`);
      }
      if (isPainted(wanted.ground) && !isPainted(state.ground)) {
        this.#notifier.notice(t('The ground of the link is of another mesh and was removed.'));
      }
      if (wanted.animation.clip !== null && state.animation.clip === null) {
        this.#notifier.notice(t('The animation of the link is not in this mesh and was left out.'));
      }
      this.#notifier.opened(request.title, shown, state);
      done(shown);
    } catch (error) {
      if (!(error instanceof Cancelled)) {
        const lighter = lighterOf(request.state, toError(error));
        const remedy = lighter && {
          name: lighter.name,
          run: () => void this.#open({ ...request, state: lighter.state }, done),
        };
        const why = messageOf(error);
        const isFilling = request.state.fill !== null && request.state.mesh === this.#session.scene.state.mesh;
        const failure = isFilling
          ? t`${request.title} was not filled: ${why}`
          : t`${request.title} was not opened: ${why}`;
        this.#notifier.fail(failure, detailsOf(error), remedy);
      }
    }
  }

  #forget(): void {
    if (!this.#awaited) return;
    this.#awaited = null;
    this.#notifier.forget();
  }
}

/** The same with less memory, where a failure was for want of it: without factors, or with as few windows as there are. */
function lighterOf(state: SceneState, failure: Error): { name: Words; state: SceneState } | undefined {
  const { method, parameters } = state;
  if (failure.name === MESH_TOO_LARGE) return simplifiedOf(state);
  if (failure.name === TOO_MANY_WINDOWS) return { name: USE_ONE_WINDOW, state: { ...state, windows: DEFAULT_WINDOWS } };
  if (!isOutOfMemory(failure) || method !== 'heat' || parameters.solver === 'cg') return undefined;
  return { name: USE_CONJUGATE_GRADIENTS, state: { ...state, parameters: { ...parameters, solver: 'cg' } } };
}

/** A simplified model that fits. Places count its own vertices, so they are chosen anew. */
function simplifiedOf(state: SceneState): { name: Words; state: SceneState } | undefined {
  const { memory } = state.parameters;
  const limit = state.method === 'heat' || memory === AUTOMATIC ? ADDRESS_SPACE : memory;
  const fitting = Math.min(MOST_SIMPLIFIED, (limit * 2 ** 20) / TRIANGLE_BYTES);
  const digits = 10 ** Math.max(0, Math.floor(Math.log10(fitting)) - 1);
  const triangles = digits * Math.floor(fitting / digits);
  if (triangles < TRIANGLES[0] || state.triangles !== null) return undefined;
  const name = t`Simplify to ${count(triangles)} triangles`;
  return { name, state: { ...state, ...NO_PLACES, triangles, windows: DEFAULT_WINDOWS } };
}

/** Whether some of the sources that were wanted are not there. */
function hasLost(wanted: SceneState, now: SceneState): boolean {
  const there = new Set(now.sources);
  const isFewer = ({ points }: SourceSet, index: number) => points.length > (now.sets[index]?.points.length ?? 0);
  return (
    wanted.sources.some((source) => !there.has(source)) ||
    wanted.sets.length > now.sets.length ||
    wanted.sets.some(isFewer)
  );
}

/** Whether the only source is one that nobody wished. */
function hasChosen(wanted: SceneState, now: SceneState): boolean {
  return (
    now.sets.length === 0 && now.sources.length > 0 && !now.sources.some((source) => wanted.sources.includes(source))
  );
}

function fileReference(mesh: string): MeshReference {
  return { kind: 'file', name: fileName(mesh), hash: '' };
}

function fromFiles(collection: Collection): Origin {
  return { ...collection, reference: fileReference };
}
