// How the ladder's errors are drawn against their price, and which rung is the cheapest.
(() => {
  const live = tumble_live;
  const problems = ['A, ordinary', 'B, stable axis', 'C, thin rod', 'D, needle 1:10⁶'];
  const rungs = ['steady', 'explicit', 'explicit, |L| restored', 'implicit, one Newton step', 'linearly implicit', 'momentum-carrying',
    'implicit midpoint', 'Lie midpoint', 'augmented second order', 'splitting by axes', 'splitting', 'Runge-Kutta', 'Lie Runge-Kutta',
    'splitting, Suzuki', 'splitting, Blanes-Moan 4', 'Dormand-Prince 5', 'splitting, Yoshida', 'splitting, Blanes-Moan 6',
    'Dormand-Prince 8', 'splitting, Kahan-Li 8', 'splitting, Sofroniou-Spaletta'];
  const [least_error, most_error] = [1e-13, 10]; // of the errors' axis
  const shown_bars = 6;

  /** What the book's build measured: ns for a step of a rung, or for an answer of the exact solution. */
  function price_of(name, problem) {
    const rows = live.tables?.step_prices?.rows ?? [];
    const price = Number(rows.find(cells => cells[0] === name)?.[problem + 1]);
    return Number.isFinite(price) ? price : NaN;
  }

  /** The rungs that are near enough, the cheapest first: {rung, name, steps, step, price in ns for each simulated second}. */
  function ranking({columns, values}) {
    const [seconds] = columns.seconds;
    return rungs.map((name, rung) => ({rung, name, steps: columns.needed[rung], error: columns.reached[rung],
      step: seconds / columns.needed[rung], price: price_of(name, values.problem) * columns.needed[rung] / seconds}))
      .filter(({steps, price}) => steps > 0 && price > 0)
      .sort((one, other) => one.price - other.price);
  }

  const exact_price = ({columns, values}) => price_of('exact solution', values.problem) / columns.seconds[0];
  const time = ns => (ns < 1000 ? live.with_unit(ns, 'ns', 2) : live.with_unit(ns / 1000, 'µs', 2));

  function draw_errors(picture, state) {
    const {painter, palette, size} = picture;
    const {columns, values} = state;
    const curves = rungs.map((name, rung) => ({name, errors: columns[`error ${rung}`],
      prices: Array.from(columns[`steps ${rung}`], steps => steps * price_of(name, values.problem) / columns.seconds[0])}));
    const prices = curves.flatMap(curve => curve.prices).filter(Number.isFinite);
    const [low, high] = prices.length ? [Math.min(...prices), Math.max(...prices)] : [1, 10];
    const plot = new live.Plot(painter, palette, size,
      {label: 'price of a simulated second', unit: 'ns', log: true, least: 10 ** Math.floor(Math.log10(low)), most: 10 ** Math.ceil(Math.log10(high))},
      {label: 'error at the end', unit: 'rad', log: true, least: least_error, most: most_error});
    picture.plot = plot;
    const [first, second] = ranking(state);
    for (const {prices: xs, errors} of curves) plot.line(xs, errors, palette.ink, {width: 1, opacity: 0.3});
    for (const [place, colour] of [[second, palette.bodies[0]], [first, palette.bodies[1]]]) {
      if (!place) continue;
      const {prices: xs, errors} = curves[place.rung];
      plot.line(xs, errors, colour, {width: 2.5});
      plot.points([place.price], [place.error], colour, 5);
    }
    plot.line([plot.x.least, plot.x.most], [values.wanted, values.wanted], palette.ink, {width: 1.5, dash: [5, 4]});
    plot.note('allowed', [plot.x.most, values.wanted], palette.ink, 'right');
    const exact = exact_price(state);
    if (Number.isFinite(exact)) {
      plot.line([exact, exact], [least_error, most_error], palette.bodies[2], {width: 1.5, dash: [2, 3]});
      plot.note('exact solution', [exact, 1e-9], palette.bodies[2], exact > 100 * plot.x.least ? 'right' : 'left');
    }
  }

  function draw_bars(picture, state) {
    const {painter, palette, size} = picture;
    const places = ranking(state).slice(0, shown_bars);
    const row = (size.height - 34) / shown_bars, widest = size.width - 20;
    painter.text('price of a simulated second', 10, 10, 'left', palette.ink);
    if (places.length === 0) painter.text('no rung is near enough', 10, 40, 'left', palette.ink);
    const most = places.at(-1)?.price ?? 1;
    places.forEach(({name, step, price}, n) => {
      const top = 28 + n * row, right = 10 + widest * price / most;
      const colour = n === 0 ? palette.bodies[1] : n === 1 ? palette.bodies[0] : palette.ink;
      painter.text(`${name}, steps of ${live.with_unit(step, 's', 2)}`, 10, top + 4, 'left', colour);
      painter.text(time(price), size.width - 10, top + 4, 'right', colour);
      const [above, below] = [top + 14, top + 14 + Math.max(3, row * 0.22)];
      painter.polygon([[10, above], [right, above], [right, below], [10, below]], colour);
    });
  }

  /** Where in the first picture one points is the error that one allows. */
  const allow = wanted => ({wanted: Number(Math.max(1e-10, Math.min(0.1, wanted)).toPrecision(2))});

  live.figures.price_of_error = {
    title: 'The error that you allow decides which rung is the cheapest',
    tables: ['step_prices'],
    hint: 'Drag the dashed line in the first picture up and down; by keys, with the arrows.',
    knobs: {
      problem: {label: 'Problem', choices: problems},
      wanted: {label: 'Largest error allowed', log: true},
    },
    panels: [
      {
        label: 'Error against price, both axes logarithmic: a line for each rung, with the two cheapest that are near enough in colour.',
        aspect: 1.1,
        draw: draw_errors,
        drag: (plot, at) => allow(plot.value_at(at)[1]),
        key: ([, up], {values}) => allow(values.wanted * 10 ** (up / 2)),
      },
      {label: 'The cheapest rungs that are near enough, as bars of their price.', aspect: 1.1, draw: draw_bars},
    ],
    finding(state) {
      const {columns, values} = state;
      const {with_unit} = live;
      const places = ranking(state), [first, second] = places;
      const [seconds] = columns.seconds;
      const asked = `For an error of at most ${with_unit(values.wanted, 'rad')} after ${with_unit(seconds, 's')}`;
      if (!first) return columns.needed.some(steps => steps > 0) ? `${asked} no price is known: the book’s build has measured none.`
        : `${asked} none of these rungs is near enough with 4096 steps.`;
      const ratio = second && second.price / first.price;
      const others = !second ? 'No other rung is near enough with 4096 steps.'
        : ratio < 1.05 ? `The next, “${second.name}”, costs as much.` : `The next, “${second.name}”, costs ${live.shown(ratio, 2)} times as much.`;
      const exact = exact_price(state);
      const beside = Number.isFinite(exact) ? ` The exact solution answers once at the end, for ${time(exact)} a simulated second.` : '';
      return `${asked} the cheapest rung is “${first.name}”, with ${first.steps === 1 ? 'a single step' : `steps of ${with_unit(first.step, 's', 2)}`}: ` +
        `${time(first.price)} for each simulated second, as measured when this book was made. ${others}${beside}`;
    },
  };
})();
