// How the torqued satellite is drawn, and what there is to find.
(() => {
  const live = tumble_live, player = globalThis.tumble_player;
  const parts = [{box: [1, 1, 2]}, {box: [0.3, 0.3, 0.3], position: [0, 0.4, 1.1]}];
  const length = v => Math.hypot(...v);

  live.figures.same_torque = {
    title: 'About which axis does the same torque turn the satellite?',
    hint: 'Drag the satellite to see it from elsewhere, or the point along the curves; by keys, with the arrows.',
    knobs: {
      'about x': {label: 'The body is rolled about *x*'},
      'about z': {label: 'and then turned about *z*'},
      direction: {label: 'Torque, from *x* towards *z*'},
      frame: {label: 'The torque’s numbers are used as', choices: ['the world’s, as they are', 'the body’s: mixed']},
    },
    panels: [
      {
        label: 'A satellite with the torque on it and the angular velocity that it gets, as arrows.',
        turns: true,
        view: {azimuth: -0.9, elevation: 0.3},
        draw(picture, {columns, values}) {
          const {painter, palette, size, view} = picture;
          const camera = {target: [0, 0, 0], distance: 9, ...view};
          live.draw_body(picture, camera, 'satellite', parts, [...columns.pose], {has_axes: true});
          const project = player.projection(camera, size);
          const mark = (vector, factor, words, colour, dash) => {
            const end = project(vector.map(component => factor * component));
            live.arrow(painter, project([0, 0, 0]), end, colour, dash ? 1.2 : 2.5);
            painter.text(words, end[0] + 6, end[1] - 8, 'left', colour);
          };
          mark([...columns.torque], 1.9, 'torque', palette.ink);
          if (values.frame === 1) mark([...columns.right], 3.2, '*ω*, right', palette.bodies[0], true);
          mark([...columns.omega], 3.2, '*ω*', palette.bodies[1]);
        },
      },
      {
        label: 'Angular velocity along the torque against how far the body is rolled, by the right way and by the mistake.',
        draw(picture, {columns, values}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'rolled about *x*', unit: '°', least: -180, most: 180},
            {label: '*ω* along the torque', unit: 'rad/s', ...live.range_of([columns['right along'], columns['wrong along'], [0]])});
          picture.plot = plot;
          plot.line(columns.rolled, columns['right along'], palette.bodies[0]);
          plot.line(columns.rolled, columns['wrong along'], palette.bodies[1], {dash: [6, 4]});
          const along = columns.omega.reduce((sum, value, n) => sum + value * columns.torque[n], 0);
          plot.points([values['about x']], [along], palette.bodies[values.frame], 6);
          plot.legend([['world', palette.bodies[0]], ['mixed', palette.bodies[1], [6, 4]]]);
        },
        drag: (plot, at) => ({'about x': plot.value_at(at)[0]}),
        key: ([right], {values}) => ({'about x': values['about x'] + 2 * right}),
      },
    ],
    finding({columns}) {
      const {with_unit} = live;
      const [omega, torque, right] = [[...columns.omega], [...columns.torque], [...columns.right]];
      const angle = (a, b) => (Math.acos(Math.max(-1, Math.min(1, player.dot(a, b) / length(a) / length(b)))) * 180) / Math.PI;
      const off = angle(omega, right);
      const answer = `The satellite turns at ${with_unit(length(omega), 'rad/s')}, about an axis ${with_unit(angle(omega, torque), '°', 2)} from the torque; along the torque that is ${with_unit(player.dot(omega, torque), 'rad/s')}.`;
      return off < 1e-6 ? answer : `${answer} With the right components it would turn about an axis ${with_unit(off, '°', 2)} from that.`;
    },
  };
})();
