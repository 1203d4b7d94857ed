/** Entries of the list of sources. */
import type { MeshPoint, OpenedMesh } from '../../protocol';
import { type ModelLength, ofModel } from '../../length';
import type { SceneState } from '../../state/scene';
import { setName } from '../words';
import { t, type Words } from '../../texts';

/** What a row of the list shows. */
interface Entry {
  title: Words;
  offset: ModelLength;
  /** A place of it to look at. */
  middle: MeshPoint;
}

const NOTHING: Entry = { title: '', offset: ofModel(0), middle: { vertex: -1 } };

export function entryAt({ sources, sets }: SceneState, index: number, opened?: OpenedMesh): Entry {
  const source = sources[index];
  if (source) {
    return { title: pointName(source), offset: ofModel(source.offset ?? 0), middle: source };
  }
  const set = sets.at(index - sources.length);
  const middle = set?.points[Math.floor(set.points.length / 2)];
  if (!set || !middle) return NOTHING;
  return { title: setName(set, opened), offset: ofModel(set.offset), middle };
}

function pointName(point: MeshPoint): Words {
  if ('vertex' in point) return t`Vertex ${point.vertex}`;
  return 'face' in point ? t`Triangle ${point.face}` : t`Tetrahedron ${point.tetrahedron}`;
}
