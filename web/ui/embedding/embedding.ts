/** Answers the page around the frame, and tells it what happens. Nobody else is heard, and nobody else is answered. */
import type { Events, Message, Method, Methods, Openable, Options, Request } from '../../embed';
import { Failure, messageOf } from '../../error';
import type { MeshPoint } from '../../protocol';
import { Opener, startOf, startOfFile, type Notifier } from '../../session/opener';
import type { GroundEditor } from '../../session/ground';
import type { Session } from '../../session/session';
import { entry } from '../../state/entry';
import { decodeLink, isOpenedWith, isUndoable } from '../../state/link';
import type { SceneState } from '../../state/scene';
import type { Heatwalk } from '../scripting';
import { distancesOf, fieldFigures, meshFigures, pathOf, stateOf } from './figures';
import { addressed, parseRequest, VERSION } from './requests';
import { sentences, type Words } from '../../texts';

/** As the pointer tells clicks from drags: see `PointerInput`. */
const CLICK_PX = 4;
const CLICK_MS = 250;

export interface EmbeddingOptions {
  session: Session;
  api: Heatwalk;
  /** Where what is opened is reported. */
  messages: Notifier;
  ground: GroundEditor;
  /** To the present scene. */
  link: () => string;
}

/** Listens from now on, and says so once. */
export function answerHost(options: EmbeddingOptions): void {
  new Embedding(options).listen();
}

class Embedding {
  readonly #o: EmbeddingOptions;
  /** Of the page around the frame, once it has asked; events go there. */
  #host: string | null = null;

  constructor(options: EmbeddingOptions) {
    this.#o = options;
  }

  listen(): void {
    addEventListener('message', (event) => {
      if (event.source === window.parent) void this.#received(event);
    });
    this.#follow();
    // To whoever it is, since it tells nothing else.
    window.parent.postMessage({ heatwalk: VERSION, event: 'listening' } satisfies Message, '*');
  }

