import type { PathKind } from '../../protocol';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import { isSameUnit, type LengthUnit, unitOf } from '../../state/scene';
import { h } from '../dom';
import { bytes, count, finePercent, length, measure, milliseconds, percent, percentDown } from '../words';

const PATH_WORDS: Record<PathKind, string> = { descent: 'steepest descent', straight: 'straightened', exact: 'exact' };

/** Size of the mesh, accuracy, times and memory. */
export function numbersSection(session: Session): HTMLElement {
  const table = h('dl', { class: 'numbers' });
  const cells = new Map<string, HTMLElement>();
  const put = (name: string, value: string) => {
    let cell = cells.get(name);
    if (!cell) {
      cell = h('dd');
      cells.set(name, cell);
      table.append(h('dt', {}, name), cell);
    }
    if (cell.textContent !== value) cell.textContent = value;
  };
  const show = () => {
    const { scene, shown } = session;
    if (!shown.value) return;
    for (const [name, value] of figures(shown.value, unitOf(scene.state, shown.value.opened))) put(name, value);
  };
  session.shown.watch(show);
  session.scene.subscribe((state, previous) => {
    if (!isSameUnit(state, previous)) show();
  });
  session.view.backend.watch((backend) => put('Renderer', backend ?? 'none'));
  session.view.resolution.watch((share) => put('Pixels drawn', percent(share ** 2)));
  return table;
}

function figures({ opened, answer, places }: Shown, unit: LengthUnit): [string, string][] {
  const { report } = opened;
  const { field, path, factoring } = answer;
  const { timings } = factoring;
  return [
    ['Triangles', count(report.faces)],
    ['Tetrahedra', opened.interior ? count(opened.interior.report.tetrahedra) : '–'],
    ['Vertices', count((opened.interior?.report ?? report).vertices)],
    ['Components', count(report.components)],
    ['Contacts', factoring.groups > 0 ? count(factoring.contacts) : '–'],
    ['Links between groups', factoring.groups > 0 ? count(factoring.links) : '–'],
    ['Groups of components', factoring.groups > 0 ? count(factoring.groups) : '–'],
    ['Boundaries', count(report.boundaryLoops)],
    ['Euler characteristic', count(report.eulerCharacteristic)],
    ['Mean edge', measure(opened.meanEdge, unit)],
    ['Diameter', measure(places.diameter, unit)],
    ['Maximum distance', field ? measure(field.maxDistance, unit) : '–'],
    ['Exact vertices', field ? percentDown(field.exactShare) : '–'],
    ['Mean error before refinement', field?.error ? finePercent(field.error.mean) : '–'],
    ['Maximum error', field?.error ? finePercent(field.error.max) : '–'],
    ['Path', path ? `${measure(path.length, unit)}, ${PATH_WORDS[answer.pathKind]}` : '–'],
    ['Cost of the path', path ? length(path.cost) : '–'],
    ['Windows of a half-edge', field?.windows ? count(field.windows) : '–'],
    ['Time factor m', field?.timeFactor ? length(field.timeFactor) : '–'],
    ['Read', milliseconds(timings.readMs)],
    ['Build', milliseconds(timings.buildMs)],
    ['Draw', milliseconds(timings.drawMs)],
    ['Join components', timings.joinMs > 0 ? milliseconds(timings.joinMs) : '–'],
    ['Factor', timings.precomputeMs > 0 ? milliseconds(timings.precomputeMs) : '–'],
    ['Solve', field ? milliseconds(field.solveMs) : '–'],
    ['Refine', field && field.refineMs > 0 ? milliseconds(field.refineMs) : '–'],
    ['Factor nonzeros', factoring.factorNonzeros > 0 ? count(factoring.factorNonzeros) : '–'],
    ['Memory', bytes(factoring.memoryBytes)],
  ];
}
