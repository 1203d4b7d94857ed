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
