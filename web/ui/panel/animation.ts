import type { Clip } from '../../protocol';
import type { Session } from '../../session/session';
import { type Animation, SPEEDS } from '../../state/scene';
import { attribute, h, say, select } from '../dom';
import { slider, toggle } from '../widgets';
import { KEYS, withKey } from '../keys';
import { listed, some, t, type Words } from '../../texts';
import { hundredths, tenths } from '../words';

const STEP_SECONDS = 0.01;

/** Which animation of the file is shown, and how; for files that have some. */
export function animationSection(session: Session): HTMLElement {
  const { scene, animator } = session;
  const change = (part: Partial<Animation>) =>
    scene.set({ animation: { ...scene.state.animation, seconds: animator.moment.value?.seconds ?? 0, ...part } });

  const clips = h('select', {
    onchange: () => {
      const clip = clips.selectedIndex - 1;
      change(clip < 0 ? { clip: null, seconds: 0, plays: false } : { clip, seconds: 0 });
    },
  });
  const play = h('button', {
    class: 'small',
    title: withKey(t('Play or stop the animation'), KEYS.play),
    onclick: () => animator.toggle(),
  });
  const time = slider({
    label: t('Time'),
    min: 0,
    max: 1,
    step: STEP_SECONDS,
    describe: (seconds) => t`${hundredths(seconds)} s`,
    change: (seconds) => change({ seconds, plays: false }),
  });
  time.element.classList.add('automatic');
  time.element.querySelector('.value')?.after(play);
  const speed = slider({
    label: t('Speed'),
    min: SPEEDS[0],
    max: SPEEDS[1],
    step: 0.1,
    describe: (value) => t`${tenths(value)} ×`,
    change: (value) => change({ speed: value }),
  });
  const loop = toggle(t('Loop'), (loops) => change({ loops }));
  const measured = select<'file' | 'pose'>(
    t('Distance'),
    [
      ['file', t('Of the pose in the file')],
      ['pose', t('Of each pose, live')],
    ],
    (where) => change({ live: where === 'pose' }),
  );
  const element = h(
    'div',
    { class: 'stack' },
    h('label', { class: 'field' }, h('span', {}, t('Animation')), clips),
    time.element,
    speed.element,
    loop.element,
    measured.element,
  );

  const fill = (choices: readonly Clip[]) => {
    clips.replaceChildren(
      h('option', {}, t('None, as in the file')),
      ...choices.map((clip) => h('option', {}, described(clip))),
    );
  };
  const show = ({ clip, plays, speed: times, loops, live }: Animation) => {
    clips.selectedIndex = (clip ?? -1) + 1;
    say(play, plays ? t('Stop') : t('Play'));
    attribute(play, 'aria-label', plays ? t('Stop the animation') : t('Play the animation'));
    play.disabled = clip === null;
    const input = time.element.querySelector('input');
    if (input) {
      input.max = String(Math.max(STEP_SECONDS, animator.duration));
      input.disabled = clip === null;
    }
    time.show(animator.moment.value?.seconds ?? 0);
    speed.show(times);
    loop.show(loops);
    measured.show(live ? 'pose' : 'file');
  };
  session.shown.watch((shown, previous) => {
    if (shown?.opened === previous?.opened && shown) return;
    fill(shown?.opened.clips ?? []);
    show(scene.state.animation);
  });
  scene.subscribe(({ animation }, { animation: before }) => {
    if (animation !== before) show(animation);
  });
  animator.moment.watch((moment) => time.show(moment?.seconds ?? 0));
  return element;
}

/** Name and length; channels that change something else than the shape, or are damaged, move nothing. */
function described({ name, seconds, leftOut }: Clip): Words {
  return listed(
    name,
    t`${hundredths(seconds)} s`,
    some(leftOut, 'without {0} of its channels', 'without {0} of its channels'),
  );
}
