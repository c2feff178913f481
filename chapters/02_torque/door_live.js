// How the pushed door is drawn, and what there is to find.
(() => {
  const live = tumble_live, width = 0.8, apart = 3;
  /** Until the page's first question is answered there are only the door and its push. */
  const is_open = () => live.answered('door');
  const per_newton = 0.025; // m of the drawn arrow
  const radians = degrees => (degrees * Math.PI) / 180;

  /** Marks the directions between the last one shown and this one, the short way round. */
  function swept(figure, columns, angle) {
    const {angles} = columns, last = figure.last_angle ?? angle;
    figure.seen ??= Array(angles.length).fill(false);
    const turn = ((angle - last + 540) % 360) - 180, parts = Math.ceil(Math.abs(turn) / apart) || 1;
    for (let part = 0; part <= parts; ++part) {
      const now = ((last + (turn * part) / parts + 540) % 360) - 180;
      figure.seen[Math.round((now + 180) / apart)] = true;
    }
    if (Math.abs(angle) === 180) figure.seen[0] = figure.seen[angles.length - 1] = true; // one direction, two names
    figure.last_angle = angle;
    return figure.seen;
  }

  /** An arrow round the hinge, as long as the torque is large. */
  function draw_turning(painter, plot, torque, colour) {
    if (Math.abs(torque) < 0.05) return;
    const sweep = (torque / 12) * 2.4, count = 24;
    const arc = Array.from({length: count + 1}, (_, n) => plot.place([0.2 * Math.cos((sweep * n) / count), 0.2 * Math.sin((sweep * n) / count)]));
    painter.line(arc, colour, 3, 1);
    const [x, y] = arc.at(-1), [along_x, along_y] = [-Math.sin(sweep) * Math.sign(torque), -Math.cos(sweep) * Math.sign(torque)];
    painter.polygon([[x + 9 * along_x, y + 9 * along_y], [x - 5 * along_y, y + 5 * along_x], [x + 5 * along_y, y - 5 * along_x]], colour);
  }

  live.figures.door = {
    title: 'How strongly does a push turn the door from here?',
    hint: 'Drag along the door to push elsewhere; drag the arrow’s tail to turn the push.',
    knobs: {
      at: {label: 'Pushed at, from the hinge'},
      angle: {label: 'Angle between door and push'},
      force: {label: 'Force'},
    },
    reset(figure) {
      figure.described.seen = figure.described.last_angle = undefined;
    },
    panels: [
      {
        label: 'A door from above, with its hinge, the lever arm from the hinge to the push, and the push as an arrow.',
        aspect: 1.1,
        draw(picture, {columns, values}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'from the hinge', unit: 'm', least: -0.3, most: 1.2},
            {label: '', unit: '', least: -0.6, most: 0.6}, {equal: true});
          picture.plot = plot;
          const [along_x, along_y] = [Math.cos(radians(values.angle)), Math.sin(radians(values.angle))];
          const [distance] = columns.distance, [torque] = columns.torque;
          painter.polygon([[0, 0.03], [width, 0.03], [width, -0.03], [0, -0.03]].map(corner => plot.place(corner)), palette.grid);
          if (is_open()) {
            plot.line([values.at - 3 * along_x, values.at + 3 * along_x], [-3 * along_y, 3 * along_y], palette.ink, {width: 1, dash: [5, 4]});
            plot.line([0, distance * along_y], [0, -distance * along_x], palette.bodies[2], {width: 3});
            if (Math.abs(distance) > 0.1) plot.note('*d*', [(distance * along_y) / 2, (-distance * along_x) / 2], palette.bodies[2]);
            draw_turning(painter, plot, torque, palette.bodies[3]);
          }
          if (values.at > 0.02) live.arrow(painter, plot.place([0, 0]), plot.place([values.at, 0]), palette.bodies[0], 3);
          const tail = [values.at - per_newton * values.force * along_x, -per_newton * values.force * along_y];
          live.arrow(painter, plot.place(tail), plot.place([values.at, 0]), palette.bodies[1], 3.5);
          plot.points([tail[0]], [tail[1]], palette.bodies[1], 5);
          plot.points([0], [0], palette.ink, 5);
          plot.legend([['arm', palette.bodies[0]], ['push', palette.bodies[1]],
            ...(is_open() ? [['distance *d*', palette.bodies[2]], ['turns', palette.bodies[3]]] : [])]);
        },
        drag(plot, at, {figure, values}, begins) {
          const [x, y] = plot.value_at(at), reach = per_newton * values.force;
          const tail = [values.at - reach * Math.cos(radians(values.angle)), -reach * Math.sin(radians(values.angle))];
          if (begins) figure.turns = Math.abs(y) > 0.07 || Math.hypot(x - tail[0], y - tail[1]) < 0.05;
          if (!figure.turns) return {at: Math.round(100 * x) / 100};
          if (Math.hypot(values.at - x, y) < 0.02) return {};
          return {angle: Math.round((Math.atan2(-y, values.at - x) * 180) / Math.PI)};
        },
        key: ([right, up], {values}) => ({at: values.at + 0.02 * right, angle: values.angle + 3 * up}),
      },
      {
        label: 'Torque about the hinge against the angle between door and push: drawn where the push has been turned, with points computed as force times distance.',
        aspect: 1.1,
        draw(picture, {columns, values, figure}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'angle between door and push', unit: '°', least: -180, most: 180},
            {label: 'torque', unit: 'N m', least: -13, most: 13});
          picture.plot = plot;
          const seen = swept(figure, columns, values.angle);
          if (!is_open()) return plot.ask();
          const [torque] = columns.torque;
          for (let n = 0; n < columns.angles.length; n += 5) {
            const [x, y] = plot.place([columns.angles[n], columns['force times distance'][n]]);
            painter.disc(x, y, 3.5, palette.bodies[2]);
            painter.disc(x, y, 2, palette.paper);
          }
          plot.line(columns.angles, columns.torques.map((value, n) => (seen[n] ? value : NaN)), palette.bodies[3]);
          plot.points([values.angle], [torque], palette.bodies[3], 6);
          plot.legend([['turned so far', palette.bodies[3]], ['force × *d*', palette.bodies[2]]]);
        },
        drag: (plot, at) => ({angle: Math.round(plot.value_at(at)[0])}),
        key: ([right], {values}) => ({angle: values.angle + 3 * right}),
      },
    ],
    finding({columns, values}) {
      const {with_unit} = live;
      const push = `A push of ${with_unit(values.force, 'N')} at ${with_unit(values.angle, '°')} to the door, ${with_unit(values.at, 'm')} from the hinge`;
      if (!is_open()) return `${push}. Say first what torques the three pushes make, and this one’s torque is shown.`;
      const [torque] = columns.torque, distance = Math.abs(columns.distance[0]);
      if (distance < 1e-9) return `${push}, makes no torque, however hard it is: its line runs through the hinge.`;
      return `${push}, makes a torque of ${with_unit(torque, 'N m')}, ${torque > 0 ? 'anticlockwise' : 'clockwise'}. Its line passes the hinge at ` +
        `d = ${with_unit(distance, 'm')}, and ${with_unit(values.force, 'N')} × ${with_unit(distance, 'm')} makes the same.`;
    },
  };
})();
