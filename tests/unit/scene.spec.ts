import { expect, test } from '@playwright/test';
import { LEVEL } from '../../web/state/ground';
import { ofModel } from '../../web/length';
import { moveSource, setInitialDistance } from '../../web/state/edit';
import { Scene } from '../../web/state/history';
import { emptyScene } from '../../web/state/scene';

const fresh = () => new Scene({ ...emptyScene({ kind: 'preset', id: 'bunny' }), sources: [{ vertex: 1 }] });

test('undo and redo restore sources and walker', () => {
  const scene = fresh();
  scene.edit({ sources: [{ vertex: 2 }] });
  scene.edit({ walker: { vertex: 9 } });
  expect(scene.undo()).toBe(true);
  expect(scene.state).toMatchObject({ sources: [{ vertex: 2 }], walker: undefined });
  expect(scene.undo()).toBe(true);
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
  expect(scene.undo()).toBe(false);
  expect(scene.redo()).toBe(true);
  expect(scene.redo()).toBe(true);
  expect(scene.state).toMatchObject({ sources: [{ vertex: 2 }], walker: { vertex: 9 } });
  expect(scene.redo()).toBe(false);
});

test('a drag is one undo step', () => {
  const scene = fresh();
  const drag = {};
  for (const vertex of [2, 3, 4]) scene.edit({ sources: [{ vertex }] }, drag);
  scene.edit({ sources: [{ vertex: 5 }] }, {});
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 4 }]);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
});

test('a moved source keeps its initial distance, and undo restores the old one', () => {
  const scene = fresh();
  setInitialDistance(scene, 0, ofModel(0.5), {});
  moveSource(scene, 0, { vertex: 7 }, {});
  expect(scene.state.sources).toEqual([{ vertex: 7, offset: 0.5 }]);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 1, offset: 0.5 }]);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
});

test('typing an initial distance is one undo step, and 0 is not stored', () => {
  const scene = fresh();
  const typing = {};
  for (const offset of [1, 12, 125]) setInitialDistance(scene, 0, ofModel(offset), typing);
  expect(scene.state.sources).toEqual([{ vertex: 1, offset: 125 }]);
  setInitialDistance(scene, 0, ofModel(0), {});
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
  scene.undo();
  scene.undo();
  expect(scene.canUndo).toBe(false);
});

test('a new change clears the redo history', () => {
  const scene = fresh();
  scene.edit({ sources: [{ vertex: 2 }] });
  scene.undo();
  scene.edit({ sources: [{ vertex: 3 }] });
  expect(scene.canRedo).toBe(false);
});

test('undo goes back over settings of the solver, style and overlays, and leaves the camera', () => {
  const scene = fresh();
  const { parameters, style, overlays } = scene.state;
  const drag = {};
  for (const timeStep of [2, 3, 4]) scene.edit({ parameters: { ...parameters, timeStep } }, drag);
  scene.edit({ method: 'exact' });
  scene.edit({ style: { ...style, period: 0.2 } });
  scene.edit({ overlays: ['edges'] });
  scene.set({ camera: [1, 0, 3, 0, 0, 0] });
  scene.undo();
  scene.undo();
  expect(scene.state).toMatchObject({ method: 'exact', style, overlays });
  scene.undo();
  scene.undo();
  expect(scene.state.parameters).toBe(parameters);
  expect(scene.state.camera).toEqual([1, 0, 3, 0, 0, 0]);
  expect(scene.canUndo).toBe(false);
});

test('what is withdrawn is no step of undo, nor is what led there', () => {
  const scene = fresh();
  scene.edit({ sources: [{ vertex: 2 }] });
  scene.edit({ method: 'exact' });
  scene.edit({ method: 'heat' });
  scene.withdraw({ method: 'exact' });
  scene.undo();
  expect(scene.state).toMatchObject({ method: 'heat', sources: [{ vertex: 2 }] });
  scene.withdraw({ method: 'exact' });
  expect(scene.canRedo).toBe(false);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
});

test('another mesh clears the undo history', () => {
  const scene = fresh();
  scene.edit({ sources: [{ vertex: 2 }] });
  scene.load(emptyScene({ kind: 'preset', id: 'teapot' }));
  expect(scene.canUndo).toBe(false);
  expect(scene.undo()).toBe(false);
});

test('the selection is always a valid source', () => {
  const scene = fresh();
  scene.edit({ sources: [{ vertex: 1 }, { vertex: 2 }] });
  scene.set({ selected: 1 });
  scene.undo();
  expect(scene.state.selected).toBe(-1);
});

test('listeners get both states until they unsubscribe', () => {
  const scene = fresh();
  const heard: number[] = [];
  const leave = scene.subscribe((state, previous) => heard.push(previous.sources.length, state.sources.length));
  scene.edit({ sources: [] });
  leave();
  scene.undo();
  expect(heard).toEqual([1, 0]);
});

const painted = (bytes: number) => ({ ground: { ...LEVEL, faces: new Uint8Array(bytes) } });

function undoAll(scene: Scene): number {
  let steps = 0;
  while (scene.undo()) steps += 1;
  return steps;
}

test('undo holds the newest steps that fit into 64 MiB, and always the last', () => {
  const scene = fresh();
  for (let stroke = 0; stroke < 100; stroke++) scene.edit(painted(2 ** 20));
  // Beside the strokes there is a little more.
  expect(undoAll(scene)).toBe(63);
  expect(scene.state.ground.faces).toHaveLength(2 ** 20);
  scene.edit(painted(2 ** 27));
  scene.edit({ ground: LEVEL });
  expect(undoAll(scene)).toBe(1);
});

test('what steps of undo share counts once, and there are no more than a thousand', () => {
  const scene = fresh();
  scene.edit(painted(2 ** 25));
  for (let links = 0; links < 100; links++) scene.edit({ links });
  expect(undoAll(scene)).toBe(101);
  for (let links = 0; links < 2000; links++) scene.edit({ links });
  expect(undoAll(scene)).toBe(1000);
});
