// The player in the book: it draws, moves, pauses, seeks, turns, follows the page's colours, and puts bodies where the
// recording says.
import assert from 'node:assert/strict';
import {after, afterEach, before, test} from 'node:test';
import {address, launch, narrow, open_page} from './browser.mjs';
import {ask, hue_distance, named_colour, pictures, pixels, player_of, step, stop_the_clock, wait_until} from './canvas.mjs';

let browser, page;
before(async () => { browser = await launch(); });
after(() => browser.close());
afterEach(() => page.context().close());

/// The landing page with its two players in sight and no time passing.
async function open_players(options) {
  page = await open_page(browser, options);
  await stop_the_clock(page);
  await page.goto(address('index.html'));
  await player_of(page).scrollIntoViewIfNeeded();
  return page;
}

/// Lets the player see that it is in sight; the browser says so when it gets to it.
async function until_in_sight() {
  await player_of(page).evaluate(figure => { figure.scrollIntoView({block: 'center'}); });
  await wait_until(page, () => window.next_picture(0) > 0);
}

const button = name => player_of(page).getByRole('button', {name, exact: true});

test('Both pictures are drawn, and the still ones make room for them.', async () => {
  await open_players();
  const paper = await named_colour(page, '--figure-paper');
  for (const view of [0, 1]) {
    const share = await ask(page, `(() => {
      const {canvas} = player.views[given[0]];
      const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      let painted = 0;
      for (let n = 0; n < data.length; n += 4) if (given[1].some((value, k) => Math.abs(data[n + k] - value) > 60)) ++painted;
      return painted / (data.length / 4);
    })()`, [view, paper]);
    assert.ok(share > 0.02 && share < 0.5, `${share} of the picture is body`);
  }
  assert.equal(await page.locator('.player-still:visible').count(), 0);
  assert.equal(await page.locator('.player canvas:visible').count(), 2);
  assert.deepEqual(page.complaints, []);
});

test('In sight it plays by itself, by the clock, and begins again after the end.', async () => {
  await open_players();
  await until_in_sight();
  const start = await pictures(page), begin = await ask(page, 'player.time');
  assert.equal(await step(page, 10, 50), 10);
  assert.ok(Math.abs(await ask(page, 'player.time') - begin - 0.5) < 1e-9);
  const later = await pictures(page);
  assert.notEqual(later[0], start[0]);
  assert.notEqual(later[1], start[1]);
  await ask(page, 'player.seek(player.duration - 0.01)');
  await step(page, 1, 50);
  assert.equal(await ask(page, 'player.time'), 0);
});

test('Out of sight nothing moves.', async () => {
  page = await open_page(browser);
  await stop_the_clock(page);
  await page.goto(`${address('chapter_08_tumbling.html')}#tumbling_run`);
  assert.equal(await player_of(page).evaluate(figure => figure.getBoundingClientRect().bottom < 0), true);
  assert.equal(await step(page, 20, 50), 0);
  assert.equal(await ask(page, 'player.time'), 0);
  await until_in_sight();
  assert.equal(await step(page, 4, 50), 4);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await wait_until(page, () => window.next_picture(0) === 0);
  const time = await ask(page, 'player.time');
  await step(page, 4, 50);
  assert.equal(await ask(page, 'player.time'), time);
});

test('Pause holds both pictures, Play goes on from there, and the button says which it does.', async () => {
  await open_players();
  await until_in_sight();
  await step(page, 7, 40);
  await button('Pause').click();
  const held = await pictures(page), time = await ask(page, 'player.time');
  await step(page, 10, 40);
  assert.deepEqual(await pictures(page), held);
  assert.equal(await ask(page, 'player.time'), time);
  await button('Play').click();
  await step(page, 3, 40); // the first picture after a pause starts the clock
  assert.ok(Math.abs(await ask(page, 'player.time') - time - 0.08) < 1e-9);
  assert.equal(await button('Pause').count(), 1);
});

test('A quarter of the speed is a quarter of the way.', async () => {
  await open_players();
  await until_in_sight();
  const slow = button('¼ speed');
  await slow.press('Space');
  assert.equal(await slow.getAttribute('aria-pressed'), 'true');
  const time = await ask(page, 'player.time');
  await step(page, 10, 40);
  assert.ok(Math.abs(await ask(page, 'player.time') - time - 0.1) < 1e-9);
});

test('The slider seeks in both recordings, by keys too, and tells the time.', async () => {
  await open_players();
  const start = await pictures(page);
  const slider = player_of(page).getByRole('slider', {name: 'Time'});
  await slider.fill('150');
  assert.ok(Math.abs(await ask(page, 'player.time') - 5) < 1e-9);
  assert.equal(await slider.getAttribute('aria-valuetext'), '5.0 s');
  assert.equal(await player_of(page).locator('.player-clock').textContent(), '5.0 s');
  const sought = await pictures(page);
  assert.ok(sought.every((picture, view) => picture !== start[view]));
  assert.equal(await ask(page, 'player.is_playing'), false);
  await slider.press('ArrowRight');
  assert.ok(Math.abs(await ask(page, 'player.time') - 151 / 30) < 1e-9);
  await slider.press('End');
  assert.ok(Math.abs(await ask(page, 'player.time') - 12) < 1e-9);
});

