/** Settings in words. */
import type { SettingKey, Settings } from '../../state/settings';
import { AUTOMATIC } from '../../wasm/contract';
import { BOUNDARIES, METHODS, MULTI_SOURCES, OPERATORS, SOLVERS } from '../settings';
import { threeDigits } from '../../state/measures';
import { counted, listed, t, type Words } from '../../texts';

const WORDS: Record<SettingKey, (settings: Settings) => Words> = {
  method: ({ method }) => METHODS[method],
  windows: ({ windows }) => counted(windows, '{0} window', '{0} windows'),
  t: ({ parameters: { timeStep } }) => (timeStep === AUTOMATIC ? t('m automatic') : t`m = ${threeDigits(timeStep)}`),
  b: ({ parameters }) => BOUNDARIES[parameters.boundary],
  multi: ({ parameters }) => t`Sources: ${MULTI_SOURCES[parameters.sources]}`,
  near: ({ parameters: { exactRadius } }) =>
    exactRadius === AUTOMATIC ? t('Exact region automatic') : t`Exact region ${exactRadius} edges`,
  memory: ({ parameters: { memory } }) => (memory === AUTOMATIC ? t('Memory automatic') : t`Memory ${memory} MiB`),
  op: ({ parameters }) => OPERATORS[parameters.operator],
  solver: ({ parameters }) => SOLVERS[parameters.solver],
  refine: ({ refine }) => (refine ? t('Refined') : t('Not refined')),
};

/** Settings of the heat method alone, and those of the others alone. */
const OF_HEAT: readonly SettingKey[] = ['t', 'b', 'multi', 'near', 'memory', 'op', 'solver'];
const OF_WINDOWS: readonly SettingKey[] = ['windows'];

/** The settings in which two sides differ; of two methods, these alone. */
export function settingsWords(settings: Settings, keys: readonly SettingKey[]): Words {
  const others = settings.method === 'heat' ? OF_WINDOWS : OF_HEAT;
  const meant = keys.includes('method') ? ['method' as const] : keys.filter((key) => !others.includes(key));
  return meant.length > 0 ? listed(...meant.map((key) => WORDS[key](settings))) : METHODS[settings.method];
}
