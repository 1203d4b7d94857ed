import { expect, test } from '@playwright/test';
import { REPORT } from '../../web/state/report';
import { csvOf, markdownOf, median, parametersOfReport, type Row } from '../../web/state/table1';
import { findPreset } from '../../web/state/presets';

const ROW: Row = {
  title: 'Cow',
  triangles: 5804,
  iterated: { precompute: 123.4, solve: 12.34 },
  factored: { precompute: 9.87, solve: 0.51 },
};

test('the models of the report are eleven, and each is there', () => {
  expect(REPORT).toHaveLength(11);
  for (const { model } of REPORT) if ('preset' in model) expect(findPreset(model.preset)?.id).toBe(model.preset);
});

test('the table is that of the report: one step of heat in squared mean edges, and no exact region', () => {
  expect(parametersOfReport('cg')).toMatchObject({ solver: 'cg', operator: 'plain', timeStep: 1, exactRadius: 0 });
});

test('times are told to a tenth of a millisecond in Markdown, whole in CSV, and those of the report as it gives them', () => {
  expect(markdownOf([ROW], 'a browser').split('\n').slice(1)).toEqual([
    '| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |',
    '| Cow | 5804 | 123 | 12.3 | 9.9 | 0.5 | 62 | 109 | 335 | 16 |',
    '',
    'Measured by Heatwalk in a browser. Report: ALGLIB in C# on a laptop of 2015.',
    '',
  ]);
  expect(csvOf([ROW]).split('\r\n')[1]).toBe('Cow,5804,123.4,12.34,9.87,0.51,62,109,335,16');
});

test('the median is the middle one, or between the middle two', () => {
  expect(median([3, 1, 2])).toBe(2);
  expect(median([4, 1, 2, 8])).toBe(3);
  expect(median([5])).toBe(5);
});