  async #received({ data, origin }: MessageEvent): Promise<void> {
    const request = addressed(data);
    if (!request) return;
    const { id } = request;
    // A page that is opened from a file has an origin that cannot be named.
    const host = origin === 'null' ? '*' : origin;
    this.#host = host;
    try {
      const { answer, transferred = [] } = await this.#answer(parseRequest(data));
      this.#post({ heatwalk: VERSION, id, answer }, host, transferred);
    } catch (error) {
      this.#post({ heatwalk: VERSION, id, error: String(messageOf(error)) }, host);
    }
  }

  #post(message: Message, host: string, transferred: Transferable[] = []): void {
    window.parent.postMessage(message, host, transferred);
  }

  #tell<E extends keyof Events>(event: E, detail: Events[E]): void {
    if (this.#host !== null) this.#post({ heatwalk: VERSION, event, detail } as Message, this.#host);
  }

  #follow(): void {
    const { session, api } = this.#o;
    void api.ready.then(() => this.#tell('ready', this.#state()));
    session.shown.watch((shown, previous) => {
      if (!shown) return;
      if (shown.opened !== previous?.opened) this.#tell('opened', meshFigures(shown, session.scene.state));
      const { field } = shown.answer;
      const isAnew = field !== previous?.answer.field && (field?.refineMs === 0 || field?.exactShare === 1);
      if (field && isAnew) this.#tell('solved', fieldFigures(field));
    });
    session.failure.watch((failure) => {
      if (failure) this.#tell('error', { message: String(messageOf(failure)) });
    });
    session.view.trouble.watch((message) => {
      if (message) this.#tell('error', { message: String(message) });
    });
    this.#followClicks(session.view.stage);
  }

  #followClicks(stage: HTMLElement): void {
    let pressed: PointerEvent | null = null;
    stage.addEventListener('pointerdown', (event) => {
      pressed = event.isPrimary && event.button === 0 ? event : null;
    });
    stage.addEventListener('pointerup', (event) => {
      if (!pressed || event.pointerId !== pressed.pointerId) return;
      const moved = Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY);
      const isClick = moved <= CLICK_PX && event.timeStamp - pressed.timeStamp <= CLICK_MS;
      const place = isClick ? this.#o.api.placeAt(event.clientX, event.clientY) : null;
      if (place) this.#tell('picked', { place, distance: this.#o.api.distanceAt(place) });
    });
  }

  async #answer(request: Request): Promise<{ answer: Methods[Method]['answer']; transferred?: Transferable[] }> {
    const { session, api } = this.#o;
    switch (request.method) {
      case 'hello':
        return { answer: { version: VERSION } };
      case 'open':
        return { answer: await this.#open(request) };
      case 'set':
        this.#set(request.options);
        return { answer: null };
      case 'setSources': {
        const sources = [...request.sources] as MeshPoint[];
        sources.forEach((source, index) => this.#require(source, `sources[${index}]`));
        session.scene.edit({ sources, selected: -1 });
        return { answer: null };
      }
      case 'setWalker': {
        const walker = request.walker as MeshPoint | null;
        if (walker) this.#require(walker, 'walker');
        session.scene.edit({ walker });
        return { answer: null };
      }
      case 'state':
        return { answer: this.#state() };
      case 'distances': {
        await api.settled();
        const { value: shown } = session.shown;
        const distances = shown && distancesOf(shown);
        return { answer: distances, transferred: distances ? [distances.values.buffer] : [] };
      }
      case 'path': {
        await api.settled();
        const { value: shown } = session.shown;
        const path = shown && pathOf(shown);
        return { answer: path, transferred: path ? [path.points.buffer] : [] };
      }
      case 'picture':
        return { answer: await api.picture(request.scale, request.clear, request.legend) };
    }
  }

  #state() {
    const { session, api, link } = this.#o;
    return stateOf(session, api, link());
  }

  #require(place: MeshPoint, name: string): void {
    const { value: shown } = this.#o.session.shown;
    if (!shown) throw new Error('No mesh is open: wait for the event ready, or open one.');
    if (!shown.places.has(place)) throw new Error(`${name}, ${JSON.stringify(place)}, is not on ${shown.opened.name}.`);
  }

  async #open(what: Openable): Promise<Methods['open']['answer']> {
    const { session, api, messages, ground } = this.#o;
    // What is in the address of the frame would come back over it.
    await api.ready;
    const before = session.shown.value?.opened;
    let reason: Words | null = null;
    await openWith(
      new Opener(
        session,
        quiet(messages, (failure) => (reason = failure)),
        ground,
      ),
      what,
    );
    const { value: shown } = session.shown;
    if (reason !== null) throw new Failure(reason);
    if (!shown || shown.opened === before) throw new Error('The opening was cancelled.');
    return meshFigures(shown, session.scene.state);
  }

  #set(options: Options): void {
    const { session } = this.#o;
    const { state } = session.scene;
    // The scene as it is is what the options change.
    const wanted = decoded(`m=${state.mesh.kind}&${written(options)}`, () => state);
    const changed = (Object.keys(wanted) as (keyof SceneState)[]).filter(
      (key) => JSON.stringify(wanted[key]) !== JSON.stringify(state[key]),
    );
    const ofMesh = changed.filter(isOpenedWith);
    if (ofMesh.length > 0) throw new Error(`${ofMesh.join(', ')} belong to the mesh: give them to open.`);
    wanted.sources.forEach((source, index) => this.#require(source, `s[${index}]`));
    if (wanted.walker) this.#require(wanted.walker, 'w');
    const part = (isWanted: (key: keyof SceneState) => boolean) =>
      Object.fromEntries(changed.filter(isWanted).map((key) => [key, wanted[key]]));
    if (changed.some(isUndoable)) session.scene.edit(part(isUndoable));
    if (changed.some((key) => !isUndoable(key))) session.scene.set(part((key) => !isUndoable(key)));
    if (changed.includes('camera') && wanted.camera) session.view.camera = wanted.camera;
  }
}

/** Tells what was opened as ever, and leaves it to the host to show what was not. */
function quiet(notifier: Notifier, failed: (reason: Words) => void): Notifier {
  return {
    opened: (title, shown, state) => notifier.opened(title, shown, state),
    notice: (text) => notifier.notice(text),
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
    const { mesh, ...state } = decoded(`m=${encodeURIComponent(what.preset)}${options}`);
    if (mesh.kind !== 'preset') throw new Error(`${what.preset} is no preset: see window.heatwalk.presets.`);
    return opener.preset(mesh.id, { mesh, ...state });
  }
  if ('url' in what) {
    const { mesh, ...state } = decoded(`model=${encodeURIComponent(what.url)}${options}`);
    if (mesh.kind !== 'address') throw new Error(`${what.url} is no http or https address.`);
    return opener.address(mesh.address, options ? { mesh, ...state } : null);
  }
  const { name: title } = entry(what.files, 0);
  const files = what.files.map(({ name, content }) => ({ path: name, content: new Blob([content]) }));
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
  const { state, notices, unknown } = decodeLink(fragment, start);
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
