// node tests/book/look.mjs BOOK_FOLDER OUT_FOLDER
// Takes pictures of every page for reading, wide and narrow, light and dark, for people to look at: no test finds what is
// ugly. PAGE.wide.light.1.png is the top of a page, .2.png what follows.
// It needs Chromium (TUMBLE_CHROMIUM, else the first on the path) and playwright-core (NODE_PATH, else the packages that
// `ctest -L book` has put into a build tree of this checkout).
import {existsSync, mkdirSync, readdirSync} from 'node:fs';
import {Module} from 'node:module';
import {delimiter, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const [book, folder] = process.argv.slice(2);
if (!book || !folder || !existsSync(join(book, 'reading_order.json'))) {
  console.error('node tests/book/look.mjs BOOK_FOLDER OUT_FOLDER: BOOK_FOLDER is a built book, such as build/book');
  process.exit(2);
}

function find_packages() {
  const builds = fileURLToPath(new URL('../../build', import.meta.url));
  const trees = existsSync(builds) ? readdirSync(builds) : [];
  return trees.map(tree => join(builds, tree, 'tests/book/packages/node_modules')).find(existsSync);
}

function find_chromium() {
  return (process.env.PATH ?? '').split(delimiter)
    .flatMap(place => ['chromium', 'chromium-browser', 'google-chrome'].map(name => join(place, name))).find(existsSync);
}

process.env.TUMBLE_BOOK = resolve(book);
process.env.TUMBLE_CHROMIUM ??= find_chromium();
process.env.NODE_PATH ??= find_packages();
Module._initPaths();
const {address, launch, narrow, open_page, wide} = await import('./browser/browser.mjs');
const {reading_pages} = await import('./browser/pages.mjs');

// Longer pictures are shrunk by what shows them until nothing can be read.
const longest = 1800;

async function take_pictures(page, name, look) {
  await page.goto(address(name));
  const {width} = page.viewportSize();
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  for (let part = 0; part * longest < height; ++part) {
    const top = part * longest;
    await page.screenshot({
      path: join(folder, `${name.replace('.html', '')}.${look}.${part + 1}.png`),
      fullPage: true, clip: {x: 0, y: top, width, height: Math.min(longest, height - top)}, timeout: 60_000,
    });
  }
}

mkdirSync(folder, {recursive: true});
const browser = await launch();
for (const [size, viewport] of Object.entries({wide, narrow})) {
  for (const colourScheme of ['light', 'dark']) {
    const page = await open_page(browser, {viewport, colourScheme});
    for (const name of reading_pages) await take_pictures(page, name, `${size}.${colourScheme}`);
    await page.context().close();
  }
}
await browser.close();
console.log(`${readdirSync(folder).length} pictures are in ${folder}`);
