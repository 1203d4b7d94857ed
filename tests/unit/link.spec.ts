import { expect, test } from '@playwright/test';
import { ofModel, SHOWN_UNITS, UNITS } from '../../web/length';
import { CUTS, FILLS, INSIDE_NUMBERS, INSIDE_RANGES, WHOLE } from '../../web/state/inside';
import { decodeLink, encodeLink, KEYS, refusedBy, refusedWords } from '../../web/state/link';
import { PRESETS } from '../../web/state/presets';
import { UNCHOSEN } from '../../web/state/sources';
import { startOf as startOfAny } from '../../web/state/start';
import { findStyle } from '../../web/state/styles';
import {
  emptyScene,
  LIGHTS,
  type MeshReference,
  type SceneState,
  SPEEDS,
  STILL,
  TRIANGLES,
} from '../../web/state/scene';
import {
  AUTOMATIC,
  BOUNDARY,
  DEFAULT_PARAMETERS,
  EXACT_RADIUS_EDGES,
  LINEAR_SOLVER,
  MEMORY_LIMIT_MEBIBYTES,
  METHOD,
  MULTI_SOURCE,
  OPERATOR,
  type Parameters,
  PATH_KIND,
  TIME_STEP_FACTORS,
  UP,
  VERTEX_FIELD,
  WINDOWS,
} from '../../web/wasm/contract';

const START: SceneState = {
  ...emptyScene({ kind: 'preset', id: 'bunny' }),
  sources: [{ vertex: 7 }],
  walker: { vertex: 99 },
};

const startOf = (mesh: MeshReference): SceneState | null => {
  if (mesh.kind !== 'preset') return emptyScene(mesh);
  return mesh.id === 'bunny' ? START : null;
};

function throughLink(state: SceneState): SceneState {
  const start = startOf(state.mesh);
  if (!start) throw new Error('no such preset');
  const decoded = decodeLink(`#${encodeLink(state, start)}`, startOf);
  expect([...decoded.notices, ...decoded.refused]).toEqual([]);
  if (!decoded.state) throw new Error('the link names no mesh');
  return decoded.state;
}

test('presets begin with what their links say', () => {
  expect(startOfAny({ kind: 'preset', id: 'images' })).toMatchObject({
    decals: [{ image: 'compass' }, { image: 'star' }],
    sets: [],
  });
  expect(startOfAny({ kind: 'preset', id: 'broken' })).toMatchObject({ overlays: ['curves'], sources: [] });
  expect(startOfAny({ kind: 'preset', id: 'broken' })?.sets.map(({ shape }) => shape.kind)).toEqual(['line', 'line']);
  expect(startOfAny({ kind: 'preset', id: 'cells' })?.sources).toHaveLength(14);
  expect(startOfAny({ kind: 'preset', id: 'loops' })?.overlays).toEqual(['loops', 'loop']);
  for (const { start } of PRESETS) expect(start.walker).toBeTruthy();
});

test('the link of an unchanged preset is its name', () => {
  expect(encodeLink(START, START)).toBe('v=1&m=bunny');
});

