/**
 * Heatwalk in a frame of another page: the messages, and a client that sends them. It depends on nothing; the build writes it
 * to `embed.js` and its types to `embed.d.ts`. docs/embedding.md describes both.
 */

/** Of the messages. Later versions add to it; what means something else has another number. */
export type Version = 1;

/** A place: an index of the input, or weights in a drawn triangle or a tetrahedron of the input, which sum to 1. */
export type Place =
  | { vertex: number }
  | { face: number; weights: readonly [number, number, number] }
  | { tetrahedron: number; weights: readonly [number, number, number, number] };

/** A place that distance is measured from. `offset`: the distance at it, in the unit of the file. */
export type Source = Place & { offset?: number };

/** Keys of the link, without those that it alone has (`v`, `m`, `model`, `name`, `hash`, `kiosk`, `open`), and their values: `{ look: 'gold' }`. */
export type Options = Readonly<Record<string, string | number>>;

/** A file of a mesh. What the mesh refers to is looked for by `name`, which may be a path. */
export interface EmbeddedFile {
  name: string;
  content: Blob | ArrayBuffer;
}

/** What to open: one of these. */
export type Openable =
  | { preset: string; options?: Options }
  /** An http or https address of a mesh or a .zip, which its server must let other pages read. */
  | { url: string; options?: Options }
  /** Of the first mesh among them. */
  | { files: readonly (EmbeddedFile | File)[]; options?: Options }
  /** A link of the page to a preset or an address, or its fragment. */
  | { link: string };

export interface MeshFigures {
  name: string;
  triangles: number;
  vertices: number;
  /** Of what distances are counted by. */
  inputVertices: number;
  components: number;
  /** Diagonal of the bounding box, in the unit of the file. */
  diameter: number;
  /** The symbol of the unit in which the page shows lengths, `mm`; empty where there is none. */
  unit: string;
  /** The length of the unit of the file, which all lengths here are in, in that one. */
  scale: number;
}

export interface FieldFigures {
  /** In the unit of the file. */
  maxDistance: number;
  unreachableVertices: number;
  /** Share of the vertices whose distance is exact, 0 to 1. */
  exactShare: number;
}

export interface State {
  mesh: MeshFigures | null;
  field: FieldFigures | null;
  /** Whether all is exact, and why not: `refining` in docs/scripting.md. */
  refining: string;
  sources: readonly Source[];
  walker: Place | null;
  /** To the present scene. */
  link: string;
  backend: string | null;
}

export interface Distances extends FieldFigures {
  /** One a vertex of the input, with the precision that is drawn (24 bits); Infinity where no source reaches, NaN off the surface. */
  values: Float64Array;
}

export interface Path {
  /** Points × 3, from the walker to the source, in the axes and the unit of the file. */
  points: Float64Array;
  length: number;
  /** The length, each segment times what a unit of it costs. */
  cost: number;
  kind: string;
}

/** What can be asked, and what is answered. */
export interface Methods {
  /** Answers once the page listens; events come from then on. */
  hello: { ask: Record<never, never>; answer: { version: Version } };
  /** Answers once the mesh is shown. The one before stays where it cannot be opened. */
  open: { ask: Openable; answer: MeshFigures };
  /** Changes the scene by keys of the link; those of the mesh (`p`, `triangles`, `fill`) belong to `open`. */
  set: { ask: { options: Options }; answer: null };
  setSources: { ask: { sources: readonly Source[] }; answer: null };
  setWalker: { ask: { walker: Place | null }; answer: null };
  state: { ask: Record<never, never>; answer: State };
  /** Answers once nothing is solved or refined any more. */
  distances: { ask: Record<never, never>; answer: Distances | null };
  /** Likewise; null without a walker, or where no source reaches it. */
  path: { ask: Record<never, never>; answer: Path | null };
  /** Likewise; a PNG, `scale` (1 to 4) times as large as the frame, without the background if `clear`. */
  picture: { ask: { scale?: number; clear?: boolean; legend?: boolean }; answer: Blob };
}

export type Method = keyof Methods;

/** What the page tells without being asked. */
export interface Events {
  /** The first scene is solved and drawn. */
  ready: State;
  /** A mesh is being opened: the name of what is done, and how much of it, 0 to 1; null where that is not known. */
  loading: { stage: string; fraction: number | null };
  opened: MeshFigures;
  /** Single sources or the walker are others now, by whomever; told during a drag, too. */
  placed: { sources: readonly Source[]; walker: Place | null };
  /** A field is shown: after each change, and once more when it is exact. */
  solved: FieldFigures;
  /** The user clicked or tapped the surface. `distance` is NaN before the first field. */
  picked: { place: Place; distance: number };
  error: { message: string };
}

