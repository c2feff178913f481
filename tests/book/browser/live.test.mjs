// Figures that one can touch: what a reader does changes what it should, by mouse, by key and by link.
//   TUMBLE_LIVE  the figures, CHAPTER/NAME, with commas
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {address, book, launch, narrow, open_page} from './browser.mjs';

const axe = createRequire(import.meta.url)('axe-core');
const figures = process.env.TUMBLE_LIVE.split(',').map(figure => figure.split('/')[1]);
/** The page that shows the figure: a chapter may have several. */
const page_of = name => readdirSync(book).find(file => file.endsWith('.html') && readFileSync(join(book, file), 'utf8').includes(`id="live_${name}"`));

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** The page with its figure awake. */
async function open_figure(name, {query = '', ...options} = {}) {
  const page = await open_page(browser, {reducedMotion: 'reduce', ...options});
  await page.goto(address(page_of(name)) + query);
  const figure = page.locator(`#live_${name}`);
  await figure.scrollIntoViewIfNeeded();
  await page.waitForFunction(id => document.getElementById(id).live, `live_${name}`);
  return {page, figure};
}
const ask = (figure, words, given) => figure.evaluate((element, [text, argument]) =>
  new Function('live', 'given', `return ${text};`)(element.live, argument), [words, given]);
const told = figure => figure.locator('.live-finding').filter({hasText: /\S/}).textContent();

async function serious_violations(page, name) {
  const {violations} = await page.evaluate(figure => axe.run({include: [`#live_${figure}`, `form[data-prediction="${figure}"]`]},
    {resultTypes: ['violations'], preload: false}), name); // preloading fails on a page opened from a file
  return violations.filter(({impact}) => ['serious', 'critical'].includes(impact)).map(({id, nodes}) => [id, ...nodes[0].target, nodes[0].failureSummary]);
}

/** Every knob is an input with a name, which keys move. */
async function turn_knobs(figure) {
  const inputs = figure.locator('.live-knob :is(input, select)');
  for (let n = 0; n < await inputs.count(); ++n) {
    const input = inputs.nth(n);
    const last = await ask(figure, 'JSON.stringify(live.values)');
    if (await input.evaluate(element => element.tagName === 'SELECT'))
      await input.selectOption({value: await input.evaluate(element => String((Number(element.value) + 1) % element.length))});
    else {
      const key = await input.evaluate(element => (element.value === element.max ? 'ArrowLeft' : 'ArrowRight'));
      for (let times = 0; times < 3; ++times) await input.press(key);
      assert.ok(await input.getAttribute('aria-valuetext'));
    }
    assert.notEqual(await ask(figure, 'JSON.stringify(live.values)'), last, `knob ${n}`);
    assert.ok(await input.evaluate(element => element.labels[0].textContent.trim().length > 3), `the name of knob ${n}`);
  }
}

/** A drag in each picture that can be dragged changes a knob or the view, and so does an arrow key. */
async function drag_pictures(page, figure) {
  const canvases = figure.locator('canvas:is(.draws, .turns)');
  const state = () => ask(figure, 'JSON.stringify([live.values, live.drawn, live.panels.map(panel => panel.view)])');
  for (let n = 0; n < await canvases.count(); ++n) {
    await canvases.nth(n).scrollIntoViewIfNeeded();
    const box = await canvases.nth(n).boundingBox();
    let last = await state();
    await page.mouse.move(box.x + 0.55 * box.width, box.y + 0.5 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.35 * box.height, {steps: 4});
    await page.mouse.up();
    assert.notEqual(await state(), last, `a drag in picture ${n}`);
    last = await state();
    await canvases.nth(n).focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowUp');
    assert.notEqual(await state(), last, `keys in picture ${n}`);
  }
}

/** Each sentence with a link sets what it says, and another finding is told. */
async function follow_sentences(page, figure, name) {
  const links = page.locator(`a.live-set[href="#live_${name}"]`);
  assert.ok(await links.count() > 0, 'a sentence with a link');
  const findings = new Set([await told(figure)]);
  for (let n = 0; n < await links.count(); ++n) {
    const knobs = await ask(figure, 'live.knobs.map(knob => knob.name)');
    const wanted = [...new URLSearchParams(await links.nth(n).getAttribute('data-set'))].filter(([knob]) => knobs.includes(knob));
    await figure.evaluate(element => { element.has_told = new Promise(done => { element.addEventListener('told', done, {once: true}); }); });
    await links.nth(n).click();
    await figure.evaluate(element => element.has_told);
    const values = await ask(figure, 'live.values');
    for (const [knob, value] of wanted) assert.equal(values[knob], Number(value), `${knob} of ${await links.nth(n).textContent()}`);
    findings.add(await told(figure));
  }
  assert.ok(findings.size > 1, 'the finding follows the knobs');
}

