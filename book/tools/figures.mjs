// Drawings by gnuplot and Graphviz, made part of a page: they take the page's colours and its font.
import { escape, unescape } from './text.mjs';
import { BookError } from './results.mjs';

// The colours of theme/figure.gp and of the map, by the property of the style sheet that takes their place.
const colours = {
  '#0b6aa2': '--figure-1', '#c2500a': '--figure-2', '#12805c': '--figure-3', '#96408a': '--figure-4',
  '#8a6a00': '--figure-5', '#4d5bc4': '--figure-6', '#22303a': '--figure-ink', '#555555': '--figure-frame',
  '#b9c2c9': '--figure-grid', '#eef3f6': '--figure-fill', '#fffffe': '--figure-paper', black: '--figure-ink',
  '#000000': '--figure-ink',
};
const titleSize = '18.00';
let drawings = 0;

const hex = (...parts) => `#${parts.map((part) => Number(part).toString(16).padStart(2, '0')).join('')}`;

function inPageColours(svg) {
  return svg
    .replace(/rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\s*\)/g, (_, red, green, blue) => hex(red, green, blue))
    .replace(/\b(stroke|fill|color)=(["'])(#[0-9a-fA-F]{6}|black)\2/g, (all, property, quote, colour) => {
      const name = colours[colour.toLowerCase()];
      return name ? `${property}="var(${name})"` : all;
    });
}

// A page may hold several drawings, and every one of gnuplot's calls its first marker gpPt0.
function withOwnNames(svg) {
  const prefix = `drawing${++drawings}_`;
  return svg
    .replace(/\sid=(["'])([^"']*)\1/g, (_, quote, id) => ` id="${prefix}${id}"`)
    .replace(/((?:xlink:)?href)=(["'])#([^"']*)\2/g, (_, name, quote, id) => `href="#${prefix}${id}"`)
    .replace(/url\(#([^)]*)\)/g, (_, id) => `url(#${prefix}${id})`);
}

function bare(svg) {
  return svg.replace(/^.*?(?=<svg)/s, '').replace(/<title>.*?<\/title>|<desc>.*?<\/desc>|<!--.*?-->|<filter.*?<\/filter>/gs, '')
    .replace(/\sxmlns(:xlink)?="[^"]*"/g, '').replace(/>\s+</g, '><').trim();
}

/** gnuplot's drawing as {title, svg}; `says` is what it tells a reader who cannot see it. */
export function figure(source, says, name) {
  let svg = bare(source);
  const titles = [];
  let bottom = 0;
  svg = svg.replace(
    new RegExp(`<g transform="translate\\(([\\d.]+),([\\d.]+)\\)"[^>]*font-size="${titleSize}"[^>]*>\\s*(<text>.*?</text>)\\s*</g>`, 'gs'),
    (_, x, y, text) => {
      titles.push(unescape(text.replace(/<[^>]*>/g, ' ').trim()));
      bottom = Math.max(bottom, Number(y) + 8);
      return '';
    });
  if (!titles.length)
    throw new BookError(`figure "${name}" has no title; give it one that states what it shows: set title "..."`);
  const [, width, height] = /viewBox="0 0 (\d+) (\d+)"/.exec(svg);
  // The paper, which the page supplies, and the empty strip that the title left.
  svg = svg.replace(/<rect x="0" y="0"[^>]*fill="#fffffe"\/>/, '')
    .replace(/<svg[^>]*>/, `<svg role="img" aria-label="${escape(says)}" viewBox="0 ${bottom} ${width} ${height - bottom}" style="--width: ${width}">`);
  return { title: titles.join(' '), svg: inPageColours(withOwnNames(svg)) };
}

/** Graphviz' drawing, whose nodes may be links. */
export function graph(source, label) {
  const [, width, height] = /width="(\d+)pt" height="(\d+)pt"/.exec(source);
  return inPageColours(withOwnNames(bare(source)))
    .replace(/xlink:(href|title)=/g, '$1=').replace(/ title="[^"]*"/g, '')
    .replace(/<svg[^>]*?viewBox="([^"]*)"[^>]*>/s,
      (_, box) => `<svg role="group" aria-label="${escape(label)}" viewBox="${box}" style="--width: ${Math.round(width * 4 / 3)}" data-height="${height}">`);
}
