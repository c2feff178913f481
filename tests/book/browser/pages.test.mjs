// Every page opens from its file: without an error, without a request that leaves the folder, set and not too wide. What takes
// the time is to open a page, so whatever can be asked of one that is open is asked at once.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {after, before, test} from 'node:test';
import {address, follow, launch, narrow, open_page} from './browser.mjs';
import {reading_pages, sampled_pages} from './pages.mjs';

let browser, page, narrow_page, formulas = 0;
before(async () => {
  browser = await launch();
  page = await open_page(browser, {reducedMotion: 'reduce'});
  narrow_page = await open_page(browser, {viewport: narrow});
});
after(() => browser.close());

/// The formulas without size, and those whose TeX stands on the page for the eye.
function faults_of_formulas() {
  const small = [...document.querySelectorAll('.katex')]
    .filter(formula => formula.checkVisibility() && formula.getBoundingClientRect().width < 2);
  const raw = /\\f[$[\]{(]|\\[()[\]]|\\(frac|times|cdot|omega|vec|mathbf)\b/.exec(
    [...document.querySelectorAll('main')].map(contents => {
      const copy = contents.cloneNode(true);
      copy.querySelectorAll('.katex, .fragment, pre, code, script').forEach(element => element.remove());
      return copy.textContent;
    }).join());
  return [...small.map(formula => `no size: ${formula.textContent}`), ...raw ? [`raw: ${raw[0]}`] : []];
}

/// What is wider than the window, from the outside in, when the whole page is.
function what_scrolls_sideways() {
  const {scrollWidth, clientWidth} = document.scrollingElement;
  // A page that hides what does not fit would pass by the width alone.
  const is_contained = element => {
    for (let box = element.parentElement; box && box !== document.body; box = box.parentElement) {
      if (getComputedStyle(box).overflowX !== 'visible') return true;
    }
    return false;
  };
  const too_wide = [...document.querySelectorAll('body *')].filter(element => {
    const {right, width, height} = element.getBoundingClientRect();
    return right > clientWidth + 1 && width > 1 && height > 1 && element.checkVisibility() && !is_contained(element);
  });
  const names = too_wide.slice(0, 5).map(element => element.outerHTML.slice(0, 90));
  return scrollWidth > clientWidth || too_wide.length ? [`${scrollWidth} > ${clientWidth}`, ...names] : [];
}

/// The tables whose head does not stand above its columns.
function tables_out_of_line() {
  const left = cell => cell.getBoundingClientRect().left;
  return [...document.querySelectorAll('.contents table')].filter(table => {
    const head = [...table.querySelector('tr')?.querySelectorAll('th') ?? []];
    const body = [...table.querySelectorAll('tr')].find(row => row.querySelector('td'))?.children ?? [];
    return head.length > 1 && head.length === body.length && head.some((cell, column) =>
      Math.abs(left(cell) - left(body[column])) > 1);
  }).map(table => table.textContent.trim().slice(0, 60));
}

/// The families of the page's text and code that are not among the fonts that it has loaded.
async function strange_families() {
  await document.fonts.ready;
  const wanted = ['main p', 'main code'].map(selector => document.querySelector(selector)).filter(Boolean);
  const families = wanted.map(element => getComputedStyle(element).fontFamily.split(',')[0].replace(/"/g, ''));
  return families.filter(family => ![...document.fonts].some(font => font.family.replace(/"/g, '') === family && font.status === 'loaded'));
}

/// What takes its time to change its look, or scrolls by itself.
function what_moves() {
  return [document.documentElement, ...document.body.querySelectorAll('*')].filter(element => {
    const {transitionDuration, animationName, animationDuration, scrollBehavior} = getComputedStyle(element);
    const longest = Math.max(...transitionDuration.split(',').map(parseFloat),
      ...animationName === 'none' ? [0] : animationDuration.split(',').map(parseFloat));
    return longest > 0.01 || scrollBehavior === 'smooth';
  }).slice(0, 5).map(element => element.outerHTML.slice(0, 80));
}

/// What can be pressed or typed into.
function controls() {
  return [...document.querySelectorAll('#sidebar, nav, button, input')].filter(control => control.checkVisibility())
    .map(control => control.outerHTML.slice(0, 80));
}

for (const name of sampled_pages) {
  test(`${name} opens from its file without an error, its formulas and tables set.`, async context => {
    page.complaints.length = 0;
    await page.goto(address(name), {waitUntil: 'load'});
    assert.ok((await page.title()).length > 0, 'the page has no title');
    assert.deepEqual(await page.evaluate(faults_of_formulas), []);
    assert.deepEqual(await page.evaluate(tables_out_of_line), [], 'the head of the table is not above its columns');
    assert.deepEqual(page.complaints, []);
    if (!reading_pages.includes(name)) return;
    formulas += await page.locator('.katex').count();
    await context.test('The letters of its text and code come with the book.', async () =>
      assert.deepEqual(await page.evaluate(strange_families), []));
    await context.test('Nothing moves for a reader who asked for less motion.', async () =>
      assert.deepEqual(await page.evaluate(what_moves), []));
    await context.test('On paper there is no sidebar, no button and no way to search.', async () => {
      await page.emulateMedia({media: 'print'});
      const shown = await page.evaluate(controls);
      await page.emulateMedia({media: null});
      assert.deepEqual(shown, []);
      assert.notDeepEqual(await page.evaluate(controls), [], 'there is none on the screen either');
    });
  });

  test(`${name} does not scroll sideways in 360 pixels.`, async () => {
    await narrow_page.goto(address(name));
    assert.deepEqual(await narrow_page.evaluate(what_scrolls_sideways), []);
  });
}

test('Formulas were looked at: some page has one.', () => assert.ok(formulas > 0));

/// How far the outermost pixels at each edge of a box differ from the page's colour, from 0 to 255: the median, since letters differ too.
async function shades_at_edges(box) {
  const {x, y, width, height} = await box.evaluate(element => {
    element.scrollIntoView({block: 'center'});
    return element.getBoundingClientRect().toJSON();
  });
  const clip = {x, y: y + height / 2 - 30, width, height: 60};  // what stays in sight of the tallest
  const picture = (await box.page().screenshot({clip})).toString('base64');
  return box.evaluate(async (element, base64) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
    Object.assign(canvas.canvas, {width: image.width, height: image.height});
    canvas.drawImage(image, 0, 0);
    const paper = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    const difference_at = x => {
      const {data} = canvas.getImageData(x, 0, 1, image.height);
      const differences = Array.from({length: image.height}, (_, y) =>
        Math.max(...paper.map((colour, part) => Math.abs(colour - data[4 * y + part])))).sort((a, b) => a - b);
      return differences[Math.floor(image.height / 2)];
    };
    return {left: difference_at(2), right: difference_at(image.width - 3)};
  }, picture);
}

for (const colourScheme of ['light', 'dark']) {
  test(`A table that is cut is shaded where it goes on, and keeps its first column in sight, in ${colourScheme}.`, async () => {
    const coloured = await open_page(browser, {viewport: {...narrow, width: 240}, colourScheme});
    let cut = 0;
    for (const name of reading_pages) {
      await coloured.goto(address(name));
      await coloured.evaluate(() => document.querySelectorAll('figure.table:not(.verdicts) > .scroll').forEach(box =>
        box.toggleAttribute('data-cut', box.checkVisibility() && box.scrollWidth > box.clientWidth + 60 && box.clientHeight > 60)));
      const box = coloured.locator('[data-cut]').first();
      if (!await box.count()) continue;
      if (++cut > 3) break;  // one style sheet sets them all
      await coloured.locator('[data-cut][role="region"]').first().waitFor(); // the script finds what is cut, once the page is laid out
      // Where nothing is hidden the edge is the page's colour; a shade differs from it by more than a rounding of colours.
      for (const [share, goes_on] of [[0, true], [0.5, true], [1, false]]) {
        const hidden = await box.evaluate((element, part) => {
          element.scrollLeft = part * (element.scrollWidth - element.clientWidth);
          return element.querySelector('td').getBoundingClientRect().left - element.getBoundingClientRect().left;
        }, share);
        assert.ok(Math.abs(hidden) < 2, `${name}, scrolled by ${share} of its way: the first column stands at ${hidden}`);
        // A figure that comes to life above moves the table while its picture is taken.
        let shades = await shades_at_edges(box);
        for (let n = 0; n < 4 && shades.right > 8 !== goes_on; ++n) shades = await shades_at_edges(box);
        assert.equal(shades.right > 8, goes_on, `${name}, scrolled by ${share} of its way: ${JSON.stringify(shades)}`);
      }
    }
    assert.ok(cut > 0, 'no table of the book is wider than 240 pixels');
    await coloured.context().close();
  });
}

test('Next leads through the whole book in order, and Previous back again.', async () => {
  for (const [relation, order] of [['next', reading_pages], ['prev', [...reading_pages].reverse()]]) {
    await page.goto(address(order[0]));
    const walked = [order[0]];
    const link = page.locator(`a[rel=${relation}]`);
    while (await link.count() && walked.length <= order.length) {
      await follow(page, link);
      walked.push(new URL(page.url()).pathname.split('/').pop());
    }
    assert.deepEqual(walked, order);
  }
});

/// Bytes that a page asks for, without those of its figures, which stand in it, and of what moves them, which loads after it.
async function weight_before_figures(name) {
  const fresh = await open_page(browser), files = new Set([address(name)]);
  fresh.on('requestfinished', request => files.add(request.url().split('#')[0]));
  await fresh.goto(address(name), {waitUntil: 'networkidle'});
  await fresh.context().close();
  const sizes = [...files].filter(file => !/(?:player|live)\w*\.(?:js|css)$/.test(file)).map(file => readFileSync(fileURLToPath(file)).length);
  const figures = readFileSync(fileURLToPath(address(name)), 'utf8').match(/<figure class="(?:drawing|player|live)[^]*?<\/figure>/g) ?? [];
  return sizes.reduce((sum, size) => sum + size, 0) - Buffer.byteLength(figures.join(''));
}

test('The first pages weigh less than 300 kB before their figures, fonts and style and all.', async () => {
  for (const name of ['index.html', 'how_to_read.html', 'chapter_01_force.html']) {
    const weight = await weight_before_figures(name);
    assert.ok(weight < 300e3, `${name} weighs ${weight} bytes`);
  }
});
