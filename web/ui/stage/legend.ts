/** The legend on the stage: it follows the picture, is moved by hand and by arrow keys, and is in saved pictures. */
import '../../style/stage.css';
import type { Session } from '../../session/session';
import type { Signal } from '../../state/signal';
import type { PlaneContext } from '../../view/view';
import { attribute, h } from '../dom';
import { arrowOf, draggable, hasModifier } from '../gesture';
import { narrow } from '../panel/panel';
import { remember, remembered } from '../memory';
import { type Box, clearOf, type Place } from './clear';
import { type Content, contentOf } from './content';
import { type Look, drawLegend, drawPlate, sizeOf } from './draw';
import { t } from '../../texts';

const MEMORY = 'heatwalk.legend.place';

/** What an arrow key moves it by, CSS pixels. */
const NUDGE_PX = 8;
/** From the edges: beside the tools, and below what stands at the top. */
const GAP = 12;
const BELOW_HEADING = 64;
const BELOW_HINTS = 112;
const BELOW_SIDES = 140;

/** With less room for the model, the small one; CSS pixels. */
const ROOM = { width: 900, height: 480 } as const;

const AXES = { X: '#d0342c', Y: '#2e8b2e', Z: '#2f6fd6' } as const;

/** What floats beside it. */
const OTHERS = '.panel, .heading, .toolbar, .hint, .message, .loading, .compare-left, .compare-right';
/** What changes where these stand. */
const CHANGING = '.stage, .panel, .heading, .toolbar, .hint, .messages > div, .loading';
/** Between it and them. */
const APART = 4;

/** Share of the room that is left of and above it, from 0 to 1. */
type Share = Place;

export class Legend {
  readonly #canvas = h('canvas', { role: 'img' });
  readonly element = h(
    'div',
    {
      class: 'legend',
      role: 'region',
      tabindex: 0,
      hidden: true,
      'aria-label': t('Legend. Arrow keys move it, L hides it.'),
      title: t('Drag to move, L to hide'),
    },
    this.#canvas,
  );
  readonly #session: Session;
  readonly #isOn: Signal<boolean>;
  readonly #forced = matchMedia('(forced-colors: active)');
  /** Where it was put by hand. */
  #place: Share | null = rememberedPlace();
  #content: Content | null = null;
  /** What is drawn. */
  #drawn = '';
  #isAwaited = false;

