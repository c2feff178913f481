// Every live figure's module computes the bits that its program computes, and its drawing needs nothing that is not there.
//   TUMBLE_RESULTS       the folder of the results
//   TUMBLE_LIVE_PROGRAMS the folder of the programs
//   TUMBLE_LIVE          the figures, CHAPTER/NAME, with commas
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import vm from 'node:vm';
import '../../book/player/vectors.js';
import '../../book/player/solids.js';
import '../../book/player/camera.js';
import '../../book/player/scene.js';
import '../../book/live/module.js';
import '../../book/live/plot.js';
import '../../book/live/still.js';
import {tables_of} from '../../book/tools/live.mjs';

const live = globalThis.tumble_live;
const {TUMBLE_RESULTS: results, TUMBLE_LIVE_PROGRAMS: programs} = process.env;
const colour = [1, 2, 3];
const palette = {paper: colour, ink: colour, grid: colour, shade: colour, bodies: Array(6).fill(colour)};

/** A quarter, a half and three quarters of each knob's way; knobs without a unit may be choices, and stay whole. */
const settings_of = knobs => [0.25, 0.5, 0.75].map(part => knobs.map(({unit, least, most}) => {
  const value = least + part * (most - least);
  return unit === '' && most >= 1 ? Math.max(least, Math.round(value)) : value;
}));

function by_program(name, values, drawn = []) {
  const run = spawnSync(join(programs, `live_${name}`), [values.join(','), drawn.join(',')], {encoding: 'utf8', maxBuffer: 1 << 28});
  return run.status === 0 ? live.run_of_program(run.stdout) : {refusal: run.stderr.trim()};
}

/** The same bits; what is no number has many, which mean nothing, and the program does not tell it from what is infinite. */
function assert_same(mine, its, where) {
  assert.equal(mine.refusal, its.refusal, where);
  if (mine.refusal) return;
  assert.deepEqual(mine.knobs, its.knobs, where);
  assert.deepEqual(Object.keys(mine.columns), Object.keys(its.columns), where);
  for (const [column, numbers] of Object.entries(mine.columns)) {
    const others = its.columns[column];
    assert.equal(numbers.length, others.length, `${where}: ${column}`);
    const different = numbers.findIndex((value, n) => !Object.is(Number.isFinite(value) ? value : NaN, others[n]));
    assert.equal(different, -1, `${where}: ${column}[${different}] is ${numbers[different]}, and ${others[different]} natively`);
  }
}

for (const [chapter, name] of process.env.TUMBLE_LIVE.split(',').map(figure => figure.split('/'))) {
  vm.runInThisContext(readFileSync(join(results, chapter, `${name}.live.js`), 'utf8'));
  const figure = live.figures[name];
  live.tables = {...live.tables, ...tables_of(figure, join(results, chapter))};
  const module = await live.Module.from(readFileSync(join(results, chapter, `${name}.wasm`)));

  test(`${name}: the module's numbers are the program's to the bit, at the start and in three settings.`, async () => {
    const start = await module.run();
    assert_same(start, by_program(name, []), 'at the start');
    for (const values of settings_of(start.knobs)) assert_same(await module.run(values), by_program(name, values), values.join());
  });

  test(`${name}: each setting has a picture and a sentence of what is found.`, async () => {
    const {knobs} = await module.run();
    assert.deepEqual(knobs.map(knob => knob.name).sort(), Object.keys(figure.knobs).sort(), 'the knobs that are described');
    for (const values of [knobs.map(({start}) => start), ...settings_of(knobs)]) {
      const run = await module.run(values);
      assert.equal(run.refusal, undefined);
      for (const is_answered of [false, true]) {
        live.answered = () => is_answered;
        const finding = figure.finding(live.state_of(figure, run, 0, values));
        assert.match(finding, /^[A-Z].*[.]$/s, values.join());
        assert.doesNotMatch(finding, /undefined|NaN/, values.join());
        assert.match(live.still_of(figure, run, palette), /<polyline/);
        assert.doesNotMatch(live.still_of(figure, run, palette), /NaN|undefined/);
      }
    }
  });

  test(`${name}: a knob beyond its limit is refused by name, and the next run is sound.`, async () => {
    const {knobs} = await module.run();
    if (!knobs.length) return; // its texts are tried in scene.test.mjs
    const beyond = knobs.map(({most}) => 2 * Math.abs(most) + 1);
    assert_same(await module.run(beyond), by_program(name, beyond), 'beyond');
    assert.match((await module.run(beyond)).refusal, new RegExp(`^${knobs[0].name} is .*it must lie between`));
    assert_same(await module.run(), by_program(name, []), 'afterwards');
  });
}

