import './style/colors.css';
import './style/page.css';
import './style/overlay.css';
import './style/panel.css';
// Last: for narrow windows, reduced motion and forced colours it overrides the others.
import './style/windows.css';
import { detailsOf, messageOf, sentenceOf } from './error';
import { Address } from './session/address';
import { CrowdWalk } from './session/crowd';
import { Frames } from './session/frames';
import { GroundEditor } from './session/ground';
import { type InputFiles, Opener } from './session/opener';
import { Overlays } from './session/overlays';
import { Session } from './session/session';
import { FIRST_PRESET } from './state/presets';
import { Scene } from './state/history';
import { Signal } from './state/signal';
import { type Tool, WORKSPACE_OF } from './state/tool';
import type { Workspace } from './state/workspace';
import { commandsOf, cutOpen } from './ui/commands';
import { h } from './ui/dom';
import { dropTarget, fileDialogue, folderDialogue } from './ui/input/drop';
import { keysAhead } from './ui/input/ahead';
import { BrushInput } from './ui/input/brush';
import { MeasureInput } from './ui/measure/input';
import { DrawInput } from './ui/input/draw';
import type { Handles } from './ui/input/handles';
import { PointerInput } from './ui/input/pointer';
import { Keys } from './ui/input/keys';
import { followPaste } from './ui/input/paste';
import { heading } from './ui/overlay/heading';
import { followInsets } from './ui/overlay/insets';
import { loadingBar } from './ui/overlay/loading';
import { Messages } from './ui/overlay/messages';
import { Readout } from './ui/overlay/readout';
import { toolbar } from './ui/overlay/toolbar';
import type { Panel } from './ui/panel/panel';
import { workspacePanel } from './ui/panel/workspaces';
import { CompareSection } from './ui/panel/compare';
import { MeasureSection } from './ui/panel/measure';
import { expose, type Script } from './ui/scripting';
import { Stage } from './ui/stage/stage';
import { followTheme } from './view/theme';
import { View } from './view/view';
import { t } from './texts';
import { trustOwnScripts } from './trusted';

trustOwnScripts();

const page = document.body;
const stage = h('main', {
  class: 'stage',
  tabindex: 0,
  'aria-label': t('Model. Arrow keys orbit, Enter sets the source at the center.'),
});
page.append(stage);

const scene = new Scene(FIRST_PRESET.start);
const wishes = new URLSearchParams(location.search);
const view = new View(stage, wishes.get('gpu') === 'webgl');
view.drawsAllPixels = wishes.get('resolution') === 'full';
const session = new Session(scene, view);
const openFiles = (input: InputFiles) => void opener.files(input);
const dialogue = fileDialogue(openFiles);
const folders = folderDialogue(openFiles);
const messages = new Messages(dialogue.choose);
const tool = new Signal<Tool>('source');
const ground = new GroundEditor(session, tool);
const opener = new Opener(session, messages);
const address = new Address(scene);
messages.sumsUp = !address.kiosk;
const known = location.hash;
const readout = new Readout(session);
const { workspace } = address;
/** What stays beside the open one, where the window has room. */
const pinned = new Signal<Workspace | null>(null);

const hint = h('div', { class: 'hint', hidden: true });
const overlays = new Overlays(session);
const crowd = new CrowdWalk(session);
const measure = new MeasureInput(session, tool);
const measuring = new MeasureSection(session, measure, tool);
const comparing = new CompareSection(session);
const draw = new DrawInput(session, tool);
const over = new Stage(session, () => frames.cameraMoved());
let handles: Handles | null = null;
const frames = new Frames(session, crowd, {
  drawn: () => {
    comparing.follow();
    measuring.follow();
    over.follow();
    handles?.follow();
    readout.follow();
  },
  rested: () => pointer.look(),
});
const cameraMoved = () => frames.cameraMoved();
const fail = session.fail.bind(session);
const help = () => {
  import('./ui/help/dialog').then(({ openHelp }) => openHelp(session, panel?.element ?? null, fail), fail);
};

const search = () => {
  const ahead = keysAhead();
  import('./ui/search/search')
    .then(({ openSearch }) => openSearch(commands, opener, panel, ahead))
    .catch(fail)
    .finally(ahead);
};
const menu = (beside: HTMLButtonElement) => {
  const options = {
    opener,
    chooseFile: dialogue.choose,
    chooseFolder: folders.choose,
    presets: panel && (() => panel?.show('scene')),
  };
  import('./ui/overlay/openmenu').then(({ openMenu }) => openMenu(beside, options), fail);
};

