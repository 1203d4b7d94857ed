/** The first answer of a mesh that has just been opened. */
import type { Answer, Engine } from './engine';
import { Places } from './places';
import type { SceneState } from './scene';
import type { OpenRequest, Shown } from './session';
import { Cancelled } from './solver-worker';

/** Makes the state fit the mesh and solves it for the first time. */
export async function prepare(engine: Engine, request: OpenRequest): Promise<{ state: SceneState; shown: Shown }> {
  const { opened } = engine;
  const places = new Places(opened);
  const { parameters, way } = request.state;
  let sources = request.state.sources.filter((source) => places.has(source));
  let walker = request.state.walker && places.has(request.state.walker) ? request.state.walker : null;
  if (request.choosePlaces && sources.length === 0) sources = [places.extreme([0.5, 0.4, 0.75])];
  let answer = await ask(engine, { sources, parameters, from: walker, way, quick: false });
  if (request.choosePlaces && !walker && answer.field) {
    walker = places.farthest(answer.field.distance);
    answer = await ask(engine, { sources, parameters, from: walker, way, quick: false });
  }
  const { mesh } = request.state;
  return {
    state: {
      ...request.state,
      mesh: mesh.kind === 'file' ? { ...mesh, hash: opened.hash } : mesh,
      sources,
      walker,
      selected: -1,
    },
    shown: { opened, places, answer },
  };
}

async function ask(engine: Engine, question: Answer['question']): Promise<Answer> {
  const answer = await engine.ask(question);
  if (!answer) throw new Cancelled();
  return answer;
}
