/** The page in French, as the browser wants it, as the address has it, and as it is chosen. */
import { violations } from '../axe';
import { everyWorkspace, expect, type HeatwalkPage, openSection, test } from '../page';

const titles = '.panel-body summary';

async function openTorus(heatwalk: HeatwalkPage): Promise<void> {
  await heatwalk.open('#m=torus&method=auto');
  await heatwalk.settled();
}

/** Files that readers and the budget of memory refuse, and what is told of each; spaces stand for narrow ones too. */
const REFUSED: readonly [name: string, content: string, told: RegExp][] = [
  ['a.obj', 'v 0 0 0\nv 1\n', /OBJ, ligne 2\s: un sommet demande trois nombres, mais il y en a 1\s; le fichier/],
  ['a.off', 'OFF 3 1 0\n0 0 0\n', /OFF, fin du fichier\s: il manque 2 des 3 sommets\s; le fichier est tronqué/],
  ['a.stl', 'solid a\nfacet normal 0 0 1\nouter loop\n', /STL, ligne 2\s: la facette est coupée par la fin du fichier/],
  [
    'a.ply',
    'ply\nformat ascii 1.0\nelement vertex 1\nproperty odd x\nend_header\n',
    /PLY, ligne 4\s: type de propriété inconnu\s: «\sproperty odd x\s»/,
  ],
  [
    'a.gltf',
    '{"asset": {"version": "2.0"}, "nodes": [}',
    /glTF, JSON, ligne 1, colonne \d+\s: une valeur est attendue/,
  ],
];

test.describe('in a browser that wants French', () => {
  test.use({ locale: 'fr-FR' });

  test('all of the page is in French, numbers too, and the address may have another language', async ({
    heatwalk,
    page,
  }) => {
    await openTorus(heatwalk);
    await expect(page.locator('html')).toHaveAttribute('lang', 'fr');
    await expect(page.locator(titles).first()).toHaveText('Scène');
    await expect(page.getByRole('button', { name: 'Mesurer' }).first()).toBeVisible();
    await openSection(page, 'numbers');
    const numbers = page.locator('#section-numbers');
    await expect(numbers).toContainText('Distance maximale');
    await expect(numbers).toContainText(/\d,\d+ unités/);
    await expect(numbers).toContainText(/17\s280/);

    await page.getByRole('button', { name: 'Aide', exact: true }).click();
    await expect(page.getByRole('dialog')).toContainText('Tourner autour');
    await page.getByLabel('Expliquer chaque réglage').check();
    await page.keyboard.press('Escape');
    // Every setting that there is has its line in French, too.
    await openSection(page, 'compare');
    await page.locator('#section-compare').scrollIntoViewIfNeeded();
    await openSection(page, 'export');
    // A comma in a number is the decimal one, as the page writes it.
    await page.getByRole('textbox', { name: 'Isolignes à' }).fill('0,5');
    expect((await heatwalk.scene()).isolines).toEqual({ values: [], spacing: 0.5 });
    await page.getByRole('textbox', { name: 'Isolignes à' }).fill('0,5; 1');
    expect((await heatwalk.scene()).isolines).toEqual({ values: [0.5, 1], spacing: 0 });
    const bare = () =>
      page
        .locator('.panel .field')
        .evaluateAll((fields) =>
          fields
            .filter((field) => !field.nextElementSibling?.classList.contains('explanation'))
            .map((field) => field.textContent),
        );
    await expect.poll(bare).toEqual([]);
    await everyWorkspace(page, async (workspace) =>
      expect([workspace, await violations(page)]).toEqual([workspace, []]),
    );

    // What is refused is told in French; the scene stays.
    await heatwalk.drop([['leer.doc', 'nothing']]);
    await expect(page.getByText('Aucun maillage trouvé dans leer.doc')).toBeVisible();

    for (const [name, content, told] of REFUSED) {
      await heatwalk.drop([[name, content]]);
      await expect(page.locator('.message').filter({ hasText: told })).toBeVisible();
    }

    await page.goto('./?lang=en#m=torus');
    await expect(page.locator(titles).first()).toHaveText('Scene');
  });
});

test('French is chosen in the help at once: the scene, undo, what is open and the help itself stay', async ({
  heatwalk,
  page,
}) => {
  await openTorus(heatwalk);
  await openSection(page, 'numbers');
  await page.getByRole('button', { name: 'Add', exact: true }).first().click();
  await page.evaluate(() => Object.assign(window, { isSamePage: true }));
  const scene = () => page.evaluate(() => JSON.stringify([window.heatwalk.scene, window.heatwalk.camera]));
  await page.mouse.click(...(await heatwalk.pixelOnModel(0, 0.25)));
  await expect(page.getByRole('button', { name: 'Undo', exact: true })).toBeEnabled();
  await heatwalk.settled();
  const before = await scene();
  const solves = await page.evaluate(() => window.heatwalk.solves);
  // What was said before, too.
  await heatwalk.drop([['leer.doc', 'nothing']]);
  await expect(page.getByText('No mesh found in leer.doc')).toBeVisible();

  await page.getByRole('button', { name: 'Help', exact: true }).click();
  await page.getByRole('combobox', { name: 'Language' }).selectOption('fr');
  await expect(page.locator(titles).first()).toHaveText('Scène');
  await expect(page.locator('html')).toHaveAttribute('lang', 'fr');
  await expect(page.getByRole('dialog', { name: 'Aide' })).toContainText('Tourner autour');
  await expect(page.getByRole('dialog').locator('kbd', { hasText: 'Échap' }).first()).toBeVisible();
  // The help fits the narrowest window.
  const size = page.viewportSize() ?? { width: 0, height: 0 };
  await page.setViewportSize({ width: 320, height: 640 });
  const help = page.getByRole('dialog', { name: 'Aide' });
  expect(await help.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)).toBe(0);
  await page.setViewportSize(size);
  await page.keyboard.press('Escape');
  await expect(page.getByText('Aucun maillage trouvé dans leer.doc')).toBeVisible();
  await expect(page.locator('#section-numbers')).toContainText(/Distance maximale\d,\d+ unités/);
  await expect(page.locator('#section-numbers')).toHaveAttribute('open');
  await expect(page.getByRole('button', { name: 'Ajouter', exact: true }).first()).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  // Nothing of the page is English but names: every text that is shown in both languages was written again.
  const english = await page.evaluate(() =>
    document.body.textContent?.match(/Keyboard|Maximum distance|Save image|Stripe width/g),
  );
  expect(english).toBeNull();
  expect(await scene()).toBe(before);
  expect(await page.evaluate(() => [window.heatwalk.solves, 'isSamePage' in window])).toEqual([solves, true]);
  await page.getByRole('button', { name: 'Annuler', exact: true }).click();
  await heatwalk.settled();
  expect(await scene()).not.toBe(before);

  expect(page.url()).toContain('m=torus');
  await page.reload();
  await expect(page.locator('html')).toHaveAttribute('lang', 'fr');
});
