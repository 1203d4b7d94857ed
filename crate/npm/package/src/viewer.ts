import {
  type Distances,
  EmbeddedHeatwalk,
  type EmbeddedFile,
  type MeshFigures,
  type Openable,
  type Options,
  type Path,
  type Place,
  type Source,
} from '../../../../web/embed.ts';
import type { Triangles } from './mesh.ts';
import { plyOf } from './ply.ts';

export type { Distances, EmbeddedFile, MeshFigures, Options, Path, Place, Source, Triangles };

/** Where the page is, unless `page` says so: relative to the document. */
const PAGE = 'heatwalk/';
/** What it begins with before a mesh comes, behind the poster: the smallest preset. */
const BEGINNING = 'm=icosphere&kiosk=1';
/** After the frame has loaded, the page listens at once, or once the rest of it has come. */
const MOST_SECONDS = 20;
/** Attributes whose values are those of keys of links. */
const KEYS: Readonly<Record<string, string>> = {
  sources: 's',
  walker: 'w',
  method: 'method',
  look: 'look',
  ramp: 'ramp',
  stripe: 'stripe',
  period: 'period',
  show: 'show',
};
/** Attributes that say which mesh is shown. */
const OPENED = ['src', 'preset'];

const STYLE = `
  :host { display: block; position: relative; width: 300px; height: 150px; }
  :host([hidden]) { display: none; }
  iframe { display: block; width: 100%; height: 100%; border: 0; }
  [part='poster'] { position: absolute; inset: 0; overflow: hidden; background: var(--poster-color, Canvas); }
  [part='poster'][hidden] { display: none; }
  ::slotted([slot='poster']) { width: 100%; height: 100%; object-fit: cover; }
`;

/** What is shown instead of `src`: triangles in memory, or files, of which the first mesh is opened. */
export type Given = Triangles | File | EmbeddedFile | readonly (File | EmbeddedFile)[];

// On a server there are no elements, and nothing is made of this.
const Base = globalThis.HTMLElement ?? (Object as unknown as typeof HTMLElement);

/**
 * `<heatwalk-viewer>`: a mesh with the distances from its sources, drawn by Heatwalk's page in a frame, without its panel. docs/npm.md lists the
 * attributes. Events are `CustomEvent`s that do not bubble: `load` (`MeshFigures`), `progress` (`{ stage, fraction }`), `distance` (`Distances`),
 * `sourcechange` (`{ sources, walker }`, by the user), `pick` (`{ place, distance }`) and `error` (`{ message }`).
 */
export class HeatwalkViewer extends Base {
  static readonly observedAttributes = ['alt', 'page', 'options', ...OPENED, ...Object.keys(KEYS)];

  readonly #poster: HTMLElement;
  #frame: HTMLIFrameElement | undefined;
  #client: EmbeddedHeatwalk | undefined;
  #watch: IntersectionObserver | undefined;
  #given: Given | null = null;
  #sources: readonly Source[] = [];
  #walker: Place | null = null;
  readonly #changed = new Set<string>();
  /** The mesh that was asked for last; another one is none of what is waited for. */
  #opening: Promise<EmbeddedHeatwalk> | undefined;
  #isShown = false;
  #isAsking = false;
  /** Changes that are under way: what the page tells of places meanwhile is no change by the user. */
  #own = 0;

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open', delegatesFocus: true });
    const style = new CSSStyleSheet();
    style.replaceSync(STYLE);
    root.adoptedStyleSheets = [style];
    this.#poster = document.createElement('div');
    this.#poster.part.add('poster');
    const poster = document.createElement('slot');
    poster.name = 'poster';
    this.#poster.append(poster);
    root.append(this.#poster, document.createElement('slot'));
  }

  /** Instead of `src`, while it is set. */
  get mesh(): Given | null {
    return this.#given;
  }

  set mesh(given: Given | null) {
    this.#given = given;
    this.#change('mesh');
  }

