// npm start: builds what has changed, serves the page and prints its address.

import { buildModules } from './bundle.mjs';
import { prepare } from './needs.mjs';
import { fail, root } from './steps.mjs';

prepare();
buildModules();
const { createServer } = await import('vite');
const port = process.env.PORT ? Number(process.env.PORT) : undefined;
try {
  const server = await createServer({ root, server: { port, strictPort: port !== undefined } });
  await server.listen();
  console.log('\nHeatwalk is served at');
  server.printUrls();
} catch (error) {
  fail(`The page could not be served: ${error.message}. Choose another port with PORT=5180 npm start.`);
}
