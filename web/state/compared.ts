/** Two settings of the solver side by side. */
import { DEFAULT_PARAMETERS, DEFAULT_WINDOWS } from '../wasm/contract';
import { type Key, keysOf, read } from './keys';
import { type SettingKey, SETTINGS, type Settings } from './settings';
import { within } from './text';

/** What the scene is compared with. */
export interface Compared extends Settings {
  /** Where the half of these settings begins: share of the width that panels leave free, from the left. */
  split: number;
}

/** Where the split can be. */
export const SPLITS = [0, 1] as const;
export const MIDDLE = 0.5;

/** The settings alone. */
export function settingsOf({ method, windows, parameters, refine }: Settings): Settings {
  return { method, windows, parameters, refine };
}

/** The keys of the settings in which two differ. */
export function differing(one: Settings, other: Settings): SettingKey[] {
  return apart(one, other).map(({ key }) => key);
}

function apart(one: Settings, other: Settings) {
  return SETTINGS.filter(({ encode }) => encode(one) !== encode(other));
}

const SPLIT = keysOf<Compared>().whole('at', 'split', within(SPLITS));
const KEYS: readonly Key<Compared>[] = [...SETTINGS, SPLIT];

/** What differs from the scene's own settings, and the split; `none` where nothing is compared. */
export function encodeCompared(compared: Compared | null, own: Settings): string {
  if (!compared) return 'none';
  return [...apart(own, compared), SPLIT].map(({ key, encode }) => `${key}:${encode(compared)}`).join();
}

/** What `encodeCompared` has written for the same settings; undefined for other text. */
export function decodeCompared(text: string, own: Settings): Compared | null | undefined {
  if (text === 'none') return null;
  let compared: Compared | undefined = { ...settingsOf(own), split: MIDDLE };
  for (const entry of text.split(',')) {
    const [name, value = '', ...more] = entry.split(':');
    const known = KEYS.find(({ key }) => key === name);
    compared = known && more.length === 0 ? read(known, value, compared) : undefined;
    if (!compared) return undefined;
  }
  return compared;
}

const BY_HEAT: Settings = { method: 'heat', windows: DEFAULT_WINDOWS, parameters: DEFAULT_PARAMETERS, refine: false };

/**
 * The comparisons of the report by He and Hung, left and right, and what stands for the exact one inside of tetrahedra. Nothing is refined:
 * exact fields would not differ.
 */
export const STUDIED = {
  'time-step': [byHeat({ timeStep: 1 }), byHeat({ timeStep: 1000 })],
  // Automatic, the time step would differ too: conjugate gradients leave noise, above which heat has to stay.
  solver: [byHeat({ solver: 'cholesky', timeStep: 100 }), byHeat({ solver: 'cg', timeStep: 100 })],
  boundary: [byHeat({ boundary: 'neumann' }), byHeat({ boundary: 'dirichlet' })],
  exact: [BY_HEAT, { ...BY_HEAT, method: 'exact', refine: true }],
  automatic: [BY_HEAT, { ...BY_HEAT, method: 'auto' }],
} as const satisfies Record<string, readonly [Settings, Settings]>;
export type Studied = keyof typeof STUDIED;

/** With no exact region about the sources, which would be the same on both sides. */
function byHeat(parameters: Partial<Settings['parameters']>): Settings {
  return { ...BY_HEAT, parameters: { ...DEFAULT_PARAMETERS, exactRadius: 0, ...parameters } };
}
