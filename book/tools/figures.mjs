// Drawings by gnuplot, made part of a page: they take the page's colours and its font.
import {escape, unescape} from './text.mjs';
import {BookError} from './results.mjs';

// The colours of theme/figure.gp, by the property of the style sheet that takes their place.
const colours = {
  '#0b6aa2': '--figure-1',
  '#c2500a': '--figure-2',
  '#12805c': '--figure-3',
  '#96408a': '--figure-4',
  '#8a6a00': '--figure-5',
  '#4d5bc4': '--figure-6',
  '#22303a': '--figure-ink',
  '#555555': '--figure-frame',
  '#b9c2c9': '--figure-grid',
  '#eef3f6': '--figure-fill',
  '#fffffe': '--figure-paper',
  black: '--figure-ink',
  '#000000': '--figure-ink',
};
const title_size = '18.00';
let drawings = 0;

const hex = (...parts) => `#${parts.map(part => Number(part).toString(16).padStart(2, '0')).join('')}`;

function in_page_colours(svg) {
  return svg
    .replace(/rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\s*\)/g, (_, red, green, blue) => hex(red, green, blue))
    .replace(/\b(stroke|fill|color) ?= ?(["'])(#[0-9a-fA-F]{6}|black)\2/g, (all, property, quote, colour) => {
      const name = colours[colour.toLowerCase()];
      return name ? `${property}="var(${name})"` : all;
    });
}

/** A page may hold several drawings, and every one of gnuplot's calls its first marker gpPt0. */
function with_own_names(svg) {
  const prefix = `drawing${++drawings}_`;
  return svg
    .replace(/\sid=(["'])([^"']*)\1/g, (_, quote, id) => ` id="${prefix}${id}"`)
    .replace(/((?:xlink:)?href)=(["'])#([^"']*)\2/g, (_, name, quote, id) => `href="#${prefix}${id}"`)
    .replace(/url\(#([^)]*)\)/g, (_, id) => `url(#${prefix}${id})`);
}

function bare(svg) {
  return svg
    .replace(/^.*?(?=<svg)/s, '')
    .replace(/<title>.*?<\/title>|<desc>.*?<\/desc>|<!--.*?-->|<filter.*?<\/filter>/gs, '')
    .replace(/\sxmlns(:xlink)?="[^"]*"/g, '')
    .replace(/ stroke-dasharray='[^']*'(?= class="gridline")/g, '')
    .replace(/>\s+</g, '><')
    .trim();
}

/** The name of a y axis stands level above it, where a reader need not turn the head, as in the figures that one can touch. */
function with_level_names(svg) {
  const axes = [...svg.matchAll(/ d='M([\d.]+),([\d.]+) L\1,([\d.]+) L/g)].map(([, ...numbers]) => numbers.map(Number));
  return svg.replace(/translate\(([\d.]+),([\d.]+)\) rotate\((?:-90|270)\)("[^>]*text-anchor=")middle/g, (turned, x, y, between) => {
    const axis = axes.find(([at, top, bottom]) => at > x && Math.abs((top + bottom) / 2 - y) < 1);
    return axis ? `translate(${Number(x) + 5},${axis[1] - 18})${between}start` : turned;
  });
}

/** About how wide words are in the page's letters, as a multiple of their size. */
const width_of = words => [...words].reduce((sum, letter) => sum + (/[mwMW]/.test(letter) ? 0.84 : /[ijlft.,:;'’|()\s]/.test(letter) ? 0.32 : 0.58), 0);

/** [left, top, right, bottom] of what gnuplot drew. */
function extent(svg) {
  const xs = [],
    ys = [];
  const point = (x, y) => {
    xs.push(Number(x));
    ys.push(Number(y));
  };
  const drawn = svg.replace(/<defs>.*?<\/defs>/gs, '');
  for (const [, path] of drawn.matchAll(/ (?:d|points)=["']([^"']*)["']/g))
    for (const [, x, y] of path.matchAll(/(-?[\d.]+),(-?[\d.]+)/g)) point(x, y);
  for (const [, x, y] of drawn.matchAll(/<use [^>]*transform=["']translate\((-?[\d.]+),(-?[\d.]+)\)/g)) point(x, y);
  const written =
    /<g transform="translate\((-?[\d.]+),(-?[\d.]+)\)( rotate\(-?[\d.]+\))?"[^>]*font-size="([\d.]+)"[^>]*text-anchor="(\w+)"[^>]*>(.*?)<\/g>/gs;
  for (const [, x, y, turned, size, anchor, text] of drawn.matchAll(written)) {
    const length = Number(size) * width_of(unescape(text.replace(/<[^>]*>/g, '')).trim());
    const before = {start: 0, middle: length / 2, end: length}[anchor],
      height = Number(size) * 0.8;
    const [left, right] = [Number(x) - before, Number(x) + length - before];
    if (turned)
      [
        [Number(x) - height, Number(y) + before - length],
        [x, Number(y) + before],
      ].forEach(([a, b]) => point(a, b));
    else
      [
        [left, Number(y) - height],
        [right, Number(y) + height / 3],
      ].forEach(([a, b]) => point(a, b));
  }
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** gnuplot's drawing as {title, svg}; `says` is what it tells a reader who cannot see it. */
export function figure(source, says, name) {
  let svg = with_level_names(bare(source));
  const titles = [];
  svg = svg.replace(
    new RegExp(
      `<g transform="translate\\([\\d.-]+,[\\d.-]+\\)"[^>]*font-size="${title_size}"[^>]*>\\s*(<text>.*?</text>)\\s*</g>`,
      'gs',
    ),
    (_, text) => {
      titles.push(unescape(text.replace(/<[^>]*>/g, ' ').trim()));
      return '';
    },
  );
  if (!titles.length)
    throw new BookError(`figure "${name}" has no title; give it one that states what it shows: set title "..."`);
  svg = svg.replace(/<rect x="0" y="0"[^>]*fill="#fffffe"\/>/, ''); // the paper, which the page supplies
  const edge = 6,
    [left, top, right, bottom] = extent(svg).map((value, side) => Math.round(value + (side < 2 ? -edge : edge)));
  svg = svg.replace(
    /<svg[^>]*>/,
    `<svg role="img" aria-label="${escape(says)}" viewBox="${left} ${top} ${right - left} ${bottom - top}" ` +
      `style="--width: ${right - left}">`,
  );
  return {title: titles.join(' '), svg: in_page_colours(with_own_names(svg))};
}
