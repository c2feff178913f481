// One Chromium for a file of tests, which sees the book's folder and nothing else.
//   TUMBLE_BOOK      the folder of the book
//   TUMBLE_CHROMIUM  the browser
//   NODE_PATH        the node_modules that hold playwright-core and axe-core
import {createRequire} from 'node:module';
import {readdirSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const {chromium} = createRequire(import.meta.url)('playwright-core');

export const book = process.env.TUMBLE_BOOK;
export const wide = {width: 1280, height: 900};
export const narrow = {width: 360, height: 740};

// Chromium's own errands would otherwise look like requests of the page, or wait for a network.
const quiet = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-sync',
  '--disable-background-networking', '--disable-component-update', '--hide-scrollbars'];

export function launch(executable = process.env.TUMBLE_CHROMIUM) {
  return chromium.launch({executablePath: executable, args: quiet});
}

export const address = name => pathToFileURL(join(book, name)).href;

/// In the page: a reader who has answered every prediction, so that all gates are open.
function answer_everything() {
  const get_item = Storage.prototype.getItem;
  Storage.prototype.getItem = function (key) {
    return get_item.call(this, key) ?? (key.startsWith('tumble.prediction.') ? '' : null);
  };
}

/// Opens an empty page in a context of its own; `page.complaints` gathers errors and forbidden requests.
export async function open_page(browser, {viewport = wide, colourScheme = 'light', gates = 'open', ...more} = {}) {
  const context = await browser.newContext({viewport, colorScheme: colourScheme, ...more});
  if (gates === 'open') await context.addInitScript(answer_everything);
  const page = await context.newPage();
  page.setDefaultTimeout(20_000);
  page.complaints = [];
  page.on('console', message => {
    if (['error', 'warning'].includes(message.type())) page.complaints.push(`console: ${message.text()}`);
  });
  page.on('pageerror', error => page.complaints.push(`script: ${error.message}`));
  page.on('requestfailed', request => page.complaints.push(`failed: ${request.url()}`));
  page.on('request', request => {
    if (!/^(file|data|blob|about):/.test(request.url())) page.complaints.push(`leaves the folder: ${request.url()}`);
  });
  return page;
}

/// Clicks a link and waits until the page it leads to is there.
export async function follow(page, link) {
  const target = await link.evaluate(anchor => anchor.href);
  await link.click();
  await page.waitForURL(target, {waitUntil: 'load'});
}
