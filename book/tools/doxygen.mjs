// Doxygen turns the expanded Markdown and the headers into HTML; we take the contents of its pages and nothing around them.
import {mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {spawnSync} from 'node:child_process';
import {BookError} from './results.mjs';
import {unescape} from './text.mjs';

const marker = '<!--title:';

/** Writes a page's expanded text where Doxygen reads it: the same path and the same lines, with another ending. */
export function write_expanded(folder, path, text) {
  const file = join(folder, expanded_name(path));
  mkdirSync(dirname(file), {recursive: true});
  writeFileSync(file, text);
}

const expanded_name = path => path.replace(/[() ]+/g, '_').replace(/(\.md)?$/, '.page');

/** What Doxygen says of an expanded page, said of where its author wrote the line. */
function with_places(said, file, page) {
  return said
    .split(`${file}:`)
    .map((part, index) => (index ? part.replace(/^\d+/, line => page.lines[line - 1]?.place ?? `${page.path}:${line}`) : part))
    .join('')
    .replaceAll(file, page.path);
}

/** What Doxygen's versions write in different ways becomes what the oldest of them writes: 1.9.4. `file` is the page's own name. */
function in_the_old_way(html, file) {
  return html
    .replace(/<tr class="memitem:(\w*)(?: template)?"(?: id="\w*")?>/g, '<tr class="memitem:$1">')
    .replace(/<h2 id="header-[\w-]*" class="groupheader">/g, '<h2 class="groupheader">')
    .replace(/<a name="doc-[\w-]*" id="doc-[\w-]*"><\/a>(?=<h2 class="groupheader">)/g, '')
    .replace(/<td class="paramname"><span class="paramname">(<em>\w*<\/em>)<\/span>/g, '<td class="paramname">$1')
    .replace(/<span class="tt">((?:(?!<\/?span\b).)*)<\/span>/gs, '<code>$1</code>')
    .replace(/ href="#(a[0-9a-f]{32,})"/g, ` href="${file}#$1"`) // a member on the same page
    .replace(/<a href="doxygen_crawl\.html"\s*\/?>(?:<\/a>)?/g, '');
}

/** The names of the members that have a description, by the address of it. */
const names_in = (html, file) =>
  [...html.matchAll(/<a id="(\w+)" name="\w+"><\/a>\n<h2 class="memtitle"><span class="permalink">.*?<\/span>([\w~]+)/g)]
    .map(([, id, name]) => [`${file}#${id}`, name]);

/** Without links from a word to a member of another name: 1.9.8 leads from Real, class and using to whatever it knows. */
const without_false_links = (html, names) =>
  html.replace(/<a class="[^"]*" href="(\w+\.html#\w+)">(\w+)<\/a>/g, (link, place, word) =>
    names.has(place) && names.get(place) !== word ? word : link);

/**
 * {file: {title, contents}}; a warning of Doxygen stops the book. One that has gaps lacks what its pages refer to, and so it
 * is not stopped.
 */
export function run_doxygen({doxygen, doxyfile, source, work}, pages, {with_gaps} = {}) {
  const output = join(work, 'doxygen');
  rmSync(output, {recursive: true, force: true});
  writeFileSync(join(work, 'header.html'), `${marker}$title-->\n`);
  writeFileSync(join(work, 'footer.html'), '\n');
  const run = spawnSync(doxygen, [doxyfile], {cwd: work, encoding: 'utf8', maxBuffer: 1 << 28});
  if (run.error) throw run.error;
  const authors = text =>
    pages.reduce((said, page) => with_places(said, join(work, 'expanded', expanded_name(page.path)), page), text)
      .replaceAll(`${source}/`, '');
  const warnings = authors(readFileSync(join(work, 'warnings.log'), 'utf8') + (run.stderr ?? '')).trim();
  if (run.status !== 0 || (warnings && !with_gaps))
    throw new BookError(`Doxygen is not content:\n${warnings || `exit status ${run.status}`}`);

  const html = join(output, 'html');
  const written = readdirSync(html)
    .filter(name => name.endsWith('.html') && name !== 'doxygen_crawl.html')
    .map(name => [name, in_the_old_way(readFileSync(join(html, name), 'utf8'), name)]);
  const names = new Map(written.flatMap(([name, text]) => names_in(text, name)));
  return Object.fromEntries(
    written.map(([name, text]) => {
      const title = unescape(text.slice(text.indexOf(marker) + marker.length, text.indexOf('-->')));
      const start = text.indexOf('<div class="contents">'),
        end = text.lastIndexOf('</div><!-- contents -->');
      const contents = start < 0 ? '' : text.slice(start + '<div class="contents">'.length, end);
      return [name, {title, contents: without_false_links(contents, names)}];
    }),
  );
}
