import './style/page.css';
import './style/overlay.css';
import './style/panel.css';
// Last: for narrow windows, reduced motion and forced colours it overrides the others.
import './style/windows.css';
import { Address } from './address';
import { CrowdWalk } from './crowd';
import { Frames } from './frames';
import { dropTarget, fileDialogue } from './input/drop';
import { Hands } from './input/hands';
import { Keys } from './input/keys';
import { Opener } from './opener';
import { Overlays } from './overlays';
import { heading } from './overlay/heading';
import { loadingBar } from './overlay/loading';
import { followInsets } from './overlay/insets';
import { Messages } from './overlay/messages';
import { Readout } from './overlay/readout';
import { toolbar, type Tool } from './overlay/toolbar';
import { h } from './panel/dom';
import { lookSection } from './panel/look-section';
import { numbersSection } from './panel/numbers-section';
import { buildPanel } from './panel/panel';
import { sceneSection } from './panel/scene-section';
import { shareSection } from './panel/share-section';
import { showSection } from './panel/show-section';
import { solverSection } from './panel/solver-section';
import { sourcesSection } from './panel/sources-section';
import { FIRST_PRESET } from './presets';
import { Scene } from './scene';
import { expose } from './scripting';
import { Session } from './session';
import { Signal } from './signal';
import { followTheme } from './theme';
import { View } from './view';

const page = document.body;
const stage = h('main', {
  class: 'stage',
  tabindex: 0,
  'aria-label': 'Model. Arrows turn it, Enter sets a source at the centre.',
});
page.append(stage);

const scene = new Scene(FIRST_PRESET.start);
const view = new View(stage, new URLSearchParams(location.search).get('gpu') === 'webgl');
const session = new Session(scene, view);
const dialogue = fileDialogue((files) => void opener.files(files));
const messages = new Messages(dialogue.choose);
const opener = new Opener(session, messages);
const address = new Address(scene, opener);
const readout = new Readout(session);
const tool = new Signal<Tool>('source');

const touch = matchMedia('(pointer: coarse)').matches ? 'Tap' : 'Click';
const hint = h('p', { class: 'hint', hidden: true }, `${touch} the surface`);
const acted = () => hint.remove();
const overlays = new Overlays(session);
const crowd = new CrowdWalk(session);
const frames = new Frames(session, crowd);
const cameraMoved = () => {
  acted();
  frames.cameraMoved();
};

new Hands({ session, readout, tool, acted, cameraMoved }).listen();
const keys = new Keys({
  session,
  readout,
  tool,
  acted,
  cameraMoved,
  chooseFile: dialogue.choose,
  closeMessage: () => messages.closeNewest(),
});

const bar = toolbar(session, tool);
page.append(
  heading(session),
  h('div', { class: 'foot' }, hint, bar),
  messages.element,
  loadingBar(session),
  readout.element,
  keys.reticle,
  dropTarget((files) => void opener.files(files)),
  dialogue.element,
);
let panel: HTMLElement | null = null;
if (!address.kiosk) {
  const sections = [
    { id: 'scene', title: 'Scene', element: sceneSection(session, opener, dialogue.choose), open: true },
    { id: 'sources', title: 'Sources', element: sourcesSection(session), open: true },
    { id: 'solver', title: 'Solver', element: solverSection(session), open: false },
    { id: 'look', title: 'Look', element: lookSection(session), open: true },
    { id: 'show', title: 'Show', element: showSection(session), open: false },
    { id: 'numbers', title: 'Numbers', element: numbersSection(session), open: false },
    { id: 'share', title: 'Share and export', element: shareSection(session, () => address.link()), open: false },
  ];
  panel = buildPanel(sections);
  page.append(panel);
}
followInsets(view, bar, panel);
overlays.follow();
session.turntable.watch((turns, turned) => {
  if (turned && !turns) frames.cameraMoved();
});

followTheme(view);
view.trouble.watch((trouble) => messages.blind(trouble, () => void view.start()));
session.failure.watch((failure) => {
  if (!failure) return;
  messages.fail(failure.message, failure.stack ?? '', opener.remedy(failure));
});

frames.start();
async function begin(): Promise<void> {
  await Promise.all([view.start(), opener.link(location.hash)]);
  hint.hidden = false;
  await new Promise(requestAnimationFrame);
}
expose(session, begin(), async () => {
  await overlays.settled();
  await crowd.settled();
});
