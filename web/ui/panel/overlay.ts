/** The switch of an overlay that has a section of its own. */
import type { Session } from '../../session/session';
import type { Overlay } from '../../state/scene';
import { attribute } from '../dom';
import { toggle } from '../widgets';
import type { Words } from '../../texts';

export function overlaySwitch(
  { scene }: Session,
  overlay: Overlay,
  name: Words,
  title: Words,
): ReturnType<typeof toggle> {
  const made = toggle(name, (isOn) => {
    const others = scene.state.overlays.filter((one) => one !== overlay);
    scene.edit({ overlays: isOn ? [...others, overlay] : others });
  });
  attribute(made.element, 'title', title);
  return made;
}
