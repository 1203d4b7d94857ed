/** Every setting of the panel changes the picture or what the page says, or says why it does not. */
import { expect, everyWorkspace, test } from '../page';

/** Settings that say what the next stroke or filling will be, or how the picture moves in time. */
const LATER = new Set([
  'section-decals › Image',
  'section-ground › Tool',
  'section-ground › Size',
  'section-ground › Soft edge',
  'section-inside › Tetrahedra',
  'section-style › Flow',
]);
/** Sections of files to come, of figures, and of what is beside the scene. */
const OTHERS = /^section-(export|share|video|compare|numbers|charts)$/;
const SETTINGS = 'input:is([type=checkbox], [type=radio], [type=range], [type=color]), select';

type Setting = HTMLInputElement | HTMLSelectElement;

/** The picture and all that is said, but by settings themselves, and by figures that come later or change by the second. */
async function seen(): Promise<string> {
  await window.heatwalk.settled();
  const picture = await window.heatwalk.picture(0.5, false);
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', await picture.arrayBuffer()));
  const texts = [...document.querySelectorAll('p, td, small, output, h1, h2, legend, text, [role=status], [role=img]')];
  const beside = '#section-numbers, #section-charts, #section-compare, .unseen';
  const told = texts.filter((element) => element.checkVisibility() && !element.closest(beside));
  return [digest.join(), ...told.map((element) => element.getAttribute('aria-label') ?? element.textContent)].join(
    '\n',
  );
}

/** Where a setting is and what it is called; null where it is not seen, cannot be changed, or says why it shows nothing. */
function nameOf(setting: Setting): [section: string, name: string] | null {
  const section = setting.closest('details[id]')?.id ?? '';
  const field = setting.closest('.field');
  if (section === '' || !field || !setting.checkVisibility() || setting.disabled) return null;
  if (field.querySelector('small:not([hidden])')) return null;
  return [section, setting.getAttribute('aria-label') ?? field.querySelector('span')?.textContent ?? ''];
}

/** Gives a setting another value; false where there is no other. */
function change(setting: Setting): boolean {
  if (setting instanceof HTMLSelectElement) {
    const others = [...setting.options].filter((option) => !option.disabled && option.value !== setting.value);
    // The first and the last one may be other words for what is automatic.
    const other = others[others.length >> 1];
    if (!other) return false;
    setting.value = other.value;
  } else if (setting.type === 'checkbox' || setting.type === 'radio') {
    if (setting.type === 'radio' && setting.checked) return false;
    setting.click();
    return true;
  } else if (setting.type === 'color') {
    setting.value = '#3366ff';
  } else {
    const [low, high] = [Number(setting.min), Number(setting.max)];
    const share = setting.valueAsNumber < (low + high) / 2 ? 0.75 : 0.25;
    setting.valueAsNumber = low + share * (high - low);
  }
  for (const event of ['input', 'change']) setting.dispatchEvent(new Event(event, { bubbles: true }));
  return true;
}

for (const link of ['m=bunny&method=heat&refine=0', 'm=bunny']) {
  test(`${link}: every setting shows something, or says why it does not`, async ({ heatwalk, page }) => {
    test.slow();
    await page.setViewportSize({ width: 1000, height: 640 });
    await heatwalk.open(`#v=1&${link}`);
    await heatwalk.closeSummary();
    // The search opens once the sections of all workspaces are there.
    await page.locator('.stage').press('Control+k');
    await expect(page.locator('dialog.search')).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(page.locator('dialog.search')).toHaveCount(0);
    const silent: string[] = [];
    const undo = page.getByRole('button', { name: 'Undo' });
    let changed = 0;
    await everyWorkspace(page, async () => {
      const before = await page.evaluate(seen);
      for (const setting of await page.locator(`[role=tabpanel]:visible >> ${SETTINGS}`).elementHandles()) {
        const [section, name] = (await setting.evaluate(nameOf)) ?? ['', ''];
        if (section === '' || OTHERS.test(section) || LATER.has(`${section} › ${name}`)) continue;
        if (!(await setting.evaluate(change))) continue;
        changed += 1;
        if ((await page.evaluate(seen)) === before) silent.push(`${section} › ${name}`);
        // What is not in the scene is switched back by hand.
        if (await undo.isEnabled()) await undo.click();
        else await setting.evaluate(change);
        await heatwalk.settled();
      }
      expect(await page.evaluate(seen)).toBe(before);
    });
    expect(changed).toBeGreaterThan(30);
    expect(silent).toEqual([]);
  });
}
