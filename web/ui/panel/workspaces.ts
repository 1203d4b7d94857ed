/** What each workspace of the panel holds. Only the first one is needed for the first picture; the others are loaded. */
import type { GroundEditor } from '../../session/ground';
import type { Frames } from '../../session/frames';
import type { Opener } from '../../session/opener';
import type { Session } from '../../session/session';
import type { Signal } from '../../state/signal';
import type { Tool } from '../../state/tool';
import type { Workspace } from '../../state/workspace';
import { chartsSection } from './charts';
import type { CompareSection } from './compare';
import type { MeasureSection } from './measure';
import { remembered } from '../memory';
import { buildPanel, type Panel, PINNED, type WorkspaceContent } from './panel';
import { sceneSection } from './scene';
import { sourcesSection } from './sources';
import { t } from '../../texts';

interface Parts {
  session: Session;
  opener: Opener;
  ground: GroundEditor;
  tool: Signal<Tool>;
  measuring: MeasureSection;
  comparing: CompareSection;
  chooseFile: () => void;
  chooseFolder: (() => void) | null;
  link: () => string;
  frames: Frames;
  /** Whether there is a legend. */
  legend: Signal<boolean>;
  /** The settings of the girth. */
  girth: () => Promise<HTMLElement>;
}

/** `drawn`: the first picture, after which all is loaded. */
export function workspacePanel(
  parts: Parts,
  open: Signal<Workspace>,
  pinned: Signal<Workspace | null>,
  drawn: Promise<void>,
): Panel {
  const { session, opener, ground, tool, measuring, comparing, chooseFile, chooseFolder, link, frames, legend, girth } =
    parts;
  const contents: Record<Workspace, WorkspaceContent> = {
    scene: {
      name: t('Scene'),
      icon: 'M10 2.5l6.5 3.500v8L10 17.500 3.500 14V6zM3.500 6l6.500 3.500L16.500 6M10 9.500v8',
      sections: [
        {
          id: 'scene',
          title: t('Scene'),
          element: sceneSection(session, opener, chooseFile, chooseFolder, drawn),
          open: true,
        },
        {
          id: 'animation',
          title: t('Animation'),
          element: async () => (await import('./animation')).animationSection(session),
          open: true,
          hidden: true,
        },
      ],
    },
    look: {
      name: t('Look'),
      icon: 'M2.500 10s3-5 7.500-5 7.500 5 7.500 5-3 5-7.500 5-7.500-5-7.500-5zM10 7.500a2.500 2.500 0 1 1 0 5 2.500 2.500 0 0 1 0-5z',
      sections: [
        {
          id: 'style',
          formerId: 'look',
          title: t('Style'),
          element: async () => (await import('./style')).styleSection(session),
          open: true,
        },
        {
          id: 'display',
          formerId: 'show',
          title: t('Display'),
          element: async () => (await import('./display')).displaySection(session, legend),
          open: true,
        },
        {
          id: 'decals',
          title: t('Images on the surface'),
          element: async () => (await import('./decals')).decalsSection(session),
          open: false,
        },
      ],
    },
    measure: {
      name: t('Measure'),
      icon: 'M3 13.500L13.500 3l3.500 3.500L6.500 17zM6 10.500l1.500 1.500M8.500 8l2 2M11 5.500l1.500 1.500',
      sections: [
        { id: 'measure', title: t('Measure'), element: measuring.element, open: true },
        { id: 'girth', title: t('Girth'), element: girth, open: true },
        {
          id: 'loops',
          title: t('Loops and curves'),
          element: async () => (await import('./paths')).pathsControls(session),
          open: false,
        },
      ],
    },
    ground: {
      name: t('Ground'),
      icon: 'M2 16l5-9 4 6 2-3 5 6zM13 6a1.500 1.500 0 1 0 3 0 1.500 1.500 0 1 0-3 0z',
      sections: [
        {
          id: 'ground',
          title: t('Ground'),
          element: async () => (await import('./ground')).groundSection(session, ground, tool),
          open: true,
        },
      ],
    },
    inside: {
      name: t('Inside'),
      icon: 'M10 3a7 7 0 1 0 7 7h-7z M13 2.500A6.500 6.500 0 0 1 17.500 7H13z',
      sections: [
        {
          id: 'inside',
          title: t('Inside'),
          element: async () => (await import('./inside')).insideSection(session, opener),
          open: true,
        },
      ],
    },
    solve: {
      name: t('Solver'),
      icon: 'M3 5h6M12 5h5M3 10h2M8 10h9M3 15h9M15 15h2M9 3v4M5 8v4M12 13v4',
      sections: [
        {
          id: 'solver',
          title: t('Solver'),
          element: async () => (await import('./solver')).solverSection(session),
          open: true,
        },
        { id: 'compare', title: t('Compare'), element: () => comparing.element(), open: false, onSight: true },
        { id: 'charts', title: t('Charts'), element: chartsSection(session, measuring.measured), open: false },
        {
          id: 'numbers',
          title: t('Numbers'),
          element: async () => (await import('./numbers')).numbersSection(session),
          open: true,
        },
      ],
    },
    share: {
      name: t('Share'),
      icon: 'M10 12V3M6.500 6L10 2.500 13.500 6M4 10v7h12v-7',
      sections: [
        {
          id: 'share',
          title: t('Share and export'),
          element: async () => (await import('./share')).shareSection(session, link, frames),
          open: true,
        },
        {
          id: 'export',
          title: t('Curves and data'),
          element: async () => (await import('./export')).exportSection(session),
          open: true,
        },
      ],
    },
  };
  const sources = { id: 'sources', title: t('Sources'), element: sourcesSection(session, tool, drawn), open: true };
  const panel = buildPanel(contents, [sources], open);
  const sectionOf = (id: string) => panel.element.querySelector<HTMLDetailsElement>(`#section-${id}`);
  session.scene.subscribe(({ compared }, previous) => {
    const section = sectionOf('compare');
    if (compared && !previous.compared && section) section.open = true;
  });
  session.shown.watch((shown) => {
    // There is nothing to choose in files that stand still.
    sectionOf('animation')?.toggleAttribute('hidden', !shown?.opened.clips.length);
  });
  void drawn.then(() => panel.load());
  // Where something is pinned, the model is framed beside it from the beginning.
  const seen = remembered(PINNED) ? Promise.resolve() : drawn;
  seen
    .then(() => import('./pin'))
    .then(({ pinning }) => pinning(panel, contents, open, pinned), session.fail.bind(session));
  return panel;
}
