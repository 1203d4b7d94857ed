/** What the crates say to the page, found in their sources. */
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';

/** Crates whose errors reach the page. Of the renderer only errors are told: the rest of its literals are of shaders and labels; what a cloud is joined by, the page tells in its own words. */
const SAYING =
  /^((basis|bindings|curves|maker|model|reader|scene|solver|surface|volume|worker)\/src\/.*|cloud\/src\/(error|text)|viewer\/src\/error)\.rs$/;
/** Tests, and what files have that are written. */
const SILENT = /tests(\.rs$|\/)|\/write(\.rs$|\/)/;
/** Comments, and literals: strings with what is in them, those of bytes, raw ones and characters without. */
const TOKEN = /\/\/[^\n]*|b?r(#*)".*?"\1|b"(?:[^"\\]|\\.)*"|"((?:[^"\\]|\\.)*)"|'(?:\\[^']+|[^'\\])'/gs;
/** What stands before a literal that no user reads: that of an attribute, of a broken invariant, of types for the page. */
const UNSAID =
  /(#!?\[(?!error\()[^\]\n]*|,\s*reason = |unchecked_\w+_type = |(expect|panic!|unreachable!)\(\s*|assert(_\w+)?!\([^;]*|typescript_custom_section\)\]\s*const \w+: &str = )$/;
/** Letters that `UNSAID` looks at. */
const NEAR = 400;

/** Literals of a Rust source that have the look of a sentence or of a part of one, with `{0}` for the first value. */
export function literalsOf(source: string): string[] {
  const tests = source.search(/#\[cfg\(test\)\]\s*mod \w+ \{/);
  const said = tests < 0 ? source : source.slice(0, tests);
  const found: string[] = [];
  for (const { 2: literal, index } of said.matchAll(TOKEN)) {
    const before = said.slice(Math.max(0, index - NEAR), index);
    if (literal === undefined || UNSAID.test(before)) continue;
    let value = 0;
    const text = literal
      .replaceAll(/\\\s*\n\s*/g, '')
      .replaceAll('\\"', '"')
      .replaceAll(/\{[^}]*\}/g, () => `{${value++}}`);
    const hasWords = /[a-z]{2}/i.test(text.replaceAll(/\{\d\}/g, ''));
    if (hasWords && (text.includes(' ') || /#\[error\(\s*$/.test(before))) found.push(text);
  }
  return found;
}

/** All of them, with the paths of their sources. */
export async function literals(): Promise<[string, string][]> {
  const root = new URL('../crate/', import.meta.url).pathname;
  const paths = (await readdir(root, { recursive: true })).filter((path) => SAYING.test(path) && !SILENT.test(path));
  const files = await Promise.all(
    paths.map(async (path) => literalsOf(await readFile(join(root, path), 'utf8')).map((text) => [path, text])),
  );
  return files.flat() as [string, string][];
}
