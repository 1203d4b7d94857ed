/** Every text of the page in French, and what workers say. */
import type { Texts } from '../translate';
import { ARCHIVES } from './archives';
import { HELP } from './help';
import { PAGE } from './page';
import { PANEL } from './panel';
import { REPORTS as OF_MODULES } from './reports';

export const FRENCH: Texts = { ...PANEL, ...PAGE, ...HELP, ...ARCHIVES };
export const REPORTS: Texts = { ...ARCHIVES, ...OF_MODULES };
