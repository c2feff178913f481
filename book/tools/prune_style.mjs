// Style sheets of others, cut down to what the book's pages can use: they are made for every page that Doxygen writes.

/** The classes and ids of a page. */
export function names_in(html, names) {
  for (const [, kind, words] of html.matchAll(/ (class|id)="([^"]*)"/g))
    for (const word of words.split(/\s+/)) if (word) names.add((kind === 'id' ? '#' : '.') + word);
}

/** What stands between braces that match, from `start` on: [the text, the place behind it]. */
function block_at(css, start) {
  let depth = 1,
    end = start;
  while (depth && end < css.length) {
    if (css[end] === '{') ++depth;
    if (css[end] === '}') --depth;
    ++end;
  }
  return [css.slice(start, end - 1), end];
}

/** A selector can match if the book has every class and id in it; what is in :not() need not be there. */
const can_match = (selector, names) =>
  (selector.replace(/:not\([^)]*\)/g, '').replace(/\[[^\]]*\]/g, '').match(/[.#][\w-]+/g) ?? []).every(name => names.has(name));

export function pruned(style, names) {
  const css = style.replace(/\/\*[\s\S]*?\*\//g, '');
  let kept = '';
  for (let start = 0; ; ) {
    const brace = css.indexOf('{', start);
    if (brace < 0) return kept;
    const head = css.slice(start, brace).replace(/^[^;]*;/, all => (/@/.test(all) ? '' : all)).trim();
    const [body, end] = block_at(css, brace + 1);
    start = end;
    if (/^@(media|supports)/.test(head)) {
      const inner = pruned(body, names);
      if (inner) kept += `${head}{${inner}}\n`;
    } else if (head === '@font-face') {
      kept += `${head}{${body.trim()}}\n`;
    } else if (!head.startsWith('@')) {
      const selectors = head.split(/,(?![^(]*\))/).map(selector => selector.trim());
      const matching = selectors.filter(selector => can_match(selector, names));
      if (matching.length && body.trim()) kept += `${matching.join(',')}{${body.replace(/\s+/g, ' ').trim()}}\n`;
    }
  }
}
