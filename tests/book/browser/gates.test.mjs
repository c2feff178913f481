// What answers a prediction is shut until the reader has answered, and nobody is shut out.
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import {after, afterEach, before, beforeEach, test} from 'node:test';
import {address, launch, narrow, open_page} from './browser.mjs';
import {reading_pages} from './pages.mjs';

const axe = createRequire(import.meta.url)('axe-core');
const chapter = 'chapter_08_tumbling.html', name = 't_handle', another = 'energy_sphere';
let browser, page;
before(async () => { browser = await launch(); });
after(() => browser.close());
beforeEach(async () => { page = await open_page(browser, {gates: 'shut', reducedMotion: 'reduce'}); });
afterEach(async () => {
  assert.deepEqual(page.complaints, []);
  await page.context().close();
});

const form = of => page.locator(`form[data-prediction="${of}"]`);
/// Of each gate before what answers a prediction: whether its contents are seen, and its line.
const state_of = of => page.locator(`[data-gate="${of}"]`).evaluateAll(gates => gates.map(gate =>
  ['.gated', '.shut'].map(part => gate.querySelector(`:scope > ${part}`).checkVisibility())));
const shut = [false, true], open = [true, false];

test('A gate is shut at first; an answer opens all gates of its name at once, and they stay so.', async () => {
  await page.goto(address(chapter));
  assert.deepEqual(await state_of(name), [shut, shut, shut]);
  assert.equal(await page.getByText('The conserved quantity is the momentum').isVisible(), false);
  await form(name).getByLabel('sideways').check();
  const opened = async () => {
    assert.deepEqual([await state_of(name), await state_of(another)], [[open, open, open], [shut]]);
    assert.equal(await form(name).getByRole('status').textContent(), 'You predicted: sideways. Now look.');
    assert.ok(await form(name).locator('details p').isVisible());
  };
  await opened();
  await page.reload();
  await opened();
});

test('"Just show me" opens them by the keyboard, which goes on from there, and they stay so.', async () => {
  await page.goto(address(chapter));
  await page.locator(`[data-gate="${name}"]`).nth(1).locator('.shut button').press('Enter');
  assert.deepEqual(await state_of(name), [open, open, open]);
  assert.ok(await page.locator(`[data-gate="${name}"] .gated`).nth(1).evaluate(box => box === document.activeElement));
  await page.reload();
  assert.deepEqual(await state_of(name), [open, open, open]);
  assert.equal(await form(name).getByRole('status').textContent(), '');
});

test('"Never ask" opens all gates of all pages, and "Ask me again" shuts them.', async () => {
  await page.goto(address(chapter));
  await page.getByRole('button', {name: 'Never ask'}).first().click();
  assert.deepEqual(await state_of(name), [open, open, open]);
  await page.goto(address('step_limits.html'));
  assert.deepEqual(await state_of('nutation'), [open, open]);
  await page.getByRole('button', {name: 'Ask me again'}).click();
  await page.waitForFunction(() => !document.querySelector('[data-gate].open'));
  assert.deepEqual(await state_of('nutation'), [shut, shut]);
  assert.equal(await page.evaluate(() => localStorage.length), 0);
});

test('"Answer first" leads to the question, a number of which is answered by Enter.', async () => {
  await page.goto(address('chapter_06_semi_implicit_euler.html'));
  await page.locator('[data-gate="swings_64"] .shut a').first().click();
  await page.keyboard.press('Tab');
  await page.keyboard.type('2.5');
  assert.deepEqual(await state_of('swings_64'), [shut]);
  await page.keyboard.press('Enter');
  assert.deepEqual(await state_of('swings_64'), [open]);
  assert.equal(await form('swings_64').getByRole('status').textContent(), 'You predicted: 2.5 J. Now look.');
});

test('An address behind a gate opens it and shows the place, without an answer.', async () => {
  for (const come of [hash => page.goto(address('step_limits.html') + hash), hash => page.evaluate(to => { location.hash = to; }, hash)]) {
    await page.goto(address('step_limits.html'));
    assert.deepEqual(await state_of('nutation'), [shut, shut]);
    await come('#live_nutation');
    await page.waitForFunction(() => document.querySelector('[data-gate="nutation"].open'));
    const {top, height} = await page.locator('#live_nutation').evaluate(box => ({top: box.getBoundingClientRect().top, height: innerHeight}));
    assert.ok(top >= 0 && top < height, `the figure lies at ${top} of ${height} pixels`);
    assert.equal(await page.evaluate(() => localStorage.getItem('tumble.prediction.nutation')), null);
    await page.goto('about:blank');
  }
});

test('Without scripts every gate of the book is open.', async () => {
  const plain = await open_page(browser, {javaScriptEnabled: false});
  let gates = 0;
  for (const each of reading_pages) {
    await plain.goto(address(each));
    gates += await plain.locator('.gated').count();
    assert.equal(await plain.locator('.gated:visible').count(), await plain.locator('.gated').count(), each);
    assert.equal(await plain.locator('.shut:visible').count(), 0, each);
  }
  assert.ok(gates > 50, `${gates} gates`);
  await plain.context().close();
});

test('On paper every gate is open, and the answers stand at the end alone.', async () => {
  await page.goto(address(chapter));
  const answers = page.locator('.answers');
  assert.equal(await answers.isVisible(), false, 'on the screen');
  await page.emulateMedia({media: 'print'});
  assert.deepEqual(await state_of(name), [open, open, open].map(() => [true, false]));
  assert.equal(await form(name).locator('details').isVisible(), false);
  assert.equal(await answers.locator('li:visible').count(), await page.locator('form.prediction').count());
  assert.ok(await answers.evaluate(box => box.compareDocumentPosition(document.querySelector('#tumbling_further')) & Node.DOCUMENT_POSITION_PRECEDING));
});

test('axe-core finds nothing serious in shut gates on a phone, light or dark, and the page is no wider than it.', async () => {
  for (const colourScheme of ['light', 'dark']) {
    const phone = await open_page(browser, {gates: 'shut', viewport: narrow, colourScheme});
    await phone.goto(address('chapter_06_semi_implicit_euler.html'));
    await phone.evaluate(axe.source);
    const {violations} = await phone.evaluate(() => axe.run('.contents', {resultTypes: ['violations'], preload: false}));
    assert.deepEqual(violations.filter(({impact}) => ['serious', 'critical'].includes(impact)).map(({id}) => id), [], colourScheme);
    assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await phone.context().close();
  }
});