  /** The single sources that are shown, also those that the user has set. Set by a list, or as links have them; the attribute follows. */
  get sources(): readonly Source[] {
    return this.#sources;
  }

  set sources(sources: readonly Source[] | string) {
    this.setAttribute('sources', typeof sources === 'string' ? sources : sources.map(sourceText).join(',') || 'none');
  }

  /** Where the walker starts; null where there is none. Set by a place, or as links have it; the attribute follows. */
  get walker(): Place | null {
    return this.#walker;
  }

  set walker(walker: Place | string | null) {
    this.setAttribute('walker', walker === null ? 'none' : typeof walker === 'string' ? walker : placeText(walker));
  }

  /** The distance of each vertex once nothing is solved any more; null without a source. */
  async distance(): Promise<Distances | null> {
    return (await this.#shown()).distances();
  }

  /** The path of the walker, likewise; null without one. */
  async path(): Promise<Path | null> {
    return (await this.#shown()).path();
  }

  /** A PNG, likewise: `scale` (1 to 4) times as large as the element, without the background if `clear`, with the legend if `legend`. */
  async toBlob(wanted: { scale?: number; clear?: boolean; legend?: boolean } = {}): Promise<Blob> {
    return (await this.#shown()).picture(wanted);
  }

  /** @internal */
  connectedCallback() {
    if (this.getAttribute('loading') !== 'lazy') return this.#begin();
    this.#watch = new IntersectionObserver((entries) => {
      if (entries.some(({ isIntersecting }) => isIntersecting)) this.#begin();
    });
    this.#watch.observe(this);
  }

  /** @internal */
  disconnectedCallback() {
    this.#end();
  }

  /** @internal */
  attributeChangedCallback(name: string) {
    if (name === 'alt') this.#title();
    else if (name !== 'page') this.#change(name);
    else if (this.#frame) {
      this.#end();
      this.connectedCallback();
    }
  }

  #begin() {
    this.#watch?.disconnect();
    const address = new URL(this.getAttribute('page') ?? PAGE, document.baseURI);
    address.hash = BEGINNING;
    const frame = (this.#frame = document.createElement('iframe'));
    frame.src = address.href;
    frame.allow = 'fullscreen; clipboard-write';
    this.#title();
    this.#poster.before(frame);
    const client = (this.#client = new EmbeddedHeatwalk(frame));
    client.on('loading', (detail) => this.#tell('progress', detail));
    client.on('picked', (detail) => this.#tell('pick', detail));
    client.on('error', (detail) => this.#tell('error', detail));
    client.on('solved', () => void this.#tellDistance(client));
    client.on('placed', ({ sources, walker }) => {
      [this.#sources, this.#walker] = [sources, walker];
      if (this.#own === 0) this.#tell('sourcechange', { sources, walker });
    });
    const answered = client.ask('hello', {}).then(
      () => true,
      () => true,
    );
    frame.addEventListener('load', () => {
      const late = new Promise<false>((resolve) => setTimeout(resolve, 1000 * MOST_SECONDS, false));
      void Promise.race([answered, late]).then((hasAnswered) => {
        if (!hasAnswered && this.#client === client) this.#fail(silent(address));
      });
    });
    this.#change('mesh');
  }

  /** Gives the frame back with all that is in it. */
  #end() {
    this.#watch?.disconnect();
    this.#client?.close();
    this.#frame?.remove();
    this.#frame = this.#client = this.#opening = undefined;
    this.#isShown = this.#isAsking = this.#poster.hidden = false;
    [this.#sources, this.#walker, this.#own] = [[], null, 0];
  }

  #title() {
    if (this.#frame) this.#frame.title = this.getAttribute('alt') ?? 'Heatwalk';
  }

  /** Has the page follow in a moment, with all that changes until then. */
  #change(name: string) {
    if (this.#changed.size === 0) queueMicrotask(() => void this.#follow());
    this.#changed.add(name);
  }

  async #follow() {
    const changed = [...this.#changed];
    this.#changed.clear();
    const client = this.#client;
    if (!client) return;
    const isGone = (name: string) => !this.hasAttribute(name);
    // What is taken away goes back to what the mesh begins with.
    if (!this.#opening || changed.some((name) => name === 'mesh' || OPENED.includes(name) || isGone(name))) {
      const what = this.#wanted();
      if (what) await this.#open(client, what);
      return;
    }
    await this.#opening.then(
      () => this.#owned(client, () => client.set(this.#options(changed))),
      // It was told.
      () => undefined,
    );
  }

  async #open(client: EmbeddedHeatwalk, what: Openable) {
    this.#isShown = false;
    const opening = (this.#opening = client.open(what).then(() => client));
    const isCurrent = () => this.#opening === opening;
    await this.#owned(
      client,
      async () => {
        await opening;
        const { mesh, sources, walker } = await client.state();
        if (!isCurrent()) return;
        [this.#sources, this.#walker] = [sources, walker];
        this.#isShown = this.#poster.hidden = true;
        this.#tell('load', mesh);
        void this.#tellDistance(client);
      },
      isCurrent,
    );
  }

  /** A change by the element; what is wrong with it is told if that `matters` still. */
  async #owned(client: EmbeddedHeatwalk, change: () => Promise<unknown>, matters = () => true) {
    this.#own++;
    try {
      await change();
    } catch (error) {
      if (this.#client === client && matters()) this.#fail(error);
    } finally {
      if (this.#client === client) this.#own--;
    }
  }

  async #tellDistance(client: EmbeddedHeatwalk) {
    if (!this.#isShown || this.#isAsking) return;
    this.#isAsking = true;
    const distances = await client.distances().catch(() => null);
    if (this.#client !== client) return;
    this.#isAsking = false;
    if (distances && this.#isShown) this.#tell('distance', distances);
  }

  #wanted(): Openable | undefined {
    const options = this.#options(['options', ...Object.keys(KEYS)]);
    const given = this.#given;
    if (given) return { files: 'positions' in given ? [{ name: 'mesh.ply', content: plyOf(given) }] : [given].flat(), options };
    const [src, preset] = OPENED.map((name) => this.getAttribute(name));
    if (src) return { url: new URL(src, document.baseURI).href, options };
    return preset ? { preset, options } : undefined;
  }

  /** Keys of the link that attributes of these names have. */
  #options(names: readonly string[]): Options {
    const all: [string, string][] = names.includes('options')
      ? [...new URLSearchParams(this.getAttribute('options') ?? '')]
      : [];
    for (const [name, key] of Object.entries(KEYS)) {
      const value = this.getAttribute(name);
      if (value !== null && names.includes(name)) all.push([key, value]);
    }
    return Object.fromEntries(all);
  }

  async #shown(): Promise<EmbeddedHeatwalk> {
    // What was set just now comes first.
    await Promise.resolve();
    if (!this.#opening) throw new Error('Nothing is shown: give src or mesh, and have the element in a document and in view.');
    return this.#opening;
  }

  #fail(error: unknown) {
    this.#tell('error', { message: error instanceof Error ? error.message : String(error) });
  }

  #tell(type: string, detail: unknown) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}

const silent = ({ origin, pathname }: URL) =>
  `${origin}${pathname} does not answer; give the address of a build of Heatwalk as the attribute page.`;

function placeText(place: Place): string {
  if ('vertex' in place) return String(place.vertex);
  return `${'face' in place ? place.face : place.tetrahedron}:${place.weights.join('/')}`;
}

const sourceText = (source: Source) => placeText(source) + (source.offset ? `@${source.offset}` : '');

if (globalThis.customElements && !customElements.get('heatwalk-viewer')) {
  customElements.define('heatwalk-viewer', HeatwalkViewer);
}

declare global {
  interface HTMLElementTagNameMap {
    'heatwalk-viewer': HeatwalkViewer;
  }
}
