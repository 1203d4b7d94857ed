/** The models of the report's table 1. */

/** Milliseconds. */
export interface Times {
  precompute: number;
  solve: number;
}

export interface ModelOfReport {
  title: string;
  /** The preset that stands for it, or a shape that is in none. */
  model: { preset: string } | { shape: string };
  triangles: number;
  iterated: Times;
  factored: Times;
}

/** The report's models with its times. */
export const REPORT: readonly [ModelOfReport, ...ModelOfReport[]] = [
  reported('High Genus', { preset: 'high_genus' }, 3328, [34, 27], [64, 8.9]),
  reported('Bague', { preset: 'ring' }, 5304, [55, 60], [109, 17]),
  reported('Cow', { preset: 'animal' }, 5804, [62, 109], [335, 16]),
  reported('Triceratops', { preset: 'triceratops' }, 5660, [59, 105], [306, 15]),
  reported('Sphere 1', { shape: 'uv_sphere' }, 9024, [94, 99], [236, 21]),
  reported('Sphere 3', { preset: 'icosphere' }, 6912, [65, 59], [327, 18]),
  reported('Hemisphere', { preset: 'hemisphere' }, 3456, [51, 34], [131, 10]),
  reported('Skull', { preset: 'skull' }, 12200, [183, 338], [989, 38]),
  reported('Maze', { preset: 'maze' }, 5120, [63, 94], [134, 12]),
  reported('Horse', { preset: 'horse' }, 39996, [447, 1355], [2047, 113]),
  reported('Dragon', { preset: 'dragon' }, 20388, [188, 1291], [1787, 58]),
];

function reported(
  title: string,
  model: ModelOfReport['model'],
  triangles: number,
  [iteratedFirst, iteratedThen]: readonly [number, number],
  [factoredFirst, factoredThen]: readonly [number, number],
): ModelOfReport {
  const iterated = { precompute: iteratedFirst, solve: iteratedThen };
  return { title, model, triangles, iterated, factored: { precompute: factoredFirst, solve: factoredThen } };
}
