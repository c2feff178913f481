// The dark toggle works, lasts, and reaches the figures.
import assert from 'node:assert/strict';
import {after, afterEach, before, beforeEach, test} from 'node:test';
import {address, follow, launch, open_page} from './browser.mjs';
import {contrasts_in_figures} from './contrast.mjs';
import {reading_pages} from './pages.mjs';

let browser, page;
before(async () => { browser = await launch(); });
after(() => browser.close());
beforeEach(async () => { page = await open_page(browser); });
afterEach(() => page.context().close());

const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
const toggle = () => page.locator('#dark').click();

/// 0 for black, 255 for white.
async function brightness() {
  const [red, green, blue] = (await background()).match(/\d+/g).map(Number);
  return (red + green + blue) / 3;
}

test('The toggle turns the page dark and light again, and says which it is.', async () => {
  await page.goto(address('index.html'));
  assert.ok(await brightness() > 200);
  assert.equal(await page.locator('#dark').getAttribute('aria-pressed'), 'false');
  await toggle();
  assert.ok(await brightness() < 60);
  assert.equal(await page.locator('#dark').getAttribute('aria-pressed'), 'true');
  await toggle();
  assert.ok(await brightness() > 200);
});

test('What the reader chose lasts over the next page and over a reload.', async () => {
  await page.goto(address('index.html'));
  await toggle();
  await follow(page, page.locator('a[rel=next]'));
  assert.ok(await brightness() < 60, 'the next page is light');
  await page.reload();
  assert.ok(await brightness() < 60, 'the page is light after a reload');
  await toggle();
  await page.reload();
  assert.ok(await brightness() > 200, 'the page is dark after a reload');
});

test('A page follows the system until the reader chooses.', async () => {
  await page.emulateMedia({colorScheme: 'dark'});
  await page.goto(address('index.html'));
  assert.ok(await brightness() < 60);
  await toggle();
  await page.reload();
  assert.ok(await brightness() > 200, "the system's choice prevails over the reader's");
});

// WCAG 2.1: 4.5 for text (1.4.3), 3 for what one must see to understand a drawing (1.4.11). Axes are read like text.
const least = {axis: 4.5, line: 3};

test('In every figure the text and the axes change with the page and stand out in both modes.', async () => {
  let measured = 0;
  for (const name of reading_pages) {
    await page.goto(address(name));
    const light = await page.evaluate(contrasts_in_figures);
    await toggle();
    const dark = await page.evaluate(contrasts_in_figures);
    await toggle();
    for (const [mode, parts] of Object.entries({light, dark})) {
      const faint = parts.filter(({part, contrast}) => contrast < (least[part] ?? 4.5));
      assert.deepEqual(faint.map(({figure, part, colour, contrast}) =>
        `${figure}: ${part} ${colour} ${contrast.toFixed(2)}`), [], `too faint on ${name}, ${mode}`);
    }
    const unchanged = light.filter(({colour}, index) => colour === dark[index].colour);
    assert.deepEqual(unchanged.map(({figure, part, colour}) => `${figure}: ${part} ${colour}`), [],
      `the same in light and dark on ${name}`);
    measured += light.length;
  }
  assert.ok(measured > 0, 'no figure was measured');
});
