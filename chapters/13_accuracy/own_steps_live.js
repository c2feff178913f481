// How a comet's steps are drawn along its orbit and against the time, and what there is to find.
(() => {
  const live = tumble_live;
  /** Which step lasts at this time. */
  const step_at = ({columns, time}) => {
    const after = columns.time.findIndex(end => end > time);
    return (after < 0 ? columns.time.length - 1 : after) - 1;
  };

  function draw_orbit(picture, state) {
    const {painter, palette, size} = picture;
    const {columns} = state;
    const plot = new live.Plot(painter, palette, size, {label: 'from the star', unit: 'm', least: -2.1, most: 1.1},
      {label: '', unit: '', least: -1.2, most: 1.2}, {equal: true});
    picture.plot = plot;
    plot.line(columns['ellipse x'], columns['ellipse y'], palette.bodies[0], {width: 1});
    plot.points([0], [0], palette.bodies[4], 7);
    plot.points(columns.x, columns.y, palette.bodies[1], 2.5);
    const n = step_at(state);
    plot.line(columns.x.subarray(n, n + 2), columns.y.subarray(n, n + 2), palette.ink, {width: 3});
    plot.points([columns.x[n]], [columns.y[n]], palette.ink, 5);
    plot.legend([['exact', palette.bodies[0]], ['a dot a step', palette.bodies[1], 'dot']]);
  }

  function draw_steps(picture, state) {
    const {painter, palette, size} = picture;
    const {columns} = state;
    const shortest = Math.min(...columns.step);
    const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: columns.time.at(-1)},
      {label: '', unit: '', log: true, least: 10 ** Math.floor(Math.log10(shortest)), most: 10});
    picture.plot = plot;
    plot.line(columns.time, columns.distance, palette.bodies[0], {width: 1});
    columns.tried.forEach((length, n) => plot.cross(plot.place([columns['tried at'][n], length]), palette.bodies[2]));
    plot.points(columns.time.subarray(0, columns.step.length), columns.step, palette.bodies[1], 2.5);
    const n = step_at(state);
    plot.points([columns.time[n]], [columns.step[n]], palette.ink, 5);
    plot.legend([['distance (m)', palette.bodies[0]], ['step (s)', palette.bodies[1], 'dot'], ['rejected', palette.bodies[2], 'cross']]);
  }

  live.figures.own_steps = {
    title: 'Where does the comet need short steps?',
    knobs: {
      eccentricity: {label: 'Eccentricity of the orbit'},
      tolerance: {label: 'Error allowed in each second', log: true, words: value => live.with_unit(value, 'm and m/s', 3)},
    },
    duration: ({columns}) => columns.time.at(-1),
    still_time: 1.5,
    panels: [
      {label: 'The orbit of a comet round its star: the exact ellipse, and a dot where each step begins.', draw: draw_orbit},
      {label: 'The length of each step against the time, on a logarithmic axis, with the steps that were rejected as crosses and the distance from the star as a line.', draw: draw_steps},
    ],
    finding({columns}) {
      const {shown, with_unit} = live;
      const steps = columns.step, [shortest, longest] = [Math.min(...steps), Math.max(...steps)];
      const {length: rejected} = columns.tried;
      const again = rejected === 0 ? 'none was rejected' : rejected === 1 ? 'one more was rejected' : `${rejected} more were rejected`;
      return `The round takes ${steps.length} steps, and ${again}. They last from ${with_unit(shortest, 's', 2)} to ${with_unit(longest, 's', 2)}; ` +
        `if all were as short as the shortest, there would be ${shown(Math.ceil(columns.time.at(-1) / shortest), 2)}. ` +
        `In the end the comet misses the point where it started by ${with_unit(columns.missed[0], 'm', 2)}.`;
    },
  };
})();
