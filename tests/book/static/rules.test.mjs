// The rules are tested: each broken page breaks the one rule it is named after, in the way its first line says.
import assert from 'node:assert/strict';
import {fileURLToPath} from 'node:url';
import {test} from 'node:test';
import {faults, rules} from './rules.mjs';
import {read_book} from './page.mjs';

const folder = fileURLToPath(new URL('broken', import.meta.url));
const book = read_book(folder, ['/home/reader/tumble']);
const found = faults(book);
const broken_files = [...book.texts.keys()].filter(path => !/^(sound|drawn)\./.test(path));

test('A sound page has no fault.', () => {
  assert.deepEqual(found.filter(({path}) => !broken_files.includes(path)), []);
});

test('Every rule has a page that breaks it.', () => {
  const broken_rules = new Set(broken_files.map(path => path.split('.')[0]));
  assert.deepEqual([...broken_rules].sort(), Object.keys(rules).sort());
});

for (const path of broken_files) {
  test(`${path} has the one fault it announces.`, () => {
    const announced = /The fault: (.*?) (-->|\*\/)/.exec(book.texts.get(path))[1];
    const here = found.filter(fault => fault.path === path);
    assert.equal(here.length, 1, JSON.stringify(here));
    assert.equal(here[0].rule, path.split('.')[0]);
    assert.ok(here[0].problem.includes(announced), `${here[0].problem}\nshould say: ${announced}`);
  });
}
