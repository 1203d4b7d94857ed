/** The girth: curves in which a plane cuts the surface, their lengths on the stage and in the panel, and files of them. */
import '../../style/tapes.css';
import { Failure, sentenceOf } from '../../error';
import { type LengthUnit, isSameUnit, MODEL, ofModel, unitOf, unitOfFile } from '../../length';
import type { GirthFile } from '../../protocol';
import { Girths, type Loop } from '../../session/girth';
import type { Session } from '../../session/session';
import { LEVEL_GIRTH } from '../../state/girth';
import { anglesOf, type CutPlane, INSIDE_RANGES } from '../../state/inside';
import { measure } from '../../state/measures';
import { counted, sentences, t, type Words } from '../../texts';
import { rimmed } from '../../view/layers';
import { save } from '../../view/picture';
import { attribute, h, say, select } from '../dom';
import { slider, toggle } from '../widgets';
import { CutHandle } from '../cut';
import { fileNameOf, percent } from '../words';
import { labelElement, stand, standing } from './standing';

/** The girth, and other curves of the plane; widths in CSS pixels. */
const GIRTH = { colour: '#ff4fd8', width: 2.5 };
const OTHERS = { colour: '#ffb3ee', width: 1.6 };
/** A drag or a key that repeats comes back within; milliseconds. */
const REST_MS = 700;

const FILES: readonly (readonly [GirthFile, Words])[] = [
  ['dxf', 'DXF'],
  ['obj', 'OBJ'],
  ['csv', 'CSV'],
  ['glb', 'GLB'],
];

export class GirthTool {
  readonly section: HTMLElement;
  /** Over the stage. */
  readonly element: HTMLElement;
  readonly #session: Session;
  readonly #girths: Girths;
  readonly #handle: CutHandle;
  readonly #label = labelElement('girth-label', '');
  readonly #spoken = h('p', { class: 'unseen', 'aria-live': 'polite' });
  readonly #figures = h('p', { class: 'girth-figures' });
  #speaking: ReturnType<typeof setTimeout> | undefined;
  #hasLines = false;

