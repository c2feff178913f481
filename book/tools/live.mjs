// Figures that one can touch: their files for the book, and what stands on a page.
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import vm from 'node:vm';
import '../player/vectors.js';
import '../player/solids.js';
import '../player/camera.js';
import '../player/scene.js';
import '../live/module.js';
import '../live/plot.js';
import '../live/still.js';
import {light_palette} from './players.mjs';
import {BookError, table_in} from './results.mjs';
import {escape} from './text.mjs';

const live = globalThis.tumble_live;

/** {script, style}: what every live figure needs, each kind as one. */
export function live_files(source) {
  const folder = join(source, 'book/live');
  const text = name => readFileSync(join(folder, name), 'utf8');
  return {script: ['module.js', 'plot.js', 'still.js', 'figure.js'].map(text).join('\n'), style: text('live.css')};
}

/** The figure's description, from its own script. */
function described(file, name) {
  if (!existsSync(file)) throw new BookError(`there is no file ${file}, which says how the live figure "${name}" is drawn`);
  vm.runInThisContext(readFileSync(file, 'utf8'), {filename: file});
  if (!live.figures[name]) throw new BookError(`${file} must set tumble_live.figures.${name}`);
  return live.figures[name];
}

/**
 * The tables that a figure draws from besides its columns, {NAME: {columns, rows}}, as the programs of its chapter wrote them to
 * `folder`. One that nobody wrote, such as of a contest that lacks a library, is absent, and the figure says so.
 */
export function tables_of(figure, folder) {
  const files = (figure.tables ?? []).map(name => [name, join(folder, `${name}.tsv`)]);
  return Object.fromEntries(files.filter(([, file]) => existsSync(file)).map(([name, file]) => [name, table_in(readFileSync(file, 'utf8'))]));
}

/**
 * {html, script, card}: what stands on the page, the text of the script that brings it to life, undefined without a module, and the
 * drawing of a card.
 * `printed` is what the figure's program printed, `module` the file of its module, `says` tells what one sees.
 */
export function live_figure({name, file, printed, module, says, source}) {
  const figure = described(file, name);
  const run = live.run_of_program(printed);
  for (const knob of run.knobs)
    if (!figure.knobs[knob.name]) throw new BookError(`${file} describes no knob "${knob.name}"; its program has it`);
  live.tables = tables_of(figure, dirname(module));
  live.asks = false;
  const still = live.still_of(figure, run, light_palette(source));
  const card = live.still_of(figure, run, light_palette(source), {of_card: true});
  const tables = figure.tables ? `tumble_live.tables = {...tumble_live.tables, ...${JSON.stringify(live.tables)}};\n` : '';
  const script = existsSync(module)
    ? `${readFileSync(file, 'utf8')}${tables}tumble_live.modules.${name} = '${readFileSync(module).toString('base64')}';\n`
    : undefined;
  const absent = script ? '' : '<p class="live-absent">This figure moves where the book is built with clang’s packages for ' +
    'WebAssembly; here they were missing, so it shows its first picture.</p>';
  const set = run.knobs.map(({name: knob, start, unit}) => {
    const {label, choices, words} = figure.knobs[knob];
    const value = choices ? choices[start] : words ? words(start) : live.with_unit(start, unit, 4);
    return `${symbols(label)}: ${symbols(value)}`;
  });
  const knobs = set.length ? `<p class="on-paper">${set.join('; ')}.</p>` : '';
  const html = `<figure class="live${live.asks ? ' asks' : ''}${figure.timeline ? ' timeline' : ''} unindexed" id="live_${name}" data-live="${name}"${script ? ` data-script="live_${name}.js"` : ''}>` +
    `<figcaption>${escape(figure.title)}</figcaption>` +
    `<div class="live-picture" role="img" aria-label="${escape(says)}">${still}</div>${knobs}${absent}</figure>`;
  return {html, script, card};
}

/** A label with its symbols set: *h* is one. */
const symbols = label => escape(label).replace(/\*(.+?)\*/g, '<i>$1</i>');

/** A link in a sentence that sets knobs, such as "h=0.1&rule=2". */
export function live_link(name, changes, words) {
  return `<a class="live-set" href="#live_${name}" data-set="${escape(changes)}">${escape(words)}</a>`;
}
