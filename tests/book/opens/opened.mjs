// What is wrong with a folder of pages once a browser has opened them all.
import {readdirSync, realpathSync} from 'node:fs';
import {join, relative, sep} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const tabs_at_once = 4;      // two a core: while one waits for its files another draws
const patience = 120_000;    // only so that a page that never loads is named; no verdict on how long one takes

/// Runs in the page: comes to rest, and answers with the page's anchors and links as its scripts have left them.
async function rest_and_tell() {
  await document.fonts.ready;
  for (const button of document.querySelectorAll('.shut button')) button.click();
  // A figure that one can touch starts its program when a reader comes near.
  for (const figure of document.querySelectorAll('figure.live[data-script]')) {
    figure.scrollIntoView({behavior: 'instant'});
    while (!figure.waking) await new Promise(requestAnimationFrame);
    await figure.waking.catch(() => {});  // told in the console
  }
  await document.fonts.ready;  // for what the figures have written
  await new Promise(done => requestAnimationFrame(() => setTimeout(done)));
  return {
    anchors: [...document.querySelectorAll('[id], a[name]')].flatMap(({id, attributes}) => [id, attributes.name?.value]).filter(Boolean),
    // An anchor of a drawing holds its address in an object.
    links: [...document.querySelectorAll('a, area')].map(({href}) => href?.baseVal ?? href).filter(Boolean)
      .map(href => new URL(href, document.baseURI).href),
  };
}

/// A tab that opens one page after another; `open(address)` answers with what `rest_and_tell` does, and `complaints`.
async function tab_for(browser, base) {
  let complaints, requested, loaded;
  const heard = {
    'Runtime.exceptionThrown': ({exceptionDetails: {text, exception}}) =>
      complaints.add(`${text} ${exception?.description?.split('\n')[0] ?? exception?.value ?? ''}`.trim()),
    'Runtime.consoleAPICalled': ({type, args}) => {
      if (!['error', 'assert'].includes(type)) return;
      complaints.add(`console.${type}: ${args.map(({value, description}) => value ?? description).join(' ')}`);
    },
    'Log.entryAdded': ({entry: {level, text}}) => {
      if (level === 'error' && !text.startsWith('Failed to load resource')) complaints.add(text);  // which is told below
    },
    'Network.requestWillBeSent': ({requestId, request: {url}}) => {
      requested.set(requestId, url);
      if (!/^(data|blob|about):/.test(url) && !url.startsWith(base)) complaints.add(`leaves the folder: ${url}`);
    },
    'Network.loadingFailed': ({requestId, errorText, canceled}) => {
      const url = requested.get(requestId) ?? '';
      if (!canceled && (url.startsWith(base) || !/^(file|https?):/.test(url)))
        complaints.add(`does not load: ${decodeURI(url).replace(decodeURI(base), '')} (${errorText})`);
    },
    'Inspector.targetCrashed': () => loaded?.failed(new Error('the tab crashed')),
    'Page.lifecycleEvent': ({name, loaderId}) => {
      if (name === 'load') loaded?.seen(loaderId);
    },
  };
  const tab = await browser.open_tab((method, params) => complaints && heard[method]?.(params));
  for (const domain of ['Runtime', 'Log', 'Network', 'Page']) await tab.send(`${domain}.enable`);
  await tab.send('Page.setLifecycleEventsEnabled', {enabled: true});
  // What moves by itself would move while the page is looked at, and for as long as that takes.
  await tab.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-reduced-motion', value: 'reduce'}]});

  async function load(address) {
    const seen = new Set();
    let done, wanted;
    const is_loaded = new Promise((resolve, failed) => {
      done = resolve;
      loaded = {failed, seen: loader => { seen.add(loader); if (loader === wanted) resolve(); }};
    });
    is_loaded.catch(() => {});  // awaited below, unless the navigation fails first
    const {loaderId, errorText} = await tab.send('Page.navigate', {url: address});
    if (errorText) throw new Error(errorText);
    wanted = loaderId;
    if (seen.has(wanted)) done();
    await is_loaded;
    const {result, exceptionDetails} = await tab.send('Runtime.evaluate',
      {expression: `(${rest_and_tell})()`, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  return {async open(address) {
    complaints = new Set();
    requested = new Map();
    let clock;
    const too_long = new Promise((_, failed) => {
      clock = setTimeout(() => failed(new Error(`has not come to rest in ${patience / 1000} s`)), patience);
    });
    try {
      return {complaints, ...await Promise.race([load(address), too_long])};
    } catch (error) {
      return {complaints: complaints.add(error.message), anchors: [], links: []};
    } finally {
      clearTimeout(clock);
    }
  }};
}

function files_below(folder) {
  return readdirSync(folder, {withFileTypes: true}).flatMap(entry =>
    entry.isDirectory() ? files_below(join(folder, entry.name)) : [join(folder, entry.name)]);
}

/// Why a link leads nowhere; nothing if it leads somewhere, or to where it is not followed.
function fault_of_link(link, base, files, pages) {
  if (/^(https|mailto|data|javascript):/.test(link)) return undefined;
  if (!link.startsWith(base)) return `a link leaves the folder: ${link}`;
  const [place, ...rest] = link.split('#');
  const file = fileURLToPath(place.split('?')[0]).slice(fileURLToPath(base).length);
  if (!files.has(file)) return `a link to no file of the folder: ${file}`;
  // Behind a figure's anchor may stand the state in which it is to be seen: #live_NAME?knob=value.
  const fragment = decodeURIComponent(rest.join('#')).replace(/^(live_\w+)\?.*$/, '$1');
  if (!fragment || fragment === 'top' || !pages.has(file) || pages.get(file).anchors.has(fragment)) return undefined;
  return `a link to no anchor of ${file}: ${fragment}`;
}

/// Opens every page of the folder, those of `first` before the others: {pages: their number, faults: ["page: what is wrong"]}.
export async function open_all(browser, given_folder, first = []) {
  const folder = realpathSync(given_folder) + sep, base = pathToFileURL(folder).href;
  const files = new Set(files_below(folder).map(file => relative(folder, file)));
  const names = [...new Set([...first, ...[...files].filter(file => file.endsWith('.html')).sort()])];
  const left = [...names], pages = new Map();
  await Promise.all(Array.from({length: Math.min(tabs_at_once, names.length)}, async () => {
    const tab = await tab_for(browser, base);
    for (let name; (name = left.shift()) !== undefined;) {
      const {complaints, anchors, links} = await tab.open(pathToFileURL(join(folder, name)).href);
      pages.set(name, {complaints, anchors: new Set(anchors), links: new Set(links)});
    }
  }));
  const faults = names.flatMap(name => {
    const {complaints, links} = pages.get(name);
    const dead = [...links].map(link => fault_of_link(link, base, files, pages)).filter(Boolean);
    return [...complaints, ...dead].map(fault => `${name}: ${fault}`);
  });
  return {pages: names.length, faults};
}