test('every change survives the link', () => {
  const neon = findStyle('neon');
  if (!neon) throw new Error('no neon');
  const state: SceneState = {
    ...START,
    parts: [0, 2],
    triangles: 250_000,
    fill: 60_000,
    sources: [
      { vertex: 1203 },
      { face: 88, weights: [0.2, 0.3, 0.5], offset: 0.125 },
      { vertex: 4, offset: 1.5e-7 },
      { vertex: 5, offset: 2e22 },
      { tetrahedron: 6, weights: [0.125, 0.25, 0.5, 0.125] },
    ],
    walker: { vertex: 5521 },
    girth: { turn: -30, tilt: 12.5, place: 0.25 },
    up: '-x',
    unit: 'mm',
    shownUnit: 'in',
    inside: {
      cut: 'wedge',
      turn: -120,
      tilt: 12.5,
      place: -0.25,
      opening: 60,
      whole: true,
      gap: 0.5,
      spacing: 0.1,
      arrows: true,
    },
    method: 'exact',
    windows: 8,
    parameters: {
      operator: 'plain',
      solver: 'cg',
      timeStep: 2.5,
      boundary: 'average',
      sources: 'summed',
      exactRadius: 12.5,
      memory: 500,
    },
    bridge: 0.0125,
    links: 3,
    pathKind: 'descent',
    refine: false,
    isolines: { values: [ofModel(0.5), ofModel(1.25)], spacing: ofModel(0) },
    compared: {
      method: 'heat',
      windows: 1,
      parameters: {
        operator: 'relocate',
        solver: 'cholesky',
        timeStep: AUTOMATIC,
        boundary: 'dirichlet',
        sources: 'exact',
        exactRadius: AUTOMATIC,
        memory: AUTOMATIC,
      },
      refine: true,
      split: 0.375,
    },
    camera: [0.5, -0.25, 3, 0.125, 0, -1],
    lights: 'file',
    animation: { clip: 2, seconds: 1.25, plays: true, speed: 0.5, loops: false, live: true },
    colorBy: 'heat',
    orthographic: true,
    hidden: [1, 3],
    overlays: ['scenery', 'boundary', 'distance'],
    crowd: 250,
    style: {
      ...neon,
      width: 0.35,
      ramp: 'viridis',
      stripe: '#12ab9f',
      pattern: 'lines',
      relief: -0.05,
      offset: 0.25,
      light: -35,
      flow: 0.5,
      surface: { metalness: 0.5, roughness: 0.25, glow: 1.5 },
      maps: ['colour', 'specular'],
      surroundings: 'sky',
    },
  };
  expect(throughLink(state)).toEqual(state);
  expect(encodeLink(state, START)).toContain(
    's=1203,88:0.2/0.3/0.5@0.125,4@1.5e-7,5@2e22,6:0.125/0.25/0.5/0.125&w=5521&up=-x&unit=mm&shown=in&girth=-30,12.5,0.25&cut=wedge&turn=-120&tilt=12.5&place=-0.25&opening=60&gap=0.5&spacing=0.1&whole=1&arrows=1&method=exact&windows=8&t=2.5&b=average&multi=summed&near=12.5&memory=500&op=plain&solver=cg&refine=0' +
      '&bridge=0.0125&links=3&way=descent&vs=method:heat,windows:1,t:auto,b:dirichlet,multi:exact,near:auto,memory:auto,op:relocate,solver:cholesky,refine:1,at:0.375',
  );
});

const CHANGES: { [Option in keyof Parameters]: readonly Parameters[Option][] } = {
  operator: OPERATOR.names,
  solver: LINEAR_SOLVER.names,
  timeStep: TIME_STEP_FACTORS,
  boundary: BOUNDARY.names,
  sources: MULTI_SOURCE.names,
  exactRadius: EXACT_RADIUS_EDGES,
  memory: MEMORY_LIMIT_MEBIBYTES,
};
const SCENES: readonly Partial<SceneState>[] = [
  ...Object.entries(CHANGES).flatMap(([option, values]) =>
    values.map((value) => ({ parameters: changed(option, value) })),
  ),
  ...([...UP.names, AUTOMATIC] as const).map((up) => ({ up })),
  ...UNITS.map((unit) => ({ unit })),
  ...SHOWN_UNITS.map((shownUnit) => ({ shownUnit })),
  ...TRIANGLES.map((triangles) => ({ triangles })),
  ...[...FILLS, null].map((fill) => ({ fill })),
  ...CUTS.map((cut) => ({ inside: { ...WHOLE, cut } })),
  ...INSIDE_NUMBERS.flatMap((name) => INSIDE_RANGES[name].map((value) => ({ inside: { ...WHOLE, [name]: value } }))),
  ...LIGHTS.map((lights) => ({ lights })),
  ...METHOD.names.map((method) => ({ method })),
  ...WINDOWS.map((windows) => ({ windows })),
  ...PATH_KIND.names.map((pathKind) => ({ pathKind })),
  ...VERTEX_FIELD.names.map((colorBy) => ({ colorBy })),
  ...SPEEDS.map((speed) => ({ animation: { ...STILL, speed } })),
];

function changed(option: string, value: unknown): Parameters {
  return { ...DEFAULT_PARAMETERS, [option]: value };
}

test('a link holds every choice and both ends of every range, and nothing else', () => {
  for (const scene of SCENES) {
    const state = { ...START, ...scene };
    expect(throughLink(state)).toEqual(state);
    const isDefault = JSON.stringify(state) === JSON.stringify(START);
    // Source and walker are of the triangles that a preset starts out with.
    const isOther = state.triangles !== START.triangles || state.fill !== START.fill;
    expect(encodeLink(state, START).split('&')).toHaveLength(isDefault ? 2 : isOther ? 5 : 3);
  }
});

/** Text that is no value of any key: nonsense, nothing, numbers that are none or far beyond every range, one cut short. */
const BROKEN: readonly string[] = ['!', 'NaN', '-1e99', '1e99', '12:0.2/', '%FF'];

