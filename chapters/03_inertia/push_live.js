// How the pushed hammer is drawn, and what there is to find.
(() => {
  const live = tumble_live;

  /** The outline of handle and head about the centre, turned and moved, as points of the ice. */
  function outline(columns, n, corners) {
    const [centre] = columns.centre, [c, s] = [columns.cosine[n], columns.sine[n]];
    return corners.map(([x, y]) => [columns.x[n] + c * x - s * (y - centre), columns.y[n] + s * x + c * (y - centre)]);
  }
  const box = (low, high, half) => [[-half, low], [-half, high], [half, high], [half, low]];
  const path = (columns, at) => Array.from(columns.time, (_, n) => outline(columns, n, [[0, at]])[0]);

  live.figures.push = {
    title: 'What changes with the place of the push, and what does not?',
    hint: 'Drag in the picture to draw the push: it acts where you begin.',
    knobs: {
      at: {label: 'Where it is pushed'},
      impulse: {label: 'Push'},
      angle: {label: 'Direction of the push'},
      head: {label: 'Mass of the head'},
    },
    duration: ({columns}) => columns.time.at(-1),
    still_time: 0.6,
    panels: [
      {
        label: 'A hammer on ice from above, with its push as an arrow, the path of its centre and that of one end, and the point that stands still at first.',
        aspect: 1.9,
        draw(picture, {columns, values, time}) {
          const {painter, palette, size} = picture;
          const ends = [path(columns, -0.15), path(columns, 0.18)].flat();
          const x = live.range_of([ends.map(p => p[0]), columns.x, [-0.35, 0.2]]), y = live.range_of([ends.map(p => p[1]), columns.y, [-0.2, 0.25]]);
          const plot = new live.Plot(painter, palette, size, {label: '*x*', unit: 'm', ...x}, {label: '*y*', unit: 'm', ...y}, {equal: true});
          picture.plot = plot;
          const n = Math.min(columns.time.length - 1, Math.floor(time * 250 + 1e-9));
          const shown = m => {
            painter.polygon(outline(columns, m, box(-0.15, 0.15, 0.015)).map(p => plot.place(p)), palette.bodies[4]);
            if (values.head > 0) painter.polygon(outline(columns, m, box(0.15, 0.18, 0.05)).map(p => plot.place(p)), palette.bodies[0]);
          };
          const draw_path = (points, colour, dash) => plot.line(points.slice(0, n + 1).map(p => p[0]), points.slice(0, n + 1).map(p => p[1]), colour, {width: 1.5, dash});
          draw_path(path(columns, -0.15), palette.bodies[3], [3, 3]);
          painter.clipped(plot.box, () => { shown(0); if (n > 0) shown(n); });
          draw_path(path(columns, columns.centre[0]), palette.bodies[1], []);
          plot.points([columns.x[n]], [columns.y[n]], palette.bodies[1], 5);
          const angle = (values.angle * Math.PI) / 180;
          const point = before => [-before * Math.cos(angle), values.at - before * Math.sin(angle)];
          const half = values.at > 0.15 ? 0.05 : 0.015; // of the hammer's width there
          const tip = Math.min(half / Math.max(0.2, Math.abs(Math.cos(angle))), 0.3 * values.impulse);
          const tail = point(0.3 * values.impulse + tip);
          live.arrow(painter, plot.place(tail), plot.place(point(tip)), palette.ink, 3);
          plot.note('push', tail, palette.ink, Math.cos(angle) < 0 ? 'left' : 'right');
          const [rest] = columns['at rest'];
          if (Number.isFinite(rest)) plot.points([0], [rest], palette.bodies[2], 5);
          plot.legend([['centre', palette.bodies[1]], ['handle’s end', palette.bodies[3], [3, 3]], ['still at first', palette.bodies[2], 'dot']]);
        },
        drag(plot, at, {figure, values}, begins) {
          const [x, y] = plot.value_at(at);
          if (begins) {
            figure.from = [x, y];
            return {at: y};
          }
          const [dx, dy] = [x - figure.from[0], y - figure.from[1]];
          const length = Math.hypot(dx, dy);
          if (length < 0.01) return {};
          return {at: figure.from[1], impulse: length / 0.3, angle: (Math.atan2(dy, dx) * 180) / Math.PI, head: values.head};
        },
        key: ([right, up], {values}) => ({at: values.at + 0.01 * up, impulse: values.impulse + 0.02 * right}),
      },
    ],
    finding({columns, values}) {
      const {shown, with_unit} = live;
      const [speed] = columns.speed, [spin] = columns.spin, [rest] = columns['at rest'], [centre] = columns.centre;
      const moves = `The centre of mass, at ${with_unit(centre, 'm')}, moves at ${with_unit(speed, 'm/s')}, wherever the hammer is pushed. `;
      if (Math.abs(spin) < 1e-9) return `${moves}Pushed through it, the hammer does not turn.`;
      const stands = values.angle % 180 !== 0 ? 'No point of the hammer stands quite still unless the push is perpendicular to it.'
        : rest > -0.15 && rest < 0.15 ? `The point at ${with_unit(rest, 'm')} stands still for a moment: hold the hammer there, and the hand feels nothing.`
          : rest < 0.18 && rest > 0 ? `The point at ${with_unit(rest, 'm')}, in the head, stands still for a moment.`
          : `The point that stands still lies at ${with_unit(rest, 'm')}, beyond the hammer.`;
      return `${moves}The hammer turns at ${shown(spin)} rad/s. ${stands}`;
    },
  };
})();
