// Where the reader is and was: the heading that is being read is marked in the page's contents; the sections that were read, the
// exercises that were ticked and the last place are kept in the browser, shown beside the pages' names, and offered as a way back.
(() => {
  const name = 'tumble-reading';
  // A browser that keeps nothing for files on a disk, or for anybody, forgets; the page works all the same.
  const kept = () => {
    try {
      return {pages: {}, solved: [], ...JSON.parse(localStorage.getItem(name) ?? '{}')};
    } catch {
      return {pages: {}, solved: []};
    }
  };
  const keep = change => {
    const state = kept();
    change(state);
    try {
      localStorage.setItem(name, JSON.stringify(state));
    } catch {
      return;
    }
    show(state);
  };

  const file = window.location.pathname.split('/').pop() || 'index.html';
  const is_kept = document.body.dataset.kept !== undefined;
  const headings = [...document.querySelectorAll('.contents :is(h2, h3)[id]')];
  const sections = headings.filter(heading => heading.localName === 'h2');
  const title = document.querySelector('main > h1').textContent;
  const words_of = heading => {
    const copy = heading.cloneNode(true);
    copy.querySelectorAll('.anchorlink, .katex-mathml').forEach(element => element.remove());
    return copy.textContent.trim();
  };

  // --- where one is ----------------------------------------------------------------------------------

  const links = new Map(
    [...document.querySelectorAll('.contents-table a')].map(link => [decodeURIComponent(link.hash.slice(1)), link]),
  );
  let current;

  /** The last heading above the upper third of the window; at the foot of the page the last of all. */
  function heading_here() {
    const shown = headings.filter(heading => heading.getClientRects().length); // what is shut has none
    const {scrollHeight, clientHeight, scrollTop} = document.scrollingElement;
    if (scrollTop > 0 && scrollTop + clientHeight >= scrollHeight - 2) {
      const in_view = shown.filter(heading => heading.getBoundingClientRect().top < window.innerHeight);
      return in_view.at(-1);
    }
    return shown.filter(heading => heading.getBoundingClientRect().top <= window.innerHeight / 3).at(-1);
  }

  function mark_place() {
    const heading = heading_here();
    if (heading === current) return;
    links.get(current?.id)?.removeAttribute('aria-current');
    current = heading;
    const link = links.get(heading?.id);
    link?.setAttribute('aria-current', 'location');
    const box = link?.closest('.contents-table');
    if (!box || box.scrollHeight <= box.clientHeight) return;
    box.scrollTop = link.offsetTop - box.clientHeight / 2;
  }

  // --- what was read --------------------------------------------------------------------------------

  /** Where a section ends: at the next one, or where the contents do. */
  const end_of = number =>
    sections[number + 1]?.getBoundingClientRect().top ?? document.querySelector('.contents').getBoundingClientRect().bottom;

  let last_top = -1;

  /** A section whose end stands still in the window has been read: who scrolls past it has not. */
  function note_reading() {
    const top = document.scrollingElement.scrollTop,
      rests = top === last_top;
    last_top = top;
    if (document.hidden || !rests) return;
    const ended = sections.filter((_, number) => end_of(number) > 0.1 * window.innerHeight && end_of(number) <= window.innerHeight).map(({id}) => id);
    const state = kept(),
      read = state.pages[file]?.read ?? [];
    const place = {file, title, id: current?.id ?? '', section: current ? words_of(current) : ''};
    const is_new = ended.some(id => !read.includes(id)) || state.pages[file]?.of !== sections.length;
    if (!is_new && state.last?.file === file && state.last.id === place.id) return;
    keep(fresh => {
      const ids = new Set([...(fresh.pages[file]?.read ?? []), ...ended]);
      fresh.pages[file] = {read: sections.map(({id}) => id).filter(id => ids.has(id)), of: sections.length};
      if (top > 0 || place.id) fresh.last = place;
    });
  }

  // --- what was solved --------------------------------------------------------------------------------

  for (const heading of document.querySelectorAll('h3[id^="exercise_"]')) {
    const id = heading.id.replace('exercise_', '');
    const label = document.createElement('label'),
      box = document.createElement('input');
    label.className = 'solved';
    box.type = 'checkbox';
    box.dataset.exercise = id;
    box.addEventListener('change', () =>
      keep(state => {
        state.solved = [...state.solved.filter(each => each !== id), ...(box.checked ? [id] : [])];
      }),
    );
    label.append(box, ' solved');
    heading.after(label);
  }

  // --- what is shown ----------------------------------------------------------------------------------

  const sidebar_links = [...document.querySelectorAll('#navigation a[href]')];

  function show_progress(link, state) {
    const {read, of} = state.pages[link.getAttribute('href')] ?? {};
    const exercises = (link.dataset.exercises ?? '').split(' ').filter(Boolean);
    const solved = exercises.filter(exercise => state.solved.includes(exercise)).length;
    link.querySelector('.progress')?.remove();
    if (!read?.length && !solved) return;
    const note = document.createElement('span');
    note.className = 'progress';
    const parts = [];
    if (read?.length) parts.push(of && read.length >= of ? 'read' : `${read.length} of ${of} read`);
    if (solved) parts.push(`${solved} of ${exercises.length} solved`);
    note.textContent = parts.join(', ');
    link.append(note);
  }

  function show_way_back({last}) {
    document.querySelector('.way-back')?.remove();
    if (!last || last.file === file || !sidebar_links.some(link => link.getAttribute('href') === last.file)) return;
    const line = document.createElement('p'),
      link = document.createElement('a');
    line.className = 'way-back';
    link.href = `${last.file}${last.id ? `#${last.id}` : ''}`;
    link.textContent = last.section ? `${last.title} › ${last.section}` : last.title;
    line.append('Continue where you were: ', link);
    const is_narrow = matchMedia('(max-width: 55rem)').matches; // there the search is in a bar of one line
    document.querySelector(file === 'index.html' || is_narrow ? 'main > h1' : '#search').after(line);
  }

  function show(state) {
    sidebar_links.forEach(link => show_progress(link, state));
    show_way_back(state);
    const solved = new Set(state.solved);
    document.querySelectorAll('.solved input').forEach(box => {
      box.checked = solved.has(box.dataset.exercise);
    });
    document.querySelectorAll('figure.exercises a[href*="#exercise_"]').forEach(link => {
      link.classList.toggle('done', solved.has(link.hash.replace('#exercise_', '')));
    });
    headings.forEach(heading =>
      links.get(heading.id)?.classList.toggle('done', Boolean(state.pages[file]?.read.includes(heading.id))),
    );
  }

  show(kept());
  mark_place();
  let waiting; // so that a long scroll marks a few places a second
  document.addEventListener('scroll', () => {
    waiting ??= window.setTimeout(() => {
      waiting = undefined;
      mark_place();
    }, 50);
  }, {passive: true});
  window.addEventListener('resize', mark_place);
  window.addEventListener('storage', () => show(kept()));
  if (is_kept) window.setInterval(note_reading, 800);
})();
