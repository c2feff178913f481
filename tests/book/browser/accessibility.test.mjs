// axe-core finds nothing serious on any page for reading, nor on a sample of the reference, light or dark.
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import {after, before, test} from 'node:test';
import {address, launch, open_page} from './browser.mjs';
import {one_page_of_each_kind} from './pages.mjs';

const axe = createRequire(import.meta.url)('axe-core');

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

for (const colourScheme of ['light', 'dark']) {
  for (const name of one_page_of_each_kind) {
    test(`axe-core finds nothing serious on ${name}, ${colourScheme}.`, async () => {
      const page = await open_page(browser, {colourScheme});
      await page.goto(address(name));
      await page.evaluate(axe.source);
      const {violations} = await page.evaluate(() => axe.run(document, {resultTypes: ['violations']}));
      const serious = violations.filter(({impact}) => ['serious', 'critical'].includes(impact))
        .map(({id, help, nodes}) => ({id, help, where: nodes.slice(0, 3).map(({target, any}) =>
          `${target.join(' ')}: ${any.map(({message}) => message).join('; ')}`)}));
      assert.deepEqual(serious, []);
      await page.context().close();
    });
  }
}
