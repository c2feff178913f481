// The fonts come with the book, so that it looks the same on every machine. Each is cut down to the letters that the book has.
import {cpSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {spawnSync} from 'node:child_process';
import {pruned} from './prune_style.mjs';
import {BookError} from './results.mjs';

// A family of symbols has what the family before it lacks.
const faces = [
  {family: 'Book Text', weight: '400', style: 'normal', font: 'text', file: 'Lato-Regular.ttf'},
  {family: 'Book Text', weight: '400', style: 'italic', font: 'text', file: 'Lato-Italic.ttf'},
  {family: 'Book Text', weight: '600 900', style: 'normal', font: 'text', file: 'Lato-Bold.ttf'},
  {family: 'Book Symbols', weight: '400', style: 'normal', font: 'symbols', file: 'DejaVuSans.ttf', after: ['text', 'Lato-Regular.ttf']},
  {family: 'Book Code', weight: '400', style: 'normal', font: 'code', file: 'JetBrainsMono-Regular.ttf'},
  {
    family: 'Book Code Symbols',
    weight: '400',
    style: 'normal',
    font: 'symbols',
    file: 'DejaVuSansMono.ttf',
    after: ['code', 'JetBrainsMono-Regular.ttf'],
  },
];

const woff2 = file => `fonts/${file.replace(/\.\w+$/, '.woff2')}`;

/** Formulas have fonts of their own, which KaTeX's style sheet names; only the kind that every browser reads is kept. */
function katex_style(folder) {
  const style = readFileSync(join(folder, 'katex.min.css'), 'utf8');
  return style.replace(/,url\([^)]*\.(?:woff|ttf)["']?\) ?format\([^)]*\)/g, '');
}

/** Which fonts a reader will see. */
export const named = ({missing}) =>
  missing
    ? `those of the reader's machine, since this was not installed: ${missing}`
    : 'Lato, JetBrains Mono and DejaVu, and those of KaTeX, cut down to the letters of the book';

/** Writes fonts.css, katex/katex.min.css and all fonts that they name into the book's folder, whose pages are there already and have these `names`. */
export function write_fonts({fonts, katex, source, work}, folder, names) {
  const style = katex_style(katex);
  const of_formulas = [...new Set([...style.matchAll(/url\(["']?fonts\/([^"')]+\.woff2)/g)].map(match => match[1]))];
  mkdirSync(join(folder, 'katex/fonts'), {recursive: true});
  const own = fonts.missing ? [] : faces;
  if (fonts.missing) {
    for (const name of of_formulas)
      cpSync(join(katex, 'fonts', name), join(folder, 'katex/fonts', name), {dereference: true});
  } else {
    const jobs = of_formulas.map(name => ({from: join(katex, 'fonts', name), to: `katex/fonts/${name}`, without: null}));
    for (const {font, file, after} of own)
      jobs.push({from: join(fonts[font], file), to: woff2(file), without: after ? join(fonts[after[0]], after[1]) : null});
    const list = join(work, 'fonts.json');
    writeFileSync(list, JSON.stringify(jobs));
    const run = spawnSync(fonts.python, ['-B', join(source, 'book/tools/subset_fonts.py'), folder, list], {encoding: 'utf8'});
    if (run.error) throw run.error;
    if (run.status !== 0) throw new BookError(`the fonts could not be cut down: ${run.stderr.trim()}`);
  }
  writeFileSync(join(folder, 'katex/katex.min.css'), pruned(style, names));
  writeFileSync(
    join(folder, 'fonts.css'),
    own
      .map(
        ({family, weight, style: slant, file}) =>
          `@font-face { font-family: "${family}"; font-weight: ${weight}; font-style: ${slant}; src: url(${woff2(file)}) format("woff2"); }\n`,
      )
      .join(''),
  );
}
