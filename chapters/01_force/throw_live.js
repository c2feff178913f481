// How the thrown ball is drawn, and what there is to find.
tumble_live.figures.throw = {
  title: 'What decides how far off the ball is?',
  hint: 'Drag the arrow in the picture to throw the ball differently.',
  knobs: {
    h: {label: 'Time step *h*', log: true},
    gravity: {label: 'Gravity', choices: ['as a force, m g', 'as an acceleration, g']},
    mass: {label: 'Mass', log: true},
    forward: {label: 'Initial velocity, forward'},
    up: {label: 'Initial velocity, up'},
  },
  panels: [
    {
      label: 'Height against distance: the exact parabola as a line, the stepped ball as points, the initial velocity as an arrow.',
      aspect: 1.25,
      draw(picture, {columns, values}) {
        const {painter, palette, size} = picture;
        const {range_of, Plot, arrow} = tumble_live;
        const x = range_of([columns['exact distance'], columns.distance, [0, values.forward / 4]], {smallest: 4});
        const y = range_of([columns['exact height'], columns.height, [0, values.up / 4]], {smallest: 4});
        const plot = new Plot(painter, palette, size, {label: 'distance', unit: 'm', ...x}, {label: 'height', unit: 'm', ...y});
        picture.plot = plot;
        plot.line(columns['exact distance'], columns['exact height'], palette.bodies[0]);
        plot.points(columns.distance, columns.height, palette.bodies[1], 3);
        arrow(painter, plot.place([0, 0]), plot.place([values.forward / 4, values.up / 4]), palette.ink);
        plot.note('velocity', [values.forward / 4, values.up / 4], palette.ink, 'right');
        plot.legend([['exact', palette.bodies[0]], ['stepped', palette.bodies[1], 'dot']]);
      },
      drag(plot, at) {
        const [x, y] = plot.value_at(at);
        return {forward: 4 * x, up: 4 * y};
      },
      key: ([right, up], {values}) => ({forward: values.forward + 0.5 * right, up: values.up + 0.5 * up}),
    },
    {
      label: 'How far the stepped ball is below the parabola, against time: a straight line.',
      aspect: 1.25,
      draw(picture, {columns}) {
        const {painter, palette, size} = picture;
        const below = columns['below the parabola'];
        const plot = new tumble_live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 2},
          {label: 'too low by', unit: 'm', ...tumble_live.range_of([below, [0]])});
        picture.plot = plot;
        plot.points(columns.time, below, palette.bodies[1], 3);
        if (!tumble_live.answered('half_the_step')) return;
        plot.line(columns.time, columns['half g h t'], palette.bodies[0]);
        plot.legend([['stepped', palette.bodies[1], 'dot'], ['½ *g h t*', palette.bodies[0]]]);
      },
    },
  ],
  finding({columns}) {
    const {with_unit} = tumble_live;
    const last = name => columns[name].at(-1);
    const by_formula = tumble_live.answered('half_the_step') ? `, and ½ *g h t* is ${with_unit(last('half g h t'), 'm')}` : '';
    const off = Math.abs(columns['exact distance'].at(-1) - columns.distance.at(-1));
    return `After ${with_unit(last('time'), 's')} the stepped ball is ${with_unit(last('below the parabola'), 'm')} below the parabola${by_formula}. ` +
      (off < 1e-9 ? 'Forward it is right, to rounding.' : `Forward it is off by ${with_unit(off, 'm', 2)}.`);
  },
};
