import type { Plugin } from 'vite';

const PACKAGE = /\/d3-scale-chromatic\/dist\/d3-scale-chromatic\.mjs$/;
/** A scheme of ColorBrewer's: lists of colors, by how many there are. */
const SCHEME = /= (new Array\(3\)\.concat\([^)]*\)\.map\(colors\));/g;

/** Lets go of the color schemes that nobody asks for: that package makes each by calls that a bundler has to leave in. */
export function schemes(): Plugin {
  return {
    name: 'heatwalk-schemes',
    transform: {
      filter: { id: PACKAGE },
      handler(code) {
        const marked = code.replaceAll(SCHEME, '= /* @__PURE__ */ (() => $1)();');
        if (marked === code) this.error('d3-scale-chromatic makes its color schemes in another way now.');
        return { code: marked, map: null };
      },
    },
  };
}
