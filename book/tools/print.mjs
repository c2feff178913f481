// The whole book in one PDF: node print.mjs SETTINGS.json. Chromium prints it to see which chapters leave a few lines for their last
// sheet, then to see on which page each section lies, and with those numbers until they are true.
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {spawnSync} from 'node:child_process';
import {places_of_destinations} from './pdf.mjs';
import {escape, plain} from './text.mjs';

const settings = JSON.parse(readFileSync(process.argv[2], 'utf8'));
const {date, commit} = JSON.parse(readFileSync(settings.colophon, 'utf8'));
const order = JSON.parse(readFileSync(join(settings.folder, 'reading_order.json'), 'utf8')).filter(
  page => !['reference', 'names', 'handbook'].includes(page.id), // the last is for instructors, and not for what they hand out
);

/** On paper the landing page follows the title page, which has said what it begins with. */
const at_a_glance = 'At a glance';

/** What the list of contents tells of a page: the sections of a chapter within the parts that all chapters have, and the parts of another page. */
function sections_of(body, id) {
  const level = id.startsWith('chapter_') ? 'h3' : 'h2';
  return [...body.matchAll(new RegExp(`<${level} id="([^"]*)">([\\s\\S]*?)<a class="anchorlink"`, 'g'))].filter(([, name]) => !/--(exercise_|read_find)/.test(name));
}

/** A page's title and contents; what had an address of its own gets one that is unique in the whole. */
function part_of({file, id, further}) {
  const html = readFileSync(join(settings.folder, file), 'utf8');
  const title = id === 'mainpage' ? at_a_glance : /<h1>([\s\S]*?)<\/h1>/.exec(html)[1];
  const contents = html.slice(
    html.indexOf('<div class="contents">'),
    html.search(/<nav class="neighbours"|<\/main>/),
  );
  const body = contents
    .replace(/<details/g, '<details open')
    .replace(/ id="([^"]*)"/g, (_, name) => ` id="${id}--${name}"`)
    .replace(/ href="#([^"]*)"/g, (_, name) => ` href="#${id}--${name}"`)
    .replace(/url\(#([^)]*)\)/g, (_, name) => `url(#${id}--${name})`)
    .replace(/<a href="[^"#:]+\.zip">([\s\S]*?)<\/a>/g, '$1') // which paper has not beside it
    .replace(/<a [^>]*href="([^"#:]+\.html)(?:#([^"]*))?"[^>]*>([\s\S]*?)<\/a>/g, (_, target, name, text) => {
      const page = order.find(each => each.file === target);
      return page ? `<a class="elsewhere" href="#${page.id}${name ? `--${name}` : ''}">${text}</a>` : text;
    });
  return {id, title, body, further, sections: sections_of(body, id)};
}

/** Above each sheet stands what it belongs to; a chapter's further pages follow its first one on the same sheets. */
const running_head = ({id, title}) =>
  `@page ${id} { @top-left { content: ${JSON.stringify(plain(title))}; font: 8.5pt Lato, sans-serif; color: #444; } }`;

/** The chapters, each with its further pages. */
const groups_of = parts => {
  const groups = [];
  for (const part of parts) {
    if (!part.further) groups.push([]);
    groups.at(-1).push(part);
  }
  return groups;
};

/** Whether less than a tenth of a chapter's last sheet is used, which it then need not have. */
function ends_in_a_few_lines([{id}], places) {
  const [begin, end] = [places.get(id), places.get(`${id}--end`)];
  const [foot, head] = [(24 / 25.4) * 72, ((297 - 22) / 25.4) * 72]; // of print.css
  return end.page > begin.page && end.height > head - 0.12 * (head - foot);
}

/** Paper has no links: where the text leads to another page, it says on which sheet that lies. */
const with_pages = (html, page_numbers) =>
  html.replace(/<a class="elsewhere" href="#([^"]*)"/g, (link, id) => `${link} data-page="${page_numbers.get(id)?.page ?? '000'}"`);

