// Times as one table: a row for each thing that was timed, its precisions side by side, the quick ones first.

const precisions = ['float', 'double'];
const precision_of = name => precisions.find(precision => name.endsWith(`, ${precision}`));

const shown = nanoseconds =>
  nanoseconds < 1000 ? `${Number(nanoseconds.toPrecision(2))}\u00a0ns` : `${Number((nanoseconds / 1000).toPrecision(2))}\u00a0µs`;

/** Two digits, and none that were not measured. */
const ratio = number => (number < 100 ? String(Number(number.toPrecision(2))) : String(Math.round(number / 10 ** (Math.floor(Math.log10(number)) - 1)) * 10 ** (Math.floor(Math.log10(number)) - 1)));

/** `costs` are {name, nanoseconds}; `familiar` is one of them, or of another chapter, that the last column counts in. */
export function table_of_costs(costs, familiar) {
  const rows = new Map();
  for (const {name, nanoseconds} of costs) {
    const precision = precision_of(name);
    const what = precision ? name.slice(0, -`, ${precision}`.length) : name;
    rows.set(what, {...rows.get(what), [precision ?? 'time']: nanoseconds});
  }
  const used = ['time', ...precisions].filter(column => [...rows.values()].some(row => column in row));
  const best_known = row => row.double ?? row.time ?? row.float;
  const sorted = [...rows].sort(([, one], [, other]) => best_known(one) - best_known(other));
  const columns = [{text: 'what'}, ...used.map(text => ({text, is_number: true}))];
  if (familiar) columns.push({text: 'in steps', is_number: true, is_unit: true});
  return {
    columns,
    rows: sorted.map(([what, row]) => [
      what,
      ...used.map(column => (column in row ? shown(row[column]) : '')),
      ...(familiar ? [ratio(best_known(row) / familiar.nanoseconds)] : []),
    ]),
  };
}
