/** The isolines that the scene wants. */
import type { IsolineWish } from '../protocol';
import { ofModel, type ModelLength } from '../length';
import { wholeOfDistance } from './period';
import type { Session } from './session';

/** The spacing of isolines that lie where the stripes do. */
function stripeSpacing({ scene, shown }: Session): ModelLength {
  return ofModel(scene.state.style.period * (shown.value ? wholeOfDistance(shown.value) : 0));
}

/** The isolines that are wanted; where nothing else is said, at the stripes. */
export function isolineWish(session: Session): IsolineWish {
  return session.scene.state.isolines ?? { values: [], spacing: stripeSpacing(session) };
}

/** The same where there are some to draw; null where there is none, or no surface. */
export function drawnIsolines(session: Session): IsolineWish | null {
  const { opened, answer } = session.shown.value ?? {};
  const wish = isolineWish(session);
  const most = answer?.field?.maxDistance ?? 0;
  const isThere = wish.values.some((value) => value < most) || (wish.spacing > 0 && wish.spacing < most);
  return isThere && !opened?.interior ? wish : null;
}
