// The buttons of a page: the pages' list on a narrow screen, copying code.
(() => {
  const menu = document.getElementById('menu'),
    sidebar = document.getElementById('sidebar');
  const open_menu = open => {
    sidebar.classList.toggle('open', open);
    menu.setAttribute('aria-expanded', String(open));
    if (open) document.querySelector('#navigation [aria-current]')?.scrollIntoView({block: 'center'});
  };
  menu.addEventListener('click', () => open_menu(!sidebar.classList.contains('open')));
  sidebar.addEventListener('keydown', event => {
    if (event.key !== 'Escape' || !sidebar.classList.contains('open')) return;
    open_menu(false);
    menu.focus();
  });
  // On a phone the first sentence comes before the contents.
  if (matchMedia('(max-width: 55rem)').matches) document.querySelector('.contents-table details')?.removeAttribute('open');
  const here = document.querySelector('#navigation [aria-current]'), pages = document.querySelector('#navigation');
  if (here) pages.scrollTop = here.offsetTop - pages.offsetTop - pages.clientHeight / 2;

  // A link to an exercise opens its card.
  const open_task = () => {
    let next = document.querySelector(`h3[id="${CSS.escape(decodeURIComponent(location.hash.slice(1)))}"][id^="exercise_"]`);
    while (next && !next.matches('details.task')) next = next.nextElementSibling;
    if (next) next.open = true;
  };
  open_task();
  addEventListener('hashchange', open_task);

  for (const code of document.querySelectorAll(
    'figure.listing .fragment, figure.listing pre, .contents > pre.fragment',
  )) {
    if (!navigator.clipboard) break;
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'copy';
    button.textContent = 'Copy';
    button.addEventListener('click', async () => {
      const lines = [...code.querySelectorAll('.line')];
      const text = lines.length ? lines.map(line => line.textContent).join('\n') : code.textContent;
      await navigator.clipboard.writeText(`${text.trimEnd()}\n`);
      button.textContent = 'Copied';
      setTimeout(() => {
        button.textContent = 'Copy';
      }, 1500);
    });
    (code.closest('figure') ?? code.parentElement).append(button);
  }

  // A formula that is wider than a phone is parted after a relation or a wide gap; between brackets it stays whole. Only a piece
  // that is too wide itself is parted after a sum's sign too.
  const ends_in = (base, kinds) => {
    const last = [...base.children].findLast(child => !child.matches('.mspace'));
    return Boolean(last && kinds.test(last.className) && !/[·⋅×∘]/.test(last.textContent));
  };
  const is_wide_gap = base => base.querySelector(':scope > .allowbreak'); // see formulas.mjs
  function pieces_of(bases, may_part) {
    const pieces = [[]];
    let depth = 0;
    for (const base of bases) {
      pieces.at(-1).push(base);
      for (const child of base.children) depth += child.matches('.mopen') - child.matches('.mclose');
      if (depth === 0 && may_part(base)) pieces.push([]);
    }
    return pieces.filter(piece => piece.length);
  }
  const width_of = piece => piece.reduce((sum, base) => sum + base.getBoundingClientRect().width, 0);
  for (const box of matchMedia('(max-width: 30rem)').matches ? document.querySelectorAll('.formula') : []) {
    const line = box.querySelector('.katex-html');
    if (!line || box.scrollWidth <= box.clientWidth) continue;
    const room = box.clientWidth - 40; // px; the lines that follow are set in
    const part = (bases, [kinds, ...finer]) => {
      const pieces = pieces_of(bases, base => is_wide_gap(base) || ends_in(base, kinds));
      return finer.length ? pieces.flatMap(piece => (width_of(piece) > room ? part(piece, finer) : [piece])) : pieces;
    };
    const pieces = part([...line.querySelectorAll(':scope > .base')], [/^none$/, /\bmrel\b/, /\bm(rel|bin)\b/]);
    for (const piece of pieces) {
      const whole = document.createElement('span');
      whole.className = 'piece';
      piece[0].before(whole);
      whole.append(...piece);
    }
    box.classList.toggle('parted', pieces.length > 1);
    const share = (box.clientWidth - 2) / box.scrollWidth; // of what still does not fit
    if (share < 1 && share > 0.7) box.style.fontSize = `${share}em`; // smaller, its indices could not be read: that one scrolls
  }

  // What scrolls in its own box must scroll by keyboard too, and only that costs a stop of the Tab key.
  const boxes = document.querySelectorAll('.scroll, .fragment, pre');
  const mark_scrolling = () => {
    for (const box of boxes) {
      if (box.scrollWidth > box.clientWidth + 1) {
        box.tabIndex = 0;
        box.setAttribute('role', 'region');
        box.setAttribute('aria-label', 'Scrolls sideways');
      } else if (box.tabIndex === 0) {
        box.removeAttribute('tabindex');
        box.removeAttribute('role');
        box.removeAttribute('aria-label');
      }
    }
  };
  mark_scrolling();
  // A box inside a fold has no width until the fold is opened, and a font that comes late changes what fits.
  const sizes = new ResizeObserver(mark_scrolling);
  for (const box of boxes) sizes.observe(box);
  document.fonts?.ready.then(mark_scrolling);
})();
