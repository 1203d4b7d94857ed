// The page as it ships, in a headless Chromium: its worker alone, a source dragged on it, and what it loads.

import { createReadStream, readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { brotliCompressSync, constants } from 'node:zlib';
// Of two checkouts, each brings its own; the test runner would refuse to be loaded twice.
import { chromium } from 'playwright-core';
import { preview } from 'vite';
import { ALWAYS, WEBGL, WEBGPU } from '../chromium.mjs';
import { requireChromium } from '../needs.mjs';
import { root } from '../steps.mjs';

const dist = join(root, 'dist');
const UNDRAWN = ['--disable-gpu', '--disable-software-rasterizer', '--disable-3d-apis'];

const SILENCE_MS = 300_000;

const WINDOW = { width: 640, height: 400 };
const DRAG_SECONDS = 5;
const POINTER_HZ = 120;
/** Until a spare worker has warmed up. */
const WARMING_SECONDS = 3;
/** How often a model is read, and its contacts are looked for. */
const RUNS = 6;
/** CSS pixels. */
const DRAG_RADIUS = 15;
/** CSS pixels between rows that a brush paints, and between the events on them. */
const ROWS = 12;
const PACE = 2;
/** The number of the first place where the brush is pressed: the places before are on the outline, where a press may miss. */
const WITHIN = 20;

/** None: the page starts out with the solver's defaults. */
const PARAMETERS = {};

/** An empty page beside the real one, and the mesh that is measured. */
const BLANK = '/bench/';
const MESH = '/bench/mesh.ply';

export class Page {
  #server;
  #browser;
  /** What the server gives at `MESH`. */
  #mesh = '';

  static async open() {
    const page = new Page();
    page.#server = await preview({ root, logLevel: 'error', plugins: [page.#plugin()] });
    page.#browser = await chromium.launch({
      executablePath: requireChromium(),
      args: [...ALWAYS, ...WEBGL],
      ignoreDefaultArgs: ['--disable-gpu'],
    });
    return page;
  }

  get version() {
    return this.#browser.version();
  }

  async close() {
    await this.#browser.close();
    await this.#server.close();
  }

  /**
   * Milliseconds of reading, precompute, the first answer and the median one, and bytes of memory, of a fresh worker: by
   * heat, or by so many windows of each half-edge, where nothing is factored.
   */
  async worker(mesh, sources, windows = 0) {
    return this.#inWorker(mesh, measureWorker, { windows, sources });
  }

  /** Milliseconds of opening a file of tetrahedra, of factoring and of the first field from vertex 0, and bytes of memory before that. */
  async inside(mesh, isByHeat) {
    return this.#inWorker(mesh, measureInside, { name: basename(mesh), isByHeat });
  }

  /**
   * Milliseconds of reading a file in a fresh worker, and of looking for contacts in it, so often one after the other; the first
   * of each by code that the browser has not optimised yet.
   */
  async model(mesh) {
    const measured = await this.#inWorker(mesh, measureModel, { name: basename(mesh), runs: RUNS });
    if (measured.failed) throw new Error(measured.failed);
    return measured;
  }

  /** Seconds from dropping a file until its stripes are in a picture, and the bytes that are loaded for it, after brotli. */
  async drop(mesh) {
    this.#mesh = mesh;
    return this.#with('/?gpu=webgl#v=1&m=bunny', async (tab) => {
      await tab.evaluate(() => window.heatwalk.ready);
      // The worker of the next mesh warms up.
      await tab.waitForTimeout(1000 * WARMING_SECONDS);
      const loaded = new Set();
      tab.context().on('request', (request) => loaded.add(new URL(request.url()).pathname));
      const seconds = await tab.evaluate(dropFile, { mesh: MESH, name: basename(mesh) });
      const files = [...loaded].filter((path) => isFile(join(dist, path)));
      const bytes = files.reduce((sum, path) => sum + brotli(readFileSync(join(dist, path))), 0);
      return { seconds, bytes };
    });
  }

  async #inWorker(mesh, measure, options) {
    this.#mesh = mesh;
    return this.#with(BLANK, async (tab) => {
      await tab.addScriptTag({ path: join(root, 'node_modules', 'comlink', 'dist', 'umd', 'comlink.min.js') });
      try {
        const measured = async () => {
          await tab.evaluate(offerWorkers, {
            worker: asset(/^entry-.*\.js$/),
            module: asset(/^heatwalk_worker_bg-.*\.wasm$/),
          });
          return tab.evaluate(measure, { mesh: MESH, parameters: PARAMETERS, ...options });
        };
        return await Promise.race([measured(), silence()]);
      } catch (error) {
        return { failed: error.message.split('\n')[0] };
      }
    });
  }

  /**
   * A source dragged for some seconds over a preset, or over the mesh of a file as one that is dropped: fields a second, and
   * how long each answer kept the page busy.
   */
  async drag(preset, file) {
    const address = `/?resolution=full&gpu=webgl#v=1&m=${preset}`;
    return this.#with(address, async (tab) => {
      await tab.evaluate(() => window.heatwalk.ready);
      if (file) {
        await tab.setInputFiles('input[type=file]', file);
        await tab.waitForFunction((name) => window.heatwalk.mesh.name === name, basename(file));
      }
      const [x, y] = await tab.evaluate(pixelOnModel);
      await tab.mouse.click(x, y);
      // A second press too soon would be a double click.
      await tab.waitForTimeout(1000);
      await tab.mouse.move(x, y);
      return { preset, ...(await drawn(tab, circles(x, y))) };
    });
  }

  /** Mud painted in rows for some seconds over a preset: fields a second, and how long each answer kept the page busy. */
  async paint(preset) {
    return this.#with(`/?resolution=full&gpu=webgl#v=1&m=${preset}`, async (tab) => {
      await tab.evaluate(() => window.heatwalk.ready);
      await tab.keyboard.press('b');
      const points = await tab.evaluate(rowsOnModel, { rows: ROWS, pace: PACE });
      await tab.mouse.move(...points[WITHIN]);
      // Until the worker has told which triangles lie side by side, nothing is painted.
      const start = performance.now();
      while (!(await tab.evaluate(isPainted))) {
        if (performance.now() - start > SILENCE_MS) throw new Error('The brush does not paint.');
        await tab.mouse.down();
        await tab.mouse.up();
        // A second press too soon would be a double click.
        await tab.waitForTimeout(1000);
      }
      return { preset, ...(await drawn(tab, points)) };
    });
  }

  /**
   * Fields a second, each with its path, while a preset's first animation plays and distance is measured in each pose; by a
   * browser that draws nothing, since drawing by software would set the rate.
   */
  async live(preset) {
    const browser = await chromium.launch({ executablePath: requireChromium(), args: [...ALWAYS, ...UNDRAWN] });
    try {
      const tab = await browser.newPage({ viewport: WINDOW });
      const address = `/#v=1&m=${preset}&clip=0&play=1&live=1`;
      await tab.goto(new URL(address, this.#server.resolvedUrls.local[0]).href);
      await tab.evaluate(() => window.heatwalk.ready);
      // The browser optimises the solver's code in the first second or two.
      await tab.waitForTimeout(1000 * DRAG_SECONDS);
      const now = () => tab.evaluate(() => [performance.now() / 1000, window.heatwalk.solves]);
      const [start, before] = await now();
      await tab.waitForTimeout(1000 * DRAG_SECONDS);
      const [end, after] = await now();
      const triangles = await tab.evaluate(() => window.heatwalk.mesh.triangles);
      return { preset, triangles, fields: (after - before) / (end - start) };
    } finally {
      await browser.close();
    }
  }

  /** The files that the page loads until its first picture, with their bytes after brotli; by a browser with WebGPU, or without. */
  async firstPicture(hasWebGpu = true) {
    const args = [...ALWAYS, ...(hasWebGpu ? WEBGPU : WEBGL)];
    const browser = await chromium.launch({
      executablePath: requireChromium(),
      args,
      ignoreDefaultArgs: ['--disable-gpu'],
    });
    try {
      const tab = await browser.newPage();
      await tab.addInitScript(markFirstPicture);
      await tab.goto(this.#server.resolvedUrls.local[0]);
      const { backend, addresses } = await tab.evaluate(untilReady);
      if (backend !== (hasWebGpu ? 'WebGPU' : 'WebGL2')) throw new Error(`The page draws with ${backend}.`);
      const paths = addresses.map((address) => new URL(address).pathname).filter((path) => isFile(join(dist, path)));
      const sizes = ['/index.html', ...paths].map((path) => [path, brotli(readFileSync(join(dist, path)))]);
      return { bytes: sizes.reduce((sum, [, bytes]) => sum + bytes, 0), files: Object.fromEntries(sizes) };
    } finally {
      await browser.close();
    }
  }

  async #with(address, work) {
    const context = await this.#browser.newContext({ viewport: WINDOW, serviceWorkers: 'block' });
    try {
      const tab = await context.newPage();
      tab.setDefaultTimeout(0);
      await tab.addInitScript(timeAnswers);
      await tab.goto(new URL(address, this.#server.resolvedUrls.local[0]).href);
      return await work(tab);
    } finally {
      await context.close();
    }
  }

  #plugin() {
    return {
      name: 'bench',
      configurePreviewServer: ({ middlewares }) => {
        middlewares.use((request, response, next) => {
          if (request.url === BLANK) response.setHeader('content-type', 'text/html').end('<!doctype html>');
          else if (request.url === MESH) createReadStream(this.#mesh).pipe(response);
          else next();
        });
      },
    };
  }
}

/** Follows places with the button down, and what came of it. */
async function drawn(tab, points) {
  await tab.mouse.down();
  const answers = await tab.evaluate(followPlaces, { points, seconds: DRAG_SECONDS, hertz: POINTER_HZ });
  await tab.mouse.up();
  return { triangles: await tab.evaluate(() => window.heatwalk.mesh.triangles), ...answers };
}

/** Places on a circle, one turn a second. */
function circles(x, y) {
  return Array.from({ length: POINTER_HZ }, (_, place) => {
    const turn = (2 * Math.PI * place) / POINTER_HZ;
    return [x + DRAG_RADIUS * Math.cos(turn), y + DRAG_RADIUS * Math.sin(turn)];
  });
}

/** A worker that ends without a word answers nothing. */
async function silence() {
  await setTimeout(SILENCE_MS, undefined, { ref: false });
  throw new Error(`no answer in ${SILENCE_MS / 60_000} minutes`);
}

/** Where the server has the built file with such a name. */
function asset(pattern) {
  return `/assets/${readdirSync(join(dist, 'assets')).find((name) => pattern.test(name))}`;
}

function isFile(path) {
  return statSync(path, { throwIfNoEntry: false })?.isFile() ?? false;
}

function brotli(bytes) {
  return brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } }).length;
}

