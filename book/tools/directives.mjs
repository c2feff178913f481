// The directives of the book's Markdown, {{name arguments}}. Each is replaced on its own line, so that a line number
// in a warning of Doxygen is the author's. Doxygen sees a marker in place of each block; what the marker stands for
// waits in a list until Doxygen is done.
import {Blocks} from './blocks.mjs';
import {first_drawing} from './previews.mjs';
import {BookError} from './results.mjs';
import {escape, typeset, typeset_in_formula, unescape} from './text.mjs';

export class Directives {
  blocks = []; // the HTML that each marker stands for

  constructor(settings, results, pages, exercises) {
    this.makers = new Blocks(settings, results, pages, exercises);
  }

  /** The page's Markdown with every directive replaced; mistakes are added to `complaints`. */
  expand(page, complaints) {
    const first = this.blocks.length;
    const folds = [];
    const inside = {code: false, formula: false};
    const lines = page.lines.map(({text, html, place}) => {
      try {
        return html === undefined ? this.#expand_line(page, text, inside, folds, place) : this.#marker(html);
      } catch (error) {
        if (!(error instanceof BookError)) throw error;
        complaints.push(`${place}: ${error.message}`);
        return '';
      }
    });
    for (const {opened, place} of folds) complaints.push(`${place}: ${opened} has no {{end}}`);
    page.picture = first_drawing(this.blocks.slice(first).map(String), this.makers.cards);
    const answers = this.makers.answers(page, complaints);
    return [...lines, ...(answers ? ['', this.#marker(answers), ''] : [])].join('\n');
  }

  #expand_line(page, line, inside, folds, place) {
    if (/^\s*(```|~~~)/.test(line)) inside.code = !inside.code;
    const is_skipped = folds.at(-1)?.is_skipped;
    if (inside.code) return is_skipped ? '' : line;
    const block = /^(\s*)\{\{(?!(?:value|set)\b)(\w+)\s*(.*)\}\}\s*$/.exec(line);
    if (is_skipped) {
      if (['fold', 'gate', 'note', 'measured'].includes(block?.[2])) folds.push({opened: line.trim(), closing: '', place, is_skipped});
      else if (block?.[2] === 'end') folds.pop();
      return '';
    }
    if (block && !inside.formula) return block[1] + this.#block(page, block[2], block[3].trim(), folds, place);
    return line.split(/(\\f[$[\]])/).map(part => {
      if (part === '\\f$') inside.formula = !inside.formula;
      else if (part === '\\f[') inside.formula = true;
      else if (part === '\\f]') inside.formula = false;
      else return this.#values(page, part, inside.formula);
      return part;
    }).join('');
  }

  #values(page, text, in_formula) {
    const expanded = text.replace(/\{\{value\s+([^{}]*)\}\}/g, (_, name) => {
      const value = this.makers.value_of(page, name.trim());
      return in_formula ? typeset_in_formula(value) : escape(typeset(value)).replace(/\u00a0/g, '&nbsp;');
    });
    const linked = expanded.replace(/\{\{set\s+([^{}]*)\}\}/g, (_, link) => {
      this.blocks.push(this.makers.live_link(unescape(link)));
      return `\\htmlonly<tumble-block id="${this.blocks.length - 1}"></tumble-block>\\endhtmlonly`;
    });
    // A formula may hold double braces of its own, and how a task shows a number is told to whoever adds an exercise.
    const left = !in_formula && /\{\{(?!parameter name\}\})(\w*)/.exec(linked);
    if (left && left[1] in this.makers.kinds) throw new BookError(`{{${left[1]} ...}} must stand alone on one line`);
    if (left) throw this.#unknown(left[1]);
    return linked;
  }

  #block(page, name, argument, folds, place) {
    if (name === 'fold') {
      if (!argument) throw new BookError('{{fold}} needs a title: {{fold Title}}');
      folds.push({opened: `{{fold ${argument}}}`, closing: '</details>', place});
      return this.#marker(`<details class="fold${/^Hint\b/.test(argument) ? ' spoiler unindexed' : ''}"><summary>${escape(argument)}</summary>`);
    }
    if (name === 'gate') {
      const [opening, closing] = this.makers.gate(page, argument);
      folds.push({opened: `{{gate ${argument}}}`, closing, place});
      return this.#marker(opening);
    }
    if (name === 'note') {
      folds.push({opened: '{{note}}', closing: '</aside>', place});
      return this.#marker('<aside class="note">');
    }
    if (name === 'measured') {
      folds.push({opened: `{{measured ${argument}}}`, closing: '', place, is_skipped: !this.makers.is_measured(page, argument)});
      return '';
    }
    if (name === 'end') {
      if (!folds.length) throw new BookError('{{end}} closes no {{fold Title}}, no {{gate name}}, no {{note}} and no {{measured name}}');
      const {closing} = folds.pop();
      return closing && this.#marker(closing);
    }
    if (name === 'snippet') {
      const {caption, command} = this.makers.snippet(page, argument);
      return this.#marker(caption, 'listing') + command;
    }
    if (!(name in this.makers.kinds)) throw this.#unknown(name);
    return this.#marker(this.makers.kinds[name](page, argument, place));
  }

  #marker(html, kind = 'block') {
    this.blocks.push(html);
    return `\\htmlonly[block]<tumble-${kind} id="${this.blocks.length - 1}"></tumble-${kind}>\\endhtmlonly`;
  }

  #unknown(name) {
    const known = ['value', 'set', 'section', 'task', 'snippet', ...Object.keys(this.makers.kinds), 'fold', 'gate', 'note', 'measured', 'end'].join(', ');
    return new BookError(`unknown directive {{${name}}}; there are ${known}`);
  }
}