  constructor(session: Session) {
    this.#session = session;
    this.#girths = new Girths(session);
    this.#handle = new CutHandle(session, {
      label: t('Position of the girth'),
      plane: () => (session.shown.value?.opened.interior ? null : session.scene.state.girth),
      put: (place, gesture) => this.#change({ place }, gesture),
    });
    this.element = h(
      'section',
      { 'aria-label': t('Girth') },
      h('div', { class: 'tapes' }, this.#label),
      this.#handle.element,
      this.#spoken,
    );
    this.section = this.#controls();
    standing(session).add({ labels: () => [this.#label], taken: () => [] });
    session.view.overprints.push((context) => {
      if (!this.#label.hidden) standing(session).print(context, [this.#label]);
    });
    this.#girths.loops.watch(() => this.#show());
    session.scene.subscribe((state, previous) => {
      if (!isSameUnit(state, previous)) this.#show();
    });
    this.#show();
  }

  settled(): Promise<void> {
    return this.#girths.settled();
  }

  /** Goes to where everything is seen now: what is said of the girth stands right of it. */
  follow(): void {
    this.#handle.follow();
    const [girth] = this.#girths.loops.value ?? [];
    const pixels = (girth?.points ?? [])
      .map((point) => this.#session.view.project(point))
      .filter((pixel) => pixel !== null);
    const right = pixels.reduce((one, other) => (other[0] > one[0] ? other : one), pixels[0] ?? [0, 0]);
    this.#label.hidden = pixels.length === 0;
    stand(this.#label, right);
    standing(this.#session).place();
  }

  #change(part: Partial<CutPlane>, gesture: object): void {
    const { scene } = this.#session;
    if (scene.state.girth) scene.edit({ girth: { ...scene.state.girth, ...part } }, gesture);
  }

  get #unit(): LengthUnit {
    const { scene, shown } = this.#session;
    return shown.value ? unitOf(scene.state, shown.value.opened) : MODEL;
  }

  #show(): void {
    const loops = this.#girths.loops.value ?? [];
    const unit = this.#unit;
    const [girth, ...others] = loops.map(({ points }) => segmentsOf(points));
    if (girth || this.#hasLines) {
      const rest = Float32Array.from(others.flat());
      const ends = Float32Array.from(girth ?? []);
      const lines = [...rimmed({ ends: rest, ...OTHERS }), ...rimmed({ ends, ...GIRTH })];
      this.#session.view.setEdges('girth', girth ? lines.filter((line) => line.ends.length > 0) : []);
      this.#hasLines = girth !== undefined;
    }
    const [first] = loops;
    const span = this.#label.firstElementChild as HTMLElement;
    say(span, first ? measure(first.length, { ...unit, assumed: false }) : '');
    const words = this.#girths.loops.value && figuresOf(loops, unit);
    say(this.#figures, words ?? '');
    clearTimeout(this.#speaking);
    this.#speaking = setTimeout(() => say(this.#spoken, words ?? ''), REST_MS);
    this.follow();
  }

  #controls(): HTMLElement {
    const { scene, shown, view } = this.#session;
    const isOn = toggle(t('Measure the girth'), (on) => scene.edit({ girth: on ? LEVEL_GIRTH : null }));
    attribute(isOn.element, 'title', t('Cuts the surface by a plane and measures the curves of the cut'));
    const number = (name: keyof CutPlane, label: Words, step: number, describe: (value: number) => Words) => {
      const [min, max] = INSIDE_RANGES[name];
      const change = (value: number, gesture: object) => this.#change({ [name]: value }, gesture);
      return [name, slider({ label, min, max, step, describe, change })] as const;
    };
    const sliders = [
      number('place', t('Position'), 0.01, (value) => (value === 0 ? t('middle') : percent(value))),
      number('turn', t('Turn'), 1, (value) => `${value}°`),
      number('tilt', t('Tilt'), 1, (value) => `${value}°`),
    ];
    const level = () => this.#change({ turn: 0, tilt: 90 }, {});
    const face = () => {
      const [yaw = 0, pitch = 0] = view.camera ?? [];
      this.#change(anglesOf([Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)]), {});
    };
    const said = h('p', { class: 'quiet', role: 'status' });
    let kind: GirthFile = 'dxf';
    const file = select(t('Girth file'), FILES, (value) => (kind = value));
    const saveFile = () => {
      say(said, '');
      this.#save(kind).catch((error: unknown) => say(said, sentenceOf(error)));
    };
    const settings = h(
      'div',
      { class: 'stack' },
      ...sliders.map(([, { element }]) => element),
      h(
        'div',
        { class: 'linking' },
        h('button', { class: 'small', title: t('Makes the plane level'), onclick: level }, t('Level')),
        h(
          'button',
          { class: 'small', title: t('Turns the plane towards the camera'), onclick: face },
          t('Across the view'),
        ),
      ),
      this.#figures,
      file.element,
      h('button', { class: 'wide', title: t('Saves all curves of the cut'), onclick: saveFile }, t('Save girth')),
      said,
    );
    const inside = t('This is for surfaces, not for the inside of tetrahedra.');
    const show = () => {
      const { girth } = scene.state;
      const isInside = shown.value?.opened.interior !== null && shown.value !== null;
      isOn.bar(isInside ? inside : null);
      isOn.show(girth !== null);
      settings.hidden = girth === null || isInside;
      if (girth) for (const [name, control] of sliders) control.show(girth[name]);
    };
    scene.subscribe((state, previous) => {
      if (state.girth !== previous.girth) show();
    });
    shown.watch(show);
    show();
    return h('div', { class: 'stack' }, isOn.element, settings);
  }

  async #save(kind: GirthFile): Promise<void> {
    const { plane } = this.#girths;
    const { engine, shown } = this.#session;
    if (!plane || !engine || this.#girths.loops.value?.length === 0)
      throw new Failure(t('The plane cuts nothing. Move it.'));
    const bytes = await engine.queries.girthFile(plane, kind, unitOfFile(kind, this.#unit));
    save(new Blob([bytes]), `${fileNameOf(shown.value)}.girth.${kind}`);
  }
}

function segmentsOf(points: Loop['points']): number[] {
  return points.slice(1).flatMap((point, index) => (points[index] ?? point).concat(point));
}

/** The girth, and what else the plane cuts. */
function figuresOf(loops: readonly Loop[], unit: LengthUnit): Words {
  const [girth] = loops;
  if (!girth) return t('The plane cuts nothing. Move it.');
  const length = measure(girth.length, unit);
  const all = ofModel(loops.reduce((sum, loop) => sum + loop.length, 0));
  return sentences(
    girth.closed ? t`Girth: ${length}.` : t`Girth: ${length}, of an open curve.`,
    loops.length > 1
      ? counted(
          loops.length,
          '{0} curve, {1} in all.',
          '{0} curves, {1} in all; the longest is the girth.',
          measure(all, unit),
        )
      : null,
  );
}
