import { createRequire } from 'node:module';
import { expect, test } from '@playwright/test';
import { meshes } from '../../tools/vite/meshes';

test('a packed mesh has the numbers of its package', async () => {
  const require = createRequire(import.meta.url);
  const path = require.resolve('bunny');
  const { transform } = meshes();
  if (typeof transform !== 'object') throw new Error('The plugin has no transform.');
  const made = transform.handler.call({} as never, '', path) as { code: string };
  const address = `data:text/javascript;base64,${Buffer.from(made.code).toString('base64')}`;
  const { default: mesh } = (await import(address)) as { default: unknown };
  const { positions, cells } = require('bunny') as Record<string, unknown>;
  expect(mesh).toEqual({ positions, cells });
});
