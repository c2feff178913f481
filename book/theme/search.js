// The search box. The index is loaded when the reader first goes to the box, by script tags: a page that was opened from a
// file may not fetch.
(() => {
  const query = document.getElementById('query'),
    answers = document.getElementById('answers');
  const answer = document.getElementById('answer'),
    found = document.getElementById('found');
  const most = 12;
  if (matchMedia('(hover: none)').matches) query.placeholder = 'Search'; // there is no key to press
  let prepared,
    chosen = -1;

  const load = file =>
    new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = file;
      script.onload = resolve;
      script.onerror = () => reject(new Error(`cannot load ${file}`));
      document.head.append(script);
    });
  let loading;
  const ready = () => {
    loading ??= Promise.all([load('search_ranking.js'), load('search_index.js')]).then(() => {
      prepared = book_search.prepare(window.bookIndex.documents, window.bookIndex.same);
    });
    return loading;
  };

  /** The line of the text around the first word that was asked for, the words marked. */
  function context(text, ways) {
    const escaped = ways.map(way => way.map(word => word.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')).join('\\p{L}*[^\\p{L}\\p{N}]+'));
    const pattern = new RegExp(`(?<![\\p{L}\\p{N}_])(?:${escaped.join('|')})[\\p{L}\\p{N}_]*`, 'giu');
    const phrase = new RegExp(`(?<![\\p{L}\\p{N}_])${escaped[0]}\\p{L}*[^\\p{L}\\p{N}]+(?:${escaped.slice(1).join('|')})`, 'iu');
    const first = text.search(phrase) >= 0 ? text.search(phrase) : Math.max(0, text.search(pattern));
    let start = Math.max(0, first - 40);
    if (start > 0) start = text.indexOf(' ', start) + 1;
    const line = text.slice(start, start + 130);
    const paragraph = document.createElement('span');
    paragraph.className = 'context';
    let end = 0;
    if (start > 0) paragraph.append('… ');
    for (const match of line.matchAll(pattern)) {
      const mark = document.createElement('mark');
      mark.textContent = match[0];
      paragraph.append(line.slice(end, match.index), mark);
      end = match.index + match[0].length;
    }
    paragraph.append(line.slice(end), start + 130 < text.length ? ' …' : '');
    return paragraph;
  }

  function option({document: {address, page, section, text}}, number, ways) {
    const item = window.document.createElement('li');
    item.id = `found_${number}`;
    item.setAttribute('role', 'option');
    item.setAttribute('aria-selected', 'false');
    item.dataset.address = address;
    const where = window.document.createElement('span');
    where.className = 'where';
    where.textContent = section ? `${page} › ${section}` : page;
    item.append(where, context(text, ways));
    item.addEventListener('mousedown', event => event.preventDefault());
    item.addEventListener('click', () => go(item));
    return item;
  }

  function go(item) {
    close();
    window.location.href = item.dataset.address;
  }

  function choose(number) {
    const items = found.children;
    if (!items.length) return;
    items[chosen]?.setAttribute('aria-selected', 'false');
    chosen = (number + items.length) % items.length;
    items[chosen].setAttribute('aria-selected', 'true');
    items[chosen].scrollIntoView({block: 'nearest'});
    query.setAttribute('aria-activedescendant', items[chosen].id);
  }

  function close() {
    answers.hidden = true;
    query.setAttribute('aria-expanded', 'false');
    query.removeAttribute('aria-activedescendant');
    chosen = -1;
  }

  async function show() {
    const text = query.value;
    if (!/[\p{L}\p{N}]/u.test(text)) return close();
    try {
      await ready();
    } catch (error) {
      answer.textContent = `The search cannot work: ${error.message}.`;
      answers.hidden = false;
      return undefined;
    }
    if (text !== query.value) return undefined;
    let {hits, whole, ways} = book_search.find(text, prepared);
    const instead = whole && hits.length ? undefined : book_search.respelt(text, prepared);
    if (instead) ({hits, whole, ways} = book_search.find(instead, prepared));
    chosen = -1;
    query.removeAttribute('aria-activedescendant');
    found.replaceChildren(...hits.slice(0, most).map((hit, number) => option(hit, number, ways)));
    const shown =
      hits.length > most
        ? `The best ${most} of ${hits.length} places`
        : `${hits.length} place${hits.length > 1 ? 's' : ''}`;
    const some = (instead ? `In place of “${text.trim()}”, for “${instead}”: ` : '') + (whole ? '' : 'No place holds all of these words. ');
    answer.textContent = hits.length ? some + shown : `Nothing found for “${text.trim()}”.`;
    answers.hidden = false;
    query.setAttribute('aria-expanded', String(hits.length > 0));
    return undefined;
  }

  query.addEventListener('focus', () => {
    ready().catch(() => {});
    if (query.value) show();
  });
  query.addEventListener('input', show);
  query.addEventListener('blur', close);
  query.addEventListener('keydown', event => {
    if (event.key === 'ArrowDown') choose(chosen + 1);
    else if (event.key === 'ArrowUp') choose(chosen < 0 ? -1 : chosen - 1);
    else if (event.key === 'Enter' && found.children.length && !answers.hidden)
      go(found.children[Math.max(0, chosen)]);
    else if (event.key === 'Escape') {
      if (answers.hidden) query.value = '';
      close();
    } else return;
    event.preventDefault();
  });
  document.addEventListener('keydown', event => {
    if (!['/', 's'].includes(event.key) || event.ctrlKey || event.metaKey || event.altKey) return;
    if (/^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName) || event.target.isContentEditable) return;
    event.preventDefault();
    query.focus();
    query.select();
  });

  // A section that has moved to another page since its address was noted is looked up by its name.
  const name = decodeURIComponent(location.hash.slice(1)).split('?')[0];
  if (name && !document.getElementById(name))
    ready().then(() => {
      const places = new Set(window.bookIndex.documents.map(({address}) => address).filter(address => address.endsWith(`#${name}`)));
      if (places.size === 1) location.replace([...places][0]);
    });
})();
