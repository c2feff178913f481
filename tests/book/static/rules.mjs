// The rules by name.
import {every_link_leads_somewhere, nothing_refers_outside, every_id_is_unique} from './link_rules.mjs';
import {every_figure_says_what_it_shows, every_player_has_a_still_picture} from './figure_rules.mjs';
import * as text_rules from './text_rules.mjs';

export const rules = {
  every_link_leads_somewhere,
  nothing_refers_outside,
  every_id_is_unique,
  every_figure_says_what_it_shows,
  every_player_has_a_still_picture,
  ...text_rules,
};

/// Every fault of the book as {rule, path, line, problem}.
export function faults(book) {
  return Object.entries(rules).flatMap(([rule, find]) => [...find(book)].map(fault => ({rule, ...fault})));
}
