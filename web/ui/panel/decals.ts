/** Images on the surface: a list of them, what adds and changes them, and a file. */
import { layFiles, layImage } from '../../session/laying';
import type { Session } from '../../session/session';
import { DECAL_IMAGES, type Decal, type DecalImage } from '../../state/decals';
import { type ModelLength, ofModel, unitOf } from '../../length';
import { measure } from '../../state/measures';
import { save } from '../../view/picture';
import { h, say, select } from '../dom';
import { slider } from '../widgets';
import { fileNameOf } from '../words';
import { t, type Words } from '../../texts';

const IMAGE_WORDS: Record<DecalImage, Words> = {
  compass: t('Compass'),
  polar: t('Polar rings'),
  grid: t('Grid'),
  star: t('Star'),
};
/** Sizes as shares of the diameter. */
const [LEAST, MOST] = [0.005, 1] as const;
/** Steps of the slider, between sizes of equal ratios. */
const STEPS = 200;

export function decalsSection(session: Session): HTMLElement {
  const { scene, shown, decal: selected, decals: lying } = session;
  const list = h('ul', { class: 'sources' });
  const trouble = h('p', { class: 'quiet', role: 'status' });
  const attempt = (work: () => void | Promise<void>) => () =>
    void Promise.resolve()
      .then(work)
      .catch((error: unknown) => session.fail(error));
  let kind: DecalImage = DECAL_IMAGES[0];
  const kinds = select(
    t('Image'),
    DECAL_IMAGES.map((name) => [name, IMAGE_WORDS[name]] as const),
    (name) => (kind = name),
  );
  const input = h('input', { type: 'file', hidden: true, accept: 'image/*', 'aria-label': t('Image file') });
  input.addEventListener(
    'change',
    attempt(async () => {
      const [file] = input.files ?? [];
      input.value = '';
      if (file) await layFiles(session, [{ path: file.name, content: file }]);
    }),
  );
  const lay = h(
    'button',
    {
      class: 'small',
      title: t('Lays the image on the model, in the middle of what is seen'),
      onclick: attempt(() => layImage(session, kind)),
    },
    t('Lay on'),
  );
  const choose = h(
    'button',
    {
      class: 'small',
      title: t('An image of your own; one can be dropped on the model, too'),
      onclick: () => input.click(),
    },
    t('Image file…'),
  );
  const keep = h(
    'button',
    {
      class: 'wide',
      title: t('The images with the parts of the surface that they cover, with texture coordinates'),
      onclick: attempt(async () => {
        const { decalsGlb } = await import('../../session/decalfile');
        const { value } = shown;
        if (value) save(new Blob([await decalsGlb(session, value)]), `${fileNameOf(value)}.decals.glb`);
      }),
    },
    t('Save images as GLB'),
  );
  const editor = editorOf(session);
  const show = () => {
    const { decals } = scene.state;
    const isBarred = shown.value !== null && shown.value.opened.interior !== null;
    say(trouble, isBarred ? t('Images are on surfaces alone.') : null);
    for (const control of [lay, choose]) control.disabled = isBarred;
    keep.hidden = decals.length === 0;
    if (selected.value >= decals.length) selected.value = -1;
    list.replaceChildren(...decals.map((one, index) => rowOf(session, one, index)));
    editor.show();
  };
  scene.subscribe((state, previous) => {
    if (
      state.decals.length !== previous.decals.length ||
      state.decals.some(({ image }, k) => image !== previous.decals[k]?.image)
    )
      show();
    else if (state.decals !== previous.decals) editor.show();
  });
  selected.watch(show);
  lying.watch((laid) => (keep.disabled = laid.length === 0));
  shown.watch((value, previous) => {
    if (value?.opened !== previous?.opened) show();
  });
  show();
  const adding = h('div', { class: 'linking' }, lay, choose);
  return h('div', { class: 'stack' }, kinds.element, adding, input, trouble, list, editor.element, keep);
}

function nameOf(image: string): Words {
  const own = DECAL_IMAGES.find((name) => name === image);
  return own ? IMAGE_WORDS[own] : t('Image file');
}

function rowOf(session: Session, { image }: Decal, index: number): HTMLElement {
  const { scene, decal: selected } = session;
  const name = h(
    'button',
    {
      class: 'source-name',
      title: t('Select; its handles move, turn and scale it'),
      onclick: () => (selected.value = selected.value === index ? -1 : index),
    },
    nameOf(image),
  );
  name.setAttribute('aria-pressed', String(selected.value === index));
  const remove = h(
    'button',
    {
      class: 'small',
      title: t('Delete this image'),
      'aria-label': t`Delete image ${index + 1}`,
      onclick: () => scene.edit({ decals: scene.state.decals.toSpliced(index, 1) }),
    },
    '×',
  );
  return h('li', {}, name, remove);
}

/** Size and angle of the image that is selected. */
function editorOf(session: Session): { element: HTMLElement; show: () => void } {
  const { scene, shown, decal: selected } = session;
  const change = (part: Partial<Decal>, gesture: object) => {
    const { decals } = scene.state;
    const decal = decals[selected.value];
    if (decal) scene.edit({ decals: decals.with(selected.value, { ...decal, ...part }) }, gesture);
  };
  const diameter = () => shown.value?.places.diameter ?? 1;
  const sizeAt = (step: number): ModelLength => ofModel(LEAST * (MOST / LEAST) ** (step / STEPS) * diameter());
  const stepOf = (size: number) => (STEPS * Math.log(size / diameter() / LEAST)) / Math.log(MOST / LEAST);
  const size = slider({
    label: t('Size'),
    min: 0,
    max: STEPS,
    step: 1,
    describe: (step) => (shown.value ? measure(sizeAt(step), unitOf(scene.state, shown.value.opened)) : ''),
    change: (step, gesture) => change({ size: sizeAt(step) }, gesture),
  });
  const angle = slider({
    label: t('Angle'),
    min: -180,
    max: 180,
    step: 1,
    describe: (value) => `${Math.round(value)}°`,
    change: (value, gesture) => change({ angle: value }, gesture),
  });
  const element = h('div', { class: 'stack' }, size.element, angle.element);
  return {
    element,
    show: () => {
      const decal = scene.state.decals[selected.value];
      element.hidden = !decal;
      if (!decal) return;
      size.show(Math.min(STEPS, Math.max(0, stepOf(decal.size))));
      angle.show(decal.angle);
    },
  };
}
