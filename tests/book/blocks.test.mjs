// Blocks that are made of what they are given alone.
import assert from 'node:assert/strict';
import {mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {test} from 'node:test';
import {Directives} from '../../book/tools/directives.mjs';
import {semester} from '../../book/tools/exercise_tables.mjs';
import {with_tasks} from '../../book/tools/exercises.mjs';
import {figure} from '../../book/tools/figures.mjs';
import {Results} from '../../book/tools/results.mjs';
import {parts_of} from '../../book/tools/scene_keys.mjs';
import {verdict_grid} from '../../book/tools/verdict_grid.mjs';

const verdicts = {name: 'in_double', columns: ['method', 'A'], rows: [['steady', '✗ L 4e-01'], ['explicit, |L| restored', '✗ E 2e-01'], ['splitting', '✓ E 1e-05']]};
const rows_of = html => [...html.matchAll(/<th scope="row">(.*?)<\/th>/g)].map(([, name]) => name);

test('Verdicts show the rows that are asked for, in that order, and all of them unasked.', () => {
  assert.deepEqual(rows_of(verdict_grid([verdicts], ['d'], 'c', ['splitting', 'explicit, |L| restored'])), ['splitting', 'explicit, |L| restored']);
  assert.equal(rows_of(verdict_grid([verdicts], ['d'], 'c')).length, 3);
  assert.throws(() => verdict_grid([verdicts], ['d'], 'c', ['ours']), /in_double has no row "ours"; its rows are: steady; explicit, \|L\| restored; splitting/);
});

const page = (chapter, name) => ({chapter, name, id: `chapter_${chapter}`, file: `chapter_${chapter}.html`});
const pages = {chapters: [page('01_force', '1 Force'), page('02_torque', '2 Torque'), page('03_inertia', '3 Inertia')]};
const told = text => ({text, file: 'task.md', line: 3});
const exercise = (chapter, minutes, points) => ({
  chapter, name: `of_${chapter}`, path: `${chapter}/of_${chapter}`, title: 'A push', minutes, points, difficulty: 'write', goals: ['push'],
  prerequisites: [], task: told('Push it.'), hints: ['Push.', 'Push hard.', 'Push harder.'].map(told), checks: [{sentence: 'It moves', points}], starter: {file: 'push.hpp', code: 'todo();'},
  solution: {file: 'push.hpp', code: 'push();', why: told('Because.')},
});
const exercises = [exercise('01_force', 10, 1), exercise('02_torque', 20, 2), exercise('03_inertia', 40, 4)];

test('The weeks before a bar are summed up, and so are all.', () => {
  const sums = html => [...html.matchAll(/<td class="number">(\d+)<\/td><td class="number">(\d+)<\/td><\/tr>/g)].map(([, minutes, points]) => [minutes, points]);
  assert.deepEqual(sums(semester('1; 2 | 3', exercises, pages)), [['10', '1'], ['20', '2'], ['30', '3'], ['40', '4'], ['70', '7']]);
  assert.match(semester('1; 2 | 3', exercises, pages), /a course of 2 weeks.*?2 exercises/);
  assert.deepEqual(sums(semester('1 2; 3', exercises, pages)), [['30', '3'], ['40', '4'], ['70', '7']]);
  assert.throws(() => semester('1 | 3', exercises, pages), /must name each chapter once/);
});

test('A task is what students are told, on any page, and never holds the solution.', () => {
  const lines = with_tasks([{text: 'Before.', place: 'page.md:1'}, {text: '{{task of_02_torque}}', place: 'page.md:2'}], exercises, pages);
  const all = lines.map(({text, html}) => text ?? html).join('\n');
  for (const words of ['Before.', '20 minutes', 'Push it.', 'It moves', 'Push harder.', 'todo();']) assert.ok(all.includes(words), words);
  assert.ok(!/push\(\)|Because/.test(all), 'the solution is there');
  assert.ok(!all.includes('{#exercise_'), 'its address is that of the exercise in its chapter');
  assert.ok(lines.slice(1).every(({place}) => ['page.md:2', 'task.md:3'].includes(place)), 'a line has no place');
  assert.throws(() => with_tasks([{text: '{{task absent}}', place: 'page.md:2'}], exercises, pages), /page\.md:2: no exercise is called absent/);
});

/** A page of the tool `bench`, set from results of which ODE's were not measured; {text, blocks, complaints}. */
function set_with_gaps(lines, unmeasured = []) {
  const folder = mkdtempSync(join(tmpdir(), 'tumble-gaps-'));
  mkdirSync(join(folder, 'bench'));
  writeFileSync(join(folder, 'bench/contest.values.tsv'), 'name\tvalue\nbullet\t15\node\t\n');
  writeFileSync(join(folder, 'bench/times.tsv'), 'bodies\tours\tODE\tBullet\n4\t2\t\t30\n16\t2.5\t\t\n64\t\t\t\n');
  const tools = [{name: 'bench', folder: 'tools/bench'}], complaints = [];
  const directives = new Directives({floors: [], tools, source: folder}, new Results(folder, tools, unmeasured), {chapters: []}, []);
  const page = {chapter: 'bench', path: 'tools/bench/bench.md', lines: lines.map((text, n) => ({text, place: `bench.md:${n + 1}`}))};
  const text = directives.expand(page, complaints);
  rmSync(folder, {recursive: true});
  return {text, blocks: directives.blocks.join('\n'), complaints};
}

test('A table has no row and no column for what was not measured, and keeps its other gaps.', () => {
  const {blocks, complaints} = set_with_gaps(['{{table times | How long}}']);
  assert.deepEqual(complaints, []);
  assert.deepEqual([...blocks.matchAll(/<th .*?>(.*?)<\/th>/g)].map(([, name]) => name), ['bodies', 'ours', 'Bullet']);
  assert.deepEqual([...blocks.matchAll(/<td class="number">(.*?)<\/td>/g)].map(([, cell]) => cell), ['4', '2', '30', '16', '2.5', '']);
});

test('What is said of a number is left out where it was not measured, with all that it holds.', () => {
  const lines = ['{{measured contest.bullet}}', 'Bullet takes {{value contest.bullet}}.', '{{end}}', 'Between.', '{{measured contest.ode}}', 'ODE takes {{value contest.ode}}.',
    '{{fold How}}', 'Hidden.', '{{end}}', '{{end}}', 'After.'];
  const {text, complaints} = set_with_gaps(lines);
  assert.deepEqual(complaints, []);
  assert.deepEqual(text.split('\n'), ['', 'Bullet takes 15.', '', 'Between.', '', '', '', '', '', '', 'After.']);
  assert.deepEqual(set_with_gaps(lines, ['bench']).text.split('\n').filter(Boolean), ['Between.', 'After.']);
});

test('A number that was not measured is quoted nowhere else, and one that no program knows is no gap.', () => {
  assert.match(set_with_gaps(['ODE takes {{value contest.ode}}.']).complaints[0], /bench\.md:1: program contest did not measure "ode".*\{\{measured contest\.ode\}\}/);
  assert.match(set_with_gaps(['{{measured contest.jolt}}', 'Jolt.', '{{end}}']).complaints[0], /wrote no value "jolt"; there are: bullet, ode/);
  assert.match(set_with_gaps(['{{measured contest.ode}}', 'ODE.']).complaints[0], /\{\{measured contest\.ode\}\} has no \{\{end\}\}/);
});

test("A drawing's areas take the page's colours as its lines do.", () => {
  const {svg} = figure('<svg><g transform="translate(0,20)" fill="black" font-size="18.00" text-anchor="start"><text>Title</text></g>' +
    "<polygon fill = 'rgb(238, 243, 246)' points = '1,2 3,4'/><path stroke='rgb( 85, 85, 85)' d='M1,2 L3,4'/></svg>", 'what it shows', 'drops');
  assert.match(svg, /<polygon fill="var\(--figure-fill\)".*<path stroke="var\(--figure-frame\)"/);
});

test('The table of the keys of scenes has every word of the schema, and no other.', () => {
  const descriptions = [];
  JSON.parse(readFileSync(new URL('../../tools/scenes/scene.schema.json', import.meta.url), 'utf8'), (key, value) => {
    if (key === 'description' && typeof value === 'string') descriptions.push(value);
    return value;
  });
  assert.ok(descriptions.length > 100);
  const words = text => text.replace(/\^2\b/g, '²').replace(/\^3\b/g, '³').toLowerCase().replace(/without (it|them)/g, '').match(/\S*[^\s.,;:]/g)?.sort();
  for (const description of descriptions) {
    const {meaning, unit, otherwise} = parts_of(description);
    assert.deepEqual(words(`${meaning} ${unit} ${otherwise}`), words(description), description);
  }
});
