import { pack } from '../tools/glb.mjs';
/** Meshes made in code, and their files. */

export interface Mesh {
  positions: [number, number, number][];
  triangles: [number, number, number][];
}

/** A unit sphere of rings and sectors, closed, `rings × 2 rings` quads. */
export function sphere(rings: number, centre: [number, number, number] = [0, 0, 0]): Mesh {
  const sectors = 2 * rings;
  const at = (theta: number, phi: number): [number, number, number] => [
    centre[0] + Math.sin(theta) * Math.cos(phi),
    centre[1] + Math.cos(theta),
    centre[2] - Math.sin(theta) * Math.sin(phi),
  ];
  const positions = [at(0, 0)];
  for (let i = 1; i < rings; i++) {
    for (let j = 0; j < sectors; j++) positions.push(at((Math.PI * i) / rings, (2 * Math.PI * j) / sectors));
  }
  positions.push(at(Math.PI, 0));
  const south = positions.length - 1;
  const vertex = (ring: number, sector: number) => 1 + (ring - 1) * sectors + (sector % sectors);
  const triangles: Mesh['triangles'] = [];
  for (let j = 0; j < sectors; j++) {
    triangles.push([0, vertex(1, j), vertex(1, j + 1)]);
    for (let i = 1; i < rings - 1; i++) {
      const [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
      triangles.push([a, b, c], [a, c, d]);
    }
    triangles.push([south, vertex(rings - 1, j + 1), vertex(rings - 1, j)]);
  }
  return { positions, triangles };
}

/** The unit square in the plane z = 0, `n × n` squares cut alternately; vertex `i + (n + 1) j` lies at (i, j) / n. */
export function grid(n: number): Mesh {
  const positions: Mesh['positions'] = [];
  const triangles: Mesh['triangles'] = [];
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) positions.push([i / n, j / n, 0]);
  }
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const a = i + (n + 1) * j;
      const [b, c, d] = [a + 1, a + n + 2, a + n + 1];
      if ((i + j) % 2 === 0) triangles.push([a, b, c], [a, c, d]);
      else triangles.push([a, b, d], [b, c, d]);
    }
  }
  return { positions, triangles };
}

/** Meshes one after another, each as an object with a name. */
export function obj(meshes: Record<string, Mesh>): string {
  const lines: string[] = [];
  let first = 1;
  for (const [name, { positions, triangles }] of Object.entries(meshes)) {
    lines.push(`o ${name}`, ...positions.map((p) => `v ${p.join(' ')}`));
    for (const triangle of triangles) lines.push(`f ${triangle.map((index) => index + first).join(' ')}`);
    first += positions.length;
  }
  return `${lines.join('\n')}\n`;
}

export function off({ positions, triangles }: Mesh): string {
  const header = `OFF\n${positions.length} ${triangles.length} 0`;
  const lines = [header, ...positions.map((p) => p.join(' ')), ...triangles.map((t) => `3 ${t.join(' ')}`)];
  return `${lines.join('\n')}\n`;
}

/** A glTF document and its one buffer. */
export function gltf(mesh: Mesh, uri?: string): { json: string; bin: Buffer } {
  const positions = Float32Array.from(mesh.positions.flat());
  const indices = Uint32Array.from(mesh.triangles.flat());
  const bin = Buffer.concat([Buffer.from(positions.buffer), Buffer.from(indices.buffer)]);
  const bound = (pick: (...values: number[]) => number) =>
    [0, 1, 2].map((k) =>
      Math.fround(mesh.positions.reduce((best, p) => pick(best, Math.fround(p[k])), Math.fround(mesh.positions[0][k]))),
    );
  const document = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'ball', mesh: 0 }],
    meshes: [{ name: 'ball', primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: mesh.positions.length,
        type: 'VEC3',
        min: bound(Math.min),
        max: bound(Math.max),
      },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: positions.byteLength },
      { buffer: 0, byteOffset: positions.byteLength, byteLength: indices.byteLength },
    ],
    buffers: [{ byteLength: bin.length, ...(uri ? { uri } : {}) }],
  };
  return { json: JSON.stringify(document), bin };
}

export function glb(mesh: Mesh): Buffer {
  const { json, bin } = gltf(mesh);
  return pack(json, bin);
}
