// Each example of the reference compiles with the includes that its page shows, and with no more: TUMBLE_BOOK, TUMBLE_SOURCE,
// TUMBLE_COMPILER, TUMBLE_EIGEN.
import assert from 'node:assert';
import {spawnSync} from 'node:child_process';
import {readFileSync, readdirSync} from 'node:fs';
import {test} from 'node:test';

const {TUMBLE_BOOK: book, TUMBLE_SOURCE: source, TUMBLE_COMPILER: compiler, TUMBLE_EIGEN: eigen} = process.env;
const chapters = readdirSync(`${source}/chapters`).map(name => `chapters/${name}`);
const flags = ['-std=c++20', '-ffp-contract=off', '-w', '-isystem', eigen, ...['common', 'exact', 'tools/scene_reader', ...chapters].map(folder => `-I${source}/${folder}`)];
const letters = {lt: '<', gt: '>', quot: '"', amp: '&', '#39': "'"};
const text_of = html => html.replace(/<[^>]*>/g, '').replace(/&(lt|gt|quot|amp|#39);/g, (_, name) => letters[name]);

/** Each example once, which several pages may show: {page, includes, body}. */
function examples() {
  const found = new Map();
  for (const page of readdirSync(book).filter(name => name.endsWith('_8hpp.html'))) {
    const listing = /<figure class="listing"><figcaption>[^<]*<a[^>]*><code>\w+_checks\.cpp<\/code>[\s\S]*?<\/figure>/.exec(readFileSync(`${book}/${page}`, 'utf8'));
    if (!listing) continue;
    const lines = [...listing[0].matchAll(/<div class="line"[^>]*>(.*)<\/div>/g)].map(([, line]) => text_of(line));
    const is_include = line => line.startsWith('#include');
    found.set(lines.join('\n'), {page, includes: lines.filter(is_include), body: lines.filter(line => !is_include(line)).join('\n')});
  }
  return [...found.values()];
}

/** What the compiler says to an example, a check or the lines of one. */
function complaint({includes, body}) {
  const checks = body.replace(/TEST_CASE\("[^"]*"\)/g, 'void example()');
  const code = checks === body ? `void example() {\n${body}\n}` : checks;
  const {status, stderr, error} = spawnSync(compiler, [...flags, '-fsyntax-only', '-x', 'c++', '-'], {encoding: 'utf8',
    input: `${includes.join('\n')}\n#include <doctest/doctest.h>\nusing namespace tumble;\nusing namespace std;\n${/\(path\)/.test(body) ? 'std::filesystem::path path; // of the reader' : ''}\n${code}\n`});
  assert.ifError(error);
  return status === 0 ? '' : stderr || 'no word';
}

const all = examples();
test('The reference has examples', () => assert.ok(all.length >= 20, `${all.length} were found`));
for (const example of all) test(`${example.page} compiles as it is shown`, () => assert.equal(complaint(example), ''));
test('An example without its includes does not compile', () => assert.notEqual(complaint({...all[0], includes: []}), ''));