// What follows runs in the browser.

/** Marks when the first picture is there: whoever asks later, or waits for a turn, finds more loaded. */
function markFirstPicture() {
  const { defineProperty } = Object;
  Object.defineProperty = (object, name, property) => {
    if (name === 'heatwalk') void property.value.ready.then(() => performance.mark('first picture'));
    return defineProperty(object, name, property);
  };
}

/** By the page's own clock: what comes after the first picture is on its way a moment later. */
async function untilReady() {
  await window.heatwalk.ready;
  const [{ startTime: ready }] = performance.getEntriesByName('first picture');
  const viewer = /viewer.*\.wasm/;
  let loaded = performance.getEntriesByType('resource');
  // A module may draw before the browser has entered its end.
  while (!loaded.some(({ name }) => viewer.test(name))) {
    await new Promise((end) => setTimeout(end, 50));
    loaded = performance.getEntriesByType('resource');
  }
  const before = loaded.filter(({ name, responseEnd }) => responseEnd <= ready || viewer.test(name));
  return { backend: window.heatwalk.backend, addresses: before.map(({ name }) => name) };
}

/** What the functions that measure need of the tab: workers that are started, those that are warmed up too, and callbacks for them. */
async function offerWorkers({ worker, module }) {
  const { Comlink } = window;
  const compiled = await WebAssembly.compileStreaming(fetch(module));
  const started = async () => {
    const api = Comlink.wrap(new Worker(worker, { type: 'module' }));
    await api.start(compiled);
    return api;
  };
  const warmed = async () => {
    const api = await started();
    await api.warmUp();
    return api;
  };
  const progress = () => Comlink.proxy(() => undefined);
  Object.assign(window, { started, warmed, progress });
}

