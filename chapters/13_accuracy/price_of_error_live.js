// How the ladder's errors are drawn against their price, and which rung is the cheapest.
(() => {
  const live = tumble_live;
  const problems = ['A, ordinary', 'B, stable axis', 'C, thin rod', 'D, needle 1:10⁶'];
  const rungs = ['steady', 'explicit', 'explicit, |L| restored', 'implicit, one Newton step', 'linearly implicit', 'momentum-carrying',
    'implicit midpoint', 'Lie midpoint', 'augmented second order', 'splitting by axes', 'splitting', 'Runge-Kutta', 'Lie Runge-Kutta',
    'splitting, Suzuki', 'splitting, Blanes-Moan 4', 'Dormand-Prince 5', 'splitting, Yoshida', 'splitting, Blanes-Moan 6',
    'Dormand-Prince 8', 'splitting, Kahan-Li 8', 'splitting, Sofroniou-Spaletta'];
  const exact = rungs.length; // the last row
  const rows = [...rungs, 'exact solution'];
  const few = ['momentum-carrying', 'implicit midpoint', 'splitting', 'Runge-Kutta', 'Dormand-Prince 5', 'splitting, Blanes-Moan 6',
    'Dormand-Prince 8', 'exact solution'].map(name => rows.indexOf(name));
  const [least_error, most_error] = [1e-13, 10]; // of the errors' axis
  /** Until the page's first question is answered the exact solution is as grey as the rest, and no answer is told. */
  const is_open = () => live.answered('price_of_error');

  /** The rows that are shown: of the whole ladder or of a few rungs, and of the one that is lit. */
  const shown_rows = ({values}) => [...rows.keys()].filter(row => values.rungs === 1 || few.includes(row) || row === values.method);

  /** What the book's build measured: ns for a step of a rung, or for an answer of the exact solution. */
  function price_of(name, problem) {
    const measured = live.tables?.step_prices?.rows ?? [];
    const price = Number(measured.find(cells => cells[0] === name)?.[problem + 1]);
    return Number.isFinite(price) ? price : NaN;
  }

  /** The runs of each rung, the cheapest first: {name, errors, prices}, in rad and in ns for each simulated second. */
  const curves_of = ({columns, values}) => rungs.map((name, rung) => ({name, errors: columns[`error ${rung}`],
    prices: Array.from(columns[`steps ${rung}`], steps => steps * price_of(name, values.problem) / columns.seconds[0])}));

  /** The most accurate run that can be paid for, judged by the worse of its error and the next finer run's: one can be small by luck. */
  function best_within(spent, {errors, prices}) {
    let best = {error: Infinity};
    for (let n = 0; n < prices.length && prices[n] <= spent; ++n) {
      const error = Math.max(errors[n], errors[n + 1] ?? 0);
      if (error < best.error) best = {error, n};
    }
    return best.n;
  }

  /** The shown rungs that the budget allows, the best first: {rung, name, step, price, error}. */
  function ranking(state) {
    const {columns, values} = state, [seconds] = columns.seconds, shown = shown_rows(state);
    return curves_of(state).map(({name, errors, prices}, rung) => {
      const steps = columns[`steps ${rung}`];
      const n = values.budget === 1 ? best_within(values.spent, {errors, prices}) : steps.indexOf(columns.needed[rung]);
      return {rung, name, step: seconds / steps[n], price: prices[n], error: values.budget === 1 ? errors[n] : columns.reached[rung]};
    }).filter(({rung, step, price}) => shown.includes(rung) && step > 0 && price > 0)
      .sort((one, other) => (values.budget === 1 ? one.error - other.error : one.price - other.price));
  }

  const exact_price = ({columns, values}) => price_of('exact solution', values.problem) / columns.seconds[0];
  const time = ns => (ns < 1000 ? live.with_unit(ns, 'ns', 2) : ns < 1e6 ? live.with_unit(ns / 1000, 'µs', 2) : live.with_unit(ns / 1e6, 'ms', 2));
  const slope_in_words = slope => String(slope.toFixed(1)).replace('-', '−');

  /** The axis of prices: whole powers of ten round all runs and the exact solution. */
  function price_axis(state) {
    const prices = [...curves_of(state).flatMap(curve => curve.prices), exact_price(state)].filter(price => price > 0);
    const [low, high] = prices.length ? [Math.min(...prices), Math.max(...prices)] : [1, 10];
    return {label: 'price of a simulated second', unit: 'ns', log: true, least: 10 ** Math.floor(Math.log10(low)), most: 10 ** Math.ceil(Math.log10(high))};
  }

  /** Lines of words, the first from `x` and `y` on, moved so far that they stay in the picture. */
  function write({painter, plot, size}, lines, [x, y], colour) {
    const width = Math.max(...lines.map(words => painter.width_of(words)));
    const left = Math.max(4, Math.min(size.width - width - 4, x));
    const lowest = plot.box.top + plot.box.height - 16 * lines.length - 2; // above the numbers of the axis
    lines.forEach((words, n) => painter.text(words, left, Math.max(4, Math.min(lowest, y)) + 8 + 16 * n, 'left', colour));
  }

  /** Words at an upright line, to the right of it where there is room. */
  function beside(picture, plot, words, at, colour) {
    const [x, y] = plot.place(at), width = picture.painter.width_of(words) + 12;
    write(picture, [words], [x + width < picture.size.width ? x + 8 : x - width + 4, y], colour);
  }

  /** The order of a grey line, where it leaves the picture or ends. */
  function draw_order({painter, palette}, plot, {errors, prices}, order) {
    const last = errors.findLastIndex((error, n) => error >= least_error && prices[n] > 0);
    if (last < 0) return;
    const [x, y] = plot.place([prices[last], errors[last]]);
    painter.text(String(order), x + 4, Math.min(y + 3, plot.box.top + plot.box.height - 9), 'left', palette.ink);
  }

  /** The lit rung: its line, its runs as dots, and its name and slope where it falls. */
  function draw_lit(picture, plot, {name, errors, prices}, slope) {
    const {palette} = picture, colour = palette.bodies[1];
    plot.line(prices, errors, colour, {width: 3});
    plot.points(prices, errors, colour, 3);
    const far_from_middle = n => Math.abs(Math.log10(errors[n]) + 6);
    const seen = [...errors.keys()].filter(n => errors[n] >= least_error && prices[n] > 0);
    if (seen.length === 0) return;
    const at = seen.reduce((best, n) => (far_from_middle(n) < far_from_middle(best) ? n : best));
    const [x, y] = plot.place([prices[at], errors[at]]);
    write(picture, Number.isFinite(slope) ? [name, `slope ${slope_in_words(slope)}`] : [name], [x + 12, y - 36], colour);
  }

  function draw_errors(picture, state) {
    const {painter, palette, size} = picture;
    const {columns, values} = state;
    const curves = curves_of(state), shown = shown_rows(state).filter(row => row !== exact);
    const plot = new live.Plot(painter, palette, size, price_axis(state),
      {label: 'error at the end', unit: 'rad', log: true, least: least_error, most: most_error});
    picture.plot = plot;
    for (const rung of shown) plot.line(curves[rung].prices, curves[rung].errors, palette.ink, {width: 1, opacity: 0.35});
    if (values.rungs === 0)
      for (const rung of shown) if (rung !== values.method) draw_order(picture, plot, curves[rung], columns.order[rung]);
    const price = exact_price(state);
    if (price > 0 && is_open()) {
      plot.line([price, price], [least_error, most_error], palette.bodies[2], {width: values.method === exact ? 3 : 2, dash: [2, 3]});
      beside(picture, plot, 'exact', [price, 1e-12], palette.bodies[2]);
    }
    const [first] = ranking(state);
    if (first && first.rung !== values.method) plot.line(curves[first.rung].prices, curves[first.rung].errors, palette.bodies[0], {width: 1.5});
    if (values.method !== exact) draw_lit(picture, plot, curves[values.method], columns.slope[values.method]);
    const budget = {width: 1.5, dash: [5, 4]};
    if (values.budget === 1) {
      plot.line([values.spent, values.spent], [least_error, most_error], palette.ink, budget);
      beside(picture, plot, 'to spend', [values.spent, most_error], palette.ink);
    } else {
      plot.line([plot.x.least, plot.x.most], [values.wanted, values.wanted], palette.ink, budget);
      plot.note('allowed', [plot.x.most, values.wanted], palette.ink, 'right');
    }
    if (!first) return;
    plot.points([first.price], [first.error], palette.bodies[0], 6);
    const [x, y] = plot.place([first.price, first.error]), words = values.budget === 1 ? 'best that steps:' : 'cheapest that steps:';
    write(picture, [words, first.name], [x - 12 - Math.max(...[words, first.name].map(line => painter.width_of(line))), y + 4], palette.bodies[0]);
  }

  /** A row for each rung with its order and what it makes of the budget, as a dot and in numbers. One presses a name to light it. */
  function draw_rows(picture, state) {
    const {painter, palette, size} = picture;
    const {columns, values} = state;
    const places = ranking(state), by_time = values.budget === 1, shown = shown_rows(state);
    const [top, height] = [24, Math.min(48, (size.height - 30) / shown.length)];
    picture.row_at = y => shown[Math.max(0, Math.min(shown.length - 1, Math.floor((y - top) / height)))];
    const named = 34, [left, right] = [named + Math.max(...rows.map(name => painter.width_of(name))) + 10, size.width - 62];
    const axis = by_time ? {least: least_error, most: most_error} : price_axis(state);
    const place = value => left + (right - left) * Math.max(0, Math.min(1, Math.log(value / axis.least) / Math.log(axis.most / axis.least)));
    painter.text('order', 6, 12, 'left', palette.ink);
    painter.text(by_time ? 'error' : 'price', size.width - 6, 12, 'right', palette.ink);
    for (const mark of by_time ? [1e-10, 1e-5, 1] : (right - left > 120 ? [1e2, 1e5] : [1e3]).filter(ns => ns > axis.least && ns < axis.most)) {
      painter.line([[place(mark), top], [place(mark), top + height * shown.length]], palette.ink, 1, 0.2);
      painter.text(by_time ? live.shown(mark, 1) : time(mark), place(mark), 12, 'center', palette.ink);
    }
    shown.forEach((row, n) => {
      const name = rows[row], y = top + (n + 0.5) * height;
      const its = row === exact ? {price: exact_price(state), error: 0} : places.find(({rung}) => rung === row);
      const is_told = row !== exact || is_open();
      const colour = !is_told ? palette.ink : row === exact ? palette.bodies[2] : row === values.method ? palette.bodies[1] : palette.ink;
      if (row === values.method) {
        const [above, below, end] = [y - height / 2, y + height / 2, size.width - 2];
        painter.line([[2, above], [end, above], [end, below], [2, below], [2, above]], colour, 1.5, 1);
      }
      if (row !== exact) painter.text(String(columns.order[row]), 26, y, 'right', colour);
      painter.text(name, named, y, 'left', colour);
      if (!is_told) return painter.text('answer first', size.width - 6, y, 'right', colour);
      const is_met = row === exact && by_time ? its.price <= values.spent : its?.price > 0;
      const value = by_time ? its?.error : its?.price;
      if (is_met && (value > 0 || !by_time)) {
        painter.line([[left, y], [place(value), y]], colour, 1, 0.5);
        painter.disc(place(value), y, row === places[0]?.rung ? 5 : 3, row === places[0]?.rung ? palette.bodies[0] : colour);
      }
      const words = !is_met ? '–' : row === exact && by_time ? 'rounding' : by_time ? live.shown(value, 1) : time(value);
      painter.text(words, size.width - 6, y, 'right', colour);
    });
  }

  /** Where in the first picture one points is what one has. */
  const allow = wanted => ({budget: 0, wanted: Number(Math.max(1e-10, Math.min(0.1, wanted)).toPrecision(2))});
  const spend = spent => ({budget: 1, spent: Number(Math.max(10, Math.min(1e6, spent)).toPrecision(2))});

  /** What the budget buys, and from which rung. */
  function best_in_words({columns, values}, places) {
    const {with_unit} = live, [first, second] = places, [seconds] = columns.seconds;
    const by_time = values.budget === 1;
    const asked = by_time ? `For ${time(values.spent)} a simulated second` : `For an error of at most ${with_unit(values.wanted, 'rad')} after ${with_unit(seconds, 's')}`;
    if (!first)
      return !(price_of('steady', 0) > 0) ? `${asked} no price is known: the book’s build has measured none.`
        : by_time ? `${asked} no rung takes even a single step.` : `${asked} none of these rungs is near enough with 4096 steps.`;
    const ratio = second && (by_time ? second.error / first.error : second.price / first.price);
    const verb = by_time ? 'errs' : 'costs';
    const next = !second ? `No other rung ${by_time ? 'can be paid for' : 'is near enough with 4096 steps'}.`
      : ratio < 1.05 ? `The next, “${second.name}”, ${verb} as much.` : `The next, “${second.name}”, ${verb} ${live.shown(ratio, 2)} times as much.`;
    const steps = first.step === seconds ? 'a single step' : `steps of ${with_unit(first.step, 's', 2)}`;
    return by_time
      ? `${asked}, as measured when this book was made, the most accurate of these rungs is “${first.name}”: with ${steps} it errs by ${with_unit(first.error, 'rad', 2)} after ${with_unit(seconds, 's')}. ${next}`
      : `${asked} the cheapest rung that steps is “${first.name}”, with ${steps}: ${time(first.price)} for each simulated second, as measured when this book was made. ${next}`;
  }

  /** What the lit rung is like. */
  function lit_in_words(state) {
    const {columns, values} = state;
    if (values.method === exact)
      return is_open() ? `The exact solution is lit: it answers once at the end, for ${time(exact_price(state))} a simulated second, whatever error is allowed.`
        : 'The exact solution stays grey until you have answered the question below.';
    const slope = columns.slope[values.method], name = `“${rungs[values.method]}” is lit`;
    if (!Number.isFinite(slope)) return `${name}: with up to 4096 steps it has no straight line, so no slope.`;
    const order = columns.order[values.method], beyond = -slope - order;
    const compared = beyond > 0.5 ? `steeper than its order of ${order}` : beyond < -0.5 ? `flatter than its order of ${order}` : `and its order is ${order}`;
    const dearer = is_open() && slope < 0 ? `: a thousandth of its error costs ${live.shown(1000 ** (-1 / slope), 2)} times as much` : '';
    return `${name}: its line has the slope ${slope_in_words(slope)}, ${compared}${dearer}.`;
  }

  live.figures.price_of_error = {
    title: 'How steeply does the price of accuracy rise?',
    tables: ['step_prices'],
    hint: 'Drag the dashed line; press a name to light its line. By keys: the arrows.',
    knobs: {
      problem: {label: 'Problem', choices: problems},
      method: {label: 'Rung that is lit', choices: rows},
      budget: {label: 'What you have', choices: ['an error that you allow', 'a time that you can spend']},
      wanted: {label: 'Largest error allowed', log: true, also: {budget: 0}},
      spent: {label: 'Time for a simulated second', log: true, also: {budget: 1}, words: time},
      rungs: {label: 'Rungs', choices: ['a few', 'the whole ladder']},
    },
    panels: [
      {
        label: 'Error against price, both axes logarithmic: a grey line for each rung, its order at its end, one of them lit with its slope, and the budget as a dashed line with a dot where the best rung meets it.',
        aspect: 0.8,
        draw: draw_errors,
        drag(plot, at, {values}) {
          const [price, error] = plot.value_at(at);
          return values.budget === 1 ? spend(price) : allow(error);
        },
        key: ([right, up], {values}) => (right ? spend(values.spent * 10 ** (right / 4)) : allow(values.wanted * 10 ** (up / 2))),
      },
      {
        label: 'The rungs by name and order, with what each costs or errs by within the budget. The arrows light another one.',
        aspect: 0.8,
        draw: draw_rows,
        press: ({row_at}, [, y]) => ({method: row_at(y)}),
        key([, up], state) {
          const shown = shown_rows(state), at = shown.indexOf(state.values.method) - up;
          return {method: shown[Math.max(0, Math.min(shown.length - 1, at))]};
        },
      },
    ],
    finding(state) {
      return `${best_in_words(state, ranking(state))} ${lit_in_words(state)}`;
    },
  };
})();
