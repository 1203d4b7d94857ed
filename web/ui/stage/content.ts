/** What the legend has of the picture: its colors, a length, and where the axes of the file point. */
import type { Session } from '../../session/session';
import { available } from '../../session/overlays';
import { drawnPlace } from '../../session/nearest';
import { inModel, ofModel, told, unitOf } from '../../length';
import { hasCosts } from '../../state/ground';
import {
  coverage,
  largestWords,
  nameWords,
  type Painted,
  roundBelow,
  spacingOf,
  ticksOf,
  titleWords,
} from '../../state/legend';
import { measure, unitWords } from '../../state/measures';
import { entry } from '../../state/entry';
import { type Pattern, rampBytes, type Style, telling, WIDEST_LINE } from '../../state/styles';
import { between, cross, dot, type Vector } from '../../state/vector';
import type { View } from '../../view/view';
import { t, sentences, type Words } from '../../texts';
import { type Bar, LEAST_APART } from './bar';
import { besideOf } from './beside';

/** A length on the screen, CSS pixels. */
export interface ScaleBar {
  pixels: number;
  text: string;
}

/** Where the axes of a map point on the screen, right, down and towards the eye. */
export interface North {
  north: Vector;
  east: Vector;
}

/** An axis of the file: its name, and where it points on the screen, right, down and towards the eye. */
export interface Axis {
  name: string;
  direction: Vector;
}

export interface Content {
  isCompact: boolean;
  bar: Bar | null;
  /** How far stripes are apart; empty for none. */
  spacing: string;
  scale: ScaleBar | null;
  /** Of what is no terrain. */
  axes: readonly Axis[];
  north: North | null;
  /** All of it in words. */
  words: Words;
}

/** The longest scale bar. */
const LONGEST = { wide: 96, compact: 56 } as const;
const MOST_TICKS = { wide: 5, compact: 2 } as const;
/** Between the stripes where the file's own materials are seen. */
const OF_FILE: Vector = [205, 204, 201];

/** Null where nothing is drawn that a legend could be about. */
export function contentOf(session: Session, isCompact: boolean): Content | null {
  const { shown, view, preview, scene } = session;
  if (!shown.value || preview.value || view.backend.value === null) return null;
  const { opened, answer } = shown.value;
  const form = isCompact ? 'compact' : 'wide';
  const unit = unitOf(scene.state, opened);
  const { most, period, offset } = view.painted;
  const { colorBy: kind } = available(scene.state, answer.question.method);
  const isKnown = answer.field !== null && (kind !== 'error' || answer.field.error !== null);
  const { style: own } = scene.state;
  const style = kind === 'distance' ? own : telling(own);
  const ofFile = style.surfaceOf === 'file' && opened.appearance !== null;
  const isSeen = !ofFile || (style.pattern !== 'none' && style.maps.includes('colour'));
  const painted: Painted = { kind, most, isCost: hasCosts(answer.question.ground) };
  const spacing = spacingOf(style.pattern, painted, period);
  const beside = besideOf(session, unit, MOST_TICKS[form]);
  const bar = isKnown && isSeen && most > 0 && !beside;
  const scale = scaleBarOf(session, LONGEST[form]);
  const ticks = ticksOf(painted, unit, MOST_TICKS[form]);
  const plain = { ...unit, assumed: false };
  const axes = isCompact ? [] : axesOf(session);
  const apart =
    spacing && (bar || beside?.bar === null)
      ? apartWords(style.pattern, painted.isCost ? t`${measure(spacing, plain)} of cost` : measure(spacing, plain))
      : null;
  return {
    isCompact,
    bar: bar
      ? {
          title: String(isCompact ? nameWords(painted) : titleWords(painted, unit)),
          // The small one has the unit beside the largest number.
          ticks: ticks.map(({ at, text }, i) => {
            const isLast = i === ticks.length - 1;
            const hasUnit = isCompact && isLast && kind === 'distance';
            return { at, text: String(hasUnit ? t`${text} ${unitWords(plain)}` : text) };
          }),
          colours: coloursOf(view, style, ofFile),
          key: JSON.stringify([style, ofFile, most, period, offset]),
        }
      : (beside?.bar ?? null),
    spacing: String(isCompact || !apart ? '' : apart),
    scale,
    axes: opened.isTerrain ? [] : axes,
    north: opened.isTerrain ? northOf(axes) : null,
    words: sentences(
      t('Legend.'),
      beside && beside.words,
      bar
        ? t`${titleWords(painted, unit)}: from ${entry(ticks, 0).text} to ${largestWords(painted, unit)}, by color.`
        : null,
      apart && t`${apart}.`,
      scale && t`Scale bar: ${scale.text}.`,
      t`Up is ${opened.drawTransform.up.toUpperCase().replace('-', '−')}.`,
      opened.isTerrain ? t('North is Y.') : null,
    ),
  };
}

