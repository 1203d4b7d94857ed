export { type AgentPoses, Agents, type Obstacle } from './agents.ts';
export type * from './answers.ts';
export { HeatwalkError } from './errors.ts';
export { init, Mesh, type Source } from './mesh.ts';
export type * from './options.ts';
export type { Place, Places, Vector } from './places.ts';
