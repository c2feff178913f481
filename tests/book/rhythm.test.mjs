// The rhythm of the pages, from their sources: how soon something moves, how far apart pictures are, how much code stands open.
import assert from 'node:assert/strict';
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {test} from 'node:test';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url)), root = join(here, '../..');
const limits = {
  words_before_touch: 400, words_without_picture: 700, long_listings: 1, lines_of_a_listing: 30, lines_between_pictures: 60, words: 3000,
  long_sentences_percent: 2, bracketed_sentences: 0, values_in_paragraph: 3,
};

const count_words = text => text.split(/\s+/).filter(word => /[\p{L}\p{N}]/u.test(word)).length;
/** Prose as it is counted: a formula or a value is one word, a link its words. */
const counted = text => text.replace(/\\f\$.*?\\f\$|\\f\[[\s\S]*?\\f\]|\{\{value [^{}]*\}\}/g, ' 1 ').replace(/\{\{set [^|{}]*\|([^{}]*)\}\}/g, '$1')
  .replace(/\]\([^)]*\)|\\(?:ref|subpage) \w+/g, ' ').replace(/^\s*(?:-|\d+\.) /gm, '').replace(/[*`[\]]/g, '');

/** Lines of code between the marks of a snippet, or of a block of code. */
function lines_of_snippet(folder, file, mark) {
  const path = join(folder, file), found = existsSync(path) ? path : join(root, file);
  const text = readFileSync(found, 'utf8').split(`//! [${mark}]`)[1] ?? '';
  return text.split('\n').filter(line => line.trim()).length;
}

/** What is measured of one page. */
function measured(path) {
  const folder = join(root, dirname(path)), lines = readFileSync(join(root, path), 'utf8').split('\n').slice(1);
  // A directive on a line of its own is a block, whatever stands in the next line.
  const blocks = lines.join('\n').split(/\n\s*\n|\n(?=\{\{(?!value|set)\w)|(?<=^\{\{(?!value|set)\w[^\n]*\}\})\n/m);
  const most = Object.fromEntries(Object.keys(limits).map(name => [name, 0]));
  const raise = (name, value) => { most[name] = Math.max(most[name], value); };
  let words = 0, since_picture = 0, code = 0, long = 0, folds = [], is_turn = false, is_touched = false, sentences = 0, long_sentences = 0;
  const picture = () => { since_picture = code = long = 0; };
  for (const block of blocks.map(text => text.trim()).filter(Boolean)) {
    if (/^## Your turn/.test(block)) is_turn = true;
    const [, name, argument = ''] = /^\{\{(\w+)\s*([\s\S]*?)\}\}$/.exec(block) ?? [];
    if (['fold', 'gate', 'note', 'measured'].includes(name)) folds.push(name);
    else if (name === 'end') folds.pop();
    const is_folded = folds.includes('fold');
    if (['figure', 'live', 'player', 'players'].includes(name)) {
      if (name !== 'figure' && !is_touched) { most.words_before_touch = words; is_touched = true; }
      picture();
    }
    const open = name === 'snippet' ? lines_of_snippet(folder, ...argument.split(/\s+/)) : /^    \S/.test(block) ? block.split('\n').length : 0;
    if (open && !is_folded && !is_turn) {
      raise('lines_of_a_listing', open);
      raise('lines_between_pictures', code += open);
      if (open > 15) raise('long_listings', ++long);
    }
    if (name || open || /^(#|\||<)/.test(block) || folds.includes('note')) continue;
    const prose = counted(block), number = count_words(prose);
    words += number;
    if (!is_folded && !is_turn) raise('words_without_picture', since_picture += number);
    raise('values_in_paragraph', (block.match(/\{\{value /g) ?? []).length);
    most.bracketed_sentences += (block.match(/(?:^|[.!?:] )\([A-Z][^()]*[.!?]\)/g) ?? []).length;
    for (const sentence of prose.split(/(?<=[.!?:;])\s+(?=[\p{Lu}"*\d])/u)) {
      ++sentences;
      if (count_words(sentence) > 35) ++long_sentences;
    }
  }
  if (!is_touched) most.words_before_touch = words;
  most.words = words;
  most.long_sentences_percent = sentences ? Math.round((100 * long_sentences) / sentences) : 0;
  return most;
}

const pages = ['chapters', 'tools'].flatMap(area => readdirSync(join(root, area)).flatMap(name => {
  const folder = join(area, name);
  return existsSync(join(root, folder, 'CMakeLists.txt')) ? readdirSync(join(root, folder)).filter(file => file.endsWith('.md')).map(file => join(folder, file)) : [];
}));

for (const path of pages)
  test(`${path} keeps the rhythm.`, () => {
    const over = Object.entries(measured(path)).filter(([name, value]) =>
      value > limits[name] && (name !== 'words_before_touch' || path.endsWith('chapter.md')));
    assert.deepEqual(over, [], `more than ${JSON.stringify(limits)}`);
  });
