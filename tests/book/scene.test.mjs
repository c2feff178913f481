// The module that edits scenes computes what simulate computes, and refuses what the reader refuses, in the same words.
//   TUMBLE_RESULTS   the folder of the results
//   TUMBLE_SIMULATE  the program simulate
//   TUMBLE_REFUSALS  the program print_refusals
//   TUMBLE_SCENES    the folder of the shipped scenes
//   TUMBLE_CORPUS    the folder of the fuzzer's texts
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';
import vm from 'node:vm';
import '../../book/player/vectors.js';
import '../../book/live/module.js';
import '../../book/live/plot.js';

const {TUMBLE_RESULTS: results, TUMBLE_SIMULATE: simulate, TUMBLE_REFUSALS: refusals, TUMBLE_SCENES: scenes, TUMBLE_CORPUS: corpus} = process.env;
const live = globalThis.tumble_live;
const bytes = readFileSync(join(results, 'simulate/scene.wasm'));
const module = await live.Module.from(bytes);
vm.runInThisContext(readFileSync(join(results, 'simulate/scene.live.js'), 'utf8'));
const {text_of, change, new_effect, new_body, kinds, bodies} = live.scene_text;
const scratch = mkdtempSync(join(tmpdir(), 'tumble-scene-'));
after(() => rmSync(scratch, {recursive: true}));

const run_of = (scene, file = 'scene.json') => module.run([], [], () => true, {scene, file});
const files = readdirSync(scenes).filter(name => name.endsWith('.json') && !name.includes('.schema.'));
const text_in = name => readFileSync(join(scenes, name), 'utf8');

function by_simulate(...words) {
  const {status, stderr} = spawnSync(simulate, words, {encoding: 'utf8', cwd: scratch});
  return {status, complaint: stderr.trim()};
}

test('The module with the whole engine stays below 800 kB.', () => {
  assert.ok(bytes.length < 800_000, `${bytes.length} bytes`);
});

test('Whatever is wrong with a scene, the module has the reader\'s own sentence, to the byte.', async () => {
  const own = readdirSync(corpus).map(name => join(corpus, name));
  const list = JSON.parse(spawnSync(refusals, own, {encoding: 'utf8', maxBuffer: 1 << 28}).stdout);
  const refused = list.filter(({refusal}) => refusal !== null);
  assert.ok(refused.length > 100, `${refused.length} texts`);
  assert.ok(refused.some(({refusal}) => refusal.includes('is refused: ')), 'one that the library refuses and the reader explains');
  for (const {text, refusal} of refused) assert.equal((await run_of(text, 'bad.json')).refusal, refusal, text.slice(0, 300));
  assert.equal(module.call('scene_parts'), 0, 'of a refused scene there is nothing to measure');
});

