import { expect, test } from '@playwright/test';
import { CrowdWalk } from '../../web/session/crowd';
import type { Session } from '../../web/session/session';

test('a crowd that is wanted is there once all is settled, though no frame has come', async () => {
  const shown: Float32Array[] = [];
  const engine = { queries: { crowd: async () => {}, stepCrowd: async () => new Float32Array(12) } };
  const session = {
    engine,
    shown: { value: { answer: { field: {} }, opened: {}, places: { diameter: 1 } } },
    scene: { state: { crowd: 3 } },
    paused: { value: true },
    view: { setCrowd: (poses: Float32Array) => shown.push(poses) },
    fail: (error: unknown) => {
      throw error;
    },
  };
  const crowd = new CrowdWalk(session as unknown as Session);
  await crowd.settled();
  expect(shown).toEqual([new Float32Array(12)]);
  session.scene.state.crowd = 0;
  await crowd.settled();
  expect(shown.at(-1)).toEqual(new Float32Array());
});
