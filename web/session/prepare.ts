/** The first answer of a mesh that has just been opened. */
import type { MeshInput, OpenedMesh } from '../protocol';
import type { Wanted } from '../solver/client';
import type { Answer, Engine, Question } from '../solver/engine';
import { Cancelled } from '../solver/remote';
import { Places } from '../state/places';
import type { SceneState } from '../state/scene';
import { MODEL_STYLE } from '../state/styles';
import { AUTOMATIC } from '../wasm/contract';

export interface Shown {
  opened: OpenedMesh;
  places: Places;
  answer: Answer;
}

export interface OpenRequest {
  title: string;
  load: () => Promise<MeshInput>;
  state: SceneState;
  /** Puts a source and a walker where the state has none. */
  choosePlaces: boolean;
  /** Shows the materials of the file where it has some. */
  inMaterialsOfFile?: true;
  /** Yaw and pitch to frame from when the state has no camera; null keeps the camera as it is. */
  view: readonly [number, number] | null;
}

/** The request for a mesh that was opened, in the style that suits it. */
export function styled(request: OpenRequest, { appearance }: OpenedMesh): OpenRequest {
  const { inMaterialsOfFile, ...rest } = request;
  return inMaterialsOfFile && appearance ? { ...rest, state: { ...rest.state, style: MODEL_STYLE } } : rest;
}

/** What a scene asks the solver, with a full field. `method`: that by which it can be asked now. */
export function questionOf(state: SceneState, method = state.method): Question {
  const { sources, windows, parameters, bridge, links, walker, pathKind } = state;
  return { sources, method, windows, parameters, bridge, links, from: walker, pathKind, quick: false };
}

/** What a scene wants of its mesh. The memory limit of the heat method is one for factors alone. */
export function wantedOf({ parts, method, windows, parameters, up }: SceneState): Wanted {
  return method === 'heat'
    ? { parts, parameters, up, room: { windows: 0, memory: AUTOMATIC } }
    : { parts, parameters: null, up, room: { windows, memory: parameters.memory } };
}

/** Makes the state fit the mesh and solves it for the first time. */
export async function prepare(engine: Engine, request: OpenRequest): Promise<{ state: SceneState; shown: Shown }> {
  const { opened } = engine;
  const places = new Places(opened);
  let sources = request.state.sources.filter((source) => places.has(source));
  let walker = request.state.walker && places.has(request.state.walker) ? request.state.walker : null;
  if (request.choosePlaces && sources.length === 0) sources = [places.extreme([0.5, 0.4, 0.75])];
  let answer = await ask(engine, { ...request.state, sources, walker });
  if (request.choosePlaces && !walker && answer.field) {
    walker = places.farthest(answer.field.distance);
    answer = await ask(engine, { ...request.state, sources, walker });
  }
  const { mesh } = request.state;
  return {
    state: {
      ...request.state,
      mesh: 'hash' in mesh ? { ...mesh, hash: opened.hash } : mesh,
      sources,
      walker,
      selected: -1,
    },
    shown: { opened, places, answer },
  };
}

async function ask(engine: Engine, state: SceneState): Promise<Answer> {
  const answer = await engine.ask(questionOf(state));
  if (!answer) throw new Cancelled();
  return answer;
}
