/** What pointer and keyboard do to sources and walker. */
import type { MeshPoint } from '../protocol';
import { UP, type Up } from '../wasm/contract';
import type { Inside } from './inside';
import { type Scene, upOf, withOffset } from './scene';

export function setSource(scene: Scene, point: MeshPoint): void {
  scene.place({ sources: [point], selected: -1 });
}

export function addSource(scene: Scene, point: MeshPoint): void {
  scene.place({ sources: [...scene.state.sources, point], selected: -1 });
}

export function moveSource(scene: Scene, index: number, point: MeshPoint, gesture: object): void {
  const { sources } = scene.state;
  const source = withOffset(point, sources[index].offset ?? 0);
  scene.place({ sources: sources.with(index, source), selected: index }, gesture);
}

/** Sets the initial distance of a source, in the unit of the file. */
export function setInitialDistance(scene: Scene, index: number, offset: number, gesture: object): void {
  const { sources } = scene.state;
  scene.place({ sources: sources.with(index, withOffset(sources[index], offset)) }, gesture);
}

export function removeSelected(scene: Scene): boolean {
  const { sources, selected } = scene.state;
  if (selected < 0) return false;
  scene.place({ sources: sources.toSpliced(selected, 1), selected: -1 });
  return true;
}

export function sendWalker(scene: Scene, point: MeshPoint): void {
  scene.place({ walker: point });
}

/** Changes how the inside is looked into. */
export function lookInto(scene: Scene, change: Partial<Inside>, gesture: object): void {
  scene.place({ inside: { ...scene.state.inside, ...change } }, gesture);
}

/** Draws the next axis upward, of a mesh that by itself has `upright` there. */
export function turnUp(scene: Scene, upright: Up): void {
  const { names } = UP;
  scene.place({ up: names[(names.indexOf(upOf(scene.state, upright)) + 1) % names.length] });
}
