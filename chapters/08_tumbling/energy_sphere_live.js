// How the sphere of L and the body are drawn, and what there is to find.
(() => {
  const live = tumble_live, player = globalThis.tumble_player;
  const rules = ['steady: no gyroscopic term', 'explicit', 'explicit, |L| restored', 'implicit, one Newton step', 'momentum-carrying',
    'splitting by axes', 'splitting with a sphere'];
  const axis_names = ['axis 1, the smallest moment', 'axis 2, the middle one', 'axis 3, the largest'];
  const point = (columns, name, n) => ['x', 'y', 'z'].map(letter => columns[`${name} ${letter}`][n]);
  const step_at = ({columns, time}) => {
    const times = columns.time;
    return Math.max(0, Math.min(times.length - 1, Math.floor(time / (times[1] ?? 1) + 1e-9)));
  };

  /** What stands for one thing has one colour in all three pictures. */
  const colours_of = ({bodies}) => ({L: bodies[1], energy: bodies[2], omega: bodies[3]});

  /** A box with the body's moments, its sides about 1; in the order in which the top keeps its axes. */
  function box_of({columns, values}) {
    const moments = [1, values.middle, 1.8];
    const total = moments[0] + moments[1] + moments[2];
    const sides = moments.map(moment => Math.sqrt((total - 2 * moment) / total) * 1.5);
    const in_body = [0, 0, 0];
    columns.axis.forEach((axis, n) => { in_body[axis] = sides[n]; });
    return in_body;
  }

  function draw_body(picture, state) {
    const {painter, palette, size, view} = picture;
    const {columns} = state, colours = colours_of(palette);
    const n = step_at(state);
    const camera = {target: [0, 0, 0], distance: 6.1, ...view};
    const parts = live.once(columns, 'box', () => [{box: box_of(state)}]);
    const orientation = [columns['q real'][n], ...point(columns, 'q', n)];
    live.draw_body(picture, camera, 'thrown box', parts, orientation);
    const project = player.projection(camera, size), {back} = player.picture_axes(view), matrix = player.matrix_of(orientation);
    // Where the sphere's axes come out of the box, on the sides that one sees.
    columns.axis.forEach((axis, number) => {
      for (const side of [-1, 1]) {
        const out = player.turned(matrix, [0, 1, 2].map(k => (k === axis ? side * (parts[0].box[axis] / 2 + 0.1) : 0)));
        const [x, y] = project(out);
        if (player.dot(out, back) > 0.25 * Math.hypot(...out)) painter.text(String(number + 1), x, y, 'center', palette.ink);
      }
    });
    const arrows = [['L', '*L*', colours.L], ['omega', '*ω*', colours.omega]]
      .map(([name, words, colour]) => ({words, colour, end: project(player.scaled(point(columns, name, n), 1.35))}));
    arrows.forEach(({words, colour, end: [x, y]}, k) => {
      live.arrow(painter, project([0, 0, 0]), [x, y], colour);
      // Each name on the side away from the other arrow.
      const [dx, dy] = [x - arrows[1 - k].end[0], y - arrows[1 - k].end[1]], apart = Math.hypot(dx, dy) || 1;
      painter.text(words, x + (13 * dx) / apart, y + (13 * dy) / apart, 'center', colour);
    });
    painter.text('in world axes', 10, 12, 'left', palette.ink);
  }

  function draw_sphere(picture, state) {
    const {painter, palette, size, view} = picture;
    const {columns} = state, colours = colours_of(palette);
    const {right, up, back} = player.picture_axes(view);
    // Words stand above it and below.
    const above = 22, below = 42;
    const scale = Math.min(size.width * 0.4, (size.height - above - below) / 2.24), middle = (above + size.height - below) / 2;
    const place = p => [size.width / 2 + scale * player.dot(p, right), middle - scale * player.dot(p, up)];
    painter.line(Array.from({length: 91}, (_, n) => [size.width / 2 + scale * Math.cos((n * Math.PI) / 45),
      middle - scale * Math.sin((n * Math.PI) / 45)]), palette.ink, 1, 0.8);
    /** What lies at the back first, and faint. */
    const draw = (name, colour, width, dash, last = Infinity) => {
      const [xs, ys, zs] = ['x', 'y', 'z'].map(letter => columns[`${name} ${letter}`]);
      const parts = [[], []]; // at the back, in front
      let side, part = [];
      for (let n = 0; n < Math.min(last + 1, xs.length); ++n) {
        const [x, y, z] = [xs[n], ys[n], zs[n]];
        const depth = x * back[0] + y * back[1] + z * back[2];
        const now = Number.isNaN(depth) ? undefined : depth < 0 ? 0 : 1;
        if (now !== side) {
          if (part.length > 1) parts[side].push(part);
          [side, part] = [now, []];
        }
        if (now !== undefined)
          part.push([size.width / 2 + scale * (x * right[0] + y * right[1] + z * right[2]),
            middle - scale * (x * up[0] + y * up[1] + z * up[2])]);
      }
      if (part.length > 1) parts[side].push(part);
      parts.forEach((lines, in_front) => lines.forEach(line => painter.line(line, colour, width, in_front ? 1 : 0.25, dash)));
    };
    draw('curve', palette.ink, 1, []);
    draw('separatrix', palette.ink, 1, [5, 4]);
    draw('own', colours.energy, 2, []);
    const n = step_at(state);
    draw('tip', colours.L, 1.5, [], n);
    const tip = point(columns, 'tip', n);
    painter.disc(...place(tip), player.dot(tip, back) >= 0 ? 5.5 : 3.5, colours.L);
    for (let axis = 0; axis < 3; ++axis) {
      const end = [0, 0, 0];
      end[axis] = 1;
      if (player.dot(end, back) < -0.2) continue;
      const [x, y] = place(player.scaled(end, 1.12));
      painter.text(String(axis + 1), x, y, 'center', palette.ink);
    }
    painter.text('in body axes', 10, 12, 'left', palette.ink);
    painter.text('energy curve', 10, size.height - 28, 'left', colours.energy);
    painter.text('tip of *L*', 10, size.height - 12, 'left', colours.L);
  }

  function draw_constants(picture, state) {
    const {painter, palette, size} = picture;
    const {columns, values} = state, colours = colours_of(palette);
    const along = columns[`tip ${'xyz'[values.about]}`];
    const {least, most} = live.range_of([columns.energy, columns.momentum, along, [-1, 1]], {limit: 4});
    const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 12},
      {label: 'relative', unit: '', least, most});
    picture.plot = plot;
    plot.line(columns.time, along, colours.L);
    plot.line(columns.time, columns.energy, colours.energy);
    plot.line(columns.time, columns.momentum, colours.L, {dash: [6, 4]}); // on top: often both are 1
    const n = step_at(state);
    plot.points([columns.time[n]], [along[n]], colours.L, 4);
    plot.legend([[`*L*${'₁₂₃'[values.about]}`, colours.L], ['|*L*|', colours.L, [6, 4]], ['energy', colours.energy]]);
  }

  live.figures.energy_sphere = {
    title: 'Seen from the box, L runs round a loop; half a round is a flip',
    hint: 'Drag the body or the sphere to turn it; by keys, with the arrows.',
    knobs: {
      rule: {label: 'Rule', choices: rules},
      h: {label: 'Time step *h*', log: true},
      wobble: {label: 'Wobble, as a fraction of the spin', log: true},
      about: {label: 'Spin of 10 rad/s about', choices: axis_names},
      middle: {label: 'Middle moment'},
    },
    duration: ({columns}) => columns.time.at(-1),
    timeline: true,
    still_time: 8,
    panels: [
      {label: 'The body in the world, with its angular momentum L and its angular velocity as arrows.', turns: true, aspect: 1.15,
        view: {azimuth: -0.8, elevation: 0.4}, draw: draw_body},
      {label: 'The sphere of L with the curves of equal energy, and the path of the tip of L.', turns: true, aspect: 1.15,
        view: {azimuth: 0.9, elevation: 0.38}, draw: draw_sphere},
      {label: 'Against time and relative to the start: the energy, the length of L, and the part of L along the axis of the spin, whose sign changes with each flip.', aspect: 3.2, draw: draw_constants},
    ],
    finding({columns, values}) {
      const {shown, with_unit} = live;
      const energy = columns.energy.at(-1), momentum = columns.momentum.at(-1);
      const most_off = columns.energy.reduce((most, value) => Math.max(most, Math.abs(value - 1)), 0);
      const kept = (value, words) => (Math.abs(value - 1) < 1e-9 ? `${words} is kept to rounding` : `${words} is ${shown(value, 4)} of what it was`);
      if (values.rule === 0)
        return 'The tip of *L* stands still in the body, so the body turns steadily and never flips. In the world *L* goes round with it, ' +
          'which no torque asked for.';
      const books = `After 12 s ${kept(momentum, '|*L*|')}, ` +
        (most_off < 1e-9 ? 'and so is the energy. ' : `and the energy, off by ${with_unit(100 * most_off, '%', 2)} at most, ` +
          `${Math.abs(energy - 1) < 0.3 * most_off ? 'has come back' : `ends at ${shown(energy, 4)} of what it was`}. `);
      const flips = columns.flips;
      if (values.about !== 1) {
        const along = columns[`tip ${values.about === 0 ? 'x' : 'z'}`];
        const least = along.reduce((low, value, n) => Math.min(low, value / columns.momentum[n]), 1);
        const axis = values.about === 0 ? 'axis 1' : 'axis 3';
        return books + (least > along[0] - 0.2 ? `Spun about ${axis}, the body only wobbles.`
          : `Spun about ${axis}, which is stable, the body has been made to tumble by the rule.`);
      }
      if (flips.length === 0) return `${books}No flip yet: the exact motion flips ${with_unit(columns['exact wait'][0] / 2, 's')} after the throw.`;
      const wait = flips.length > 1 ? `, then every ${with_unit((flips.at(-1) - flips[0]) / (flips.length - 1), 's')}` : '';
      return `${books}It flips first after ${with_unit(flips[0], 's')}${wait}; the exact motion takes ${with_unit(columns['exact wait'][0], 's')} from flip to flip.`;
    },
  };
})();
