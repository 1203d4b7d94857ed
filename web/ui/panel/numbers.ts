import type { PathKind } from '../../protocol';
import type { Shown } from '../../session/prepare';
import type { Session } from '../../session/session';
import { isSameUnit, type LengthUnit, unitOf } from '../../length';
import { hasCosts } from '../../state/ground';
import { h, say } from '../dom';
import { calmly } from './calm';
import { measure, threeDigits } from '../../state/measures';
import { bytes, finePercent, milliseconds, percent, percentDown } from '../words';
import { count, listed, t, type Words } from '../../texts';

const PATH_WORDS: Record<PathKind, Words> = {
  descent: t('steepest descent'),
  straight: t('straightened'),
  exact: t('exact'),
};

/** Size of the mesh, accuracy, times and memory. */
export function numbersSection(session: Session): HTMLElement {
  const table = h('dl', { class: 'numbers' });
  const row = (name: Words) => {
    const [head, cell] = [h('dt', {}, name), h('dd')];
    table.append(head, cell);
    return { head, cell };
  };
  const [renderer, pixels] = [row(t('Renderer')).cell, row(t('Pixels drawn')).cell];
  const rows: ReturnType<typeof row>[] = [];
  const show = calmly(session, () => {
    const { scene, shown } = session;
    if (!shown.value) return;
    figures(shown.value, unitOf(scene.state, shown.value.opened)).forEach(([name, value], index) => {
      const { head, cell } = (rows[index] ??= row(name));
      say(head, name);
      say(cell, value);
    });
  });
  session.shown.watch(show);
  session.scene.subscribe((state, previous) => {
    if (!isSameUnit(state, previous)) show();
  });
  session.view.backend.watch((backend) => say(renderer, backend ?? t('none')));
  session.view.resolution.watch((share) => say(pixels, percent(share ** 2)));
  return table;
}

function figures({ opened, answer, places }: Shown, unit: LengthUnit): [Words, Words][] {
  const { report } = opened;
  const { field, path, factoring } = answer;
  const { timings } = factoring;
  return [
    [t('Triangles'), count(report.faces)],
    [t('Polygons'), report.polygons < report.faces ? count(report.polygons) : '–'],
    [t('Tetrahedra'), opened.interior ? count(opened.interior.report.tetrahedra) : '–'],
    [t('Vertices'), count((opened.interior?.report ?? report).vertices)],
    [t('Components'), count(report.components)],
    [t('Contacts'), factoring.groups > 0 ? count(factoring.contacts) : '–'],
    [t('Links between groups'), factoring.groups > 0 ? count(factoring.links) : '–'],
    [t('Groups of components'), factoring.groups > 0 ? count(factoring.groups) : '–'],
    [t('Boundaries'), count(report.boundaryLoops)],
    [t('Euler characteristic'), count(report.eulerCharacteristic)],
    [t('Mean edge'), measure(opened.meanEdge, unit)],
    [t('Diagonal'), measure(places.diameter, unit)],
    [
      hasCosts(answer.question.ground) ? t('Greatest cost') : t('Maximum distance'),
      field ? measure(field.maxDistance, unit) : '–',
    ],
    [t('Exact vertices'), field ? percentDown(field.exactShare) : '–'],
    [t('Mean error before refinement'), field?.error ? finePercent(field.error.mean) : '–'],
    [t('Maximum error'), field?.error ? finePercent(field.error.max) : '–'],
    [t('Path'), path ? listed(measure(path.length, unit), PATH_WORDS[answer.pathKind]) : '–'],
    [t('Cost of the path'), path ? measure(path.cost, unit) : '–'],
    [t('Windows of a half-edge'), field?.windows ? count(field.windows) : '–'],
    [t('Time factor m'), field?.timeFactor ? threeDigits(field.timeFactor) : '–'],
    [t('Read'), milliseconds(timings.readMs)],
    [t('Build'), milliseconds(timings.buildMs)],
    [t('Draw'), milliseconds(timings.drawMs)],
    [t('Join components'), timings.joinMs > 0 ? milliseconds(timings.joinMs) : '–'],
    [t('Factor'), timings.precomputeMs > 0 ? milliseconds(timings.precomputeMs) : '–'],
    [t('Solve'), field ? milliseconds(field.solveMs) : '–'],
    [t('Refine'), field && field.refineMs > 0 ? milliseconds(field.refineMs) : '–'],
    [t('Factor nonzeros'), factoring.factorNonzeros > 0 ? count(factoring.factorNonzeros) : '–'],
    [t('Memory'), bytes(factoring.memoryBytes)],
  ];
}
