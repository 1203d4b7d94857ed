// Ten thousand agents on a torus that follow the pointer, in three.js.
import { Mesh as Surface } from 'heatwalk';
import * as three from 'three';

const AGENTS = 10_000;
const RADIUS = 0.008;

export async function show(canvas) {
  const geometry = new three.TorusKnotGeometry(1, 0.35, 500, 100);
  const { position } = geometry.attributes;
  const surface = await Surface.from({ positions: position.array, indices: geometry.index.array });
  const agents = surface.agents();
  const starts = Uint32Array.from({ length: AGENTS }, () => Math.floor(Math.random() * position.count));
  await agents.add(starts, RADIUS, 0.15);

  const renderer = new three.WebGLRenderer({ canvas, antialias: true });
  const scene = new three.Scene().add(new three.HemisphereLight(0xffffff, 0x445566, 3));
  const camera = new three.PerspectiveCamera(45, canvas.width / canvas.height, 0.1, 20).translateZ(5);
  const body = new three.CapsuleGeometry(RADIUS, 3 * RADIUS, 2, 6).translate(0, 2.5 * RADIUS, 0);
  const ground = new three.Mesh(geometry, new three.MeshLambertMaterial({ color: 0xddd6c8 }));
  const instanced = new three.InstancedMesh(body, new three.MeshLambertMaterial({ color: 0xd81b60 }), AGENTS);
  scene.add(ground, instanced);

  const lead = async (x, y) => {
    const ray = new three.Raycaster();
    ray.setFromCamera(new three.Vector2(x, y), camera);
    const [hit] = ray.intersectObject(ground);
    if (hit) await agents.follow(hit.point);
  };
  canvas.addEventListener('pointermove', ({ offsetX, offsetY }) =>
    lead((2 * offsetX) / canvas.clientWidth - 1, 1 - (2 * offsetY) / canvas.clientHeight),
  );
  await agents.follow(0);

  let last = performance.now();
  const frame = async () => {
    const now = performance.now();
    const { matrices } = await agents.update(Math.min(0.05, (now - last) / 1000));
    last = now;
    instanced.instanceMatrix.array.set(matrices);
    instanced.instanceMatrix.needsUpdate = true;
    renderer.render(scene, camera);
    requestAnimationFrame(frame);
  };
  await frame();
  return { agents, renderer, instanced };
}