async function measureWorker({ mesh, parameters, windows, sources }) {
  const { started, warmed, progress } = window;
  // As on the page, where a preset is shown first, and then the worker of the next mesh warms up.
  const room = { windows, memory: 'auto' };
  const shown = await started();
  await shown.open({ kind: 'shape', shape: 'icosphere' }, [], room, progress());
  await shown.prepare(parameters, progress());
  await shown.solve([{ vertex: 0 }], false, null);
  const api = await warmed();
  const bytes = new Uint8Array(await (await fetch(mesh)).arrayBuffer());
  // An earlier commit takes a file as `name` and `bytes`.
  const file = { path: 'mesh.ply', content: new Blob([bytes]), name: 'mesh.ply', bytes };
  await api.open({ kind: 'files', mesh: file.path, files: [file] }, [], room, progress());
  const { timings } = await api.prepare(windows > 0 ? null : parameters, progress());
  const times = [];
  for (const vertex of sources) {
    const asked = [{ vertex }];
    const { field } = await (windows > 0 ? api.propagate(asked, windows, false, null) : api.solve(asked, false, null));
    times.push(field.solveMs);
  }
  const [first] = times;
  times.sort((a, b) => a - b);
  // The same parameters again: nothing is factored, and the answer tells the memory, which never shrinks.
  const { memoryBytes } = await api.configure(parameters);
  return {
    read: timings.readMs,
    first,
    precompute: timings.buildMs + timings.precomputeMs,
    solve: (times[(times.length - 1) >> 1] + times[times.length >> 1]) / 2,
    memory: memoryBytes,
  };
}

