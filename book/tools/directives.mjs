// The directives of the book's Markdown: {{name arguments}}. Each is replaced on its own line, so that a line number in a
// warning of Doxygen is the author's. What a block directive stands for waits in a list until Doxygen is done; Doxygen sees
// a marker.
import { existsSync, readFileSync } from 'node:fs';
import { join, normalize } from 'node:path';
import { spawnSync } from 'node:child_process';
import { BookError } from './results.mjs';
import { cell, escape, typeset, typeset_in_formula } from './text.mjs';
import { check_line } from './checks.mjs';
import { figure, graph } from './figures.mjs';
import { map_of_chapters } from './chapter_map.mjs';

const source_link = (path, line, text) =>
  `<a href="source:${escape(path)}${line ? `#l${String(line).padStart(5, '0')}` : ''}">${text}</a>`;
const code = (text) => `<code>${escape(text)}</code>`;

/** Expands the pages of one book. `blocks` receives the HTML that each marker stands for. */
export class Directives {
  blocks = [];
  quoted = new Set();  // the checks that some page shows

  constructor(settings, results, pages) {
    this.settings = settings;
    this.results = results;
    this.pages = pages;
    this.values = { colophon: settings.colophon, reading: reading_time(pages) };  // what no program wrote
  }

  /** The page's Markdown with every directive replaced; mistakes are added to `complaints`. */
  expand(page, complaints) {
    const folds = [];
    let fenced = false;
    let formula = false;
    const lines = page.text.split('\n').map((line, index) => {
      const complain = (error) => {
        if (!(error instanceof BookError)) throw error;
        complaints.push(`${page.path}:${index + 1}: ${error.message}`);
        return '';
      };
      if (/^\s*(```|~~~)/.test(line)) fenced = !fenced;
      if (fenced) return line;
      try {
        const block = /^(\s*)\{\{(?!value\b)(\w+)\s*(.*)\}\}\s*$/.exec(line);
        if (block && !formula) return block[1] + this.#block(page, block[2], block[3].trim(), folds, index + 1);
        // Formulas may hold double braces of their own; there a directive is a value or it is none.
        return line.split(/(\\f[$[\]])/).map((part) => {
          if (part === '\\f$') formula = !formula;
          else if (part === '\\f[') formula = true;
          else if (part === '\\f]') formula = false;
          else return this.#inline(page, part, formula);
          return part;
        }).join('');
      } catch (error) {
        return complain(error);
      }
    });
    for (const { title, line } of folds) complaints.push(`${page.path}:${line}: {{fold ${title}}} has no {{end}}`);
    return lines.join('\n');
  }

  #inline(page, text, formula) {
    return text.replace(/\{\{(\w+)([^{}]*)\}\}?/g, (all, name, argument) => {
      if (name === 'value') {
        const value = this.#value(page, argument.trim());
        return formula ? typeset_in_formula(value) : escape(typeset(value)).replace(/\u00a0/g, '&nbsp;');
      }
      if (formula) return all;
      throw new BookError(this.#knows(name) ? `{{${name}}} must stand alone on its line` : this.#unknown(name));
    });
  }

  #knows(name) {
    return ['snippet', 'output', 'table', 'figure', 'check', 'costs', 'fold', 'end', 'map', 'chapters'].includes(name);
  }

  #unknown(name) {
    return `unknown directive {{${name}}}; there are snippet, output, value, table, figure, check, costs, fold, end, map and chapters`;
  }

  #block(page, name, argument, folds, line) {
    if (name === 'snippet') return this.#snippet(page, argument);
    return this.#marker(this.#block_html(page, name, argument, folds, line));
  }

  #marker(html, kind = 'block') {
    this.blocks.push(html);
    return `\\htmlonly[block]<tumble-${kind} id="${this.blocks.length - 1}"></tumble-${kind}>\\endhtmlonly`;
  }

  #block_html(page, name, argument, folds, line) {
    switch (name) {
      case 'output': return this.#output(page, argument);
      case 'table': return this.#table(page, argument);
      case 'figure': return this.#figure(page, argument);
      case 'check': return this.#check(page, argument);
      case 'costs': return this.#costs(page, argument);
      case 'map': return this.#map();
      case 'chapters': return this.#chapters();
      case 'fold':
        if (!argument) throw new BookError('{{fold}} needs a title: {{fold Title}}');
        folds.push({ title: argument, line });
        return `<details class="fold"><summary>${escape(argument)}</summary>`;
      case 'end':
        if (!folds.pop()) throw new BookError('{{end}} closes no {{fold Title}}');
        return '</details>';
      default: throw new BookError(this.#unknown(name));
    }
  }

  /** "program" of this page's chapter, or "02_torque/program" of any. */
  #of(page, text) {
    const slash = text.indexOf('/');
    const chapter = slash < 0 ? page.chapter : text.slice(0, slash);
    if (!chapter) throw new BookError(`"${text}" must name its chapter here, as in 01_force/${text || 'name'}`);
    return [chapter, text.slice(slash + 1)];
  }

  #source(chapter, file) {
    const floor = this.settings.floors.find((each) => each.name === chapter);
    if (!floor) throw new BookError(`no chapter ${chapter}; there are ${this.settings.floors.map((each) => each.name).join(', ')}`);
    const path = join(floor.folder, file);
    if (!existsSync(join(this.settings.source, path))) throw new BookError(`there is no file ${path}`);
    return path;
  }

  #value(page, argument) {
    const [group, name] = argument.split('.');
    if (this.values[group]) {
      const value = this.values[group][name];
      if (value === undefined)
        throw new BookError(`no value ${argument}; of ${group} there are: ${Object.keys(this.values[group]).join(', ')}`);
      return value;
    }
    const match = /^(?:(\w+)\/)?(\w+)\.(\w+)$/.exec(argument);
    if (!match) throw new BookError(`{{value ${argument}}} should read {{value program.name}}`);
    const [chapter] = this.#of(page, match[1] ? `${match[1]}/` : '');
    return this.results.value(chapter, match[2], match[3]);
  }

  #snippet(page, argument) {
    const match = /^(\S+)\s+(\S+)$/.exec(argument);
    if (!match) throw new BookError(`{{snippet ${argument}}} should read {{snippet file tag}}`);
    const home = page.path.startsWith('book/') ? '.' : page.path.slice(0, page.path.lastIndexOf('/'));
    const path = normalize(join(home, match[1]));
    const file = join(this.settings.source, path);
    if (!existsSync(file)) throw new BookError(`there is no file ${path}`);
    const lines = readFileSync(file, 'utf8').split('\n');
    const mark = `//! [${match[2]}]`;
    const marks = lines.flatMap((text, index) => (text.trim() === mark ? [index] : []));
    if (marks.length !== 2)
      throw new BookError(`${path} must hold the line ${mark} twice, around the code; it holds it ${marks.length} times`);
    const is_code = (text) => text.trim() && !text.trim().startsWith('//! [');
    const first = lines.findIndex((text, index) => index > marks[0] && is_code(text));
    if (first < 0 || first >= marks[1]) throw new BookError(`the snippet ${match[2]} of ${path} is empty`);
    const shown = path.replace(/^(?:chapters|common)\/(?:[^/]+\/)?(?=(?:tumble|course)\/)/, '').replace(/^.*\/(?=[^/]+\.cpp$)/, '');
    const caption = `${source_link(path, first + 1, code(shown))}, line ${first + 1}`;
    return `${this.#marker(caption, 'listing')}\\snippet ${path} ${match[2]}`;
  }

  #output(page, argument) {
    const [chapter, program] = this.#of(page, argument);
    const text = this.results.text(chapter, program, '.txt', 'output of program');
    if (!text.trim()) throw new BookError(`the program ${program} printed nothing`);
    return '<figure class="listing output"><figcaption>' +
      `What ${source_link(this.#source(chapter, `${program}.cpp`), 0, code(program))} prints</figcaption>` +
      `<pre class="unindexed">${escape(text.trimEnd())}</pre></figure>`;
  }

  #table(page, argument) {
    const [reference, caption] = split(argument);
    const { columns, rows } = this.results.table(...this.#of(page, reference));
    const numeric = columns.map((_, column) => rows.every((row) => /^-?[\d.]+(e[+-]?\d+)?$|^$/.test(row[column])));
    const align = (column) => (numeric[column] ? ' class="number"' : '');
    return `<figure class="table">${caption ? `<figcaption>${escape(caption)}</figcaption>` : ''}<div class="scroll"><table>` +
      `<thead><tr>${columns.map((text, column) => `<th scope="col"${align(column)}>${escape(text)}</th>`).join('')}</tr></thead><tbody>` +
      rows.map((row) => `<tr>${row.map((text, column) => `<td${align(column)}>${escape(cell(text))}</td>`).join('')}</tr>`).join('') +
      '</tbody></table></div></figure>';
  }

  #figure(page, argument) {
    const [reference, description] = split(argument);
    if (!description)
      throw new BookError(`{{figure ${argument}}} should read {{figure name | what it shows, for those who cannot see it}}`);
    const says = description.replace(/\{\{value\s+([^{}]*)\}\}/g, (_, name) => typeset(this.#value(page, name.trim())));
    if (says.includes('{{')) throw new BookError('the description of a figure may hold {{value program.name}} and no other directive');
    const [chapter, name] = this.#of(page, reference);
    const { title, svg } = figure(this.results.text(chapter, name, '.svg', 'figure'), says, name);
    return `<figure class="drawing"><figcaption>${escape(title)}</figcaption><div class="scroll">${svg}</div></figure>`;
  }

  #check(page, argument) {
    const prefixed = /^(\d\d_\w+)\/(.*)$/.exec(argument);
    const chapter = prefixed?.[1] ?? page.chapter;
    if (!chapter) throw new BookError('a check must name its chapter here, as in {{check 01_force/The sentence}}');
    const sentence = prefixed?.[2] ?? argument;
    const all = this.results.checks(chapter);
    const matches = all.filter((check) => check.sentence === sentence);
    if (matches.length !== 1)
      throw new BookError(`${matches.length} checks of ${chapter} are named "${sentence}"; there must be exactly one. ` +
        (matches.length ? `They stand at ${matches.map((check) => `${this.#path(check.file)}:${check.line}`).join(' and ')}`
          : `Its checks are:\n${all.map((check) => `    ${check.sentence}`).join('\n')}`));
    this.quoted.add(matches[0]);
    return check_line(matches[0], this.#path(matches[0].file), source_link);
  }

  #path(file) {
    return file.startsWith(`${this.settings.source}/`) ? file.slice(this.settings.source.length + 1) : file;
  }

  /** The failed checks of a chapter that its pages do not quote. */
  unquoted_failures(chapter) {
    const failures = this.results.checks(chapter).filter((check) => !check.passed && !this.quoted.has(check));
    return failures.map((check) => check_line(check, this.#path(check.file), source_link)).join('');
  }

  #costs(page, argument) {
    const [chapter, program] = this.#of(page, argument);
    const source = source_link(this.#source(chapter, `${program}.cpp`), 0, code(program));
    const costs = this.results.costs(chapter, program);
    if (!costs) return `<p>${source} was not run: Google Benchmark was not installed when this book was built.</p>`;
    const time = (nanoseconds) => (nanoseconds < 1000 ? `${Number(nanoseconds.toPrecision(2))} ns`
      : `${Number((nanoseconds / 1000).toPrecision(2))} µs`).replace(' ', '\u00a0');
    return `<figure class="table unindexed"><figcaption>Time measured by ${source} on the machine that built this book</figcaption>` +
      '<div class="scroll"><table><thead><tr><th scope="col">what</th><th scope="col" class="number">time</th></tr></thead><tbody>' +
      costs.map((cost) => `<tr><td>${escape(cost.name)}</td><td class="number">${time(cost.nanoseconds)}</td></tr>`).join('') +
      '</tbody></table></div></figure>';
  }

  #map() {
    const drawn = spawnSync(this.settings.dot, ['-Tsvg'], { input: map_of_chapters(this.settings, this.pages), encoding: 'utf8' });
    if (drawn.status !== 0) throw new BookError(`Graphviz could not draw the map: ${drawn.stderr}`);
    return `<figure class="drawing map"><div class="scroll">${graph(drawn.stdout, 'The chapters, each standing on the one below it')}</div></figure>`;
  }

  #chapters() {
    return `<ol class="chapters">${this.pages.chapters.filter((page) => !page.further).map((page) =>
      `<li><a href="${page.file}">${escape(page.name)}</a>${page.question ? ` <span>${escape(page.question)}</span>` : ''}</li>`).join('')}</ol>`;
  }
}

function split(argument) {
  const bar = argument.indexOf('|');
  return bar < 0 ? [argument.trim(), ''] : [argument.slice(0, bar).trim(), argument.slice(bar + 1).trim()];
}

/** How long the chapters take: the prose at 120 words a minute, and half as long again at the reader's own machine. */
function reading_time(pages) {
  const words = pages.chapters.reduce((sum, page) => sum + page.text.split(/\s+/).length, 0);
  const minutes = Math.max(10, Math.round(words / 120 / 10) * 10);
  return { minutes_reading: String(minutes), hours: String(Math.ceil((minutes * 2.5) / 60)) };
}