test('In the picture, arrows and dragging turn the view, + and − zoom, Home goes back, space plays.', async () => {
  await open_players({reducedMotion: 'reduce'});
  const first = await pictures(page);
  const canvas = player_of(page).locator('canvas').first();
  const camera = () => ask(page, '({...player.views[0].camera})');
  const began = await camera();
  for (const [key, property, sign] of [['ArrowRight', 'azimuth', 1], ['ArrowLeft', 'azimuth', -1], ['ArrowUp', 'elevation', 1],
    ['ArrowDown', 'elevation', -1], ['+', 'distance', -1], ['-', 'distance', 1]]) {
    const before_key = await camera(), picture = await pictures(page);
    await canvas.press(key);
    assert.ok(sign * ((await camera())[property] - before_key[property]) > 0, key);
    const after_key = await pictures(page);
    assert.ok(after_key.every((drawn, view) => drawn !== picture[view]), `${key} leaves a picture as it was`);
  }
  await canvas.press('ArrowUp');
  await canvas.press('Home');
  assert.deepEqual(await camera(), began);
  assert.deepEqual(await pictures(page), first);

  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 150, box.y + 120, {steps: 5});
  await page.mouse.up();
  const dragged = await camera();
  assert.ok(dragged.azimuth < began.azimuth && dragged.elevation > began.elevation);
  await page.mouse.move(box.x + 10, box.y + 10);
  assert.deepEqual(await camera(), dragged);
  await button('First view').click();
  assert.deepEqual(await pictures(page), first);

  await canvas.press('Space');
  assert.equal(await ask(page, 'player.is_playing'), true);
  await canvas.press('Space');
  assert.equal(await ask(page, 'player.is_playing'), false);
});

test('It never starts by itself for a reader who asked for less motion, but plays when told to.', async () => {
  await open_players({reducedMotion: 'reduce'});
  assert.equal(await ask(page, 'player.is_playing'), false);
  assert.equal(await step(page, 20, 50), 0);
  assert.equal(await ask(page, 'player.time'), 0);
  await button('Play').click();
  await wait_until(page, () => window.next_picture(0) > 0);
  await step(page, 4, 50);
  assert.ok(Math.abs(await ask(page, 'player.time') - 0.2) < 1e-9);
});

test('The dark button changes the picture at once.', async () => {
  await open_players({reducedMotion: 'reduce'});
  const corner = [[5, 5]];
  const [light] = await pixels(page, 0, corner);
  assert.deepEqual(light, await named_colour(page, '--figure-paper'));
  await page.locator('#dark').click();
  const dark = await named_colour(page, '--figure-paper');
  assert.ok(dark[0] < 60 && light[0] > 200);
  await wait_until(page, () => document.documentElement.classList.contains('dark-mode'));
  for (const view of [0, 1]) assert.deepEqual((await pixels(page, view, corner))[0], dark);
});

/// v turned by q, by the product q v q*.
function turn([w, ...u], v) {
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const once = cross(u, v).map((value, k) => value + w * v[k]);
  return cross(u, once).map((value, k) => v[k] + 2 * value);
}

/// The place of a point in a picture of `size`, by similar triangles: the eye, the point, and a plane between them. The
/// field of view is 28 degrees over the shorter side.
function seen(point, {target, azimuth, elevation, distance}, size) {
  const [east, north] = [Math.cos(azimuth), Math.sin(azimuth)];
  const relative = point.map((value, k) => value - target[k]);
  const outward = relative[0] * east + relative[1] * north; // on the ground, towards the camera
  const aside = relative[1] * east - relative[0] * north;
  const [cosine, sine] = [Math.cos(elevation), Math.sin(elevation)];
  const before = distance - (outward * cosine + relative[2] * sine);
  const above = relative[2] * cosine - outward * sine;
  const per_slope = Math.min(size.width, size.height) / (2 * Math.tan(14 * Math.PI / 180));
  return [size.width / 2 + per_slope * aside / before, size.height / 2 - per_slope * above / before];
}

