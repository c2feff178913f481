// Formulas that the exercises write in plain text are set as a reader of the terminal reads them.
import assert from 'node:assert/strict';
import {with_quotes} from '../../book/tools/quotes.mjs';
import {test} from 'node:test';
import {formula_of_plain_text} from '../../book/tools/plain_formula.mjs';
import {lines_of_plain_text} from '../../book/tools/plain_text.mjs';

const bare = tex => tex.replace(/\s+/g, ' ').trim();
const set = (...lines) => bare(/\\\[(.*)\\\]/s.exec(formula_of_plain_text(lines))[1].replace(/&amp;/g, '&'));

test('Letters, signs, powers and indices are those of the text.', () => {
  const cases = [
    ['v_p = V + ω × p', 'v_{p} = V + \\omega \\times p'],
    ['ω = L / I₁ + ω₃ k', '\\omega = L / I_{1} + \\omega _{3} k'],
    ['r = q p*', 'r = q p^{*}'],
    ["v'² + w² h²/4", "v'^{2} + w^{2} h^{2}/4"],
    ['e^(−(k + 1) t)', 'e^{-(k + 1) t}'],
    ['√(2 (h) / g)', '\\sqrt{2 (h) / g}'],
    ['I⁻¹ (1 − 2⁻ᵖ)', 'I^{-1} (1 - 2^{-p})'],
    ['F = τ / (l sin θ)', 'F = \\tau / (l \\sin \\theta )'],
  ];
  for (const [text, tex] of cases) assert.equal(set(text), tex);
});

test('Words between the letters stay words, and what stands far apart goes apart.', () => {
  assert.equal(set('c from the common centre d'), 'c \\;\\text{from the common centre}\\; d');
  assert.equal(set('a = 1        b = 2'), 'a = 1 \\qquad b = 2');
  const long = set('d/dt (1/u) = c/m        1/u(t) = 1/u(0) + c t/m        u(t) = u(0)');
  assert.equal(long.split('\\\\').length, 3);
});

test('Lines below each other have their signs of equality below each other.', () => {
  assert.equal(set('v = a', 'x    = b'), '\\begin{aligned}v &= a \\\\ x &= b\\end{aligned}');
  assert.equal(set('v = a', 'x'), '\\begin{aligned}v &= a \\\\ &x\\end{aligned}');
});

test('What is set off is a command, code or a formula; a heading is none of the page.', () => {
  const text = '# Why\n\n    x = v t\n\n    return x;\n\n    ./course next\n\nRead *"this"*.';
  const lines = lines_of_plain_text({text, file: 'why.md', line: 1});
  assert.deepEqual(lines.filter(line => line.html ?? line.text).map(({html, text: words}) => (html ? 'formula' : words)),
    ['**Why**', 'formula', '```{.cpp}', 'return x;', '```', '    ./course next', 'Read <em>"this"</em>.']);
  assert.equal(lines.at(-1).place, 'why.md:9');
});

test('Within a sentence powers are raised, indices lowered and differences taken; code stays as it is.', () => {
  const set_line = text => lines_of_plain_text({text, file: 'why.md', line: 1}).map(line => line.text).join('\n');
  assert.equal(set_line('e^(-κt) and ω_k² of m_a v_a - V, d^(3/2)'),
    'e<sup>−κt</sup> and ω<sub>k</sub>² of m<sub>a</sub> v<sub>a</sub> − V, d<sup>3/2</sup>');
  assert.equal(set_line('weight_i and time_step'), 'weight_i and time_step');
  assert.equal(set_line('Say `a_b - c^d`.'), 'Say \\htmlonly<code>a_b - c^d</code>\\endhtmlonly.');
  assert.equal(set_line('Say `a -\nb` or `tumble::a`.'), 'Say `a -\nb` or `tumble::a`.');
});

test('Quotation marks and apostrophes are set as they are printed, and code keeps its own.', () => {
  assert.equal(with_quotes(`<p title="a 'b'">"It's <i>so</i>", he said: ('no').</p><pre>"it's"</pre><p>"<code>'x'</code>'s"</p>`),
    `<p title="a 'b'">“It’s <i>so</i>”, he said: (‘no’).</p><pre>"it's"</pre><p>“<code>'x'</code>’s”</p>`);
  assert.equal(with_quotes(`<span class="katex"><span>f'</span></span>'s "`), `<span class="katex"><span>f'</span></span>’s “`);
});