/** From the page around the frame. */
export type Request = {
  [M in Method]: { heatwalk: Version; id: number; method: M } & Methods[M]['ask'];
}[Method];

/** To the page around the frame. `listening` comes once, before anybody has asked. */
export type Message =
  | { heatwalk: Version; event: 'listening' }
  | { heatwalk: Version; id: number; answer: unknown }
  | { heatwalk: Version; id: number; error: string }
  | { [E in keyof Events]: { heatwalk: Version; event: E; detail: Events[E] } }[keyof Events];

const VERSION: Version = 1;

interface Waiting {
  resolve: (answer: never) => void;
  reject: (error: Error) => void;
}

/**
 * A page in a frame. Dispatches `Events` as custom events: `heatwalk.addEventListener('solved', ({ detail }) => …)`; `on` is the
 * same with types. Calls made before the page has loaded wait for it.
 */
export class EmbeddedHeatwalk extends EventTarget {
  readonly #frame: HTMLIFrameElement;
  readonly #listening = Promise.withResolvers<void>();
  readonly #waiting = new Map<number, Waiting>();
  readonly #receive = (event: MessageEvent) => this.#received(event);
  #last = 0;
  #closed: Error | null = null;

  /** `frame`: an iframe with the address of the page. */
  constructor(frame: HTMLIFrameElement) {
    super();
    this.#frame = frame;
    window.addEventListener('message', this.#receive);
    // Nobody may wait for it.
    this.#listening.promise.catch(() => undefined);
    // It may have been listening before.
    this.#post({ heatwalk: VERSION, id: 0, method: 'hello' });
  }

  open(what: Openable): Promise<MeshFigures> {
    return this.ask('open', what);
  }

  set(options: Options): Promise<null> {
    return this.ask('set', { options });
  }

  setSources(sources: readonly Source[]): Promise<null> {
    return this.ask('setSources', { sources });
  }

  setWalker(walker: Place | null): Promise<null> {
    return this.ask('setWalker', { walker });
  }

  state(): Promise<State> {
    return this.ask('state', {});
  }

  distances(): Promise<Distances | null> {
    return this.ask('distances', {});
  }

  path(): Promise<Path | null> {
    return this.ask('path', {});
  }

  picture(wanted: { scale?: number; clear?: boolean; legend?: boolean } = {}): Promise<Blob> {
    return this.ask('picture', wanted);
  }

  /** Returns the function that ends this. */
  on<E extends keyof Events>(event: E, listener: (detail: Events[E]) => void): () => void {
    const heard = (dispatched: Event) => listener((dispatched as CustomEvent<Events[E]>).detail);
    this.addEventListener(event, heard);
    return () => this.removeEventListener(event, heard);
  }

  async ask<M extends Method>(method: M, wanted: Methods[M]['ask']): Promise<Methods[M]['answer']> {
    await this.#listening.promise;
    if (this.#closed) throw this.#closed;
    const id = ++this.#last;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      try {
        this.#post({ ...wanted, heatwalk: VERSION, id, method } as Request);
      } catch (error) {
        this.#waiting.delete(id);
        reject(error instanceof Error ? error : new Error(String(error)));
      }
    });
  }

  /** Hears nothing any more; calls under way fail, and so do later ones. */
  close(): void {
    window.removeEventListener('message', this.#receive);
    const closed = new Error('The connection to the frame was closed.');
    this.#closed = closed;
    this.#listening.reject(closed);
    for (const { reject } of this.#waiting.values()) reject(closed);
    this.#waiting.clear();
  }

  #post(request: Request): void {
    this.#frame.contentWindow?.postMessage(request, this.#origin);
  }

  /** A page that is opened from a file has none that could be named. */
  get #origin(): string {
    const { origin } = new URL(this.#frame.src, document.baseURI);
    return origin === 'null' || this.#frame.sandbox.length > 0 ? '*' : origin;
  }

  #received({ source, origin, data }: MessageEvent): void {
    const message = data as Message | null;
    if (source !== this.#frame.contentWindow || message?.heatwalk !== VERSION) return;
    // The frame may have been led to a page of somebody else.
    if (this.#origin !== '*' && origin !== this.#origin) return;
    if ('event' in message) {
      // A page that is loaded anew knows nothing of what was asked.
      if (message.event === 'listening') this.#post({ heatwalk: VERSION, id: 0, method: 'hello' });
      else this.dispatchEvent(new CustomEvent(message.event, { detail: message.detail }));
      return;
    }
    if (message.id === 0) this.#listening.resolve();
    const waiting = this.#waiting.get(message.id);
    this.#waiting.delete(message.id);
    if ('error' in message) waiting?.reject(new Error(message.error));
    else waiting?.resolve(message.answer as never);
  }
}
