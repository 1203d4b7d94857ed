/** What measures and shows tapes: loaded with the first of them. */
import '../../style/tapes.css';
import type { Session } from '../../session/session';
import { figuresOf, Tapes, type TapeFigures } from '../../session/tapes';
import type { MeasureInput } from './input';
import { TapeLabels } from './labels';
import { tapesTable } from './section';

export interface Measuring {
  tapes: Tapes;
  labels: TapeLabels;
  table: HTMLElement;
  figures: () => TapeFigures[];
}

export function measuring(session: Session, input: MeasureInput): Measuring {
  const tapes = new Tapes(session);
  return {
    tapes,
    labels: new TapeLabels(session, tapes, input),
    table: tapesTable(session, tapes),
    figures: () => tapes.measured.value.map(figuresOf),
  };
}
