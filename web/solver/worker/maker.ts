/** Shapes, made by a module that is loaded with the first of them. */
import makerAddress from '../../wasm/maker/heatwalk_maker_bg.wasm?url';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { onDemand } from './demand';

const maker = onDemand(async () => {
  const module = await import('../../wasm/maker/heatwalk_maker.js');
  await module.default({ module_or_path: makerAddress });
  return module;
});

/** Makes the shape of this name. */
export async function makeShape(name: string): Promise<wasm.MeshFile> {
  const { make, __wbg_reset_state: renew } = await maker();
  try {
    return wasm.MeshFile.made(make(name));
  } finally {
    // As for files: memory of the last one goes back, and a trap ends nothing else.
    renew();
  }
}
