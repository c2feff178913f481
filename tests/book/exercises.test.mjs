// A chapter's page ends with its exercises; what is folded away there is not found by a search, and a student's copy of the course has
// no solution to show. TUMBLE_TINY is the folder of the tiny book, which make_tiny_book.cmake has built.
import assert from 'node:assert/strict';
import {mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {after, test} from 'node:test';

const folder = process.env.TUMBLE_TINY;
const solution = join(folder, 'solutions/01_tiny/stick');
const task = join(folder, 'exercises/01_tiny/stick/task.md'), sound_task = readFileSync(task, 'utf8');
const data = join(folder, 'exercises/01_tiny/stick/exercise.json'), sound_data = readFileSync(data, 'utf8');
const notes = join(folder, 'exercises/instructor.md');

after(() => {
  rmSync(join(folder, 'solutions'), {recursive: true, force: true});
  rmSync(notes, {force: true});
  writeFileSync(task, sound_task);
  writeFileSync(data, sound_data);
});

function make_book() {
  const {status, stderr} = spawnSync(process.execPath,
    [join(folder, 'book/tools/book.mjs'), join(folder, 'build/book_work/settings.json')], {encoding: 'utf8', timeout: 60_000});
  return {status, stderr};
}

const made = name => readFileSync(join(folder, 'book_made', name), 'utf8');
const chapter = () => made('chapter_01_tiny.html');
const hidden_by = (page, word) => new RegExp(`<details class="fold spoiler[^>]*>(?:(?!</details>)[^])*${word}`).test(page);

test('Without solutions the page has the task, the checks and three closed hints.', () => {
  const {status, stderr} = make_book();
  assert.equal(status, 0, stderr);
  const page = chapter();
  for (const expected of ['id="exercises_01_tiny"', 'id="exercise_stick"', 'Make the stick 1.5 m long', '7 minutes', '3 points',
    './course start stick', 'The stick is as long as a gingerbread man is tall', 'Hint 3 of 3']) {
    assert.ok(page.includes(expected), expected);
  }
  assert.equal(page.match(/<details class="fold spoiler unindexed">/g).length, 3);
  assert.ok(hidden_by(page, 'marzipan'), 'the first hint is not folded away');
  assert.ok(!page.includes('Solution'), 'a solution is announced');
  assert.match(made('exercises.html'), /href="chapter_01_tiny\.html#exercise_stick"/);
  assert.ok(!page.includes('handbook.html'), 'students have a page for instructors');
});

test('With solutions there is one more fold; a search finds the task and nothing that is folded away.', () => {
  mkdirSync(solution, {recursive: true});
  writeFileSync(join(solution, 'stick.hpp'),
    'double stick_length() {\n  //! [solution]\n  return 1.5;  // nougat\n  //! [starter]\n  // return 1;\n  //! [end]\n}\n');
  writeFileSync(join(solution, 'why.md'), '# Why\n\nThe zwieback of the whole.\n\n## Common mistakes\n\n- Too much liquorice.\n');
  const {status, stderr} = make_book();
  assert.equal(status, 0, stderr);
  const page = chapter();
  for (const word of ['nougat', 'zwieback', 'liquorice']) assert.ok(hidden_by(page, word), word);
  assert.ok(!page.includes('[solution]') && !page.includes('return 1;'), 'the marks of the solution show');
  const index = made('search_index.js');
  for (const word of ['stick 1.5 m long', 'gingerbread']) assert.ok(index.includes(word), `${word} is not found`);
  for (const word of ['marzipan', 'nougat', 'zwieback', 'liquorice']) assert.ok(!index.includes(word), `${word} is found`);
});

test('Notes for instructors become the last page, with the weeks of a semester.', () => {
  writeFileSync(notes, '# Handbook {#handbook}\n\n{{semester 1}}\n\n{{wrong_answers}}\n');
  const {status, stderr} = make_book();
  assert.equal(status, 0, stderr);
  assert.match(made('handbook.html'), /A longer stick<\/a>&#160;\(7\)/);
  assert.match(chapter(), /href="handbook\.html"/);
  assert.equal(JSON.parse(made('reading_order.json')).at(-1).id, 'handbook');
});

const mistakes = [
  ['a task with a link to nowhere', task, text => text.replace('Make', 'See \\ref chapter_09_absent. Make'),
    /exercises\/01_tiny\/stick\/task\.md:3: .*chapter_09_absent/],
  ['a task with another title', task, text => text.replace('longer', 'shorter'), /task\.md:1: .*"# A shorter stick".*"# A longer stick"/],
  ['an exercise that breaks a rule', data, text => text.replace('"minutes": 7', '"minutes": 0'), /exercise\.json: minutes is 0/],
  ['a semester without a chapter', notes, text => text.replace('semester 1', 'semester 2'), /instructor\.md:3: .*each chapter once/],
  ['a part of a file that is not there', notes, text => `${text}\n{{section cmake/absent.md | Add}}\n`, /instructor\.md:\d+: there is no file/],
];

for (const [what, file, with_mistake, message] of mistakes) {
  test(`The build refuses ${what}, and says where it stands.`, () => {
    const sound = readFileSync(file, 'utf8');
    try {
      writeFileSync(file, with_mistake(sound));
      const {status, stderr} = make_book();
      assert.notEqual(status, 0, 'the book was made all the same');
      assert.match(stderr, message);
      assert.ok(!stderr.includes(`${folder}/`), `the message names the machine's folders\n${stderr}`);
    } finally {
      writeFileSync(file, sound);
    }
  });
}
