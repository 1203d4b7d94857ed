/** The legend, and the handles on the model: of the plane that cuts tetrahedra, of the corners of a line. */
import type { Session } from '../../session/session';
import type { Signal } from '../../state/signal';
import { CutHandle, cutOf } from '../cut';
import { LineCorners } from '../input/corners';
import type { DrawInput } from '../input/draw';
import { keepFocus } from '../input/focus';
import { Legend } from './legend';

export interface Over {
  /** Goes to where the model is seen now. */
  follow(): void;
}

/** Puts all of it over the stage, which has the focus from then on where nothing else has. */
export function over(session: Session, legend: Signal<boolean>, draw: DrawInput): Over {
  const parts = [new Legend(session, legend), new CutHandle(session, cutOf(session)), new LineCorners(session, draw)];
  keepFocus(session.view.stage);
  session.view.stage.after(...parts.map(({ element }) => element));
  return {
    follow: () => {
      for (const part of parts) part.follow();
    },
  };
}
