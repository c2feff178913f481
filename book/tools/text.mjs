// Words and numbers on their way into HTML.

export function escape(text) {
  return text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');
}

export function unescape(text) {
  return text
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&quot;/g, '"')
    .replace(/&#39;/g, "'")
    .replace(/&#160;|&nbsp;/g, '\u00a0')
    .replace(/&amp;/g, '&');
}

export const capitalised = text => text.charAt(0).toUpperCase() + text.slice(1);

/** "a, b and c" */
export function listed(words) {
  return words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
}

export function counted(number, singular, plural = `${singular}s`) {
  return `${number} ${number === 1 ? singular : plural}`;
}

const superscripts = {'-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹'};
const number = /^(-?)(\d+(?:\.\d+)?)(?:e([+-]?\d+))?(?= |$)/;

/** A small power of ten is no power: 2.9e+00 is 2.9, and 4.3e-01 is 0.43. */
function plain_power([all, sign, digits, exponent]) {
  if (!exponent || Math.abs(Number(exponent)) > 2) return [all, sign, digits, exponent];
  const after = Math.max(0, (digits.split('.')[1]?.length ?? 0) - Number(exponent));
  return [all, sign, Number(`${digits}e${exponent}`).toFixed(after), undefined];
}

/** A value as a reader wants it: "-1.5e-05 m" becomes "−1.5 × 10⁻⁵ m", which does not break over lines. */
export function typeset(value) {
  const match = number.exec(value);
  if (!match) return value;
  const [all, sign, digits, exponent] = plain_power(match);
  const power = exponent && ` × 10${[...String(Number(exponent))].map(c => superscripts[c]).join('')}`;
  return ((sign ? '−' : '') + digits + (power ?? '') + value.slice(all.length)).replace(/ /g, '\u00a0');
}

/** The same inside a formula. */
export function typeset_in_formula(value) {
  const match = number.exec(value);
  if (!match) return value;
  const [all, sign, digits, exponent] = plain_power(match);
  const unit = value.slice(all.length).trim();
  return sign + digits + (exponent ? ` \\cdot 10^{${Number(exponent)}}` : '') + (unit ? `\\,\\mathrm{${unit}}` : '');
}

/** A cell of a table: programs write every digit they have, a reader gets five that count, but a whole number as it is. */
export function cell(value) {
  if (/^[-\d.e+]+(, [-\d.e+]+)+$/.test(value)) return value.split(', ').map(cell).join(', ');
  const short =
    /^-?\d+(\.\d*|(?=e))(e[+-]?\d+)?$/.test(value) && value.replace(/[^\d]/g, '').length > 6
      ? String(Number(Number(value).toPrecision(5)))
      : value;
  return typeset(short);
}

/** What a page says, without its tags. */
export function plain(html) {
  return unescape(html.replace(/<\/?(?:a|b|code|em|i|span|strong|sub|sup)\b[^>]*>/g, '').replace(/<[^>]*>/g, ' '))
    .replace(/\s+/g, ' ')
    .trim();
}

/** A heading as part of an address. */
export function slug(text) {
  return text
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, '_')
    .replace(/^_+|_+$/g, '');
}
