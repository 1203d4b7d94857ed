/** The brush: what it paints, and how large it is. */

export const MATERIALS = ['mud', 'sand', 'road', 'custom', 'wall', 'gate', 'eraser'] as const;
export type Material = (typeof MATERIALS)[number];

export const TOOLS = ['brush', 'fill', 'line', 'toggle'] as const;
/** What a click or a drag on the surface does: paints; fills the area under it; goes on with a wall along edges; opens and closes. */
export type GroundTool = (typeof TOOLS)[number];

export interface Brush {
  tool: GroundTool;
  material: Material;
  /** Of the custom material. */
  cost: number;
  /** As a share of the diameter of the mesh. */
  radius: number;
  /** The share of the radius over which the cost fades. */
  soft: number;
}

/** Least and largest radius. */
export const RADII = [0.005, 0.2] as const;

export const BRUSH: Brush = { tool: 'brush', material: 'mud', cost: 8, radius: 0.04, soft: 0 };

/** What materials cost. */
export const MATERIAL_COSTS = { mud: 4, sand: 2, road: 0.5, eraser: 1 } as const;
