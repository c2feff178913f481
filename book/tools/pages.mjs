// The pages of the book, in the order in which they are read.
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {BookError} from './results.mjs';

/** A Markdown file that begins with "# Title {#address}". `home` is the folder that its directives start from. */
export function read_page(source, path, chapter = undefined) {
  const text = readFileSync(join(source, path), 'utf8');
  const heading = /^# (.+?) \{#(\w+)\}\s*\n/.exec(text);
  if (!heading) throw new BookError(`${path}:1: the first line must be "# Title {#address}"`);
  const page = make_page(path, heading[1], heading[2], text, chapter);
  return {...page, lines: page.lines.flatMap(line => with_sections(source, line))};
}

export function make_page(path, title, id, text, chapter = undefined) {
  const [name, question] = title.split(': ');
  return {path, title, id, text, lines: lines_of(path, text), chapter, name, question, file: id === 'mainpage' ? 'index.html' : `${id}.html`};
}

/** Where a line reads {{section FILE | Heading}}, what stands in that file under that heading. Its links become paths. */
function with_sections(source, line) {
  const [, path, heading] = /^\{\{section (\S+) \| (.+?)\}\}\s*$/.exec(line.text) ?? [];
  if (!path) return line;
  const complain = what => {
    throw new BookError(`${line.place}: ${what}`);
  };
  if (!existsSync(join(source, path))) complain(`there is no file ${path}`);
  const lines = lines_of(path, readFileSync(join(source, path), 'utf8'));
  const first = lines.findIndex(({text}) => text === `## ${heading}`) + 1;
  if (!first) complain(`${path} has no heading "## ${heading}"`);
  const count = lines.slice(first).findIndex(({text}) => text.startsWith('## '));
  return lines
    .slice(first, count < 0 ? undefined : first + count)
    .map(({text, place}) => ({text: text.replace(/\[[^\]]*\]\(([^():]*)\)/g, '`$1`'), place}));
}

const lines_of = (path, text) => text.split('\n').map((line, index) => ({text: line, place: `${path}:${index + 1}`}));

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

const included_in = (source, path) =>
  [...readFileSync(join(source, path), 'utf8').matchAll(/^#include <(tumble\/[\w/]+\.hpp)>/gm)].map(([, name]) => name);

/** The address of a header's group in the list of all headers. */
export const group_of = ({page}) => `headers_of_${page?.id ?? 'all'}`;

/**
 * What a reader's program may include: {path, name, brief, page, is_brought}, `page` being that of the chapter which explains it. Of a folder
 * with many, those are brought along that a header of the same folder includes and no program or example of the course does.
 */
function public_headers(source, floors, chapters) {
  const of_chapter = name => chapters.find(page => page.chapter === name && !page.further);
  const folders = floors.map(({folder, name}) => ({below: join(folder, 'tumble'), inside: 'tumble', page: of_chapter(name)}));
  const scenes = chapters.find(page => page.chapter === 'scene_reader'),
    hard = chapters.find(page => page.id === 'chapter_13_accuracy');
  folders.push(
    {below: 'tools/scene_reader/tumble/scene', inside: 'tumble/scene', page: scenes, only: /^(scene|read_scene|read_scene_file|read_scene_text|scene_error|solid|keys)\.hpp$/},
    {below: 'exact/tumble/exact', inside: 'tumble/exact', page: hard},
  );
  const programs = floors.flatMap(({folder}) =>
    readdirSync(join(source, folder), {recursive: true}).filter(file => /(?<!_checks)\.cpp$|examples_checks\.cpp$/.test(file)).map(file => join(folder, file)));
  const by_programs = new Set(programs.flatMap(path => included_in(source, path)));
  return folders.flatMap(({below, inside, page, only = /\.hpp$/}) => {
    const files = (existsSync(join(source, below)) ? readdirSync(join(source, below)) : []).filter(file => only.test(file) && file.endsWith('.hpp')).sort();
    const by_each_other = new Set(files.flatMap(file => included_in(source, join(below, file))));
    return files.map(file => {
      const path = join(below, file),
        name = `${inside}/${file}`;
      const is_brought = files.length > 12 && by_each_other.has(name) && !by_programs.has(name);
      return {path, name, brief: brief(source, path), page, is_brought};
    });
  });
}

/** {front, chapters, back, teaching, all}: floors are {name, folder}, from the ground up; tools also have the chapter that their pages follow.
 * The chapters' pages come in the order in which the front page lists them. */
export function read_pages(source, floors, tools) {
  const front = ['index', 'how_to_read', 'conventions', 'chapter_map', 'for_lecturers'].map(name =>
    read_page(source, `book/pages/${name}.md`),
  );
  const chapters = [];
  for (const {name, folder} of floors) {
    if (!existsSync(join(source, folder, 'chapter.md'))) continue;
    // A big chapter has further pages, which follow its first one.
    const further = readdirSync(join(source, folder))
      .filter(file => file.endsWith('.md') && file !== 'chapter.md')
      .sort();
    for (const file of ['chapter.md', ...further]) {
      const page = read_page(source, join(folder, file), name);
      if (file === 'chapter.md' && page.id !== `chapter_${name}`)
        throw new BookError(`${page.path}:1: the address is {#${page.id}}; it must be {#chapter_${name}}`);
      chapters.push({...page, further: file !== 'chapter.md', leads: file === 'chapter.md'});
    }
    for (const tool of tools.filter(({chapter}) => chapter === name))
      for (const [index, file] of readdirSync(join(source, tool.folder)).filter(file => file.endsWith('.md')).sort().entries())
        chapters.push({...read_page(source, join(tool.folder, file), tool.name), further: true, leads: index === 0});
  }
  const listed = [...front[0].lines.map(({text}) => text).join('\n').matchAll(/\\subpage (\w+)/g)].map(([, id]) => id);
  chapters.sort((one, other) => listed.indexOf(one.id) - listed.indexOf(other.id));
  const headers = public_headers(source, floors, chapters);
  const back = ['exercises', 'cheat_sheet', 'scene_keys', 'reference', 'names', 'colophon'].map(name =>
    read_page(source, `book/pages/${name}.md`),
  );
  // A student's copy of the course has no notes for instructors.
  const notes = 'exercises/instructor.md';
  const teaching = existsSync(join(source, notes)) ? [read_page(source, notes)] : [];
  const all = [...front, ...chapters, ...back, ...teaching];
  for (const page of all)
    if (all.find(other => other.id === page.id) !== page)
      throw new BookError(`${page.path}:1: the address {#${page.id}} is taken by another page`);
  return {front, chapters, back, teaching, all, headers};
}
