// How the ellipsoid rolls, its tracks on either side, and what there is to find.
(() => {
  const live = tumble_live, player = globalThis.tumble_player;
  const scale = 0.16; // of the picture, for 1 rad/s
  const point = (columns, name, n) => ['x', 'y', 'z'].map(letter => columns[`${name} ${letter}`][n]);
  const step_at = ({columns, time}) => Math.max(0, Math.min(columns.time.length - 1, Math.floor(time / columns.time[1] + 1e-9)));
  const circle = radius => Array.from({length: 91}, (_, n) => [radius * Math.cos((n * Math.PI) / 45), radius * Math.sin((n * Math.PI) / 45)]);

  function draw_rolling(picture, state) {
    const {painter, palette, size, view} = picture;
    const {columns, values} = state;
    const n = step_at(state);
    const camera = {target: [0, 0, -0.25], distance: 8.6, ...view};
    const project = player.projection(camera, size);
    const place = at => project(player.scaled(at, scale));
    const orientation = [columns['q real'][n], ...point(columns, 'q', n)];

    function draw_plane() {
      const reach = 1.25 * columns.circles[1], floor = -values.height;
      const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]].map(([x, y]) => place([reach * x, reach * y, floor]));
      painter.line(corners, palette.ink, 1, 0.6);
      for (const radius of columns.circles)
        painter.line(circle(radius).map(([x, y]) => place([x, y, floor])), palette.ink, 1, 0.6, [4, 4]);
      painter.line(Array.from({length: n + 1}, (_, m) => place(point(columns, 'world', m))), palette.bodies[1], 1.5, 1);
    }

    /** The polhode lies on the ellipsoid and turns with it: faint where the ellipsoid hides it. */
    function draw_polhode() {
      const matrix = player.matrix_of(orientation);
      const {back} = player.picture_axes(view);
      const eye = player.sum(camera.target, player.scaled(back, camera.distance));
      let part = [], was;
      const end = () => {
        if (part.length < 2) return;
        if (was) painter.line(part, palette.paper, 5, 0.8); // a light border, as green on blue is hard to see
        painter.line(part, palette.bodies[2], 2, was ? 1 : 0.25);
      };
      for (let m = 0; m <= n; ++m) {
        const at = point(columns, 'body', m), outwards = at.map((value, k) => value / columns['semi-axes'][k] ** 2);
        const there = player.scaled(player.turned(matrix, at), scale);
        const is_near = player.dot(player.turned(matrix, outwards), player.difference(eye, there)) > 0;
        const now = project(there);
        if (is_near !== was) {
          if (part.length) part.push(now);
          end();
          [part, was] = [[], is_near];
        }
        part.push(now);
      }
      end();
    }

    const is_below = view.elevation < 0;
    if (!is_below) draw_plane();
    const parts = live.once(columns, 'ellipsoid', () => [{ellipsoid: Array.from(columns['semi-axes'], axis => axis * scale)}]);
    live.draw_body(picture, camera, 'ellipsoid', parts, orientation);
    draw_polhode();
    if (is_below) draw_plane();
    const contact = place(point(columns, 'world', n)), centre = place([0, 0, 0]);
    live.arrow(painter, centre, contact, palette.ink, 2);
    painter.text('*ω*', contact[0] + 9, contact[1] + 9, 'left', palette.ink);
    painter.disc(...contact.slice(0, 2), 4, palette.bodies[1]);
    painter.text('polhode', 10, 12, 'left', palette.bodies[2]);
    painter.text('herpolhode', 10, 28, 'left', palette.bodies[1]);
  }

  function draw_herpolhode(picture, state) {
    const {painter, palette, size} = picture;
    const {columns} = state;
    const n = step_at(state), reach = 1.1 * columns.circles[1];
    const plot = new live.Plot(painter, palette, size, {label: '*ω* in the plane', unit: 'rad/s', least: -reach, most: reach},
      {label: 'perpendicular to that', unit: 'rad/s', least: -reach, most: reach}, {equal: true});
    picture.plot = plot;
    for (const radius of columns.circles) {
      const rim = circle(radius);
      plot.line(rim.map(([x]) => x), rim.map(([, y]) => y), palette.ink, {width: 1, dash: [4, 4]});
    }
    plot.line(columns['world x'].slice(0, n + 1), columns['world y'].slice(0, n + 1), palette.bodies[1], {width: 1.5});
    plot.points([0], [0], palette.ink, 3);
    plot.points([columns['world x'][n]], [columns['world y'][n]], palette.bodies[1], 5);
  }

  live.figures.poinsot = {
    title: 'A free body moves as its ellipsoid rolls on a plane',
    hint: 'Drag the ellipsoid to see it from elsewhere; by keys, with the arrows.',
    knobs: {
      height: {label: 'Distance of the plane, 2*E*/|*L*|'},
      middle: {label: 'Middle moment'},
    },
    duration: () => 12,
    still_time: 4,
    panels: [
      {label: 'The ellipsoid on its plane, with the track of the contact on either.', turns: true, view: {azimuth: 0.5, elevation: -0.45}, draw: draw_rolling},
      {label: 'The plane seen from above, with the herpolhode between its two circles.', draw: draw_herpolhode},
    ],
    finding({columns, values}) {
      const {with_unit} = live;
      const xs = columns['world x'], ys = columns['world y'];
      const radii = Array.from(xs, (x, n) => Math.hypot(x, ys[n]));
      const least = radii.reduce((a, b) => Math.min(a, b)), most = radii.reduce((a, b) => Math.max(a, b));
      const off = columns['world z'].reduce((a, z) => Math.max(a, Math.abs(z + values.height)), 0);
      const middle = Array.from(columns['semi-axes']).sort((a, b) => a - b)[1];
      return `The plane lies ${values.height > middle ? 'beyond' : 'within'} the middle semi-axis, ${with_unit(middle, 'rad/s')}, so the polhode goes ` +
        `round axis ${values.height > middle ? 1 : 3}. In 12 s the contact comes as near to the foot as ${with_unit(least, 'rad/s')} and as far as ` +
        `${with_unit(most, 'rad/s')}; the circles’ radii are ${with_unit(columns.circles[0], 'rad/s')} and ${with_unit(columns.circles[1], 'rad/s')}. ` +
        `The contact leaves the plane by ${with_unit(off, 'rad/s', 2)} at most, which is the error of the steps.`;
    },
  };
})();
