// What the search looks through, gathered while the book is built: the sections with their words, the terms that each defines, and
// the words under which readers look for what the book calls otherwise. A script tag loads it, since a page opened from a file may
// not fetch.
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {BookError} from './results.mjs';
import {plain} from './text.mjs';
import {without_formulas} from './formulas.mjs';

const silent = [
  /<pre[\s\S]*?<\/pre>/g,
  /<div class="fragment">[\s\S]*?<\/div><!-- fragment -->/g,
  /<svg[\s\S]*?<\/svg>/g,
  /<figcaption>[\s\S]*?<\/figcaption>/g,
  /<a class="anchorlink"[\s\S]*?<\/a>/g,
  /<span class="verdict">[\s\S]*?<\/span>/g,
  /<span class="mark"[\s\S]*?<\/span>/g,
  /<td[^>]*>[^<>\p{L}]*<\/td>/gu, // a number in a table
];

const checks = /<details class="fold others"[\s\S]*?<\/details>|<div class="check [\s\S]*?<\/div><\/div>/g;

/** Takes out elements of the class `unindexed`, with all that they hold. */
function without_unindexed(html) {
  for (;;) {
    const start = /<(\w+)\b[^>]*\bclass="[^"]*\bunindexed\b[^"]*"[^>]*>/.exec(html);
    if (!start) return html;
    const tags = new RegExp(`<(/?)${start[1]}\\b[^>]*>`, 'g');
    tags.lastIndex = start.index;
    let depth = 0,
      end = html.length;
    for (let tag = tags.exec(html); tag; tag = tags.exec(html)) {
      depth += tag[1] ? -1 : 1;
      if (depth === 0) {
        end = tags.lastIndex;
        break;
      }
    }
    html = html.slice(0, start.index) + html.slice(end);
  }
}

const words = html => plain(without_formulas(silent.reduce((text, pattern) => text.replace(pattern, ' '), html)));

/** Terms that a section sets apart where it explains them: a few words in bold, or in italics. */
function terms_in(html) {
  const found = [...html.matchAll(/<(b|strong|em)>([\s\S]*?)<\/\1>/g)].map(([, , inner]) => words(inner).replace(/[.,:;]$/, ''));
  return [...new Set(found.filter(term => term && !/^\d+$/.test(term) && term.split(' ').length <= 4))];
}

/** Rows of tables that have an address, each called by its first cell: a field, or a task. */
const rows_in = html =>
  [...html.matchAll(/<tr\b[^>]*?(?: id="([\w-]+)")?>\s*<td[^>]*>(?:<a class="anchor" id="(\w+)"><\/a>)?([\s\S]*?)<\/td>([\s\S]*?)<\/tr>/g)]
    .flatMap(([, row, anchor, first, others]) => ((row ?? anchor) && !first.includes('"declaration"') ? [{id: row ?? anchor, called: words(first), text: words(`${first} ${others}`)}] : []));

/** The sections of a page: what stands before the first heading, then one for each heading, its rows, and its checks for themselves. */
export function sections(page, html) {
  const parts = without_unindexed(html).split(/<h[2-4] id="([^"]*)">([\s\S]*?)<\/h[2-4]>/);
  const section = (address, heading, body) => ({
    address,
    page: page.name,
    section: heading,
    terms: terms_in(silent.reduce((text, pattern) => text.replace(pattern, ' '), body)),
    text: words(body),
  });
  const found = [section(page.file, '', parts[0])];
  for (let n = 1; n < parts.length; n += 3) {
    const address = `${page.file}#${parts[n]}`, heading = words(parts[n + 1]);
    found.push(section(address, heading, parts[n + 2].replace(checks, ' ')));
    for (const {id, called, text} of rows_in(parts[n + 2]))
      found.push({address: `${page.file}#${id}`, page: page.name, section: called, terms: [], text, is_row: true});
    const more = parts[n + 2].match(checks)?.join(' ');
    if (more) found.push({...section(address, 'Checks', more), are_checks: true});
  }
  return found.filter(({text, section: heading}) => text || heading);
}

const words_file = 'book/pages/search_words.json';

/** The script that a page loads when a reader begins to search. */
export function search_script(source, documents) {
  const {same, places} = JSON.parse(readFileSync(join(source, words_file), 'utf8'));
  for (const [address, ...asked] of places) {
    const document = documents.find(each => each.address === address);
    // A book that is being made lacks sections; a whole one must have them all.
    if (document) document.asked = [...(document.asked ?? []), ...asked];
    else if (!documents.some(each => each.is_being_made && each.address === address.replace(/#.*/, '')))
      throw new BookError(`${words_file}: there is no place ${address}`);
  }
  const shown = documents.map(({is_being_made, ...document}) => document);
  return `window.bookIndex = ${JSON.stringify({same, documents: shown})};\n`;
}
