import { expect, test } from '@playwright/test';
import { expose, wrap } from 'comlink';
import { handedOver } from '../../web/solver/transfer';

test('a message takes its buffers along, each once, however deep they are', async () => {
  const { port1, port2 } = new MessageChannel();
  const [numbers, bytes] = [new Float32Array([1, 2, 3]), new Uint8Array([4])];
  const message = { field: { numbers, tail: numbers.subarray(1) }, parts: [null, { bytes }], name: 'all' };
  const expected = structuredClone(message);
  expose({ ask: () => handedOver(message) }, port1);
  expect(await wrap<{ ask(): typeof message }>(port2).ask()).toEqual(expected);
  expect([numbers.buffer.byteLength, bytes.buffer.byteLength]).toEqual([0, 0]);
  port1.close();
});
