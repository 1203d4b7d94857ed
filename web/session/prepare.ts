/** The first answer of a mesh that has just been opened. */
import type { MeshInput, Moment, OpenedMesh, Source } from '../protocol';
import type { Wanted } from '../solver/client';
import type { Answer, Engine, Question } from '../solver/engine';
import { convertible } from '../length';
import { Cancelled } from '../solver/remote';
import { fits, LEVEL } from '../state/ground';
import { Places } from '../state/places';
import { type Animation, isRefined, type SceneState, STILL } from '../state/scene';
import { allSources, UNCHOSEN } from '../state/sources';
import { MODEL_STYLE } from '../state/styles';
import { reducedMotion } from '../view/motion';
import { AUTOMATIC } from '../wasm/contract';
import { firstSource } from './first';
import type { Mesh } from './found';
import type { Words } from '../texts';

export interface Shown {
  opened: OpenedMesh;
  places: Places;
  answer: Answer;
}

/** What is placed on a mesh. */
export type Placed = Pick<SceneState, 'sources' | 'sets' | 'walker' | 'tapes' | 'decals'>;
export type Transfer = (mesh: Mesh) => Promise<Placed>;

export interface OpenRequest {
  title: Words;
  load: () => Promise<MeshInput>;
  state: SceneState;
  /** Puts a source and a walker where the state has none. */
  choosePlaces: boolean;
  /** Shows the file as its author made it: in its materials and in motion, where it has these. */
  asAuthored?: true;
  /** Finds what is placed, in the place of what the state has. */
  transfer?: Transfer;
  /** Yaw and pitch to frame from when the state has no camera; null keeps the camera as it is. */
  view: readonly [number, number] | null;
}

/** The request for a mesh that was opened, in the style and the motion that suit it. */
export function suited(request: OpenRequest, { appearance, clips }: OpenedMesh): OpenRequest {
  const { asAuthored, ...rest } = request;
  const state = { ...rest.state };
  if (asAuthored && appearance) state.style = MODEL_STYLE;
  if (asAuthored && clips.length > 0) state.animation = { ...STILL, clip: 0, plays: !reducedMotion() };
  const { clip, seconds } = state.animation;
  if (clip !== null) {
    const end = clips.at(clip)?.seconds;
    const inClip = { ...state.animation, seconds: Math.min(seconds, end ?? 0) };
    state.animation = end === undefined ? STILL : inClip;
  }
  return { ...rest, state };
}

/** Where an animation stands; null: as in the file. */
export function momentOf({ clip, seconds }: Animation): Moment | null {
  return clip === null ? null : { clip, seconds };
}

/** What a scene asks the solver, with a full field. `method`: that by which it can be asked now. */
export function questionOf(state: SceneState, method = state.method): Question {
  const { windows, parameters, bridge, links, ground, inside, walker, pathKind, animation, refine } = state;
  const sources = allSources(state);
  const moment = animation.live ? momentOf(animation) : null;
  return {
    sources,
    method,
    windows,
    parameters,
    bridge,
    links,
    ground,
    inside,
    moment,
    from: walker ?? null,
    pathKind,
    quick: false,
    refines: isRefined({ method, refine }),
  };
}

/** What a scene wants of its mesh. The memory limit of the heat method is one for factors alone. */
export function wantedOf({ parts, method, windows, parameters, up, triangles, fill }: SceneState): Wanted {
  return method === 'heat'
    ? { parts, parameters, up, triangles, fill, budget: { windows: 0, memory: AUTOMATIC } }
    : { parts, parameters: null, up, triangles, fill, budget: { windows, memory: parameters.memory } };
}

/** Makes the state fit the mesh and solves it for the first time. */
export async function prepare(engine: Engine, request: OpenRequest): Promise<{ state: SceneState; shown: Shown }> {
  const { opened } = engine;
  const places = new Places(opened);
  const mesh = { engine, opened, places };
  const placed = await (request.transfer ? request.transfer(mesh) : placedOn(mesh, request.state));
  let { sources, walker } = placed;
  const { sets, tapes, decals } = placed;
  const { sources: wanted } = request.state;
  const areNone = wanted.length === 0 && wanted !== UNCHOSEN;
  const isWithout = request.choosePlaces && !areNone && sources.length + sets.length === 0;
  const { inputVertices, faces: triangles } = opened.report;
  const isFitting = fits(request.state.ground, { triangles, inputVertices });
  const ground = isFitting ? request.state.ground : { ...LEVEL };
  const answerTo = (some: readonly Source[]) => ask(engine, { ...request.state, sources: some, sets, walker, ground });
  let answer: Answer;
  if (isWithout) {
    ({ sources, answer } = await firstSource(places, answerTo));
  } else answer = await answerTo(sources);
  if (request.choosePlaces && walker === undefined && answer.field) {
    walker = places.farthest(answer.field);
    const { posed } = answer;
    answer = { ...(await ask(engine, { ...request.state, sources, sets, walker, ground })), posed };
  }
  const { mesh: reference } = request.state;
  return {
    state: {
      ...request.state,
      ...usable(request.state, opened),
      mesh: 'hash' in reference ? { ...reference, hash: opened.hash } : reference,
      sources,
      sets,
      walker: walker ?? null,
      tapes,
      decals,
      ground,
      links: Math.min(request.state.links, answer.factoring.links),
      selected: -1,
    },
    shown: { opened, places, answer },
  };
}

/**
 * Of parts, units and planes, what is for a mesh: a girth is of a surface, a cut of tetrahedra. What is simplified, or filled, is one
 * part in the place of those of the file.
 */
function usable({ parts, hidden, girth, inside, ...units }: SceneState, opened: OpenedMesh): Partial<SceneState> {
  const isWhole = opened.simplified !== null || opened.interior !== null;
  const isThere = (part: number) => isWhole || part < opened.parts.length;
  return {
    parts: parts.filter(isThere),
    hidden: hidden.filter(isThere),
    ...(opened.interior ? { girth: null, inside } : { girth, inside: { ...inside, cut: 'none' } }),
    ...convertible(units, opened),
  };
}

/** What of a state is on a mesh. */
async function placedOn(mesh: Mesh, { sources, sets, walker, tapes, decals }: SceneState): Promise<Placed> {
  const { places } = mesh;
  return {
    sources: sources.filter((source) => places.has(source)),
    // Where there are none, what finds their places is not fetched.
    sets: sets.length > 0 ? await (await import('./found')).found(mesh, sets) : [],
    walker: walker && !places.has(walker) ? undefined : walker,
    tapes: tapes.filter(({ points }) => points.every((point) => places.has(point))),
    decals: decals.filter(({ place }) => places.has(place)),
  };
}

async function ask(engine: Engine, state: SceneState): Promise<Answer> {
  const answer = await engine.ask(questionOf(state));
  if (!answer) throw new Cancelled();
  return answer;
}
