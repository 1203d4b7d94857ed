/** Sentences on how a field was found and how far it is exact, which the first picture goes without. */
import type { DistanceField, FieldError } from '../protocol';
import { MOST_SECONDS, type Phase } from '../solver/refiner';
import type { LengthUnit } from '../length';
import { measure } from '../state/measures';
import type { SceneState } from '../state/scene';
import { finePercent, LEAST_EXACT, percentDown } from './words';
import { counted, sentences, t, type Words } from '../texts';

/** What is wanted of a field. */
type Wish = Pick<SceneState, 'method' | 'pathKind'>;

/** How a field was found, and how far it is exact, in a sentence. */
export function fieldSentence(field: DistanceField, unit: LengthUnit): Words {
  const { exactBelow, exactShare, windows, error, inner, timeFactor } = field;
  if (inner && timeFactor === undefined) {
    return exactBelow === Infinity
      ? t('Exact: straight lines lead from everywhere to a source.')
      : t`By waves. Straight lines lead from ${percentDown(exactShare)} of the vertices to a source: these are exact.`;
  }
  if (exactBelow === Infinity) return sentences(t('Exact.'), error && errorSentence(error, windows));
  const figures = [measure(exactBelow, unit), percentDown(exactShare)] as const;
  if (windows === undefined) {
    return exactShare >= LEAST_EXACT
      ? t('By the heat method: exact below {0} ({1} of vertices).', ...figures)
      : t('By the heat method.');
  }
  return exactShare >= LEAST_EXACT
    ? counted(
        windows,
        'By propagation with {0} window: exact below {1} ({2} of vertices), an upper bound beyond.',
        'By propagation with {0} windows: exact below {1} ({2} of vertices), an upper bound beyond.',
        ...figures,
      )
    : counted(windows, 'By propagation with {0} window.', 'By propagation with {0} windows.');
}

function errorSentence(error: FieldError, windows: number | undefined): Words {
  return windows === undefined
    ? t`Error of the heat method: ${errorWords(error)}.`
    : counted(
        windows,
        'Error of propagation with {0} window: {1}.',
        'Error of propagation with {0} windows: {1}.',
        errorWords(error),
      );
}

export function errorWords({ mean, max }: FieldError): Words {
  return t`mean ${finePercent(mean)}, maximum ${finePercent(max)}`;
}

/** What is shown, and the state of refinement or the reason why it ended. */
export function refiningSentence(
  phase: Phase,
  field: DistanceField,
  { method, pathKind }: Wish,
  unit: LengthUnit,
): Words {
  const soFar = fieldSentence(field, unit);
  switch (phase) {
    case 'memory':
      return sentences(
        soFar,
        t('Refinement stopped because memory ran out.'),
        pathKind === 'exact' ? t('The path is straightened where no exact one was found.') : null,
      );
    case 'late':
      return sentences(soFar, t`Refinement stopped after ${MOST_SECONDS} seconds.`);
    case 'stuck':
      return sentences(soFar, t('Refinement stopped because it made no progress.'));
    case 'off':
      return method === 'propagation' ? soFar : sentences(soFar, t('Refinement is off.'));
    case 'costs':
      return sentences(soFar, t('Where costs differ, windows and paths are refracted and nothing is exact.'));
    case 'inside':
    case 'exact':
    case 'solving':
    case 'resting':
    case 'refining':
    case 'hidden':
    case 'failed':
    case 'idle':
      return soFar;
  }
}
