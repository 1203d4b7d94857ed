/** What the page has beside the first picture, and is fetched after it. */
import type { Address } from './session/address';
import { Entries } from './session/entries';
import type { InputFiles, Opener } from './session/opener';
import type { Session } from './session/session';
import { keepVersion } from './session/version';
import type { SceneState } from './state/scene';
import type { Signal } from './state/signal';
import type { Tool } from './state/tool';
import type { DrawInput } from './ui/input/draw';
import { type Handles, handlesOf } from './ui/input/handles';
import { followLaunches } from './ui/input/launch';
import { announcer } from './ui/overlay/announcer';
import { showHints } from './ui/overlay/hints';
import type { Messages } from './ui/overlay/messages';
import type { Panel } from './ui/panel/panel';
import { followSwipes } from './ui/panel/swipe';

interface Parts {
  session: Session;
  tool: Signal<Tool>;
  draw: DrawInput;
  opener: Opener;
  openFiles: (input: InputFiles) => void;
  address: Address;
  /** The fragment that the page was opened with. */
  known: string;
  messages: Messages;
  panel: Panel | null;
  /** Where hints stand. */
  hint: HTMLElement;
  /** The scene of the first picture. */
  state: SceneState;
}

export function afterFirstPicture(parts: Parts): { handles: Handles; entries: Entries } {
  const { session, tool, draw, opener, openFiles, address, known, messages, panel, hint, state } = parts;
  showHints(hint, session, tool, state);
  document.body.append(announcer(session));
  followLaunches(openFiles);
  if (panel) followSwipes(panel.element);
  // Without it the page is one that needs its network.
  keepVersion(messages).catch(() => undefined);
  return { handles: handlesOf(session, draw), entries: new Entries(session.scene, opener, address, known) };
}
