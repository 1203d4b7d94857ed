import type { Session, Shown } from '../session';
import { bytes, count, length, milliseconds } from '../words';
import { h } from './dom';

/** What the mesh is and what it cost. */
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
  session.shown.watch((shown) => {
    if (shown) for (const [name, value] of figures(shown)) put(name, value);
  });
  session.view.backend.watch((backend) => put('Drawn with', backend ?? 'nothing'));
  return table;
}

function figures({ opened, answer, places }: Shown): [string, string][] {
  const { report, timings } = opened;
  const { field, path } = answer;
  return [
    ['Triangles', count(report.faces)],
    ['Vertices', count(report.vertices)],
    ['Components', count(report.components)],
    ['Boundaries', count(report.boundaryLoops)],
    ['Euler characteristic', count(report.eulerCharacteristic)],
    ['Mean edge', `${length(opened.meanEdge)} units`],
    ['Diameter', `${length(places.diameter)} units`],
    ['Largest distance', field ? `${length(field.maxDistance)} units` : '–'],
    ['Way home', path ? `${length(path.length)} units` : '–'],
    ['Read', milliseconds(timings.readMs)],
    ['Build', milliseconds(timings.buildMs)],
    ['Factor', milliseconds(answer.timings?.precomputeMs ?? timings.precomputeMs)],
    ['Solve', field ? milliseconds(field.solveMs) : '–'],
    ['Factor entries', count(opened.factorNonzeros)],
    ['Memory', bytes(opened.memoryBytes)],
  ];
}
