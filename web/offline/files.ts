/** What the build tells the service worker. */
export interface KeptFiles {
  /** Differs between builds of different content. */
  build: string;
  /** A file that only the page of this build names. */
  page: string;
  /** Paths of all other files, relative to the page. */
  files: readonly string[];
}