for (const name of figures) {
  test(`${name}: knobs, drags, keys and the page's sentences change it, and its state is an address.`, async () => {
    assert.ok(existsSync(join(book, `live_${name}.js`)), 'the figure’s script');
    const {page, figure} = await open_figure(name);
    assert.match(await told(figure), /\.$/);
    await page.evaluate(axe.source);
    assert.deepEqual(await serious_violations(page, name), []);
    await turn_knobs(figure);
    await figure.locator('button', {hasText: 'Reset'}).click();
    assert.ok(await ask(figure, 'live.knobs.every(knob => live.values[knob.name] === knob.start)'), 'the page’s own state');
    await drag_pictures(page, figure);
    await follow_sentences(page, figure, name);
    const [link, values] = [await ask(figure, 'live.link'), await ask(figure, 'JSON.stringify(live.values)')];
    await page.goto('about:blank');
    await page.goto(address(page_of(name)) + link.slice(link.indexOf('#')));
    await page.waitForFunction(([id, wanted]) => JSON.stringify(document.getElementById(id).live?.values) === wanted, [`live_${name}`, values]);
    await page.emulateMedia({media: 'print'});
    assert.ok(await figure.locator('div.live-still').isVisible());
    assert.equal(await figure.locator('canvas').first().isVisible(), false);
    assert.deepEqual(page.complaints, []);
    await page.context().close();
  });

  test(`${name}: in the dark on a phone axe finds nothing serious, and nothing is wider than the page.`, async () => {
    const {page, figure} = await open_figure(name, {viewport: narrow, colourScheme: 'dark'});
    await told(figure);
    await page.evaluate(axe.source);
    assert.deepEqual(await serious_violations(page, name), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.context().close();
  });

  test(`${name}: without scripts there is a still picture, and the prediction folds its answer.`, async () => {
    const page = await open_page(browser, {javaScriptEnabled: false});
    await page.goto(address(page_of(name)));
    assert.ok(await page.locator(`#live_${name} div.live-still`).isVisible());
    const fold = page.locator(`form[data-prediction="${name}"] details`);
    assert.equal(await fold.locator('p').isVisible(), false);
    await fold.locator('summary').click();
    assert.ok(await fold.locator('p').isVisible());
    await page.context().close();
  });
}

test('What a reader predicted is kept in the browser and shown beside what happens.', async () => {
  const [name] = figures;
  const {page} = await open_figure(name);
  const form = page.locator(`form[data-prediction="${name}"]`);
  const choice = form.locator('input[type="radio"]').nth(1);
  await choice.check();
  const words = await choice.getAttribute('value');
  assert.equal(await form.locator('.predicted').textContent(), `You predicted: ${words}. Now look.`);
  assert.ok(await form.locator('details p').last().isVisible());
  await form.locator('input[type="radio"]').nth(0).check();
  await choice.check();
  assert.equal(await form.locator('input:checked').count(), 1);
  await page.reload();
  assert.equal(await form.locator('.predicted').textContent(), `You predicted: ${words}. Now look.`);
  await page.context().close();
});

test('A guess is drawn into the figure that answers it as soon as it is made, where its axis has it.', async () => {
  const {page, figure} = await open_figure('turn_per_step');
  const input = page.locator('form[data-prediction="turn_per_step"] input');
  const drawn = () => figure.locator('canvas').first().evaluate(canvas => canvas.toDataURL());
  await told(figure);
  const without = await drawn();
  for (const [guess, is_seen] of [['2.5', true], ['90', false]]) {
    await input.fill(guess);
    await input.press('Enter');
    assert.equal(await drawn() !== without, is_seen, guess);
  }
  await page.context().close();
});

for (const [name, prediction, choice, found] of [['phase_portrait', 'two_lines', 'velocity first', 'spirals out'], ['door', 'door', '8, 4 and 0', 'makes a torque of']])
  test(`${name} would answer the question above it: it shows where it starts, and the rest once that is answered.`, async () => {
    const {page, figure} = await open_figure(name, {gates: 'shut'});
    const drawn = n => figure.locator('canvas').nth(n).evaluate(canvas => canvas.toDataURL());
    assert.match(await told(figure), /\bSay first/);
    assert.ok(!(await told(figure)).includes(found));
    const before = [await drawn(0), await drawn(1)];
    await page.locator(`form[data-prediction="${prediction}"]`).getByLabel(choice).check();
    await figure.locator('.live-finding').filter({hasText: found}).waitFor();
    for (const n of [0, 1]) assert.notEqual(await drawn(n), before[n], `picture ${n}`);
    await page.context().close();
  });

test('The door’s graph is drawn where the push has been turned, and begins again with a reset.', async () => {
  const {page, figure} = await open_figure('door');
  const curve = () => ask(figure, 'live.described.seen.filter(Boolean).length');
  await told(figure);
  const at_first = await curve();
  await figure.locator('canvas').nth(1).focus();
  for (let times = 0; times < 10; ++times) await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => document.getElementById('live_door').live.values.angle === 90);
  assert.equal(await curve(), at_first + 10);
  await figure.locator('button', {hasText: 'Reset'}).click();
  await page.waitForFunction(() => document.getElementById('live_door').live.values.angle === 60);
  assert.equal(await curve(), at_first);
  await page.context().close();
});

