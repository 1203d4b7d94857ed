import { TIME_FACTOR_RANGE } from '../link';
import type { Boundary } from '../protocol';
import type { Scene } from '../scene';
import { h, select, slider } from './dom';

const BOUNDARIES: readonly (readonly [Boundary, string])[] = [
  ['neumann', 'Insulated (Neumann)'],
  ['dirichlet', 'Held at zero (Dirichlet)'],
  ['average', 'Mean of both'],
];

/** Time factor, on a logarithmic scale, and boundary condition. */
export function solverSection(scene: Scene): HTMLElement {
  const change = (part: Partial<typeof scene.state.parameters>) =>
    scene.set({ parameters: { ...scene.state.parameters, ...part } });
  const [low, high] = TIME_FACTOR_RANGE;
  const factor = slider({
    label: 'Time factor m',
    min: Math.log10(low),
    max: Math.log10(high),
    step: 0.05,
    describe: (value) => `${Number((10 ** value).toPrecision(2))}`,
    change: (value) => change({ timeFactor: Number((10 ** value).toPrecision(2)) }),
  });
  const boundary = select('Boundary', BOUNDARIES, (value) => change({ boundary: value }));
  const show = () => {
    factor.show(Math.log10(scene.state.parameters.timeFactor));
    boundary.show(scene.state.parameters.boundary);
  };
  scene.subscribe((state, previous) => {
    if (state.parameters !== previous.parameters) show();
  });
  show();
  return h(
    'div',
    { class: 'stack' },
    factor.element,
    h('p', { class: 'quiet' }, 'Heat flows for t = m h², with h the mean edge. Larger m gives smoother distance.'),
    boundary.element,
  );
}