const brush = new BrushInput(session, ground, tool);
// A tool and its settings are there together.
tool.watch((chosen) => {
  const home = WORKSPACE_OF[chosen];
  if (home && home !== pinned.value) workspace.value = home;
});
const putAway = () => {
  const home = WORKSPACE_OF[tool.value];
  if (home && home !== workspace.value && home !== pinned.value) tool.value = 'source';
};
for (const each of [workspace, pinned]) each.watch(putAway);
const pointer = new PointerInput({ session, readout, tool, brush, measure, draw, cameraMoved });
pointer.listen();
const commands = commandsOf({
  session,
  opener,
  ground,
  tool,
  stage: over,
  chooseFile: dialogue.choose,
  chooseFolder: folders.choose,
  help,
  search,
  cameraMoved,
});
const keys = new Keys({
  session,
  readout,
  tool,
  ground,
  measure,
  draw,
  commands,
  cameraMoved,
  closeMessage: () => messages.closeNewest(),
});

followPaste(opener);

const head = heading(session, { open: menu, search, share: address.kiosk ? null : () => panel?.show('share'), help });
const bar = toolbar(session, tool, over, address.kiosk ? null : workspace, pinned, () => cutOpen(session, opener));
page.append(
  comparing.layer,
  head,
  h('section', { class: 'foot', 'aria-label': t('Tools') }, hint, bar),
  messages.element,
  loadingBar(session),
  measuring.labels,
  readout.element,
  keys.reticle,
  dropTarget(openFiles, (dragged) => void opener.address(dragged)),
  dialogue.element,
  folders.element,
);
/** The first picture is there, or cannot be. */
const first = Promise.withResolvers<void>();
let panel: Panel | null = null;
if (!address.kiosk) {
  let asked: Promise<HTMLElement> | null = null;
  messages.question = () => (asked ??= import('./ui/overlay/question').then(({ question }) => question(session)));
  const parts = {
    session,
    opener,
    ground,
    tool,
    measuring,
    comparing,
    chooseFile: dialogue.choose,
    chooseFolder: folders.choose,
    link: () => address.link(),
    frames,
    legend: over.legend,
    girth: async () => (await over.girth()).section,
  };
  panel = workspacePanel(parts, workspace, pinned, first.promise);
  page.append(panel.element);
}
followInsets(view, head, bar, panel?.element ?? null);
overlays.follow();
session.turntable.watch((turns, turned) => {
  if (turned && !turns) frames.cameraMoved();
});

followTheme(view);
for (const place of [stage, panel?.element])
  place?.addEventListener('pointerdown', () => messages.goOn(place === stage));
view.trouble.watch((trouble) => messages.blind(trouble, () => void view.start()));
view.failure.watch((failure) => {
  if (failure) messages.fail(messageOf(failure), detailsOf(failure));
});
session.failure.watch((failure) => {
  if (!failure) return;
  messages.fail(sentenceOf(failure), detailsOf(failure), opener.remedy(failure));
});

/** What nobody has caught: a handler has failed, and the page goes on. */
const unforeseen = (error: unknown) => {
  if (error instanceof Error) messages.fail(t`Something went wrong: ${messageOf(error)}`, detailsOf(error));
};
addEventListener('error', ({ error }) => unforeseen(error));
addEventListener('unhandledrejection', ({ reason }) => unforeseen(reason));

frames.start();
async function begin(): Promise<void> {
  await Promise.all([view.start(), opener.link(known)]);
  await new Promise(requestAnimationFrame);
}
const host = { session, messages, commands, link: () => address.link() };
let script: Script | null = null;
const answered = async () => {
  await measuring.settled();
  await comparing.settled();
};
expose(
  session,
  begin().finally(first.resolve),
  async () => {
    await overlays.settled();
    await crowd.settled();
    await answered();
    await over.load();
    await over.settled();
  },
  answered,
  measuring,
  () => import('./ui/control/script').then(({ scriptOf }) => (script ??= scriptOf(host, window.heatwalk))),
);
void first.promise.then(() => over.load());
first.promise
  .then(async () => {
    const { state } = scene;
    const { afterFirstPicture } = await import('./later');
    ({ handles } = afterFirstPicture({
      session,
      tool,
      draw,
      opener,
      openFiles,
      address,
      known,
      messages,
      panel,
      hint,
      state,
    }));
  })
  .catch(fail);
// Only in a frame is there anybody to answer.
if (window.parent !== window) {
  void import('./ui/embedding/embedding').then(({ answerHost }) => answerHost(host, window.heatwalk));
}
