// What each directive shows: code, outputs, tables, figures, checks and costs of the chapters.
import {existsSync, readFileSync} from 'node:fs';
import {dirname, join, normalize} from 'node:path';
import {check_line, failed_line, folded_checks, verdict_of_all} from './checks.mjs';
import {live_figure, live_link} from './live.mjs';
import {list_of_exercises, semester, wrong_answers} from './exercise_tables.mjs';
import {figure} from './figures.mjs';
import {player} from './players.mjs';
import {group_of} from './pages.mjs';
import {answers, gate, prediction} from './predictions.mjs';
import {thumbnail} from './previews.mjs';
import {BookError, table_in} from './results.mjs';
import {table, without_empty} from './tables.mjs';
import {table_of_costs} from './costs.mjs';
import {scene_keys} from './scene_keys.mjs';
import {verdict_grid} from './verdict_grid.mjs';
import {capitalised, cell, escape, typeset} from './text.mjs';

/** A link to a line of a source; the address of the source's page is filled in once Doxygen has made it. */
function source_link(path, line, html) {
  return `<a href="source:${escape(path)}${line ? `#l${String(line).padStart(5, '0')}` : ''}">${html}</a>`;
}

const code = text => `<code>${escape(text)}</code>`;

/** "name | words" as [name, words] */
function parted(argument) {
  const bar = argument.indexOf('|');
  return bar < 0 ? [argument.trim(), ''] : [argument.slice(0, bar).trim(), argument.slice(bar + 1).trim()];
}

/** Tables that the book's build does not make: what was measured elsewhere, or for long, kept in the tree by the program that did. */
const kept_tables = {
  'bits.tried': 'tests/bits/tried.tsv',
  'colophon.compilers': 'tests/compilers/tried.tsv',
};

/** What times are compared with, so that one can picture them. */
const familiar = {
  benchmark: ['01_force', 'force_cost'],
  row: 'gravity as an acceleration and step, double',
  unit: "steps of chapter 1's falling particle, in double",
};

/** How long it takes: the chapters' prose at 120 words a minute, and the exercises' own minutes. */
function reading_time(pages, exercises) {
  const words = pages.chapters.reduce((sum, page) => sum + page.text.split(/\s+/).length, 0);
  const reading = Math.max(1, Math.round(words / 120 / 60));
  const own = Math.round(exercises.reduce((sum, {minutes}) => sum + minutes, 0) / 60);
  return {reading_hours: String(reading), exercise_hours: String(own), hours: String(reading + own)};
}

const unmeasured = what =>
  `<p class="unindexed">Not measured in this book, which a test made; <code>./course book</code> measures it: ${escape(what)}</p>`;

export class Blocks {
  live_scripts = new Map(); // what brings a figure to life: the text of a script by its file's name
  cards = new Map(); // by the block that shows a live figure, what stands for it on a card
  quoted = new Set(); // the checks, and the programs as CHAPTER/PROGRAM, that some page shows
  folded = new Set(); // the chapters that show all their other checks
  predictions = new Map(); // by their names, under which a browser keeps the answers

  constructor(settings, results, pages, exercises) {
    this.settings = settings;
    this.results = results;
    this.pages = pages;
    this.values = {colophon: settings.colophon, reading: reading_time(pages, exercises)}; // what no program wrote
    this.kinds = {
      output: (page, argument) => this.#output(page, argument),
      text: (_, argument) => this.#text(argument),
      table: (page, argument) => this.#table(page, argument),
      verdicts: (page, argument) => this.#verdicts(page, argument),
      figure: (page, argument) => this.#figure(page, argument),
      player: (page, argument) => this.#player(page, argument, 'player', 1),
      players: (page, argument) => this.#player(page, argument, 'players', 2),
      live: (page, argument) => this.#live(page, argument),
      predict: (page, argument, place) => this.#predict(page, argument, place),
      check: (page, argument) => this.#check(page, argument),
      other_checks: page => this.#other_checks(page),
      costs: (page, argument) => this.#costs(page, argument),
      sayings: () => this.#sayings(),
      say: (page, argument) => this.#say(page, argument),
      map: () => this.#map(),
      chapters: () => this.#chapters(),
      headers: () => this.#headers(),
      source: () => this.#source(),
      names: () => () => this.reference.names(), // once all pages are read
      scene_keys: () => scene_keys(settings.source),
      exercises: () => list_of_exercises(exercises, pages),
      semester: (_, argument) => semester(argument, exercises, pages),
      wrong_answers: () => wrong_answers(exercises, pages),
    };
  }

