/** A place for what floats, where nothing else does. */

/** Left and top, CSS pixels. */
export type Place = readonly [number, number];

/** An area: of the places that there may be, or of what is in the way. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/**
 * The place nearest to a wanted one at which what is `width` × `height` large stays `gap` away from all that is in the way; where
 * there is none, the wanted one. `room`: where its left upper corner may be.
 */
export function clearOf(
  wanted: Place,
  [width, height]: readonly [number, number],
  room: Box,
  others: readonly Box[],
  gap: number,
): Place {
  const covers = ([x, y]: Place, { left, top, width: across, height: down }: Box) =>
    x < left + across + gap && x + width + gap > left && y < top + down + gap && y + height + gap > top;
  const isClear = (place: Place) => !others.some((other) => covers(place, other));
  const start = [within(wanted[0], room.left, room.width), within(wanted[1], room.top, room.height)] as const;
  if (isClear(start)) return start;
  const xs = others.flatMap((other) => [other.left - gap - width, other.left + other.width + gap]);
  const ys = others.flatMap((other) => [other.top - gap - height, other.top + other.height + gap]);
  const places = beside(start[0], room.left, room.width, xs).flatMap((x) =>
    beside(start[1], room.top, room.height, ys).map((y) => [x, y] as const),
  );
  const away = ([x, y]: Place) => Math.hypot(x - start[0], y - start[1]);
  return (
    places
      .filter(isClear)
      .reduce<Place | null>((best, place) => (best && away(best) <= away(place) ? best : place), null) ?? start
  );
}

/** A coordinate, and what of others is in the room too. */
function beside(value: number, from: number, extent: number, sides: readonly number[]): number[] {
  return [value, ...sides.filter((side) => side >= from && side <= from + extent)];
}

function within(value: number, from: number, extent: number): number {
  return Math.min(from + extent, Math.max(from, value));
}
