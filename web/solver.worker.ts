/** The worker: the solver's wasm module behind the interface of protocol.ts. */
import { expose, transfer } from 'comlink';
import type {
  BuildReport,
  DistanceField,
  DrawMesh,
  MeshInput,
  OpenedMesh,
  Parameters,
  ProgressListener,
  SolverApi,
  SurfacePath,
  SurfacePoint,
  Timings,
} from './protocol';
import initialise, * as wasm from './wasm/solver/heatwalk_worker.js';
import wasmAddress from './wasm/solver/heatwalk_worker_bg.wasm?url';

/** Shares of reading, building and factoring in the time that opening takes, for the progress bar. */
const BUILD_FROM = 0.1;
const FACTOR_FROM = 0.3;

/** Calls that arrive while the module is still being compiled wait for it. */
const ready = initialise({ module_or_path: wasmAddress });

interface Current {
  solver: wasm.Solver;
  timings: Timings;
}

let current: Current | undefined;

const api: SolverApi = {
  async open(input, parts, parameters, progress) {
    const { memory } = await ready;
    const hash = await hashOf(input);
    const clock = stopwatch();
    progress({ stage: 'Reading', fraction: 0, vertices: 0 });
    const file = read(input);
    try {
      const readMs = clock();
      progress({ stage: 'Welding', fraction: BUILD_FROM, vertices: 0 });
      const names = file.part_names();
      const triangles = file.part_triangles();
      const walked = parts.length > 0 ? parts : names.map((_, index) => index);
      const surface = file.surface(Uint32Array.from(walked));
      try {
        const report = reportOf(surface);
        const buildMs = clock();
        const solver = factor(surface, parameters, report.vertices, progress);
        const timings: Timings = { readMs, buildMs, precomputeMs: clock() };
        current?.solver.free();
        current = { solver, timings };
        const opened: OpenedMesh = {
          name: nameOf(input),
          hash,
          parts: names.map((name, index) => ({ name, triangles: triangles[index] ?? 0 })),
          walked: [...walked],
          surface: drawMesh(surface.drawing()),
          inputVertices: surface.input_vertices(),
          scenery: drawMesh(file.scenery(Uint32Array.from(walked))),
          report,
          timings,
          meanEdge: surface.mean_edge(),
          factorNonzeros: solver.factor_nonzeros(),
          memoryBytes: memory.buffer.byteLength,
        };
        return transfer(opened, [
          ...buffersOf(opened.surface),
          ...buffersOf(opened.scenery),
          opened.inputVertices.buffer,
        ]);
      } finally {
        surface.free();
      }
    } finally {
      file.free();
    }
  },

  configure({ timeFactor, boundary }: Parameters): Promise<Timings> {
    const mesh = openMesh();
    const clock = stopwatch();
    mesh.solver.configure(timeFactor, boundary, () => undefined);
    mesh.timings = { ...mesh.timings, precomputeMs: clock() };
    return Promise.resolve(mesh.timings);
  },

  solve(sources: SurfacePoint[]): Promise<DistanceField> {
    const { solver } = openMesh();
    const clock = stopwatch();
    const distance = solver.solve(sources);
    const field: DistanceField = {
      distance,
      maxDistance: solver.max_distance(),
      unreachableVertices: solver.unreachable_vertices(),
      solveMs: clock(),
    };
    return Promise.resolve(transfer(field, [distance.buffer]));
  },

  path(from: SurfacePoint): Promise<SurfacePath> {
    const path = openMesh().solver.path(from);
    const answer: SurfacePath = { points: path.take_points(), normals: path.take_normals(), length: path.length };
    path.free();
    return Promise.resolve(transfer(answer, [answer.points.buffer, answer.normals.buffer]));
  },

  async shapes(): Promise<string[]> {
    await ready;
    return wasm.shape_names();
  },
};

function openMesh(): Current {
  if (!current) throw new Error('No mesh is open.');
  return current;
}

function read(input: MeshInput): wasm.MeshFile {
  switch (input.kind) {
    case 'files':
      return wasm.MeshFile.read(
        input.files.map(({ name }) => name),
        input.files.map(({ bytes }) => bytes),
      );
    case 'shape':
      return wasm.MeshFile.shape(input.shape);
    case 'arrays':
      return wasm.MeshFile.arrays(input.name, input.positions, input.triangles);
  }
}

function nameOf(input: MeshInput): string {
  switch (input.kind) {
    case 'files':
      return input.files[0]?.name ?? '';
    case 'shape':
      return input.shape;
    case 'arrays':
      return input.name;
  }
}

function factor(
  surface: wasm.WalkedSurface,
  { timeFactor, boundary }: Parameters,
  vertices: number,
  progress: ProgressListener,
): wasm.Solver {
  return surface.factor(timeFactor, boundary, (stage: string, fraction: number) => {
    progress({ stage, fraction: FACTOR_FROM + (1 - FACTOR_FROM) * fraction, vertices });
  });
}

function reportOf(surface: wasm.WalkedSurface): BuildReport {
  const counts = surface.report();
  const report: BuildReport = {
    inputVertices: counts.input_vertices,
    vertices: counts.vertices,
    faces: counts.faces,
    weldedVertices: counts.welded_vertices,
    unreferencedVertices: counts.unreferenced_vertices,
    degenerateFaces: counts.degenerate_faces,
    duplicateFaces: counts.duplicate_faces,
    turnedFaces: counts.turned_faces,
    nonManifoldEdges: counts.non_manifold_edges,
    components: counts.components,
    boundaryLoops: counts.boundary_loops,
    eulerCharacteristic: counts.euler_characteristic,
  };
  counts.free();
  return report;
}

function drawMesh(mesh: wasm.DrawMesh): DrawMesh {
  const arrays = { positions: mesh.take_positions(), normals: mesh.take_normals(), triangles: mesh.take_triangles() };
  mesh.free();
  return arrays;
}

function buffersOf({ positions, normals, triangles }: DrawMesh): Transferable[] {
  return [positions.buffer, normals.buffer, triangles.buffer];
}

/** Milliseconds since the last call. */
function stopwatch(): () => number {
  let before = performance.now();
  return () => {
    const now = performance.now();
    const passed = now - before;
    before = now;
    return passed;
  };
}

/** SHA-256 of the mesh file; empty where the browser offers none (pages that are not served over HTTPS). */
async function hashOf(input: MeshInput): Promise<string> {
  if (input.kind !== 'files' || !input.files[0] || !('subtle' in crypto)) return '';
  const digest = await crypto.subtle.digest('SHA-256', input.files[0].bytes as Uint8Array<ArrayBuffer>);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

expose(api);