test('The pixels of the handle are where the recorded pose says, and nowhere else.', async () => {
  await open_players({reducedMotion: 'reduce'});
  const bodies = [await named_colour(page, '--figure-1'), await named_colour(page, '--figure-2')]; // twins have two colours
  let tried = 0;
  for (const [view, frame] of [[0, 0], [0, 47], [0, 101], [0, 180], [0, 299], [1, 10], [1, 133], [1, 360]]) {
    const body = bodies[view];
    if (frame === 101) await player_of(page).locator('canvas').first().press('ArrowRight');
    if (frame === 180) await player_of(page).locator('canvas').first().press('+');
    await player_of(page).getByRole('slider').fill(String(frame));
    const {pose, camera, size, parts} = await ask(page, `(({recording, camera, size}) => ({pose: recording.frames[given[1]],
      camera, size, parts: recording.bodies[0].parts}))(player.views[given[0]])`, [view, frame]);
    // The shaft and the bar of chapter 8's T, as the recording has them.
    assert.deepEqual(parts.map(({cylinder}) => cylinder), [[0.008, 0.12], [0.01, 0.06]]);
    const in_world = point => turn(pose.slice(3), point).map((value, k) => value + pose[k]);
    const place = point => seen(in_world(point), camera, size);
    const inside = [[0, 0, 0], [0.057, 0, 0], [-0.057, 0, 0], [0, -0.03, 0], [0, -0.065, 0]];
    const outside = [[0.08, 0, 0], [-0.08, 0, 0], [0, -0.09, 0], [0.05, -0.05, 0], [-0.05, -0.05, 0], [0, 0.035, 0]];

    const projected = await ask(page, 'given[1].map(point => player.views[given[0]].project(point))', [view, inside.map(in_world)]);
    inside.forEach((point, n) => place(point).forEach((value, k) =>
      assert.ok(Math.abs(projected[n][k] - value) < 1e-6, `project() says ${projected[n]}, not ${place(point)}`)));

    const [painted, empty] = [await pixels(page, view, inside.map(place)), await pixels(page, view, outside.map(place))];
    painted.forEach((colour, n) => assert.ok(hue_distance(colour, body) < 15,
      `view ${view}, frame ${frame}: ${inside[n]} m should be body at ${place(inside[n])}, not ${colour}`));
    // From here an outer point may hide behind the body or lie before it; those at a distance tell.
    const axis_points = Array.from({length: 49}, (_, n) => [(n - 24) * 0.0025, 0, 0])
      .concat(Array.from({length: 25}, (_, n) => [0, -0.068 * n / 24, 0])).map(place);
    const thickest = Math.min(size.width, size.height) / (2 * Math.tan(14 * Math.PI / 180)) * 0.0145 / (camera.distance - 0.07);
    outside.forEach((point, n) => {
      const [x, y] = place(point);
      if (axis_points.every(([a, b]) => Math.hypot(a - x, b - y) > thickest)) {
        ++tried;
        assert.ok(!(hue_distance(empty[n], body) < 15), `view ${view}, frame ${frame}: ${point} m should be empty, not ${empty[n]}`);
      }
    });
    assert.deepEqual(await pixels(page, view, [[4, 4]]), [await named_colour(page, '--figure-paper')]);
  }
  assert.ok(tried >= 20, `only ${tried} points outside the body were seen apart from it`);
});

test('Two stand side by side, on 360 pixels too, and both fit.', async () => {
  await open_players({viewport: narrow});
  await page.goto(address('chapter_08_tumbling.html'));
  const side_by_side = () => {
    const [one, other] = [...document.querySelectorAll('.player canvas')].map(canvas => canvas.getBoundingClientRect());
    return one.top === other.top && one.right < other.left && one.left >= 0 && other.right <= innerWidth && one.height > 150;
  };
  await wait_until(page, side_by_side);
  page.setViewportSize({width: 1280, height: 900});
  await wait_until(page, side_by_side);
});

test('In the drawing with the name of the recording a line goes with the time, along a curve that lasts as long.', async () => {
  page = await open_page(browser);
  await stop_the_clock(page);
  await page.goto(address('chapter_08_tumbling.html'));
  for (const share of [0, 0.25, 1]) {
    await ask(page, 'player.seek(given * player.duration)', share);
    const off = await page.locator('.player-cursor').evaluate((line, part) => {
      const {x, width} = document.querySelector('[id$="_t_handle_plot_1"]').getBBox();
      return (line.x1.baseVal.value - x) / width - part;
    }, share);
    assert.ok(Math.abs(off) < 1e-3, `at ${share} of the time the line is off by ${off}`);
  }
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('.player-cursor').isVisible(), false);
});

test('On paper and without scripts there are still pictures, told in words.', async () => {
  await open_players();
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('.player-still:visible').count(), 2);
  assert.equal(await page.locator('.player :is(canvas, button, input):visible').count(), 0);
  await page.context().close();

  page = await open_page(browser, {javaScriptEnabled: false});
  await page.goto(address('index.html'));
  const image = page.getByRole('img', {name: /^Two T-handles side by side/});
  assert.equal(await image.count(), 1);
  assert.equal(await image.locator('svg.player-still:visible').count(), 2);
});

test('A reader who hears the page is told of each picture what it shows and which keys work.', async () => {
  await open_players();
  const canvas = page.getByRole('application', {name: /^A\. Two T-handles/});
  assert.equal(await canvas.count(), 1);
  const hint = await canvas.evaluate(element => document.getElementById(element.getAttribute('aria-describedby')).textContent);
  assert.match(hint, /arrows, \+, −, Home, and space/);
  assert.equal(await page.getByRole('img', {name: /^Two T-handles/}).count(), 0, 'the still picture is told as well');
});
