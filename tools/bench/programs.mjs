// The native programs of a checkout, each in a process of its own: one that fails takes no other with it.

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { json } from '../peers.mjs';
import { cargo } from '../steps.mjs';

const FACTORING = ['ordering', 'analysing', 'factoring'];
const EXAMPLES = ['bench_mesh', 'closed_forms', 'factors', 'paths', 'queries'];

export class Programs {
  #tree;

  /** Of the checkout in the folder `tree`. */
  constructor(tree) {
    this.#tree = tree;
  }

  build() {
    // Another commit may have fewer.
    const there = EXAMPLES.filter((name) => existsSync(join(this.#tree, 'crate', 'solver', 'examples', `${name}.rs`)));
    const programs = ['--bin', 'heatwalk', ...there.flatMap((name) => ['--example', name])];
    const manifest = ['--manifest-path', join(this.#tree, 'Cargo.toml')];
    const packages = ['-p', 'heatwalk-cli', '-p', 'heatwalk'];
    cargo('Building the program', ['build', '--release', ...manifest, ...packages, ...programs], 'See above.', {
      CARGO_TARGET_DIR: join(this.#tree, 'target'),
    });
  }

  get heatwalk() {
    return join(this.#tree, 'target', 'release', 'heatwalk');
  }

  example(name) {
    return join(this.#tree, 'target', 'release', 'examples', name);
  }

  /** Milliseconds of precompute, its stages and a solve; and the sources of which that is the median. */
  native(mesh, count) {
    const args = ['distance', mesh, '--source', '0', '--repeat', String(count), '--json'];
    const answer = json(this.heatwalk, args);
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

  queries(mesh) {
    return json(this.example('queries'), [mesh]);
  }

  /** By matrix: milliseconds of factoring and a solve, and of faer's under the same elimination order. */
  factors(mesh) {
    return json(this.example('factors'), [mesh]);
  }
}
