import type { Session } from '../../session/session';
import { findPreset } from '../../state/presets';
import { h } from '../dom';
import { count, exactnessWords } from '../words';

/** Top left: the name, the scene's title, the size of the mesh and how much of the distance is exact. */
export function heading(session: Session): HTMLElement {
  const title = h('span', { class: 'title' });
  const size = h('span', { class: 'quiet size' });
  const exactness = h('span', { class: 'quiet exactness' });
  session.shown.watch((shown) => {
    const field = shown?.answer.field;
    exactness.textContent = field ? exactnessWords(field) : '';
    const { mesh } = session.scene.state;
    title.textContent = mesh.kind === 'preset' ? (findPreset(mesh.id)?.title ?? '') : mesh.name;
    size.textContent = shown ? `${count(shown.opened.report.faces)} triangles` : '';
  });
  session.scene.subscribe((state, previous) => {
    if (state.mesh === previous.mesh) return;
    title.textContent = state.mesh.kind === 'preset' ? (findPreset(state.mesh.id)?.title ?? '') : state.mesh.name;
  });
  return h('header', { class: 'heading' }, h('h1', {}, 'Heatwalk'), title, size, exactness);
}
