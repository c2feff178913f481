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
  return Object.fromEntries(
    readdirSync(html)
      .filter(name => name.endsWith('.html'))
      .map(name => {
        const text = readFileSync(join(html, name), 'utf8');
        const title = unescape(text.slice(text.indexOf(marker) + marker.length, text.indexOf('-->')));
        const start = text.indexOf('<div class="contents">'),
          end = text.lastIndexOf('</div><!-- contents -->');
        return [name, {title, contents: start < 0 ? '' : text.slice(start + '<div class="contents">'.length, end)}];
      }),
  );
}
