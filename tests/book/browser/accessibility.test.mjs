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

async function serious_violations(page, options) {
  const {violations} = await page.evaluate(chosen => axe.run(document, {resultTypes: ['violations'], ...chosen}), options);
  return violations.filter(({impact}) => ['serious', 'critical'].includes(impact)).map(({id, help, nodes}) => ({id, help,
    where: nodes.slice(0, 3).map(({target, any}) => `${target.join(' ')}: ${any.map(({message}) => message).join('; ')}`)}));
}

for (const name of one_page_of_each_kind) {
  test(`axe-core finds nothing serious on ${name}, light or dark.`, async () => {
    const page = await open_page(browser);
    await page.goto(address(name));
    await page.evaluate(axe.source);
    assert.deepEqual(await serious_violations(page, {}), [], 'light');
    // Dark changes the colours and the button, not the structure of the page.
    await page.locator('#dark').click();
    const changed = {runOnly: ['color-contrast', 'link-in-text-block', 'label-content-name-mismatch', 'button-name']};
    assert.deepEqual(await serious_violations(page, changed), [], 'dark');
    await page.context().close();
  });
}
