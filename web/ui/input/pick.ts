/** What lies under a pointer. */
import type { MeshPoint } from '../../protocol';
import type { Session } from '../../session/session';

export type Target = { kind: 'source'; index: number } | { kind: 'surface'; point: MeshPoint } | { kind: 'empty' };

/** Radius around the foot of a pin, in CSS pixels, within which it can be dragged. */
const GRIP = { mouse: 14, touch: 26 };
/** A pin whose foot lies behind the surface by more than this share of the diameter is hidden. */
const HIDDEN_BY = 0.03;

export function targetAt(session: Session, x: number, y: number, touch: boolean): Target {
  const index = sourceAt(session, x, y, touch ? GRIP.touch : GRIP.mouse);
  if (index >= 0) return { kind: 'source', index };
  const hit = session.view.pick(x, y);
  return hit ? { kind: 'surface', point: hit.point } : { kind: 'empty' };
}

function sourceAt({ scene, shown, view }: Session, x: number, y: number, grip: number): number {
  const places = shown.value?.places;
  if (!places) return -1;
  let best = -1;
  let nearest = grip;
  scene.state.sources.forEach((source, index) => {
    const position = places.at(source)?.position;
    const pixel = position && view.project(position);
    if (!position || !pixel) return;
    const away = Math.hypot(pixel[0] - x, pixel[1] - y);
    if (away > nearest) return;
    const hit = view.pick(...pixel);
    if (hit && Math.hypot(...position.map((p, i) => p - hit.position[i])) > HIDDEN_BY * places.drawnDiameter) return;
    best = index;
    nearest = away;
  });
  return best;
}
