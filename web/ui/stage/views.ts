/** The model from the front, from the side and from above, as a whole, and on the whole screen: a menu, and keys. */
import '../../style/views.css';
import type { Session } from '../../session/session';
import { attribute, h, say } from '../dom';
import { KEYS, keyName } from '../keys';
import { narrow } from '../panel/panel';
import { placeMenu } from '../popover';
import { t, type Words } from '../../texts';

/** Yaw and pitch of the camera, radians. */
const DIRECTIONS = {
  front: [0, 0],
  side: [Math.PI / 2, 0],
  top: [0, Math.PI / 2],
} as const;

export type ViewName = keyof typeof DIRECTIONS | 'fit' | 'parallel' | 'screen';

const ITEMS: readonly { name: ViewName; words: Words }[] = [
  { name: 'front', words: t('Front') },
  { name: 'side', words: t('Side') },
  { name: 'top', words: t('Top') },
  { name: 'fit', words: t('Fit') },
  { name: 'parallel', words: t('Orthographic') },
  { name: 'screen', words: t('Full screen') },
];

/** `moved`: called where the camera moves. */
export async function show(name: ViewName, { view, scene }: Session, moved: () => void): Promise<void> {
  if (name === 'screen') {
    if (document.fullscreenElement) await document.exitFullscreen();
    else if (document.fullscreenEnabled) await document.documentElement.requestFullscreen();
    return;
  }
  if (name === 'parallel') {
    scene.set({ orthographic: !scene.state.orthographic });
    return;
  }
  const { camera } = view;
  // The direction changes at once, as all else of the camera does by `frame` smoothly.
  if (name !== 'fit' && camera) view.camera = [...DIRECTIONS[name], ...camera.slice(2)];
  view.frame();
  moved();
}

/** Opens the menu at its button, or closes it. */
export function toggleMenu(button: HTMLElement, session: Session, choose: (name: ViewName) => void): void {
  menuOf(button, session, choose).togglePopover();
}

const menus = new WeakMap<HTMLElement, HTMLElement>();

function menuOf(button: HTMLElement, { scene }: Session, choose: (name: ViewName) => void): HTMLElement {
  const made = menus.get(button);
  if (made) return made;
  const items = ITEMS.filter(({ name }) => name !== 'screen' || document.fullscreenEnabled).map(({ name, words }) => {
    const key = keyName(KEYS[name]);
    const chosen = () => {
      menu.hidePopover();
      choose(name);
    };
    const label = h('span', {}, words);
    const item = h(
      'button',
      {
        role: name === 'parallel' ? 'menuitemcheckbox' : 'menuitem',
        tabindex: -1,
        'aria-keyshortcuts': String(key),
        onclick: chosen,
      },
      label,
      h('kbd', { 'aria-hidden': 'true' }, key),
    );
    return { name, item, label };
  });
  const menu = h(
    'div',
    { class: 'views', role: 'menu', popover: 'auto', 'aria-label': t('Views') },
    ...items.map(({ item }) => item),
  );
  attribute(button, 'aria-haspopup', 'menu');
  menu.addEventListener('toggle', (event) => {
    const isOpen = (event as ToggleEvent).newState === 'open';
    button.setAttribute('aria-expanded', String(isOpen));
    const hadFocus = menu.contains(document.activeElement);
    if (!isOpen) {
      if (hadFocus || document.activeElement === document.body) button.focus();
      return;
    }
    const parallel = items.find(({ name }) => name === 'parallel');
    parallel?.item.setAttribute('aria-checked', String(scene.state.orthographic));
    const full = items.find(({ name }) => name === 'screen');
    if (full) say(full.label, document.fullscreenElement ? t('Leave full screen') : t('Full screen'));
    placeMenu(menu, button, narrow() ? 'beside' : 'above');
    items[0]?.item.focus();
  });
  menu.addEventListener('keydown', (event) => {
    const at = items.findIndex(({ item }) => item === document.activeElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
    // What goes back out of the menu goes back out of nothing else.
    if (to !== undefined || event.key === 'Escape') event.stopPropagation();
    if (to === undefined) return;
    event.preventDefault();
    items.at(to % items.length)?.item.focus();
  });
  document.body.append(menu);
  menus.set(button, menu);
  return menu;
}
