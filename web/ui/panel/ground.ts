import type { DrawPath } from '../../protocol';
import { paintAll, paintWeights } from '../../session/costs';
import { type GroundEditor, NO_GROUND } from '../../session/ground';
import type { Session } from '../../session/session';
import { colourOfCost, WALL_COLOURS } from '../../session/tints';
import { type GroundTool, type Material, MATERIAL_COSTS, MATERIALS, RADII, TOOLS } from '../../state/brush';
import { codeOf, COSTS, costOf, isPainted, isWeighted } from '../../state/ground';
import { isKnown, isSameUnit, type LengthUnit, unitOf } from '../../length';
import type { Signal } from '../../state/signal';
import type { Tool } from '../../state/tool';
import { attribute, h, say, select } from '../dom';
import { labelled, slider, toggle } from '../widgets';
import { KEYS, withKey } from '../keys';
import { measure, threeDigits } from '../../state/measures';
import { byHand, hikingWords, percent } from '../words';
import { sentences, t, type Words } from '../../texts';

/** Of the button that paints them. */
const COSTS_OF_FILE = t('Costs of the file');

const TOOL_WORDS: Record<GroundTool, Words> = {
  brush: t('brush'),
  fill: t('fill an area'),
  line: t('wall along edges'),
  toggle: t('open and close gates'),
};

const TOOL_HINTS: Record<GroundTool, Words> = {
  brush: t('Drag on the surface to paint. Drag beside it, with ctrl, or with two fingers to orbit.'),
  fill: t('Choose an area: all of it that costs the same is painted.'),
  line: byHand(
    t('Mark one vertex after the other. The last one again, or Esc, ends the wall.'),
    t('Mark one vertex after the other. The last one again ends the wall.'),
  ),
  toggle: t('Choose a wall or a gate to open it, or to close it again.'),
};

/** While a wall is being drawn. */
const NEXT_HINT = byHand(
  t('Mark the next vertex. The last one again, or Esc, ends the wall.'),
  t('Mark the next vertex. The last one again ends the wall.'),
);

const MATERIAL_WORDS: Record<Material, Words> = {
  mud: t('Mud'),
  sand: t('Sand'),
  road: t('Road'),
  custom: t('Custom'),
  wall: t('Wall'),
  gate: t('Gate'),
  eraser: t('Eraser'),
};

/** Steps of the sliders of costs for a factor of ten, of the size, and of the relief for a factor of two. */
const COST_STEPS = 25;
const SIZE_STEPS = 100;
const HEIGHT_POWERS = 5;

