import type { Plugin } from 'vite';

/** What the page says of where it is: read from the environment of the build, and left out where that says nothing. */
export function host(): Plugin {
  return {
    name: 'heatwalk-host',
    transformIndexHtml: {
      order: 'post',
      handler(html) {
        const { HEATWALK_ADDRESS: address, HEATWALK_SOURCE: source } = process.env;
        // Who shows a preview of a link wants whole addresses.
        const whole = address
          ? html.replace('content="social.jpg"', `content="${new URL('social.jpg', address).href}"`)
          : html;
        if (!source) return whole;
        return {
          html: whole,
          tags: [{ tag: 'meta', attrs: { name: 'heatwalk-source', content: source }, injectTo: 'head' }],
        };
      },
    },
  };
}
