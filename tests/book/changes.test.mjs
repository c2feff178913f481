// Nothing in the book is pasted: change the code, build, and the page has changed with it; and a check that fails is seen.
// TUMBLE_TINY is the folder of the tiny book, which make_tiny_book.cmake has built; TUMBLE_CMAKE is cmake.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

const folder = process.env.TUMBLE_TINY;
const header = join(folder, 'chapters/01_tiny/tumble/tiny.hpp');
const red = join(folder, 'build/book_work/red.txt');
const sound = readFileSync(header, 'utf8');

function make_book_with(length) {
  writeFileSync(header, sound.replace('return 1.25;', `return ${length};`));
  const {status, stdout} = spawnSync(process.env.TUMBLE_CMAKE, ['--build', join(folder, 'build'), '--target', 'book'],
    {encoding: 'utf8', timeout: 120_000});
  return {status, said: stdout, page: readFileSync(join(folder, 'book_made/chapter_01_tiny.html'), 'utf8')};
}

const part = (page, pattern) => pattern.exec(page)?.[0];
const drawing = page => part(page, /<svg role="img"[^]*?<\/svg>/).replace(/aria-label="[^"]*"/, '');

const still = page => part(page, /<svg class="player-still"[^]*?<\/figure>/);

let first;
before(() => { first = make_book_with('1.25'); assert.equal(first.status, 0, first.said); });
after(() => writeFileSync(header, sound));

test('Another number in the code is another number everywhere on the page.', () => {
  const {status, said, page} = make_book_with('1.75');
  assert.equal(status, 0, said);
  assert.ok(!page.includes('1.25'), part(page, /.{60}1\.25.{60}/));
  const places = {
    'the prose': /It is 1\.75&#160;m long/, 'a formula': /L = 1\.75/, 'the code': /return<\/span> 1\.75;/,
    'the output': /The stick is 1\.75 m long\./, 'the table': /<td class="number">1\.75<\/td>/,
    "the figure's description": /aria-label="[^"]*1\.75[^"]*"/, 'the recording': /"cylinder":\[0\.05,1\.75\]/,
  };
  for (const [place, pattern] of Object.entries(places)) assert.match(page, pattern, place);
  assert.notEqual(drawing(page), drawing(first.page), 'the figure is still the old one');
  assert.notEqual(still(page), still(first.page), 'the still picture of the player is the old one');
});

test('What the code no longer holds stops no book: the page shows it failed, and red.txt tells of it.', () => {
  const {status, said, page} = make_book_with('2.25');
  assert.equal(status, 0, said);
  assert.match(said, /2 results in red/);
  assert.match(page, /The stick is 2\.25 m long\./);
  const failures = [...page.matchAll(/class="check failed"[^]*?<b>failed<\/b>/g)];
  assert.equal(failures.length, 2, 'the check and the program');
  assert.match(page, /<b>failed<\/b>; expected, but not so: the stick is hardly longer than two metres/);
  assert.equal(readFileSync(red, 'utf8'), '01_tiny: The stick is shorter than two metres\n' +
    '01_tiny: tiny_demo: expected, but not so: the stick is hardly longer than two metres\n');
});

test('The old code makes the old page again.', () => {
  const {status, said, page} = make_book_with('1.25');
  assert.equal(status, 0, said);
  assert.equal(page, first.page);
  assert.equal(readFileSync(red, 'utf8'), '');
});
