// Builds the book: node book.mjs SETTINGS.json [--so-far CHAPTERS]
// With --so-far only these chapters, a list with commas, have their results; in the others' place stands that they are being made.
import {
  copyFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import {join} from 'node:path';
import {BookError, Results} from './results.mjs';
import {Directives} from './directives.mjs';
import {Formulas} from './formulas.mjs';
import {lines_of_section, read_exercises} from './exercises.mjs';
import {finish_contents} from './contents.mjs';
import {layout} from './layout.mjs';
import {live_files} from './live.mjs';
import {player_files} from './players.mjs';
import {read_pages} from './pages.mjs';
import {run_doxygen, write_expanded} from './doxygen.mjs';
import {search_script, sections} from './search.mjs';
import {counted} from './text.mjs';

const settings = JSON.parse(readFileSync(process.argv[2], 'utf8'));
settings.colophon = JSON.parse(readFileSync(settings.colophon, 'utf8'));
const made = process.argv[3] === '--so-far' ? new Set(process.argv[4].split(',')) : undefined;

/** What stands in a page's place until its results are there. The page asks for itself again from time to time. */
function stand_in(page) {
  return [
    `# ${page.title} {#${page.id}}`,
    '',
    'This page is being made: its code is being compiled, run and measured on your machine, as all that the book shows ' +
      'was. It appears here by itself as soon as that is done; meanwhile, begin with the first chapters. If `./course book` ' +
      'was stopped, call it again: it goes on where it was.',
    '',
  ].join('\n');
}

function expand_pages(pages, directives) {
  const folder = join(settings.work, 'expanded');
  rmSync(folder, {recursive: true, force: true});
  const complaints = [];
  for (const page of pages.all) {
    page.expanded = page.is_being_made ? stand_in(page) : directives.expand(page, complaints);
    write_expanded(folder, page.path, page.expanded);
  }
  if (complaints.length) throw new BookError(complaints.join('\n'));
}

/** Pages of the reference and of the sources, as far as a reader can come by following links. */
function reachable(written, start, links_of) {
  const found = new Set(start),
    waiting = [...start];
  while (waiting.length)
    for (const [, target] of links_of(waiting.pop()).matchAll(/href="([^"#:]+\.html)/g))
      if (written[target] && !found.has(target)) {
        found.add(target);
        waiting.push(target);
      }
  return found;
}

/** A page that Doxygen made on its own: of a header, a struct, the namespace or a source. */
function reference_page(file, title) {
  const name = title
    .replace(/ (Source File|File Reference|(\w+ )?(Template )?Reference)$/, '')
    .replace(/< .* >/, '')
    .replace(/^.*\/(?=tumble\/)/, file.endsWith('_source.html') ? '$&' : '')
    .replace(/^/, file.startsWith('namespace') ? 'Namespace ' : '');
  return {file, under: 'reference.html', title: name, name};
}

function write_pages(folder, pages, written, directives) {
  const sources = new Map();
  for (const [file, {title}] of Object.entries(written))
    if (file.endsWith('_source.html')) sources.set(title.replace(/ Source File$/, ''), file);
  const formulas = new Formulas(settings.katex);
  const by_file = new Map(pages.all.map(page => [page.file, page]));
  for (const page of pages.all)
    if (!written[page.file]) throw new BookError(`${page.path}: Doxygen made no page ${page.file} of it`);

  const finished = new Map();
  const finish = file => {
    if (!finished.has(file))
      finished.set(
        file,
        finish_contents(written[file].contents, {blocks: directives.blocks, sources, is_page: by_file.has(file)}),
      );
    return finished.get(file);
  };
  const documents = [];
  for (const file of reachable(written, [...by_file.keys()], name => finish(name).html)) {
    const page = by_file.get(file) ?? reference_page(file, written[file].title);
    const {html, headings} = finish(file);
    const more = page.chapter && !page.further && !page.is_being_made ? directives.makers.unquoted_failures(page.chapter) : '';
    const whole = more
      ? `${html}<h2 id="failed_checks">What failed and no page quotes</h2>${more}`
      : html;
    if (!file.endsWith('_source.html'))
      documents.push(
        ...sections(page, whole).map(section => ({...section, weight: page.chapter ? 3 : page.under ? 0.2 : 1.5})),
      );
    const typeset_headings = headings.map(heading => ({...heading, html: formulas.in_page(heading.html, page)}));
    writeFileSync(
      join(folder, file),
      layout(page, {html: formulas.in_page(whole, page), headings: typeset_headings}, pages, settings.book),
    );
  }
  writeFileSync(join(folder, 'search_index.js'), search_script(settings.lunr, documents));
  writeFileSync(
    join(folder, 'reading_order.json'),
    JSON.stringify(pages.all.map(({file, title, id}) => ({file, title, id}))),
  );
}

function copy_theme(folder, live_scripts) {
  const own = join(settings.source, 'book/theme');
  for (const name of readdirSync(own).filter(file => /\.(css|js|svg)$/.test(file)))
    copyFileSync(join(own, name), join(folder, name));
  const player = player_files(settings.source);
  writeFileSync(join(folder, 'player.js'), player.script);
  writeFileSync(join(folder, 'player.css'), player.style);
  const live = live_files(settings.source);
  writeFileSync(join(folder, 'live.js'), live.script);
  writeFileSync(join(folder, 'live.css'), live.style);
  for (const [name, script] of live_scripts) writeFileSync(join(folder, name), script);
  // Doxygen's own style sheet draws arrows and tabs from images that our pages do not use.
  const style = readFileSync(join(settings.work, 'doxygen/html/doxygen.css'), 'utf8');
  writeFileSync(join(folder, 'doxygen.css'), style.replace(/^.*url\(.*$\n/gm, ''));
  for (const name of ['doxygen-awesome.css', 'doxygen-awesome-darkmode-toggle.js'])
    copyFileSync(join(settings.awesome, name), join(folder, name));
  mkdirSync(join(folder, 'katex'));
  const katex = readFileSync(join(settings.katex, 'katex.min.css'), 'utf8');
  const fonts = [...new Set([...katex.matchAll(/url\(["']?fonts\/([^"')]+\.woff2)/g)].map(match => match[1]))];
  writeFileSync(
    join(folder, 'katex/katex.min.css'),
    katex.replace(/,url\([^)]*\.(?:woff|ttf)["']?\) ?format\([^)]*\)/g, ''),
  );
  mkdirSync(join(folder, 'katex/fonts'));
  for (const font of fonts)
    cpSync(join(settings.katex, 'fonts', font), join(folder, 'katex/fonts', font), {dereference: true});
  copyFileSync(join(settings.lunr, 'lunr.js'), join(folder, 'lunr.js'));
}

/** The finished book takes the place of the old one at once; a folder that is not a book stays as it is. */
function publish(fresh, folder) {
  if (existsSync(folder)) {
    if (readdirSync(folder).length && !existsSync(join(folder, 'reading_order.json')))
      throw new BookError(
        `the book's folder ${folder} holds something else; empty it or set TUMBLE_BOOK_FOLDER to another`,
      );
    // A page that asks for itself again must find one: the gap is as short as can be.
    rmSync(`${folder}.old`, {recursive: true, force: true});
    renameSync(folder, `${folder}.old`);
  }
  renameSync(fresh, folder);
  rmSync(`${folder}.old`, {recursive: true, force: true});
}

function build() {
  mkdirSync(settings.work, {recursive: true});
  const pages = read_pages(settings.source, settings.floors);
  for (const page of pages.chapters) page.is_being_made = made !== undefined && !made.has(page.chapter);
  const results = new Results(settings.results);
  const exercises = read_exercises(settings);
  for (const page of pages.chapters)
    if (!page.further) page.lines.push(...lines_of_section(page, exercises, pages));
  const directives = new Directives(settings, results, pages, exercises);
  expand_pages(pages, directives);
  const written = run_doxygen(settings, pages.all, {with_gaps: made !== undefined});

  const fresh = `${settings.folder}.new`;
  rmSync(fresh, {recursive: true, force: true});
  mkdirSync(fresh, {recursive: true});
  write_pages(fresh, pages, written, directives);
  copy_theme(fresh, directives.makers.live_scripts);
  publish(fresh, settings.folder);

  if (!made) tell_red([...new Set(pages.chapters.map(page => page.chapter))], results);
}

/** What does not hold stops no book: the pages show it, and whoever asked for the book is told from this file. */
function tell_red(chapters, results) {
  const red = chapters.flatMap(chapter => [
    ...results.checks(chapter).filter(check => !check.passed).map(check => `${chapter}: ${check.sentence}`),
    ...results.names(chapter, '.failed').map(program => `${chapter}: ${program}: ${results.complaint(chapter, program)}`),
  ]);
  writeFileSync(join(settings.work, 'red.txt'), red.map(line => `${line}\n`).join(''));
  if (red.length) process.stdout.write(`${counted(red.length, 'result')} in red; the pages show which\n`);
}

try {
  build();
} catch (error) {
  if (!(error instanceof BookError)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 1;
}
