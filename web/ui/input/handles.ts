/** What is taken hold of on the model: the plane that cuts tetrahedra, the corners of a line. Loaded after the first picture. */
import type { Session } from '../../session/session';
import { CutHandle, cutOf } from '../cut';
import { LineCorners } from './corners';
import type { DrawInput } from './draw';
import { keepFocus } from './focus';

export interface Handles {
  /** Goes to where the model is seen now. */
  follow(): void;
}

/** Puts them over the stage, which has the focus from then on where nothing else has. */
export function handlesOf(session: Session, draw: DrawInput): Handles {
  const { stage } = session.view;
  const [cut, corners] = [new CutHandle(session, cutOf(session)), new LineCorners(session, draw)];
  stage.after(cut.element, corners.element);
  keepFocus(stage);
  return {
    follow: () => {
      cut.follow();
      corners.follow();
    },
  };
}