test('A press on a name lights its rung, a slider chooses its budget, and the exact solution stays grey until the question is answered.', async () => {
  const {page, figure} = await open_figure('price_of_error', {gates: 'shut', viewport: narrow});
  const names = figure.locator('canvas').nth(1);
  const drawn = n => figure.locator('canvas').nth(n).evaluate(canvas => canvas.toDataURL());
  const telling = words => figure.locator('.live-finding').filter({hasText: words}).waitFor();
  const press = async part => {
    const {width, height} = await names.boundingBox();
    await names.click({position: {x: width / 4, y: part * height}});
  };
  await telling('slope');
  assert.doesNotMatch(await told(figure), /thousandth/);
  await press(0.98);
  await telling('stays grey until you have answered');
  const grey = [await drawn(0), await drawn(1)];
  await page.locator('form[data-prediction="price_of_error"]').getByLabel('about 10 times').check();
  await telling('The exact solution is lit');
  for (const n of [0, 1]) assert.notEqual(await drawn(n), grey[n], `picture ${n}`);
  await press(0.08);
  await telling('“momentum-carrying” is lit');
  await names.press('ArrowDown');
  await names.press('ArrowDown');
  await telling('“splitting” is lit');
  await figure.getByLabel('Rungs', {exact: true}).selectOption('1');
  await names.press('ArrowUp');
  await telling('“splitting by axes” is lit');
  await figure.getByLabel('Time for a simulated second').press('ArrowRight');
  await telling(/^For .* a simulated second/);
  assert.equal(await figure.getByLabel('What you have').inputValue(), '1');
  await figure.getByLabel('Largest error allowed').press('ArrowRight');
  await telling(/^For an error of at most/);
  await page.context().close();
});

test('Out of sight nothing moves, and a reader who wants little motion begins at rest.', async () => {
  const moving = figures.find(name => name === 'energy_sphere') ?? figures[0];
  const {page, figure} = await open_figure(moving);
  assert.equal(await ask(figure, 'live.is_playing'), false, 'at rest');
  await figure.locator('button', {hasText: 'Play'}).click();
  await page.waitForFunction(id => document.getElementById(id).live.time > 0.05, `live_${moving}`);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForTimeout(300);
  const time = await ask(figure, 'live.time');
  await page.waitForTimeout(300);
  assert.equal(await ask(figure, 'live.time'), time);
  await page.context().close();
});

