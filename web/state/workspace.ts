/** What the panel is open at: the settings of one task each. */
export const WORKSPACES = ['scene', 'look', 'measure', 'ground', 'inside', 'solve', 'share'] as const;
export type Workspace = (typeof WORKSPACES)[number];

export const FIRST_WORKSPACE: Workspace = 'scene';

export function isWorkspace(name: string | null): name is Workspace {
  return WORKSPACES.some((workspace) => workspace === name);
}