for (const file of files) {
  test(`${file}: the module ends where simulate ends, to the bit, with the same plan and the same books.`, async () => {
    const run = await run_of(text_in(file), file);
    if (run.refusal) { // too many bodies for a page
      assert.deepEqual(by_simulate(join(scenes, file), '--live', 'page.html'), {status: 2, complaint: `simulate: ${run.refusal}`});
      return;
    }
    const books = JSON.parse(run.said.books);
    assert.equal(by_simulate(join(scenes, file), '--csv', 'motion.csv', '--every', String(books.steps), '--books', 'books.json').status, 0);
    const rows = readFileSync(join(scratch, 'motion.csv'), 'utf8').trim().split('\n').slice(1 + books.bodies);
    const numbers = rows.flatMap(row => row.match(/(?:,[^,"]*){13}$/)[0].split(',').slice(1).map(Number));
    assert.equal(numbers.length, 13 * books.bodies);
    const last = run.columns.last;
    const different = numbers.findIndex((value, n) => !Object.is(value, last[n]));
    assert.equal(different, -1, `number ${different}: ${last[different]}, and ${numbers[different]} by simulate`);
    assert.equal(run.said.books, readFileSync(join(scratch, 'books.json'), 'utf8'));
    const {stdout} = spawnSync(simulate, [join(scenes, file), '--plan'], {encoding: 'utf8'});
    const plan = JSON.parse(run.said.plan);
    for (const {effect, visited, of, reason} of plan.rows)
      assert.ok(stdout.split('\n').some(line => line.startsWith(effect) && line.includes(` ${visited} of ${of} `) && line.endsWith(reason)), `${effect}: ${reason}`);
    for (const sentence of [plan.accuracy, ...plan.warnings, ...plan.unknown.map(what => `limit of the step unknown: ${what}\n`)]) assert.ok(stdout.includes(sentence), sentence);
    // What measures the cost goes through the lines that visit somebody.
    assert.equal(plan.unknown.length, stdout.split('limit of the step unknown: ').length - 1);
    assert.equal(module.call('scene_parts'), plan.rows.filter(({visited}) => visited > 0).length);
    for (let part = -1; part < module.call('scene_parts'); ++part) module.call('scene_run_part', part, 1, 2);
  });
}

test('Frames are no more than a page can hold, and their last lies at the end or less than an interval before.', async () => {
  for (const file of ['orbit.json', 'storm.json', 't_handle.json']) {
    const {columns, said} = await run_of(text_in(file));
    const {seconds_between_frames: apart} = JSON.parse(said.recording), {time: end} = JSON.parse(said.books);
    assert.ok(columns.time.length <= 2001 && columns.poses.length <= 7 * 4.1e5);
    assert.ok(end - columns.time.at(-1) < apart * (1 + 1e-9) && columns.time.at(-1) <= end);
  }
});

test('A step that fails is refused in the words of simulate, and the next run is sound.', async () => {
  const comet = {duration: 1, bodies: [{name: 'comet', mass: 1}], effects: [{kind: 'point_gravity', strength: 1}]};
  const {refusal} = await run_of(text_of(comet), 'comet.json');
  assert.match(refusal, /comet/);
  const file = join(scratch, 'comet.json');
  writeFileSync(file, text_of(comet));
  assert.deepEqual(by_simulate(file), {status: 1, complaint: `simulate: ${refusal}`});
  assert.equal((await module.run()).refusal, undefined);
});

test('What the form writes means what the text meant: every shipped scene survives its own layout.', async () => {
  for (const file of files) {
    const scene = JSON.parse(text_in(file));
    assert.deepEqual(JSON.parse(text_of(scene)), scene);
    assert.ok(text_of(scene).split('\n').every(line => line.length <= 120 || line.includes('"description"')), file);
  }
});

test('Every kind of effect and of body can be added to the first scene, which runs with it.', async () => {
  const first = JSON.parse((await module.run()).texts.scene);
  for (const kind of kinds) {
    const run = await run_of(text_of({...first, effects: [new_effect(first, kind)]}));
    assert.equal(run.refusal, undefined, kind);
  }
  for (const kind of bodies) {
    const scene = structuredClone(first);
    scene.bodies.push(new_body(scene, kind));
    scene.bodies.push(new_body(scene, kind));
    assert.equal((await run_of(text_of(scene))).refusal, undefined, kind);
  }
  assert.deepEqual([...kinds].sort(), [...new Set(JSON.parse(readFileSync(join(scenes, 'everything.json'), 'utf8')).effects.map(({kind}) => kind))].sort());
});

test('Words of an address switch effects off and on again, and set what they name.', async () => {
  const scene = JSON.parse((await module.run()).texts.scene), aside = [], before = structuredClone(scene);
  change(scene, aside, {gravity: 'off', 'box.angular_velocity': '[0,5,0]', 'scene.step.per_second': '7', 'spring.stiffness': '50'});
  assert.deepEqual(scene.effects.map(({kind}) => kind), ['spring_between']);
  assert.deepEqual(scene.bodies.find(({name}) => name === 'box').angular_velocity, [0, 5, 0]);
  assert.equal(scene.step.per_second, 7);
  assert.equal(scene.effects[0].stiffness, 50);
  change(scene, aside, {gravity: 'on', thruster: 'on'});
  change(scene, aside, {thruster: 'on'}); // it burns already
  assert.deepEqual(scene.effects.map(({kind}) => kind), ['spring_between', 'gravity', 'thruster']);
  assert.deepEqual(scene.effects[1], before.effects[0]);
  assert.equal((await run_of(text_of(scene))).refusal, undefined);
});

test('What has a name of its own is switched by that name, or by its kind with all others of the kind.', () => {
  const thruster = name => ({kind: 'thruster', name, bodies: ['box'], force: [0, 0, 2]});
  const scene = {bodies: [{name: 'box', mass: 1}], effects: [thruster('left'), {kind: 'gravity', acceleration: [0, 0, -9]}, thruster('right')]};
  const aside = [], names = list => list.map(({name, kind}) => name ?? kind);
  change(scene, aside, {thruster: 'off'});
  assert.deepEqual([names(scene.effects), names(aside)], [['gravity'], ['left', 'right']]);
  change(scene, aside, {right: 'on', 'thruster.force': '[0,0,3]'});
  assert.deepEqual([names(scene.effects), names(aside)], [['gravity', 'right'], ['left']]);
  assert.deepEqual([scene.effects[1].force, aside[0].force], [[0, 0, 3], [0, 0, 3]]);
});

test('The finding says what has changed in the plan, line by line.', async () => {
  const {finding_of} = live.scene_tables;
  const first = await module.run(), scene = JSON.parse(first.texts.scene);
  change(scene, [], {thruster: 'on'});
  const burning = await run_of(text_of(scene));
  const finding = finding_of(burning.said, first.said);
  assert.match(finding, /^A step makes 8 passes over 4 bodies\. Changed in the plan: thruster is new \(1 of 1\); kick of the spin was no pass and is now 1 of 4; tumbling: splitting was no pass and is now 1 of 4\.$/);
  assert.match(finding_of(first.said, burning.said), /thruster is gone/);
  assert.doesNotMatch(finding_of(first.said, first.said), /Changed/);
  scene.effects.push(...['ball', 'box'].map(name => ({kind: 'linear_damping', rate: 0.1, bodies: [name]})));
  const twice = await run_of(text_of(scene));
  scene.effects.pop();
  const once = await run_of(text_of(scene));
  assert.match(finding_of(once.said, twice.said), /Changed in the plan: linear damping is gone\.$/, 'one of two lines of a name');
  assert.match(finding_of(twice.said, once.said), /Changed in the plan: linear damping is new \(1 of 1\)\.$/);
});
