/** What measures and shows tapes: loaded with the first of them. */
import '../../style/tapes.css';
import type { Session } from '../../session/session';
import { told, Tapes, type ToldTape } from '../../session/tapes';
import type { MeasureInput } from './input';
import { TapeLabels } from './labels';
import { tapesTable } from './section';

export interface Measuring {
  tapes: Tapes;
  labels: TapeLabels;
  table: HTMLElement;
  told: () => ToldTape[];
}

export function measuring(session: Session, input: MeasureInput): Measuring {
  const tapes = new Tapes(session);
  return {
    tapes,
    labels: new TapeLabels(session, tapes, input),
    table: tapesTable(session, tapes),
    told: () => tapes.measured.value.map(told),
  };
}
