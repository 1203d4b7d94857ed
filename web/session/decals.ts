/** Images on the surface: asks how each lies, and shows them. Loaded with the first one. */
import type { DecalWish, LaidDecal, Moment, OpenedMesh } from '../protocol';
import type { Engine } from '../solver/engine';
import { Cancelled, WorkerLost } from '../solver/remote';
import type { Decal, LaidImage } from '../state/decals';
import { rightAt } from '../state/decalframe';
import type { Places } from '../state/places';
import type { Patches } from '../view/layers';
import { decalImage } from '../view/decalimages';
import { laidImage } from '../view/decals';
import { layPatches, together } from '../view/patches';
import { isMoving, placesOf, surfaceOf } from './exact';
import { imageFile } from './images';
import type { Shown } from './prepare';
import type { Session } from './session';

export class Decals {
  readonly #session: Session;
  /** What was laid last, of each in the scene's order. */
  #laid: (Laid | undefined)[] = [];
  #latest: Promise<void> | null = null;
  /** The pose that they are laid in. */
  #moment: Moment | null = null;
  /** What the view shows. */
  #shown: unknown[] = [];

  constructor(session: Session) {
    this.#session = session;
  }

  /** Shows what the scene wants by now. Resolves when it is shown. */
  follow(): Promise<void> {
    this.#show();
    this.#latest ??= this.#work().finally(() => (this.#latest = null));
    return this.#latest;
  }

  /** Lays one after the other until all lie as the scene wants it by then. */
  async #work(): Promise<void> {
    for (;;) {
      const basis = this.#basis;
      if (!basis) return;
      const { decals, surface } = basis;
      const index = decals.findIndex((decal, at) => !isLaid(this.#laid[at], decal, surface.surface));
      const decal = decals[index];
      if (!decal) return;
      try {
        const image = await decalImage(decal.image, imageFile);
        const laid = await basis.engine.inTurn.decal(wishOf(basis, decal, image));
        if (laid) this.#laid[index] = { decal, image, laid, surface: surface.surface };
      } catch (error) {
        if (error instanceof Cancelled || error instanceof WorkerLost) return;
        this.#session.fail(error);
        // What cannot be laid is not asked for again until it is changed.
        this.#laid[index] = { decal, image: null, laid: null, surface: surface.surface };
      }
      this.#show();
    }
  }

  /** What images lie on now; null: on nothing. */
  get #basis(): Basis | null {
    const { engine, shown, scene, pose } = this.#session;
    const { value } = shown;
    if (!engine || !value || value.opened.interior || engine.opened !== value.opened) return null;
    const { opened, places, answer } = value;
    const { question } = answer;
    // While the model moves, images move along as they lie.
    const moment = isMoving(this.#session) ? this.#moment : pose.value;
    this.#moment = moment;
    const surface = surfaceOf(opened, { engine, question, moment });
    return { engine, opened, places, surface, decals: scene.state.decals };
  }

  /** Those that lie on the surface now; one that is dragged lies where it was. */
  get #lying(): LaidImage[] {
    const basis = this.#basis;
    const { decals = [], surface } = basis ?? {};
    return decals.flatMap((_, index) => {
      const laid = this.#laid[index];
      if (!laid?.laid || laid.surface !== surface?.surface) return [];
      return { index, decal: laid.decal, image: laid.image, laid: laid.laid };
    });
  }

  #show(): void {
    const { view, shown, scene, decals } = this.#session;
    this.#laid.length = Math.min(this.#laid.length, scene.state.decals.length);
    const lying = this.#lying;
    const state = [shown.value?.opened, shown.value?.places.drawn, ...lying.map(({ laid }) => laid)];
    if (state.length === this.#shown.length && state.every((part, index) => part === this.#shown[index])) return;
    this.#shown = state;
    layPatches(view, 'decals', shown.value && patchesOf(shown.value, lying));
    decals.value = lying;
  }
}

type Laid = { decal: Decal; surface: number } & ({ image: ImageBitmap; laid: LaidDecal } | { image: null; laid: null });

interface Basis {
  engine: Engine;
  opened: OpenedMesh;
  places: Places;
  surface: ReturnType<typeof surfaceOf>;
  decals: readonly Decal[];
}

function isLaid(laid: Laid | undefined, decal: Decal, surface: number): boolean {
  return laid?.decal === decal && laid.surface === surface;
}

function wishOf({ opened, places, surface }: Basis, { place, size, angle }: Decal, image: ImageBitmap): DecalWish {
  const { width, height } = image;
  const longer = Math.max(width, height);
  return {
    ...surface,
    place: placesOf(opened, [place]),
    half: [(size * width) / longer, (size * height) / longer],
    right: rightAt(places.at(place)?.normal ?? [0, 0, 1], angle),
  };
}

function patchesOf({ opened, places }: Shown, lying: readonly LaidImage[]): Patches | null {
  if (lying.length === 0) return null;
  const isOpen = opened.report.boundaryLoops > 0;
  const of = ({ image, laid }: LaidImage, index: number) =>
    laidImage(opened.surface, places.drawn, laid, image, index, places.drawnDiameter, isOpen);
  return lying.map(of).reduce(together);
}
