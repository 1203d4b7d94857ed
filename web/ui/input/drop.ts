/** Files from a drag or from the file dialog. */
import { FORMATS } from '../../session/opener';
import { h } from '../dom';

/** The quiet frame over the whole canvas while files are dragged over the window. */
export function dropTarget(open: (files: File[]) => void): HTMLElement {
  const frame = h(
    'div',
    { class: 'drop', hidden: true },
    h('div', {}, h('p', {}, 'Drop a mesh'), h('small', {}, FORMATS)),
  );
  // dragenter and dragleave come in pairs for every element that is crossed.
  let depth = 0;
  const show = (change: number) => {
    depth = Math.max(0, depth + change);
    frame.hidden = depth === 0;
  };
  addEventListener('dragenter', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    show(1);
  });
  addEventListener('dragleave', (event) => {
    if (hasFiles(event)) show(-1);
  });
  addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
  });
  addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    show(-depth);
    open([...(event.dataTransfer?.files ?? [])]);
  });
  return frame;
}

/** The file dialogue; returns the input, which must be in the page, and the function that shows it. */
export function fileDialogue(open: (files: File[]) => void): { element: HTMLElement; choose: () => void } {
  const input = h('input', {
    type: 'file',
    multiple: true,
    accept: '.obj,.off,.ply,.stl,.glb,.gltf,.bin',
    hidden: true,
    'aria-label': 'Open mesh files',
    onchange: () => {
      open([...(input.files ?? [])]);
      // The same file may be chosen again.
      input.value = '';
    },
  });
  return { element: input, choose: () => input.click() };
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}
