/** WebKit for GTK, which stands for Safari, by the WebDriver protocol: https://www.w3.org/TR/webdriver2/ */
import { type ChildProcess, spawn } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { createServer } from 'node:net';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { type Screen, startScreen } from './screen';

const DRIVER = '/usr/bin/WebKitWebDriver';
const LIBRARIES = '/usr/lib';
const STARTED_MS = 10_000;
const SCRIPT_MS = 60_000;

/** Where the browser is, if it is anywhere: in the folder of the library, whose name tells the machine. */
export function findWebKit(): string | undefined {
  if (!existsSync(DRIVER)) return undefined;
  const folders = readdirSync(LIBRARIES).filter((name) => name.endsWith('-linux-gnu'));
  const browsers = folders.map((name) => join(LIBRARIES, name, 'webkit2gtk-4.1', 'MiniBrowser'));
  return browsers.find((browser) => existsSync(browser));
}

export class WebKit {
  private constructor(
    readonly session: string,
    readonly driver: ChildProcess,
    readonly screen: Screen,
  ) {}

  static async start(binary: string, width: number, height: number): Promise<WebKit> {
    const screen = await startScreen(width, height);
    const port = await freePort();
    const driver = spawn(DRIVER, [`--port=${port}`], { env: screen.environment, stdio: 'ignore' });
    const address = `http://127.0.0.1:${port}`;
    await started(address);
    const wanted = { browserName: 'MiniBrowser', 'webkitgtk:browserOptions': { binary, args: ['--automation'] } };
    const { sessionId } = await call<{ sessionId: string }>(`${address}/session`, {
      capabilities: { alwaysMatch: { ...wanted, timeouts: { script: SCRIPT_MS } } },
    });
    const webkit = new WebKit(`${address}/session/${sessionId}`, driver, screen);
    await call(`${webkit.session}/window/rect`, { x: 0, y: 0, width, height });
    return webkit;
  }

  async goto(url: string): Promise<void> {
    await call(`${this.session}/url`, { url });
  }

  /** What an expression of the page gives, once its promise is kept. */
  evaluate<T>(expression: string, ...args: unknown[]): Promise<T> {
    return call<T>(`${this.session}/execute/sync`, { script: `return (${expression})`, args });
  }

  /** A press of the mouse that goes from place to place; of CSS pixels. */
  async press(...[first, ...more]: (readonly [number, number])[]): Promise<void> {
    const actions = [
      move(first),
      { type: 'pointerDown', button: 0 },
      ...more.map(move),
      { type: 'pointerUp', button: 0 },
    ];
    await call(`${this.session}/actions`, { actions: [{ type: 'pointer', id: 'mouse', actions }] });
  }

  /** Gives a file to a field for files. */
  async choose(selector: string, file: string): Promise<void> {
    const wanted = { using: 'css selector', value: selector };
    const [element] = Object.values(await call<Record<string, string>>(`${this.session}/element`, wanted));
    await call(`${this.session}/element/${element}/value`, { text: file });
  }

  async stop(): Promise<void> {
    await fetch(this.session, { method: 'DELETE' });
    this.driver.kill();
    this.screen.display.kill();
  }
}

function move([x, y]: readonly [number, number]): object {
  return { type: 'pointerMove', x: Math.round(x), y: Math.round(y), duration: 50 };
}

async function call<T>(address: string, body: object): Promise<T> {
  const response = await fetch(address, { method: 'POST', body: JSON.stringify(body) });
  const { value } = (await response.json()) as { value: T & { error?: string; message?: string } };
  if (!response.ok) throw new Error(`WebKit: ${value.error}: ${value.message}`);
  return value;
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    });
  });
}

async function started(address: string): Promise<void> {
  const end = Date.now() + STARTED_MS;
  for (;;) {
    const isThere = await fetch(`${address}/status`).then(
      () => true,
      () => false,
    );
    if (isThere) return;
    if (Date.now() > end) throw new Error(`${DRIVER} does not answer.`);
    await setTimeout(50);
  }
}
