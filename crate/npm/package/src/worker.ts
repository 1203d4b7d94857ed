import { type Agents, initSync, Mesh } from '../../../../web/wasm/package/heatwalk_npm.js';
import * as reader from '../../../../web/wasm/package-reader/heatwalk_reader.js';
import { KEEP_AGENTS, type KeptAgents, type Question, type Told } from './messages.ts';
import { builtin } from './spawn.ts';

type Method = (...args: unknown[]) => unknown;

/** Agents, and what they were last told, which is told to those of the next worker; of one before, not made yet. */
type Group = { agents: Agents; told: KeptAgents['told'] } | KeptAgents;

interface NodePort {
  on(event: 'message', hear: (question: Question) => void): void;
  postMessage(message: Told, transfer?: ArrayBufferLike[]): void;
}

let mesh: Mesh | undefined;
let isSingle = false;
/** Groups of agents by their numbers. */
const groups = new Map<number, Group>();
const tell = connected();

/** Hears questions from now on; gives what tells answers. */
function connected(): (message: Told, transfer?: ArrayBufferLike[]) => void {
  if ('WorkerGlobalScope' in globalThis) {
    globalThis.addEventListener('message', ({ data }: MessageEvent<Question>) => answer(data));
    return (message, transfer = []) => globalThis.postMessage(message, { transfer: transfer as Transferable[] });
  }
  const { parentPort } = builtin<{ parentPort: NodePort }>('node:worker_threads');
  parentPort.on('message', answer);
  return (message, transfer) => parentPort.postMessage(message, transfer);
}

function answer(question: Question) {
  const { id, opening } = question;
  const progress = (stage: string, fraction: number) => tell({ id, fraction, stage });
  try {
    if (opening) {
      mesh = opened(opening);
      isSingle = opening.mesh.isSingle;
      for (const kept of opening.agents) groups.set(kept.number, kept);
    }
    if (!mesh) throw new Error('a question came before the mesh');
    // Nothing of it is transferred, for it stays here too.
    if (question.method === KEEP_AGENTS) return tell({ id, value: keptAgents() });
    const value = answered(mesh, question, progress);
    const told = isSingle ? single(value) : value;
    tell({ id, value: told }, buffers(told));
  } catch (error) {
    tell({ id, ...failure(error) });
  }
}

function opened({ modules, mesh: opening }: NonNullable<Question['opening']>): Mesh {
  initSync({ module: modules.solver });
  if ('positions' in opening) return Mesh.of(opening.positions, opening.indices, opening.options);
  const { name, bytes, resources, options } = opening;
  if (!modules.reader) throw new Error('files need the module that reads them');
  const { ReadMesh, initSync: beginReader, __wbg_reset_state: renew } = reader;
  beginReader({ module: modules.reader });
  const packed = ReadMesh.read(name, bytes, (uri: string) => resources[uri]).take();
  // Its memory goes back.
  renew();
  return Mesh.of_packed(packed, options);
}

type Tell = (stage: string, fraction: number) => void;

function answered(of: Mesh, { method, args, agents }: Question, progress: Tell): unknown {
  if (agents !== undefined) return answeredBy(agents, of, method, args, progress);
  return method === 'matrix' ? matrix(of, args, progress) : called(of, method, [...args, progress]);
}

/** Of agents: what the mesh has to do with it is a method of the mesh, and all else one of theirs. */
function answeredBy(number: number, of: Mesh, method: string, args: unknown[], progress: Tell): unknown {
  if (method === 'begin') return void groups.set(number, { agents: of.agents(), told: {} });
  if (method === 'end') return end(number);
  const { agents, told } = present(number, of, progress);
  const given = method in agents ? called(agents, method, args) : called(of, method, [agents, ...args, progress]);
  if (method === 'lead_agents' || method === 'set_obstacles') told[method] = args;
  return given;
}

/** A group; one of a worker before is made as it was. */
function present(number: number, of: Mesh, progress: Tell) {
  const group = groups.get(number);
  if (!group) {
    throw Object.assign(new Error('the agents are gone with the worker; make others'), { name: 'no-agents' });
  }
  if ('agents' in group) return group;
  const { state, told } = group;
  const agents = of.agents();
  if (told.lead_agents) called(of, 'lead_agents', [agents, ...told.lead_agents, progress]);
  if (told.set_obstacles) called(agents, 'set_obstacles', told.set_obstacles);
  agents.restore(state);
  const made = { agents, told };
  groups.set(number, made);
  return made;
}

function end(number: number) {
  const group = groups.get(number);
  groups.delete(number);
  if (group && 'agents' in group) group.agents.free();
}

/** All groups as they are, for the next worker. */
const keptAgents = (): KeptAgents[] =>
  Array.from(groups, ([number, group]) =>
    'agents' in group ? { number, state: group.agents.state(), told: group.told } : group,
  );

const called = (of: object, method: string, args: unknown[]) => (of as Record<string, Method>)[method]?.(...args);

/** Rows in the type that answers have, so that none is there twice. */
function matrix(of: Mesh, [sources, targets, options]: unknown[], progress: Tell) {
  const rows = (sources as Float64Array).length / 5;
  const columns = (targets as Uint32Array).length;
  const data = isSingle ? new Float32Array(rows * columns) : new Float64Array(rows * columns);
  const put = (row: number, values: Float64Array) => data.set(values, row * columns);
  of.rows(sources as Float64Array, targets as Uint32Array, options as object, put, progress);
  return { data, rows, columns };
}

/** The same with all its numbers in single precision. */
function single(value: unknown): unknown {
  if (value instanceof Float64Array) return Float32Array.from(value);
  if (Array.isArray(value)) return value.map(single);
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([key, held]) => [key, single(held)]));
}

/** The memory of all arrays in an answer. */
function buffers(value: unknown): ArrayBufferLike[] {
  if (ArrayBuffer.isView(value)) return [value.buffer];
  return typeof value === 'object' && value !== null ? Object.values(value).flatMap(buffers) : [];
}

/** A trap without a sentence is memory that was refused. */
function failure(error: unknown): { code: string; message: string; isFatal: boolean } {
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) {
    return { code: 'out-of-memory', message: 'there is not enough memory; use a mesh with fewer triangles', isFatal: true };
  }
  const { name, message } = error as Error;
  if (name === 'Error') return { code: 'bad-parameter', message, isFatal: false };
  if (/^[a-z-]+$/.test(name)) return { code: name, message, isFatal: false };
  return { code: 'panic', message: `Heatwalk has an error of its own, please report it: ${message}`, isFatal: true };
}
