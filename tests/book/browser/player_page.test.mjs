// A page that a program wrote: one file, every kind of part, names that try to break out.
// TUMBLE_PLAYER_PAGES is the folder where tests/player wrote it.
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {after, afterEach, before, test} from 'node:test';
import {launch, narrow, open_page} from './browser.mjs';
import {ask, hue_distance, named_colour, pictures, pixels, player_of, step, stop_the_clock, wait_until} from './canvas.mjs';

const axe = createRequire(import.meta.url)('axe-core');
const file = pathToFileURL(join(process.env.TUMBLE_PLAYER_PAGES, 'every_part.html')).href;
const title = 'Every part, <b>bold</b> & </script> "quoted"';

let browser, page;
before(async () => { browser = await launch(); });
after(() => browser.close());
afterEach(() => page.context().close());

async function open_replay(options) {
  page = await open_page(browser, options);
  await stop_the_clock(page);
  await page.goto(file);
}

test('It opens from its file without an error, and a name is text whatever it holds.', async () => {
  await open_replay();
  assert.deepEqual(page.complaints, []);
  assert.equal(await page.title(), title);
  assert.equal(await page.locator('h1').textContent(), title);
  assert.equal(await page.locator('b').count(), 0);
});

test('It plays by itself, and pauses.', async () => {
  await open_replay();
  await wait_until(page, () => window.next_picture(0) > 0);
  const [start] = await pictures(page);
  await step(page, 5, 100);
  assert.ok(Math.abs(await ask(page, 'player.time') - 0.5) < 1e-9);
  const [later] = await pictures(page);
  assert.notEqual(later, start);
  await page.getByRole('button', {name: 'Pause'}).click();
  await step(page, 5, 100);
  assert.equal((await pictures(page))[0], later);
});

test('Every kind of part is drawn in its body\'s colour where the recording says.', async () => {
  await open_replay({reducedMotion: 'reduce'});
  let looked_at = 0;
  for (const frame of [0, 20, 60]) {
    await ask(page, 'player.seek(0.1 * given)', frame);
    // What lies before another body may hide it.
    const places = await ask(page, `player.views[0].recording.bodies.map((_, n) => {
      const view = player.views[0];
      return view.project(view.recording.frames[given].slice(7 * n, 7 * n + 3));
    })`, frame);
    const colours = await pixels(page, 0, places);
    for (const [n, colour] of colours.entries()) {
      const hidden = places.some((other, m) => m !== n && other[2] < places[n][2] && Math.hypot(other[0] - places[n][0],
        other[1] - places[n][1]) < 75);
      if (hidden) continue;
      ++looked_at;
      const own = await named_colour(page, `--figure-${n % 6 + 1}`);
      assert.ok(hue_distance(colour, own) < 15, `frame ${frame}: body ${n} is ${colour}, not like ${own}`);
    }
  }
  assert.ok(looked_at > 20, `only ${looked_at} of 27 were not hidden`);
});

/// Where the followed body is off the middle of the picture, px.
const off_the_middle = () => ask(page, `(() => {
  const [view] = player.views, {width, height} = view.size;
  const frame = view.recording.frames[Math.round(player.time / 0.1)];
  const [x, y] = view.project(frame.slice(7 * player.followed, 7 * player.followed + 3));
  return Math.hypot(x - width / 2, y - height / 2);
})()`);

test('The camera follows the body that is chosen, by pressing it too, and stays with it until told otherwise.', async () => {
  await open_replay({reducedMotion: 'reduce'});
  const canvas = page.locator('.player canvas'), choice = page.getByRole('combobox', {name: 'Follow'});
  const first = await pictures(page), followed = () => ask(page, 'player.followed ?? null');
  await choice.selectOption('thrown');
  assert.equal(await followed(), 8);
  const there = await pictures(page);
  for (const frame of [0, 25, 60]) {
    await ask(page, 'player.seek(0.1 * given)', frame);
    assert.ok(await off_the_middle() < 1e-6);
  }
  assert.notDeepEqual(await pictures(page), there);
  await ask(page, 'player.seek(0)');
  await canvas.press('ArrowRight');
  assert.ok(await off_the_middle() < 1e-6);
  await choice.selectOption('no body');
  assert.equal(await followed(), null);
  await canvas.press('Home');
  assert.deepEqual(await pictures(page), first);

  await ask(page, 'player.seek(2)');
  const [x, y] = await ask(page, 'player.views[0].project(player.views[0].recording.frames[20].slice(56, 59))');
  const press = async (right, down) => {
    const box = await canvas.boundingBox();
    await page.mouse.click(box.x + right, box.y + down);
  };
  await press(x, y);
  assert.equal(await followed(), 8);
  assert.equal(await choice.inputValue(), '8');
  assert.ok(await off_the_middle() < 1e-6);
  await press(4, 4);
  assert.equal(await followed(), null);
});

test('By keys F follows the next body and Shift F the one before; Escape follows none.', async () => {
  await open_replay({reducedMotion: 'reduce'});
  const canvas = page.locator('.player canvas'), followed = () => ask(page, 'player.followed ?? null');
  for (const [key, body] of [['f', 0], ['f', 1], ['Shift+F', 0], ['Shift+F', null], ['Shift+F', 8], ['f', null], ['f', 0], ['Escape', null]]) {
    await canvas.press(key);
    assert.equal(await followed(), body, key);
  }
  const hint = await canvas.evaluate(element => document.getElementById(element.getAttribute('aria-describedby')).textContent);
  assert.match(hint, /Press a body to follow it\. Keys in the picture: .*F follows the next body, Escape none\./);
});

test('A page that is to follow a body does so from the start, and again at Home.', async () => {
  page = await open_page(browser, {reducedMotion: 'reduce'});
  await stop_the_clock(page);
  await page.goto(pathToFileURL(join(process.env.TUMBLE_PLAYER_PAGES, 'following.html')).href);
  assert.equal(await page.getByRole('combobox', {name: 'Follow'}).inputValue(), '8');
  assert.ok(await off_the_middle() < 1e-6);
  const first = await pictures(page);
  await page.locator('.player canvas').press('Escape');
  assert.notDeepEqual(await pictures(page), first);
  await page.locator('.player canvas').press('Home');
  assert.deepEqual(await pictures(page), first);
});

test('It follows the system into the dark, on a wide window and on a narrow one, and axe-core finds nothing.', async () => {
  for (const colourScheme of ['light', 'dark'])
    for (const viewport of [{width: 1280, height: 900}, narrow]) {
      if (page) await page.context().close();
      await open_replay({colourScheme, viewport, reducedMotion: 'reduce'});
      const [corner] = await pixels(page, 0, [[4, 4]]);
      assert.equal(corner[0] < 60, colourScheme === 'dark');
      const {width, height, right} = await page.evaluate(() => ({width: document.scrollingElement.scrollWidth,
        height: document.scrollingElement.scrollHeight, right: document.querySelector('canvas').getBoundingClientRect().right}));
      assert.ok(width <= viewport.width && right <= viewport.width, `${width} pixels wide`);
      assert.ok(height <= viewport.height, `${height} pixels high`);
      await page.evaluate(axe.source);
      const {violations} = await page.evaluate(() => axe.run(document, {resultTypes: ['violations']}));
      assert.deepEqual(violations.map(({id, nodes}) => `${id}: ${nodes[0].html}`), []);
    }
});
