// Programs of others, each in a process of its own.

import { join } from 'node:path';
import { attempt, installs, json, LIBIGL, POTPOURRI3D, pythonWith, SCIKIT_SPARSE, SCIPY } from '../peers.mjs';
import { root } from '../steps.mjs';

const CHOLMOD_REMEDY = 'apt-get install libsuitesparse-dev libopenblas0-serial, and a C compiler';

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
