// The picture of README.md is a copy of one that the build draws: node readme_picture.mjs COPY DRAWN
// Another gnuplot may draw the same data with other lines, so the two are compared only where one gnuplot drew both.
import {readFileSync} from 'node:fs';

const [copy_file, drawn_file] = process.argv.slice(2);
const copy = readFileSync(copy_file, 'utf8'), drawn = readFileSync(drawn_file, 'utf8');
const gnuplot_of = svg => /Produced by (GNUPLOT.*?)\s*</.exec(svg)?.[1] ?? 'an unknown program';
if (gnuplot_of(copy) !== gnuplot_of(drawn)) {
  console.log(`Skipped, for the copy was drawn by ${gnuplot_of(copy)} and the build has ${gnuplot_of(drawn)}`);
  process.exit(0);
}

// Coordinates are rounded to a hundredth of a pixel; a machine that rounds otherwise may move one by a unit of that.
const number = /-?\d+(\.\d+)?/g;
const shape = svg => svg.replace(number, '#');
const numbers = svg => [...svg.matchAll(number)].map(match => Number(match[0]));
const drawn_numbers = numbers(drawn);
const moved = numbers(copy).findIndex((value, index) => Math.abs(value - drawn_numbers[index]) > 0.015);
if (shape(copy) !== shape(drawn) || moved >= 0) {
  console.error(`${copy_file} is not what the build draws any more: copy ${drawn_file} over it`);
  process.exit(1);
}
