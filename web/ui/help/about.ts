/** What becomes of one's files, where the source is, how a fault is reported, and licenses: nothing is sent by the page itself. */
import { sentenceOf } from '../../error';
import type { Session } from '../../session/session';
import { save } from '../../view/picture';
import { copy } from '../clipboard';
import { h, say } from '../dom';
import { addressOf } from './documents';
import { fileNameOf } from '../words';
import { t } from '../../texts';

export function about(session: Session): HTMLElement[] {
  const source = sourceAddress();
  const said = h('span', { class: 'quiet', role: 'status' });
  const text = h('textarea', { readonly: true, rows: 6, hidden: true, 'aria-label': t('Report') });
  const copyReport = async () => {
    text.value = reportOf();
    const isCopied = await copy(text.value);
    text.hidden = isCopied;
    say(said, isCopied ? t('Copied.') : t('The clipboard is not available. Copy it from the field.'));
  };
  const saveScene = async () => {
    try {
      const { sceneFile } = await import('../../session/scene');
      save(await sceneFile(session), `${fileNameOf(session.shown.value)}.heatwalk.zip`);
    } catch (error) {
      say(said, sentenceOf(error));
    }
  };
  return [
    h('h3', {}, t('Privacy')),
    h(
      'p',
      {},
      t(
        'Meshes are read and solved in this browser. Nothing is uploaded, counted or tracked; the page asks its own host alone, and that of an address that you open.',
      ),
    ),
    h(
      'p',
      {},
      t(
        'Files that you open are kept in this browser only, to be opened again; so are your choices. The menu “Open” erases the files, and the browser all of it, with the data of this site.',
      ),
    ),
    h('h3', {}, t('Report a fault')),
    h(
      'p',
      {},
      t(
        'Nothing is sent by itself. Save the scene, which holds your mesh, copy the report, which names it, look at both, and hand them over.',
      ),
    ),
    h(
      'div',
      { class: 'actions' },
      h('button', { onclick: () => void saveScene() }, t('Save scene')),
      h('button', { onclick: () => void copyReport() }, t('Copy report')),
      said,
    ),
    text,
    ...(source
      ? [
          h(
            'p',
            {},
            h('a', { href: `${source}/issues/new`, target: '_blank', rel: 'noopener' }, t('A new report')),
            ' · ',
            h('a', { href: source, target: '_blank', rel: 'noopener' }, t('The source, and its license')),
          ),
        ]
      : [
          h(
            'p',
            { class: 'quiet' },
            t('Whoever runs this page has not said where its source is, and who takes reports.'),
          ),
        ]),
    h('h3', {}, t('Licenses')),
    h(
      'p',
      {},
      h(
        'a',
        { href: addressOf('licenses'), target: '_blank', rel: 'noopener' },
        t('What the page is made of, and under which licenses'),
      ),
    ),
  ];
}

/** Where the source of this page is, as its host says. */
function sourceAddress(): string | null {
  const content = document.querySelector<HTMLMetaElement>('meta[name="heatwalk-source"]')?.content ?? '';
  return /^https?:\/\//.test(content) ? content.replace(/\/$/, '') : null;
}

/** What a fault may depend on. */
function reportOf(): string {
  const { backend, mesh, field, refining, scene } = window.heatwalk;
  const build = document.querySelector<HTMLScriptElement>('script[src]')?.src ?? '';
  const size = [innerWidth, innerHeight, devicePixelRatio];
  const { href: link } = location;
  const { userAgent } = navigator;
  const { method, parameters } = scene;
  return JSON.stringify({ link, build, userAgent, backend, size, mesh, field, refining, method, parameters }, null, 2);
}
