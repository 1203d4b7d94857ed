/** What pointer and keyboard do to sources and walker. */
import type { MeshPoint, Source } from '../protocol';
import { UP, type Up } from '../wasm/contract';
import type { Inside } from './inside';
import type { Scene } from './history';
import type { ModelLength } from '../length';
import { upOf } from './scene';
import { isSamePlace, onceEach, type SourceSet, withOffset } from './sources';
import { entry } from './entry';

export function setSource(scene: Scene, point: MeshPoint): void {
  scene.edit({ sources: [point], sets: [], selected: -1 });
}

/** False: a place that is a source already, which is selected then. */
export function addSource(scene: Scene, source: Source): boolean {
  const before = scene.state.sources;
  const sources = onceEach([...before, source]);
  const index = sources.findIndex((other, i) => other !== before[i]);
  if (index >= 0) {
    scene.edit({ sources, selected: sources.length > before.length ? -1 : index });
    return true;
  }
  scene.set({ selected: before.findIndex((other) => isSamePlace(other, source)) });
  return false;
}

export function moveSource(scene: Scene, index: number, point: MeshPoint, gesture: object): void {
  const { sources } = scene.state;
  const source = withOffset(point, sources[index]?.offset ?? 0);
  scene.edit({ sources: sources.with(index, source), selected: index }, gesture);
}

/** Adds a set, which is selected then. */
export function addSet(scene: Scene, set: SourceSet, gesture: object | null = null): void {
  const { sources, sets } = scene.state;
  scene.edit({ sets: [...sets, set], selected: sources.length + sets.length }, gesture);
}

/** Puts a set in the place of another one. What is selected stays so. */
export function replaceSet(scene: Scene, before: SourceSet, set: SourceSet, gesture: object | null = null): void {
  scene.edit({ sets: scene.state.sets.map((other) => (other === before ? set : other)) }, gesture);
}

/** The set that is selected, if one is. */
export function selectedSet(scene: Scene): SourceSet | undefined {
  const { sources, sets, selected } = scene.state;
  return selected < sources.length ? undefined : sets[selected - sources.length];
}

/** Sets the initial distance of an entry of the list, in the unit of the file. */
export function setInitialDistance(scene: Scene, index: number, offset: ModelLength, gesture: object): void {
  const { sources, sets } = scene.state;
  const source = sources[index];
  const set = sets[index - sources.length];
  if (source) scene.edit({ sources: sources.with(index, withOffset(source, offset)) }, gesture);
  else if (set) replaceSet(scene, set, { ...set, offset }, gesture);
}

/** Removes an entry of the list. */
export function removeEntry(scene: Scene, index: number): void {
  const { sources, sets } = scene.state;
  if (index < sources.length) scene.edit({ sources: sources.toSpliced(index, 1), selected: -1 });
  else scene.edit({ sets: sets.toSpliced(index - sources.length, 1), selected: -1 });
}

export function removeSelected(scene: Scene): boolean {
  const { selected } = scene.state;
  if (selected < 0) return false;
  removeEntry(scene, selected);
  return true;
}

export function sendWalker(scene: Scene, point: MeshPoint): void {
  scene.edit({ walker: point });
}

/** Changes how the inside is looked into. */
export function lookInto(scene: Scene, change: Partial<Inside>, gesture: object): void {
  scene.edit({ inside: { ...scene.state.inside, ...change } }, gesture);
}

/** Draws the next axis upward, of a mesh that by itself has `upright` there. */
export function turnUp(scene: Scene, upright: Up): void {
  const { names } = UP;
  scene.edit({ up: entry(names, (names.indexOf(upOf(scene.state, upright)) + 1) % names.length) });
}
