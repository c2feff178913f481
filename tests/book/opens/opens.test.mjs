// Every page of the book opens in Chromium without an error, and no link on it is dead, once its scripts have run.
//   TUMBLE_BOOK      the folder of the book
//   TUMBLE_CHROMIUM  the browser
// The pages in `broken` have each the one fault that their first line announces.
import assert from 'node:assert/strict';
import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {after, before, test} from 'node:test';
import {Chromium} from './chromium.mjs';
import {open_all} from './opened.mjs';

let browser;
before(() => { browser = new Chromium(process.env.TUMBLE_CHROMIUM); });
after(() => browser.close());

test('A page with a fault is named, and a sound one is not.', async () => {
  const broken = fileURLToPath(new URL('broken', import.meta.url));
  const announced = readdirSync(broken).sort().flatMap(name => {
    const fault = /The fault: (.*?) -->/.exec(readFileSync(join(broken, name), 'utf8'))?.[1];
    return fault ? [[name, fault]] : [];
  });
  const {faults} = await open_all(browser, broken);
  assert.equal(faults.length, announced.length, faults.join('\n'));
  for (const [index, [name, fault]] of announced.entries())
    assert.ok(faults[index].startsWith(`${name}: `) && faults[index].includes(fault), `${faults[index]}\nshould say: ${fault}`);
});

test('Every page of the book opens without an error, and every link leads somewhere.', async context => {
  const book = process.env.TUMBLE_BOOK;
  const in_order = JSON.parse(readFileSync(join(book, 'reading_order.json'), 'utf8')).map(({file}) => file);
  const {pages, faults} = await open_all(browser, book, in_order);
  context.diagnostic(`${pages} pages, ${faults.length} faults`);
  assert.equal(faults.length, 0, faults.join('\n'));
});
