/** What is taken hold of on the model: the plane that cuts tetrahedra, the corners of a line, images. Loaded after the first picture. */
import type { Session } from '../../session/session';
import { CutHandle, cutOf } from '../cut';
import { LineCorners } from './corners';
import { DecalHandles } from './decals';
import type { DrawInput } from './draw';
import { keepFocus } from './focus';

export interface Handles {
  /** Goes to where the model is seen now. */
  follow(): void;
}

/** Puts them over the stage, which has the focus from then on where nothing else has. */
export function handlesOf(session: Session, draw: DrawInput): Handles {
  const { stage } = session.view;
  const cut = new CutHandle(session, cutOf(session));
  const [corners, decals] = [new LineCorners(session, draw), new DecalHandles(session)];
  stage.after(cut.element, corners.element, decals.element);
  keepFocus(stage);
  return {
    follow: () => {
      cut.follow();
      corners.follow();
      decals.follow();
    },
  };
}
