// The reference: a page for each header that a program may include, with all that it offers on it. Doxygen spreads that over pages of
// classes, files and namespaces; here its descriptions are gathered where one would look for them, and links lead there.
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {at_left_edge} from './contents.mjs';
import {BookError} from './results.mjs';
import {escape, plain, slug} from './text.mjs';

/** The rows of Doxygen's lists: {id, template, left, right, brief, kind}; without what stands there a second time, as a base class has it. */
function rows_of(html) {
  const rows = [];
  for (const [, list] of html.matchAll(/<table class="memberdecls">([\s\S]*?)<\/table>/g)) {
    const kind = /<a id="([\w-]+)"/.exec(list)?.[1] ?? '';
    let template = '';
    for (const [, id, row] of list.matchAll(/<tr class="memitem:(\w*)">([\s\S]*?)<\/tr>(?=\s*$|\n<tr class="(?:memdesc|separator|memitem))/g)) {
      const head = /<td class="memTemplParams"[^>]*>([\s\S]*?)<\/td>/.exec(row)?.[1];
      if (head) {
        template = head;
        continue;
      }
      const left = /<td class="mem(?:Templ)?ItemLeft"[^>]*>([\s\S]*?)<\/td>/.exec(row)?.[1] ?? '';
      const right = /<td class="mem(?:Templ)?ItemRight"[^>]*>([\s\S]*?)<\/td>/.exec(row)?.[1] ?? '';
      const brief = new RegExp(`<tr class="memdesc:${id}"><td class="mdescLeft">&#160;</td><td class="mdescRight">([\\s\\S]*?)(?:<a href="[^"]*">More\\.\\.\\.</a>)?<br />`).exec(list)?.[1] ?? '';
      const is_of_base = /=0$/.test(right.trim()) && rows.some(known => / override$/.test(known.right.trim()) && name_in(known.right) === name_in(right));
      if (!is_of_base) rows.push({kind, id, template, left, right, brief});
      template = '';
    }
  }
  return rows;
}

const longest_before_given = 500; // letters of a description; of a longer one the first paragraph
const longest_initial = 300; // letters of a variable's initial value; a longer one is looked up in the source
const longest_default = 60; // letters; what is longer is shown where it stands

/** Numbers, vectors, matrices, orientations and poses have units; a body or a text has none of its own. */
const is_quantity = type =>
  /\b(Vec3|Mat3|Quaternion|Pose|Real|double|float|int|int64_t|size_t|Time|Nanoseconds)\b/i.test(type) &&
  !/\b(WorldTime|StepTime|Particle|Top|RigidBody|Bod(y|ies)\w*|Wrench|Mesh|Array|vector|span|string\w*)\b/.test(type);

/** Enumerators in the look of fields; no link from a person's name, which is also that of a class: Verlet's step, Suzuki (1990). */
const with_own_names = doc =>
  doc
    .replace(/<table class="fieldtable">\s*<tr><th colspan="2">Enumerator<\/th><\/tr>([\s\S]*?<\/table>)/g,
      '<div class="scroll"><table class="fields"><tr><th scope="col">value</th><th scope="col">what</th></tr>$1</div>')
    .replace(/<td class="fieldname">(<a id[^>]*><\/a>)?(\w+)&#160;<\/td><td class="fielddoc">\s*(?:<p ?>)?([\s\S]*?)\s*(?:<\/p>)?\s*<\/td>/g, '<td>$1<code>$2</code></td><td class="what">$3</td>')
    .replace(/<a class="el" [^>]*>(\w+)<\/a>(?=['’]s\b| \(\d{4}\))/g, '$1');

/** What Doxygen says of each member at length: id to {doc, line}; `line` is the address of its source. */
function descriptions_in(html, is_of_struct) {
  const found = new Map();
  for (const [, id, block] of html.matchAll(
    /<a id="(\w+)" name="\w+"><\/a>\n<h2 class="memtitle">([\s\S]*?)(?=<a id="\w+" name="\w+"><\/a>\n<h2 class="memtitle">|<h2 class="groupheader|$)/g,
  )) {
    const doc = /<div class="memdoc">([\s\S]*)<\/div>\s*<\/div>\s*(?:<\/div>)?\s*$/.exec(block)?.[1] ?? '';
    const line = /Definition at line <a class="el" href="([^"]*)"/.exec(doc)?.[1];
    const parameters = [...block.matchAll(/<td class="paramtype">([\s\S]*?)<\/td>\s*<td class="paramname"><em>(\w+)<\/em>/g)]
      .map(([, type, name]) => ({name, type: plain(type).trim(), has_unit: is_quantity(plain(type))}));
    const kept = with_own_names(doc).replace(/^\s*<b>Initial value:<\/b><div class="fragment">([\s\S]*?)<\/div><!-- fragment -->/, (whole, value) =>
      is_of_struct || plain(value).length <= longest_initial ? whole : '').replace(/<p class="definition">[\s\S]*?<\/p>/g, '').replace(/<p>Implement(s|ed in) <a [\s\S]*?<\/p>/g, '');
    found.set(id, {doc: kept.trim(), line, parameters});
  }
  return found;
}

/** A declaration as a reader wants it: no blanks inside <>, and Real for what takes a number of the same kind. */
const declaration = html =>
  html
    .replace(/&#160;|\s+/g, ' ')
    .replace(/<\/?b>/g, '')
    .replace(/(?:<a [^>]*>)?Same(?:<\/a>)?&lt; (\w+) &gt;/g, '$1')
    .replace(/&lt; /g, '&lt;')
    .replace(/ &gt;/g, '&gt;')
    .replace(/ &amp;(?=\w|<a)/g, '&amp; ')
    .replace(/ &amp;/g, '&amp;')
    .replace(/ \(/g, '(')
    .replace(/ +,/g, ',')
    .replace(/(?<=\d) '(?=\d{3})/g, "'")
    .replace(/ +/g, ' ')
    .trim();

const name_in = right => plain(/^\s*(?:<(?:a|b)\b[^>]*>)?(operator\(\)|operator[^ (]+|[\w~]+)/.exec(right)?.[1] ?? right);

/** The declaration as it is set: what it is a template of stands on a line of its own. */
const declared = (template, text) =>
  `<code>${template ? `<span>${declaration(template).replace(/^template&lt;/, 'template &lt;')}</span><span>${text}</span>` : text}</code>`;

/** What the world asks of an effect, by the tables of the page on effects: a member's name to what it tells. Most of ours say no more. */
function members_of_effects(source) {
  const told = new Map(), page = join(source, 'chapters/11_world/effects.md');
  for (const line of existsSync(page) ? readFileSync(page, 'utf8').split('\n') : []) {
    const [names, first, second, third] = line.replace(/^\| | \|$/g, '').split(' | ');
    if (third === undefined) continue;
    const what = escape(/^`\w+\((seen|first)/.test(names) ? `gives ${second}, and that is ${third}`.replace(/that is (?=changes|replaces)/, 'that ') : first).replace(/`([^`]*)`/g, '<code>$1</code>');
    for (const [, name] of names.matchAll(/(\w+)(?:(?:<\w+>)?\(|`$)/g)) told.set(name + (names.startsWith(`\`${name}(first`) ? '/2' : ''), what);
  }
  return told.set('name', 'what plans and errors call it');
}

/** How a class begins in its header: [kind, bases]. */
const beginning = (text, name) =>
  new RegExp(`^(class|struct) ${name}(?: final)?(?: : ([^{;]+?))? \\{`, 'm').exec(text)?.slice(1) ?? [];

/** Where a long class is parted by a comment: {line, name}. */
const parts_of = text =>
  text.split('\n').flatMap((line, n) => {
    const name = /^ {2}\/\/ --- (.+?) -+$/.exec(line)?.[1];
    return name ? [{line: n + 1, name}] : [];
  });

/** The parts of a long class, and the functions in each. */
function overview_of(parts) {
  if (!parts.length) return '';
  const row = ({name, links}) => `<tr><td><a href="#${slug(name)}">${escape(name)}</a></td><td>${[...links].map(([each, id]) => `<a href="#${id}"><code>${each}</code></a>`).join(', ')}</td></tr>`;
  return `<div class="scroll"><table class="given overview"><thead><tr><th scope="col">part</th><th scope="col">functions</th></tr></thead><tbody>${parts.map(row).join('')}</tbody></table></div>`;
}

/** From a header's name to how it is used: {test, file, line, lines}, what stands between two comments with that name in a file of checks. */
function examples_in(written) {
  const examples = new Map();
  for (const [file, page] of Object.entries(written)) {
    if (!/_checks\.cpp\b/.test(page.title) || !page.contents.includes('.hpp]')) continue;
    let test, label, shown;
    for (const [, line, html] of page.contents.matchAll(/<div class="line"><a id="(l\d+)"[^>]*><\/a><span class="lineno">[ \d]*<\/span>(.*)<\/div>/g)) {
      const text = plain(html);
      test = /^TEST_CASE\("(.*)"\)/.exec(text)?.[1] ?? test;
      const [, names] = /^\/\/! \[(.*\.hpp)\]$/.exec(text) ?? [];
      if (!names) shown?.push(html.replaceAll('<span class="comment"></span>', ''));
      else if (shown) {
        for (const name of label.split(' ')) examples.set(name, {test, file, line, lines: shown, names: label.split(' ')});
        shown = undefined;
      } else [label, shown] = [names, []];
    }
  }
  return examples;
}

export class Reference {
  /** `headers` are {path, name, page, brief}, `page` that of the chapter; `lessons` leads from a path to where it is taught. */
  constructor(written, headers, {source, lessons}) {
    this.written = written;
    this.headers = headers;
    this.lessons = lessons;
    const {inner, names, of, types, throws = {}} = JSON.parse(readFileSync(join(source, 'book/pages/parameters.json'), 'utf8'));
    this.parameters = names;
    this.inner = new Set(inner); // what the library itself uses, and stands in a header that users need
    this.parameters_of = of;
    this.parameters_by_type = types;
    this.throws_by_type = throws; // {owner: {type: [[what, when]]}}
    this.asked_of_effects = members_of_effects(source);
    this.examples = examples_in(written);
    const unknown = [...this.examples.keys()].filter(name => !headers.some(header => header.path.endsWith(`/${name}`)));
    if (unknown.length) throw new BookError(`there are examples of headers that the reference lacks: ${unknown.join(', ')}`);
    for (const header of headers) Object.assign(header, {text: readFileSync(join(source, header.path), 'utf8'), fields: []});
    this.#gather();
    this.included = new Map(headers.map(({name, text}) => [name, [...text.matchAll(/^#include <(tumble\/[\w/]+\.hpp)>/gm)].map(([, other]) => other)]));
    this.made = new Map(headers.map(header => [header.file, this.#page(header)]));
    const anchors = ({contents}) => new Set([...contents.matchAll(/ id="([^"]*)"/g)].map(match => match[1]));
    this.anchors = new Map([...this.made].map(([file, page]) => [file, anchors(page)]));
  }

  /** {title, contents, headings} of a header's page. */
  page(header) {
    return this.made.get(header.file);
  }

  #gather() {
    this.places = new Map(); // where a link of Doxygen's leads to in this reference
    this.descriptions = new Map();
    this.told_apart = new Map(); // of a class those names that it tells of more than once: Doxygen's links in code lead to any of them
    const source_pages = new Map();
    for (const [file, {title}] of Object.entries(this.written))
      if (file.endsWith('_source.html')) source_pages.set(title.replace(/ Source File$/, ''), file);
    for (const header of this.headers) {
      header.source = source_pages.get(header.path);
      if (!header.source) throw new BookError(`Doxygen made no page of ${header.path}`);
      header.file = header.source.replace('_source.html', '.html');
    }
    const by_source = new Map(this.headers.map(header => [header.source, header]));
    for (const [file, {contents}] of Object.entries(this.written)) {
      if (!/^(namespace|struct|class|union|concept)/.test(file) || /-members/.test(file)) continue;
      // Doxygen gives members of two structs that look alike one id, so the struct's is put before.
      const prefix = file.startsWith('namespace') ? '' : `${this.#id_of(file)}-`;
      for (const [id, about] of descriptions_in(contents, prefix !== '')) {
        this.descriptions.set(prefix + id, about);
        const header = by_source.get(about.line?.replace(/#.*/, ''));
        const begins = header?.text.split('\n').slice(Number(/#l(\d+)/.exec(about.line)?.[1]) - 1).join('\n') ?? '';
        about.before = /^\s*(?:template <.*>\n\s*)?((?:\[\[noreturn\]\] |explicit )+)/.exec(begins)?.[1] ?? ''; // which Doxygen leaves out
        this.places.set(`${file}#${id}`, header ? `${header.file}#${prefix}${id}` : about.line);
      }
      const includes = /<p><code>#include &lt;<a class="el" href="([^"]*)"/.exec(contents)?.[1];
      const definition = [...contents.matchAll(/Definition at line <a class="el" href="([^"]*)"/g)].map(match => match[1]);
      const own_line = definition.find(line => line.startsWith(includes ?? '?')) ?? includes;
      const header = by_source.get(includes);
      if (!file.startsWith('namespace'))
        this.places.set(file, header ? `${header.file}#${this.#id_of(file)}` : own_line);
      const groups = this.#by_description(rows_of(contents).map(row => ({...row, id: prefix + row.id}))).map(([{right}]) => name_in(right));
      this.told_apart.set(file, new Set(groups.filter((name, n) => groups.indexOf(name) < n)));
      if (header) (header.compounds ??= []).push({file, source: own_line, line: Number(/#l(\d+)/.exec(own_line)?.[1])});
    }
    for (const header of this.headers) header.compounds?.sort((one, other) => one.line - other.line);
    this.by_class = new Map([...this.places].filter(([file]) => /^(struct|class)\w+\.html$/.test(file)).map(([file, place]) => [
      this.written[file].title.replace(/<.*|\s.*/, ''), place]));
    this.by_file = new Map(this.headers.map(header => [header.file, header]));
  }

  /** The address of a struct on its header's page. */
  #id_of(file) {
    return slug(this.written[file].title.replace(/ (?:Class|Struct|Union|Concept)?\s*(?:Template )?Reference$/, '').replace(/<.*?>/g, ''));
  }

  /** All names in the order of the alphabet, each with links to where it is explained. */
  names() {
    const places = new Map();
    const add = (name, where) => {
      const known = places.get(name) ?? [];
      if (!known.some(each => each.name === where.name)) places.set(name, [...known, where]);
    };
    for (const header of this.headers) {
      let owner;
      for (const {level, id, html} of this.page(header).headings) {
        const name = plain(html);
        if (!/^[\w~]+$/.test(name) || html.startsWith('<b>')) continue;
        const is_of_class = level === 3;
        if (!is_of_class) owner = name;
        if (is_of_class && name === owner) continue; // a constructor
        add(name, {name: is_of_class ? owner : header.name.replace('tumble/', ''), address: `${header.file}#${id}`});
      }
      for (const {id, owner: of, name} of header.fields) add(name, {name: of, address: `${header.file}#${id}`});
    }
    const sorted = [...places.keys()].sort((one, other) => one.toLowerCase() < other.toLowerCase() ? -1 : 1);
    const initials = [...new Set(sorted.map(name => name[0].toUpperCase()))];
    const item = name => `<li><code>${escape(name)}</code> ${places.get(name).map(where => `<a href="${where.address}">${escape(where.name)}</a>`).join(', ')}</li>`;
    return initials.map(letter =>
      `<h1>${letter}</h1><ul class="names unindexed">${sorted.filter(name => name[0].toUpperCase() === letter).map(item).join('')}</ul>`).join('');
  }

  /** Links to Doxygen's own pages lead to where the reference has it, or else to the source; what is nowhere is no link. */
  redirect(html) {
    return html.replace(
      /<a ([^>]*)href="((?:namespace|struct|class|union|concept)\w*\.html)(#\w+)?"([^>]*)>([\s\S]*?)<\/a>/g,
      (_, before, file, anchor = '', after, text) => {
        if (before.includes('code') && this.told_apart.get(file)?.has(text)) return text;
        const place = this.#present(this.places.get(file + anchor) ?? this.places.get(file));
        return place ? `<a ${before}href="${place}"${after}>${text}</a>` : text;
      },
    ).replace(/<a [^>]*href="(\w+_8[hc]pp\.html)(#\w+)?"[^>]*>([\s\S]*?)<\/a>/g, (link, file, anchor, text) => {
      const header = this.by_file.get(file);
      if (!header) return text;
      // A header that was named for a function of it, whose overloads Doxygen can't tell apart, leads to the first of them.
      const named = !anchor && this.made?.get(file).headings.find(({html}) => html === /^\w+/.exec(text)?.[0]);
      return named ? link.replace(file, `${file}#${named.id}`) : link;
    }).replace(/<a class="el" href="[^"]*"[^>]*>(world\.(\w+)\([^<]*)<\/a>/g, (link, text, name) => {
      // A call of the world's: Doxygen links some function of that name, but a member is meant.
      const member = this.made?.get('world_8hpp.html')?.headings.find(({id, html}) => id.startsWith('world-') && html.replace(/<[^>]*>/g, '') === name);
      return member ? `<a class="el" href="world_8hpp.html#${member.id}">${text}</a>` : text;
    });
  }

  /** What Doxygen describes and its lists leave out, such as what is private, is found on the page at large. */
  #present(place) {
    const [file, anchor] = place?.split('#') ?? [];
    return anchor && this.anchors.has(file) && !this.anchors.get(file).has(anchor) ? file : place;
  }

  /** What a function is given: each quantity, and what else is told of that function by name. */
  #given(owner, name, parameters) {
    const told = parameters.map(({name: parameter, has_unit, type}) => [parameter, this.parameters_of[`${owner}/${name}`]?.[parameter] ??
      this.parameters_of[name]?.[parameter] ?? ((has_unit && this.parameters[parameter]) || this.parameters_by_type[owner]?.[type]), type]);
    // A type says enough where the table is there for the others.
    const by_type = type => this.parameters_by_type.any?.[type.replace(/<.*>/, '').replace(/\s*&/, ' &').trim()];
    const rows = told.flatMap(([parameter, known, type]) => (known || by_type(type) ? [[parameter, ...(known || by_type(type))]] : []));
    if (!told.some(([, known]) => known)) return '';
    const columns = ['argument', 'what', 'unit', 'axes'].map((head, n) => ({head, n})).filter(({n}) => rows.some(row => row[n]));
    const cell = (text, n) => (n === 0 ? `<code>${text}</code>` : escape(text ?? ''));
    const line = row => `<tr>${columns.map(({n}) => `<td>${cell(row[n], n)}</td>`).join('')}</tr>`;
    const head = columns.map(({head}) => `<th scope="col">${head}</th>`).join('');
    return `<div class="scroll"><table class="given"><thead><tr>${head}</tr></thead><tbody>${rows.map(line).join('')}</tbody></table></div>`;
  }

  /** Overloads that follow one another and have no words of their own stand below the first one's declaration. */
  #by_description(rows) {
    const groups = [];
    for (const row of rows)
      if (groups.length && name_in(groups.at(-1)[0].right) === name_in(row.right) && !this.descriptions.get(row.id)?.doc && !row.brief) groups.at(-1).push(row);
      else groups.push([row]);
    return groups;
  }

  /** Each type that has a page leads to it; the name that is declared needs no link to itself. */
  #with_types(html, id) {
    const parts = html.split(/(<a [^>]*>[\s\S]*?<\/a>|<[^>]*>|&\w+;)/);
    return parts.map(part => {
      if (/^<a [^>]*>[a-z]/.test(part)) return part.replace(/<[^>]*>/g, ''); // an argument that is called like a function
      if (part.startsWith('<a ')) return part.includes(`#${id.replace(/^\w+-/, '')}"`) ? part.replace(/<[^>]*>/g, '') : part;
      return /^[<&]/.test(part) ? part : part.replace(/\b[A-Z]\w+\b/g, word => (this.by_class.get(word) ? `<a class="el" href="${this.by_class.get(word)}">${word}</a>` : word));
    }).join('');
  }

  #declaration({id, template, left, right}, address = '') {
    const about = this.descriptions.get(id);
    const line = about?.line ? ` <a class="line-link" href="${about.line}">source</a>` : '';
    return `<p class="declaration"${address}>${declared(template, this.#with_types(declaration(`${about?.before ?? ''}${left} ${right}`), id))}${line}</p>`;
  }

  #member([first, ...overloads], owner, taken, level) {
    const {id, right, brief} = first;
    const about = this.descriptions.get(id);
    const name = name_in(right);
    const address = row => {
      const is_new = !taken.has(row.id);
      taken.add(row.id);
      return is_new ? ` id="${row.id}"` : '';
    };
    // What a function is given stands beside its declaration, before a derivation of many lines.
    const told = (about ? about.doc : brief && `<p>${brief}</p>`) || '';
    const [exceptions = ''] = /<dl class="exception">[\s\S]*?<\/dl>/.exec(told) ?? [];
    const doc = told.replace(exceptions, '');
    const given = this.#given(owner, name, about?.parameters ?? []);
    const [, begin, rest] = /^([\s\S]*?<\/p>)([\s\S]*)$/.exec(plain(doc).length > longest_before_given ? doc : '') ?? [, doc, ''];
    return (
      `<${level}${address(first)}>${escape(name)}</${level}>` +
      this.#declaration(first) + overloads.map(row => this.#declaration(row, address(row))).join('') + begin + given + rest + this.#with_handles(exceptions, owner, name, about?.parameters ?? [])
    );
  }

  /** What a function throws, and with it what each throws that is given a handle. */
  #with_handles(exceptions, owner, name, parameters) {
    const types = parameters.filter(({name: parameter}) => !this.parameters_of[`${owner}/${name}`]?.[parameter]).map(({type}) => type);
    const rows = [...new Set(types)].flatMap(type => this.throws_by_type[owner]?.[type] ?? [])
      .map(([thrown, when]) => `<tr><td class="paramname">${escape(thrown)}</td><td>${escape(when)} </td></tr>`).join('');
    if (!rows) return exceptions;
    return exceptions ? exceptions.replace('</table>', `${rows}</table>`)
      : `<dl class="exception"><dt>Exceptions</dt><dd><table class="exception">${rows}</table></dd></dl>`;
  }

  /** What a member is for that an effect has because the world asks for it. */
  #asked({id, right, brief}) {
    if (brief || this.descriptions.get(id)?.doc) return undefined;
    const name = name_in(right);
    return (/\bfirst\b/.test(plain(right)) && this.asked_of_effects.get(`${name}/2`)) || this.asked_of_effects.get(name);
  }

  /** Those members of a class, in one table. */
  #table_of_asked(rows) {
    if (!rows.length) return '';
    const line = row => `<tr id="${row.id}"><td>${this.#declaration(row)}</td><td class="what">${this.#asked(row)}</td></tr>`;
    return `<div class="scroll"><table class="fields asked"><thead><tr><th scope="col"><a href="effects.html#effects_members">member of an effect</a></th>` +
      `<th scope="col">what</th></tr></thead><tbody>${rows.map(line).join('')}</tbody></table></div>`;
  }

  #fields(rows, are_of_effect) {
    const lines = rows.map(({id, left, right}) => {
      const told = this.descriptions.get(id)?.doc ?? '';
      const [begins = '', long] = /^<b>Initial value:<\/b><div class="fragment">([\s\S]*?)<\/div><!-- fragment -->/.exec(told) ?? [];
      const own = told.slice(begins.length).trim().replace(/^<p\s*>|<\/p>\s*$/g, '');
      const doc = own || (are_of_effect && this.asked_of_effects.get(name_in(right))) || '';
      const [, first, short] = /^(.*?)(?: = ?(.*))?$/.exec(declaration(right));
      const [, field, taken = ''] = /^(.*?)(?: ?(\)\(.*))?$/.exec(first); // the second is of a pointer to a function
      const value = short ?? (long && escape(plain(long.replace(/<div class="ttc"[\s\S]*?<\/div><\/div>/g, ''))).replace(/^\s*=\s*/, ''));
      const {line} = this.descriptions.get(id) ?? {};
      const shown = value && plain(value).length > longest_default && line ? `<a href="${line}">see source</a>` : value && `<code>${value}</code>`;
      return {id, cells: [...[field, declaration(left) + taken].map(cell => cell && `<code>${cell}</code>`), shown, doc]};
    });
    const columns = ['field', 'type', 'default', 'what'].map((text, n) => ({text, n})).filter(({n}) => lines.some(({cells}) => cells[n]));
    const head = columns.map(({text}) => `<th scope="col">${text}</th>`).join('');
    const body = lines.map(({id, cells}) => `<tr id="${id}">${columns.map(({text, n}) => `<td class="${text}">${cells[n] ?? ''}</td>`).join('')}</tr>`);
    return `<div class="scroll"><table class="fields"><thead><tr>${head}</tr></thead><tbody>${body.join('')}</tbody></table></div>`;
  }

  /** The first lines of a class: what it is a template of, and its bases with links to them. */
  #begun(head, header, name, source) {
    const [kind = head?.[2] ?? 'struct', bases] = beginning(header.text, name);
    const linked = bases && escape(bases).replace(/\w+/g, word => {
      const place = this.by_class.get(word);
      return place ? `<a class="el" href="${place}">${word}</a>` : word;
    });
    return `<p class="declaration">${declared(head?.[1], `${kind} ${escape(name)}${linked ? ` : ${linked}` : ''}`)} <a class="line-link" href="${source}">source</a></p>`;
  }

  #compound({file, source}, header, taken, headings) {
    const {title, contents} = this.written[file];
    const name = title.replace(/ (?:Class|Struct|Union|Concept)?\s*(?:Template )?Reference$/, '').replace(/< .* >|^tumble::/g, '');
    const id = this.#id_of(file);
    headings.push({level: 2, id, html: escape(name)});
    const described =
      /<a name="details" id="details"><\/a><h2 class="groupheader">Detailed Description<\/h2>\s*<div class="textblock">([\s\S]*?)<\/div>\s*(?=<h2 class="groupheader"|$)/.exec(
        contents,
      )?.[1] ?? '';
    const head = /<div class="compoundTemplParams">([\s\S]*?)<br \/>\s*(class|struct|union)/.exec(described);
    const definition = /<h2 class="groupheader">Concept definition<\/h2>\s*(<div class="fragment">[\s\S]*?<!-- fragment -->)/.exec(contents)?.[1]
      .replace(/tumble::(?=\w+<\/a>)/, '').replace(/<a [^>]*>(\w+)<\/a> = {2}(<span class="keyword">requires[\s\S]*)/, (_, called, body) =>
        `${called} =</div><div class="line">  ${body.replace(/<div class="line">/g, '<div class="line">  ')}`);
    const doc = described
      .replace(/<div class="compoundTemplParams">[\s\S]*?<\/div>/, '')
      .replace(/<p class="definition">[\s\S]*?<\/p>/g, '');
    const rows = rows_of(contents)
      .filter(({kind}) => !/^(pri|pro)-|inherit/.test(kind))
      .map(row => ({...row, id: `${id}-${row.id}`}));
    const fields = rows.filter(({kind}) => /attribs/.test(kind));
    const functions = rows.filter(({kind}) => !/attribs|nested/.test(kind) && kind !== 'friends');
    const told_by_all = functions.filter(row => this.#asked(row));
    const asked = told_by_all.filter(row => name_in(row.right) !== 'broadcast'); // of no use to a reader
    const members = functions.filter(row => !told_by_all.includes(row));
    header.fields.push(...[...fields, ...asked].map(row => ({id: row.id, owner: name, name: name_in(row.right)})));
    const parts = parts_of(header.text);
    let part;
    const overview = [];
    const told = this.#by_description(members).map(group => {
      const [row] = group;
      const line = Number(/#l(\d+)/.exec(this.descriptions.get(row.id)?.line)?.[1]);
      const begun = parts.findLast(each => each.line < line);
      const opens = begun && begun !== part;
      part = begun ?? part;
      if (opens) overview.push({name: part.name, links: new Map()});
      const {links} = overview.at(-1) ?? {};
      if (links && !links.has(name_in(row.right))) links.set(name_in(row.right), row.id);
      if (opens) headings.push({level: 3, id: slug(part.name), html: `<b>${escape(part.name)}</b>`});
      if (headings.at(-1).html !== escape(name_in(row.right))) headings.push({level: 3, id: row.id, html: escape(name_in(row.right))});
      return (opens ? `<h3 class="part" id="${slug(part.name)}">${escape(part.name)}</h3>` : '') + this.#member(group, name, taken, 'h3');
    });
    return (
      `<h2 id="${id}">${escape(name)}</h2>` +
      `${definition ?? this.#begun(head, header, name, source)}${doc}${fields.length ? this.#fields(fields, asked.length > 0) : ''}${this.#table_of_asked(asked)}${overview_of(overview)}${told.join('')}`
    );
  }

  /** The headers that one brings along. */
  #brought_by(header, known = new Set()) {
    for (const other of this.included.get(header) ?? []) if (!known.has(other)) this.#brought_by(other, known.add(other));
    return known;
  }

  /** How a header is used, with what a program includes for it: the headers of the names in it that no other of them brings along. */
  #example(header) {
    const of = this.examples.get(header.name.split('/').at(-1));
    if (!of) return '';
    const linked = [...of.lines.join('').matchAll(/(?<!\.)<a class="code[^"]*" href="([^"]*)"/g)].map(([, href]) => this.places.get(href)?.replace(/#.*/, '') ?? href.replace(/#.*/, ''));
    const used = new Set(this.headers.filter(({file, name}) => linked.includes(file) || of.names.includes(name.split('/').at(-1))).map(({name}) => name));
    const needed = [...used].filter(name => ![...used].some(other => other !== name && this.#brought_by(other).has(name))).sort();
    const line = html => `<div class="line">${html}</div>`;
    const text = plain(of.lines.join('\n'));
    const standard = ['map', 'sstream'].filter(name => text.includes({map: 'std::map', sstream: 'std::stringstream'}[name]));
    const includes = [...standard.map(name => line(`<span class="preprocessor">#include &lt;${name}&gt;</span>`)), ...needed.map(name => line(`<span class="preprocessor">#include &lt;${name}&gt;</span>`)), line('')];
    const caption = `<figcaption>${escape(of.test)}: <a href="${of.file}#${of.line}"><code>${escape(this.written[of.file].title.replace(/ Source File$/, '').split('/').at(-1))}</code></a></figcaption>`;
    return `<figure class="listing">${caption}<div class="fragment">${includes.join('\n')}\n${at_left_edge(`${of.lines.map(line).join('\n')}</div>`)}</figure>`;
  }

  #page(header) {
    const {contents} = this.written[header.file];
    const taken = new Set();
    const lessons = this.lessons.get(header.path) ?? [];
    const taught = [...(header.page ? [{address: header.page.file, name: header.page.name}] : []), ...lessons]
      .map(({address, name}) => `<a href="${address}">${escape(name)}</a>`)
      .join('; ');
    const own = rows_of(contents).filter(({kind}) => !/nested|namespaces|concepts/.test(kind));
    const shown = own.filter(({kind, id}) => kind !== 'typedef-members' || this.descriptions.get(id)?.doc);
    const aliases = own.filter(row => !shown.includes(row));
    // What the example uses comes before what that is made of, and types before functions.
    const example = this.#example(header);
    const parts = [
      ...(header.compounds ?? []).map(compound => {
        const headings = [];
        return {html: this.#compound(compound, header, taken, headings), headings, is_used: example.includes(`"${compound.file}"`)};
      }),
      ...this.#by_description(shown).map(group => {
        const [{id, right}] = group;
        const goes_on = /^<p>\s*The same\b/.test(this.descriptions.get(id)?.doc ?? ''); // it says so of what stands before it
        return {html: this.#member(group, header.name, taken, 'h2'), headings: [{level: 2, id, html: escape(name_in(right))}], is_used: !goes_on && (example.includes(`#${id}"`) || new RegExp(`\\b${name_in(right)}<\\w+>\\(`).test(plain(example)))};
      }),
    ];
    const is_inner = ({headings: [{html}], is_used}) => this.inner.has(html) && !is_used;
    const inner = parts.filter(is_inner), others = parts.filter(part => !part.is_used && !is_inner(part));
    const apart = inner.length && inner.length < parts.length ? [{html: '<h2 class="part" id="inner">Used by the library itself</h2>', headings: [{level: 2, id: 'inner', html: '<b>Used by the library itself</b>'}]}] : [];
    const ordered = [...parts.filter(({is_used}) => is_used), ...others, ...apart, ...inner];
    // A list names each function once, and the members of a class once below it.
    const listed = new Set();
    let owner;
    const headings = ordered.flatMap(part => part.headings).filter(({level, html}) => {
      owner = level === 2 || html.startsWith('<b>') ? html : owner; // or a part of it
      const called = level === 2 ? html : `${owner}::${html}`;
      return !listed.has(called) && listed.add(called);
    });
    const [, told] = /<h2 class="groupheader">Detailed Description<\/h2>\s*<div class="textblock">([\s\S]*?)(?:<p class="definition">|<\/div>\s*(?:<h2|$))/.exec(contents) ?? [, `<p>${escape(header.brief)}</p>`];
    const also = aliases.length
      ? `<p class="facts">Also: ${aliases.map(({id, right}) => `<code id="${id}">${declaration(right)}</code>`).join(', ')}.</p>`
      : '';
    const names = new Map(headings.map(({id, html}) => [plain(html), id]));
    // Of two functions with one name Doxygen links either: the one that stands here is meant.
    const with_own = html => html.replace(/<a class="el" href="[^"]*">((\w+)\(\))<\/a>/g, (link, text, name) => (names.has(name) ? `<a class="el" href="#${names.get(name)}">${text}</a>` : link));
    return {
      title: header.name,
      headings,
      contents:
        `${told}<p class="facts"><code>#include &lt;<a href="${header.source}">${header.name}</a>&gt;</code><br>` +
        `${taught ? `Taught in ${taught}.` : ''}${header.is_brought ? ' Others bring it along: a program seldom includes it.' : ''}</p>${also}${example}${with_own(ordered.map(({html}) => html).join(''))}`,
    };
  }
}

/** From a header's path to the sections that quote it: {address, name}. */
export function lessons_of(pages) {
  const lessons = new Map();
  for (const page of pages.all) {
    let heading;
    for (const {text} of page.lines) {
      const [, title, id] = /^##+ (.*?)(?: \{#(\w+)\})?\s*$/.exec(text ?? '') ?? [];
      if (title) heading = {address: `${page.file}#${id ?? slug(title.replace(/`/g, ''))}`, name: title.replace(/`/g, '')};
      const [, file] = /^\{\{snippet (\S+\.hpp) /.exec(text ?? '') ?? [];
      if (!file || !heading || !page.chapter) continue;
      const path = join(page.path, '..', file);
      const known = lessons.get(path) ?? [];
      if (!known.some(({address}) => address === heading.address)) lessons.set(path, [...known, heading]);
    }
  }
  return lessons;
}