/** Lengths are as large as a file has them. */
const LENGTHS: ReadonlySet<string> = new Set(['bridge', 'iso']);

test('a broken value of any key is named, and nothing else is lost', () => {
  const whole = 'v=1&m=bunny&s=12&w=3&t=10&look=gold&period=0.2&show=edges&cam=1,0,3,0,0,0&vs=t:2,at:0.3';
  const others = (key: string) => new URLSearchParams([...new URLSearchParams(whole)].filter(([name]) => name !== key));
  const lost: string[] = [];
  for (const { key } of KEYS) {
    const without = decodeLink(others(key).toString(), startOf);
    for (const value of BROKEN.filter((each) => each !== '1e99' || !LENGTHS.has(key))) {
      const { state, notices, refused, unknown } = decodeLink(`${others(key).toString()}&${key}=${value}`, startOf);
      const isNamed = refused.join() === `${key}=${value}`;
      const isSame = JSON.stringify(state) === JSON.stringify(without.state);
      if (!isNamed || !isSame || notices.length + unknown.length > 0) lost.push(`${key}=${value}`);
    }
  }
  expect(lost).toEqual([]);
});

test('a former name is read as what it is called now', () => {
  const decoded = decodeLink('#v=1&m=bunny&multi=superposed', startOf);
  expect([...decoded.notices, ...decoded.refused]).toEqual([]);
  expect(decoded.state?.parameters.sources).toBe('summed');
});

test('a preset with other settings can be set back to the defaults', () => {
  const start: SceneState = {
    ...START,
    parameters: { ...DEFAULT_PARAMETERS, timeStep: 2, exactRadius: 0 },
    pathKind: 'exact',
    refine: false,
  };
  const link = encodeLink(START, start);
  expect(link).toBe('v=1&m=bunny&t=auto&near=auto&refine=1&way=straight');
  expect(decodeLink(link, () => start)).toEqual({ state: START, notices: [], refused: [], unknown: [] });
});

test('an old link keeps its meaning', () => {
  const decoded = decodeLink('#v=1&m=bunny&s=1203,88:0.2/0.3/0.5&w=5521&t=1&b=neumann', startOf);
  expect([...decoded.notices, ...decoded.refused]).toEqual([]);
  expect(decoded.state?.method).toBe('heat');
  expect(decoded.state?.parameters).toMatchObject({ timeStep: 1, boundary: 'neumann' });
  expect(decoded.state?.sources).toEqual([{ vertex: 1203 }, { face: 88, weights: [0.2, 0.3, 0.5] }]);
});

test('a link to a file says the method that the file was opened with, and is by heat where it does not', () => {
  const mesh: MeshReference = { kind: 'file', name: 'cow.off', hash: '' };
  const state: SceneState = { ...emptyScene(mesh), method: 'auto' };
  expect(encodeLink(state, emptyScene(mesh))).toBe('v=1&m=file&name=cow.off&hash=&method=auto');
  expect(throughLink(state).method).toBe('auto');
  expect(decodeLink('#v=1&m=file&name=cow.off', startOf).state?.method).toBe('heat');
});

test('a scene without sources and walker differs from an unchanged one', () => {
  const state = { ...START, sources: [], walker: null };
  expect(throughLink(state)).toEqual(state);
});

test('stripes that change nothing stay so', () => {
  const state: SceneState = { ...START, style: { ...START.style, maps: [] } };
  expect(encodeLink(state, START)).toContain('maps=none');
  expect(throughLink(state).style.maps).toEqual([]);
});

test('a file name with special characters survives the link, with its hash', () => {
  const mesh: MeshReference = { kind: 'file', name: 'my & mesh=1 ä+#.obj', hash: 'ab'.repeat(32) };
  const state = { ...emptyScene(mesh), sources: [{ vertex: 3 }] };
  expect(throughLink(state)).toEqual(state);
});

test('rounding happens once: a link made from a link is equal', () => {
  const state: SceneState = {
    ...START,
    sources: [
      { face: 5, weights: [1 / 3, 1 / 3, 1 / 3] },
      // Each rounded by itself, they would miss 1, and be others once they are read.
      { face: 6, weights: [0.50004, 0.25004, 0.24992] },
    ],
    camera: [Math.PI, Math.E, Math.SQRT2, 1e-9, 0, 0],
  };
  const link = encodeLink(state, START);
  const read = throughLink(state);
  expect(encodeLink(read, START)).toBe(link);
  expect(read.sources[1]).toEqual({ face: 6, weights: [0.5001, 0.25, 0.2499] });
});

