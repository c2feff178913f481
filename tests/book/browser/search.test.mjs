// Full-text search, by mouse and by keyboard alone.
import assert from 'node:assert/strict';
import {after, afterEach, before, beforeEach, test} from 'node:test';
import {address, launch, narrow, open_page} from './browser.mjs';

let browser, page;
before(async () => { browser = await launch(); });
after(() => browser.close());
beforeEach(async () => {
  page = await open_page(browser);
  await page.goto(address('index.html'));
});
afterEach(() => page.context().close());

const first = () => page.locator('#found [role=option]').first();

/// The page stands where its address says: at an element of that name, with the top of it in view.
async function assert_at_section_of_chapter_3() {
  await page.waitForURL(/\/chapter_03_inertia\.html#/);
  const {text, top, height} = await page.evaluate(() => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    return {text: target?.textContent ?? '', top: target?.getBoundingClientRect().top, height: innerHeight};
  });
  assert.match(text, /parallel[ -]ax[ei]s/i);
  assert.ok(top >= 0 && top < height, `the section's heading lies at ${top} of ${height} pixels`);
}

test('"parallel axis" is found in chapter 3 first, and the answer leads to its section.', async () => {
  await page.locator('#query').fill('parallel axis');
  await first().waitFor();
  assert.match(await first().textContent(), /Inertia/);
  await first().click();
  await assert_at_section_of_chapter_3();
  assert.deepEqual(page.complaints, []);
});

test('The keyboard alone searches, chooses and follows.', async () => {
  await page.keyboard.press('/');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'query');
  await page.keyboard.type('parallel axis');
  await first().waitFor();
  await page.keyboard.press('ArrowDown');
  assert.equal(await first().getAttribute('aria-selected'), 'true');
  const active = await page.locator('#query').getAttribute('aria-activedescendant');
  assert.equal(active, await first().getAttribute('id'));
  await page.keyboard.press('Enter');
  await assert_at_section_of_chapter_3();
});

test('A narrow screen shows the answers whole.', async () => {
  await page.setViewportSize(narrow);
  await page.locator('#query').fill('parallel axis');
  await first().waitFor();
  const {x, width} = await page.locator('#answers').boundingBox();
  assert.ok(x >= 0 && x + width <= narrow.width, `the answers reach from ${x} to ${x + width}`);
});

test('Nothing of the page lies above the answers.', async () => {
  await page.setViewportSize({width: 1300, height: 900});
  await page.goto(address('chapter_03_inertia.html'));
  await page.evaluate(() => document.querySelector('figure.listing').scrollIntoView());
  await page.locator('#query').fill('axes');
  await first().waitFor();
  const covered = await page.locator('#answers').evaluate(answers => {
    const {left, top, width, height} = answers.getBoundingClientRect();
    const places = [0.1, 0.3, 0.5, 0.7, 0.9].flatMap(x => [0.1, 0.3, 0.5, 0.7, 0.9].map(y => [left + x * width, top + y * height]));
    return places.map(([x, y]) => document.elementFromPoint(x, y)).filter(element => !answers.contains(element)).length;
  });
  assert.equal(covered, 0);
});

test('A word of the prose that is in no heading is found too.', async () => {
  await page.locator('#query').fill('satellite');
  await first().waitFor();
  assert.match(await first().textContent(), /satellite/i);
});

test('What is nowhere in the book is said to be nowhere; Escape closes the answers.', async () => {
  await page.locator('#query').fill('xylophone');
  await page.locator('#answer', {hasText: /nothing found/i}).waitFor();
  assert.equal(await page.locator('#found [role=option]').count(), 0);
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('#answers').isVisible(), false);
});

test('A section that has moved to another page is found there by its name.', async () => {
  await page.goto(`${address('chapter_01_force.html')}#inertia_parallel`);
  await assert_at_section_of_chapter_3();
});
