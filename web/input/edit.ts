/** What hands and keys do to sources and walker. */
import type { SurfacePoint } from '../protocol';
import type { Scene } from '../scene';

export function setSource(scene: Scene, point: SurfacePoint): void {
  scene.place({ sources: [point], selected: -1 });
}

export function addSource(scene: Scene, point: SurfacePoint): void {
  scene.place({ sources: [...scene.state.sources, point], selected: -1 });
}

export function moveSource(scene: Scene, index: number, point: SurfacePoint, gesture: object): void {
  scene.place({ sources: scene.state.sources.with(index, point), selected: index }, gesture);
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
