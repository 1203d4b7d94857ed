import { expect, test } from '@playwright/test';
import { decodeLink, encodeLink } from '../../web/link';
import { findLook } from '../../web/looks';
import { emptyScene, type MeshReference, type SceneState } from '../../web/scene';

const START: SceneState = {
  ...emptyScene({ kind: 'preset', id: 'bunny' }),
  sources: [{ vertex: 7 }],
  walker: { vertex: 99 },
};

const startOf = (mesh: MeshReference): SceneState | null => {
  if (mesh.kind === 'file') return emptyScene(mesh);
  return mesh.id === 'bunny' ? START : null;
};

function throughLink(state: SceneState): SceneState {
  const start = startOf(state.mesh);
  if (!start) throw new Error('no such preset');
  const decoded = decodeLink(`#${encodeLink(state, start)}`, startOf);
  if (!decoded) throw new Error('the link names no mesh');
  expect(decoded.notices).toEqual([]);
  return decoded.state;
}

test('an untouched preset needs nothing but its name', () => {
  expect(encodeLink(START, START)).toBe('v=1&m=bunny');
});

test('everything that was changed survives the link', () => {
  const neon = findLook('neon');
  if (!neon) throw new Error('no neon');
  const state: SceneState = {
    ...START,
    parts: [0, 2],
    sources: [{ vertex: 1203 }, { face: 88, weights: [0.2, 0.3, 0.5] }],
    walker: { vertex: 5521 },
    parameters: { timeFactor: 2.5, boundary: 'average' },
    camera: [0.5, -0.25, 3, 0.125, 0, -1],
    look: { ...neon, width: 0.35, ramp: 'viridis', stripe: '#12ab9f' },
  };
  expect(throughLink(state)).toEqual(state);
  expect(encodeLink(state, START)).toContain('s=1203,88:0.2/0.3/0.5&w=5521&t=2.5&b=average');
});

test('a scene without sources and walker is not the same as an untouched one', () => {
  const state = { ...START, sources: [], walker: null };
  expect(throughLink(state)).toEqual(state);
});

test('a file is named with its hash, whatever its name holds', () => {
  const mesh: MeshReference = { kind: 'file', name: 'my & mesh=1 ä+#.obj', hash: 'ab'.repeat(32) };
  const state = { ...emptyScene(mesh), sources: [{ vertex: 3 }] };
  expect(throughLink(state)).toEqual(state);
});

test('rounding happens once: a link made from a link is the same', () => {
  const state: SceneState = {
    ...START,
    sources: [{ face: 5, weights: [1 / 3, 1 / 3, 1 / 3] }],
    camera: [Math.PI, Math.E, Math.SQRT2, 1e-9, 0, 0],
  };
  const link = encodeLink(state, START);
  expect(encodeLink(throughLink(state), START)).toBe(link);
});

test('unknown keys are ignored', () => {
  const decoded = decodeLink('#v=1&m=bunny&colour=red&kiosk=1', startOf);
  expect(decoded).toEqual({ state: START, notices: [] });
});

for (const [broken, key] of [
  ['s=12,abc', 's'],
  ['s=4:0.9/0.9/0.9', 's'],
  ['w=-3', 'w'],
  ['t=0', 't'],
  ['t=', 't'],
  ['b=robin', 'b'],
  ['cam=1,2,3', 'cam'],
  ['cam=1,2,-3,0,0,0', 'cam'],
  ['look=plaid', 'look'],
  ['ramp=toString', 'ramp'],
  ['stripe=red', 'stripe'],
  ['width=2', 'width'],
  ['period=NaN', 'period'],
  ['p=0,x', 'p'],
]) {
  test(`the broken value ${broken} falls back with a notice`, () => {
    const decoded = decodeLink(`#v=1&m=bunny&${broken}`, startOf);
    expect(decoded?.state).toEqual(START);
    expect(decoded?.notices).toHaveLength(1);
    expect(decoded?.notices[0]).toContain(`${key}=`);
  });
}

test('another version is told', () => {
  expect(decodeLink('#v=2&m=bunny', startOf)?.notices).toHaveLength(1);
});

test('a fragment without a mesh that exists is no scene', () => {
  expect(decodeLink('', startOf)).toBeNull();
  expect(decodeLink('#v=1&s=3', startOf)).toBeNull();
  expect(decodeLink('#v=1&m=unicorn', startOf)).toBeNull();
});
