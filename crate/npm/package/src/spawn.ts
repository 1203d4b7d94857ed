import { HeatwalkError } from './errors.ts';
import type { Question, Told } from './messages.ts';
import { scripts } from './parts.ts';

/** A worker of a browser or of Node. */
export interface Port {
  post(message: Question): void;
  terminate(): void;
}

/** Of Node alone: its modules, without an import that bundlers for browsers would follow. */
export function builtin<T>(name: string): T {
  const found = (globalThis as { process?: { getBuiltinModule?(name: string): T } }).process?.getBuiltinModule?.(name);
  if (!found) throw new HeatwalkError('there are no workers here: a browser or Node 20.16 is needed', 'no-worker');
  return found;
}

/** How many of the scripts cannot be loaded. */
let missing = 0;

/** A script of this text: of data for Node, of a blob for browsers. */
export function scriptOf(text: string): URL {
  if (typeof Worker === 'undefined') return new URL(`data:text/javascript,${encodeURIComponent(text)}`);
  return new URL(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
}

interface NodeWorker {
  on(event: 'message', hear: (told: Told) => void): void;
  on(event: 'error', hear: (error: Error) => void): void;
  postMessage(message: Question, transfer: []): void;
  terminate(): void;
  unref(): void;
  ref(): void;
}

/** A worker; `hear` is given what it tells, `fail` why it cannot run. */
export async function spawn(hear: (told: Told) => void, fail: (reason: string) => void): Promise<Port> {
  let current: Port | undefined;
  let first: Question | undefined;
  let [hasTold, isOver] = [false, false];
  const begin = async (number: number) => {
    const script = await scripts()[number]?.();
    if (!script) throw new HeatwalkError('the worker of the package cannot be loaded', 'no-worker');
    if (isOver) return;
    current = started(
      script,
      (told) => {
        hasTold = true;
        hear(told);
      },
      (reason) => {
        current?.terminate();
        if (hasTold || number + 1 >= scripts().length) return fail(reason);
        // It is not there: the next one is the same.
        missing = Math.max(missing, number + 1);
        begin(number + 1).then(
          () => first && current?.post(first),
          (error: unknown) => fail(String(error)),
        );
      },
    );
  };
  await begin(missing);
  return {
    post(question) {
      if (!hasTold) first = question;
      current?.post(question);
    },
    terminate() {
      isOver = true;
      current?.terminate();
    },
  };
}

/** A worker of a script; in Node one that the process does not wait for unless it has a question. */
function started(script: URL, hear: (told: Told) => void, fail: (reason: string) => void): Port {
  if (typeof Worker === 'undefined') {
    const { Worker: Thread } = builtin<{ Worker: new (script: URL) => NodeWorker }>('node:worker_threads');
    const thread = new Thread(script);
    thread.on('message', (told) => {
      if (!('fraction' in told)) thread.unref();
      hear(told);
    });
    thread.on('error', (error) => fail(error.message));
    return {
      post(question) {
        thread.ref();
        thread.postMessage(question, []);
      },
      terminate: () => thread.terminate(),
    };
  }
  const worker = new Worker(reachable(script), { type: 'module', name: 'heatwalk' });
  worker.addEventListener('message', ({ data }: MessageEvent<Told>) => hear(data));
  worker.addEventListener('error', (event) => {
    event.preventDefault();
    fail(event.message || `${script.href} could not be loaded`);
  });
  return { post: (question) => worker.postMessage(question, []), terminate: () => worker.terminate() };
}

/** A script of another origin, as of a network of copies, can only be imported. */
function reachable(script: URL): URL | string {
  const isOther = typeof location !== 'undefined' && script.protocol.startsWith('http') && script.origin !== location.origin;
  if (!isOther) return script;
  return URL.createObjectURL(new Blob([`import ${JSON.stringify(script.href)};`], { type: 'text/javascript' }));
}
