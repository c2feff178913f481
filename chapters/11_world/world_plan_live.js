// How a small world is drawn beside its plan, and what the plan says.
(() => {
  const live = tumble_live;
  const bodies = ['post', 'ball', 'drop', 'box'];
  const half = [0.15, 0.25, 0.4]; // of the box's sides, m, in the order of its axes
  const on_off = ['off', 'on'];
  const text_of = column => new TextDecoder().decode(Uint8Array.from(column)).split('\n').filter(Boolean);
  const step_at = ({columns, time}) => Math.max(0, Math.min(columns.time.length - 1, Math.floor(time / (columns.time[1] ?? 1) + 1e-9)));

  /** The lines of the plan: {name, reason, visited, of}. */
  const lines_of = columns => text_of(columns.plan).map((line, n) => {
    const [name, reason] = line.split('\t');
    return {name, reason, visited: columns.visited[n], of: columns.of[n]};
  });

  /** A vector of the box in world axes: v + 2 w (u × v) + 2 u × (u × v). */
  function turned([w, ...u], v) {
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const once = cross(u, v), twice = cross(u, once);
    return v.map((value, n) => value + 2 * (w * once[n] + twice[n]));
  }

  function draw_box(plot, columns, n, colour) {
    const q = ['real', 'x', 'y', 'z'].map(name => columns[`q ${name}`][n]);
    const [x, z] = [columns['box x'][n], columns['box z'][n]];
    const corner = signs => {
      const at = turned(q, signs.map((sign, axis) => sign * half[axis]));
      return [x + at[0], z + at[2]];
    };
    for (let axis = 0; axis < 3; ++axis)
      for (const one of [-1, 1])
        for (const other of [-1, 1]) {
          const ends = [-1, 1].map(along => {
            const signs = [one, other];
            signs.splice(axis, 0, along);
            return corner(signs);
          });
          plot.line(ends.map(end => end[0]), ends.map(end => end[1]), colour, {width: 1.5});
        }
  }

  live.figures.world_plan = {
    title: 'A step consists of what the scene calls for',
    knobs: {
      gravity: {label: 'Gravity', choices: on_off},
      air: {label: 'Drag of the air', choices: on_off},
      spring: {label: 'Spring from the post to the ball', choices: on_off},
      thruster: {label: 'Thruster on the box', choices: on_off},
      spin: {label: 'Spin of the box'},
      rate: {label: 'Steps in a second', log: true, whole: true, words: value => live.with_unit(value, '1/s')},
    },
    duration: ({columns}) => columns.time.at(-1),
    still_time: 0.6,
    panels: [
      {
        label: 'The world from the side: a post that nothing can move, a ball, a drop and a box, with their paths.',
        aspect: 1,
        draw(picture, state) {
          const {painter, palette, size} = picture;
          const {columns, values} = state;
          const plot = new live.Plot(painter, palette, size, {label: 'x', unit: 'm', least: -3, most: 3},
            {label: 'z', unit: 'm', least: -1, most: 4}, {equal: true});
          picture.plot = plot;
          const n = step_at(state);
          const at = name => [columns[`${name} x`][n], columns[`${name} z`][n]];
          bodies.slice(1).forEach((name, place) => plot.line(columns[`${name} x`].slice(0, n + 1), columns[`${name} z`].slice(0, n + 1),
            palette.bodies[place], {width: 1.5, dash: [3, 3]}));
          if (values.spring > 0) plot.line([at('post')[0], at('ball')[0]], [at('post')[1], at('ball')[1]], palette.ink, {width: 1});
          plot.points([at('post')[0]], [at('post')[1]], palette.ink, 6);
          plot.points([at('ball')[0]], [at('ball')[1]], palette.bodies[0], 9);
          plot.points([at('drop')[0]], [at('drop')[1]], palette.bodies[1], 4);
          painter.clipped(plot.box, () => draw_box(plot, columns, n, palette.bodies[2]));
          [['post', palette.ink, 0], ['ball', palette.bodies[0], 0.1], ['drop', palette.bodies[1], 0], ['box', palette.bodies[2], 0.4]]
            .filter(([name]) => at(name)[1] > plot.y.least)
            .forEach(([name, colour, aside]) => plot.note(name, [at(name)[0] + aside, at(name)[1]], colour));
        },
      },
      {
        label: 'The plan: a line for each effect and motion, and a bar for the bodies that it visits in each step.',
        aspect: 1,
        draw(picture, {columns}) {
          const {painter, palette, size} = picture;
          const lines = lines_of(columns), row = Math.min(34, (size.height - 34) / lines.length), most = bodies.length;
          painter.text('the plan', 10, 12, 'left', palette.ink);
          painter.text('visits', size.width - 10, 12, 'right', palette.ink);
          lines.forEach(({name, visited, of}, n) => {
            const top = 32 + n * row, colour = visited > 0 ? palette.bodies[0] : palette.ink;
            painter.text(name, 10, top, 'left', colour);
            painter.text(visited > 0 ? `${visited} of ${of}` : 'no pass', size.width - 10, top, 'right', colour);
            const width = (size.width - 20) * visited / most;
            if (visited > 0) painter.polygon([[10, top + 9], [10 + width, top + 9], [10 + width, top + 13], [10, top + 13]], colour);
            painter.line([[10, top + 13], [size.width - 10, top + 13]], palette.grid, 1, 1);
          });
        },
      },
    ],
    finding({columns}) {
      const lines = lines_of(columns);
      const passes = lines.filter(({visited}) => visited > 0), idle = lines.filter(({visited}) => visited === 0);
      const why = idle.length === 0 ? 'Every line of the plan is a pass.' : `No pass: ${idle.map(({name, reason}) => `${name} (${reason})`).join('; ')}.`;
      const warnings = text_of(columns.warnings).map(warning => ` Warning: ${warning.replace(/[.]?$/, '.')}`).join('');
      return `A step makes ${passes.length} ${passes.length === 1 ? 'pass' : 'passes'}. ${why}${warnings}`;
    },
  };
})();
