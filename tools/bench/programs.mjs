// The native programs of a checkout, each in a process of its own: one that fails takes no other with it.

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { json } from '../peers.mjs';
import { cargo } from '../steps.mjs';

const FACTORING = ['ordering', 'analysing', 'factoring'];
/** Means the heat method, also to commits whose program knows no other. */
export const BY_HEAT = ['--near', 'auto'];
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

  /** Whether the program has methods that factor nothing; another commit may not. */
  get hasMethods() {
    return spawnSync(this.heatwalk, ['distance', '--help'], { encoding: 'utf8' }).stdout.includes('propagation');
  }

  /** Options for one thread, as the peers have. Another commit's program may build on one only, and know no option for it. */
  get #oneThread() {
    const help = spawnSync(this.heatwalk, ['info', '--help'], { encoding: 'utf8' }).stdout;
    return help.includes('--threads') ? ['--threads', '1'] : [];
  }

  /** What `heatwalk distance` answers from a source, on one thread. */
  distance(mesh, source, ...options) {
    const places = ['--source', String(source)];
    return json(this.heatwalk, ['distance', mesh, ...places, ...options, ...this.#oneThread, '--json']);
  }

  /** Mean and maximum error in per cent. */
  error(mesh, source, ...options) {
    const { mean_error_percent: mean, max_error_percent: max } = this.distance(mesh, source, ...options, '--compare');
    return { mean, max };
  }

  /** Milliseconds from positions to the first whole field, by a method that factors nothing. */
  first(mesh, method) {
    const { build, precompute, solve } = this.distance(mesh, 0, '--method', method).timings_ms;
    return build + precompute + solve;
  }

  /** Milliseconds of another source by a method that factors nothing, the median over so many; and these. */
  another(mesh, method, count) {
    const answer = this.distance(mesh, 0, '--method', method, '--repeat', String(count));
    return { solve: answer.timings_ms.solve, sources: answer.timed_sources };
  }

  /** Milliseconds of precompute, its stages and a solve by heat; and the sources of which that is the median. */
  native(mesh, count) {
    const answer = this.distance(mesh, 0, ...BY_HEAT, '--repeat', String(count));
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