async function measureInside({ mesh, name, parameters, isByHeat }) {
  const { warmed, progress } = window;
  const api = await warmed();
  const content = await (await fetch(mesh)).blob();
  const times = [performance.now()];
  const file = { kind: 'files', mesh: name, files: [{ path: name, content }] };
  const { interior } = await api.open(file, [], { windows: 1, memory: 'auto' }, progress());
  times.push(performance.now());
  const { memoryBytes } = await api.prepare(isByHeat ? parameters : null, progress());
  times.push(performance.now());
  const asked = [{ vertex: 0 }];
  await (isByHeat ? api.solve(asked, false, null) : api.propagate(asked, 1, false, null));
  times.push(performance.now());
  const [open, precompute, solve] = times.slice(1).map((time, index) => time - times[index]);
  return { tetrahedra: interior.tetrahedra.length / 4, open, precompute, solve, memory: memoryBytes };
}

async function measureModel({ mesh, name, runs }) {
  const { warmed, progress } = window;
  const api = await warmed();
  const content = await (await fetch(mesh)).blob();
  const input = { kind: 'files', mesh: name, files: [{ path: name, content }] };
  const [reads, joins] = [[], []];
  for (let run = 0; run < runs; run++) {
    await api.open(input, [], { windows: 1, memory: 'auto' }, progress());
    const { timings } = await api.prepare(null, progress());
    reads.push(timings.readMs);
    joins.push((await api.bridge('auto', 0, false)).timings.joinMs);
  }
  return { reads, joins };
}

/** What a frame finds is drawn by then, or by the one before the next. */
async function dropFile({ mesh, name }) {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([await (await fetch(mesh)).blob()], name));
  const begin = performance.now();
  document.body.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer }));
  return new Promise((resolve) => {
    let left = 2;
    const frame = () => {
      if (window.heatwalk.mesh?.name === name && window.heatwalk.field) left -= 1;
      if (left > 0) requestAnimationFrame(frame);
      else resolve((performance.now() - begin) / 1000);
    };
    requestAnimationFrame(frame);
  });
}

