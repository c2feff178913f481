// How a hard case is drawn, and what there is to find.
(() => {
  const live = tumble_live;
  const cases = ['A, ordinary', 'B, stable axis', 'C, thin rod', 'D, needle 1:10⁶', 'a disc, 20 rad a step', 'A at 100 rad a step',
    'a crawl, 10⁻⁷ rad a step', 'A at 1 rad a step'];
  const rungs = ['steady', 'explicit', 'explicit, |L| restored', 'implicit, one Newton step', 'linearly implicit', 'momentum-carrying',
    'implicit midpoint', 'Lie midpoint', 'augmented second order', 'splitting by axes', 'splitting', 'Runge-Kutta', 'Lie Runge-Kutta',
    'splitting, Suzuki', 'splitting, Blanes-Moan 4', 'Dormand-Prince 5', 'splitting, Yoshida', 'splitting, Blanes-Moan 6',
    'Dormand-Prince 8', 'splitting, Kahan-Li 8', 'splitting, Sofroniou-Spaletta'];
  const [least, most] = [1e-16, 1e4]; // of the errors' axes
  const quantities = [
    {letter: 'E', column: 'energy', time: 'time', words: 'the energy', unit: '', label: 'energy off, relative'},
    {letter: 'L', column: 'momentum', time: 'time', words: '*L*', unit: '', label: '*L* off, relative'},
    {letter: 'P', column: 'phase', time: 'time of the phase', words: 'the phase', unit: 'rad', label: 'orientation off'},
  ];
  const allowed = (columns, n) => columns.allowed[n];
  const largest = numbers => numbers.reduce((a, b) => Math.max(a, b), 0);
  const letter_in = column => String.fromCharCode(column[0]);

  /** Whole powers of ten around the time that is watched. */
  function axis_of_time({columns}) {
    const [first, last] = [columns.step[0], columns.step[0] * columns.steps[0]];
    return {label: 'time', unit: 's', log: true, least: 10 ** Math.floor(Math.log10(first)), most: 10 ** Math.ceil(Math.log10(last))};
  }

  function draw_error(picture, state, n) {
    const {painter, palette, size} = picture;
    const {columns} = state;
    const {column, time, label, unit} = quantities[n];
    const plot = new live.Plot(painter, palette, size, axis_of_time(state), {label, unit, least, most, log: true});
    picture.plot = plot;
    const {x} = plot, limit = allowed(columns, n);
    if (Number.isFinite(limit)) {
      plot.line([x.least, x.most], [limit, limit], palette.ink, {width: 1.5, dash: [5, 4]});
      plot.note('allowed', [x.least, limit], palette.ink);
    } else plot.note(n === 2 ? 'not judged in this case' : 'no limit in this case', [x.least, 1e2], palette.ink);
    plot.line(columns[time], columns[column], palette.bodies[n]);
    plot.points(columns[time].slice(-1), columns[column].slice(-1), palette.bodies[n], 4);
    const last = columns[time].at(-1);
    if (n === 2 && last < 0.9 * columns.time.at(-1)) plot.note('judged until here', [last, Math.max(1e-14, columns[column].at(-1) / 300)], palette.bodies[n], last > Math.sqrt(x.least * x.most) ? 'right' : 'left');
    if (columns.diverged[0] > 0 && n === 0) plot.note('diverged', [columns.time.at(-1), 1e3], palette.bodies[n]);
  }

  const panel_of = (n, what) => ({
    label: `${what} against time, both axes logarithmic, with what is allowed as a dashed line.`,
    aspect: 1.1,
    draw: (picture, state) => draw_error(picture, state, n),
  });

  /** Whether an error has come to rest: its second half is hardly worse than its first. */
  function course_of(words, times, errors) {
    const half = times.findIndex(time => time > times.at(-1) / 2);
    return largest(errors) > 1.5 * largest(errors.slice(0, half)) ? `The error of ${words} is still growing` : `The error of ${words} has stopped growing`;
  }

  live.figures.hard_case = {
    title: 'Which rule survives which case?',
    knobs: {
      case: {label: 'Case', choices: cases},
      rung: {label: 'Rung of the ladder', choices: rungs},
      precision: {label: 'Precision', choices: ['double', 'float']},
      step: {label: 'Time step, times that of the table', log: true, words: value => live.shown(value)},
    },
    panels: [panel_of(0, 'The error of the energy'), panel_of(1, 'The error of the vector L'), panel_of(2, 'The error of the orientation')],
    finding({columns, values}) {
      const {with_unit} = live;
      const start = `In ${values.precision === 0 ? 'double' : 'float'}, with steps of ${with_unit(columns.step[0], 's')}, “${rungs[values.rung]}” `;
      const fault = letter_in(columns.fault), worst = quantities.findIndex(({letter}) => letter === letter_in(columns.worst));
      if (fault === 'D')
        return `${start}diverges: after ${columns.diverged[0] === 1 ? 'one step' : `${columns.diverged[0]} steps`} its energy has grown a thousandfold, or is no number.`;
      if (!Number.isFinite(allowed(columns, worst)))
        return `${start}stays finite for ${columns.steps[0]} steps, and no more is asked. Its energy is off by up to ${with_unit(largest(columns.energy), '')}, relative.`;
      const {words, unit, column, time} = quantities[worst];
      const off = `off by ${with_unit(columns.error[0], unit, 2)}, where ${with_unit(allowed(columns, worst), unit, 2)} is allowed`;
      if (fault === '.') return `${start}passes. What comes nearest to its limit is ${words}, ${off}.`;
      const also = quantities.filter(({column: name}, n) => n !== worst && columns[name].length > 0 &&
        (n === 2 ? columns[name].at(-1) : largest(columns[name])) > allowed(columns, n));
      const others = also.length > 0 ? `${also.map(other => other.words).join(' and ')} ${also.length > 1 ? 'are' : 'is'} beyond the limit too`
        : 'the rest is within its limits';
      return `${start}fails on ${words}, ${off}; ${others}. ${course_of(words, columns[time], columns[column])}.`;
    },
  };
})();
