// Nobody waits for the last chapter to read the first: the book can be set so far, and says what is still to come.
// TUMBLE_TINY is the folder of the tiny book, which make_tiny_book.cmake has built.
import assert from 'node:assert/strict';
import {existsSync, readFileSync, renameSync} from 'node:fs';
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {after, test} from 'node:test';

const folder = process.env.TUMBLE_TINY;
const results = join(folder, 'build/results/01_tiny');
const red = join(folder, 'build/book_work/red.txt');

function make_book(...options) {
  return spawnSync(process.execPath,
    [join(folder, 'book/tools/book.mjs'), join(folder, 'build/book_work/settings.json'), ...options],
    {encoding: 'utf8', timeout: 60_000});
}
const page = name => readFileSync(join(folder, 'book_made', `${name}.html`), 'utf8');

after(() => existsSync(`${results}.away`) && renameSync(`${results}.away`, results));

test('A chapter without results says that it is being made, and asks for itself again until it is there.', () => {
  const red_before = readFileSync(red, 'utf8');
  renameSync(results, `${results}.away`);
  const {status, stderr} = make_book('--so-far', '01_another');
  assert.equal(status, 0, stderr);
  assert.match(page('chapter_01_tiny'), /This page is being made/);
  assert.match(page('chapter_01_tiny'), /<meta http-equiv="refresh" content="\d+">/);
  assert.match(page('index'), /<a href="chapter_01_tiny.html"[^>]*>[^<]*<small>being made<\/small>/);
  assert.doesNotMatch(page('index'), /http-equiv="refresh"/);
  assert.equal(readFileSync(red, 'utf8'), red_before, 'what is in red is told of a whole book');
});

test('Without its results the whole book is not made.', () => {
  const {status, stderr} = make_book();
  assert.equal(status, 1);
  assert.match(stderr, /chapter\.md:\d+: no /);
});

test('With them the page takes its place, and asks no more.', () => {
  renameSync(`${results}.away`, results);
  for (const options of [['--so-far', '01_tiny'], []]) {
    const {status, stderr} = make_book(...options);
    assert.equal(status, 0, stderr);
    assert.match(page('chapter_01_tiny'), /The stick is 1\.25 m long\./);
    assert.doesNotMatch(page('chapter_01_tiny') + page('index'), /http-equiv="refresh"|being made/);
  }
});
