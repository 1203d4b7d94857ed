/** What compares two settings: loaded with the first comparison. */
import '../../style/compare.css';
import { Comparison } from '../../session/comparison';
import type { Session } from '../../session/session';
import { Divider } from './divider';
import { compareSection } from './section';

export interface Comparing {
  comparison: Comparison;
  divider: Divider;
  section: HTMLElement;
}

export function comparing(session: Session): Comparing {
  const comparison = new Comparison(session);
  return { comparison, divider: new Divider(session, comparison), section: compareSection(session, comparison) };
}
