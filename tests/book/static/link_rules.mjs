// Where the book's addresses may lead.
import {addresses, destination} from './addresses.mjs';

export function* every_link_leads_somewhere(book) {
  for (const {path, line, address} of addresses(book)) {
    const {file, fragment} = destination({path, address});
    if (!file) continue;
    if (!book.files.has(file)) {
      yield {path, line, problem: `"${address}" leads to no file of the book`};
    } else if (fragment && book.pages.has(file) && !book.pages.get(file).anchors.has(fragment)) {
      yield {path, line, problem: `"${address}" leads to no anchor of ${file}`};
    }
  }
}

export function* nothing_refers_outside(book) {
  for (const {path, line, address, loaded} of addresses(book)) {
    if (!destination({path, address}).outside) continue;
    if (loaded) {
      yield {path, line, problem: `"${address}" would be loaded from outside the book`};
    } else if (!/^(https:\/\/|mailto:)/.test(address)) {
      yield {path, line, problem: `"${address}" leaves the book, and is no https:// link to a source`};
    }
  }
}

export function* every_id_is_unique(book) {
  for (const page of book.pages.values()) {
    const lines = new Map();
    for (const {attributes: {id}, line} of page.ids) {
      if (lines.has(id)) {
        yield {path: page.path, line, problem: `the id "${id}" stands on line ${lines.get(id)} already`};
      }
      lines.set(id, line);
    }
  }
}