test('that the sources of a file are still to be chosen is not that there are none', () => {
  const start = emptyScene({ kind: 'file', name: 'cow.off', hash: '' });
  expect(encodeLink(start, start)).not.toContain('s=');
  expect(encodeLink({ ...start, sources: [] }, start)).toContain('&s=none');
});

test('unknown keys are ignored, and named', () => {
  const decoded = decodeLink('#v=1&m=bunny&colour=red&kiosk=1', startOf);
  expect(decoded).toEqual({ state: START, notices: [], refused: [], unknown: ['colour'] });
});

for (const [broken, key] of [
  ['s=12,abc', 's'],
  ['s=4:0.9/0.9/0.9', 's'],
  ['w=-3', 'w'],
  ['t=0', 't'],
  ['t=', 't'],
  ['t=automatic', 't'],
  ['b=robin', 'b'],
  ['multi=both', 'multi'],
  ['near=-1', 'near'],
  ['near=65', 'near'],
  ['op=tufted', 'op'],
  ['solver=lu', 'solver'],
  ['way=home', 'way'],
  ['method=dijkstra', 'method'],
  ['windows=3', 'windows'],
  ['windows=all', 'windows'],
  ['refine=yes', 'refine'],
  ['up=w', 'up'],
  ['up=+y', 'up'],
  ['s=12@', 's'],
  ['s=12@-1', 's'],
  ['s=12@1@2', 's'],
  ['s=12@1.2.3', 's'],
  ['s=12@1e999', 's'],
  ['w=12@1', 'w'],
  ['cam=1,2,3', 'cam'],
  ['clip=-1', 'clip'],
  ['time=-0.1', 'time'],
  ['speed=0', 'speed'],
  ['play=yes', 'play'],
  ['live=2', 'live'],
  ['cam=1,2,-3,0,0,0', 'cam'],
  ['look=plaid', 'look'],
  ['ramp=toString', 'ramp'],
  ['stripe=red', 'stripe'],
  ['width=2', 'width'],
  ['period=NaN', 'period'],
  ['p=0,x', 'p'],
]) {
  test(`the broken value ${broken} falls back and is named`, () => {
    const decoded = decodeLink(`#v=1&m=bunny&${broken}`, startOf);
    expect(decoded.state).toEqual(START);
    expect(decoded.refused).toHaveLength(1);
    expect(decoded.refused[0]).toContain(`${key}=`);
  });
}

test('several broken values are named in one notice', () => {
  const { refused } = decodeLink('#v=1&m=bunny&look=plaid&width=2', startOf);
  expect(refused.toSorted()).toEqual(['look=plaid', 'width=2']);
  expect(String(refusedWords(refused))).toBe(`The link's ${refused.join(' and ')} are invalid; the defaults are used.`);
  expect(String(refusedWords(['t=0']))).toBe("The link's t=0 is invalid; the default is used.");
});

test('escapes that are none of text are named as they stand, and nothing else is lost', () => {
  for (const broken of ['%E0%A4%A', '%', 'colour=%FF', 'name=%E0%A4', 'kiosk=2', 'hash=50%', 'm=%FF']) {
    const { state, refused, unknown } = decodeLink(`#v=1&m=bunny&s=3&${broken}`, startOf);
    expect({ state, refused, unknown }, broken).toEqual({
      state: { ...START, sources: [{ vertex: 3 }] },
      refused: [broken],
      unknown: [],
    });
  }
  expect(decodeLink('#%E0%A4%A', startOf)).toEqual({ state: null, notices: [], refused: ['%E0%A4%A'], unknown: [] });
  // A name by hand may have a percent sign, and so may an address.
  expect(decodeLink('#m=file&name=100%.obj', startOf)).toMatchObject({
    state: { mesh: { name: '100%.obj' } },
    refused: [],
  });
});

test('what the mesh of a link does not have is named', () => {
  const tapes = [{ points: [{ vertex: 1 }, { vertex: 2 }], closed: false }];
  const wanted: SceneState = { ...START, parts: [0, 7], hidden: [9], shownUnit: 'km', tapes, sources: [{ vertex: 5 }] };
  expect(refusedBy(wanted, wanted)).toEqual([]);
  const opened = { ...wanted, parts: [0], hidden: [], shownUnit: null, tapes: [], walker: { vertex: 4 } };
  expect(refusedBy(wanted, opened)).toEqual(['p=0,7', 'w=99', 'shown=km', 'tape=1,2', 'hide=9']);
  // What is for tetrahedra alone, and for surfaces alone.
  const cut: SceneState = { ...wanted, inside: { ...wanted.inside, cut: 'plane' } };
  expect([refusedBy(cut, wanted), refusedBy(cut, cut)]).toEqual([['cut=plane'], []]);
  const girth: SceneState = { ...wanted, girth: { turn: 0, tilt: 90, place: 0 } };
  expect([refusedBy(girth, wanted), refusedBy(girth, girth)]).toEqual([['girth=0,90,0'], []]);
  // Where a link names no walker, the page may choose one.
  expect(refusedBy({ ...wanted, walker: null }, wanted)).toEqual([]);
});

