// The pages of the book, in the order in which they are read.
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {BookError} from './results.mjs';

/** A Markdown file that begins with "# Title {#address}". `home` is the folder that its directives start from. */
export function read_page(source, path, chapter = undefined) {
  const text = readFileSync(join(source, path), 'utf8');
  const heading = /^# (.+?) \{#(\w+)\}\s*\n/.exec(text);
  if (!heading) throw new BookError(`${path}:1: the first line must be "# Title {#address}"`);
  return make_page(path, heading[1], heading[2], text, chapter);
}

export function make_page(path, title, id, text, chapter = undefined) {
  const [name, question] = title.split(': ');
  return {path, title, id, text, chapter, name, question, file: id === 'mainpage' ? 'index.html' : `${id}.html`};
}

/** What a header says of itself after @file. */
function brief(source, path) {
  const match = /\/\/\/ @file\n((?:\/\/\/ .*\n)+)/.exec(readFileSync(join(source, path), 'utf8'));
  return match
    ? match[1]
        .replace(/^\/\/\/ /gm, '')
        .replace(/\n/g, ' ')
        .trim()
    : '';
}

function reference_page(source, floors, titles) {
  const lines = [
    '# Reference {#reference}',
    '',
    'What the library offers, header by header, in the order of the chapters that explain it. Everything lies in the ' +
      'namespace \\ref tumble "tumble".',
    '',
  ];
  const headers = [];
  for (const {folder, name} of floors) {
    const below = join(folder, 'tumble');
    if (!existsSync(join(source, below))) continue;
    lines.push(`## ${titles.get(name) ?? (name === 'common' ? 'What every chapter uses' : name)}`, '');
    for (const header of readdirSync(join(source, below))
      .filter(file => file.endsWith('.hpp'))
      .sort()) {
      const path = join(below, header);
      headers.push({path, name: `tumble/${header}`});
      lines.push(`- \\ref ${path} "tumble/${header}": ${brief(source, path)}`);
    }
    lines.push('');
  }
  return {page: make_page('(made by the book) reference', 'Reference', 'reference', lines.join('\n')), headers};
}

/** {front, chapters, back, all}: floors are {name, folder}, from the ground up. */
export function read_pages(source, floors) {
  const front = ['index', 'how_to_read', 'conventions', 'chapter_map'].map(name =>
    read_page(source, `book/pages/${name}.md`),
  );
  const chapters = [];
  for (const {name, folder} of floors) {
    if (!existsSync(join(source, folder, 'chapter.md'))) continue;
    // A big chapter has further pages; they follow its first one in the order of their names.
    const further = readdirSync(join(source, folder))
      .filter(file => file.endsWith('.md') && file !== 'chapter.md')
      .sort();
    for (const file of ['chapter.md', ...further]) {
      const page = read_page(source, join(folder, file), name);
      if (file === 'chapter.md' && page.id !== `chapter_${name}`)
        throw new BookError(`${page.path}:1: the address is {#${page.id}}; it must be {#chapter_${name}}`);
      chapters.push({...page, further: file !== 'chapter.md'});
    }
  }
  const titles = new Map(chapters.filter(page => !page.further).map(page => [page.chapter, page.title]));
  const {page: reference, headers} = reference_page(source, floors, titles);
  const back = [reference, read_page(source, 'book/pages/colophon.md')];
  const all = [...front, ...chapters, ...back];
  for (const page of all)
    if (all.find(other => other.id === page.id) !== page)
      throw new BookError(`${page.path}:1: the address {#${page.id}} is taken by another page`);
  return {front, chapters, back, all, headers};
}
