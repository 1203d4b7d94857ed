/** Sets of sources as they are drawn: curves, and dots where their places are in no order. */
import type { Places } from '../state/places';
import { distance, moved, normalized, type Vector } from '../state/vector';
import { isClosed, isCurve, type SourceSet } from '../state/sources';
import type { Edges } from '../view/layers';

/** As pins are, and the one that is selected. */
const COLOURS = { set: '#2fbf12', selected: '#b4ff38' } as const;
const WIDTHS = { curve: 4, dot: 6 } as const;
/** Length of a dot as a share of the diameter: it lies flat on the surface and is seen by its width. */
const DOT = 0.003;
/** Places of a curve farther apart than this share of the diameter are not joined: the pen was lifted there. */
const GAP = 0.05;

/** The sets on a mesh; the one that is selected last, over the others. */
export function curvesOf(sets: readonly SourceSet[], selected: SourceSet | undefined, places: Places): Edges[] {
  const others = sets.filter((set) => set !== selected);
  return [...drawn(others, COLOURS.set, places), ...drawn(selected ? [selected] : [], COLOURS.selected, places)];
}

function drawn(sets: readonly SourceSet[], colour: string, places: Places): Edges[] {
  const curves = sets.filter(isCurve).flatMap((set) => segments(set, places));
  const dots = sets.filter((set) => !isCurve(set)).flatMap((set) => marks(set, places));
  return [
    { ends: Float32Array.from(curves), colour, width: WIDTHS.curve },
    { ends: Float32Array.from(dots), colour, width: WIDTHS.dot },
  ].filter(({ ends }) => ends.length > 0);
}

function segments(set: SourceSet, places: Places): number[] {
  const corners = set.points.map((point) => places.at(point)?.position);
  if (isClosed(set)) corners.push(corners[0]);
  const longest = longestStep(set, places);
  const ends: number[] = [];
  corners.forEach((end, i) => {
    const start = corners[i - 1];
    if (start && end && distance(start, end) < longest) ends.push(...start, ...end);
  });
  return ends;
}

/** As it is drawn, from one place to the next; those farther apart are not joined. */
export function longestStep({ shape }: SourceSet, places: Places): number {
  return shape.kind === 'stroke' ? GAP * places.drawnDiameter : Infinity;
}

function marks({ points }: SourceSet, places: Places): number[] {
  const half = (DOT / 2) * places.drawnDiameter;
  return points.flatMap((point) => {
    const place = places.at(point);
    if (!place) return [];
    const { position, normal } = place;
    const along = tangent(normal);
    return [-half, half].flatMap((step) => moved(position, along, step));
  });
}

/** A unit vector at right angles to another one. */
function tangent([x, y, z]: Vector): Vector {
  // Of the two, the longer one: the normal is not along both axes.
  return normalized(Math.abs(x) < Math.abs(z) ? [0, z, -y] : [-y, x, 0]);
}
