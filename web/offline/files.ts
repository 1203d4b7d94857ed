/** What the build tells the service worker. */
export interface KeptFiles {
  /** Differs between builds of different content. */
  build: string;
  /** A file that only the page of this build names. */
  page: string;
  /** Paths of the files that are named by their content, relative to the page. */
  files: readonly string[];
  /** Paths of the documents and of what they need, relative to the page. */
  documents: readonly string[];
}

/** What a page asks the service worker: which page its build has, and to serve from now on, which it declines by null. */
export interface Question {
  heatwalk: 'page' | 'take over';
}
