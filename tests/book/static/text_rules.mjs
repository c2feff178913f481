// What the book's tools must not leave behind in the text.
const is_code = element => element.has_class('fragment') || element.name === 'pre';
const is_formula = element => element.has_class('katex');
const is_prose = element => !element.is_inside(is_code) && !element.is_inside(is_formula);

/// Where an element's own words, not those of its children, match the pattern; of the elements that `is_read` accepts.
function* own_words_matching(book, pattern, is_read) {
  for (const page of book.pages.values()) {
    for (const element of page.elements) {
      if (['script', 'style'].includes(element.name) || !is_read(element)) continue;
      const match = pattern.exec(element.children.filter(child => typeof child === 'string').join(' '));
      if (match) yield {path: page.path, line: element.line, found: match[0].trim()};
    }
  }
}

export function* every_snippet_has_code(book) {
  for (const page of book.pages.values()) {
    for (const snippet of page.with_class('fragment')) {
      if (!snippet.text().trim()) {
        yield {path: page.path, line: snippet.line, problem: 'the snippet is empty'};
      }
    }
  }
}

export function* every_directive_is_expanded(book) {
  // A directive begins with a word. C++ has double braces too, before a quote or a number, and so have formulas: of the
  // directives these may hold {{value ...}} alone. That a task has a {{parameter name}} is told to whoever writes one.
  const left = [...own_words_matching(book, /\{\{\s*(?!parameter name\}\})[a-z].{0,40}/, is_prose),
    ...own_words_matching(book, /\{\{value .{0,40}/, element => element.is_inside(is_formula))];
  for (const {found, ...place} of left) yield {...place, problem: `a directive was not expanded: "${found}"`};
}

export function* every_formula_is_typeset(book) {
  const raw = /(\\f[$[\]{(]|\\[()[\]]|\$\$).{0,40}/;
  for (const {found, ...place} of own_words_matching(book, raw, is_prose)) {
    yield {...place, problem: `a formula was not typeset: "${found}"`};
  }
}

export function* every_emphasis_is_set(book) {
  // Doxygen leaves the stars where a quotation mark follows or precedes them.
  const raw = /(^|\s)\*+["'\u201c\u2018(]?\w[^*]{2,}\*/;
  for (const {found, ...place} of own_words_matching(book, raw, element => ['p', 'li', 'td'].includes(element.name))) {
    yield {...place, problem: `an emphasis was not set: "${found}"`};
  }
}

export function* every_code_in_a_line_is_marked(book) {
  // Newer Doxygen writes a span for it, which no style of ours knows.
  for (const page of book.pages.values()) {
    for (const element of page.elements) {
      if (element.has_class('tt')) yield {path: page.path, line: element.line, problem: 'code in a line is no <code>'};
    }
  }
}

export function* every_fold_is_closed(book) {
  // A parser would close it at the end of the page, and fold away all that follows.
  for (const page of book.pages.values()) {
    const count = tag => page.source.split(tag).length - 1;
    if (count('<details') !== count('</details>')) yield {path: page.path, line: 1, problem: 'a fold is not closed'};
  }
}

export function* every_page_says_what_it_is_about(book) {
  // In its head, for search engines and messengers; where it has a preview, that is a picture of the book.
  for (const page of book.pages.values()) {
    const said = name => page.elements.find(({attributes}) => [attributes.name, attributes.property].includes(name))?.attributes.content;
    const body = page.elements.find(({name}) => name === 'body');
    const [description, picture] = [said('description') ?? (body.has_class('prose') ? '' : undefined), said('og:image')];
    if (description !== undefined && !/^.{30,}[.?!]$/.test(description))
      yield {path: page.path, line: 1, problem: `its description is no sentence: "${description}"`};
    if (picture && !book.files.has(picture.replace(/^https:.*\/(?=previews\/)/, '')))
      yield {path: page.path, line: 1, problem: `its preview is missing: ${picture}`};
  }
}

export function* every_formula_is_valid(book) {
  for (const page of book.pages.values()) {
    for (const element of page.elements) {
      // What KaTeX cannot read it prints in this colour.
      const is_wrong = element.has_class('katex-error')
        || (element.is_inside(is_formula) && /#cc0000/i.test(element.attributes.style ?? ''));
      if (is_wrong) {
        yield {path: page.path, line: element.line, problem: `KaTeX could not read "${element.text()}"`};
      }
    }
  }
}

export function* every_check_has_a_verdict(book) {
  for (const page of book.pages.values()) {
    for (const check of page.with_class('check')) {
      const [verdict] = check.find(element => element.has_class('verdict'));
      if (!/\b(passed|failed)\b/.test(verdict?.text() ?? '')) {
        yield {path: page.path, line: check.line, problem: `no verdict: "${check.text().trim()}"`};
      }
    }
  }
}

export function* no_text_names_this_machine(book) {
  for (const [path, text] of book.texts) {
    for (const folder of book.machine_paths) {
      const position = text.indexOf(folder);
      if (position < 0) continue;
      const line = text.slice(0, position).split('\n').length;
      yield {path, line, problem: `names a folder of the machine that made it, ${folder}`};
    }
  }
}

export function* no_search_finds_a_spoiler(book) {
  const said = text => text.replace(/\s+/g, ' ').trim();
  const start = 'window.bookIndex = ';
  const found = [...book.texts.values()].filter(text => text.startsWith(start))
    .flatMap(text => JSON.parse(text.slice(start.length, text.lastIndexOf('}') + 1)).documents)
    .map(({section, text}) => `${section} ${text}`).join('\n');
  for (const page of book.pages.values()) {
    for (const spoiler of [...page.with_class('spoiler'), ...page.with_class('gate')]) {
      const paragraphs = spoiler.find(({name}) => ['p', 'li', 'summary'].includes(name))
        .filter(paragraph => !paragraph.find(is_formula).length);
      const told = paragraphs.map(paragraph => said(paragraph.text())).find(text => text.length > 30 && found.includes(text));
      if (told) yield {path: page.path, line: spoiler.line, problem: `a search finds what is folded away: "${told}"`};
    }
  }
}

/// The words of a page below an element, less what is folded or behind a gate, and less what paper alone shows.
function open_words_below(page, start) {
  const is_shut = element => element.name === 'details' || ['gate', 'on-paper'].some(name => element.has_class(name));
  let is_below = false, words = '';
  const read = element => {
    if (element === start) is_below = true;
    else if (!is_shut(element) && !['script', 'style'].includes(element.name)) {
      for (const child of element.children) {
        if (typeof child !== 'string') read(child);
        else if (is_below) words += child;
      }
      words += is_code(element) || ['p', 'li', 'td', 'th', 'figcaption'].includes(element.name) ? '\n' : '';
    }
  };
  read(page.root);
  return words.replace(/\u00a0/g, ' ');
}

/// Numbers in a text, {digits, value, unit}: how many count, and the word behind it.
function numbers_in(text) {
  const plain_power = (_, power) => `e${[...power].map(sign => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(sign) - 1).join('').replace('-1', '-')}`;
  const plain = text.replace(/\u00a0/g, ' ').replace(/−/g, '-').replace(/ × 10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/g, plain_power);
  return [...plain.matchAll(/(?<![\w./])(-?[\d.]*\d(?:e[+-]?\d+)?)(?: ?([a-zµ°%]+(?:\/\w+)?))?/gi)].map(([, number, unit = '']) =>
    ({digits: number.replace(/e.*/, '').replace(/^[-0.]+/, '').replace(/\D/g, '').length, value: Number(number), unit}));
}

export function* no_page_answers_its_question(book) {
  for (const page of book.pages.values()) {
    for (const form of page.with_class('prediction')) {
      const open = open_words_below(page, form), open_numbers = numbers_in(open);
      const answer = form.find(({name}) => name === 'p').map(paragraph => paragraph.text()).join(' ');
      // Only a number with a unit is like another, and not where much is measured that has it: that changes with every run.
      const number = numbers_in(answer).find(told => told.digits >= 2 && told.unit && !['times', 'ns', 'µs', 'ms', '%'].includes(told.unit) &&
        open_numbers.some(({digits, value, unit}) => digits >= told.digits && Number(value.toPrecision(told.digits)) === told.value && unit === told.unit));
      const sentence = answer.split(/(?<=[.:]) /).find(told => told.length > 20 && open.includes(told.replace(/[.:]$/, '')));
      const told = sentence ?? (number && `${number.value} ${number.unit}`);
      if (told) yield {path: page.path, line: form.line, problem: `what answers "${form.attributes['data-prediction']}" stands outside its gate: "${told.trim()}"`};
    }
  }
}
