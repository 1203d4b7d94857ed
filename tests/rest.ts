/** Runs in the page, until the camera stands still. */
export async function cameraAtRest(): Promise<void> {
  let before = '';
  for (let same = 0; same < 4;) {
    const place = JSON.stringify(window.heatwalk.camera);
    same = place === before ? same + 1 : 0;
    before = place;
    await new Promise(requestAnimationFrame);
  }
}
