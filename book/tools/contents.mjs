// From what Doxygen wrote between a page's header and footer to what the book shows there.
import {escape, plain, slug} from './text.mjs';

/** Blanks that set code under code; on a phone they would only push it to the edge. */
const far = blanks => `<span class="far">${blanks}</span>`;
const longest_indentation = 8; // letters, on a phone

/**
 * A piece from inside a function, moved to the left edge, and each line with its indentation, under which it goes on if it is too long.
 */
export function at_left_edge(fragment) {
  const starts = [...fragment.matchAll(/<div class="line">((?:<a [^>]*><\/a>)?)( *)(?=[^ ])(?!<\/div>)/g)];
  const indentation = Math.min(...starts.map(([, , blanks]) => blanks.length));
  const moved = indentation > 0 && Number.isFinite(indentation)
    ? fragment.replace(new RegExp(`(<div class="line">(?:<a [^>]*></a>)?) {${indentation}}`, 'g'), '$1') : fragment;
  return moved
    .replace(/(?<=[^ >]|<\/\w+>) {2,}(?=<span class="comment">)/g, blanks => ` ${far(blanks.slice(1))}`)
    .replace(/<div class="line">((?:<a [^>]*><\/a>)?)( +)(?=[^ ])/g, (_, anchor, blanks) => {
      const seen = blanks.slice(0, longest_indentation), more = blanks.slice(longest_indentation);
      return `<div class="line" style="--in:${seen.length}">${anchor}${seen}${more && far(more)}`;
    });
}

/** A block of commands line by line, and what each of them is told to do apart, which on a phone stands below it. */
const with_lines = commands => commands.replace(/\n$/, '').split('\n').map(line =>
  `<span class="line">${`${line}\n`.replace(/^(\S.*?\S)( {3,})(\S.*\n)$/, (_, command, blanks, told) => `${command}${far(blanks)}<span class="told">${told}</span>`)}</span>`).join('');

/** Puts the directives' blocks where their markers stand, and gives each listing its caption. */
function with_blocks(html, blocks) {
  return html
    .replace(
      /<tumble-listing id="(\d+)"><\/tumble-listing>\s*(<div class="fragment">[\s\S]*?<\/div><!-- fragment -->)/g,
      (_, id, fragment) => `<figure class="listing"><figcaption>${blocks[id]}</figcaption>${at_left_edge(fragment)}</figure>`,
    )
    .replace(/<p[^>]*>\s*((?:<tumble-block id="\d+"><\/tumble-block>\s*)+)<\/p>/g, '$1')
    .replace(/<tumble-block id="(\d+)"><\/tumble-block>/g, (_, id) => (typeof blocks[id] === 'function' ? blocks[id]() : blocks[id]));
}

/** Doxygen's ways with HTML that a reader or a browser would stumble over. */
function tidy(html) {
  return html
    .replace(/<div class="ttc"[\s\S]*?<\/div><\/div>\n/g, '') // hidden notes for a script that we don't have
    .replace(
      /<div class="line">\/\/! \[\w+\]<\/div>\n|<div class="line"><span class="comment">\/\/! \[\w+\]<\/span><\/div>\n/g,
      '',
    )
    .replace(/<div class="line"[^>]*>\s*<span class="comment">\/\/ NOLINT[^<]*<\/span><\/div>\n/g, '') // said to a tool, and to no reader
    .replace(/(\w)<span class="keyword(?:type)?">(\w+)<\/span>(?=\w)/g, '$1$2') // the "id" in "width" is no keyword
    .replace(/(<a\b[^>]*?) name="[^"]*"(?=[ >])/g, '$1')
    .replace(/ (align|valign|border|cellspacing|cellpadding)="[^"]*"/g, '')
    .replace(/(?<=\.)<a class="code hl_function" href="[^"]*#a\w+">(\w+)<\/a>|<a class="code hl_function" href="[^"]*#a\w+">([A-Z]\w*::\w+)<\/a>/g, '$1$2') // a member, and no free function of its name
    .replace(/<a class="code hl_function" href="[^"]*">(\w+)<\/a>(?!\(|&lt;)/g, '$1') // a variable that is called like a function
    .replace(/&lt;tt&gt;(.*?)&lt;\/tt&gt;/g, '<code>$1</code>') // `code` in a heading
    .replace(/<a href="[^"]*">More\.\.\.<\/a>/g, '')
    .replace(/(<pre class="fragment">)([\s\S]*?)(?=<\/pre>)/g, (_, tag, commands) => tag + with_lines(commands))
    .replace(/<p >/g, '<p>')
    .replace(/<p>\s*<\/p>/g, '')
    .replace(/<tt>/g, '<code>')
    .replace(/<\/tt>/g, '</code>')
    .replace(/<p class="definition">[\s\S]*?<\/p>/g, all =>
      all.replace(/^<p class="definition">Definition at/, '<p class="definition">Defined at'),
    );
}

