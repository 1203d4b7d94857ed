/** What pointer and keyboard do to sources and walker. */
import type { SurfacePoint } from '../protocol';
import { UP, type Up } from '../wasm/contract';
import { type Scene, upOf, withOffset } from './scene';

export function setSource(scene: Scene, point: SurfacePoint): void {
  scene.place({ sources: [point], selected: -1 });
}

export function addSource(scene: Scene, point: SurfacePoint): void {
  scene.place({ sources: [...scene.state.sources, point], selected: -1 });
}

export function moveSource(scene: Scene, index: number, point: SurfacePoint, gesture: object): void {
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

export function sendWalker(scene: Scene, point: SurfacePoint): void {
  scene.place({ walker: point });
}

/** Draws the next axis upward, of a mesh that by itself has `upright` there. */
export function turnUp(scene: Scene, upright: Up): void {
  const { names } = UP;
  scene.place({ up: names[(names.indexOf(upOf(scene.state, upright)) + 1) % names.length] });
}
