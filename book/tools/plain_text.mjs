// The exercises' texts are written to be read in a terminal. Here they become lines of the book's Markdown, with what is set off
// in them set as code or as formulas.
import {formula_of_plain_text} from './plain_formula.mjs';
import {escape} from './text.mjs';

const is_code = line => /[;{}]|::|\/\/|^\s*(\.\/course|\$)/.test(line);
const is_set_off = line => /^ {4,}\S/.test(line);

/**
 * Code in a sentence. Doxygen would make a link of each word that it knows from the library; here `hammer.hpp` is the reader's own file
 * and `r.norm()` is no quaternion's, so that only what says whose it is becomes a link.
 */
const code = (span, words) => (words.includes('tumble::') ? span : `\\htmlonly<code>${escape(words)}</code>\\endhtmlonly`);

/** What a line of prose needs for Doxygen: a heading becomes a word in bold, since it heads no section of the page. */
function prose(line) {
  return line
    .replace(/`([^`]+)`/g, code)
    .replace(/^#+ +(.*)$/, '**$1**')
    .replace(/(^|[\s(])\*(["“].*?["”])\*/g, '$1<em>$2</em>'); // Doxygen leaves stars beside quotation marks
}

function set_off(lines) {
  const bare = lines.map(({text}) => text.trim());
  if (bare.every(line => line.startsWith('./course'))) return lines;
  if (bare.some(is_code)) {
    const code = lines.map(({text, place}) => ({text: text.slice(4), place}));
    return [{text: '```{.cpp}', place: lines[0].place}, ...code, {text: '```', place: lines.at(-1).place}];
  }
  return [{html: formula_of_plain_text(bare), place: lines[0].place}];
}

/** {text, file, line} as the lines of a page. */
export function lines_of_plain_text({text, file, line}) {
  const lines = text.split('\n').map((words, index) => ({text: words, place: `${file}:${line + index}`}));
  const result = [];
  for (let n = 0; n < lines.length; ) {
    const starts = is_set_off(lines[n].text) && (n === 0 || !lines[n - 1].text.trim());
    if (!starts) {
      result.push({...lines[n], text: prose(lines[n].text)});
      ++n;
      continue;
    }
    let end = n;
    while (end < lines.length && is_set_off(lines[end].text)) ++end;
    result.push(...set_off(lines.slice(n, end)));
    n = end;
  }
  return result;
}
