// How two turns are drawn, and what there is to find.
(() => {
  const live = tumble_live, player = globalThis.tumble_player;
  const degrees = 180 / Math.PI;
  const angle_of = (real, size) => 2 * Math.atan2(size, Math.abs(real)) * degrees;

  /** A brick with a peg, so that every orientation of it looks different. */
  const parts = [{box: [1.9, 1.1, 0.6]}, {box: [0.35, 0.35, 0.5], position: [0.65, 0.25, 0.5]}];

  /** How far the line from the centre along `way`, a unit vector of the brick's own axes, runs inside it, and the side where it leaves. */
  function way_out(way) {
    const distances = way.map((along, n) => parts[0].box[n] / 2 / Math.abs(along));
    const inside = Math.min(...distances), side = distances.indexOf(inside);
    return {inside, normal: way.map((along, n) => (n === side ? Math.sign(along) : 0))};
  }

  const draw_body = (name, words) => (picture, {columns}) => {
    const {painter, palette, size, view} = picture;
    const camera = {target: [0, 0, 0], distance: 6, ...view};
    const project = player.projection(camera, size), {back} = player.picture_axes(view);
    const [real, ...imaginary] = columns[name];
    const into_brick = player.matrix_of([real, ...imaginary.map(part => -part)]), out_of_it = player.matrix_of([real, ...imaginary]);
    // What leaves the brick on a side that one does not see is behind it; the rest begins on its surface.
    const axes = ['x', 'y', 'z'].map((letter, n) => {
      const axis = [0, 1, 2].map(k => (k === n ? 1 : 0));
      const {inside, normal} = way_out(player.turned(into_brick, axis));
      const is_seen = player.dot(player.turned(out_of_it, normal), back) > 0;
      const draw = () => {
        live.arrow(painter, project(player.scaled(axis, is_seen ? inside : 0)), project(player.scaled(axis, 1.4)), palette.ink, 1);
        const [x, y] = project(player.scaled(axis, 1.55));
        painter.text(`*${letter}*`, x, y, 'center', palette.ink);
      };
      return {is_seen, draw};
    });
    for (const {is_seen, draw} of axes) if (!is_seen) draw();
    live.draw_body(picture, camera, 'brick', parts, [real, ...imaginary]);
    for (const {is_seen, draw} of axes) if (is_seen) draw();
    painter.text(words, 10, size.height - 12, 'left', palette.ink);
  };

  live.figures.two_turns = {
    title: 'Two turns in two orders, and a turn of 720°',
    hint: 'Drag a body to see it from elsewhere, or the point along the curves; by keys, with the arrows.',
    knobs: {
      first: {label: 'Turn about the world’s *x*'},
      second: {label: 'Turn about the world’s *z*'},
      sign: {label: 'Quaternion of the first', choices: ['q', '−q']},
    },
    panels: [
      {label: 'A brick turned about x first, then about z.', turns: true, aspect: 1.3, view: {azimuth: 0.7, elevation: 0.5}, draw: draw_body('x then z', 'first about *x*, then about *z*')},
      {label: 'The same brick turned about z first, then about x.', turns: true, aspect: 1.3, view: {azimuth: 0.7, elevation: 0.5}, draw: draw_body('z then x', 'first about *z*, then about *x*')},
      {
        label: 'Real part and part along x of the first turn’s quaternion against its angle, to 720 degrees.',
        aspect: 1.5,
        draw(picture, {columns, values}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'turn about *x*', unit: '°', least: 0, most: 720},
            {label: 'component', unit: '', least: -1.1, most: 1.1});
          picture.plot = plot;
          plot.line(columns.angle, columns.real, palette.bodies[0]);
          plot.line(columns.angle, columns.along, palette.bodies[1]);
          plot.points([values.first, values.first], [columns.one[0], columns.one[1]], palette.ink, 5);
          plot.legend([['real', palette.bodies[0]], ['along *x*', palette.bodies[1]]]);
        },
        drag: (plot, at) => ({first: plot.value_at(at)[0]}),
        key: ([right], {values}) => ({first: values.first + 5 * right}),
      },
      {
        label: 'The angle between the two orders against the fraction of both turns that is made, beside the product of the two angles.',
        aspect: 1.5,
        draw(picture, {columns, values}) {
          const {painter, palette, size} = picture;
          const apart = columns.part.map((_, n) => angle_of(columns['apart real'][n], columns['apart size'][n]));
          const product = columns.part.map(part => (part * part * values.first * values.second) / degrees);
          const plot = new live.Plot(painter, palette, size, {label: 'fraction of both turns', unit: '', least: 0, most: 1},
            {label: 'apart', unit: '°', least: 0, most: 185});
          picture.plot = plot;
          plot.line(columns.part, product, palette.bodies[0], {dash: [6, 4]});
          plot.line(columns.part, apart, palette.bodies[1]);
          plot.points([1], [apart.at(-1)], palette.bodies[1], 5);
          plot.legend([['estimate', palette.bodies[0], [6, 4]], ['exact', palette.bodies[1]]]);
        },
      },
    ],
    finding({columns, values}) {
      const {shown} = live;
      const [real, ...imaginary] = columns.between;
      const apart = angle_of(real, Math.hypot(...imaginary));
      const product = (values.first * values.second) / degrees;
      const small = Math.max(values.first, values.second) <= 20
        ? ` The product of the two angles is ${shown(product)}° (in radians, ${shown(product / degrees)}).` : '';
      const q0 = columns.one[0];
      const sign = values.sign ? 'With −q both bricks are where they were: ' : '';
      const back = values.first >= 359 && values.first <= 361 ? ' After 360° about x the real part has the other sign; 720° bring it back.' : '';
      return `${sign ? `${sign}the` : 'The'} two orders end ${apart < 1e-6 ? 0 : shown(apart)}° apart.${small} The real part of the first quaternion is ${shown(q0)}.${back}`;
    },
  };
})();
