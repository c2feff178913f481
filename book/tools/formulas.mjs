// Formulas, typeset by KaTeX while the book is built, so that a page needs no script for them.
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { BookError } from './results.mjs';
import { unescape } from './text.mjs';

export class Formulas {
  #cache = new Map();

  constructor(folder) {
    this.katex = createRequire(import.meta.url)(join(folder, 'katex.js'));
  }

  #typeset(tex, displayMode, where) {
    const key = `${displayMode} ${tex}`;
    if (!this.#cache.has(key)) {
      try {
        this.#cache.set(key, this.katex.renderToString(tex, { displayMode, throwOnError: true, strict: 'error', output: 'htmlAndMathml' }));
      } catch (error) {
        throw new BookError(`${where}: the formula ${tex.trim()} cannot be typeset: ${error.message}`);
      }
    }
    return this.#cache.get(key);
  }

  /** Typesets \( \) and \[ \] everywhere but in code. */
  inPage(html, where) {
    return html.split(/(<pre[\s\S]*?<\/pre>|<code[\s\S]*?<\/code>|<div class="fragment">[\s\S]*?<!-- fragment -->|<svg[\s\S]*?<\/svg>)/)
      .map((part, index) => (index % 2 ? part : part
        .replace(/<p class="formulaDsp">\s*\\\[([\s\S]*?)\\\]\s*<\/p>/g,
          (_, tex) => `<div class="formula scroll">${this.#typeset(unescape(tex), true, where)}</div>`)
        .replace(/\\\[([\s\S]*?)\\\]/g, (_, tex) => `<span class="formula scroll">${this.#typeset(unescape(tex), true, where)}</span>`)
        .replace(/\\\(([\s\S]*?)\\\)/g, (_, tex) => this.#typeset(unescape(tex), false, where))))
      .join('');
  }
}

/** A page's text for the search, where a formula says little. */
export function withoutFormulas(html) {
  return html.replace(/\\\(([\s\S]*?)\\\)/g, (_, tex) => (/^[\w =+]+$/.test(tex.trim()) ? tex.trim() : '…')).replace(/\\\[[\s\S]*?\\\]/g, '…');
}
