/** Files and folders from a drag or from a dialogue. */
import { ACCEPTED, formats } from '../../files/paths';
import type { InputFiles } from '../../session/opener';
import { h } from '../dom';
import { draggedAddress, filesOf, itemsOf } from './files';
import { t, type Words } from '../../texts';

/** The quiet frame over the whole canvas while something to open is dragged over the window. */
export function dropTarget(open: (input: InputFiles) => void, fetch: (address: string) => void): HTMLElement {
  const frame = h(
    'div',
    { class: 'drop', hidden: true },
    h('div', {}, h('p', {}, t('Drop a mesh')), h('small', {}, formats())),
  );
  // dragenter and dragleave come in pairs for every element that is crossed.
  let depth = 0;
  const show = (change: number) => {
    depth = Math.max(0, depth + change);
    frame.hidden = depth === 0;
  };
  addEventListener('dragenter', (event) => {
    if (!isOpenable(event)) return;
    event.preventDefault();
    show(1);
  });
  addEventListener('dragleave', (event) => {
    if (isOpenable(event)) show(-1);
  });
  addEventListener('dragover', (event) => {
    if (!isOpenable(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
  });
  addEventListener('drop', (event) => {
    if (!isOpenable(event)) return;
    event.preventDefault();
    show(-depth);
    const { dataTransfer } = event;
    const address = dataTransfer && draggedAddress(dataTransfer);
    if (address) fetch(address);
    else if (dataTransfer?.types.includes('Files'))
      open({ ...itemsOf(dataTransfer.items), at: [event.clientX, event.clientY] });
  });
  return frame;
}

export interface Dialogue {
  /** The input, which must be in the page. */
  element: HTMLElement;
  /** Null where the browser has no such dialogue. */
  choose: (() => void) | null;
}

export function fileDialogue(open: (input: InputFiles) => void): Dialogue & { choose: () => void } {
  return dialogue({ multiple: true, accept: ACCEPTED, 'aria-label': t('Open mesh files') }, open);
}

export function folderDialogue(open: (input: InputFiles) => void): Dialogue {
  const { element, choose } = dialogue({ webkitdirectory: true, 'aria-label': t('Open a folder') }, open);
  return { element, choose: 'webkitdirectory' in element ? choose : null };
}

function dialogue(
  attributes: Record<string, Words | boolean>,
  open: (input: InputFiles) => void,
): Dialogue & { choose: () => void } {
  const input = h('input', {
    type: 'file',
    hidden: true,
    ...attributes,
    onchange: () => {
      open(filesOf(input.files ?? []));
      // The same file may be chosen again.
      input.value = '';
    },
  });
  return { element: input, choose: () => input.click() };
}

/** Files, and addresses from other pages: the content of a drag is not known before the drop. */
function isOpenable({ dataTransfer }: DragEvent): boolean {
  return dataTransfer?.types.some((type) => type === 'Files' || type === 'text/uri-list') ?? false;
}
