// A commit of this repository in a folder of its own, with its programs and its page.

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { fail, root, run } from '../steps.mjs';
import { Programs } from './programs.mjs';

function git(...args) {
  const { status, stdout, stderr } = spawnSync('git', args, { cwd: root, encoding: 'utf8' });
  if (status !== 0) fail(`git ${args.join(' ')} failed: ${stderr.trim()}`);
  return stdout.trim();
}

/** What is checked out in a folder, as git describes it. */
export function description(tree) {
  return git('-C', tree, 'describe', '--always', '--dirty');
}

/** The folder of a commit under target/, made where it is not there yet. */
export function checkout(commit) {
  const hash = git('rev-parse', '--verify', `${commit}^{commit}`);
  const tree = join(root, 'target', 'against', hash.slice(0, 12));
  if (!existsSync(tree)) {
    git('worktree', 'prune');
    git('worktree', 'add', '--detach', tree, hash);
  }
  return tree;
}

/** A folder's programs and, once opened, its page, which is driven by the driver that lies beside it. */
export class Checkout {
  page;

  constructor(tree) {
    this.tree = tree;
    this.name = description(tree);
    this.programs = new Programs(tree);
    this.programs.build();
  }

  async openPage() {
    const build = join(this.tree, 'tools', 'build.mjs');
    run(`Building the page of ${this.name}`, process.execPath, [build], 'The message above names the cause.');
    const { Page } = await import(pathToFileURL(join(this.tree, 'tools', 'bench', 'page.mjs')).href);
    this.page = await Page.open();
  }

  async close() {
    await this.page?.close();
  }
}
