// A book as the rules see it: a folder of files, of which the pages are parsed.
import {readFileSync, readdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join, relative} from 'node:path';

// Debian keeps parse5 where only require() looks (NODE_PATH), not import.
const {parse} = createRequire(import.meta.url)('parse5');

export class Element {
  constructor(node, parent) {
    this.name = node.tagName;
    this.parent = parent;
    this.attributes = Object.fromEntries(
      node.attrs.map(({prefix, name, value}) => [prefix ? `${prefix}:${name}` : name, value]));
    this.line = node.sourceCodeLocation?.startLine ?? parent?.line ?? 1;
    this.children = (node.content ?? node).childNodes
      .filter(child => child.tagName || child.nodeName === '#text')
      .map(child => child.tagName ? new Element(child, this) : child.value);
  }

  has_class(name) {
    return (this.attributes.class ?? '').split(/\s+/).includes(name);
  }

  is_inside(condition) {
    return condition(this) || (this.parent?.is_inside(condition) ?? false);
  }

  find(condition) {
    const elements = this.children.filter(child => child instanceof Element);
    const below = elements.flatMap(child => child.find(condition));
    return condition(this) ? [this, ...below] : below;
  }

  /// The words a reader sees; an element that `leave_out` accepts is not read.
  text(leave_out = () => false) {
    if (['script', 'style'].includes(this.name) || leave_out(this)) return '';
    return this.children
      .map(child => child instanceof Element ? child.text(leave_out) : child).join('');
  }
}

export class Page {
  constructor(path, source) {
    this.path = path;
    this.source = source;
    const document = parse(source, {sourceCodeLocationInfo: true});
    this.root = new Element(document.childNodes.find(node => node.tagName), null);
    this.elements = this.root.find(() => true);
    this.ids = this.elements.filter(({attributes}) => 'id' in attributes);
    this.anchors = new Set(this.elements.flatMap(({name, attributes}) =>
      [attributes.id, name === 'a' ? attributes.name : undefined].filter(Boolean)));
  }

  with_class(name) {
    return this.elements.filter(element => element.has_class(name));
  }
}

function files_below(folder) {
  return readdirSync(folder, {withFileTypes: true}).flatMap(entry => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? files_below(path) : [path];
  });
}

/// `machine_paths` are folders of this machine that no page may name.
export function read_book(folder, machine_paths = []) {
  const files = files_below(folder).map(path => relative(folder, path)).sort();
  const texts = new Map(files.filter(path => /\.(html|css|js|json|svg|txt|xml)$/.test(path))
    .map(path => [path, readFileSync(join(folder, path), 'utf8')]));
  const ending = extension => [...texts].filter(([path]) => path.endsWith(extension));
  return {
    files: new Set(files),
    machine_paths,
    texts,
    pages: new Map(ending('.html').map(([path, source]) => [path, new Page(path, source)])),
    style_sheets: new Map(ending('.css')),
  };
}
