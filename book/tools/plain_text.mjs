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
const code = (span, words) => (/tumble::|\n/.test(words) ? span : `\\htmlonly<code>${escape(words)}</code>\\endhtmlonly`);

/** Powers, indices and minus signs of formulas within a sentence. */
const mathematics = text =>
  text
    .replace(/(?<=\S) - (?=\S)/g, ' − ')
    .replace(/(?<![\p{L}\d_])(\p{L})_([\p{L}\d])(?![\p{L}\d_])/gu, '$1<sub>$2</sub>')
    .replace(/\^(?:\(([^()]+)\)|([\p{L}\d]))/gu, (_, bracket, letter) => `<sup>${(bracket ?? letter).replace('-', '−')}</sup>`);

/** What prose needs for Doxygen: a heading becomes a word in bold, since it heads no section of the page. */
const prose = text =>
  mathematics(text)
    .replace(/^#+ +(.*)$/gm, '**$1**')
    .replace(/(^|[\s(])\*(["“].*?["”])\*/g, '$1<em>$2</em>'); // Doxygen leaves stars beside quotation marks

/** A text without what is set off in it, on as many lines as before. */
function running(text) {
  return text
    .split(/(`[^`]+`)/)
    .map((part, index) => (index % 2 ? code(part, part.slice(1, -1)) : prose(part)))
    .join('');
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
  const plain = text.split('\n');
  const starts = n => is_set_off(plain[n]) && (n === 0 || !plain[n - 1].trim());
  const result = [];
  for (let n = 0, end; n < plain.length; n = end) {
    const is_running = !starts(n);
    end = n + 1;
    while (end < plain.length && (is_running ? !starts(end) : is_set_off(plain[end]))) ++end;
    const part = plain.slice(n, end).join('\n');
    const lines = (is_running ? running(part) : part)
      .split('\n')
      .map((words, index) => ({text: words, place: `${file}:${line + n + index}`}));
    result.push(...(is_running ? lines : set_off(lines)));
  }
  return result;
}