test('On a phone the first picture stays in view while one turns the knobs below it, hides none that has the focus, and goes with its figure.', async () => {
  for (const name of figures.filter(each => each !== 'scene')) {
    const {page, figure} = await open_figure(name, {viewport: {width: 390, height: 700}});
    const header = await page.locator('#sidebar').evaluate(element => element.getBoundingClientRect().bottom);
    const picture = () => figure.locator('canvas').first().evaluate(canvas => { const {top, bottom} = canvas.getBoundingClientRect(); return {top, bottom}; });
    const knobs = figure.locator('.live-knob :is(input, select)');
    for (const n of [await knobs.count() - 1, 0]) {
      await knobs.nth(n).focus();
      await page.waitForTimeout(100); // until what was still being laid out above it has its height
      await knobs.nth(n).evaluate(knob => knob.scrollIntoView({block: 'nearest'}));
      const {top, bottom} = await picture(), knob = await knobs.nth(n).boundingBox();
      assert.ok(top >= header && bottom - top < 0.45 * 700, `${name}: the picture reaches from ${top} to ${bottom}`);
      assert.ok(knob.y >= bottom && knob.y + knob.height < 701, `${name}: knob ${n} at ${knob.y} beside a picture down to ${bottom}`);
    }
    const beyond = await figure.evaluate(element => {
      scrollTo(0, scrollY + element.getBoundingClientRect().bottom - 100);
      return element.querySelector('canvas').getBoundingClientRect().bottom - element.getBoundingClientRect().bottom;
    });
    assert.ok(beyond < 1, `${name}: the picture ends with its figure, ${beyond} px beyond it`);
    await page.context().close();
  }
});

test('A finger that scrolls over a picture or a slider changes nothing; one that sets out sideways draws.', async () => {
  const {page, figure} = await open_figure('throw', {viewport: narrow, hasTouch: true, isMobile: true});
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...touchPoints) => session.send('Input.dispatchTouchEvent', {type, touchPoints});
  const swipe = async ({x, y, width, height}, dx, dy) => {
    const from = {x: x + 0.6 * width, y: y + 0.6 * height};
    await touch('touchStart', from);
    for (let n = 1; n <= 8; ++n) await touch('touchMove', {x: from.x + (dx * n) / 8, y: from.y + (dy * n) / 8});
    await touch('touchEnd');
  };
  const scrolled = () => page.evaluate(() => window.scrollY);
  const values = () => ask(figure, 'JSON.stringify(live.values)');
  const before = await values();
  for (const place of ['canvas.draws', 'input[type="range"]']) {
    const element = figure.locator(place).first();
    await element.scrollIntoViewIfNeeded();
    const top = await scrolled();
    await swipe(await element.boundingBox(), 3, -120);
    await page.waitForFunction(then => window.scrollY > then + 50, top);
    assert.equal(await values(), before, place);
  }
  const canvas = figure.locator('canvas.draws').first();
  await canvas.scrollIntoViewIfNeeded();
  await swipe(await canvas.boundingBox(), -80, 10);
  assert.notEqual(await values(), before);
  await page.context().close();
});

test('A symbol stands in italics beside its knob and in the picture, and bare in a list of choices.', async () => {
  const {page, figure} = await open_figure('damping');
  assert.deepEqual(await figure.locator('.live-knob label i').allTextContents(), ['k', 'h']);
  assert.equal(await figure.locator('.live-knob option').first().textContent(), 'exp(−k h)');
  const still = await figure.locator('.live-still tspan[font-style="italic"]').allTextContents();
  assert.deepEqual([...new Set(still)], ['k h']);
  assert.doesNotMatch(await figure.locator('.live-still').textContent(), /\*/);
  await page.context().close();
});

test('Where a panel waits for an answer, it says so, and the still picture on paper shows what it waits for.', async () => {
  for (const name of ['door', 'phase_portrait', 'stutter']) {
    const {page, figure} = await open_figure(name, {gates: 'shut'});
    const written = () => figure.evaluate(element => {
      const words = [], {live} = element;
      for (const {painter} of live.panels) painter.text = text => words.push(text);
      live.draw();
      return words;
    });
    assert.ok((await written()).includes('answer first'), name);
    assert.doesNotMatch(await figure.locator('.live-still').textContent(), /answer first/);
    await page.context().close();
    const answered = await open_figure(name);
    assert.ok(!(await answered.figure.evaluate(element => {
      const words = [];
      for (const {painter} of element.live.panels) painter.text = text => words.push(text);
      element.live.draw();
      return words;
    })).includes('answer first'), name);
    await answered.page.context().close();
  }
});
