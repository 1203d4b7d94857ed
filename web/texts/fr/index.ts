/** Every text of the page in French, and what workers say. */
import type { Texts } from '../translate';
import { ARCHIVES, SHELL } from './archives';
import { GLTF } from './gltf';
import { HELP } from './help';
import { OPTIONS } from './options';
import { PAGE } from './page';
import { PANEL } from './panel';
import { READERS } from './readers';
import { REPORTS as OF_MODULES } from './reports';
import { SURFACE } from './surface';
import { TETRAHEDRA } from './tetrahedra';

export const FRENCH: Texts = { ...PANEL, ...PAGE, ...SURFACE, ...HELP, ...ARCHIVES, ...SHELL };
export const REPORTS: Texts = { ...ARCHIVES, ...OF_MODULES, ...READERS, ...GLTF, ...TETRAHEDRA, ...OPTIONS };
