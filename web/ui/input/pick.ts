/** What lies under a pointer. */
import type { MeshPoint } from '../../protocol';
import type { Session } from '../../session/session';
import type { Corner } from '../../state/sources';
import { distance } from '../../state/vector';

/** `corner`: of a line along edges, which a drag from there moves; `foot`: from the pointer to what a drag moves, in CSS pixels. */
export type Target =
  | { kind: 'source'; index: number; foot: [number, number] }
  | { kind: 'surface'; point: MeshPoint; corner: Corner | null }
  | { kind: 'empty' };

/** Radius around the foot of a pin, in CSS pixels, within which it can be dragged. */
const GRIP = { mouse: 14, touch: 26 };
/** The same around the ball. */
const SLACK = { mouse: 2, touch: 12 };
/** A pin whose foot lies behind the surface by more than this share of the diameter is hidden. */
const HIDDEN_BY = 0.03;

export function targetAt(session: Session, x: number, y: number, touch: boolean): Target {
  const { sources, sets } = session.scene.state;
  const pointer = touch ? 'touch' : 'mouse';
  const grip = GRIP[pointer];
  const index = nearestOf(session, sources, x, y, grip);
  if (index >= 0) return { kind: 'source', index, foot: [0, 0] };
  const ball = session.view.pinAt(x, y, SLACK[pointer]);
  const foot = ball >= 0 && footOf(session, ball);
  if (foot) return { kind: 'source', index: ball, foot: [foot[0] - x, foot[1] - y] };
  const hit = session.view.pick(x, y);
  if (!hit) return { kind: 'empty' };
  const corners = sets.flatMap((set) =>
    set.shape.kind === 'line' ? set.shape.corners.map((vertex, place): Corner => ({ set, place, vertex })) : [],
  );
  return { kind: 'surface', point: hit.point, corner: corners[nearestOf(session, corners, x, y, grip)] ?? null };
}

function footOf({ scene, shown, view }: Session, index: number): [number, number] | null {
  const source = scene.state.sources[index];
  const place = source && shown.value?.places.at(source);
  return place ? view.project(place.position) : null;
}

/** The index of the place that is nearest to a pixel, of those that are seen within `grip` pixels; −1 for none. */
function nearestOf({ shown, view }: Session, points: readonly MeshPoint[], x: number, y: number, grip: number): number {
  const places = shown.value?.places;
  if (!places) return -1;
  let best = -1;
  let nearest = grip;
  points.forEach((point, index) => {
    const position = places.at(point)?.position;
    const pixel = position && view.project(position);
    if (!position || !pixel) return;
    const away = Math.hypot(pixel[0] - x, pixel[1] - y);
    if (away > nearest) return;
    const hit = view.pick(...pixel);
    if (hit && distance(position, hit.position) > HIDDEN_BY * places.drawnDiameter) return;
    best = index;
    nearest = away;
  });
  return best;
}
