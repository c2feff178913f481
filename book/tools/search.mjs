// The index of the search, made while the book is built. lunr finds sections by their words; a script tag loads the index,
// since a page opened from a file may not fetch.
import {createRequire} from 'node:module';
import {join} from 'node:path';
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
];

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

/** The sections of a page: what stands before the first heading, then one for each heading. */
export function sections(page, html) {
  const parts = without_unindexed(html).split(/<h[2-4] id="([^"]*)">([\s\S]*?)<\/h[2-4]>/);
  const found = [{address: page.file, page: page.name, section: '', text: words(parts[0])}];
  for (let n = 1; n < parts.length; n += 3)
    found.push({
      address: `${page.file}#${parts[n]}`,
      page: page.name,
      section: words(parts[n + 1]),
      text: words(parts[n + 2]),
    });
  return found.filter(section => section.text || section.section);
}

/** The script that a page loads when a reader begins to search. */
export function search_script(folder, documents) {
  const lunr = createRequire(import.meta.url)(join(folder, 'lunr.js'));
  const index = lunr(function () {
    this.ref('number');
    this.field('page', {boost: 4});
    this.field('section', {boost: 6});
    this.field('text');
    documents.forEach((document, number) => this.add({...document, number}, {boost: document.weight}));
  });
  const shown = documents.map(({address, page, section, text}) => ({address, page, section, text}));
  return `window.bookIndex = ${JSON.stringify({index, documents: shown})};\n`;
}
