import { expect, test } from '@playwright/test';
import { found } from '../../web/ui/search/found';

const entry = (name: string, place = '', line = '') => ({ name, place, line });
const ENTRIES = [
  entry('Stripe width', 'Look', 'Share of the period'),
  entry('Period', 'Look'),
  entry('Élan', 'Aspect'),
  entry('Time factor m', 'Solver', 'Heat flows'),
];
const names = (text: string) => found(ENTRIES, text).map(({ name }) => name);

test('names come before what is said of them, without case and accents, and every word counts', () => {
  expect(names('PERIOD')).toEqual(['Period', 'Stripe width']);
  expect(names('ELAN')).toEqual(['Élan']);
  expect(names('heat solver')).toEqual(['Time factor m']);
  expect(names('heat look')).toEqual([]);
  expect(names('factor')).toEqual(['Time factor m']);
  expect(names(' ')).toHaveLength(ENTRIES.length);
});
