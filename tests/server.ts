/** The built page, or another folder of files, on a host of its own, in a folder, with whatever headers it has there. */
import { createReadStream, existsSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { PAGE } from './built';

const FOLDER = '/in/a/folder/';
const TYPES: Readonly<Record<string, string>> = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.webp': 'image/webp',
};

/** Of a page that is isolated from others: it may share memory. */
export const ISOLATED = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
  'Cross-Origin-Resource-Policy': 'cross-origin',
};

export class Host {
  /** Paths that were asked for since this was emptied. */
  asked: string[] = [];
  /** A path of which the next answer breaks off. */
  breaksOff: string | null = null;
  /** What is served in the place of files, by path. */
  readonly pages: Record<string, string>;
  readonly #server: Server;

  private constructor(server: Server, pages: Readonly<Record<string, string>>) {
    this.#server = server;
    this.pages = { ...pages };
  }

  /** `pages`: texts beside the built page, by path; `files`: what is served in the place of that. */
  static async start(
    headers: Readonly<Record<string, string>> = {},
    pages: Readonly<Record<string, string>> = {},
    files = PAGE,
  ): Promise<Host> {
    const server = createServer((request, response) => {
      const { pathname } = new URL(request.url ?? '/', 'http://host');
      host.asked.push(pathname);
      for (const [name, value] of Object.entries(headers)) response.setHeader(name, value);
      const page = host.pages[pathname];
      const inside = pathname.startsWith(FOLDER) ? normalize(pathname.slice(FOLDER.length) || 'index.html') : '..';
      const file = join(files, inside);
      if (pathname === host.breaksOff) {
        host.breaksOff = null;
        response
          .writeHead(200, { 'Content-Type': TYPES[extname(file)], 'Content-Length': 1000 })
          .write('broken', () => response.destroy());
      } else if (page !== undefined)
        response.setHeader('Content-Type', TYPES[extname(pathname)] ?? 'text/html').end(page);
      else if (inside.startsWith('..') || !existsSync(file)) response.writeHead(404).end();
      else
        createReadStream(file).pipe(
          response.setHeader('Content-Type', TYPES[extname(file)] ?? 'application/octet-stream'),
        );
    });
    const host = new Host(server, pages);
    await new Promise<void>((resolve) => server.listen(0, resolve));
    return host;
  }

  /** Where the built page is. */
  get page(): string {
    return `http://localhost:${this.#port}${FOLDER}`;
  }

  /** Another origin. */
  get other(): string {
    return `http://127.0.0.1:${this.#port}`;
  }

  get #port(): number {
    return (this.#server.address() as AddressInfo).port;
  }

  async stop(): Promise<void> {
    this.#server.closeAllConnections();
    await new Promise((resolve) => this.#server.close(resolve));
  }
}
