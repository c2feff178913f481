// What tells of all exercises at once: the list, the weeks of a semester, and the wrong answers that are known.
import {link_to} from './exercises.mjs';
import {BookError} from './results.mjs';
import {table} from './tables.mjs';
import {counted, escape} from './text.mjs';

const sum = (exercises, what) => String(exercises.reduce((total, exercise) => total + exercise[what], 0));
const number = text => ({text, is_number: true});
const chapters_of = pages => pages.chapters.filter(page => !page.further);
const link_to_page = page => `<a href="${page.file}">${escape(page.name)}</a>`;

/** Every exercise, chapter by chapter. */
export function list_of_exercises(exercises, pages) {
  const row = exercise => [
    {html: `${link_to(exercise)}<span class="goals">${escape(exercise.goals.join('; '))}</span>`},
    exercise.difficulty, String(exercise.minutes), String(exercise.points),
  ];
  const columns = [{text: 'exercise'}, {text: 'kind'}, number('minutes'), number('points')];
  const tables = chapters_of(pages).map(page => {
    const own = exercises.filter(({chapter}) => chapter === page.chapter);
    const sums = [['together', '', sum(own, 'minutes'), sum(own, 'points')]];
    if (!own.length) return '';
    return `<h1>${escape(page.name)}</h1>${table('', columns, own.map(row), 'table exercises', sums)}`;
  });
  const labs = exercises.filter(({difficulty}) => difficulty === 'lab').length;
  return (
    `<p>${counted(exercises.length, 'exercise')}, ${counted(labs, 'lab')} among them: ` +
    `${sum(exercises, 'minutes')} minutes, ${sum(exercises, 'points')} points.</p>${tables.join('')}`
  );
}

/** "1; 2; 9 10" as weeks of chapters: every chapter once, in order. A bar in place of a semicolon parts two courses. */
function weeks_of(argument, pages) {
  const weeks = argument.split(/[;|]/).map(week => week.trim().split(/\s+/).map(Number));
  const chapters = chapters_of(pages), wanted = chapters.map(page => Number(page.chapter.slice(0, 2)));
  if (weeks.flat().join() !== wanted.join()) {
    throw new BookError(`{{semester ${argument}}} must name each chapter once and in order, the weeks parted by semicolons or one bar; the chapters ` +
      `are ${wanted.join(' ')}`);
  }
  return weeks.map(week => week.map(chapter => chapters[wanted.indexOf(chapter)]));
}

/** With a bar, the weeks before it are summed up as well: they make a course of their own. */
export function semester(argument, exercises, pages) {
  const of = chapters => exercises.filter(({chapter}) => chapters.some(page => page.chapter === chapter));
  const weeks = weeks_of(argument, pages);
  const rows = weeks.map((chapters, index) => {
    const own = of(chapters);
    const named = exercise => `${link_to(exercise)}&#160;(${exercise.minutes})`;
    return [String(index + 1), {html: chapters.map(link_to_page).join('<br>')}, {html: own.map(named).join(', ')},
      sum(own, 'minutes'), sum(own, 'points')];
  });
  const first = argument.split('|')[0].split(';').length;
  if (first < weeks.length) {
    const own = of(weeks.slice(0, first).flat());
    rows.splice(first, 0, ['', {html: `<em>so far, a course of ${first} weeks</em>`}, counted(own.length, 'exercise'), sum(own, 'minutes'), sum(own, 'points')]);
  }
  return table('', [number('week'), {text: 'lecture'}, {text: 'lab (minutes)'}, number('minutes'), number('points')], rows,
    'table semester', [['', 'together', '', sum(exercises, 'minutes'), sum(exercises, 'points')]]);
}

const emphasised = message => ({html: escape(message).replace(/\*(\w+)\*/g, '<em>$1</em>')});

/** A fold for each chapter, with what its exercises' checks recognise. */
export function wrong_answers(exercises, pages) {
  const columns = [{text: 'the mistake'}, {text: 'the check that turns red'}, {text: 'the message holds'}];
  const row = ({name, caught_by, message}) => [name.replace(/_/g, ' '), caught_by, emphasised(message)];
  return chapters_of(pages).map(page => {
    const own = exercises.filter(({chapter, wrong}) => chapter === page.chapter && wrong);
    const count = own.reduce((total, {wrong}) => total + wrong.length, 0);
    const tables = own.map(exercise => table(link_to(exercise), columns, exercise.wrong.map(row), 'table mistakes'));
    return count ? `<details class="fold unindexed"><summary>${escape(page.name)}: ${counted(count, 'mistake')}</summary>${tables.join('')}</details>` : '';
  }).join('');
}
