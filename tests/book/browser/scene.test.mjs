// The figure in which a scene is edited, on the page that simulate --live writes: by form, by text, by key, by link.
//   TUMBLE_SIMULATE  the program simulate
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {createRequire} from 'node:module';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {after, afterEach, before, test} from 'node:test';
import {launch, narrow, open_page} from './browser.mjs';

const axe = createRequire(import.meta.url)('axe-core');
const folder = mkdtempSync(join(tmpdir(), 'tumble-live-'));
const file = join(folder, 'box.html');
const address = pathToFileURL(file).href;

let browser, page, figure;
before(async () => {
  const {status, stderr} = spawnSync(process.env.TUMBLE_SIMULATE, ['tethered_box', '--live', file], {encoding: 'utf8'});
  assert.equal(status, 0, stderr);
  browser = await launch();
});
after(async () => {
  await browser?.close();
  rmSync(folder, {recursive: true});
});
afterEach(() => page.context().close());

async function open(where = address, options = {}) {
  page = await open_page(browser, {reducedMotion: 'reduce', ...options});
  await page.goto(where);
  await page.waitForFunction(() => document.querySelector('figure.live').live);
  figure = page.locator('figure.live');
  await figure.locator('.live-finding').filter({hasText: /\S/}).waitFor();
}
const ask = words => figure.evaluate((element, text) => new Function('live', `return ${text};`)(element.live), words);
const books = async () => JSON.parse(await ask('live.run.said.books'));
const area = () => page.getByRole('textbox', {name: 'The scene as a file'});
const fold = name => page.locator('.scene-fold > summary', {hasText: new RegExp(`^${name}$`)});
const line = name => page.locator('.scene-table').first().locator('tr', {has: page.locator('th', {hasText: new RegExp(`^${name}$`)})});

/** Does something, and waits until its run has been told. */
async function and_run(action) {
  await figure.evaluate(element => { element.has_told = new Promise(done => { element.addEventListener('told', done, {once: true}); }); });
  await action();
  await figure.evaluate(element => element.has_told);
}

test('It opens from its file with the scene in it, which has run to its end, and nothing complains.', async () => {
  await open();
  assert.equal(await page.title(), 'A box on a tether');
  assert.equal((await books()).steps, 3600);
  assert.equal(await ask('live.is_playing'), false);
  const finding = await figure.locator('.live-finding').textContent();
  assert.match(finding, /^A step makes \d+ passes over 2 bodies/);
  assert.doesNotMatch(finding, /Changed/);
  assert.deepEqual(page.complaints, []);
});

test('An effect that is switched off leaves the text and the plan, which say so, and comes back.', async () => {
  await open();
  const box = page.getByRole('checkbox', {name: 'linear damping', exact: true});
  await and_run(() => box.uncheck());
  assert.doesNotMatch(await area().inputValue(), /linear_damping/);
  assert.ok(await page.locator('.scene-table s', {hasText: 'linear damping'}).isVisible(), 'the line that is gone');
  assert.match(await figure.locator('.live-finding').textContent(), /linear damping is gone/);
  await and_run(() => box.check());
  assert.match(await area().inputValue(), /linear_damping/);
  assert.match(await line('linear damping').textContent(), /\(new\)/);
});

test('A number of the form is an input with a name and a unit; a key changes it, the text and the motion.', async () => {
  await open();
  await fold('crate').press('Enter');
  const input = page.getByRole('spinbutton', {name: 'crate: angular velocity z, rad/s'});
  assert.equal(await input.inputValue(), '2');
  const before = (await books()).now.energy;
  await and_run(() => input.press('ArrowUp'));
  assert.equal(await input.inputValue(), '3');
  assert.match(await area().inputValue(), /"angular_velocity": \[0, 1, 3\]/);
  assert.notEqual((await books()).now.energy, before);
  assert.ok(await input.evaluate(element => element === document.activeElement), 'the focus stays');
});

test('Bodies and effects are added and removed, and the plan changes by their lines.', async () => {
  await open();
  await page.getByRole('combobox', {name: 'Which effect'}).selectOption('thruster');
  await and_run(() => page.getByRole('button', {name: 'Add an effect'}).click());
  assert.match(await line('thruster').textContent(), /1 of 1/);
  await page.getByRole('combobox', {name: 'Which body'}).selectOption('ball');
  await and_run(() => page.getByRole('button', {name: 'Add a body'}).click());
  assert.equal((await books()).bodies, 3);
  await fold('ball').click();
  await and_run(() => page.getByRole('button', {name: 'Remove ball'}).click());
  assert.equal((await books()).bodies, 2);
});

