/** Answers the page around the frame, and tells it what happens. Nobody else is heard, and nobody else is answered. */
import type { Events, Message, Method, Methods, Request } from '../../embed';
import { messageOf } from '../../error';
import type { Session } from '../../session/session';
import { Actions, type ActionsOptions } from '../control/actions';
import { fieldFigures, meshFigures, placesOf } from '../control/figures';
import type { Heatwalk } from '../scripting';
import { addressed, parseRequest, VERSION } from './requests';

/** As the pointer tells clicks from drags: see `PointerInput`. */
const CLICK_PX = 4;
const CLICK_MS = 250;

/** Listens from now on, and says so once. */
export function answerHost(options: ActionsOptions, api: Heatwalk): void {
  new Embedding(options, api).listen();
}

class Embedding {
  readonly #session: Session;
  readonly #api: Heatwalk;
  readonly #actions: Actions;
  /** Of the page around the frame, once it has asked; events go there. */
  #host: string | null = null;

  constructor(options: ActionsOptions, api: Heatwalk) {
    this.#session = options.session;
    this.#api = api;
    this.#actions = new Actions(options, api);
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
    const session = this.#session;
    void this.#api.ready.then(() => this.#tell('ready', this.#actions.state()));
    session.shown.watch((shown, previous) => {
      if (!shown) return;
      if (shown.opened !== previous?.opened) this.#tell('opened', meshFigures(shown, session.scene.state));
      const { field } = shown.answer;
      const isAnew = field !== previous?.answer.field && (field?.refineMs === 0 || field?.exactShare === 1);
      if (field && isAnew) this.#tell('solved', fieldFigures(field));
    });
    session.loading.watch((loading) => {
      if (loading) this.#tell('loading', { stage: loading.stage, fraction: loading.fraction });
    });
    session.scene.subscribe((state, previous) => {
      if (state.sources !== previous.sources || state.walker !== previous.walker) this.#tell('placed', placesOf(state));
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
      const place = isClick ? this.#api.placeAt(event.clientX, event.clientY) : null;
      if (place) this.#tell('picked', { place, distance: this.#api.distanceAt(place) });
    });
  }

  async #answer(request: Request): Promise<{ answer: Methods[Method]['answer']; transferred?: Transferable[] }> {
    const actions = this.#actions;
    switch (request.method) {
      case 'hello':
        return { answer: { version: VERSION } };
      case 'open':
        return { answer: await actions.open(request) };
      case 'set':
        await actions.set(request.options);
        return { answer: null };
      case 'setSources':
        actions.setSources(request.sources);
        return { answer: null };
      case 'setWalker':
        actions.setWalker(request.walker);
        return { answer: null };
      case 'state':
        return { answer: actions.state() };
      case 'distances': {
        const distances = await actions.distances();
        return { answer: distances, transferred: distances ? [distances.values.buffer] : [] };
      }
      case 'path': {
        const path = await actions.path();
        return { answer: path, transferred: path ? [path.points.buffer] : [] };
      }
      case 'picture':
        return { answer: await this.#api.picture(request.scale, request.clear, request.legend) };
    }
  }
}
