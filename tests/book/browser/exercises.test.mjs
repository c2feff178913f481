// Nobody sees a hint or a solution who did not ask for it: folded away on the screen, and not on paper.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {address, launch, open_page} from './browser.mjs';
import {chapter_pages} from './pages.mjs';

let browser, page;
before(async () => {
  browser = await launch();
  page = await open_page(browser);
});
after(() => browser.close());

/// The folds whose contents can be seen, by the words on them.
const opened = () => page.locator('details.spoiler').evaluateAll(folds => folds
  .filter(fold => [...fold.children].slice(1).some(child => child.checkVisibility()))
  .map(fold => fold.querySelector('summary').textContent));

test('Every chapter has exercises, shut until a link leads to one, and each of their hints until a key opens it, alone.', async () => {
  for (const name of chapter_pages) {
    await page.goto(address(name));
    const hint = page.locator('details.spoiler summary', {hasText: 'Hint 2'}).last();
    assert.ok(await hint.count(), `${name} has no hint`);
    assert.equal(await hint.isVisible(), false, name);
    await page.goto(`${address(name)}#${await page.locator('h3[id^="exercise_"]').last().getAttribute('id')}`);
    assert.deepEqual(await opened(), [], name);
    await hint.press('Enter');
    assert.deepEqual(await opened(), [await hint.textContent()], name);
  }
});

test('On paper there is a note in the place of hints and solutions.', async () => {
  await page.goto(address(chapter_pages[0]));
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('details.spoiler:visible').count(), 0);
  assert.match(await page.locator('.on-paper', {hasText: 'Hints'}).first().innerText(), /\.\/course hint NAME gives one hint at a time/);
  await page.emulateMedia({media: null});
});