/** Headings one level down, since the page's title is the first; each gets an address that does not change with its number. */
function with_headings(html, is_page) {
  const headings = [],
    taken = new Set();
  const result = html.replace(
    /<h([1-5])([^>]*)>\s*(?:<a class="anchor" id="([^"]*)"><\/a>)?\s*([\s\S]*?)<\/h\1>/g,
    (all, level, attributes, id, text) => {
      if (!is_page) return all;
      let address = id && !id.startsWith('autotoc') ? id : slug(plain(text));
      while (taken.has(address)) address += '_';
      taken.add(address);
      headings.push({level: Number(level) + 1, id: address, html: text.trim()});
      const tag = `h${Number(level) + 1}`;
      return `<${tag} id="${address}">${text.trim()} <a class="anchorlink" href="#${address}" aria-label="Link to this section">#</a></${tag}>`;
    },
  );
  return {html: result, headings};
}

function in_scrollers(html) {
  return html
    .replace(
      /<table class="(markdownTable[^"]*|doxtable|params|exception|tparams|retval|memname|memberdecls)">[\s\S]*?<\/table>/g,
      table => `<div class="scroll">${table}</div>`,
    )
    .replace(/<div class="scroll">(<table class="memname">)/g, '<div class="scroll prototype">$1');
}

/**
 * The first row of a table of ours is its head, which a printed page repeats. Each cell knows its column's name, since a phone sets the
 * cells of a row one below another if there are many; and a long name in code may break at its joints.
 */
function with_heads(html) {
  return html
    .replace(/(<table class="markdownTable)(">)\s*(<tr class="markdownTableHead">[\s\S]*?<\/tr>)([\s\S]*?)(?=<\/table>)/g, (_, begin, end, head, rows) => {
      const names = [...head.matchAll(/<th\b[^>]*>([\s\S]*?)<\/th>/g)].map(([, name]) => plain(name).trim());
      let n = 0;
      const named = rows.replace(/<tr\b|<td\b/g, tag => (tag === '<tr' ? ((n = 0), tag) : `<td data-label="${escape(names[n++] ?? '')}"`));
      return `${begin}${names.length > 3 ? ' many-columns' : ''}${end}<thead>${head}</thead><tbody>${named}</tbody>`;
    })
    .replace(/<td\b[^>]*>[\s\S]*?<\/td>/g, cell => cell.replace(/<code>[\w./:]{12,}<\/code>/g, code => code.replace(/(?<=\w)(_|::|\/)(?=\w)/g, '$1<wbr>')));
}

/**
 * {html, headings} of one page; `sources` leads from a file's path to the page that shows it, `headers` are {path, file} of the
 * reference's.
 */
export function finish_contents(contents, {blocks, sources, headers, is_page}) {
  const {html, headings} = with_headings(tidy(with_blocks(contents, blocks)), is_page);
  return {
    headings,
    html: in_scrollers(with_heads(html.replace(/<p>(?=(?:(?!<\/?p>)[\s\S])*:\s*<\/p>\s*<figure)/g, '<p class="leads">')))
      .replace(/href="header:([^"#]*)/g, (_, path) => `href="${headers.find(header => header.path === path).file}`)
      .replace(/href="source:([^"#]*)/g, (_, path) => {
        if (!sources.has(path)) throw new Error(`no page shows the source of ${path}`);
        return `href="${sources.get(path)}`;
      }),
  };
}
