// Quotation marks and apostrophes as they are printed: “so”, ‘so’ and don’t. Code, formulas and drawings keep theirs.

const straight = /&quot;|&#39;|["']/g;
const kept = /^(code|pre|script|style|svg|textarea)$/;
const inline = /^(a|b|i|em|strong|span|small|sub|sup|abbr|kbd|cite|label)$/;

/** HTML with its quotation marks set. */
export function with_quotes(html) {
  let inside, depth = 0; // the element that keeps its own, and how many of its name are open in it
  let before = ' ';
  const set = text => text.replace(straight, (mark, place) => {
    const last = place ? text[place - 1] : before;
    const opens = /[\s([{—–\u00a0“‘]/.test(last);
    return /["q]/.test(mark) ? (opens ? '“' : '”') : opens ? '‘' : '’';
  });
  return html.replace(/<!--[\s\S]*?-->|<(\/?)([a-zA-Z][\w-]*)((?:"[^"]*"|'[^']*'|[^'">])*)>|[^<]+/g, (all, closes, name, attributes) => {
    if (all.startsWith('<!--')) return all;
    if (name === undefined) {
      if (inside === undefined && all) {
        const text = set(all);
        before = text.at(-1);
        return text;
      }
      return all;
    }
    if (inside !== undefined) {
      if (name === inside && !/\/$/.test(attributes)) depth += closes ? -1 : 1;
      if (depth === 0) [inside, before] = [undefined, 'x'];
    } else if (!closes && (kept.test(name) || /class="(?:[^"]* )?(?:katex|fragment|line)\b/.test(attributes))) {
      [inside, depth] = [name, 1];
    } else if (!inline.test(name)) {
      before = ' ';
    }
    return all;
  });
}
