import { expect, test } from '@playwright/test';
import { moveSource, startSourceFrom } from '../../web/state/edit';
import { DEFAULT_PARAMETERS, emptyScene, Scene } from '../../web/state/scene';

const fresh = () => new Scene({ ...emptyScene({ kind: 'preset', id: 'bunny' }), sources: [{ vertex: 1 }] });

test('undo and redo go over sources and walker', () => {
  const scene = fresh();
  scene.place({ sources: [{ vertex: 2 }] });
  scene.place({ walker: { vertex: 9 } });
  expect(scene.undo()).toBe(true);
  expect(scene.state).toMatchObject({ sources: [{ vertex: 2 }], walker: null });
  expect(scene.undo()).toBe(true);
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
  expect(scene.undo()).toBe(false);
  expect(scene.redo()).toBe(true);
  expect(scene.redo()).toBe(true);
  expect(scene.state).toMatchObject({ sources: [{ vertex: 2 }], walker: { vertex: 9 } });
  expect(scene.redo()).toBe(false);
});

test('a drag is one step', () => {
  const scene = fresh();
  const drag = {};
  for (const vertex of [2, 3, 4]) scene.place({ sources: [{ vertex }] }, drag);
  scene.place({ sources: [{ vertex: 5 }] }, {});
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 4 }]);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
});

test('a source keeps its starting value when it is moved, and undo takes the value back', () => {
  const scene = fresh();
  startSourceFrom(scene, 0, 0.5, {});
  moveSource(scene, 0, { vertex: 7 }, {});
  expect(scene.state.sources).toEqual([{ vertex: 7, offset: 0.5 }]);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 1, offset: 0.5 }]);
  scene.undo();
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
});

test('typing a starting value is one step, and 0 leaves no trace', () => {
  const scene = fresh();
  const typing = {};
  for (const offset of [1, 12, 125]) startSourceFrom(scene, 0, offset, typing);
  expect(scene.state.sources).toEqual([{ vertex: 1, offset: 125 }]);
  startSourceFrom(scene, 0, 0, {});
  expect(scene.state.sources).toEqual([{ vertex: 1 }]);
  scene.undo();
  scene.undo();
  expect(scene.canUndo).toBe(false);
});

test('a new step forgets what was undone', () => {
  const scene = fresh();
  scene.place({ sources: [{ vertex: 2 }] });
  scene.undo();
  scene.place({ sources: [{ vertex: 3 }] });
  expect(scene.canRedo).toBe(false);
});

test('undo leaves camera, look and parameters alone', () => {
  const scene = fresh();
  scene.place({ sources: [{ vertex: 2 }] });
  scene.set({ camera: [1, 0, 3, 0, 0, 0], parameters: { ...DEFAULT_PARAMETERS, timeFactor: 4 } });
  scene.undo();
  expect(scene.state.camera).toEqual([1, 0, 3, 0, 0, 0]);
  expect(scene.state.parameters.timeFactor).toBe(4);
});

test('another mesh ends the history', () => {
  const scene = fresh();
  scene.place({ sources: [{ vertex: 2 }] });
  scene.load(emptyScene({ kind: 'preset', id: 'teapot' }));
  expect(scene.canUndo).toBe(false);
  expect(scene.undo()).toBe(false);
});

test('a selection never points past the sources', () => {
  const scene = fresh();
  scene.place({ sources: [{ vertex: 1 }, { vertex: 2 }] });
  scene.set({ selected: 1 });
  scene.undo();
  expect(scene.state.selected).toBe(-1);
});

test('listeners hear both states until they leave', () => {
  const scene = fresh();
  const heard: number[] = [];
  const leave = scene.subscribe((state, previous) => heard.push(previous.sources.length, state.sources.length));
  scene.place({ sources: [] });
  leave();
  scene.undo();
  expect(heard).toEqual([1, 0]);
});
