// Which places of the book answer a question best. The page's search box uses it, and the test that asks it forty questions.
// A place counts for each word that it holds: most in its heading, then among the terms it defines, then in its text. Words that
// mean the same find each other, and a place that lacks a word can still be the best one.
(() => {
  const stop_words = new Set(
    ('a about all an and any are as at be by can cannot could did do does for from get gets had has have how i if in into is it its ' +
      'me mine my no not of on or our should so than that the their them then there these they this to was we were what when where ' +
      'which while who why will with would you your').split(' '),
  );

  /** What the forms of a word share: turned, turning and turns are "turn". It need be no word itself. */
  function stem(word) {
    if (word.length < 4 || /\d/.test(word)) return word;
    let bare = word
      .replace(/(.{2})is$/, '$1')
      .replace(/ies$/, 'y')
      .replace(/(ss|x|ch|sh)es$/, '$1')
      .replace(/([^su])s$/, '$1');
    const shorter = bare.replace(/(?:ational|ation|ating|ion|ing|ed|ely|ly)$/, '');
    if (shorter.length >= 3 && /[aeiouy]/.test(shorter)) bare = shorter;
    return bare.replace(/([bdfgmnprt])\1$/, '$1').replace(/(.{2})(?:ate|at|e)$/, '$1');
  }

  const words_of = text => text.toLowerCase().normalize('NFC').split(/[^\p{L}\p{N}_]+/u).filter(Boolean);
  const stems_of = text => words_of(text).map(stem);

  /** The documents with their words, and how many of them hold each word. `same` are groups of words and phrases. */
  function prepare(documents, same) {
    const cache = new Map();
    const cached = text => words_of(text).map(word => {
      if (!cache.has(word)) cache.set(word, stem(word));
      return cache.get(word);
    });
    const counts = new Map();
    const places = documents.map(document => {
      const fields = {
        section: cached(document.section || document.page),
        page: cached(document.page),
        terms: document.terms.map(cached),
        asked: (document.asked ?? []).map(cached),
        text: cached(document.text),
      };
      const held = new Set([...fields.section, ...fields.page, ...fields.text, ...fields.asked.flat()]);
      for (const word of held) counts.set(word, (counts.get(word) ?? 0) + 1);
      return {document, fields, held};
    });
    const groups = same.map(group => group.map(stems_of));
    return {places, groups, counts, vocabulary: [...cache.keys()]};
  }

  /** A name of the code, if that is what is asked for: World, world.step(), World::step, add_force; "add force" may be one too. */
  function name_in(question) {
    const [, owner, name] = /^(?:tumble::)?(?:(\w+)(?:::|\.|->))?(\w+)(?:\(\)?)?$/.exec(question.trim().replace(/ +/g, '_')) ?? [];
    return name && {owner: owner?.toLowerCase(), name, is_certain: /^[A-Z]\w|[_:.(>]/.test(question.trim())};
  }
  /** A name as one half remembers it: parted where its words meet, without little words, in small letters. */
  const remembered = name => name.replace(/([a-z])([A-Z])/g, '$1_$2').toLowerCase().split('_').filter(word => !stop_words.has(word)).join('_');
  const has_name = ({symbol, owner}, asked) =>
    (symbol === asked.name || (symbol?.includes('_') && remembered(symbol) === remembered(asked.name))) && (!asked.owner || asked.owner === owner?.toLowerCase());

  /** Whether one letter more, less, other or swapped makes the one word the other. */
  function is_nearly(one, other) {
    if (Math.abs(one.length - other.length) > 1 || one[0] !== other[0]) return false;
    let n = 0;
    while (n < one.length && one[n] === other[n]) ++n;
    const rest = one.slice(n), others = other.slice(n);
    return rest.slice(1) === others.slice(1) || rest.slice(1) === others || rest === others.slice(1) ||
      (rest.length > 1 && rest[0] === others[1] && rest[1] === others[0] && rest.slice(2) === others.slice(2));
  }

  /** The question with each word that the book lacks in place of one that is nearly it, or of its parts: setGravity is "set gravity". */
  function respelt(question, {counts, vocabulary}) {
    const often = word => counts.get(stem(word)) ?? 0;
    const parted = question.replace(/\w+/g, name => (often(name.toLowerCase()) ? name : name.replace(/([a-z])([A-Z])/g, '$1 $2').replaceAll('_', ' ')));
    const better = words_of(parted).map(word =>
      word.length < 4 || often(word) ? word : vocabulary.filter(known => is_nearly(word, known)).sort((one, other) => often(other) - often(one))[0] ?? word);
    return better.join(' ') === words_of(question).join(' ') ? undefined : better.join(' ');
  }

  const is_at = (words, phrase, start, prefix) =>
    phrase.every((word, n) => {
      const other = words[start + n];
      return other !== undefined && (other === word || (prefix && n === phrase.length - 1 && other.startsWith(prefix)));
    });

  function times_in(words, phrase, prefix) {
    let count = 0;
    for (let start = 0; start + phrase.length <= words.length; ++start) if (is_at(words, phrase, start, prefix)) ++count;
    return count;
  }

  /** What is looked for: of each word or phrase of the question all ways to say it. */
  function concepts_of(question, {groups, counts, places}) {
    const all = words_of(question);
    const ends_inside_a_word = /[\p{L}\p{N}_]$/u.test(question);
    const telling = all.filter(word => !stop_words.has(word));
    const words = telling.length ? telling : all.slice(-1);
    const stems = words.map(stem);
    const concepts = [];
    for (let n = 0; n < stems.length; ) {
      const said = groups
        .flatMap(group => group.filter(phrase => is_at(stems, phrase, n)).map(phrase => ({group, phrase})))
        .sort((one, other) => other.phrase.length - one.phrase.length)[0];
      const length = said?.phrase.length ?? 1;
      const phrase = stems.slice(n, n + length);
      const is_last = n + length === stems.length && ends_inside_a_word;
      const longest = said ? groups.filter(group => group.some(each => each.join(' ') === said.phrase.join(' '))).flat() : [];
      const ways = [phrase, ...longest.filter(way => way.join(' ') !== phrase.join(' '))];
      const rarity = Math.max(
        ...phrase.map(word => Math.log(1 + places.length / (1 + (counts.get(word) ?? 0)))),
      );
      const prefix = is_last && words[n + length - 1].length > 1 ? words[n + length - 1] : undefined;
      concepts.push({ways, prefix, rarity: Math.min(rarity, 6)});
      n += length;
    }
    return concepts;
  }

  /** 0 where the place lacks it; a synonym counts a little less than the reader's own word. */
  function worth(concept, fields) {
    let best = 0;
    concept.ways.forEach((way, n) => {
      const prefix = n === 0 ? concept.prefix : undefined;
      const discount = n === 0 ? 1 : 0.85;
      const text = times_in(fields.text, way, prefix);
      const value =
        Math.max(
          times_in(fields.section, way, prefix) ? 8 : 0,
          fields.asked.some(phrase => times_in(phrase, way, prefix)) ? 9 : 0,
          fields.terms.some(phrase => times_in(phrase, way, prefix)) ? 5 : 0,
          times_in(fields.page, way, prefix) ? 3 : 0,
        ) + (text ? 1 + Math.log2(text) / 2 : 0);
      best = Math.max(best, discount * value);
    });
    return best;
  }

  /** {hits: [{document, ...}], whole, ways}: `whole` says whether the best place holds every word. */
  function find(question, prepared) {
    const concepts = concepts_of(question, prepared);
    if (!concepts.length) return {hits: [], whole: true, ways: []};
    const together = concepts.reduce((sum, {rarity}) => sum + rarity, 0);
    const first_way = concepts.flatMap(({ways}) => ways[0]);
    const firsts = new Set(concepts.flatMap(({ways}) => ways.map(way => way[0])));
    const prefix = concepts.at(-1).prefix;
    const is_foreseen = ({asked}) => asked?.some(phrase => phrase.toLowerCase() === question.trim().toLowerCase());
    const hits = [];
    for (const {document, fields, held} of prepared.places) {
      if (![...firsts].some(word => held.has(word)) && !(prefix && [...held].some(word => word.startsWith(prefix)))) continue;
      const values = concepts.map(concept => worth(concept, fields));
      const covered = concepts.reduce((sum, {rarity}, n) => sum + (values[n] ? rarity : 0), 0) / together;
      if (!covered) continue;
      let score = concepts.reduce((sum, {rarity}, n) => sum + rarity * values[n], 0) / together;
      // A heading, a defined term or a question foreseen that says just this, and little else.
      const says = phrase => {
        const matched = concepts.filter(({ways}) => ways.some(way => times_in(phrase, way))).length;
        return matched === concepts.length ? Math.min(1, first_way.length / phrase.length) : 0;
      };
      score += 6 * says(fields.section);
      const foreseen = is_foreseen(document) ? 2 : Math.max(0, ...fields.asked.map(says));
      score += 5 * Math.max(0, ...fields.terms.map(says)) + 10 * foreseen;
      if (first_way.length > 1 && times_in(fields.text, first_way)) score += 1.5;
      // Who asks for a name of the code wants its page in the reference, and what is foreseen is meant as it stands.
      const is_the_name = first_way.length === 1 && first_way[0].includes('_') && fields.section.includes(first_way[0]);
      hits.push({document, covered, score: score * covered ** 2 * (is_the_name ? 1.2 : foreseen >= 1 ? 1 : document.weight)});
    }
    hits.sort((one, other) => other.score - one.score);
    // A name of the code that is written as one leads to it; words that may be one have it second, if it is meant for users.
    const asked = name_in(question);
    const is_meant = ({weight}) => asked.is_certain || weight > 0.25;
    const named = prepared.places.filter(({document}) => asked && has_name(document, asked) && is_meant(document)).map(({document}) =>
      hits.find(hit => hit.document === document) ?? {document, covered: 1, score: 0});
    named.sort((one, other) => Boolean(one.document.is_row) - Boolean(other.document.is_row) || other.score - one.score); // a field comes after functions
    if (named.length) hits.splice(0, hits.length, ...hits.filter(hit => !named.includes(hit)));
    hits.splice(asked?.is_certain && !(hits.length && is_foreseen(hits[0].document)) ? 0 : 1, 0, ...named);
    return {hits, whole: hits.length === 0 || hits[0].covered > 0.999, ways: concepts.flatMap(({ways}) => ways)};
  }

  globalThis.book_search = {prepare, find, respelt, stem, words_of};
})();
