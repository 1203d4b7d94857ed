/** Tetrahedra made in code, as a file of Gmsh 2.2. */

/** The six tetrahedra of a cube around its diagonal, by corners whose bits are x, y and z. */
const KUHN = [
  [0, 1, 3, 7],
  [0, 1, 5, 7],
  [0, 2, 3, 7],
  [0, 2, 6, 7],
  [0, 4, 5, 7],
  [0, 4, 6, 7],
];

/** The vertex at (i, j, k) / n of `cubeMsh`. */
export function cubeVertex(n: number, i: number, j: number, k: number): { vertex: number } {
  return { vertex: i + (n + 1) * (j + (n + 1) * k) };
}

/** The unit cube in n³ cubes of six tetrahedra. */
export function cubeMsh(n: number): string {
  return cubesMsh(n, () => true);
}

/** Those of its n³ cubes that are `kept`. */
export function cubesMsh(n: number, kept: (i: number, j: number) => boolean): string {
  const nodes: string[] = [];
  const elements: string[] = [];
  for (let k = 0; k <= n; k++) {
    for (let j = 0; j <= n; j++) {
      for (let i = 0; i <= n; i++) nodes.push(`${nodes.length + 1} ${i / n} ${j / n} ${k / n}`);
    }
  }
  for (let k = 0; k < n; k++) {
    for (let j = 0; j < n; j++) {
      for (let i = 0; i < n; i++) {
        if (!kept(i, j)) continue;
        for (const corners of KUHN) {
          const at = (corner: number) =>
            1 + cubeVertex(n, i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2)).vertex;
          elements.push(`${elements.length + 1} 4 0 ${corners.map(at).join(' ')}`);
        }
      }
    }
  }
  return `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n${nodes.length}\n${nodes.join('\n')}\n$EndNodes\n$Elements\n${elements.length}\n${elements.join('\n')}\n$EndElements\n`;
}
