// Which pages the tests open: all pages for reading, in their order, and a sample of the reference.
import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {book} from './browser.mjs';

export const reading_pages =
  JSON.parse(readFileSync(join(book, 'reading_order.json'), 'utf8')).map(({file}) => file);

const chapter_pages = reading_pages.filter(name => name.startsWith('chapter_') && name !== 'chapter_map.html');

const others = readdirSync(book).filter(name => name.endsWith('.html') && !reading_pages.includes(name)).sort();
const source_pages = others.filter(name => name.endsWith('_source.html'));
const reference_pages = others.filter(name => !name.endsWith('_source.html'));

/// At most `count` of the names, spread evenly.
const spread = (names, count) => {
  const stride = Math.max(1, names.length / count);
  return names.filter((_, index) => Math.floor(index / stride) !== Math.floor((index - 1) / stride));
};

export const sampled_pages = [...reading_pages, ...spread(reference_pages, 8), ...spread(source_pages, 4)];

export const one_page_of_each_kind =
  [...reading_pages, ...spread(reference_pages, 2), ...spread(source_pages, 1)];

export {chapter_pages};