test('places of a preset are left where it has other triangles, and what a link says itself stays', () => {
  const other = decodeLink('#v=1&m=bunny&triangles=500', startOf).state;
  expect(other).toMatchObject({ sources: [], walker: undefined, triangles: 500 });
  expect(other?.sources).toBe(UNCHOSEN);
  const own = decodeLink('#v=1&m=bunny&fill=5000&s=3&w=none', startOf).state;
  expect(own).toMatchObject({ sources: [{ vertex: 3 }], walker: null });
  expect(decodeLink('#v=1&m=bunny&p=0', startOf).state?.sources).toBe(START.sources);
  expect(decodeLink('#v=1&m=images&triangles=500', startOfAny).state?.decals).toEqual([]);
  expect(decodeLink('#v=1&m=broken&triangles=500', startOfAny).state?.sets).toEqual([]);
});

test('another version gives a notice', () => {
  expect(decodeLink('#v=2&m=bunny', startOf).notices).toHaveLength(1);
});

test('a fragment without an existing mesh is not a scene', () => {
  expect(decodeLink('', startOf)).toEqual({ state: null, notices: [], refused: [], unknown: [] });
  expect(decodeLink('#v=1&open=look&campaign=3', startOf)).toEqual({
    state: null,
    notices: [],
    refused: [],
    unknown: [],
  });
  const { state, notices } = decodeLink('#v=1&m=unicorn', startOf);
  expect(state).toBeNull();
  expect(notices.map(String)).toEqual(['There is no preset “unicorn”; the first preset is shown.']);
});

function told(fragment: string): string[] {
  return decodeLink(fragment, startOf).notices.map(String);
}

test('what a link says of a mesh that it does not name, or that does not exist, is named', () => {
  expect(told('#s=3')).toEqual([
    "The link's s=3 is left out: it is for a mesh that the link does not name, or that does not exist.",
  ]);
  expect(told('#v=1&m=unicorn&w=7&s=3')).toEqual([
    'There is no preset “unicorn”; the first preset is shown.',
    "The link's s=3 and w=7 are left out: they are for a mesh that the link does not name, or that does not exist.",
  ]);
});

const ADDRESS = 'https://models.example/a%20b/cow.obj?token=a+b&part=%231';

test('an address survives the link with what is set for its mesh, and alone it is a scene', () => {
  const mesh: MeshReference = { kind: 'address', address: ADDRESS, path: 'set & more/cow.obj', hash: 'ab'.repeat(32) };
  const state = { ...emptyScene(mesh), sources: [{ vertex: 3 }] };
  expect(throughLink(state)).toEqual(state);
  expect(encodeLink(state, emptyScene(mesh))).toMatch(/^v=1&model=https:\/\/models\.example\/a%2520b\/cow\.obj/);
  expect(decodeLink('#model=https://models.example/cow.obj', startOf)).toEqual({
    state: emptyScene({ kind: 'address', address: 'https://models.example/cow.obj', path: '', hash: '' }),
    notices: [],
    refused: [],
    unknown: [],
  });
});

test('an address in a link may be written as it is', () => {
  const address = 'https://models.example/a%20b/c++.obj?raw=1';
  const { state } = decodeLink(`#model=${address}&s=3`, startOf);
  expect(state).toMatchObject({ mesh: { kind: 'address', address }, sources: [{ vertex: 3 }] });
});

for (const model of [
  'javascript:alert(1)',
  'file:///etc/passwd',
  'data:text/plain,OFF',
  '//models.example/a.obj',
  'cow.obj',
  '',
]) {
  test(`the address ${model || 'that is empty'} is refused with a notice`, () => {
    const { state, notices } = decodeLink(`#v=1&model=${encodeURIComponent(model)}`, startOf);
    expect(state).toBeNull();
    expect(notices).toHaveLength(1);
    expect(String(notices[0])).toContain(`model=${model} is no http or https address`);
  });
}
