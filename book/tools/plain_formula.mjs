// From a formula in plain text, "v_p = V + ω × p", to TeX.
import {escape} from './text.mjs';

const raised = '⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵖᵀ',
  raised_as = '0123456789+-pT';
const lowered = '₀₁₂₃₄₅₆₇₈₉ᵢⱼ',
  lowered_as = '0123456789ij';
const functions = new Set(['sin', 'cos', 'tan', 'log', 'ln', 'exp', 'atan']);
const signs = {
  '×': '\\times ', '·': '\\cdot ', '−': '-', '∫': '\\int ', 'Σ': '\\sum ', '…': '\\dots ', '½': '\\tfrac12 ', '*': '^{*}', '%': '\\%',
  'α': '\\alpha ', 'κ': '\\kappa ', 'λ': '\\lambda ', 'μ': '\\mu ', 'ω': '\\omega ', 'Ω': '\\Omega ', 'φ': '\\varphi ', 'τ': '\\tau ',
  'θ': '\\theta ', 'π': '\\pi ',
};

const translated = (run, from, to) => [...run].map(letter => to[from.indexOf(letter)]).join('');

/** Where the bracket that opens at `start` closes. */
function end_of_bracket(text, start) {
  let depth = 0;
  for (let n = start; n < text.length; ++n) {
    if (text[n] === '(') ++depth;
    if (text[n] === ')' && --depth === 0) return n;
  }
  throw new Error(`the bracket in "${text.slice(start)}" does not close`);
}

const parts = [
  // Words between the letters of a formula, such as "from the common centre c".
  [/^([A-Za-z]{2,}(?:'s)?)(?: +[A-Za-z]{2,}(?:'s)?)*/, ([words]) => {
    if (functions.has(words)) return words === 'atan' ? '\\arctan ' : `\\${words} `;
    const differentials = words.split(' ').every(word => /^d[a-z]$/.test(word));
    return differentials ? words.replace(/ /g, '\\,') : `\\;\\text{${words}}\\;`;
  }],
  [new RegExp(`^[${raised}]+`), ([run]) => `^{${translated(run, raised, raised_as)}}`],
  [new RegExp(`^[${lowered}]+`), ([run]) => `_{${translated(run, lowered, lowered_as)}}`],
  [/^_([A-Za-z0-9])/, ([, letter]) => `_{${letter}}`],
];

function tex_of(text) {
  let tex = '';
  for (let n = 0; n < text.length; ) {
    const rest = text.slice(n);
    const grouped = /^(\^|√)\(/.exec(rest);
    if (grouped) {
      const end = end_of_bracket(text, n + 1);
      tex += `${grouped[1] === '√' ? '\\sqrt' : '^'}{${tex_of(text.slice(n + 2, end))}}`;
      n = end + 1;
      continue;
    }
    const part = parts.map(([pattern, made]) => [pattern.exec(rest), made]).find(([match]) => match);
    if (part) {
      tex += part[1](part[0]);
      n += part[0][0].length;
    } else {
      tex += signs[text[n]] ?? text[n];
      ++n;
    }
  }
  return tex;
}

/** Lines of plain formulas as one that is displayed. What stands far apart in a line goes to lines of its own. */
export function formula_of_plain_text(lines) {
  const bare = lines.map(line => line.replace(/ +=/g, ' ='));
  const rows = bare.flatMap(line => (line.length > 48 ? line.split(/ {3,}/) : [line]));
  const row = text => text.split(/ {3,}/).map(tex_of).join(' \\qquad ');
  const aligned = tex => (tex.includes('=') ? tex.replace('=', '&=') : `&${tex}`);
  const body =
    rows.length === 1
      ? row(rows[0])
      : `\\begin{aligned}${rows.map(text => aligned(row(text))).join(' \\\\ ')}\\end{aligned}`;
  return `<p class="formulaDsp">\\[${escape(body)}\\]</p>`;
}
