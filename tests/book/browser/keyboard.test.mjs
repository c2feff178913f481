// A reader without a mouse reaches every control, and sees where they are.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {address, launch, narrow, open_page} from './browser.mjs';
import {chapter_pages, reading_pages} from './pages.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/// Numbers every control that is on the screen; returns what a reader would call each.
function number_the_controls() {
  const native = 'a[href], button, input, select, textarea, summary';
  const controls = [...document.querySelectorAll(`${native}, [tabindex]`)].filter(control =>
    (control.matches(native) || control.tabIndex >= 0) && !control.disabled && control.getClientRects().length > 0
    && control.checkVisibility({checkVisibilityCSS: true}));
  controls.forEach((control, index) => { control.dataset.control = index; });
  return controls.map(control =>
    `<${control.localName}> ${(control.getAttribute('aria-label') ?? control.textContent).trim() || control.outerHTML}`);
}

/// The focused control's number, and whether it differs to the eye from its state without focus.
function focused_control() {
  const control = document.activeElement;
  if (!control || control === document.body) return undefined;
  const {outlineStyle, outlineWidth, boxShadow} = getComputedStyle(control);
  const has_outline = outlineStyle !== 'none' && parseFloat(outlineWidth) > 0;
  return {number: control.dataset.control, is_marked: has_outline || boxShadow !== 'none'};
}

for (const name of reading_pages) {
  test(`The keyboard reaches every control of ${name}, and shows where it is.`, async () => {
    const page = await open_page(browser);
    await page.goto(address(name));
    const controls = await page.evaluate(number_the_controls);
    const reached = new Set();
    const unmarked = new Set();
    // Round once, with some steps to spare for what only a script made reachable, such as the form of a scene.
    for (let step = 0; step < controls.length + 60; ++step) {
      await page.keyboard.press('Tab');
      const focused = await page.evaluate(focused_control);
      if (!focused) break;
      if (focused.number === undefined) continue;
      reached.add(Number(focused.number));
      if (!focused.is_marked) unmarked.add(controls[focused.number]);
    }
    assert.ok(controls.length > 0, 'there is no control at all');
    assert.deepEqual(controls.filter((_, index) => !reached.has(index)), [], 'the Tab key never reaches these');
    assert.deepEqual([...unmarked], [], 'these do not show that they have the focus');
    await page.context().close();
  });
}

test('Keys work the dark button, the folds, the copy buttons and the list of pages.', async () => {
  const page = await open_page(browser, {permissions: ['clipboard-read', 'clipboard-write']});
  await page.goto(address(chapter_pages[0]));

  await page.locator('#dark').press('Space');
  assert.equal(await page.locator('#dark').getAttribute('aria-pressed'), 'true');

  await page.locator('details.task > summary').first().press('Enter');
  const fold = page.locator('details.spoiler').first();
  await fold.locator('summary').press('Enter');
  assert.equal(await fold.evaluate(details => details.open), true);

  const listing = page.locator('figure.listing:not(.output)', {has: page.locator('.copy')}).first();
  await listing.locator('.copy').press('Enter');
  await listing.locator('.copy', {hasText: 'Copied'}).waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  const lines = await listing.locator('.fragment .line').allTextContents();
  assert.equal(copied.trimEnd(), lines.join('\n').trimEnd());

  await page.setViewportSize(narrow);
  const pages = page.locator('#navigation');
  assert.equal(await pages.isVisible(), false);
  await page.locator('#menu').press('Enter');
  assert.equal(await pages.isVisible(), true);
  await page.keyboard.press('Escape');
  assert.equal(await pages.isVisible(), false);
  await page.context().close();
});
