// The rules are tested: each broken page breaks one of them, and says so.
import assert from 'node:assert/strict';
import {cpSync, mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {after, test} from 'node:test';
import {faults, rules} from './rules.mjs';
import {read_book} from './page.mjs';

// [the rule, or RULE.css for a style sheet; what stands on the page; a part of what is said]
const broken = [
  ['every_check_has_a_verdict',
    '<div class="check">A sentence that says passed. <span class="verdict">in float and double</span></div>', 'no verdict: "A sentence that says passed.'],
  ['every_check_has_a_verdict', '<div class="check">A sentence that holds.</div>', 'no verdict: "A sentence that holds.'],
  ['every_code_in_a_line_is_marked', '<p>Type <span class="tt">./course</span>.</p>', 'code in a line is no <code>'],
  ['every_directive_is_expanded',
    '<p><span class="katex">L = {{value force_demo.error_10}}</span></p>', 'a directive was not expanded: "{{value force_demo.error_10}}'],
  ['every_directive_is_expanded',
    '<p>The error is {{value force_demo.error_10}}.</p>', 'a directive was not expanded: "{{value force_demo.error_10}}'],
  ['every_emphasis_is_set', '<p>*"Why does it explode?"* It does not.</p>', 'an emphasis was not set: "*"Why does it'],
  ['every_figure_says_what_it_shows', '<svg><text>Energy</text></svg>', 'has no alternative text'],
  ['every_figure_says_what_it_shows', '<img src="drawn.svg" alt="drawn.svg"/>', String.raw`only repeats its file's name`],
  ['every_figure_says_what_it_shows', '<img src="drawn.svg"/>', 'has no alternative text'],
  ['every_figure_says_what_it_shows',
    '<img src="drawn.svg" alt="parabola of a thrown ball, side view"/>', 'is not described by a sentence'],
  ['every_figure_says_what_it_shows', '<svg role="img" aria-label="A ball flies."></svg>', 'is described in 20 letters or fewer'],
  ['every_figure_says_what_it_shows',
    `<figure><figcaption>The explicit step gains energy</figcaption>
<svg role="img" aria-label="The explicit step gains energy."></svg></figure>`, 'only repeats its title'],
  ['every_fold_is_closed', '<details class="fold"><summary>The task</summary><p>All that follows is folded away.</p>', 'a fold is not closed'],
  ['every_formula_is_typeset',
    String.raw`<p>Newton: \f$ F = m a \f$.</p>`, String.raw`a formula was not typeset: "\f$ F = m a \f$`],
  ['every_formula_is_typeset', String.raw`<p>Newton: \( F = m a \).</p>`, String.raw`a formula was not typeset: "\( F = m a \)`],
  ['every_formula_is_valid',
    String.raw`<p><span class="katex"><span style="color:#cc0000">\frak</span></span></p>`, String.raw`KaTeX could not read "\frak"`],
  ['every_formula_is_valid',
    String.raw`<p><span class="katex-error" title="ParseError">\frac</span></p>`, String.raw`KaTeX could not read "\frac"`],
  ['every_id_is_unique', `<p id="axis">One.</p>
<p id="axis">Two.</p>`, 'the id "axis" stands on line 5 already'],
  ['every_link_leads_somewhere', '<a href="sound.html#gone">on</a>', '"sound.html#gone" leads to no anchor of sound.html'],
  ['every_link_leads_somewhere.css',
    String.raw`@font-face { src: url('font.woff2'); }`, '"font.woff2" leads to no file of the book'],
  ['every_link_leads_somewhere', '<a href="missing.html">on</a>', '"missing.html" leads to no file of the book'],
  ['every_link_leads_somewhere', '<a href="#gone">up</a>', '"#gone" leads to no anchor of'],
  ['every_link_leads_somewhere', '<script src="missing.js"></script>', '"missing.js" leads to no file of the book'],
  ['every_link_leads_somewhere',
    '<p style="background: url(missing.png)">A paragraph.</p>', '"missing.png" leads to no file of the book'],
  ['every_page_says_what_it_is_about', '<meta name="description" content="A page of chapter 11."/>', 'is no sentence: "A page of chapter 11."'],
  ['every_page_says_what_it_is_about', '<meta property="og:image" content="previews/gone.png"/>', 'its preview is missing: previews/gone.png'],
  ['every_player_has_a_still_picture',
    '<figure class="player"><div class="player-view"><svg aria-hidden="true" class="player-still"><polygon points="0,0 1,0 0,1"></polygon></svg></div></figure>', 'has no alternative text'],
  ['every_player_has_a_still_picture',
    '<figure class="player"><div role="img" aria-label="A ball flies along a parabola and lands."><div class="player-view"><svg class="player-still"></svg></div></div></figure>', 'the player has no still picture'],
  ['every_snippet_has_code', '<div class="fragment"><div class="line"> </div></div>', 'the snippet is empty'],
  ['no_page_answers_its_question',
    '<form class="prediction" data-prediction="far"><details><p>As far as 2.8 × 10⁸\u00a0m.</p></details></form><pre>end 2.776e+08 m</pre>', 'what answers "far" stands outside its gate: "280000000 m"'],
  ['no_page_answers_its_question',
    '<form class="prediction" data-prediction="which"><details><p>The hammer is heavier.</p></details></form><h2>The hammer is heavier</h2>', 'outside its gate: "The hammer is heavier."'],
  ['no_search_finds_a_spoiler',
    '<div class="gate"><p>The hidden answer is that the hammer is heavier than its handle.</p></div>', 'a search finds what is folded away: "The hidden answer'],
  ['no_search_finds_a_spoiler',
    '<details class="spoiler"><summary>Solution</summary><p>The hidden answer is that the hammer is heavier than its handle.</p></details>', 'a search finds what is folded away: "The hidden answer'],
  ['no_text_names_this_machine',
    '<p>Built in /home/reader/tumble/build.</p>', 'names a folder of the machine that made it, /home/reader/tumble'],
  ['nothing_refers_outside', '<a href="../README.md">up</a>', '"../README.md" leaves the book'],
  ['nothing_refers_outside.css',
    '@import "https://example.org/a.css";', '"https://example.org/a.css" would be loaded from outside'],
  ['nothing_refers_outside', '<a href="/usr/share/a.html">on</a>', '"/usr/share/a.html" leaves the book'],
  ['nothing_refers_outside',
    '<img src="http://example.org/a.png" alt="A ball flies along a parabola and lands."/>', '"http://example.org/a.png" would be loaded from outside'],
  ['nothing_refers_outside',
    '<link rel="stylesheet" href="//example.org/a.css"/>', '"//example.org/a.css" would be loaded from outside'],
  ['nothing_refers_outside', '<a href="http://example.org">on</a>', '"http://example.org" leaves the book'],
  ['nothing_refers_outside',
    '<script src="https://example.org/a.js"></script>', '"https://example.org/a.js" would be loaded from outside'],
];

const folder = mkdtempSync(join(tmpdir(), 'broken-'));
after(() => rmSync(folder, {recursive: true}));
cpSync(fileURLToPath(new URL('sound', import.meta.url)), folder, {recursive: true});
const files = broken.map(([name, text], i) => {
  const is_page = !name.endsWith('.css'), file = `${i}.${is_page ? 'html' : 'css'}`;
  writeFileSync(join(folder, file), is_page
    ? `<!DOCTYPE html>\n<html lang="en">\n<head><title>A page</title></head>\n<body>\n${text}\n</body>\n</html>\n` : text);
  return file;
});
const found = faults(read_book(folder, ['/home/reader/tumble']));

test('A sound page has no fault.', () => {
  assert.deepEqual(found.filter(({path}) => !files.includes(path)), []);
});

test('Every rule has a page that breaks it.', () => {
  assert.deepEqual([...new Set(broken.map(([name]) => name.split('.')[0]))].sort(), Object.keys(rules).sort());
});

broken.forEach(([name, text, announced], i) => {
  test(`${name} is broken by ${text}`, () => {
    const here = found.filter(({path}) => path === files[i]);
    assert.equal(here.length, 1, JSON.stringify(here));
    assert.equal(here[0].rule, name.split('.')[0]);
    assert.ok(here[0].problem.includes(announced), `${here[0].problem}\nshould say: ${announced}`);
  });
});
