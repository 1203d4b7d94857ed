/** What the pointer does. */

/** Tools that draw many sources at once; they are chosen in the list of sources. */
export const DRAWING = ['line', 'stroke', 'boundary', 'part'] as const;

/** What a plain click or tap does; modifiers reach the others. */
export type Tool = 'source' | 'add' | 'walker' | 'measure' | (typeof DRAWING)[number];

export function draws(tool: Tool): boolean {
  return DRAWING.some((drawing) => drawing === tool);
}
