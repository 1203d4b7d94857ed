// What a headless Chromium is started with, in tests and benchmarks of the page.

export const ALWAYS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
/** Its own rasterizer, the same on every machine. */
export const WEBGL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
/** Mesa's takes half the time. */
export const MESA = ['--use-angle=gl-egl', '--ignore-gpu-blocklist'];
/** As where the system asks for less transparency: what floats over the canvas is opaque, and put together in a quarter of the time. */
export const OPAQUE = '--blink-settings=prefersReducedTransparency=true';
/** All of them together: any fewer give a blank canvas without an error. */
export const WEBGPU = [
  ...WEBGL,
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--ignore-gpu-blocklist',
];
