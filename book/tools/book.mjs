// Builds the book: node book.mjs SETTINGS.json [--so-far CHAPTERS]
// With --so-far only these chapters, a list with commas, have their results; in the others' place stands that they are being made.
import {execFileSync} from 'node:child_process';
import {
  copyFileSync,
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
import {lines_of_section, read_exercises, with_tasks} from './exercises.mjs';
import {finish_contents} from './contents.mjs';
import {write_fonts} from './fonts.mjs';
import {layout} from './layout.mjs';
import {live_files} from './live.mjs';
import {player_files} from './players.mjs';
import {names_in, pruned} from './prune_style.mjs';
import {read_pages} from './pages.mjs';
import {preview} from './previews.mjs';
import {with_quotes} from './quotes.mjs';
import {Reference, lessons_of} from './reference.mjs';
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
function reachable(is_ours, start, links_of) {
  const found = new Set(start),
    waiting = [...start];
  while (waiting.length)
    for (const [, target] of links_of(waiting.pop()).matchAll(/href="([^"#:]+\.html)/g))
      if (is_ours(target) && !found.has(target)) {
        found.add(target);
        waiting.push(target);
      }
  return found;
}

/** The page of a source, which Doxygen made. */
function source_page(file, title) {
  const name = title.replace(/ Source File$/, '');
  return {file, under: 'reference.html', title: name, name};
}

/** Sections of the reference with the names that they explain: a class's members are called after it. */
function with_symbols(found) {
  const name_at = new Map(found.map(({address, section}) => [address.replace(/.*#/, ''), section]));
  return found.map(each => {
    const owner = name_at.get(/#(\w+)-a[0-9a-f]+$/.exec(each.address)?.[1]);
    return each.section ? {...each, symbol: each.section, owner, section: owner ? `${owner}::${each.section}` : each.section} : each;
  });
}

/** How much a place found there is worth: the chapters explain, their exercises ask, the reference lists. */
function weight_of(page, {address, are_checks, is_row}) {
  if (is_row && page.id === 'reference') return 1; // what one wants to do, and with what
  if (are_checks) return 0.3; // they say in a sentence what the text explains
  if (page.under) return page.is_brought ? 0.25 : 0.4;
  if (/#exercise/.test(address)) return 0.6;
  if (['handbook', 'reference'].includes(page.id)) return 0.5; // they list what others explain
  return page.chapter ? 1 : 0.9;
}

function write_pages(folder, pages, written, directives) {
  const sources = new Map();
  for (const [file, {title}] of Object.entries(written))
    if (file.endsWith('_source.html')) sources.set(title.replace(/ Source File$/, ''), file);
  const formulas = new Formulas(settings.katex);
  const by_file = new Map(pages.all.map(page => [page.file, page]));
  for (const page of pages.all)
    if (!written[page.file]) throw new BookError(`${page.path}: Doxygen made no page ${page.file} of it`);

  const reference = new Reference(written, pages.headers, {source: settings.source, lessons: lessons_of(pages)});
  directives.makers.reference = reference;
  const finished = new Map();
  const finish = file => {
    if (!finished.has(file)) {
      const header = reference.by_file.get(file);
      const {title, contents, headings} = header ? reference.page(header) : written[file];
      const done = finish_contents(reference.redirect(contents), {
        blocks: directives.blocks,
        sources,
        headers: reference.headers,
        is_page: by_file.has(file),
      });
      finished.set(file, {...done, title, headings: headings ?? done.headings});
    }
    return finished.get(file);
  };
  const is_ours = file => by_file.has(file) || reference.by_file.has(file) || file.endsWith('_source.html');
  const documents = [];
  const names = new Set(['.dark-mode', '.light-mode']);
  for (const file of reachable(is_ours, [...by_file.keys()], name => finish(name).html)) {
    const {html, headings, title} = finish(file);
    const page = by_file.get(file) ?? (reference.by_file.has(file) ? {file, under: 'reference.html', title, name: title, is_brought: reference.by_file.get(file).is_brought, header: reference.by_file.get(file)} : source_page(file, title));
    const leads = page.leads && !page.is_being_made;
    const more = leads ? directives.makers.unquoted_failures(page.chapter) : '';
    const whole =
      html +
      (more && `<h2 id="failed_checks">What failed and no page quotes</h2>${more}`) +
      (leads ? directives.makers.verdict(page.chapter) : '');
    if (!file.endsWith('_source.html'))
      documents.push(
        ...(reference.by_file.has(file) ? with_symbols : same => same)(sections(page, whole)).map(section => ({
          ...section,
          weight: weight_of(page, section),
          is_being_made: page.is_being_made,
        })),
      );
    const typeset_headings = headings.map(heading => ({...heading, html: formulas.in_page(heading.html, page)}));
    const head = by_file.has(file) && !page.is_being_made ? preview(page, whole, settings, folder) : '';
    const laid_out = layout(page, {html: formulas.in_page(whole, page), headings: typeset_headings, head}, pages, settings.book);
    names_in(laid_out, names);
    writeFileSync(join(folder, file), with_quotes(laid_out));
  }
  writeFileSync(join(folder, 'search_index.js'), search_script(settings.source, documents));
  writeFileSync(
    join(folder, 'reading_order.json'),
    JSON.stringify(pages.all.map(({file, title, id, further}) => ({file, title, id, further}))),
  );
  return names;
}

/** The style, the scripts and the fonts; `names` are the classes and ids that the pages have. */
function copy_theme(folder, names, live_scripts) {
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
  const awesome = readFileSync(join(settings.awesome, 'doxygen-awesome.css'), 'utf8');
  writeFileSync(join(folder, 'doxygen.css'), pruned(style.replace(/^.*url\(.*$\n/gm, ''), names) + pruned(awesome, names));
  write_fonts(settings, folder, names);
}

/** The course itself, as it stands in git, for whoever finds the book alone. */
function pack_source(folder) {
  if (settings.colophon.commit.startsWith('none')) return;
  execFileSync('git', ['archive', '--format=zip', '--prefix=tumble/', '-o', join(folder, 'tumble.zip'), 'HEAD'], {cwd: settings.source});
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
  const pages = read_pages(settings.source, settings.floors, settings.tools);
  for (const page of pages.chapters) page.is_being_made = made !== undefined && !made.has(page.chapter);
  const results = new Results(settings.results, settings.tools, settings.unmeasured);
  const exercises = read_exercises(settings);
  for (const page of pages.chapters) {
    if (page.further) continue;
    page.exercises = exercises.filter(({chapter}) => chapter === page.chapter).map(({name}) => name);
    page.lines.push(...lines_of_section(page, exercises, pages));
  }
  for (const page of pages.all) page.lines = with_tasks(page.lines, exercises, pages);
  const directives = new Directives(settings, results, pages, exercises);
  expand_pages(pages, directives);
  const written = run_doxygen(settings, pages.all, {with_gaps: made !== undefined});

  const fresh = `${settings.folder}.new`;
  rmSync(fresh, {recursive: true, force: true});
  mkdirSync(join(fresh, 'previews'), {recursive: true});
  copy_theme(fresh, write_pages(fresh, pages, written, directives), directives.makers.live_scripts);
  pack_source(fresh);
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
