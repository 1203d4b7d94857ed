/** Keeps this version of the page, and offers a newer one. */
import { keepForOffline } from '../offline/register';
import type { Notifier } from './notifier';
import { t } from '../texts';

export async function keepVersion(notifier: Notifier): Promise<void> {
  await keepForOffline(
    () => window.heatwalk.settled(),
    (load) =>
      notifier.notice(t('A new version of this page is ready. Until you reload, nothing changes.'), {
        name: t('Reload, with the scene as it is'),
        run: load,
      }),
  );
}
