/** Shapes, made by a module that is loaded with the first of them. */
import makerAddress from '../../wasm/maker/heatwalk_maker_bg.wasm?url';
import * as wasm from '../../wasm/solver/heatwalk_worker.js';
import { inFreshInstance, moduleOnDemand } from './demand';

const maker = moduleOnDemand(() => import('../../wasm/maker/heatwalk_maker.js'), makerAddress);

/** Makes the shape of this name. */
export function makeShape(name: string): Promise<wasm.MeshFile> {
  return inFreshInstance(maker, ({ make }) => wasm.MeshFile.made(make(name)));
}
