// What a scene says when it has run: its plan, line by line with what has changed, and its books.
(() => {
  const live = globalThis.tumble_live;

  /** The lines of a plan with a key for each: lines of the same name are counted. */
  function lines_of(said) {
    const counts = new Map();
    return JSON.parse(said.plan).rows.map(row => {
      const count = (counts.get(row.effect) ?? 0) + 1;
      counts.set(row.effect, count);
      return {...row, key: `${row.effect} ${count}`};
    });
  }

  const visits = ({visited, of}) => (visited > 0 ? `${visited} of ${of}` : 'no pass');

  /** The lines as they are, each with how it was before: {...line, before, is_new}; and those that are gone. */
  function compared(said, said_before) {
    const lines = lines_of(said);
    if (!said_before) return {lines, gone: []};
    const before = new Map(lines_of(said_before).map(line => [line.key, line]));
    const marked = lines.map(line => {
      const last = before.get(line.key);
      if (!last) return {...line, is_new: true};
      return visits(last) === visits(line) && last.reason === line.reason ? line : {...line, before: last};
    });
    const keys = new Set(lines.map(({key}) => key));
    return {lines: marked, gone: [...before.values()].filter(({key}) => !keys.has(key))};
  }

  function made(tag, properties = {}, attributes = {}, children = []) {
    const element = Object.assign(document.createElement(tag), properties);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  function table(caption, columns, rows) {
    const head = made('tr', {}, {}, columns.map(text => made('th', {textContent: text, scope: 'col'})));
    const inner = made('table', {className: 'table scene-table'}, {}, [made('caption', {textContent: caption}),
      made('thead', {}, {}, [head]), made('tbody', {}, {}, rows)]);
    return made('div', {className: 'scene-scroll', tabIndex: 0}, {role: 'region', 'aria-label': caption}, [inner]);
  }

  const row = (cells, name = '') => made('tr', {className: name}, {},
    cells.map((text, n) => made(n === 0 ? 'th' : 'td', typeof text === 'string' ? {textContent: text} : {}, n === 0 ? {scope: 'row'} : {},
      typeof text === 'string' ? [] : text)));

  /** The plan; a line that has changed says what it was. `costs`: ns of a step by the line's key, where they were measured. */
  function plan_table(said, said_before, costs) {
    const {lines, gone} = compared(said, said_before);
    const small = text => made('small', {textContent: text});
    const cost = ({key}) => (costs ? [costs.has(key) ? live.shown(costs.get(key)) : '–'] : []);
    const rows = lines.map(line => {
      const was = line.is_new ? [' ', small('(new)')] : line.before ? [' ', small(`(before: ${visits(line.before)}; ${line.before.reason})`)] : [];
      return row([line.effect, visits(line), [line.reason, ...was], ...cost(line)], was.length ? 'changed' : line.visited ? '' : 'idle');
    });
    rows.push(...gone.map(line => row([[made('s', {textContent: line.effect})], 'gone', [small(`(before: ${visits(line)})`)], ...(costs ? ['–'] : [])], 'changed')));
    if (costs) rows.push(row(['the whole step, with its memory and its guard', '', '', live.shown(costs.get('whole'))]));
    return table('The plan of a step', ['what is done', 'bodies', 'why', ...(costs ? ['ns in a step'] : [])], rows);
  }

  /** The books as the terminal has them. */
  function books_table(said) {
    const books = JSON.parse(said.books);
    const number = value => (value === null ? 'not finite' : live.shown(value));
    const line = (name, {energy, momentum, angular_momentum}) =>
      row([name, number(energy), momentum.map(number).join(', '), angular_momentum.map(number).join(', ')]);
    return table(`The books after ${live.shown(books.time, 6)} s: what each effect put in`,
      ['from', 'energy (J)', 'momentum x, y, z (kg m/s)', 'angular momentum x, y, z (kg m²/s)'],
      [line('at the start', books.at_the_start), ...books.effects.map(effect => line(`+ ${effect.name}`, effect)),
        line('now', books.now), line('unexplained', books.unexplained)]);
  }

  const list = names => (names.length > 1 ? `${names.slice(0, -1).join(', ')} and ${names.at(-1)}` : names[0]);

  /** A sentence or two about the plan, and what has changed in it. */
  function finding_of(said, said_before) {
    const plan = JSON.parse(said.plan), books = JSON.parse(said.books);
    const {lines, gone} = compared(said, said_before);
    const passes = lines.filter(({visited}) => visited > 0), idle = lines.filter(({visited}) => visited === 0);
    const changes = [...lines.filter(({is_new}) => is_new).map(line => `${line.effect} is new (${visits(line)})`),
      ...lines.filter(line => line.before && visits(line.before) !== visits(line))
        .map(line => `${line.effect} was ${visits(line.before)} and is now ${visits(line)}`),
      ...gone.map(({effect}) => `${effect} is gone`)];
    const sentences = [`A step makes ${passes.length} ${passes.length === 1 ? 'pass' : 'passes'} over ${books.bodies} ${books.bodies === 1 ? 'body' : 'bodies'}`];
    if (idle.length) sentences.push(`No pass: ${list(idle.map(({effect}) => effect))}`);
    if (changes.length) sentences.push(`Changed in the plan: ${changes.join('; ')}`);
    sentences.push(...plan.unknown.map(what => `Limit of the step unknown: ${what}`));
    sentences.push(...plan.warnings.map(warning => `Warning: ${warning.replace(/[.]$/, '')}`));
    return `${sentences.join('. ')}.`;
  }

  Object.assign(live, {scene_tables: {lines_of, plan_table, books_table, finding_of, made}});
})();
