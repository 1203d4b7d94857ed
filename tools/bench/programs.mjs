// The native program and the peers, each in a process of its own: one that fails takes no other with it.

import { join } from 'node:path';
import { attempt, installs, json, LIBIGL, POTPOURRI3D, pythonWith, SCIKIT_SPARSE, SCIPY } from '../peers.mjs';
import { cargo, root } from '../steps.mjs';

const release = join(root, 'target', 'release');
export const MESH_PROGRAM = join(release, 'examples', 'bench_mesh');
const FACTORING = ['ordering', 'analysing', 'factoring'];
const CHOLMOD_REMEDY = 'apt-get install libsuitesparse-dev libopenblas0-serial, and a C compiler';

export function buildPrograms() {
  cargo(
    'Building the program',
    [
      'build',
      '--release',
      '-p',
      'heatwalk-cli',
      '-p',
      'heatwalk',
      '--bin',
      'heatwalk',
      '--example',
      'queries',
      '--example',
      'bench_mesh',
    ],
    'See above.',
  );
}

export function native(mesh, count) {
  const args = ['distance', mesh, '--source', '0', '--repeat', String(count), '--json'];
  const answer = json(join(release, 'heatwalk'), args);
  const { timings_ms: timings, stages_ms: stages } = answer;
  return {
    precompute: timings.build + timings.precompute,
    solve: timings.solve,
    factors: FACTORING.reduce((sum, stage) => sum + stages[stage], 0),
    build: timings.build,
    ...stages,
    sources: answer.timed_sources,
  };
}

export function queries(mesh) {
  return json(join(release, 'examples', 'queries'), [mesh]);
}

export class Peers {
  #python = pythonWith(POTPOURRI3D, LIBIGL, SCIPY);
  /** Why a peer is left out, by its name. */
  skipped = {};

  constructor() {
    if (!installs(this.#python, SCIKIT_SPARSE)) {
      this.skipped.cholmod = `CHOLMOD is skipped: ${SCIKIT_SPARSE} cannot be built. To have it: ${CHOLMOD_REMEDY}.`;
      console.log(`\n${this.skipped.cholmod}`);
    }
  }

  get versions() {
    return json(this.#python, [join(root, 'tools', 'bench', 'peers.py'), 'versions']);
  }

  run(name, mesh, sources) {
    if (this.skipped[name]) return { failed: 'skipped' };
    return attempt(this.#python, [join(root, 'tools', 'bench', 'peers.py'), name, mesh, ...sources.map(String)]);
  }
}
