/** Every text of the page in French. */
import type { Texts } from '../translate';
import { HELP } from './help';
import { PAGE } from './page';
import { PANEL } from './panel';

export const FRENCH: Texts = { ...PANEL, ...PAGE, ...HELP };