/** The brush, what slopes and height cost, and what the path costs. */
export function groundSection(session: Session, editor: GroundEditor, pointer: Signal<Tool>): HTMLElement {
  const { scene } = session;
  const brush = toggle(t('Brush'), (on) => {
    pointer.value = on ? 'brush' : 'source';
  });
  attribute(brush.element, 'title', withKey(t('The pointer paints the ground'), KEYS.brush));
  const tool = select<GroundTool>(t('Tool'), labelled(TOOLS, TOOL_WORDS), (value) => editor.take({ tool: value }));
  const hint = h('p', { class: 'quiet' });
  const buttons = MATERIALS.map((material) => {
    const swatch = h('span', { class: 'swatch', 'aria-hidden': 'true' });
    const button = h(
      'button',
      { class: 'material', onclick: () => editor.take({ material }) },
      swatch,
      MATERIAL_WORDS[material],
    );
    return { material, swatch, button };
  });
  const materials = h(
    'div',
    { class: 'materials', role: 'group', 'aria-label': t('Material') },
    ...buttons.map(({ button }) => button),
  );
  const cost = slider({
    label: t('Cost'),
    min: COST_STEPS * Math.log10(COSTS[0]),
    max: COST_STEPS * Math.log10(COSTS[1]),
    step: 1,
    describe: (step) => t`${threeDigits(costAt(step))} × as dear`,
    change: (step) => editor.take({ material: 'custom', cost: costAt(step) }),
  });
  const size = slider({
    label: t('Size'),
    min: 0,
    max: SIZE_STEPS,
    step: 1,
    describe: (step) => t`${threeDigits(100 * radiusAt(step))} % of the diagonal`,
    change: (step) => editor.set({ radius: radiusAt(step) }),
  });
  attribute(size.element, 'title', t('[ and ] change it'));
  const soft = slider({
    label: t('Soft edge'),
    min: 0,
    max: 1,
    step: 0.05,
    describe: percent,
    change: (value) => editor.set({ soft: value }),
  });
  const fill = h(
    'button',
    { class: 'small', title: t('Paints all of it'), onclick: () => paintAll(session, editor.brush.value) },
    t('Fill all'),
  );
  const clear = h(
    'button',
    { class: 'small', title: t('Takes away all that is painted, and all walls'), onclick: () => editor.clear() },
    t('Clear'),
  );
  const ofFile = h('button', { class: 'small', hidden: true, onclick: () => paintWeights(session) }, COSTS_OF_FILE);
  const slope = toggle(t('Slope'), (on) => editor.setRelief({ slope: on }));
  attribute(slope.element, 'title', t('Tobler’s hiking function, as the mean of uphill and downhill'));
  const slopeHint = h('p', { class: 'quiet' });
  const height = slider({
    label: t('Height'),
    min: -HEIGHT_POWERS,
    max: HEIGHT_POWERS,
    step: 0.5,
    describe: (power) => (power === 0 ? t('costs nothing') : t`${threeDigits(2 ** power)} × at the top`),
    change: (power, gesture) => editor.setRelief({ highest: 2 ** power }, gesture),
  });
  const legend = h('p', { class: 'ground-legend', role: 'status' });

  const showBrush = () => {
    const { tool: chosen, material, cost: custom, radius, soft: edge } = editor.brush.value;
    brush.show(editor.isOn);
    tool.show(chosen);
    const isLine = editor.lineEnd.value !== null;
    say(hint, isLine ? NEXT_HINT : TOOL_HINTS[chosen]);
    hint.hidden = !editor.isOn;
    for (const { material: other, swatch, button } of buttons) {
      button.setAttribute('aria-pressed', String(other === material));
      const title = titleOf(other, custom);
      attribute(button, 'title', title);
      swatch.style.background = swatchOf(other, custom);
    }
    materials.hidden = chosen === 'line' || chosen === 'toggle';
    cost.show(Math.round(COST_STEPS * Math.log10(custom)));
    cost.element.hidden = materials.hidden || material !== 'custom';
    size.show(Math.round(stepOf(radius)));
    size.element.hidden = chosen !== 'brush';
    soft.show(edge);
    soft.element.hidden = chosen !== 'brush' || material === 'wall' || material === 'gate';
  };
  editor.brush.watch(showBrush);
  pointer.watch(showBrush);
  editor.lineEnd.watch(showBrush);

  const controls = h('div', { class: 'stack' });
  const none = h('p', { class: 'quiet', hidden: true }, NO_GROUND);
  const showGround = () => {
    const { ground } = scene.state;
    slope.show(ground.slope);
    slopeHint.hidden = !ground.slope;
    const opened = session.shown.value?.opened;
    const hasHours = opened !== undefined && isKnown(unitOf(scene.state, opened));
    const up = opened?.drawTransform.up.toUpperCase().replace('-', '−') ?? '';
    say(
      slopeHint,
      sentences(
        t`Steep ground costs what Tobler’s hiking function says, as the mean of uphill and downhill. Up is ${up}.`,
        hasHours ? null : t('For hours, choose the unit of the file by "Correct unit".'),
      ),
    );
    height.show(Math.log2(ground.highest));
    clear.disabled = !isPainted(ground);
    const shown = session.shown.value;
    const path = shown?.answer.path;
    const walked =
      path && shown && (isWeighted(ground) || isPainted(ground))
        ? costsSentence(path, unitOf(scene.state, shown.opened), ground.slope)
        : null;
    const exactness = isWeighted(ground) ? t('Where costs differ, no distances are exact.') : null;
    say(legend, sentences(walked, exactness));
  };
  scene.subscribe((state, previous) => {
    if (state.ground !== previous.ground || !isSameUnit(state, previous)) showGround();
  });
  session.shown.watch((shown, previous) => {
    showGround();
    if (shown?.opened !== previous?.opened) {
      const weights = shown?.opened.weights;
      ofFile.hidden = !weights;
      say(ofFile, weights ? t`Costs of the file (${weights.name})` : COSTS_OF_FILE);
      controls.hidden = !editor.isThere;
      none.hidden = editor.isThere;
    }
  });
  controls.append(
    brush.element,
    tool.element,
    hint,
    materials,
    cost.element,
    size.element,
    soft.element,
    h('div', { class: 'linking' }, fill, clear, ofFile),
    slope.element,
    slopeHint,
    height.element,
    legend,
  );
  return h('div', {}, none, controls);
}

function costsSentence(path: DrawPath, unit: LengthUnit, hasSlopes: boolean): Words {
  const time = hasSlopes ? hikingWords(path.cost, unit) : null;
  return sentences(
    t`The path is ${measure(path.length, unit)} long and costs as much as ${measure(path.cost, unit)} of bare ground.`,
    time && t`A hiker takes ${time}, as the mean of uphill and downhill, at 5 km/h on the flat.`,
  );
}

/** As it is painted: powers of two in steps of a twelfth. */
function costAt(step: number): number {
  return costOf(codeOf(10 ** (step / COST_STEPS)));
}

function radiusAt(step: number): number {
  return RADII[0] * (RADII[1] / RADII[0]) ** (step / SIZE_STEPS);
}

function stepOf(radius: number): number {
  return (SIZE_STEPS * Math.log(radius / RADII[0])) / Math.log(RADII[1] / RADII[0]);
}

function titleOf(material: Material, custom: number): Words {
  switch (material) {
    case 'wall':
      return t('Nobody walks through');
    case 'gate':
      return t('A wall that can be opened');
    case 'eraser':
      return t('Costs 1 again; also takes walls away');
    case 'custom':
      return t`A unit costs ${threeDigits(custom)}`;
    case 'mud':
    case 'sand':
    case 'road':
      return t`A unit costs ${threeDigits(MATERIAL_COSTS[material])}`;
  }
}

function swatchOf(material: Material, custom: number): string {
  switch (material) {
    case 'wall':
    case 'gate':
      return WALL_COLOURS[material];
    case 'eraser':
      return 'transparent';
    case 'custom':
      return colourOfCost(custom);
    case 'mud':
    case 'sand':
    case 'road':
      return colourOfCost(MATERIAL_COSTS[material]);
  }
}
