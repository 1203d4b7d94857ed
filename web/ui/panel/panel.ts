/** The floating panel: the workspaces, one of which is open, and their sections; on a narrow window a sheet with two stops. */
import { entry } from '../../state/entry';
import type { Signal } from '../../state/signal';
import { WORKSPACES, type Workspace } from '../../state/workspace';
import { attribute, h, icon, say } from '../dom';
import { arrowOf } from '../gesture';
import { remember, remembered } from '../memory';
import { t, type Words } from '../../texts';

export interface Section {
  id: string;
  title: Words;
  /** Of one that is loaded: asked for when it is seen first, or before, by `Panel.load`. */
  element: HTMLElement | (() => Promise<HTMLElement>);
  /** Not before it is seen. */
  onSight?: true;
  /** Until the user expands or collapses it. */
  open: boolean;
  /** Until there is something to show in it. */
  hidden?: true;
  /** The `id` that an earlier version of the page remembered it by. */
  formerId?: string;
}

export interface WorkspaceContent {
  name: Words;
  /** Of a 20 × 20 line drawing. */
  icon: string;
  sections: readonly Section[];
}

export interface Panel {
  element: HTMLElement;
  /** What scrolls. */
  body: HTMLElement;
  /** In the body: the sheets of all workspaces in their order, and what is below every one. */
  column: HTMLElement;
  sheets: readonly HTMLElement[];
  /** Loads all sections but those that wait until they are seen. */
  load(): Promise<void>;
  /** Opens a workspace. */
  show(name: Workspace): void;
  /** Opens the workspace and the section of a control, scrolls there and gives it the focus. */
  reveal(control: HTMLElement): void;
}

const MEMORY = 'heatwalk.panel';
/** The workspace that is pinned. */
export const PINNED = 'heatwalk.panel.pinned';

/** `open`: the workspace that is; `common`: what is below every one of them. */
export function buildPanel(
  workspaces: Record<Workspace, WorkspaceContent>,
  common: readonly Section[],
  open: Signal<Workspace>,
): Panel {
  const memory = stops();
  const loads: (() => Promise<void>)[] = [];
  const build = ({ id, formerId, title, element, open: isFirst, hidden, onSight }: Section) => {
    const isOpen = memory[id] ?? (formerId ? memory[formerId] : undefined) ?? isFirst;
    const part = typeof element === 'function' ? later(element) : { element, load: () => Promise.resolve() };
    if (!onSight) loads.push(part.load);
    const details = h(
      'details',
      { open: isOpen, hidden: hidden ?? false, id: `section-${id}` },
      h('summary', {}, title),
      part.element,
    );
    details.addEventListener('toggle', () => keep(id, details.open));
    return details;
  };
  const sheets = WORKSPACES.map((name) =>
    h(
      'div',
      { role: 'tabpanel', id: `workspace-${name}`, 'aria-labelledby': `tab-${name}` },
      ...workspaces[name].sections.map(build),
    ),
  );
  const column = h('div', { class: 'panel-column' }, ...sheets, ...common.map(build));
  const body = h('div', { class: 'panel-body', id: 'panel-body' }, column);
  const element = h('aside', { class: 'panel', 'aria-label': t('Panel') });
  const handle = h('button', {
    class: 'panel-handle',
    'aria-controls': 'panel-body',
    onclick: () => setOpen(element.dataset.open !== 'true'),
  });
  const setOpen = (isOpen: boolean) => {
    element.dataset.open = String(isOpen);
    handle.setAttribute('aria-expanded', String(isOpen));
    const name = isOpen ? t('Collapse the panel') : t('Expand the panel');
    attribute(handle, 'aria-label', name);
    attribute(handle, 'title', name);
    body.inert = !isOpen;
    keep('panel', isOpen);
  };
  const choose = (name: Workspace) => {
    // On a sheet the tab of what is open is the way back to the model.
    setOpen(!(narrow() && element.dataset.open === 'true' && open.value === name));
    open.value = name;
  };
  const strip = tabs(workspaces, open, choose);
  open.watch((name, previous) => {
    sheets.forEach((sheet, index) => (sheet.hidden = WORKSPACES[index] !== name));
    if (name !== previous) body.scrollTop = 0;
  });
  element.append(handle, strip, body);
  // On a narrow window the sheet begins at its lower stop, so that the model is seen first.
  setOpen(narrow() ? false : (memory.panel ?? true));
  return {
    element,
    body,
    column,
    sheets,
    load: async () => {
      await Promise.all(loads.map((load) => load()));
    },
    show: (name) => {
      open.value = name;
      setOpen(true);
    },
    reveal: (control) => {
      const sheet = sheets.findIndex((each) => each.contains(control) && column.contains(each));
      if (sheet >= 0) open.value = entry(WORKSPACES, sheet);
      setOpen(true);
      for (let at = control.closest('details'); at; at = at.parentElement?.closest('details') ?? null) at.open = true;
      control.scrollIntoView({ block: 'center' });
      control.focus();
    },
  };
}

/** A tab for each workspace; arrows go from one to the next, Home and End to the ends. */
function tabs(
  workspaces: Record<Workspace, WorkspaceContent>,
  open: Signal<Workspace>,
  choose: (name: Workspace) => void,
): HTMLElement {
  const buttons = WORKSPACES.map((name) =>
    h(
      'button',
      {
        role: 'tab',
        id: `tab-${name}`,
        'aria-controls': `workspace-${name}`,
        title: workspaces[name].name,
        onclick: () => choose(name),
      },
      icon(workspaces[name].icon),
      h('span', {}, workspaces[name].name),
    ),
  );
  open.watch((chosen) =>
    buttons.forEach((button, index) => {
      const isChosen = WORKSPACES[index] === chosen;
      button.setAttribute('aria-selected', String(isChosen));
      button.tabIndex = isChosen ? 0 : -1;
    }),
  );
  const strip = h('div', { class: 'tabs', role: 'tablist', 'aria-label': t('Workspaces') }, ...buttons);
  strip.addEventListener('keydown', (event) => {
    const step = arrowOf(event)?.[0];
    const count = WORKSPACES.length;
    const beside = step ? (WORKSPACES.indexOf(open.value) + step + count) % count : null;
    const next = event.key === 'Home' ? 0 : event.key === 'End' ? count - 1 : beside;
    if (next === null) return;
    event.preventDefault();
    open.value = entry(WORKSPACES, next);
    entry(buttons, next).focus();
  });
  return strip;
}

/** Stands for an element until it is loaded: when it is seen first, or asked for. */
function later(load: () => Promise<HTMLElement>): { element: HTMLElement; load: () => Promise<void> } {
  const place = h('div', { class: 'quiet' });
  let loading: Promise<void> | null = null;
  const fetch = () =>
    (loading ??= load().then(
      (element) => {
        observer.disconnect();
        place.replaceWith(element);
      },
      () => {
        // The next time that it is seen or asked for tries again.
        loading = null;
        say(place, t('This part of the page could not be loaded. Check the connection and reload the page.'));
      },
    ));
  const observer = new IntersectionObserver((entries) => {
    if (entries.some(({ isIntersecting }) => isIntersecting)) void fetch();
  });
  observer.observe(place);
  return { element: place, load: fetch };
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
