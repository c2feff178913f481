// What the build found out: values, tables, outputs, costs and the verdicts of the checks.
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {unescape} from './text.mjs';

/** A mistake of an author, told with what was expected instead. */
export class BookError extends Error {}

const known = names => (names.length ? `there are: ${names.join(', ')}` : 'there are none');

export function table_in(text) {
  const [columns, ...rows] = text.replace(/\n+$/, '').split('\n').map(line => line.split('\t'));
  return {columns, rows};
}

export class Results {
  #cache = new Map();

  /** A chapter must have a report of its checks; of the `tools` some have none, and of those that are `unmeasured` no numbers. */
  constructor(folder, tools = [], unmeasured = []) {
    this.folder = folder;
    this.tools = tools.map(({name}) => name);
    this.unmeasured = unmeasured;
  }

  names(chapter, ending) {
    const folder = join(this.folder, chapter);
    if (!existsSync(folder)) return [];
    return readdirSync(folder)
      .filter(name => name.endsWith(ending))
      .map(name => name.slice(0, -ending.length));
  }

  text(chapter, name, ending, kind) {
    const file = join(this.folder, chapter, name + ending);
    if (!this.#cache.has(file)) {
      if (!existsSync(file))
        throw new BookError(`no ${kind} "${name}" in chapter ${chapter}; ${known(this.names(chapter, ending))}`);
      this.#cache.set(file, readFileSync(file, 'utf8'));
    }
    return this.#cache.get(file);
  }

  table(chapter, name, ending = '.tsv', kind = 'table') {
    return table_in(this.text(chapter, name, ending, kind));
  }

  value(chapter, program, name) {
    if (this.unmeasured.includes(chapter)) return '–';
    const value = this.#written(chapter, program, name);
    if (!value)
      throw new BookError(`program ${program} did not measure "${name}"; what is said of it stands between {{measured ${program}.${name}}} and {{end}}`);
    return value;
  }

  /** Whether there is such a value; where something was not measured, its program writes an empty one. */
  is_measured(chapter, program, name) {
    return !this.unmeasured.includes(chapter) && this.#written(chapter, program, name) !== '';
  }

  #written(chapter, program, name) {
    const {rows} = this.table(chapter, program, '.values.tsv', 'values of program');
    const row = rows.find(cells => cells[0] === name);
    if (!row)
      throw new BookError(`program ${program} wrote no value "${name}"; ${known(rows.map(cells => cells[0]))}`);
    return row[1];
  }

  /**
   * [{name, nanoseconds}], or undefined where Google Benchmark did not measure. A benchmark that counts the bodies it
   * treats tells the time of one body.
   */
  costs(chapter, name) {
    if (!existsSync(join(this.folder, chapter, `${name}.json`))) return undefined;
    const scale = {ns: 1, us: 1e3, ms: 1e6, s: 1e9};
    return JSON.parse(this.text(chapter, name, '.json', 'costs'))
      .benchmarks.filter(run => run.aggregate_name === 'median')
      .sort((one, other) => one.family_index - other.family_index) // as written; they were run in a random order
      .map(run => ({
        name: run.run_name.replace(/\/real_time$/, ''), // which says by which clock it was timed
        nanoseconds: run.items_per_second ? 1e9 / run.items_per_second : run.cpu_time * scale[run.time_unit],
      }));
  }

  /** What a program expected in vain, or undefined if it ended well. */
  complaint(chapter, program) {
    if (!existsSync(join(this.folder, chapter, `${program}.failed`))) return undefined;
    const said = this.text(chapter, program, '.failed', 'failure of program').trim();
    return said.replaceAll('\n', '; ') || 'it broke off';
  }

  /** Every check of a chapter: its sentence, where it stands and how it went in each precision. */
  checks(chapter) {
    if (this.tools.includes(chapter) && !this.names(chapter, '.xml').includes('checks')) return [];
    const key = `checks of ${chapter}`;
    if (!this.#cache.has(key))
      this.#cache.set(key, read_checks(this.text(chapter, 'checks', '.xml', 'report'), chapter));
    return this.#cache.get(key);
  }
}

function read_checks(xml, chapter) {
  if (!xml.trimEnd().endsWith('</doctest>'))
    throw new BookError(
      `the checks of chapter ${chapter} broke off: their report has no end. Run ${chapter}_checks to see why`,
    );
  const checks = new Map();
  for (const [, attributes, body] of xml.matchAll(/<TestCase ([^>]*(?:"[^"]*"[^>]*)*?[^/])>\n(.*?)<\/TestCase>/gs)) {
    const attribute = name => unescape(new RegExp(`\\b${name}="([^"]*)"`).exec(attributes)?.[1] ?? '');
    const [, sentence, precision] = /^(.*?)(?:<([^<>]*)>)?$/s.exec(attribute('name'));
    const key = `${sentence}\n${attribute('filename')}\n${attribute('line')}`;
    if (!checks.has(key))
      checks.set(key, {sentence, file: attribute('filename'), line: Number(attribute('line')), runs: []});
    const summary = /<OverallResultsAsserts successes="(\d+)" failures="(\d+)" test_case_success="(\w+)"/.exec(body);
    const assertions = Number(summary?.[1] ?? 0) + Number(summary?.[2] ?? 0);
    const complaints = [
      ...body.matchAll(
        /<Expression [^>]*?line="(\d+)"[^>]*>\s*<Original>(.*?)<\/Original>\s*(?:<Expanded>(.*?)<\/Expanded>)?/gs,
      ),
    ].map(([, line, original, expanded]) => ({
      line,
      original: unescape(original.trim()),
      expanded: unescape((expanded ?? '').trim()),
    }));
    if (assertions === 0) complaints.push({line: attribute('line'), original: 'it asserts nothing', expanded: ''});
    checks.get(key).runs.push({precision, assertions, passed: summary?.[3] === 'true' && assertions > 0, complaints});
  }
  return [...checks.values()].map(check => ({...check, passed: check.runs.every(run => run.passed)}));
}
