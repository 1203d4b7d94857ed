/** The floating panel: sections that collapse and remember it; on a narrow window a sheet with two stops. */
import { attribute, h, say } from '../dom';
import { remember, remembered } from '../memory';
import { t, type Words } from '../../texts';

export interface Section {
  id: string;
  title: Words;
  /** Of one that is loaded: asked for when it is expanded first. */
  element: HTMLElement | (() => Promise<HTMLElement>);
  /** Until the user expands or collapses it. */
  open: boolean;
  /** Until there is something to show in it. */
  hidden?: true;
  /** The `id` that an earlier version of the page remembered it by. */
  formerId?: string;
}

const MEMORY = 'heatwalk.panel';

export function buildPanel(sections: readonly Section[]): HTMLElement {
  const memory = stops();
  const body = h('div', { class: 'panel-body', id: 'panel-body' });
  for (const { id, formerId, title, element, open, hidden } of sections) {
    const isOpen = memory[id] ?? (formerId ? memory[formerId] : undefined) ?? open;
    const details = h(
      'details',
      { open: isOpen, hidden: hidden ?? false, id: `section-${id}` },
      h('summary', {}, title),
      typeof element === 'function' ? later(element) : element,
    );
    details.addEventListener('toggle', () => keep(id, details.open));
    body.append(details);
  }
  const panel = h('aside', { class: 'panel', 'aria-label': t('Panel') });
  const handle = h('button', {
    class: 'panel-handle',
    'aria-controls': 'panel-body',
    onclick: () => setOpen(panel.dataset.open !== 'true'),
  });
  const setOpen = (open: boolean) => {
    panel.dataset.open = String(open);
    handle.setAttribute('aria-expanded', String(open));
    const name = open ? t('Collapse the panel') : t('Expand the panel');
    attribute(handle, 'aria-label', name);
    attribute(handle, 'title', name);
    body.inert = !open;
    keep('panel', open);
  };
  panel.append(handle, body);
  // On a narrow window the sheet begins at its lower stop, so that the model is seen first.
  setOpen(narrow() ? false : (memory.panel ?? true));
  return panel;
}

/** Stands for an element until its section is expanded. */
function later(load: () => Promise<HTMLElement>): HTMLElement {
  const place = h('div', { class: 'quiet' });
  new IntersectionObserver(([seen], observer) => {
    if (!seen?.isIntersecting) return;
    observer.disconnect();
    load().then(
      (element) => place.replaceWith(element),
      () => say(place, t('This part of the page could not be loaded. Check the connection and reload the page.')),
    );
  }).observe(place);
  return place;
}

export function narrow(): boolean {
  return matchMedia('(max-width: 719px)').matches;
}

function stops(): Record<string, boolean> {
  try {
    return JSON.parse(remembered(MEMORY) ?? '{}') as Record<string, boolean>;
  } catch {
    return {};
  }
}

function keep(id: string, open: boolean): void {
  remember(MEMORY, JSON.stringify({ ...stops(), [id]: open }));
}
