// Formulas, typeset by KaTeX while the book is built, so that a page needs no script for them.
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {BookError} from './results.mjs';
import {unescape} from './text.mjs';

export class Formulas {
  #cache = new Map();

  constructor(folder) {
    this.katex = createRequire(import.meta.url)(join(folder, 'katex.js'));
  }

  #typeset(tex, displayMode, page) {
    const key = `${displayMode} ${tex}`;
    if (!this.#cache.has(key)) {
      try {
        this.#cache.set(
          key,
          // A wide gap stands between formulas, so one that is too wide for a phone may go on in another line there.
          this.katex.renderToString(displayMode ? tex.replace(/\\q?quad(?![a-zA-Z])/g, '$&\\allowbreak ') : tex, {displayMode, throwOnError: true, strict: 'error', output: 'htmlAndMathml'}).replaceAll('\\allowbreak ', ''),
        );
      } catch (error) {
        throw new BookError(`${place_of(tex, page)}: the formula ${tex.trim()} cannot be typeset: ${error.message}`);
      }
    }
    return this.#cache.get(key);
  }

  /** Typesets \( \) and \[ \] everywhere but in code. */
  in_page(html, page) {
    return html
      .split(
        /(<pre[\s\S]*?<\/pre>|<code[\s\S]*?<\/code>|<div class="fragment">[\s\S]*?<!-- fragment -->|<svg[\s\S]*?<\/svg>)/,
      )
      .map((part, index) =>
        index % 2
          ? part
          : part
              .replace(
                /<p class="formulaDsp">\s*\\\[([\s\S]*?)\\\]\s*<\/p>/g,
                (_, tex) => `<div class="formula scroll">${this.#typeset(unescape(tex), true, page)}</div>`,
              )
              .replace(
                /\\\[([\s\S]*?)\\\]/g,
                (_, tex) => `<span class="formula scroll">${this.#typeset(unescape(tex), true, page)}</span>`,
              )
              // A comma or full stop goes into the formula, or it could begin the next line.
              .replace(/\\\(([\s\S]*?)\\\)([,.;:]?)/g, (_, tex, mark) => {
                const set = this.#typeset(unescape(tex) + (mark && `\\text{${mark}}`), false, page);
                return is_short(unescape(tex)) ? set.replace(/(?<=class="katex)(?=")/, ' whole') : set;
              }),
      )
      .join('');
  }
}

/** A formula of a few letters, which no line should part. */
const is_short = tex => tex.replace(/\\[a-zA-Z]+/g, 'x').replace(/[{}^_\s]/g, '').length <= 9;

/** "path:line" of a formula; the reference has the name of its page alone. */
function place_of(tex, {path, file, lines, expanded}) {
  const first_line = tex.trim().split('\n')[0];
  const line = expanded?.split('\n').findIndex(text => text.includes(first_line)) ?? -1;
  return line < 0 ? (path ?? file) : lines[line].place;
}

/** A page's text for the search, where a formula says little. */
export function without_formulas(html) {
  return html
    .replace(/\\\(([\s\S]*?)\\\)/g, (_, tex) => (/^[\w =+]+$/.test(tex.trim()) ? tex.trim() : '…'))
    .replace(/\\\[[\s\S]*?\\\]/g, '…');
}
