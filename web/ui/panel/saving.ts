/** What saves curves on the surface as a file of a kind that is chosen. */
import { Failure } from '../../error';
import type { CurveFile } from '../../protocol';
import { towardEye } from '../../session/export';
import type { Session } from '../../session/session';
import type { Engine } from '../../solver/engine';
import { isKnown, unitOf, unitOfFile } from '../../length';
import { save } from '../../view/picture';
import { h, select } from '../dom';
import { fileNameOf } from '../words';
import { t, type Words } from '../../texts';

type Kind = Extract<CurveFile['kind'], 'dxf' | 'obj' | 'svg' | 'pdf' | 'csv' | 'glb'>;
const FILES: readonly (readonly [Kind, Words])[] = [
  ['dxf', 'DXF'],
  ['obj', 'OBJ'],
  ['svg', t('as seen, SVG')],
  ['pdf', t('as seen, PDF')],
  ['csv', 'CSV'],
  ['glb', 'GLB'],
];

interface Saving {
  /** Of the kinds. */
  label: Words;
  button: Words;
  title: Words;
  /** Of the name, before the kind. */
  suffix: string;
  file: (engine: Engine, file: CurveFile) => Promise<Uint8Array<ArrayBuffer>>;
}

export function savingCurves(session: Session, { label, button, title, suffix, file }: Saving): HTMLElement {
  let [[kind]] = FILES as readonly [readonly [Kind, Words]];
  const kinds = select(label, FILES, (value) => (kind = value));
  const saved = async () => {
    const { engine, shown, scene, view } = session;
    if (!engine || !shown.value) return;
    const unit = unitOfFile(kind, unitOf(scene.state, shown.value.opened));
    if (kind === 'pdf' && !isKnown(unit))
      throw new Failure(
        t('A PDF is at true scale, and nothing says what the lengths are in. Choose it by "Correct unit".'),
      );
    const bytes = await file(engine, { kind, towardEye: towardEye(view.camera), unit });
    save(new Blob([bytes]), `${fileNameOf(shown.value)}.${suffix}.${kind}`);
  };
  const keep = h(
    'button',
    { class: 'wide', title, onclick: () => void saved().catch((error: unknown) => session.fail(error)) },
    button,
  );
  return h('div', { class: 'stack', hidden: true }, kinds.element, keep);
}
