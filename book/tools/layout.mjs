// What surrounds the contents of a page: the sidebar, the way here, the table of contents, the pages before and after.
import {group_of} from './pages.mjs';
import {escape, plain} from './text.mjs';

/** The headers of one chapter, in the order of the reference: those that programs include, and the one whose page this is. */
const beside = ({headers}, current) => headers.filter(({page, is_brought, file}) => page === current.header.page && (!is_brought || file === current.file));

function navigation(pages, current) {
  const item = page => {
    const here = page === current || page.file === current.under;
    const later = page.is_being_made ? ' <small>being made</small>' : '';
    const own = page.exercises?.length ? ` data-exercises="${page.exercises.join(' ')}"` : '';
    const is_around = page.file === current.under && current.header;
    const below = is_around ? beside(pages, current).map(({file, name}) =>
      `<li class="further"><a href="${file}"${file === current.file ? ' aria-current="page"' : ''}>${escape(name)}</a></li>`).join('') : '';
    return `<li${page.further ? ' class="further"' : ''}><a href="${page.file}"${own}${here && !is_around ? ' aria-current="page"' : ''}>${escape(page.name)}${later}</a></li>${below}`;
  };
  const group = (title, list) => `<h2>${title}</h2><ul>${list.map(item).join('')}</ul>`;
  return (
    `<nav id="navigation" aria-label="Pages of the book">${group('Start', pages.front)}${group('Chapters', pages.chapters)}` +
    `${group('Look up', pages.back)}${pages.teaching.length ? group('Teach', pages.teaching) : ''}</nav>`
  );
}

function table_of_contents(headings) {
  const listed = headings.filter(heading => heading.level <= 3);
  if (listed.length < 3) return '';
  const link = ({id, html}) => `<a href="#${id}">${html.replace(/<\/?a\b[^>]*>/g, '')}</a>`;
  const items = [];
  for (const heading of listed)
    if (heading.level === 2 || !items.length) items.push({heading, below: []});
    else items.at(-1).below.push(heading);
  const item = ({heading, below}) =>
    `<li>${link(heading)}${below.length ? `<ul>${below.map(each => `<li>${link(each)}</li>`).join('')}</ul>` : ''}</li>`;
  return `<nav class="contents-table" aria-label="On this page"><details open><summary>On this page</summary><ul>${items.map(item).join('')}</ul></details></nav>`;
}

function neighbours(pages, current) {
  const order = current.header ? pages.headers.filter(header => !header.is_brought || header === current.header) : pages.all;
  const index = order.indexOf(current.header ?? current);
  if (index < 0) return '';
  const link = (page, rel, word) =>
    page ? `<a rel="${rel}" href="${page.file}"><span>${word}</span> ${current.header ? breakable(escape(page.name)) : escape(page.name)}</a>` : '<span></span>';
  return (
    `<nav class="neighbours" aria-label="Previous and next page">${link(order[index - 1], 'prev', '← Previous')}` +
    `${link(order[index + 1], 'next', 'Next →')}</nav>`
  );
}

function way_here(page, reference) {
  return page.under
    ? `<nav class="way" aria-label="You are here"><a href="${reference.file}">${escape(reference.name)}</a> › ` +
      `${page.header ? `<a href="${reference.file}#${group_of(page.header)}">${escape(page.header.page?.name ?? 'Common')}</a> › ` : ''}${escape(page.name)}</nav>`
    : '';
}

/** How often a page that is still being made asks for itself again. */
const seconds_until_next_look = 10;

const style_and_script = (name, is_needed) =>
  is_needed ? `<link rel="stylesheet" href="${name}.css">\n<script src="${name}.js" defer></script>\n` : '';

/** A long name of a file may break where its parts meet. */
const breakable = html => html.replace(/[/_]/g, '$&<wbr>');

/** The whole page. `page` is one of `pages` or {name, title, file, under} for a page of the reference. */
export function layout(page, {html, headings, head = ''}, pages, book) {
  const reference = pages.all.find(each => each.id === 'reference');
  const is_landing = page.file === 'index.html';
  const title = is_landing ? book.name : `${page.title} · ${book.name}`;
  const kind = page.under ? (page.file.endsWith('_source.html') ? 'source' : 'reference') : 'prose';
  return `<!DOCTYPE html>
<html lang="en-GB">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
${head}${page.is_being_made ? `<meta http-equiv="refresh" content="${seconds_until_next_look}">\n` : ''}<title>${escape(title)}</title>
<link rel="icon" href="icon.svg">
<link rel="stylesheet" href="doxygen.css">
<link rel="stylesheet" href="fonts.css">
<link rel="stylesheet" href="katex/katex.min.css">
<link rel="stylesheet" href="book.css">
<link rel="stylesheet" href="contents.css">
<link rel="stylesheet" href="print.css" media="print">
<style media="print">@page { @top-left { content: ${JSON.stringify(title).replace(/</g, '\\3c ')}; font: 8.5pt Lato, sans-serif; color: #444; } }</style>
${style_and_script('player', /<figure class="(?:player|live)/.test(html))}${style_and_script('live', /class="live[ -]/.test(html))}<script src="dark.js"></script>
<script src="book.js" defer></script>
<script src="reading.js" defer></script>
<script src="search.js" defer></script>
${/<form class="prediction\b/.test(html) ? '<script src="predict.js" defer></script>\n' : ''}</head>
<body class="${kind}${page.id === 'cheat_sheet' ? ' cheat-sheet' : is_landing ? ' landing' : ''}"${page.chapter && !page.is_being_made ? ' data-kept' : ''}>
<a class="skip" href="#text">Skip to the text</a>
<header id="sidebar">
<div class="brand"><a href="index.html">${escape(book.name)}</a><button id="dark" type="button" aria-pressed="false">Dark</button><button id="menu" type="button" aria-expanded="false" aria-controls="navigation">Pages</button></div>
<div id="search" role="search"><input id="query" type="text" role="combobox" aria-label="Search the book" aria-autocomplete="list" aria-expanded="false" aria-controls="found" placeholder="Search ( / )" autocomplete="off" spellcheck="false"><div id="answers" hidden><p id="answer" role="status"></p><ul id="found" role="listbox" aria-label="Places found"></ul></div></div>
${navigation(pages, page)}
</header>
<main id="text" tabindex="-1">
${way_here(page, reference)}
<h1>${page.under ? breakable(escape(plain(escape(page.title)))) : escape(page.title)}</h1>
${kind === 'source' || is_landing ? '' : table_of_contents(headings)}
<div class="contents">
${(page.id === 'cheat_sheet' ? html.replace(/(?<=<code>)[^<]+/g, breakable) : html).replace(/<code>(-[^<>\s]{1,24})<\/code>/g, '<code class="flag">$1</code>')}
</div>
${neighbours(pages, page)}
</main>
</body>
</html>
`;
}
