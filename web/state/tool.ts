/** What the pointer does. */
import type { Workspace } from './workspace';

/** Tools that draw many sources at once; they are chosen in the list of sources. */
export const DRAWING = ['line', 'stroke', 'boundary', 'part'] as const;

/** What a plain click or tap does; modifiers reach the others. */
export type Tool = 'source' | 'add' | 'walker' | 'measure' | 'brush' | (typeof DRAWING)[number];

export function draws(tool: Tool): boolean {
  return DRAWING.some((drawing) => drawing === tool);
}

/** Where the settings of a tool are, of those that belong to one task. */
export const WORKSPACE_OF: Partial<Record<Tool, Workspace>> = { measure: 'measure', brush: 'ground' };
