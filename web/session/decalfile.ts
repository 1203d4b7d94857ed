/** Images on the surface as a file. */
import { unitOf, unitOfFile } from '../length';
import type { DrawTransform } from '../protocol';
import { vectorAt } from '../state/vector';
import { laidImage } from '../view/decals';
import { pngOf } from '../view/decalimages';
import { GlbFile } from './glb';
import { filePlace } from './nearest';
import type { Shown } from './prepare';
import type { Session } from './session';

/** GLB: a node for each image with what of the surface it covers, its texture coordinates and the image. */
export async function decalsGlb(
  { decals, scene }: Session,
  { opened, places }: Shown,
): Promise<Uint8Array<ArrayBuffer>> {
  const { drawTransform: transform, surface } = opened;
  const turn: DrawTransform = { ...transform, center: [0, 0, 0], scale: 1 };
  const { scale } = unitOfFile('glb', unitOf(scene.state, opened));
  const file = new GlbFile();
  const [nodes, meshes, materials]: [object[], object[], object[]] = [[], [], []];
  for (const { index, image, laid } of decals.value) {
    const { mesh } = laidImage(surface, places.drawn, laid, image, index, places.drawnDiameter, false);
    const count = mesh.positions.length / 3;
    const rows = (place: (vertex: number) => readonly number[]) =>
      Float32Array.from(Array.from({ length: count }, (_, vertex) => place(vertex)).flat());
    const inFile = (vertex: number) =>
      filePlace(vectorAt(mesh.positions, vertex), transform).map((value) => scale * value);
    const attributes = {
      POSITION: file.vertices(rows(inFile), 'VEC3'),
      NORMAL: file.vertices(
        rows((vertex) => filePlace(vectorAt(mesh.normals, vertex), turn)),
        'VEC3',
      ),
      TEXCOORD_0: file.vertices(
        rows((vertex) => [mesh.texcoords[4 * vertex] ?? 0, mesh.texcoords[4 * vertex + 1] ?? 0]),
        'VEC2',
      ),
    };
    materials.push({
      pbrMetallicRoughness: {
        baseColorTexture: { index: file.texture(await pngOf(image)) },
        metallicFactor: 0,
        roughnessFactor: 0.7,
      },
      alphaMode: 'BLEND',
      doubleSided: true,
    });
    meshes.push({ primitives: [{ attributes, indices: file.indices(mesh.triangles), material: meshes.length }] });
    nodes.push({ name: `decal_${index + 1}`, mesh: nodes.length });
  }
  return file.finish({ scenes: [{ nodes: [...nodes.keys()] }], nodes, meshes, materials });
}
