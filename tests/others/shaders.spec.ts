/** Shaders of `heatwalk-gpu` as a browser takes them: its compiler refuses what that of wgpu lets pass. */
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { chromium, expect, test } from '@playwright/test';
import { ALWAYS, WEBGPU } from '../../tools/chromium.mjs';

const SOURCES = 'crate/gpu/src';
const ROUND = ['window', 'patch', 'front', 'round'];

const read = (path: string) => readFileSync(`${SOURCES}/${path}`, 'utf8');
const shader = (name: string) => read(`shaders/${name}.wgsl`);

/** The constants of small and of large patches, as `pipelines.rs` writes them. */
function constants(): string[] {
  const [, passes] = /PASSES: usize = (\d+)/.exec(read('pipelines.rs')) ?? [];
  const capacities = read('patches.rs').matchAll(/Capacity \{ faces: (\d+), edges: (\d+), vertices: (\d+) \}/g);
  return [...capacities].map(([, faces, edges, vertices]) =>
    Object.entries({ FACES: faces, EDGES: edges, VERTICES: vertices, PASSES: passes })
      .map(([name, value]) => `const ${name} = ${value}u;\n`)
      .join(''),
  );
}

test('Chromium compiles the shaders of distance within the default limits', async () => {
  const rounds = constants().map((text): [string, string] => ['advance', text + ROUND.map(shader).join('')]);
  expect(rounds).toHaveLength(2);
  const others = ['clear', 'gather'].map((name): [string, string] => [name, shader(name)]);
  // WebGPU is there on a page of a host alone.
  const server = createServer((_, response) => response.end()).listen(0, 'localhost');
  const browser = await chromium.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: [...ALWAYS, ...WEBGPU],
    ignoreDefaultArgs: ['--disable-gpu'],
  });
  try {
    const page = await browser.newPage();
    await page.goto(`http://localhost:${(server.address() as AddressInfo).port}/`);
    expect(await page.evaluate(messages, [...rounds, ...others])).toEqual([]);
  } finally {
    await browser.close();
    server.close();
  }
});

/** What a device says of pipelines, each an entry point and its text. */
async function messages(pipelines: [string, string][]): Promise<string[]> {
  const adapter = await navigator.gpu.requestAdapter();
  if (!adapter) return ['there is no adapter'];
  const device = await adapter.requestDevice();
  const said: string[] = [];
  for (const [entryPoint, code] of pipelines) {
    const module = device.createShaderModule({ code });
    const information = await module.getCompilationInfo();
    said.push(...information.messages.map(({ lineNum, message }) => `${entryPoint}, line ${lineNum}: ${message}`));
    const pipeline = device.createComputePipelineAsync({ layout: 'auto', compute: { module, entryPoint } });
    await pipeline.catch((error: unknown) => said.push(String(error)));
  }
  return said;
}
