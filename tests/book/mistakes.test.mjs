// An author's mistake breaks the build of the book, with a message that names the file, the line and what was wrong.
// TUMBLE_TINY is the folder of the tiny book, which make_tiny_book.cmake has built.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {after, test} from 'node:test';

const folder = process.env.TUMBLE_TINY;
const chapter = 'chapters/01_tiny/chapter.md';
const sound = readFileSync(join(folder, chapter), 'utf8');
after(() => writeFileSync(join(folder, chapter), sound));

function make_book(text) {
  writeFileSync(join(folder, chapter), text);
  return spawnSync(process.execPath, [join(folder, 'book/tools/book.mjs'), join(folder, 'build/book_work/settings.json')],
    {encoding: 'utf8', timeout: 60_000});
}

test('The chapter without a mistake is made, and holds what its directives stand for.', () => {
  const {status, stderr} = make_book(sound);
  assert.equal(status, 0, stderr);
  const page = readFileSync(join(folder, 'book_made/chapter_01_tiny.html'), 'utf8');
  for (const expected of ['The stick is 1.25 m long.', 'stick_length', '<b>passed</b>', 'rises from zero to 1.25',
    'The other 2 checks of this chapter: <span class="verdict"><b>all passed</b>', 'class="verdict-of-all">✓ 3 checks of this chapter: <b>all passed</b>',
    '<summary>Why so short?</summary>', 'The line ends at the stick',
    'data-gate="rising"><p class="on-paper guess">', '<li>How far does it rise? <b>By a metre.</b></li>', '<script src="predict.js" defer>',
    'The stick rises</p><svg class="player-still"', '"cylinder":[0.05,1.25]', 'A stick of 1.25', '<script src="player.js" defer>']) {
    assert.ok(page.includes(expected), expected);
  }
});

const mistakes = [
  ['a check that is not there', '{{check The stick is longer than two metres}}', /0 checks .*"The stick is longer than two metres"/],
  ['a check name that two cases have', '{{check The stick has a length}}', /2 checks .*"The stick has a length"/],
  ['an unknown value', 'It is {{value tiny_demo.width}} wide.', /no value "width".*length/],
  ['a value of an unknown program', 'It is {{value big_demo.length}} long.', /no .*"big_demo".*tiny_demo/],
  ['an unknown figure', '{{figure circle | A circle with a radius of two metres.}}', /no figure "circle".*line/],
  ['a figure without alternative text', '{{figure line}}', /should read \{\{figure name \| what it shows/],
  ['an unknown live figure', '{{live circle | A circle that can be made larger.}}', /no live figure "circle"/],
  ['a live figure without alternative text', '{{live circle}}', /should read \{\{live name \| what it shows/],
  ['a prediction without an answer', '{{predict circle | How large? | large; small}}', /should read \{\{predict name \| question \| choice/],
  ['a prediction without a gate', '{{predict circle | How large? | large; small | Large.}}', /prediction "circle" has no gate/],
  ['a gate without a prediction', '{{gate circle}}\nIt is large.\n{{end}}', /no prediction "circle" stands before it on this page/],
  ['a gate before its prediction', '{{gate rising}}\nIt is large.\n{{end}}', /no prediction "rising" stands before it on this page/],
  ['a gate that does not end', '{{fold More}}\n{{predict circle | How large? | large; small | Large.}}\n{{end}}\n{{gate circle}}', /\{\{gate circle\}\} has no \{\{end\}\}/, 6],
  ['a link that sets nothing', 'Make it {{set circle | larger}}.', /should read \{\{set figure knob=value&other=value \| words/],
  ['an unknown recording', '{{player circle | A circle rolls along the ground.}}', /no recording "circle".*stick/],
  ['a player without alternative text', '{{player stick}}', /should read \{\{player recording \| what it shows/],
  ['one player where two are announced', '{{players stick | A stick rises by a metre.}}', /should read \{\{players one recording, the other \|/],
  ['two recordings in one player', '{{player stick, stick | A stick rises by a metre.}}', /should read \{\{player recording \|/],
  ['an unknown table', '{{table circle}}', /no table "circle".*line/],
  ['a part that a program did not print', '{{output tiny_demo 9}}', /\{\{output tiny_demo 9\}\}: empty lines divide what tiny_demo prints into \d+ parts/],
  ['an unknown program', '{{output big_demo}}', /no output of program "big_demo".*tiny_demo/],
  ['an unknown directive', '{{photograph line}}', /unknown directive \{\{photograph\}\}/],
  ['an unknown directive within a sentence', 'See {{photograph line}} here.', /unknown directive \{\{photograph\}\}/],
  ['an empty snippet', '{{snippet tumble/tiny.hpp nothing}}', /snippet nothing of .*tiny\.hpp is empty/],
  ['an unknown snippet', '{{snippet tumble/tiny.hpp width}}', /tiny\.hpp must hold the line \/\/! \[width\]/],
  ['a snippet of a file that is not there', '{{snippet tumble/big.hpp length}}', /there is no file chapters\/01_tiny\/tumble\/big\.hpp/],
  ['a fold that does not end', '{{fold More}}', /\{\{fold More\}\} has no \{\{end\}\}/],
  ['an end without a fold', '{{end}}', /\{\{end\}\} closes no/],
  ['a formula that is none', 'So \\f$ \\frac{1}{ \\f$ follows.', /\\frac\{1\}\{/],
  ['a formula with an unknown word', '\\f[ \\wheel = 1 \\f]', /\\wheel/],
  ['a link to a page that is not there', 'See \\ref chapter_09_absent.', /chapter_09_absent/],
];

for (const [what, line, message, at = 3] of mistakes) {
  test(`The build refuses ${what}, and says where it stands.`, () => {
    const lines = sound.split('\n');
    // Before everything else, so that a tool that counts from elsewhere is found out.
    lines.splice(2, 0, line, '');
    const {status, stderr} = make_book(lines.join('\n'));
    assert.notEqual(status, 0, 'the book was made all the same');
    assert.match(stderr, message);
    assert.ok(stderr.includes(`${chapter}:${at}:`), `the message does not say ${chapter}:${at}\n${stderr}`);
    assert.ok(!stderr.includes(`${folder}/${chapter}`), `the message names the machine's folders\n${stderr}`);
  });
}
