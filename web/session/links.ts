/** Links between groups of components that stay apart. */
import type { Session } from './session';

/** Links the nearest group that no source reaches to what they reach. */
export async function linkNearest(session: Session): Promise<void> {
  const { engine, scene } = session;
  if (!engine) return;
  try {
    const links = await engine.queries.linksToReachMore();
    // Meanwhile another mesh may have come, or another number of links.
    if (engine === session.engine && links > scene.state.links) scene.edit({ links });
  } catch (error) {
    session.fail(error);
  }
}

/** Links all groups. */
export function linkAll({ scene, shown }: Session): void {
  const factoring = shown.value?.answer.factoring;
  if (factoring && factoring.groups > 1) scene.edit({ links: factoring.links + factoring.groups - 1 });
}
