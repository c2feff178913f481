// How the gyroscope is drawn, and what there is to find.
(() => {
  const live = tumble_live, player = globalThis.tumble_player;
  const rules = ['steady: no gyroscopic term', 'explicit', 'explicit, |L| restored', 'implicit, one Newton step', 'momentum-carrying',
    'splitting by axes', 'splitting with a sphere'];
  const point = (columns, name, n) => ['x', 'y', 'z'].map(letter => columns[`${name} ${letter}`][n]);
  const step_at = ({columns, time}) => Math.max(0, Math.min(columns.time.length - 1, Math.floor(time / (columns.time[1] ?? 1) + 1e-9)));
  const tilt_of = z => Math.acos(Math.max(-1, Math.min(1, z)));

  // The wheel 4 cm above the tip, drawn in units of 2.5 cm.
  const parts = [{cylinder: [1.2, 0.4], position: [0, 0, 1.6]}, {cylinder: [0.07, 2.6], position: [0, 0, 1.3]}];
  const stand = [{cone: [0.5, 1.6], position: [0, 0, -1.6]}];

  /** How far the axis has gone round, in rad, turn after turn. */
  function azimuths(columns, name) {
    let last = 0, turns = 0;
    return Array.from(columns[`${name} x`], (x, n) => {
      const now = Math.atan2(x, -columns[`${name} y`][n]);
      if (n > 0 && Math.abs(now - last) > Math.PI) turns += now < last ? 1 : -1;
      last = now;
      return now + 2 * Math.PI * turns;
    });
  }

  function draw_top(picture, state) {
    const {painter, palette, size, view} = picture;
    const {columns} = state;
    const n = step_at(state);
    const camera = {target: [0, 0, 0.8], distance: 11.5, ...view};
    // What the tip stands on; a top that gets below level would run into it, and hangs in the air.
    const stays_above = live.once(columns, 'stays above', () => Array.from(columns['axis z']).every(z => z > 0));
    if (stays_above) live.draw_body({...picture, palette: {...palette, bodies: [palette.bodies[1]]}}, camera, 'stand', stand, [1, 0, 0, 0]);
    live.draw_body(picture, camera, 'heavy top', parts, [columns['q real'][n], ...point(columns, 'q', n)]);
    const project = player.projection(camera, size);
    const path = Array.from({length: n + 1}, (_, m) => project(player.scaled(point(columns, 'axis', m), 2.7)));
    painter.line(path, palette.bodies[1], 1.2, 0.9);
    painter.disc(...project([0, 0, 0]).slice(0, 2), 3, palette.ink);
  }

  live.figures.heavy_top = {
    title: 'A spinning top goes round at its own rate, nods, and stands if it spins fast enough',
    hint: 'Drag the top to see it from elsewhere; by keys, with the arrows. It is the toy of this page.',
    knobs: {
      spin: {label: 'Spin'},
      tilt: {label: 'Tilt at which it is let go'},
      rule: {label: 'Rule', choices: rules},
      h: {label: 'Time step *h*', log: true},
    },
    duration: () => 2,
    still_time: 1,
    panels: [
      {label: 'The gyroscope on its tip, with the path of the end of its axis.', turns: true, view: {azimuth: 0.25, elevation: 0.3}, draw: draw_top},
      {
        label: 'Tilt of the axis against the angle by which it has gone round, stepped and in very fine steps.',
        draw(picture, state) {
          const {painter, palette, size} = picture;
          const {columns} = state;
          const [round, fine_round, tilts, fine_tilts] = live.once(columns, 'path', () =>
            [azimuths(columns, 'axis'), azimuths(columns, 'fine'), Array.from(columns['axis z'], tilt_of), Array.from(columns['fine z'], tilt_of)]);
          const x = live.range_of([fine_round], {smallest: 1}), y = live.range_of([fine_tilts, tilts], {smallest: 0.3});
          // Tilt grows downwards, as the top sinks.
          const plot = new live.Plot(painter, palette, size, {label: 'gone round', unit: 'rad', ...x},
            {label: 'tilt', unit: 'rad', least: y.most, most: Math.max(0, y.least)});
          picture.plot = plot;
          plot.line(fine_round, fine_tilts, palette.bodies[0]);
          const n = step_at(state);
          plot.line(round.slice(0, n + 1), tilts.slice(0, n + 1), palette.bodies[1], {width: 1.5});
          plot.points([round[n]], [tilts[n]], palette.bodies[1], 5);
          plot.legend([['very fine steps', palette.bodies[0]], ['stepped', palette.bodies[1]]]);
        },
      },
    ],
    finding({columns, values}) {
      const {with_unit} = live;
      const last = columns.time.length - 1, seconds = columns.time[last];
      if (seconds < 1.9) return `After ${with_unit(seconds, 's')} the top has left the range of numbers: this rule lets it explode.`;
      const tilts = columns['axis z'].map(tilt_of);
      const most = tilts.reduce((a, b) => Math.max(a, b));
      const rate = azimuths(columns, 'axis')[last] / seconds;
      const [sleeps] = columns.sleeps, [slow] = columns.slow, lowest = tilt_of(columns['lowest cosine'][0]);
      const round = Number.isFinite(slow) ? `It goes round at ${with_unit(rate, 'rad/s')} on average, and a steady precession would be at ${with_unit(slow, 'rad/s')}. `
        : 'It is too slow for its axis to go round steadily. ';
      const sinks = `It sinks to ${with_unit(most, 'rad')}; on paper it would sink to ${with_unit(lowest, 'rad')}.`;
      const upright = values.tilt < 0.1
        ? ` On paper it stands upright from ${with_unit(sleeps, 'rad/s')} on, so this one ${Math.abs(values.spin) >= sleeps ? 'sleeps' : 'falls'}.` : '';
      return round + sinks + upright;
    },
  };
})();
