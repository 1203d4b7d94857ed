import { expect, test } from '../page';

test('scripts of others do not run on the page, and no text becomes HTML', async ({ page }) => {
  await page.goto('./?gpu=webgl');
  await page.waitForFunction(() => 'heatwalk' in window);
  const refused = await page.evaluate(async () => {
    const told: string[] = [];
    addEventListener('securitypolicyviolation', ({ effectiveDirective }) => told.push(effectiveDirective));
    const attempts = {
      html: () => (document.createElement('p').innerHTML = '<img src=x onerror="window.ran = true">'),
      text: () => document.body.append(Object.assign(document.createElement('script'), { text: 'window.ran = true' })),
      evaluation: () => setTimeout('window.ran = true'),
      worker: () => new Worker('https://elsewhere.example/worker.js'),
      'data worker': () => new Worker('data:text/javascript,postMessage(1)'),
      object: () => Object.assign(document.createElement('object'), { data: 'https://elsewhere.example/' }),
    };
    const outcomes = await Promise.allSettled(Object.values(attempts).map(async (attempt) => attempt()));
    const thrown = Object.keys(attempts).filter((_, index) => outcomes[index]?.status === 'rejected');
    const frame = Object.assign(document.createElement('iframe'), { src: 'https://elsewhere.example/' });
    const base = Object.assign(document.createElement('base'), { href: 'https://elsewhere.example/' });
    document.body.append(frame);
    document.head.append(base);
    const form = Object.assign(document.createElement('form'), { action: 'https://elsewhere.example/' });
    document.body.append(form);
    form.submit();
    await new Promise((resolve) => setTimeout(resolve, 500));
    return { thrown, told, ran: 'ran' in window, base: document.baseURI };
  });
  expect(refused.thrown).toEqual(['html', 'text', 'evaluation', 'worker', 'data worker', 'object']);
  expect(refused.told).toEqual(expect.arrayContaining(['frame-src', 'base-uri', 'form-action']));
  expect(refused.ran).toBe(false);
  expect(refused.base).not.toContain('elsewhere');
});

test('documents and the list of licenses keep to a policy of their own', async ({ page }) => {
  const told: string[] = [];
  page.on('console', (message) => told.push(message.text()));
  await page.goto('./docs/licenses.html');
  await expect(page.getByRole('cell', { name: 'faer', exact: true })).toBeVisible();
  await expect(page.getByText('Permission is hereby granted, free of charge').first()).toBeVisible();
  await page.goto('./docs/accuracy.html');
  await page.getByRole('searchbox').fill('windows');
  await expect(page.getByRole('link', { name: /windows/i }).first()).toBeVisible();
  const number = page.locator('td.right').first();
  await expect(number).toHaveCSS('text-align', 'right');
  await expect(page.locator('body')).toHaveCSS('display', 'grid');
  expect(told).toEqual([]);
});
