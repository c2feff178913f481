// Verdicts as a grid: a row for each method, a column for each case in each precision, coloured and lettered.
import {BookError} from './results.mjs';
import {escape, typeset} from './text.mjs';

/** What a cell such as "✗ L 4e-01" says: the letter of the grid, a word for its colour, and the sentence for who asks. */
function read(cell, place) {
  const [, sign, kind, number] = /^([✓✗])(?: (E|L|φ|step))? ?(.*)$/u.exec(cell) ?? [];
  if (!sign) throw new BookError(`${place}: a verdict reads ✓ or ✗, then E, L, φ or "step" with a number; it is "${cell}"`);
  const what = {E: 'energy', L: 'angular momentum', φ: 'phase', step: 'diverged at step'}[kind] ?? '';
  const said = `${sign === '✓' ? 'passed' : 'failed'}: ${what} ${typeset(number)}`.replace(': finite', ', finite').trim();
  if (sign === '✓') return {letter: '✓', colour: 'passed', said};
  return kind === 'step' ? {letter: 'D', colour: 'diverged', said} : {letter: kind, colour: {E: 'energy', L: 'momentum', φ: 'phase'}[kind], said};
}

const key = [
  ['✓', 'passed', 'passed'],
  ['E', 'energy', 'wrong in the energy'],
  ['L', 'momentum', 'in the angular momentum'],
  ['φ', 'phase', 'in the phase'],
  ['D', 'diverged', 'it diverged'],
];

/** The table with the rows that bear these names, in their order. */
function with_rows(table, wanted) {
  const row_of = name => {
    const row = table.rows.find(([own]) => own === name);
    if (!row) throw new BookError(`${table.name} has no row "${name}"; its rows are: ${table.rows.map(([own]) => own).join('; ')}`);
    return row;
  };
  return {...table, rows: wanted.map(row_of)};
}

/**
 * `whole` are {name, columns, rows} alike, one for each precision; `names` what stands above each of their columns; `wanted` the
 * names of the rows to show, without which all are.
 */
export function verdict_grid(whole, names, caption, wanted = undefined) {
  const tables = wanted ? whole.map(table => with_rows(table, wanted)) : whole;
  const [first] = tables;
  for (const {name, columns, rows} of tables)
    if (columns.join() !== first.columns.join() || rows.map(([row]) => row).join() !== first.rows.map(([row]) => row).join())
      throw new BookError(`the verdicts of ${name} have other rows or columns than those of ${first.name}`);
  const cases = first.columns.slice(1);
  const head =
    `<tr><th scope="col" rowspan="2">${escape(first.columns[0])}</th>` +
    `${cases.map(each => `<th scope="colgroup" colspan="${tables.length}">${escape(each)}</th>`).join('')}</tr>` +
    `<tr>${cases.map(() => names.map(name => `<th scope="col">${escape(name)}</th>`).join('')).join('')}</tr>`;
  const cell = (table, row, column) => {
    const {letter, colour, said} = read(table.rows[row][column], `${table.name}, ${table.rows[row][0]}`);
    return `<td class="v ${colour}" title="${escape(said)}">${letter}</td>`;
  };
  const line = (cells, row) =>
    `<tr><th scope="row">${escape(cells[0])}</th>${cases.map((_, n) => tables.map(table => cell(table, row, n + 1)).join('')).join('')}</tr>`;
  const legend = key.map(([letter, colour, text]) => `<span class="v ${colour}">${letter}</span> ${text}`).join(' &#160; ');
  return (
    `<figure class="table verdicts unindexed"><figcaption>${escape(caption)}<br><span class="key">${legend}</span></figcaption><div class="scroll">` +
    `<table><thead>${head}</thead><tbody>${first.rows.map(line).join('')}</tbody></table></div></figure>`
  );
}
