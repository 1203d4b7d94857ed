/** Curves of paths on the surface: a switch for each kind, their lengths, and files of them. */
import { isSameUnit, MODEL, unitOf } from '../../length';
import type { PathCurves } from '../../protocol';
import { LEAST } from '../../session/paths';
import type { Session } from '../../session/session';
import { measure } from '../../state/measures';
import { h, say } from '../dom';
import { overlaySwitch } from './overlay';
import { savingCurves } from './saving';
import { counted, enumerated, sentences, t, type Words } from '../../texts';

/** Lengths that are told; all are in files. */
const MOST_TOLD = 12;

interface Kind {
  kind: PathCurves;
  name: Words;
  title: Words;
  /** Of the choice of files, of the button that saves one, and what that says. */
  label: Words;
  button: Words;
  saves: Words;
  tooFew: Words | null;
  tell: (lengths: readonly Words[]) => Words;
}

const KINDS: readonly Kind[] = [
  {
    kind: 'loops',
    name: t('Loops around handles'),
    title: t('Closed curves that cannot shrink to a point, as short as they can be'),
    label: t('Loops'),
    button: t('Save loops'),
    saves: t('The loops around handles as curves'),
    tooFew: null,
    tell: (lengths) =>
      lengths.length > 0
        ? sentences(
            counted(lengths.length, '{0} loop.', '{0} loops.'),
            t`The shortest: ${enumerated(lengths.slice(0, MOST_TOLD))}.`,
          )
        : t('The surface has no handle: all closed curves shrink to points.'),
  },
  {
    kind: 'loop',
    name: t('Loop through the sources'),
    title: t(
      'A closed curve of shortest paths through the sources in their order; through one or two, one that cannot shrink',
    ),
    label: t('Loop'),
    button: t('Save the loop'),
    saves: t('The loop through the sources as a curve'),
    tooFew: t('A loop is through one source or more.'),
    tell: ([length]) =>
      length === undefined
        ? t('This loop shrinks to a point: place sources on the way around a handle or a hole, or three and more.')
        : t`The loop is ${length} long.`,
  },
  {
    kind: 'bezier',
    name: t('Bézier curve of the sources'),
    title: t('A smooth curve from the first source to the last, which those between draw toward them'),
    label: t('Curve'),
    button: t('Save the curve'),
    saves: t('The Bézier curve as a curve on the surface'),
    tooFew: t('A Bézier curve is of two sources or more.'),
    tell: ([length = '']) => t`The curve is ${length} long.`,
  },
];

export function pathsControls(session: Session): HTMLElement {
  return h('div', { class: 'stack' }, ...KINDS.map((kind) => controlsOf(session, kind)));
}

function controlsOf(session: Session, { kind, name, title, label, button, saves, tooFew, tell }: Kind): HTMLElement {
  const { scene, shown, paths } = session;
  const on = overlaySwitch(session, kind, name, title);
  const lengths = h('p', { class: 'quiet', role: 'status' });
  const saving = savingCurves(session, {
    label,
    button,
    title: saves,
    suffix: kind,
    file: (engine, file) => engine.queries.pathFile(kind, file),
  });
  const show = () => {
    const { overlays, sources } = scene.state;
    on.show(overlays.includes(kind));
    const isInside = shown.value?.opened.interior;
    on.bar(isInside ? t('Loops and curves are on surfaces alone.') : sources.length < LEAST[kind] ? tooFew : null);
    const { value: found } = paths[kind];
    saving.hidden = !found || found.lengths.length === 0;
    lengths.hidden = !found;
    if (!found) return;
    const unit = shown.value ? unitOf(scene.state, shown.value.opened) : MODEL;
    say(lengths, tell(found.lengths.map((length) => measure(length, unit))));
  };
  paths[kind].watch(show);
  shown.watch(show);
  scene.subscribe((state, previous) => {
    const isOther = state.overlays !== previous.overlays || state.sources !== previous.sources;
    if (isOther || !isSameUnit(state, previous)) show();
  });
  show();
  return h('div', { class: 'stack' }, on.element, lengths, saving);
}
