/** What a table has for each index. An index that it has nothing for is a defect. */
export function through(indices: Uint32Array, table: Uint32Array): Uint32Array {
  return indices.map((index) => {
    const entry = table[index];
    if (entry === undefined) throw new RangeError(`there is no entry ${index} of ${table.length}`);
    return entry;
  });
}
