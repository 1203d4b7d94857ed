import { Failure } from '../error';
import { t } from '../texts';

/** An entry that a list must have; where it has none, the page is at fault. */
export function entry<T>(list: ArrayLike<T>, index: number): T {
  const found = list[index];
  if (found === undefined) throw new Failure(t`there is no entry ${index} of ${list.length}`);
  return found;
}
