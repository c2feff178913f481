// The exercises as exercises/tools describe them, and the section about them that ends a chapter's page.
import {existsSync} from 'node:fs';
import {join} from 'node:path';
import {spawnSync} from 'node:child_process';
import {BookError} from './results.mjs';
import {lines_of_plain_text} from './plain_text.mjs';
import {table} from './tables.mjs';
import {counted, escape, listed} from './text.mjs';

/** All of them, in the order in which they are meant to be done; none where the course has none. */
export function read_exercises({source, python}) {
  if (!existsSync(join(source, 'exercises/tools/for_the_book.py'))) return [];
  const run = spawnSync(python, ['-B', join(source, 'exercises/tools/for_the_book.py'), '--root', source], {
    encoding: 'utf8',
    maxBuffer: 1 << 26,
  });
  if (run.error) throw run.error;
  if (run.status !== 0) throw new BookError(run.stderr.trim().replaceAll(`${source}/`, ''));
  return JSON.parse(run.stdout);
}

export const kinds = {
  change: 'change a line',
  write: 'write code',
  derive: 'derive, then write',
  prove: 'write, and prove',
  lab: 'lab',
};

const page_of = chapter => `chapter_${chapter}.html`;

/** A link to where an exercise stands in the book. */
export function link_to({chapter, name, title}) {
  return `<a href="${page_of(chapter)}#exercise_${name}">${escape(title)}</a>`;
}

/** A chapter or an exercise that comes before: "03_inertia" or "03_inertia/hammer". */
function link_to_earlier(path, exercises, pages) {
  const found = exercises.find(exercise => exercise.path === path);
  if (found) return link_to(found);
  const chapter = pages.chapters.find(page => page.id === `chapter_${path}`);
  if (!chapter) throw new BookError(`an exercise asks for ${path}, which is no exercise and no chapter`);
  return `chapter <a href="${chapter.file}">${escape(chapter.name)}</a>`;
}

/** What opening a hint takes from the reader. */
const hint_titles = [
  'Hint 1 of 3: where to look',
  'Hint 2 of 3: takes the idea from you',
  'Hint 3 of 3: leaves you little but the typing',
];
const solution_title = 'Solution: leaves you nothing to find. Solve it first';

const block = html => ({html});
const text = words => ({text: words});
const blank = text('');

/** A fold that the search does not look into, and that stays closed on paper. */
const fold = (title, lines) => [
  block(`<details class="fold spoiler unindexed"><summary>${escape(title)}</summary>`),
  blank,
  ...lines,
  blank,
  block('</details>'),
];

const listing = ({file, code}) => [
  block(`<figure class="listing"><figcaption><code>${escape(file)}</code></figcaption>`),
  blank,
  text('```{.cpp}'),
  ...code.trimEnd().split('\n').map(line => text(line)),
  text('```'),
  blank,
  block('</figure>'),
];

function solution_of({solution}) {
  return fold(solution_title, [...listing(solution), blank, ...lines_of_plain_text(solution.why)]);
}

/** What a student is told, as a closed card under its facts: the task, the checks, the hints, and what else `more` has. */
function card(exercise, exercises, pages, more) {
  const before = exercise.prerequisites.map(path => link_to_earlier(path, exercises, pages));
  const checks = exercise.checks.map(({sentence, points}) => [sentence, String(points)]);
  return [
    block(
      `<p class="facts">${kinds[exercise.difficulty]} · ${counted(exercise.minutes, 'minute')} · ${counted(exercise.points, 'point')}` +
        `${before.length ? ` · after ${listed(before)}` : ''}<br>You will ${escape(exercise.goals.join('; '))}.</p>`,
    ),
    blank,
    block('<details class="fold task"><summary>The task</summary>'),
    blank,
    ...lines_of_plain_text(exercise.task),
    blank,
    text(`    ./course start ${exercise.name}`),
    blank,
    block(table('', [{text: 'what the checks hold you to'}, {text: 'points', is_number: true}], checks, 'table checks')),
    blank,
    ...exercise.hints.flatMap((hint, index) => [...fold(hint_titles[index], lines_of_plain_text(hint)), blank]),
    ...more,
    blank,
    block('</details>'),
    blank,
  ];
}

function lines_of_exercise(exercise, exercises, pages) {
  return [
    text(`### ${exercise.title} {#exercise_${exercise.name}}`),
    blank,
    ...card(exercise, exercises, pages, [
      ...(exercise.solution ? solution_of(exercise) : []),
    ]),
  ];
}

/** The lines that end a chapter's page. */
export function lines_of_section(page, exercises, pages) {
  const own = exercises.filter(exercise => exercise.chapter === page.chapter);
  if (!own.length) return [];
  return [
    blank,
    text(`## Exercises {#exercises_${page.chapter}}`),
    blank,
    text('These are judged. `./course start NAME` copies one to `work/`, and `./course watch NAME` gives the verdict each time you save'),
    text('your copy. \\ref exercises lists those of all chapters.'),
    blank,
    block('<p class="on-paper">Hints and solutions are folded away on the screen, and not printed: <code>./course hint NAME</code> gives one hint at a time.</p>'),
    blank,
    ...own.flatMap(exercise =>
      lines_of_exercise(exercise, exercises, pages).map(line => ({place: `exercises/${exercise.path}/exercise.json`, ...line})),
    ),
  ];
}

/** The lines of a page with {{task NAME}} replaced by what the exercise gives a student, in every edition alike: no solution. */
export function with_tasks(lines, exercises, pages) {
  return lines.flatMap(line => {
    const [, name] = /^\{\{task (\w+)\}\}\s*$/.exec(line.text ?? '') ?? [];
    if (!name) return [line];
    const exercise = exercises.find(each => each.name === name);
    if (!exercise) throw new BookError(`${line.place}: no exercise is called ${name}`);
    return [blank, ...card(exercise, exercises, pages, fold('The starter', listing(exercise.starter)))].map(each => ({place: line.place, ...each}));
  });
}