  /** [chapter, name]: "name" is of this page's chapter, "02_torque/name" of any. */
  #of(page, text) {
    const [, chapter = page.chapter, name] = /^(?:(\w+)\/)?(.*)$/s.exec(text);
    if (!chapter) throw new BookError(`"${text}" must name its chapter here, as in 01_force/${text}`);
    this.#folder(chapter);
    return [chapter, name];
  }

  /** Of a chapter, or of a tool. */
  #folder(chapter) {
    const rooms = [...this.settings.floors, ...this.settings.tools];
    const room = rooms.find(({name}) => name === chapter);
    if (!room) throw new BookError(`no chapter ${chapter}; there are ${rooms.map(({name}) => name).join(', ')}`);
    return room.folder;
  }

  #program_link(chapter, program) {
    const folder = this.#folder(chapter);
    const path = join(folder, `${program}.cpp`);
    if (existsSync(join(this.settings.source, path))) return source_link(path, 0, code(program));
    // The runs of a tool are called PROGRAM_WORD.
    const [tool] = program.split('_');
    const of_tool = join(folder, `${tool}.cpp`);
    if (!existsSync(join(this.settings.source, of_tool))) throw new BookError(`there is no program ${path}`);
    return source_link(of_tool, 0, code(tool));
  }

  #path(file) {
    // ccache makes the compiler see paths from the folder that it runs in.
    return file.replace(/^.*\/(?=(?:chapters|exact|tools)\/)/, '');
  }

  /** [program, name] of PROGRAM.NAME or CHAPTER/PROGRAM.NAME. */
  #named_value(argument, directive) {
    const [, ...names] = /^(?:\w+\/)?(\w+)\.(\w+)$/.exec(argument) ?? [];
    if (!names.length) throw new BookError(`{{${directive} ${argument}}} should read {{${directive} program.name}}`);
    return names;
  }

  is_measured(page, argument) {
    const [program, name] = this.#named_value(argument, 'measured');
    return this.results.is_measured(this.#of(page, argument)[0], program, name);
  }

  value_of(page, argument) {
    const [group, name] = this.#named_value(argument, 'value');
    if (!(group in this.values)) {
      const [chapter] = this.#of(page, argument);
      return this.results.value(chapter, group, name);
    }
    const value = this.values[group][name];
    if (value === undefined) {
      throw new BookError(`no value ${argument}; of ${group} there are: ${Object.keys(this.values[group]).join(', ')}`);
    }
    return value;
  }

  /** {caption, command}: Doxygen's command brings the code, with links to the reference. */
  snippet(page, argument) {
    const match = /^(\S+)\s+(\S+)$/.exec(argument);
    if (!match) throw new BookError(`{{snippet ${argument}}} should read {{snippet file tag}}`);
    const path = normalize(join(page.chapter ? dirname(page.path) : '.', match[1]));
    if (!existsSync(join(this.settings.source, path))) throw new BookError(`there is no file ${path}`);
    const lines = readFileSync(join(this.settings.source, path), 'utf8').split('\n').map(line => line.trim());
    const mark = `//! [${match[2]}]`;
    const marks = lines.flatMap((line, index) => (line === mark ? [index] : []));
    if (marks.length !== 2) {
      throw new BookError(`${path} must hold the line ${mark} before and after the code; it holds it ${marks.length} times`);
    }
    const first = lines.findIndex((line, index) => index > marks[0] && line && !line.startsWith('//! ['));
    if (first >= marks[1]) throw new BookError(`the snippet ${match[2]} of ${path} is empty`);
    const shown = /(?:(?:tumble|support)\/)?[^/]+$/.exec(path)[0];
    const reference = this.pages.headers.some(header => header.path === path) ? ` <span class="on-screen">· <a href="header:${escape(path)}">reference</a></span>` : '';
    return {caption: `${source_link(path, first + 1, code(shown))}, line ${first + 1}${reference}`, command: `\\snippet ${path} ${match[2]}`};
  }

  /** What a program printed: all of it, or one of the parts that empty lines divide it into. */
  #output(page, argument) {
    const [, called, part] = /^(.*?)(?:\s+(\d+))?$/.exec(argument);
    const [chapter, program] = this.#of(page, called);
    const text = this.results.text(chapter, program, '.txt', 'output of program').trimEnd();
    if (!text.trim()) throw new BookError(`the program ${program} printed nothing`);
    const parts = text.split(/\n{2,}/);
    if (part && !(part >= 1 && part <= parts.length)) throw new BookError(`{{output ${argument}}}: empty lines divide what ${program} prints into ${parts.length} parts`);
    const shown = part ? parts[part - 1] : text;
    this.quoted.add(`${chapter}/${program}`);
    return `<figure class="listing output"><figcaption>What ${this.#program_link(chapter, program)} prints${part > 1 ? ' then' : ''}</figcaption>` +
      `<pre class="unindexed${shown.split('\n').length > 15 ? ' long' : ''}">${escape(shown)}</pre></figure>${part > 1 ? '' : this.#complaint(chapter, program)}`;
  }

  /** A file of the tree as it is, such as what a test knows that a tool prints. */
  #text(argument) {
    const [path, caption] = parted(argument);
    const file = join(this.settings.source, path);
    if (!caption || !existsSync(file)) throw new BookError(`{{text ${argument}}} should read {{text FILE | caption}}, with a file of the course`);
    return `<figure class="listing output"><figcaption>${escape(caption)}</figcaption>` +
      `<pre class="unindexed">${escape(readFileSync(file, 'utf8').trimEnd())}</pre></figure>`;
  }

  /** In red, what a program expected in vain. */
  #complaint(chapter, program) {
    const complaint = this.results.complaint(chapter, program);
    return complaint === undefined ? '' : failed_line(this.#program_link(chapter, program), complaint);
  }

  #table(page, argument) {
    const [reference, caption] = parted(argument);
    if (this.#is_unmeasured(page, reference)) return unmeasured(caption);
    const {columns, rows} = without_empty(reference in kept_tables
      ? table_in(readFileSync(join(this.settings.source, kept_tables[reference]), 'utf8'))
      : this.results.table(...this.#of(page, reference)));
    // Most cells are numbers: a word among them, such as "rounding", stands where its number would.
    const is_number = (_, column) => {
      const filled = rows.map(row => row[column]).filter(text => text && !/^[-–]$/.test(text)); // a dash tells nothing
      return filled.filter(text => /^-?[\d.]+(e[+-]?\d+)?( ?(×|%|[nµm]?s))?$/.test(text)).length * 2 >= Math.max(1, filled.length);
    };
    return table(escape(caption), columns.map((text, column) => ({text, is_number: is_number(text, column)})),
      rows.map(row => row.map(cell)));
  }

  #verdicts(page, argument) {
    // The name of a row may hold bars, as in |L|, but none between blanks.
    const [, references, rows, caption] = /^(.+?)(?: \| rows=(.+?))? \| (?!rows=)(.+)$/.exec(argument) ?? [];
    const parts = (references ?? '').split(',').map(part => /^\s*(\S+) as (.+?)\s*$/.exec(part)?.slice(1));
    if (!caption || parts.some(part => !part)) {
      throw new BookError(`{{verdicts ${argument}}} should read {{verdicts table as heading, other as its heading | caption}}, or ` +
        '{{verdicts table as heading | rows=one; other | caption}}');
    }
    const tables = parts.map(([name]) => ({name, ...this.results.table(...this.#of(page, name))}));
    return verdict_grid(tables, parts.map(([, heading]) => heading), caption, rows?.split(';').map(row => row.trim()));
  }

  /** [what stands before the bar, the words behind it with their values] */
  #described(page, argument, directive, name) {
    const [reference, description] = parted(argument);
    if (!description) {
      throw new BookError(`{{${directive} ${argument}}} should read {{${directive} ${name} | what it shows, for those who cannot see it}}`);
    }
    const says = description.replace(/\{\{value\s+([^{}]*)\}\}/g, (_, value) => typeset(this.value_of(page, value.trim())));
    if (says.includes('{{')) {
      throw new BookError(`the description of a ${directive} may hold {{value program.name}} and no other directive`);
    }
    return [reference, says];
  }

  #player(page, argument, directive, count) {
    const shape = count === 1 ? 'recording' : 'one recording, the other';
    const [reference, says] = this.#described(page, argument, directive, shape);
    const names = reference.split(',').map(name => name.trim());
    if (names.length !== count) {
      throw new BookError(`{{${directive} ${argument}}} should read {{${directive} ${shape} | what it shows, for those who cannot see it}}`);
    }
    const recordings = names.map(reference_to_one => {
      const [chapter, name] = this.#of(page, reference_to_one);
      return {name, text: this.results.text(chapter, name, '.recording.json', 'recording')};
    });
    return player(recordings, says, this.settings.source);
  }

  /** Whether this build went without the measurements from which it is made. */
  #is_unmeasured(page, reference) {
    return this.results.unmeasured.includes(/^(\w+)\//.exec(reference)?.[1] ?? page.chapter);
  }

  #figure(page, argument) {
    const [reference, says] = this.#described(page, argument, 'figure', 'name');
    if (this.#is_unmeasured(page, reference)) return unmeasured(says);
    const [chapter, name] = this.#of(page, reference);
    const {title, svg} = figure(this.results.text(chapter, name, '.svg', 'figure'), says, name);
    return `<figure class="drawing"><figcaption>${escape(title)}</figcaption><div class="scroll">${svg}</div></figure>`;
  }

  #live(page, argument) {
    const [reference, says] = this.#described(page, argument, 'live', 'name');
    const [chapter, name] = this.#of(page, reference);
    const {html, script, card} = live_figure({
      name,
      file: join(this.settings.results, chapter, `${name}.live.js`),
      printed: this.results.text(chapter, name, '.live.json', 'live figure'),
      module: join(this.settings.results, chapter, `${name}.wasm`),
      says,
      source: this.settings.source,
    });
    if (script) this.live_scripts.set(`live_${name}.js`, script);
    this.cards.set(html, card);
    return html;
  }

  #predict(page, argument, place) {
    const [name, question, choices, answer] = argument.split('|').map(part => part.trim());
    if (!answer || !/^\w+$/.test(name)) {
      throw new BookError(`{{predict ${argument}}} should read {{predict name | question | choice; other choice | what happens}}, or ` +
        '"number unit" in place of the choices');
    }
    if (this.predictions.has(name)) throw new BookError(`there is a prediction "${name}" already; browsers keep the answers by this name`);
    const [shown, told] = [question, answer].map(text =>
      text.replace(/\{\{value\s+([^{}]*)\}\}/g, (_, value) => typeset(this.value_of(page, value.trim()))));
    this.predictions.set(name, {page, place, question: shown, answer: told, is_gated: false});
    return prediction(name, shown, choices.split(';').map(choice => choice.trim()), told);
  }

  /** [opening, closing] of what stays shut until the reader has answered. */
  gate(page, name) {
    const asked = this.predictions.get(name);
    if (asked?.page !== page) throw new BookError(`{{gate ${name}}} shuts what answers a prediction, and no prediction "${name}" stands before it on this page`);
    const is_near = !asked.is_gated; // the question stands just above its first gate
    asked.is_gated = true;
    return gate(name, asked.question, is_near);
  }

  /** The answers of a page's predictions, each of which must have a gate; a mistake is added to `complaints`. */
  answers(page, complaints) {
    const asked = [...this.predictions].filter(([, each]) => each.page === page);
    for (const [name, {place, is_gated}] of asked)
      if (!is_gated) complaints.push(`${place}: the prediction "${name}" has no gate; what answers it stands between {{gate ${name}}} and {{end}}`);
    return asked.length ? answers(page.name, asked.map(([, each]) => each)) : '';
  }

  /** {{set NAME knob=value&other=value | words}} inside a sentence. */
  live_link(argument) {
    const match = /^(\w+) ([^|]+=[^|\s]+) \| (.+)$/.exec(argument.trim());
    if (!match) throw new BookError(`{{set ${argument}}} should read {{set figure knob=value&other=value | words of the link}}`);
    return live_link(match[1], match[2], match[3]);
  }

  #check(page, argument) {
    const is_prefixed = [...this.settings.floors, ...this.settings.tools].some(({name}) => argument.startsWith(`${name}/`));
    const [chapter, sentence] = is_prefixed || !page.chapter ? this.#of(page, argument) : [page.chapter, argument];
    const all = this.results.checks(chapter);
    const matches = all.filter(check => check.sentence === sentence);
    if (matches.length !== 1) {
      const which = matches.length
        ? `They stand at ${matches.map(({file, line}) => `${this.#path(file)}:${line}`).join(' and ')}`
        : `Its checks are:\n${all.map(check => `    ${check.sentence}`).join('\n')}`;
      throw new BookError(`${matches.length} checks of ${chapter} are named "${sentence}"; it must be exactly one. ${which}`);
    }
    this.quoted.add(matches[0]);
    return check_line(matches[0], this.#path(matches[0].file), source_link);
  }

  /** All checks of the chapter that no page of it quotes, in one line that opens. Which they are is known once every page is read. */
  #other_checks(page) {
    if (!page.chapter) throw new BookError('{{other_checks}} stands on a page of a chapter, whose other checks it lists');
    const all = this.results.checks(page.chapter);
    this.folded.add(page.chapter);
    return () => {
      const others = all.filter(check => !this.quoted.has(check));
      return folded_checks(others, this.#kind(page.chapter), check => check_line(check, this.#path(check.file), source_link), file => this.#path(file));
    };
  }

  /** The verdicts of a chapter in one line. */
  verdict(chapter) {
    const checks = this.results.checks(chapter);
    return checks.length ? verdict_of_all(checks, this.#kind(chapter)) : '';
  }

  /** Checks are a chapter's, or those of a tool, which has one page. */
  #kind(chapter) {
    return this.settings.tools.some(({name}) => name === chapter) ? 'page' : 'chapter';
  }

  /** The failed checks and programs of a chapter that its pages do not show. */
  unquoted_failures(chapter) {
    const checks = this.results.checks(chapter)
      .filter(check => !check.passed && !this.quoted.has(check) && !this.folded.has(chapter))
      .map(check => check_line(check, this.#path(check.file), source_link));
    const programs = this.results.names(chapter, '.failed').filter(program => !this.quoted.has(`${chapter}/${program}`))
      .map(program => this.#complaint(chapter, program));
    return [...checks, ...programs].join('');
  }

  #costs(page, argument) {
    const [chapter, program] = this.#of(page, argument);
    const link = this.#program_link(chapter, program);
    const costs = this.results.costs(chapter, program);
    if (!costs) return `<p>${link} was not run: Google Benchmark was not installed when this book was built.</p>`;
    const {columns, rows} = table_of_costs(costs, this.results.costs(...familiar.benchmark)?.find(({name}) => name === familiar.row));
    const unit = columns.at(-1).is_unit ? `; the last column counts ${familiar.unit}` : '';
    return table(`Time measured by ${link} on the machine that built this book${unit}`, columns, rows, 'table unindexed');
  }

  /** From the top floor to the ground: each chapter with its question and the headers that it adds. */
  #map() {
    const item = page => {
      const own = this.pages.headers.filter(header => header.page === page);
      const links = own.filter(({is_brought}) => !is_brought).map(({path, name}) => `<a href="header:${escape(path)}"><code>${escape(name.replace('tumble/', ''))}</code></a>`);
      const adds = links.length ? `<span class="headers">${links.join(', ')}</span>` : '';
      return `<li><a href="${page.file}">${escape(page.name)}</a><br>${escape(page.question ?? '')}${adds}</li>`;
    };
    return `<ol class="map">${this.pages.chapters.filter(page => !page.further).reverse().map(item).join('')}</ol>`;
  }

  /** Where a reader of this book gets the course, if git knows it. */
  #source() {
    const {commit} = this.values.colophon;
    if (commit.startsWith('none')) return '';
    const [name] = escape(commit).split(',');
    return `<p><span class="on-screen"><a href="tumble.zip">The whole course</a> is in this book, as commit ${name}. Unpack it, and in its folder:</span>` +
      `<span class="on-paper">In the folder of the course, which is commit ${name}:</span></p>`;
  }

  #headers() {
    const {headers} = this.pages;
    const chapters = [...new Set(headers.map(({page}) => page))];
    const item = ({path, name, brief}) => `<li><a href="header:${escape(path)}"><code>${escape(name)}</code></a>: ${escape(brief)}</li>`;
    return chapters
      .map(page => {
        const title = page ? escape(page.title) : 'What every chapter uses';
        const own = headers.filter(header => header.page === page);
        const parts = own.filter(({is_brought}) => is_brought);
        const fold = parts.length
          ? `<details class="fold"><summary>${parts.length} more, which come with these</summary><ul class="headers">${parts.map(item).join('')}</ul></details>`
          : '';
        return `<h2><a class="anchor" id="${group_of({page})}"></a>${title}</h2><ul class="headers">${own.filter(({is_brought}) => !is_brought).map(item).join('')}</ul>${fold}`;
      })
      .join('');
  }

  /** A card for each chapter: its opening picture and its question, once all pages are read. */
  #chapters() {
    const item = page =>
      `<li><a href="${page.file}">${thumbnail(page)}<b>${escape(page.name)}</b><span>${escape(capitalised(page.question ?? ''))}</span></a></li>`;
    return () => `<ol class="chapters unindexed">${this.pages.chapters.filter(page => !page.further).map(item).join('')}</ol>`;
  }

  /** What one can say after each chapter, as a list. */
  #sayings() {
    const item = ({name, say}) => `<li value="${/^\d+/.exec(name)}">${say}</li>`;
    return () => `<ol class="sayings unindexed">${this.pages.chapters.filter(page => page.say).map(item).join('')}</ol>`;
  }

  /** What a reader of the page can say. */
  #say(page, argument) {
    if (page.say) throw new BookError('a page says once what its reader can say');
    page.say = escape(argument).replace(/\{\{value\s+([^{}]*)\}\}/g, (_, value) => escape(typeset(this.value_of(page, value.trim()))));
    return `<p class="say">${page.say}</p>`;
  }
}