/** Notes how long each message of a worker keeps the page's thread busy, with all that follows from it at once. */
function timeAnswers() {
  // Longer than the chain of promises that leads from an answer to the buffers of the renderer.
  const MICROTASKS = 500;
  const busy = [];
  Object.defineProperty(window, 'busyMs', { value: busy });
  const listen = Worker.prototype.addEventListener;
  Worker.prototype.addEventListener = function (type, listener, options) {
    if (type !== 'message') return listen.call(this, type, listener, options);
    const timed = (event) => {
      const begin = performance.now();
      let left = MICROTASKS;
      const follow = () => (--left > 0 ? queueMicrotask(follow) : busy.push(performance.now() - begin));
      listener.call(this, event);
      follow();
    };
    return listen.call(this, type, timed, options);
  };
}

/** The pixel nearest to the middle of the free area that shows the model. */
function pixelOnModel() {
  const { heatwalk } = window;
  const [cx, cy] = heatwalk.centre;
  for (let radius = 0; radius < 150; radius += 5) {
    for (let angle = 0; angle < 2 * Math.PI; angle += 0.5) {
      const [x, y] = [cx + radius * Math.cos(angle), cy + radius * Math.sin(angle)];
      if (heatwalk.placeAt(x, y)) return [x, y];
    }
  }
  throw new Error('The model is not in the picture.');
}

function isPainted() {
  return Object.values(window.heatwalk.scene.ground.faces).some((code) => code > 0);
}

/** Places on the model in rows, there and back, down from the middle and then from the top. */
function rowsOnModel({ rows, pace }) {
  const { heatwalk, innerHeight, innerWidth } = window;
  const middle = heatwalk.centre[1];
  const count = Math.floor(innerHeight / rows);
  const row = (index) => {
    const y = (middle + index * rows) % innerHeight;
    const places = Array.from({ length: Math.floor(innerWidth / pace) }, (_, place) => [place * pace, y]);
    // Not where something else lies over it.
    const on = places.filter(([x]) => heatwalk.placeAt(x, y) && document.elementFromPoint(x, y)?.closest('.stage'));
    return index % 2 ? on.toReversed() : on;
  };
  const points = Array.from({ length: count }, (_, index) => row(index)).flat();
  if (points.length === 0) throw new Error('The model is not in the picture.');
  return points;
}

/** Moves the pointer from place to place, and from the last to the first; the first is out of the reach of a click. */
async function followPlaces({ points, seconds, hertz }) {
  const { heatwalk, busyMs } = window;
  const stage = document.querySelector('.stage');
  const move = ([clientX, clientY]) =>
    stage.dispatchEvent(
      new PointerEvent('pointermove', {
        clientX,
        clientY,
        pointerId: 1,
        pointerType: 'mouse',
        buttons: 1,
        bubbles: true,
      }),
    );
  // So that the drag begins.
  move(points[0]);
  const { solves } = heatwalk;
  busyMs.length = 0;
  const begin = performance.now();
  const passed = () => (performance.now() - begin) / 1000;
  let moves = 0;
  let frames = 0;
  let counting = true;
  const frame = () => {
    frames += 1;
    if (counting) requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  await new Promise((resolve) => {
    const timer = setInterval(() => {
      move(points[Math.floor(hertz * passed()) % points.length]);
      moves += 1;
      if (passed() < seconds) return;
      clearInterval(timer);
      resolve();
    }, 1000 / hertz);
  });
  counting = false;
  const perSecond = (count) => count / passed();
  busyMs.sort((a, b) => a - b);
  return {
    fields: perSecond(heatwalk.solves - solves),
    frames: perSecond(frames),
    moves: perSecond(moves),
    usual: busyMs[busyMs.length >> 1],
    longest: busyMs.at(-1),
  };
}
