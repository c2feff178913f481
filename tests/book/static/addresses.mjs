// Every address a page or a style sheet holds, and where it leads.
import {posix} from 'node:path';

const loading_attributes = ['src', 'poster', 'data', 'background', 'action', 'xlink:href', 'ping'];

function addresses_of_css(css, first_line) {
  const code = css.replace(/\/\*[\s\S]*?\*\//g, comment => comment.replace(/[^\n]/g, ' '));
  const pattern = /url\(\s*(?:"([^"]*)"|'([^']*)'|([^)"'\s]*))\s*\)|@import\s+(?:"([^"]*)"|'([^']*)')/g;
  return [...code.matchAll(pattern)].map(match => ({
    address: match.slice(1).find(part => part !== undefined),
    line: first_line + code.slice(0, match.index).split('\n').length - 1,
    loaded: true,
  }));
}

function addresses_of_element(element) {
  const {name, attributes, line} = element;
  const found = loading_attributes.filter(key => key in attributes)
    .map(key => ({address: attributes[key], line, loaded: true}));
  // A link in the prose is followed when the reader chooses; every other href is loaded at once.
  if ('href' in attributes) {
    found.push({address: attributes.href, line, loaded: !['a', 'area'].includes(name)});
  }
  for (const candidate of (attributes.srcset ?? '').split(',').filter(part => part.trim())) {
    found.push({address: candidate.trim().split(/\s+/)[0], line, loaded: true});
  }
  const refresh = /url=(.*)$/i.exec(attributes.content ?? '');
  if (attributes['http-equiv']?.toLowerCase() === 'refresh' && refresh) {
    found.push({address: refresh[1], line, loaded: true});
  }
  if (attributes.style) found.push(...addresses_of_css(attributes.style, line));
  if (name === 'style') found.push(...addresses_of_css(element.children.join(''), line));
  return found;
}

/// All addresses of the book as {path, line, address, loaded}.
export function* addresses(book) {
  for (const page of book.pages.values()) {
    for (const element of page.elements) {
      for (const found of addresses_of_element(element)) yield {path: page.path, ...found};
    }
  }
  for (const [path, css] of book.style_sheets) {
    for (const found of addresses_of_css(css, 1)) yield {path, ...found};
  }
}

/// {outside: true}, {nowhere: true} for data and scripts, or {file, fragment}, the file as seen from the book's folder.
export function destination({path, address}) {
  const trimmed = address.trim();
  if (/^(data|javascript):/i.test(trimmed)) return {nowhere: true};
  if (/^([a-z][a-z0-9+.-]*:|\/)/i.test(trimmed)) return {outside: true};
  const [place, fragment = ''] = trimmed.split('#').map(decodeURIComponent);
  const file = place.split('?')[0];
  const target = file ? posix.normalize(posix.join(posix.dirname(path), file)) : path;
  return target.startsWith('../') ? {outside: true} : {file: target, fragment};
}