test('The slope at a rung’s line is the order that it claims, wherever its steps are short enough to tell.', async () => {
  const module = await live.Module.from(readFileSync(join(results, '13_accuracy/price_of_error.wasm')));
  const told = [6, 10, 11, 13, 16, 18]; // orders 2, 2, 4, 4, 6 and 8, straight on the ordinary body and the stable axis
  for (const problem of [0, 1]) {
    const {columns} = await module.run([problem]);
    for (const rung of told) assert.ok(Math.abs(columns.slope[rung] + columns.order[rung]) < 0.15, `rung ${rung}: ${columns.slope[rung]}`);
    assert.ok(Number.isNaN(columns.slope[0]), 'the rule that never comes near has none');
  }
});

test('A time buys the most accurate run that it pays for, and the exact solution stays grey until the question is answered.', async () => {
  const module = await live.Module.from(readFileSync(join(results, '13_accuracy/price_of_error.wasm')));
  const figure = live.figures.price_of_error, {tables} = live;
  // A step of the splitting for 100 ns, of Runge and Kutta's rule for 10, an answer for 1 µs, in 10 s.
  live.tables = {step_prices: {rows: [['splitting', '100'], ['Runge-Kutta', '10'], ['exact solution', '1000']]}};
  const run = await module.run();
  const told = (is_answered, ...values) => {
    live.answered = () => is_answered;
    return figure.finding(live.state_of(figure, run, 0, values));
  };
  assert.match(told(true, 0, 10, 1, 1e-4, 400, 0), /^For 400\sns .*“Runge-Kutta”: with steps of 0[.]028\ss/); // 362 of them, the next 512
  assert.match(told(true, 0, 10, 1, 1e-4, 400, 0), /The next, “splitting”/);
  assert.match(told(true, 0, 10, 1, 1e-4, 10, 0), /^For 10\sns .*“splitting”: with a single step/);
  assert.match(told(false, 0, 21, 0, 1e-4, 400, 0), /stays grey until/);
  assert.match(told(true, 0, 21, 0, 1e-4, 400, 0), /for 100\sns a simulated second/);
  assert.doesNotMatch(told(false, 0, 11, 0, 1e-4, 400, 0), /thousandth/);
  assert.match(told(true, 0, 11, 0, 1e-4, 400, 0), /order is 4: a thousandth of its error costs 5[.]\d times/);
  live.tables = tables;
});

test('A comet’s steps fill its round, are shortest at the star, and are nearly ten times as many for a ten-thousandth of the error.', async () => {
  const module = await live.Module.from(readFileSync(join(results, '13_accuracy/own_steps.wasm')));
  const [rough, fine] = [await module.run([0.8, 1e-4]), await module.run([0.8, 1e-8])];
  for (const {columns} of [rough, fine]) {
    const {step, distance, time, tried} = columns;
    assert.equal(step.length + 1, distance.length);
    assert.ok(Math.abs(step.reduce((sum, h) => sum + h) / time.at(-1) - 1) < 1e-12, 'they add up to the round');
    const shortest = step.indexOf(Math.min(...step));
    assert.ok(distance[shortest] < 0.25, `the shortest begins ${distance[shortest]} m from the star, which it passes at 0.2 m`);
    assert.ok(tried.every(h => h > columns.step[shortest]), 'what was rejected was longer than the shortest');
  }
  const times = fine.columns.step.length / rough.columns.step.length;
  assert.ok(times > 8 && times < 10, `${times}`);
});

test('A long work comes in parts: who gives up between them gets nothing, and who goes on gets the whole.', async () => {
  const bytes = readFileSync(join(results, '13_accuracy/price_of_error.wasm'));
  const [patient, hasty] = [await live.Module.from(bytes), await live.Module.from(bytes)];
  const whole = await patient.run();
  let parts = 0;
  assert.equal(await hasty.run([], [], () => ++parts < 5), undefined);
  assert.equal(parts, 5);
  await hasty.run([2]); // another problem meanwhile
  assert_same(await hasty.run(), whole, 'taken up again');
});
