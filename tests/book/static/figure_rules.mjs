// A reader who cannot see a figure is told what it shows, and paper gets a picture of what moves.
const is_picture = ({name, attributes}) =>
  ['img', 'svg', 'object', 'iframe'].includes(name) || attributes.role === 'img';

// A formula carries its MathML, a button its own label; both hide what is only drawn.
const is_not_for_reading = element =>
  element.attributes['aria-hidden'] === 'true' || element.has_class('katex') || element.name === 'button';

const plain = text => text.trim().toLowerCase().replace(/[.!?]$/, '');
const file_name = address => decodeURIComponent(address).split('/').pop();

/// The titles in the drawing, and the caption of the <figure> around it.
function titles_of(picture) {
  let outermost = picture;
  while (outermost.parent?.is_inside(({name}) => name === 'figure')) outermost = outermost.parent;
  return outermost.find(({name}) => ['title', 'text', 'figcaption'].includes(name)).map(title => plain(title.text()));
}

function what_is_wrong(figure) {
  const {attributes} = figure;
  const description = (attributes.alt ?? attributes['aria-label'] ?? '').trim();
  if (!description) return 'has no alternative text';
  if (titles_of(figure).includes(plain(description))) return `only repeats its title: "${description}"`;
  const name = plain(file_name(attributes.src ?? attributes.data ?? ''));
  if ([name, name.replace(/\.\w+$/, '')].includes(plain(description))) {
    return `only repeats its file's name: "${description}"`;
  }
  if (description.length <= 20) return `is described in 20 letters or fewer: "${description}"`;
  if (!/[.!?]$/.test(description)) return `is not described by a sentence: "${description}"`;
  return undefined;
}

export function* every_figure_says_what_it_shows(book) {
  for (const page of book.pages.values()) {
    for (const figure of page.elements.filter(is_picture)) {
      if (figure.is_inside(is_not_for_reading) || figure.parent.is_inside(is_picture)) continue;
      const problem = what_is_wrong(figure);
      if (problem) yield {path: page.path, line: figure.line, problem: `the figure ${problem}`};
    }
  }
}

export function* every_player_has_a_still_picture(book) {
  for (const page of book.pages.values()) {
    for (const view of page.with_class('player-view')) {
      const stills = view.find(element => element.name === 'svg' && element.has_class('player-still'));
      const is_drawn = stills.some(still => still.find(({name}) => name === 'polygon' || name === 'circle').length > 0);
      if (!is_drawn) yield {path: page.path, line: view.line, problem: 'the player has no still picture'};
      else if (!view.is_inside(is_picture)) {
        yield {path: page.path, line: view.line, problem: 'the still picture of the player has no alternative text'};
      }
    }
  }
}
