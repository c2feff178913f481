// The page shows where one is, and remembers what was read and solved.
import assert from 'node:assert/strict';
import {after, afterEach, before, beforeEach, test} from 'node:test';
import {address, launch, narrow, open_page} from './browser.mjs';

const chapter = 'chapter_02_torque.html', another = 'chapter_01_force.html';
let browser, page;
before(async () => { browser = await launch(); });
after(() => browser.close());
beforeEach(async () => { page = await open_page(browser); });
afterEach(async () => {
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

const marked = () => page.locator('.contents-table [aria-current=location]').evaluateAll(links => links.map(link => link.hash));
const scroll_to = id => page.evaluate(name => document.getElementById(name).scrollIntoView(), id);
const progress_of = file => page.locator(`#navigation a[href="${file}"] .progress`);

test("From 1200 pixels on the page's contents stand beside the text, and below it above.", async () => {
  for (const [width, is_beside] of [[1200, true], [1280, true], [1920, true], [1000, false], [narrow.width, false]]) {
    await page.setViewportSize({width, height: 800});
    await page.goto(address(chapter));
    const contents = await page.locator('.contents-table').boundingBox(), text = await page.locator('.contents').boundingBox();
    assert.equal(contents.x >= text.x + text.width, is_beside, `at ${width} pixels`);
    const widest = await page.evaluate(() => Math.max(...[...document.querySelectorAll('.contents figure')]
      .map(figure => figure.getBoundingClientRect().right)));
    if (is_beside) assert.ok(widest <= contents.x, `at ${width} pixels a figure reaches to ${widest}, the contents begin at ${contents.x}`);
  }
});

test('The heading that is being read is marked, and no other.', async () => {
  await page.goto(address(chapter));
  for (const id of ['torque_run', 'torque_trust', 'couples']) {
    await scroll_to(id);
    await page.waitForFunction(name => document.querySelector('.contents-table [aria-current]')?.hash === `#${name}`, id);
    assert.deepEqual(await marked(), [`#${id}`]);
  }
});

test('A section counts as read when its end has stood still in the window, not when it was scrolled past.', async () => {
  await page.goto(address(chapter));
  await scroll_to('torque_further');
  await page.evaluate(() => document.getElementById('torque_run').scrollIntoView({block: 'center'}));
  await progress_of(chapter).waitFor({state: 'attached'});
  assert.match(await progress_of(chapter).textContent(), /^\d of \d+ read$/);
  const done = await page.locator('.contents-table a.done').evaluateAll(links => links.map(link => link.hash));
  assert.ok(done.includes('#torque_code') && !done.includes('#torque_trust'), done.join());
});

test('The next page offers the way back to where one was, and so does the landing page after a reload.', async () => {
  await page.goto(address(chapter));
  await scroll_to('torque_cost');
  await page.waitForFunction(() => JSON.parse(localStorage.getItem('tumble-reading'))?.last?.id === 'torque_cost');
  for (const other of ['index.html', another]) {
    await page.goto(address(other));
    const link = page.locator('.way-back a');
    assert.match(await link.textContent(), /Torque.*What it costs/);
    assert.match(await link.getAttribute('href'), /^chapter_02_torque\.html#torque_cost$/);
  }
});

test('An exercise that is ticked as solved stays so, and is counted beside its chapter.', async () => {
  await page.goto(address(another));
  const box = page.locator('label.solved input').first();
  await box.check();
  await page.reload();
  assert.ok(await box.isChecked());
  assert.match(await progress_of(another).textContent(), /1 of \d solved/);
  await page.goto(address('exercises.html'));
  assert.equal(await page.locator('a.done').count(), 1);
  await page.goto(address(another));
  await box.uncheck();
  await page.goto(address('exercises.html'));
  assert.equal(await page.locator('a.done').count(), 0);
});

test('A browser that keeps nothing shows the page all the same.', async () => {
  await page.addInitScript(() => {
    Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('refused', 'SecurityError'); }});
  });
  await page.goto(address(chapter));
  await scroll_to('torque_run');
  await page.waitForFunction(() => document.querySelector('.contents-table [aria-current]')?.hash === '#torque_run');
});
