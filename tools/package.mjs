// npm run package: the npm package as it would be published.

import { statSync } from 'node:fs';
import { relative } from 'node:path';
import { publishPackageModules } from './bundle.mjs';
import { prepare } from './needs.mjs';
import { packPackage } from './npm.mjs';
import { root } from './steps.mjs';

prepare();
publishPackageModules();
const file = await packPackage(true);
console.log(`\n${relative(root, file)} has ${statSync(file).size.toLocaleString('en')} bytes.`);
