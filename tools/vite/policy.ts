/** What a page may load, run and ask for, told to the browser within it: a content security policy. */
import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

/** Meshes come from any address that a visitor opens; presets and modules of the page in one file from what it makes itself. */
const CONNECTIONS = "'self' blob: data: https: http:";

/** Sources of scripts and styles beside the page's own folder: their hashes, where they are in the page. */
interface Within {
  scripts: readonly string[];
  styles: readonly string[];
}

const NOTHING: Within = { scripts: [], styles: [] };

/** Of the page: scripts of its own alone, whose addresses its default policy of trusted types looks at, and nothing that makes HTML of text. */
function policyOf({ scripts, styles }: Within): string {
  return [
    "default-src 'none'",
    ['script-src', "'self'", "'wasm-unsafe-eval'", ...scripts].join(' '),
    ['style-src', "'self'", ...styles].join(' '),
    "img-src 'self' blob: data:",
    "media-src 'self' blob:",
    `connect-src ${CONNECTIONS}`,
    "worker-src 'self' blob:",
    "manifest-src 'self'",
    "object-src 'none'",
    "base-uri 'none'",
    "form-action 'none'",
    "require-trusted-types-for 'script'",
    'trusted-types default',
  ].join('; ');
}

/** Of a document: its style, its images and the search over all of them. */
export const DOCUMENT_POLICY = [
  "default-src 'none'",
  "script-src 'self'",
  "style-src 'self'",
  "img-src 'self' data:",
  "connect-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
  "require-trusted-types-for 'script'",
  "trusted-types 'none'",
].join('; ');

/** Puts the policy into the page. The server for development adds scripts and styles of its own, and has none. */
export function policy(): Plugin {
  return {
    name: 'heatwalk-policy',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler: () => [
        {
          tag: 'meta',
          attrs: { 'http-equiv': 'Content-Security-Policy', content: policyOf(NOTHING) },
          injectTo: 'head-prepend',
        },
      ],
    },
  };
}

/** A page whose scripts and styles are in it, with the policy that lets these run and no others. */
export function withPolicy(html: string, scripts: readonly string[], styles: readonly string[]): string {
  const content = policyOf({ scripts: scripts.map(hashOf), styles: styles.map(hashOf) });
  return html.replace('<head>', `<head>\n    <meta http-equiv="Content-Security-Policy" content="${content}" />`);
}

function hashOf(text: string): string {
  return `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
}