function apartWords(pattern: Pattern, length: Words): Words {
  return pattern === 'lines' ? t`Lines ${length} apart` : t`Stripes ${length} apart`;
}

/** The colors of the surface with its stripes, as they are without light. */
function coloursOf(view: View, style: Style, ofFile: boolean): Bar['colours'] {
  const { most, period, offset } = view.painted;
  const periods = period > 0 ? most / period : 0;
  const hasStripes = periods > 0 && style.maps.includes('colour');
  return (pixels, scale) => {
    // Lines that would run into each other would hide the colors.
    const isStriped = hasStripes && (style.pattern !== 'lines' || pixels > LEAST_APART * scale * periods);
    const ramps = rampBytes(style);
    const lineWidth = style.width * WIDEST_LINE * scale;
    const at = (row: number, share: number): Vector => {
      const start = 4 * (256 * row + Math.round(255 * Math.min(1, Math.max(0, share))));
      return [entry(ramps, start), entry(ramps, start + 1), entry(ramps, start + 2)];
    };
    return (share) => {
      const under = ofFile ? OF_FILE : at(0, share);
      const covered = isStriped ? coverage(style, lineWidth, share * periods - offset, periods / pixels) : 0;
      return `rgb(${between(under, at(1, share), covered).map(Math.round).join()})`;
    };
  };
}

/** Right, up and back of the camera, as it is drawn. */
function eyeAxes(camera: readonly number[]): [Vector, Vector, Vector] {
  const [yaw = 0, pitch = 0] = camera;
  const right: Vector = [Math.cos(yaw), 0, -Math.sin(yaw)];
  const back: Vector = [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
  return [right, cross(back, right), back];
}

/** A round length across the line of sight in the middle of the model; null where that is not seen. */
function scaleBarOf({ view, shown, scene }: Session, longest: number): ScaleBar | null {
  const { camera } = view;
  if (!shown.value || !camera) return null;
  const { places, opened } = shown.value;
  const [low, high] = places.box;
  const middle = low.map((value, i) => (value + entry(high, i)) / 2) as Vector;
  const [right] = eyeAxes(camera);
  const step = places.drawnDiameter / 100;
  const ahead = middle.map((value, i) => value + step * entry(right, i)) as Vector;
  const [from, to] = [view.project(middle), view.project(ahead)];
  if (!from || !to) return null;
  const unit = unitOf(scene.state, opened);
  /** CSS pixels of the model's unit. */
  const pixels = (Math.hypot(to[0] - from[0], to[1] - from[1]) / step) * opened.drawTransform.scale;
  const most = told(ofModel(longest / pixels), unit);
  if (!(most > 0 && Number.isFinite(most))) return null;
  const length = inModel(roundBelow(most), unit);
  return { pixels: length * pixels, text: String(measure(length, { ...unit, assumed: false })) };
}

/** The farthest first. */
function axesOf({ view, shown }: Session): Axis[] {
  const { camera } = view;
  const transform = shown.value?.opened.drawTransform;
  if (!camera || !transform) return [];
  const [right, up, back] = eyeAxes(camera);
  const turned = { ...transform, center: [0, 0, 0] as Vector, scale: 1 };
  const ofFile: [string, Vector][] = [
    ['X', [1, 0, 0]],
    ['Y', [0, 1, 0]],
    ['Z', [0, 0, 1]],
  ];
  return ofFile
    .map(([name, axis]) => {
      const drawn = drawnPlace(axis, turned);
      return { name, direction: [dot(drawn, right), -dot(drawn, up), dot(drawn, back)] as Vector };
    })
    .toSorted((one, other) => one.direction[2] - other.direction[2]);
}

/** A map has east along X and north along Y. */
function northOf(axes: readonly Axis[]): North | null {
  const [east, north] = ['X', 'Y'].map((name) => axes.find((axis) => axis.name === name)?.direction);
  return east && north ? { north, east } : null;
}
