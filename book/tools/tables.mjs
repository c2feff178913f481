// A table as HTML.
import {escape} from './text.mjs';

/** Nothing is torn between a factor and its power, a number and its unit, or a letter and its number; \u2060 joins what would part at a sign. */
const whole = text => text.replace(/ × /g, '\u00a0×\u00a0')
  .replace(/(\d) (?=(?:[nµm]?s|×|m|rad|J|kg)(?![\p{L}]))/gu, '$1\u00a0')
  .replace(/(?:(?<=\p{L}) )?(\d(?:\.\d+)?e[+-])(?=\d)/gu, (all, number) => `${all[0] === ' ' ? '\u00a0' : ''}${number}\u2060`);
const shown = cell => (typeof cell === 'string' ? escape(whole(cell)) : cell.html);

/** Without the rows and the columns that hold nothing beside their heading: what was not measured. */
export function without_empty({columns, rows}) {
  const full_rows = rows.filter(([, ...cells]) => !cells.length || cells.some(Boolean));
  const shown = columns.map((_, column) => column === 0 || full_rows.some(row => row[column]));
  const only_shown = cells => cells.filter((_, column) => shown[column]);
  return {columns: only_shown(columns), rows: full_rows.map(only_shown)};
}

/** Columns are {text, is_number}; a cell is a text or {html}. Rows of `sums` stand below a line. */
export function table(caption, columns, rows, kind = 'table', sums = []) {
  const mark = column => (columns[column].is_number ? ' class="number"' : '');
  const head = columns.map(({text}, column) => `<th scope="col"${mark(column)}>${escape(whole(text))}</th>`).join('');
  const are_cards = kind.includes('keys') || (columns.length > 4 && kind === 'table'); // where a phone has no room for the row
  const label = column => (are_cards ? ` data-label="${escape(columns[column].text)}"` : '');
  /** A sentence in place of numbers takes the room of all that it stands for. */
  const is_told = (row, column) => columns[column].is_number && /(\S+ ){3}/.test(row[column]) && row.slice(column + 1).every(cell => cell === '');
  const cells = row => {
    const told = row.findIndex((_, column) => is_told(row, column));
    const numbers = told < 0 ? row : row.slice(0, told);
    const rest = told < 0 ? '' : `<td colspan="${row.length - told}"${label(told)}>${shown(row[told])}</td>`;
    return numbers.map((cell, column) => `<td${mark(column)}${label(column)}>${shown(cell)}</td>`).join('') + rest;
  };
  const lines = some => some.map(row => `<tr>${cells(row)}</tr>`).join('');
  const foot = sums.length ? `<tfoot>${lines(sums)}</tfoot>` : '';
  return (
    `<figure class="${kind}">${caption ? `<figcaption>${caption}</figcaption>` : ''}<div class="scroll">` +
    `<table${are_cards ? ' class="many-columns"' : ''}><thead><tr>${head}</tr></thead><tbody>${lines(rows)}</tbody>${foot}</table></div></figure>`
  );
}
