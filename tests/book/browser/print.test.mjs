// On paper nothing is cut off and no box is empty; the cheat sheet has one.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {address, launch, open_page} from './browser.mjs';
import {reading_pages} from './pages.mjs';

// A4 less the margins of print.css, in the pixels of a style sheet: 96 to the inch.
const paper = Math.floor((210 - 2 * 24) / 25.4 * 96);

let browser, page;
before(async () => {
  browser = await launch();
  page = await open_page(browser, {viewport: {width: paper, height: 900}});
  await page.emulateMedia({media: 'print'});
});
after(() => browser.close());

/// What reaches beyond the paper's edge; a formula carries its MathML where nobody sees it.
function what_is_cut(width) {
  return [...document.querySelectorAll('main *')].filter(element => {
    const {right, width: own, height} = element.getBoundingClientRect();
    return own > 1 && height > 1 && right > width + 1 && element.checkVisibility() && !element.closest('.katex-mathml, svg svg, .katex svg');
  }).slice(0, 5).map(element => `${Math.round(element.getBoundingClientRect().right)}: ${element.outerHTML.slice(0, 90)}`);
}

/// Folds that are printed as a title with nothing below it, where something is folded away that a reader of paper lacks.
function empty_folds() {
  return [...document.querySelectorAll('details.fold:not(.others)')].filter(fold => fold.checkVisibility() &&
    [...fold.children].slice(1).every(child => !child.checkVisibility() || child.getBoundingClientRect().height === 0))
    .map(fold => fold.querySelector('summary').textContent);
}

for (const name of reading_pages) {
  test(`${name}: nothing is cut off on paper, and no box is empty.`, async () => {
    await page.goto(address(name));
    assert.deepEqual(await page.evaluate(what_is_cut, paper), []);
    assert.deepEqual(await page.evaluate(empty_folds), []);
  });
}

test('The cheat sheet is printed on one page.', async () => {
  await page.goto(address('cheat_sheet.html'));
  const pdf = (await page.pdf({preferCSSPageSize: true})).toString('latin1');
  assert.equal(pdf.match(/\/Type \/Page\b/g).length, 1);
});
