import { floats, integers } from './arrays.ts';
import type { Connection } from './connection.ts';
import { withInitial } from './initial.ts';
import type { DistanceOptions, QueryOptions } from './options.ts';
import { encodePlaces, encodeVector, type Places, type Vector } from './places.ts';

/** Where agents are, in the order in which they were added. */
export interface AgentPoses {
  /** Three coordinates of each. */
  positions: Float32Array;
  /** Quaternions x, y, z, w, from a model that stands along y and looks along −z. */
  orientations: Float32Array;
  /** Both as a matrix of 16 numbers, column after column, as instances of three.js and Babylon.js have it. */
  matrices: Float32Array;
  /** Three of each, in the unit of positions a second. */
  velocities: Float32Array;
  /** The numbers of those that touch a source, or one that has arrived and is nearer to it. */
  arrived: Uint32Array;
}

/** What agents make way for: a ball in space. */
export interface Obstacle {
  position: Vector;
  radius: number;
  /** In the unit of positions a second; zero if not given. */
  velocity?: Vector | undefined;
}

/** The number of the last group: that of one is never that of another, in whatever worker. */
let last = 0;

/** One number for all agents, or one for each. */
type Each = number | ArrayLike<number>;

/**
 * Agents that walk on a mesh to the nearest source, and make way for each other and for obstacles. They never leave the surface nor cross a wall.
 * A question that is aborted leaves them as they were before it.
 */
export class Agents {
  readonly #connection: Connection;
  readonly #number = ++last;
  readonly #hasBegun: Promise<unknown>;

  /** @internal */
  constructor(connection: Connection) {
    this.#connection = connection;
    this.#hasBegun = connection.ask('begin', [], {}, this.#number);
    // Whoever asks first is told.
    this.#hasBegun.catch(() => {});
  }

  /** Adds agents at places, with radii in the unit of positions and speeds in that a second. */
  async add(places: Places, radius: Each, speed: Each): Promise<void> {
    const at = encodePlaces(places, 'place');
    const count = at.length / 5;
    await this.#ask('add_agents', [at, each(radius, count, 'radii'), each(speed, count, 'speeds')]);
  }

  /** Puts agents elsewhere, where they stand still. */
  async put(agents: ArrayLike<number>, places: Places): Promise<void> {
    await this.#ask('put_agents', [integers(agents, 'agent'), encodePlaces(places, 'place')]);
  }

  /** Takes agents away; those behind move up. */
  async remove(agents: ArrayLike<number>): Promise<void> {
    await this.#ask('remove', [integers(agents, 'agent')]);
  }

  /** Sends them to the nearest source from now on, as `distance` finds it. */
  async follow(sources: Places, options: DistanceOptions = {}): Promise<void> {
    const { signal, progress, ...method } = withInitial(options);
    await this.#ask('lead_agents', [encodePlaces(sources, 'source'), method], { signal, progress });
  }

  /** What they make way for from now on. */
  async setObstacles(obstacles: readonly Obstacle[]): Promise<void> {
    const numbers = obstacles.flatMap(({ position, radius, velocity = [0, 0, 0] }, k) => [
      ...encodeVector(position, `position of obstacle ${k}`),
      ...encodeVector(velocity, `velocity of obstacle ${k}`),
      Number(radius),
    ]);
    await this.#ask('set_obstacles', [Float64Array.from(numbers)]);
  }

  /** Moves them by so many seconds; tells where they are then. */
  async update(seconds: number, options?: QueryOptions): Promise<AgentPoses> {
    return (await this.#ask('update', [Number(seconds)], options)) as AgentPoses;
  }

  /** Gives their memory back. */
  dispose() {
    this.#ask('end', []).catch(() => {});
  }

  async #ask(method: string, args: unknown[], options?: QueryOptions): Promise<unknown> {
    await this.#hasBegun;
    return this.#connection.ask(method, args, options, this.#number);
  }
}

const each = (value: Each, count: number, name: string) =>
  typeof value === 'number' ? new Float64Array(count).fill(value) : floats(value, name);
