/** Packages of plain data that carry no types of their own. */
interface PlainMesh {
  positions: [number, number, number][];
  cells: [number, number, number][];
}

declare module 'bunny' {
  const mesh: PlainMesh;
  export default mesh;
}

declare module 'teapot' {
  const mesh: PlainMesh;
  export default mesh;
}

/** Of the page in one file: all documents as one page of HTML. */
declare module 'virtual:documents' {
  const html: string;
  export default html;
}
