/** Where the page that is tested has been bundled: see tools/bundle.mjs. */
export const PAGE = 'target/page';
export const SINGLE = 'target/page-single';
