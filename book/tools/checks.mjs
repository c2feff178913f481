// A check on a page: its sentence, its verdict in each precision, and what failed.
import {counted, escape, listed} from './text.mjs';

function counts(runs) {
  const numbers = [...new Set(runs.map(run => run.assertions))];
  if (runs.length === 1) return counted(numbers[0], 'assertion');
  return numbers.length === 1
    ? `${counted(numbers[0], 'assertion')} each`
    : `${listed(runs.map(run => String(run.assertions)))} assertions`;
}

function verdict(word, runs) {
  const precisions = runs.map(run => run.precision).filter(Boolean);
  return `<b>${word}</b>${precisions.length ? ` in ${escape(listed(precisions))}` : ''}`;
}

/** One line for a check that passed; a failed one also says which expression failed and with which values. */
export function check_line(check, path, source_link) {
  const passed = check.runs.filter(run => run.passed),
    failed = check.runs.filter(run => !run.passed);
  const verdicts = [failed.length && verdict('failed', failed), passed.length && verdict('passed', passed)].filter(
    Boolean,
  );
  const complaints = failed.flatMap(run =>
    run.complaints
      .slice(0, 3)
      .map(
        complaint =>
          `<li>${escape(run.precision ?? '')} ${source_link(path, complaint.line, `line ${complaint.line}`)}: <code>${escape(complaint.original)}</code>` +
          `${complaint.expanded ? ` was <code>${escape(complaint.expanded)}</code>` : ''}</li>`,
      ),
  );
  return (
    `<div class="check ${check.passed ? 'passed' : 'failed'}"><span class="mark" aria-hidden="true">${check.passed ? '✓' : '✗'}</span>` +
    `<div>${source_link(path, check.line, escape(check.sentence))} <span class="verdict">${verdicts.join(', ')}; ${counts(check.runs)}</span>` +
    `${complaints.length ? `<ul>${complaints.join('')}</ul>` : ''}</div></div>`
  );
}

/** The same for a program that expected something in vain. */
export function failed_line(program_link, complaint) {
  return (
    `<div class="check failed"><span class="mark" aria-hidden="true">✗</span>` +
    `<div>${program_link} <span class="verdict"><b>failed</b>; ${escape(complaint)}</span></div></div>`
  );
}

/** "passed in float and double", or how many failed. */
function summary(checks) {
  const failed = checks.filter(check => !check.passed).length;
  const precisions = [...new Set(checks.flatMap(({runs}) => runs.map(({precision}) => precision)).filter(Boolean))];
  const where = precisions.length ? ` in ${listed(precisions)}` : '';
  return failed ? `<b class="red">${failed} failed</b>, ${checks.length - failed} passed${where}` : `<b>all passed</b>${where}`;
}

const comparisons = checks =>
  checks.reduce((sum, {runs}) => sum + runs.reduce((all, {assertions}) => all + assertions, 0), 0).toLocaleString('en-GB');

/** One line for many checks, which opens; it is open where one failed. They stand by the file that holds them. */
export function folded_checks(checks, where, line_of, path_of) {
  if (!checks.length) return '';
  const files = [...new Set(checks.map(({file}) => path_of(file)))];
  const group = file =>
    `<p class="file"><code>${escape(file.replace(/^.*\//, ''))}</code></p>` +
    checks.filter(check => path_of(check.file) === file).map(line_of).join('');
  const open = checks.some(check => !check.passed) ? ' open' : '';
  return (
    `<details class="fold others"${open}><summary>The other ${counted(checks.length, 'check')} of this ${where}: ` +
    `<span class="verdict">${summary(checks)}</span></summary>${files.map(group).join('')}</details>`
  );
}

/** The last line of a chapter, or of a tool's page: all its checks, and how they went. */
export function verdict_of_all(checks, where) {
  const failed = checks.filter(check => !check.passed).length;
  return (
    `<p class="verdict-of-all${failed ? ' failed' : ''}">${failed ? '✗' : '✓'} ${counted(checks.length, 'check')} of this ${where}: ` +
    `${summary(checks)}; ${comparisons(checks)} comparisons, made by the build of this book.</p>`
  );
}
