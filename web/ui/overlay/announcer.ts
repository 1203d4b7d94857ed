/** Tells screen readers what is shown once it has come to rest: how exact distances are, how far they reach, how long the path is. */
import type { Session } from '../../session/session';
import { isSameUnit, unitOf } from '../../length';
import { refiningSentence } from '../accuracy';
import { h, say } from '../dom';
import { hasCosts } from '../../state/ground';
import { measure } from '../../state/measures';
import { sentences, t, type Words } from '../../texts';

/** A drag or a key that repeats comes back within. */
const REST_MS = 700;

export function announcer(session: Session): HTMLElement {
  const element = h('p', { class: 'unseen', 'aria-live': 'polite' });
  let timer: ReturnType<typeof setTimeout> | undefined;
  /** Whether a step was taken back, or done again, since the last sentence. */
  let travelled: Words | null = null;
  const tell = () => {
    if (!session.settled || session.dragging) return;
    say(element, sentences(travelled, announcement(session)));
    travelled = null;
  };
  const wait = () => {
    clearTimeout(timer);
    timer = setTimeout(tell, REST_MS);
  };
  session.shown.watch(wait);
  session.refiner.phase.watch(wait);
  session.scene.subscribe((state, previous) => {
    const { travelled: way } = session.scene;
    if (way) travelled = way === 'back' ? t('Undone.') : t('Redone.');
    if (way || !isSameUnit(state, previous)) wait();
  });
  return element;
}

function announcement({ scene, shown, refiner }: Session): Words {
  const { opened, answer } = shown.value ?? {};
  if (!opened || !answer?.field) return '';
  const unit = unitOf(scene.state, opened);
  const { path } = answer;
  const isCost = hasCosts(answer.question.ground);
  return sentences(
    refiningSentence(refiner.phase.value, answer.field, scene.state, unit),
    isCost
      ? t`Greatest cost ${measure(answer.field.maxDistance, unit)}.`
      : t`Maximum distance ${measure(answer.field.maxDistance, unit)}.`,
    path ? t`Path ${measure(path.length, unit)}.` : null,
    path && isCost ? t`Its cost ${measure(path.cost, unit)}.` : null,
  );
}
