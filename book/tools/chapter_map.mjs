// The tower of chapters as a graph for Graphviz: each floor with its question and the headers that it adds.
import {existsSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {escape} from './text.mjs';

function wrapped(text, width) {
  const lines = [''];
  for (const word of text.split(' ')) {
    if (lines.at(-1) && lines.at(-1).length + word.length >= width) lines.push('');
    lines[lines.length - 1] += (lines.at(-1) ? ' ' : '') + word;
  }
  return lines.map(escape).join('<br/>');
}

export function map_of_chapters({source, floors}, pages) {
  const nodes = floors.map(({name, folder}) => {
    const page = pages.chapters.find(each => each.chapter === name);
    const headers = existsSync(join(source, folder, 'tumble'))
      ? readdirSync(join(source, folder, 'tumble'))
          .filter(file => file.endsWith('.hpp'))
          .sort()
      : [];
    const title = page?.name ?? (name === 'common' ? 'Common ground' : name);
    const label =
      `<b>${escape(title)}</b>${page?.question ? `<br/>${wrapped(page.question, 36)}` : ''}` +
      `${headers.length ? `<br/><font point-size="12">${wrapped(headers.join(', '), 42)}</font>` : ''}`;
    return `"${name}" [label=<${label}>${page ? ` URL="${page.file}"` : ''}];`;
  });
  const edges = floors.filter(floor => floor.below).map(floor => `"${floor.name}" -> "${floor.below}";`);
  return `digraph chapters { rankdir=TB; bgcolor="transparent"; nodesep=0.3; ranksep=0.35;
    node [shape=box, style="rounded,filled", fillcolor="#eef3f6", color="#555555", fontcolor="#22303a", fontname="sans-serif", fontsize=15, margin="0.18,0.1"];
    edge [color="#555555", arrowsize=0.7];
    ${nodes.join('\n')}\n${edges.join('\n')} }`;
}