test('A mistake in the text gets the sentence of the terminal; what was sound stays, and is mended.', async () => {
  await open();
  const good = await area().inputValue();
  await and_run(() => area().fill(good.replace('"stiffness": 2000', '"stiffness": -2000')));
  const sentence = 'tethered_box.json: /effects/1/stiffness is -2000 N/m; it must be 0 or more';
  assert.equal(await figure.locator('.live-finding').textContent(), sentence);
  assert.equal(await area().getAttribute('aria-invalid'), 'true');
  assert.equal((await books()).steps, 3600);
  const measure = page.getByRole('button', {name: 'Measure what each line costs'});
  assert.ok(await measure.isDisabled(), 'nothing is there to measure');
  await and_run(() => area().fill(good.slice(0, 40)));
  assert.match(await figure.locator('.live-finding').textContent(), /^tethered_box\.json: line \d+, column \d+: not valid JSON/);
  assert.ok(await page.getByRole('spinbutton').first().isDisabled(), 'no form of what is no JSON');
  await and_run(() => area().fill(good.replace('"duration": 15', '"duration": 1')));
  assert.equal((await books()).steps, 240);
  assert.equal(await area().getAttribute('aria-invalid'), null);
  assert.ok(await measure.isEnabled());
  await and_run(() => page.getByRole('button', {name: 'Reset'}).click());
  assert.equal(await area().inputValue(), good);
});

test('The whole scene goes into an address, from which another page takes it.', async () => {
  await open();
  await and_run(() => area().fill('{"duration": 1, "bodies": [{"name": "a & b = ü", "mass": 1}]}'));
  const [link, text] = [await ask('live.link'), await area().inputValue()];
  await page.context().close();
  await open(link);
  await page.waitForFunction(wanted => document.querySelector('textarea').value === wanted, text);
  assert.equal((await books()).bodies, 1);
});

test('It can be replayed, the time is an input, and the view turns by keys.', async () => {
  await open();
  const time = page.getByRole('slider', {name: 'Time'});
  await time.press('End');
  assert.equal(await ask('live.time'), 15);
  await page.getByRole('button', {name: 'Play'}).click();
  await page.waitForFunction(() => { const {live} = document.querySelector('figure.live'); return live.time > 0 && live.time < 5; });
  await page.getByRole('button', {name: 'Pause'}).click();
  const canvas = page.locator('canvas.turns');
  await canvas.press('ArrowLeft');
  assert.equal(await ask('live.panels[0].view.azimuth'), -0.1);
});

test('What each line costs is measured where the page is, a number for every line that visits somebody.', async () => {
  await open();
  await page.getByRole('button', {name: 'Measure what each line costs'}).click();
  await page.locator('.scene-table th', {hasText: 'ns in a step'}).waitFor();
  for (const name of ['gravity', 'rope', 'drift', 'the whole step, with its memory and its guard'])
    assert.match(await line(name).locator('td').last().textContent(), /^\d/, name);
});

test('In the dark on a phone nothing is wider than the page, and axe-core finds nothing, nor on a wide light one.', async () => {
  for (const options of [{viewport: narrow, colourScheme: 'dark'}, {}]) {
    if (page) await page.context().close();
    await open(address, options);
    for (const summary of await page.locator('.scene-fold > summary').all()) await summary.click();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.evaluate(axe.source);
    const {violations} = await page.evaluate(() => axe.run(document, {resultTypes: ['violations'], preload: false}));
    assert.deepEqual(violations.map(({id, nodes}) => `${id}: ${nodes[0].html}`), []);
  }
});

test('Without scripts it says that it needs them, and without WebAssembly so too.', async () => {
  page = await open_page(browser, {javaScriptEnabled: false});
  await page.goto(address);
  assert.match(await page.locator('main').textContent(), /this browser runs none/);
  await page.context().close();
  page = await open_page(browser, {});
  await page.addInitScript(() => { delete globalThis.WebAssembly; });
  await page.goto(address);
  await page.locator('.live-absent').waitFor();
  assert.match(await page.locator('.live-absent').textContent(), /WebAssembly/);
});
