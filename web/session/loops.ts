/** Loops around the handles of the surface: asks for them, and shows them. Loaded when they are first wanted. */
import type { FoundLoops } from '../protocol';
import { rimmed } from '../view/layers';
import { Beside } from './beside';
import { type Asked as OnSurface, isMoving, isSameSurface, surfaceOf } from './exact';
import type { Shown } from './prepare';

const LOOP = { colour: '#ff8a00', width: 3 } as const;

interface Asked extends OnSurface {
  shown: Shown;
}

export class Loops extends Beside<Asked, FoundLoops> {
  protected get wanted(): Asked | null {
    const { engine, shown, scene, pose } = this.session;
    const { value } = shown;
    if (!scene.state.overlays.includes('loops') || !engine || !value || isMoving(this.session)) return null;
    if (value.opened.interior) return null;
    return { engine, question: value.answer.question, moment: pose.value, shown: value };
  }

  protected isSame(one: Asked, other: Asked): boolean {
    return isSameSurface(one, other);
  }

  protected find(asked: Asked): Promise<FoundLoops> {
    return asked.engine.inTurn.handleLoops(surfaceOf(asked.shown.opened, asked));
  }

  protected show(found: FoundLoops | null): void {
    const { view, loops } = this.session;
    view.setEdges('loops', found ? rimmed({ ...LOOP, ends: found.ends }, 0.5) : []);
    loops.value = found;
  }
}
