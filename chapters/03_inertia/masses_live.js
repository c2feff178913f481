// How the dragged masses and their axes are drawn, and what there is to find.
(() => {
  const live = tumble_live;
  const ranks = ['smallest', 'middle', 'largest'];
  const is_upright = (columns, axis) => Math.abs(columns['axes z'][axis]) > 0.7;
  const alike = (one, other) => Math.abs(one - other) < 0.002 * Math.max(one, other);
  const coordinates = columns => Array.from(columns.x).flatMap((x, n) => [x, columns.y[n]]);
  const inside = value => Math.max(-1, Math.min(1, Math.round(100 * value) / 100));

  function moved(columns, which, [x, y]) {
    const drawn = coordinates(columns);
    [drawn[2 * which], drawn[2 * which + 1]] = [inside(x), inside(y)];
    return {drawn};
  }

  live.figures.masses = {
    title: 'The principal axes follow the masses',
    hint: 'Drag a mass. By keys, the arrows move the one that was dragged last, at first the heavy one.',
    knobs: {
      heavy: {label: 'Mass of the heavy one', log: true},
      apart: {label: 'Distance between the halves of each mass'},
    },
    panels: [
      {
        label: 'Four masses from above, which can be dragged, with their centre and the three principal axes through it.',
        aspect: 1,
        draw(picture, {columns, figure}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: '*x*', unit: 'm', least: -1.1, most: 1.1},
            {label: '*y*', unit: 'm', least: -1.1, most: 1.1}, {equal: true});
          picture.plot = plot;
          const [cx, cy] = columns.centre;
          const along = (axis, distance) => [cx + distance * columns['axes x'][axis], cy + distance * columns['axes y'][axis]];
          const flat = ranks.map((_, axis) => axis).filter(axis => !is_upright(columns, axis));
          for (const axis of flat) {
            const [from, to] = [along(axis, -3), along(axis, 3)];
            plot.line([from[0], to[0]], [from[1], to[1]], palette.bodies[axis], {width: 2});
          }
          columns.mass.forEach((mass, n) => plot.points([columns.x[n]], [columns.y[n]], n === (figure.held ?? 0) ? palette.bodies[3] : palette.ink,
            9 * Math.cbrt(mass)));
          const upright = ranks.findIndex((_, axis) => is_upright(columns, axis));
          plot.points([cx], [cy], palette.bodies[upright] ?? palette.ink, 9);
          plot.points([cx], [cy], palette.paper, 3);
          if (upright >= 0) {
            const side = cx > 0 ? -1 : 1; // where there is more room, on the left below the names of the other axes
            plot.note(`${ranks[upright]}, towards you`, [cx + 0.04 * side, cy + (side < 0 ? -0.35 : -0.2)], palette.bodies[upright], side < 0 ? 'right' : 'left');
          }
          for (const axis of flat) {
            const [x, y] = along(axis, columns['axes x'][axis] < 0 ? 0.62 : -0.62);
            plot.note(ranks[axis], [x, y + 0.12 * Math.abs(columns['axes x'][axis])], palette.bodies[axis]); // where the axis lies level its name stands higher
          }
        },
        drag(plot, at, {columns, figure}, begins) {
          const here = plot.value_at(at);
          if (begins) {
            const distances = Array.from(columns.x, (x, n) => Math.hypot(x - here[0], columns.y[n] - here[1]));
            figure.held = distances.indexOf(Math.min(...distances));
          }
          return moved(columns, figure.held, here);
        },
        key([right, up], {columns, figure}) {
          const n = figure.held ?? 0;
          return moved(columns, n, [columns.x[n] + 0.05 * right, columns.y[n] + 0.05 * up]);
        },
      },
      {
        label: 'The three principal moments as bars.',
        aspect: 1,
        draw(picture, {columns}) {
          const {painter, palette, size} = picture;
          const most = columns.moments[2] || 1, row = (size.height - 40) / 3;
          painter.text('principal moments', 10, 12, 'left', palette.ink);
          ranks.forEach((rank, axis) => {
            const top = 34 + axis * row, colour = palette.bodies[axis], right = 10 + (size.width - 20) * columns.moments[axis] / most;
            painter.text(`${rank}: ${live.with_unit(columns.moments[axis], 'kg m²')}${is_upright(columns, axis) ? ', towards you' : ''}`, 10, top, 'left', colour);
            painter.polygon([[10, top + 12], [right, top + 12], [right, top + 12 + row * 0.4], [10, top + 12 + row * 0.4]], colour);
            painter.line([[10, top + 12], [10, top + 12 + row * 0.4]], palette.ink, 1, 1);
          });
        },
      },
    ],
    finding({columns}) {
      const {with_unit} = live;
      const [small, middle, large] = columns.moments;
      if (alike(small, middle) || alike(middle, large))
        return `Two moments are equal, ${with_unit(alike(small, middle) ? small : large, 'kg m²')} each. In the plane of their two axes every direction is as ` +
          'principal as any other, and those drawn are arbitrary.';
      const upright = ranks.findIndex((_, axis) => is_upright(columns, axis));
      const flat = Math.abs(large - small - middle) < 1e-9 * large ? ' Everything lies in one plane, so the largest is the sum of the other two.' : '';
      return `The axis towards you belongs to the ${ranks[upright]} moment. The middle one is ${with_unit(middle, 'kg m²')}, about ` +
        `${upright === 1 ? 'this axis' : 'an axis in the picture'}: chapter 8 will throw a body about it.${flat}`;
    },
  };
})();
