// How the turn of one step is drawn, and what there is to find.
(() => {
  const live = tumble_live, player = globalThis.tumble_player;
  const rules = ['first order', 'exponential'], sides = ['on the left, for the world’s ω', 'on the right, a mistake'];
  const half_angle = (cosine, sine) => {
    const angle = 2 * Math.atan2(sine, cosine);
    return angle < 0 ? angle + 2 * Math.PI : angle;
  };

  live.figures.turn_per_step = {
    title: 'How far does a step turn, and about which axis?',
    hint: 'Drag along the curve, or turn the globe.',
    knobs: {
      asked: {label: 'Turn asked for, *ωh*'},
      rule: {label: 'Rule', choices: rules},
      side: {label: 'The turn is multiplied', choices: sides},
    },
    card: {panel: 1},
    panels: [
      {
        label: 'Angle turned in one step against the angle asked for: the exponential as the diagonal, the first-order rule as a curve that bends over.',
        draw(picture, {columns, values}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'asked, *ωh*', unit: 'rad', least: 0, most: 6.3},
            {label: 'turned', unit: 'rad', least: 0, most: 6.3}, {equal: true});
          picture.plot = plot;
          plot.line([0, 6.3], [0, 6.3], palette.bodies[0]);
          plot.line([0, 6.3], [Math.PI, Math.PI], palette.ink, {width: 1, dash: [4, 4]});
          plot.note('half a turn', [0.1, Math.PI], palette.ink);
          const turned = columns['curve asked'].map((_, n) => half_angle(columns['curve cosine'][n], columns['curve sine'][n]));
          plot.line(columns['curve asked'], turned, palette.bodies[1]);
          plot.points([values.asked], [half_angle(columns.cosine[0], columns.sine[0])], palette.bodies[values.rule ? 0 : 1], 6);
          plot.guess('turn_per_step');
          plot.legend([['exponential', palette.bodies[0]], ['first order', palette.bodies[1]]]);
        },
        drag: (plot, at) => ({asked: plot.value_at(at)[0]}),
        key: ([right], {values}) => ({asked: values.asked + 0.1 * right}),
      },
      {
        label: 'A globe with the world’s axis and the places of the body’s nose after each step.',
        turns: true,
        view: {azimuth: 0.61, elevation: 0.35},
        draw(picture, {columns, values}) {
          const {painter, palette, size, view} = picture;
          const {right, up, back} = player.picture_axes(view);
          const scale = Math.min(size.width, size.height) * 0.36;
          const place = p => [size.width / 2 + scale * player.dot(p, right), size.height / 2 + 10 - scale * player.dot(p, up)];
          const rim = Array.from({length: 91}, (_, n) => {
            const angle = (n * Math.PI) / 45;
            return [size.width / 2 + scale * Math.cos(angle), size.height / 2 + 10 - scale * Math.sin(angle)];
          });
          painter.line(rim, palette.ink, 1, 0.8);
          const height = Math.sin(0.6), radius = Math.cos(0.6);
          const circle = Array.from({length: 91}, (_, n) => [radius * Math.cos((n * Math.PI) / 45), radius * Math.sin((n * Math.PI) / 45), height]);
          for (let n = 0; n < 90; ++n)
            painter.line([place(circle[n]), place(circle[n + 1])], palette.bodies[0], 1.5, player.dot(circle[n], back) < 0 ? 0.35 : 1);
          live.arrow(painter, place([0, 0, 0]), place([0, 0, 1.35]), palette.ink);
          painter.text('*ω*', place([0, 0, 1.35])[0] + 10, place([0, 0, 1.35])[1], 'left', palette.ink);
          const noses = Array.from(columns['nose x'], (x, n) => [x, columns['nose y'][n], columns['nose z'][n]]);
          const [[first_x, first_y]] = noses;
          noses.forEach((_, n) => { // where the exact turn takes the nose
            const [cosine, sine] = [Math.cos(n * values.asked), Math.sin(n * values.asked)];
            const there = [first_x * cosine - first_y * sine, first_x * sine + first_y * cosine, height];
            painter.disc(...place(there), 5.5, palette.bodies[0]);
            painter.disc(...place(there), 3.8, palette.paper);
          });
          noses.forEach((nose, n) => {
            const behind = player.dot(nose, back) < 0;
            if (n) painter.line([place(noses[n - 1]), place(nose)], palette.bodies[1], 1, behind ? 0.3 : 0.7);
            painter.disc(...place(nose), behind ? 1.8 : 3.2, palette.bodies[1]);
          });
          painter.text('start', place(noses[0])[0] + 8, place(noses[0])[1] - 10, 'left', palette.ink);
          painter.text('the nose after each step', 10, 10, 'left', palette.bodies[1]);
          painter.text('and where it should be', 10, 26, 'left', palette.bodies[0]);
        },
      },
    ],
    finding({columns, values}) {
      const {with_unit} = live;
      const turned = half_angle(columns.cosine[0], columns.sine[0]);
      const first = values.rule === 0
        ? `Asked for ${with_unit(values.asked, 'rad')}, the first-order rule turns by ${with_unit(turned, 'rad', 4)}, which is 2 atan(*ωh*/2): ` +
          `${with_unit((100 * turned) / values.asked, '%')} of it.`
        : `The exponential turns by the ${with_unit(values.asked, 'rad')} that it was asked for.`;
      const heights = columns['nose z'];
      const off = heights.reduce((most, z) => Math.max(most, Math.abs(z - heights[0])), 0);
      const second = values.side === 0
        ? ' With the turn multiplied on the left, the nose keeps its height.'
        : ` With the turn multiplied on the right, the nose strays from its height by up to ${live.shown(off)}: the body turns about its own axis.`;
      return first + second;
    },
  };
})();