/** The title and the first paragraph in one block, since Chromium may part a heading from what follows it. */
const with_title = ({id, title, body}) => body.replace(/<div class="textblock">(<p\b[\s\S]*?<\/p>)?/, (_, first = '') =>
  `<div class="textblock"><div class="opening"><h1 id="${id}">${title}</h1>${first}</div>`);

function whole(groups, page_numbers, tight) {
  const parts = groups.flat();
  const line = (id, html, kind) =>
    `<li class="${kind}"><a href="#${id}"><span>${html}</span><span>${page_numbers.get(id)?.page ?? ''}</span></a></li>`;
  return `<!DOCTYPE html><html lang="en-GB" class="light-mode"><head><meta charset="utf-8"><title>${escape(settings.book.name)}</title>
${['doxygen.css', 'fonts.css', 'katex/katex.min.css', 'book.css', 'contents.css', 'player.css', 'live.css', 'print.css']
  .map(name => `<link rel="stylesheet" href="${name}">`)
  .join('\n')}
<style>${parts.filter(part => !part.further).map(running_head).join('\n')}</style></head><body class="prose whole">
<main><section class="title-page"><h1>${escape(settings.book.name)}</h1><p>${escape(settings.book.brief)}</p>
<p class="edition">Built on ${escape(date)}, commit ${escape(commit)}</p></section>
<section class="printed-contents"><h1>Contents</h1><ul>
${parts.map(part => line(part.id, part.title, part.further ? 'further' : 'page') + (part.further ? [] : part.sections).map(([, id, text]) => line(id, escape(plain(text)), 'section')).join('')).join('\n')}
</ul>${groups.map(([{id}]) => `<a class="to-end" href="#${id}--end">&#8203;</a>`).join('')}</section>
${groups.map(group => {
  const [{id}] = group;
  const section = part => `<section class="page${part.further ? ' further' : ''}${tight.has(id) ? ' tight' : ''}" style="page: ${id}">${with_title(part)}`;
  return `${with_pages(group.map(section).join('</section>\n'), page_numbers)}<span class="end" id="${id}--end">&#8203;</span></section>`;
}).join('\n')}
</main></body></html>`;
}

function print(html, pdf) {
  const page = join(settings.folder, 'printed.html'),
    profile = mkdtempSync(join(tmpdir(), 'tumble-print-'));
  try {
    writeFileSync(page, html);
    const run = spawnSync(
      settings.chromium,
      [
        '--headless',
        '--no-sandbox',
        '--disable-gpu',
        '--no-first-run',
        '--disable-background-networking',
        `--user-data-dir=${profile}`,
        '--no-pdf-header-footer',
        '--generate-pdf-document-outline',
        `--print-to-pdf=${pdf}`,
        `file://${encodeURI(page)}`,
      ],
      {encoding: 'utf8', timeout: 300_000},
    );
    if (run.error) throw run.error;
    if (run.status !== 0) throw new Error(`Chromium could not print the book:\n${run.stderr}`);
  } finally {
    rmSync(page, {force: true});
    rmSync(profile, {recursive: true, force: true});
  }
}

const groups = groups_of(order.map(part_of)),
  fresh = join(settings.work, 'tumble.pdf');
rmSync(fresh, {force: true});
const places_after = (...given) => {
  print(whole(groups, ...given), fresh);
  return places_of_destinations(readFileSync(fresh));
};
let places = places_after(new Map(), new Set());
const tight = new Set(groups.filter(group => ends_in_a_few_lines(group, places)).map(([{id}]) => id));
if (tight.size) places = places_after(new Map(), tight);
// A number may be shorter than what held its place, and move what follows.
const pages_of = found => JSON.stringify([...found].map(([id, {page}]) => [id, page]));
for (let printed, left = 4; pages_of(places) !== printed; --left) {
  if (left === 0) throw new Error('the sheets of the printed book move each time that their numbers are printed');
  printed = pages_of(places);
  places = places_after(places, tight);
}
writeFileSync(join(settings.folder, 'tumble.pdf'), readFileSync(fresh));
rmSync(fresh);
