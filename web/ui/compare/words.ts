/** Settings in words. */
import type { SettingKey, Settings } from '../../state/settings';
import { AUTOMATIC } from '../../wasm/contract';
import { BOUNDARIES, METHODS, MULTI_SOURCES, OPERATORS, SOLVERS } from '../settings';
import { counted, length } from '../words';
import { t } from '../../texts';

const WORDS: Record<SettingKey, (settings: Settings) => string> = {
  method: ({ method }) => METHODS[method],
  windows: ({ windows }) => counted(windows, 'window'),
  t: ({ parameters: { timeStep } }) => `m ${timeStep === AUTOMATIC ? t('automatic') : `= ${length(timeStep)}`}`,
  b: ({ parameters }) => BOUNDARIES[parameters.boundary],
  multi: ({ parameters }) => t`${MULTI_SOURCES[parameters.sources]} sources`,
  near: ({ parameters: { exactRadius } }) =>
    exactRadius === AUTOMATIC ? t('Exact region automatic') : t`Exact region ${exactRadius} edges`,
  memory: ({ parameters: { memory } }) => t`Memory ${memory === AUTOMATIC ? t('automatic') : t`${memory} MiB`}`,
  op: ({ parameters }) => OPERATORS[parameters.operator],
  solver: ({ parameters }) => SOLVERS[parameters.solver],
  refine: ({ refine }) => (refine ? t('Refined') : t('Not refined')),
};

/** Settings of the heat method alone, and those of the others alone. */
const OF_HEAT: readonly SettingKey[] = ['t', 'b', 'multi', 'near', 'memory', 'op', 'solver'];
const OF_WINDOWS: readonly SettingKey[] = ['windows'];

/** What settings are told apart by: of two methods, by these. */
export function told(settings: Settings, keys: readonly SettingKey[]): string {
  const others = settings.method === 'heat' ? OF_WINDOWS : OF_HEAT;
  const meant = keys.includes('method') ? ['method' as const] : keys.filter((key) => !others.includes(key));
  return meant.map((key) => WORDS[key](settings)).join(', ') || METHODS[settings.method];
}
