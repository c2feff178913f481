// The reference has whatever the headers document, whichever version of Doxygen wrote it: read from the sources as lines.
import assert from 'node:assert/strict';
import {existsSync, readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

const book = process.env.TUMBLE_BOOK,
  source = process.env.TUMBLE_SOURCE;

const headers = ['common', ...readdirSync(join(source, 'chapters')).map(name => join('chapters', name))]
  .map(folder => join(folder, 'tumble'))
  .filter(folder => existsSync(join(source, folder)))
  .flatMap(folder => readdirSync(join(source, folder)).filter(name => name.endsWith('.hpp')).map(name => join(folder, name)));

/** The names of types, of fields that have a note, and of functions that stand at the margin under a comment, in what is not left out. */
function documented(text) {
  const shown = text.replace(/\/\/\/ @cond[\s\S]*?\/\/\/ @endcond/g, '').replace(/^namespace detail \{[\s\S]*?^\}  \/\/ namespace detail$/gm, '').replace(/^ (?:private|protected):[\s\S]*?^\};/gm, '');
  const fields = [...shown.matchAll(/^ +(?:const )?[\w:]+(?:<.*>)? (\w+)(?: = [^;]*)?; +\/\/\/</gm)].map(match => match[1]);
  const functions = [...shown.matchAll(/^\/\/\/.*\n(?:\/\/!.*\n)?(?:template <.*>\n)?(?:inline |constexpr )*[\w:]+(?:<[\w:, <>]*>)? (\w+)\(/gm)].map(match => match[1]);
  const types = [...shown.matchAll(/^\/\/\/.*\n(?:\/\/!.*\n)?(?:template <.*>\n)?(?:class|struct) (\w+)(?: final)?(?: :[^;{]*)? \{/gm)].map(match => match[1]);
  return {types, fields, functions};
}

test('Each type, field and function that a header documents stands in the reference, on the page of that header.', () => {
  let types = 0,
    fields = 0,
    functions = 0;
  const absent = [];
  for (const path of headers) {
    const file = `${path.split('/').at(-1).replaceAll('_', '__').replace('.hpp', '_8hpp.html')}`;
    if (!existsSync(join(book, file))) {
      absent.push(`${path}: no page ${file}`);
      continue;
    }
    const page = readFileSync(join(book, file), 'utf8');
    const rows = [...page.matchAll(/<tr id="[^"]*"><td[^>]*><code>(.*?)<\/code>/g)].map(match => match[1].replace(/<[^>]*>/g, '').replace(/ = .*/, ''));
    const named = [...page.matchAll(/<h[23][^>]*>([\w~]+)<\/h[23]>/g)].map(match => match[1]);
    const headings = [...page.matchAll(/<h[23] id="[^"]*">(.*?)<\/h[23]>/g)].map(match => match[1]);
    absent.push(...headings.filter(name => !/^(~?\w+|operator\S+)$/.test(name)).map(name => `${path}: a name instead of "${name}"`));
    if (named.includes('tumble')) absent.push(`${path}: what is called there like the namespace`);
    const told = documented(readFileSync(join(source, path), 'utf8'));
    absent.push(...told.fields.filter(name => !rows.includes(name)).map(name => `${path}: the field ${name}`));
    absent.push(...told.types.filter(name => !headings.includes(name)).map(name => `${path}: the type ${name}`));
    absent.push(...told.functions.filter(name => !named.includes(name)).map(name => `${path}: the function ${name}`));
    types += told.types.length;
    fields += told.fields.length;
    functions += told.functions.length;
  }
  assert.deepEqual(absent, []);
  assert.ok(types > 50 && fields > 100 && functions > 200, `${types} types, ${fields} fields and ${functions} functions were found in the sources`);
});

test('The unit and the axes in the table of what a function takes are those that its text names beside the argument.', () => {
  const {names, of} = JSON.parse(readFileSync(join(source, 'book/pages/parameters.json'), 'utf8'));
  const rows = [...Object.values(names), ...Object.values(of).flatMap(each => Object.values(each))];
  const units = [...new Set(rows.map(([, unit]) => unit))].filter(unit => unit && /^[\w /()²³⁻]+$/.test(unit) && !['1', 'any'].includes(unit));
  const literally = text => text.replace(/[()/.]/g, '\\$&');
  const any_unit = units.sort((a, b) => b.length - a.length).map(literally).join('|');
  let compared = 0;
  const wrong = [];
  for (const file of readdirSync(book).filter(name => name.endsWith('_8hpp.html')))
    for (const member of readFileSync(join(book, file), 'utf8').split(/(?=<h[23][ >])/)) {
      const [, name] = /^<h[23][^>]*>(.*?)<\//.exec(member) ?? [];
      const [told, table] = member.split('<table class="given">');
      if (!table) continue;
      const declared = told.replace(/<[^>]*>/g, '');
      const heads = [...table.split('</thead>')[0].matchAll(/<th[^>]*>(\w+)<\/th>/g)].map(match => match[1]);
      for (const [, row] of table.split('</table>')[0].matchAll(/<tr>(<td>.*?)<\/tr>/g)) {
        const cells = [...row.matchAll(/<td>(.*?)<\/td>/g)].map(match => match[1].replace(/<[^>]*>/g, ''));
        const [argument, unit, axes] = ['argument', 'unit', 'axes'].map(head => cells[heads.indexOf(head)] ?? '');
        const beside = new RegExp(`<code>${argument}</code>(?: is \\S+,)?(?: in | \\(| )(${any_unit})(?![\\w/²³])(?:, (world|body|model)\\b)?`).exec(told);
        if (beside) {
          compared += 1;
          if (beside[1] !== unit) wrong.push(`${file}, ${name}: ${argument} in ${unit}, by the text in ${beside[1]}`);
          if (beside[2] && beside[2] !== axes) wrong.push(`${file}, ${name}: ${argument} in ${axes} axes, by the text in ${beside[2]} axes`);
        }
        // What is counted in whole numbers is no number of seconds.
        if (unit === 's' && new RegExp(`int64_t ${argument}\\b`).test(declared)) wrong.push(`${file}, ${name}: ${argument} in s, and it is a whole number`);
      }
    }
  assert.deepEqual(wrong, []);
  assert.ok(compared > 50, `${compared} units were found in the texts`);
});

test('What is said of one function\'s arguments is said of a function that there is.', () => {
  const {of} = JSON.parse(readFileSync(join(source, 'book/pages/parameters.json'), 'utf8'));
  const exact = readdirSync(join(source, 'exact/tumble/exact')).map(name => join('exact/tumble/exact', name));
  const code = [...headers, ...exact].map(path => readFileSync(join(source, path), 'utf8')).join('');
  const gone = Object.keys(of).filter(name => !new RegExp(`\\b${name.split('/').at(-1)}\\b *[({<]`).test(code));
  assert.deepEqual(gone, []);
});

test('A call of the world\'s, wherever it is written, leads to that member of World.', () => {
  const members = new Map([...readFileSync(join(book, 'world_8hpp.html'), 'utf8').matchAll(/<h3 id="(world-\w+)">(.*?)<\/h3>/g)]
    .map(([, id, name]) => [id, name.replace(/<[^>]*>/g, '')]));
  const wrong = [];
  let calls = 0;
  for (const file of readdirSync(book).filter(name => name.endsWith('.html')))
    for (const [, address, name] of readFileSync(join(book, file), 'utf8').matchAll(/<a [^>]*href="([^"]*)"[^>]*>world\.(\w+)\(/g)) {
      ++calls;
      const [page, id] = address.split('#');
      if ((page || file) !== 'world_8hpp.html' || members.get(id) !== name) wrong.push(`${file}: world.${name}() leads to ${address}`);
    }
  assert.deepEqual(wrong, []);
  assert.ok(calls > 20, `only ${calls} such links were seen`);
});