  constructor(session: Session, isOn: Signal<boolean>) {
    this.#session = session;
    this.#isOn = isOn;
    const soon = () => this.#followSoon();
    isOn.watch(soon);
    session.shown.watch(soon);
    session.offsets.watch(soon);
    session.cells.watch(soon);
    session.scene.subscribe(soon);
    session.view.trouble.watch(soon);
    // Another language, other colors, another size.
    new MutationObserver(() => this.#redraw()).observe(document.documentElement, { attributeFilter: ['lang'] });
    for (const query of [this.#forced, matchMedia('(prefers-color-scheme: dark)')]) {
      query.addEventListener('change', () => this.#redraw());
    }
    const observer = new ResizeObserver(() => this.follow());
    for (const element of document.querySelectorAll(CHANGING)) observer.observe(element);
    session.view.captions.push((context, width, height, pixels) => this.#print(context, width, height, pixels));
    draggable(this.element, {
      begin: ({ button, clientX, clientY }) => {
        const { left, top } = this.element.getBoundingClientRect();
        return button === 0 ? { x: clientX - left, y: clientY - top } : null;
      },
      move: ({ clientX, clientY }, { x, y }) => this.#moveTo(clientX - x, clientY - y),
    });
    this.element.addEventListener('keydown', (event) => this.#key(event));
    this.element.addEventListener('wheel', (event) => session.view.stage.dispatchEvent(new WheelEvent('wheel', event)));
  }

  /** With the next frame: a drag brings more answers than there are frames. */
  #followSoon(): void {
    if (this.#isAwaited) return;
    this.#isAwaited = true;
    requestAnimationFrame(() => {
      this.#isAwaited = false;
      this.follow();
    });
  }

  /** Shows what the picture has now. Styles hold for what is on the page. */
  follow(): void {
    if (!this.element.isConnected) return;
    this.#content = this.#isOn.value ? contentOf(this.#session, this.#isSmall) : null;
    this.element.hidden = this.#content === null;
    if (!this.#content) return;
    const { bar, spacing, scale, axes, north, isCompact, words } = this.#content;
    const drawn = JSON.stringify([bar, bar?.key, spacing, scale, axes, north, isCompact, devicePixelRatio]);
    if (drawn !== this.#drawn) {
      this.#drawn = drawn;
      this.#draw(this.#content);
    }
    const said = String(words);
    if (this.#canvas.getAttribute('aria-label') !== said) attribute(this.#canvas, 'aria-label', words);
    this.#stand();
  }

  get #isSmall(): boolean {
    const { free, stage } = this.#session.view;
    return free < ROOM.width || stage.clientHeight < ROOM.height;
  }

  #redraw(): void {
    this.#drawn = '';
    this.follow();
  }

  #draw(content: Content): void {
    // Drawn by the processor: a canvas of the graphics card waits for it with each answer of a drag.
    const context = this.#canvas.getContext('2d', { willReadFrequently: true });
    if (!context) return;
    const look = this.#look;
    const [width, height] = sizeOf(context, content, look.font);
    this.#canvas.width = Math.ceil(width * devicePixelRatio);
    this.#canvas.height = Math.ceil(height * devicePixelRatio);
    Object.assign(this.#canvas.style, { width: `${width}px`, height: `${height}px` });
    context.scale(devicePixelRatio, devicePixelRatio);
    drawLegend(context, content, look, devicePixelRatio);
  }

  get #look(): Look {
    const { color, backgroundColor, borderTopColor, fontSize, fontFamily } = getComputedStyle(this.element);
    const font = `${fontSize} ${fontFamily}`;
    return { font, text: color, plate: backgroundColor, line: borderTopColor, axes: this.#forced.matches ? {} : AXES };
  }

  /** Where it may be put: where no panel lies over it. */
  get #room(): Box {
    const { centre, free, stage } = this.#session.view;
    const { offsetWidth, offsetHeight } = this.element;
    const left = centre[0] - free / 2;
    const { height } = stage.getBoundingClientRect();
    return { left, top: 0, width: Math.max(0, free - offsetWidth), height: Math.max(0, height - offsetHeight) };
  }

  /** Beside whatever floats there by now. */
  #stand(): void {
    const room = this.#room;
    const wanted = this.#place ? placed(this.#place, room) : this.#standard(room);
    const { offsetWidth, offsetHeight } = this.element;
    const others = [...document.querySelectorAll(OTHERS)].map((other) => other.getBoundingClientRect());
    const taken = others.filter(({ width }) => width > 0);
    const [x, y] = clearOf(wanted, [offsetWidth, offsetHeight], room, taken, APART);
    this.element.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }

  /** At the side on which there are no tools, below what stands at the top. */
  #standard({ left, width, height }: Box): Place {
    if (!narrow()) return [left + GAP, Math.min(BELOW_HEADING, height)];
    const x = left + Math.max(0, width - GAP);
    const { scene, view } = this.#session;
    if (view.stage.clientHeight < ROOM.height) {
      // On a low one the model reaches up to the heading.
      const heading = document.querySelector('.heading')?.getBoundingClientRect();
      return [x, Math.min(heading && heading.right < x - GAP ? GAP : BELOW_HEADING, height)];
    }
    return [x, Math.min(scene.state.compared === null ? BELOW_HINTS : BELOW_SIDES, height)];
  }

  #moveTo(x: number, y: number): void {
    const { left, top, width, height } = this.#room;
    this.#place = [share(x - left, width), share(y - top, height)];
    remember(MEMORY, this.#place.join());
    this.#stand();
  }

  #key(event: KeyboardEvent): void {
    const arrow = arrowOf(event);
    if (!arrow || hasModifier(event)) return;
    event.preventDefault();
    event.stopPropagation();
    const { left, top } = this.element.getBoundingClientRect();
    this.#moveTo(left + NUDGE_PX * arrow[0], top + NUDGE_PX * arrow[1]);
  }

  /** On a picture that is as large, of which `pixels` of the device are one of CSS. */
  #print(context: PlaneContext, width: number, height: number, pixels: number): void {
    this.follow();
    const content = this.#content;
    if (!content) return;
    const [ownWidth, ownHeight] = sizeOf(context, content, this.#look.font);
    // A picture has neither panel nor heading.
    const room = { left: 0, top: 0, width: Math.max(0, width - ownWidth), height: Math.max(0, height - ownHeight) };
    const [x, y] = this.#place ? placed(this.#place, room) : [GAP, GAP];
    context.save();
    context.translate(Math.round(x), Math.round(y));
    drawPlate(context, content, this.#look);
    drawLegend(context, content, this.#look, pixels);
    context.restore();
  }
}

function placed([x, y]: Share, { left, top, width, height }: Box): Place {
  return [left + x * width, top + y * height];
}

function share(part: number, whole: number): number {
  return whole > 0 ? Math.min(1, Math.max(0, part / whole)) : 0;
}

function rememberedPlace(): Share | null {
  const [x, y] = (remembered(MEMORY) ?? '').split(',').map(Number);
  return x !== undefined && y !== undefined && x >= 0 && x <= 1 && y >= 0 && y <= 1 ? [x, y] : null;
}
