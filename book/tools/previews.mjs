// What a page looks like from outside: its first sentence, and its first drawing as a card on the landing page and in a link to it.
import {spawnSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {without_formulas} from './formulas.mjs';
import {capitalised, escape, plain} from './text.mjs';

/** The drawing in a block of HTML; drawings hold others. */
function drawing_in(html) {
  const start = html.indexOf('<svg');
  let depth = 0;
  for (const tag of html.matchAll(/<(\/?)svg\b[^>]*>/g)) {
    depth += tag[1] ? -1 : 1;
    if (depth === 0) return html.slice(start, tag.index + tag[0].length);
  }
  return undefined;
}

/**
 * The first drawing of a page that answers no question of it: behind a gate there may be answers. `cards` has a simpler drawing
 * of some blocks.
 */
export function first_drawing(blocks, cards = new Map()) {
  let gates = 0;
  for (const html of blocks) {
    if (html.startsWith('<div class="gate')) ++gates;
    else if (html === '</div></div>') --gates;
    else if (gates === 0 && drawing_in(html)) return cards.get(html) ?? drawing_in(html);
  }
  return undefined;
}

/** For a place with room for a few moments of a motion, of the six that a still shows. */
function shortened(svg) {
  if (!svg.includes('class="player-still"')) return svg;
  return svg
    .replace('viewBox="0 0 3600 616"', 'viewBox="1200 0 1200 540"')
    .replace(/<svg x="(\d+)" y="0"[\s\S]*?<\/svg><text\b[\s\S]*?<\/text>/g, (cell, x) =>
      ['1200', '1800'].includes(x) ? cell.replace(/<text\b[\s\S]*?<\/text>/, '') : '');
}

/** The drawing as a file of its own, in the colours of paper. */
function drawing_file(svg, style) {
  return shortened(svg)
    .replace(/var\(--([\w-]+)\)/g, (_, name) => new RegExp(`--${name}: (#\\w{6});`).exec(style)[1])
    .replace('<svg', '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" font-family="Lato, sans-serif"');
}

/** A page's drawing on a card, silent: whoever hears the card hears the page's question. */
export const thumbnail = ({id, picture}) => (picture ? `<img src="previews/${id}.svg" loading="lazy" alt="" aria-hidden="true">` : '');

/** What a search engine or a messenger shows of a page: its first sentences, to at least 70 letters. */
export function description_of(html) {
  const paragraphs = html.replace(/<(figure|form|nav|details)\b[\s\S]*?<\/\1>/g, '').match(/<p\b[^>]*>[\s\S]*?<\/p>/g) ?? [];
  const text = plain(without_formulas(paragraphs.join(' '))).replace(/^A page of .*?\. /, '').trim();
  return /^.{70,}?[.?!](?=\s|$)/.exec(text)?.[0] ?? text;
}

const [width, height, margin] = [1200, 630, 60];

/** A card for links to the page: its title over its drawing, in the colours of paper. */
function card(page, book, style) {
  const colour = name => new RegExp(`--${name}: (#\\w{6});`).exec(style)[1];
  const [left, top, wide, high] = /viewBox="([^"]*)"/.exec(shortened(page.picture))[1].split(' ').map(Number);
  const scale = Math.min((width - 2 * margin) / wide, (height - 4 * margin) / high);
  const drawing = drawing_file(page.picture, style)
    .replace(/ style="[^"]*"/, '')
    .replace('<svg', `<svg x="${(width - wide * scale) / 2}" y="${3 * margin}" width="${wide * scale}" height="${high * scale}"`);
  const line = (y, size, weight, text) =>
    `<text x="${margin}" y="${y}" font-family="Lato, sans-serif" font-size="${size}" font-weight="${weight}" fill="${colour('figure-ink')}">${escape(text)}</text>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="${width}" height="${height}">` +
    `<rect width="${width}" height="${height}" fill="${colour('figure-paper')}"/>` +
    `${line(80, 44, 700, capitalised(page.question ?? page.name))}${line(128, 28, 400, `${book.name} · ${page.name}`)}${drawing}</svg>`;
}

/** Makes the page's preview, previews/ID.png. @return what its head says of it */
export function preview(page, html, {book, source, rsvg, address}, folder) {
  const meta = (name, content) => `<meta ${name.startsWith('og:') ? 'property' : 'name'}="${name}" content="${escape(content)}">\n`;
  const description = page.id === 'mainpage' ? `${book.brief}.` : description_of(html);
  const words = meta('description', description) + meta('og:title', page.title) + meta('og:description', description) + meta('og:type', 'article');
  if (!page.picture) return words;
  const style = readFileSync(join(source, 'book/theme/book.css'), 'utf8');
  writeFileSync(join(folder, `previews/${page.id}.svg`), drawing_file(page.picture, style));
  if (!rsvg) return words;
  const file = `previews/${page.id}.png`;
  const svg = card(page, book, style);
  const {status, stderr} = spawnSync(rsvg, ['--output', join(folder, file)], {input: svg});
  if (status !== 0) throw new Error(`${rsvg} could not draw the preview of ${page.path}: ${stderr}`);
  return words + meta('og:image', `${address}${file}`) + meta('twitter:card', 'summary_large_image');
}
