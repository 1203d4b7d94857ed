/**
 * The renderer's module, in one build for each graphics interface. A browser fetches the build that it can use: what
 * WebGL2 needs to check and translate shaders is most of its bytes, and a browser with WebGPU brings that along.
 */
import webgl2Address from '../wasm/viewer-webgl2/heatwalk_viewer_webgl2_bg.wasm?url';
import webgpuAddress from '../wasm/viewer-webgpu/heatwalk_viewer_webgpu_bg.wasm?url';

type WebGpuBindings = typeof import('../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js');

/** What both builds have. */
type Bindings = Pick<WebGpuBindings, 'Viewer' | '__wbg_reset_state'> & {
  default: (source: { module_or_path: Response }) => Promise<unknown>;
};

class Build {
  readonly #address: string;
  readonly #bindings: () => Promise<Bindings>;
  #loaded: Promise<Bindings> | null = null;

  constructor(address: string, bindings: () => Promise<Bindings>) {
    this.#address = address;
    this.#bindings = bindings;
  }

  /** The class of the renderer in a fresh instance of the module: nothing of an earlier instance may be used any more. */
  async fresh(): Promise<Bindings['Viewer']> {
    if (this.#loaded) {
      const { Viewer, __wbg_reset_state: resetInstance } = await this.#loaded;
      resetInstance();
      return Viewer;
    }
    this.#loaded = this.#load();
    try {
      return (await this.#loaded).Viewer;
    } catch (error) {
      // The next start tries again.
      this.#loaded = null;
      throw error;
    }
  }

  async #load(): Promise<Bindings> {
    const [response, bindings] = await Promise.all([fetch(this.#address), this.#bindings()]);
    await bindings.default({ module_or_path: response });
    return bindings;
  }
}

export const WEBGPU = new Build(webgpuAddress, () => import('../wasm/viewer-webgpu/heatwalk_viewer_webgpu.js'));
export const WEBGL2 = new Build(webgl2Address, () => import('../wasm/viewer-webgl2/heatwalk_viewer_webgl2.js'));

export type { Build };

/** Whether the browser has an adapter for WebGPU: many have the interface without one. */
export async function hasWebGpu(): Promise<boolean> {
  try {
    return Boolean(await navigator.gpu?.requestAdapter({ powerPreference: 'high-performance' }));
  } catch {
    return false;
  }
}
