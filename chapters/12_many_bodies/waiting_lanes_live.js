// How the lanes of packs are drawn that wait for each other, and what there is to find.
(() => {
  const live = tumble_live;
  const widths = [1, 2, 4, 8, 16];
  const across = 16; // balls in a row of the picture
  const orders = ['as they come', 'sorted by height', 'all from one height'];
  const sum = numbers => numbers.reduce((a, b) => a + b, 0);

  /** What all steps of all balls cost with packs of each width, in units of the rest of a ball's step. */
  function costs({columns, values}) {
    const balls = columns.touching.length / columns.time.length, steps = columns.time.length;
    const {branch} = values;
    return widths.map((width, n) => ({
      width,
      both: steps * balls / width * (1 + branch),
      skipping: steps * balls / width + columns['packs of each width'][n] * branch,
    }));
  }
  const step_at = ({columns, time}) => Math.min(columns.time.length - 1, Math.round(time / (columns.time[1] - columns.time[0])));

  function draw_lanes(picture, state) {
    const {painter, palette, size} = picture;
    const {columns, values} = state;
    const width = widths[values.width], n = step_at(state);
    const balls = columns.touching.length / columns.time.length;
    const rows = balls / across, cell = Math.min((size.width - 20) / across, (size.height - 66) / rows);
    const [left, top] = [(size.width - across * cell) / 2, 26];
    painter.text('each square is a ball in its lane', 10, 12, 'left', palette.ink);
    for (let first = 0; first < balls; first += width) {
      const lanes = columns.touching.slice(n * balls + first, n * balls + first + width);
      const works = lanes.some(touches => touches > 0);
      lanes.forEach((touches, lane) => {
        const ball = first + lane;
        const x = left + (ball % across) * cell, y = top + Math.floor(ball / across) * cell;
        const [right, bottom] = [x + cell - (lane === width - 1 ? 4 : 1), y + cell - 3];
        const corners = [[x, y], [right, y], [right, bottom], [x, bottom]];
        if (touches) painter.polygon(corners, palette.bodies[1]);
        else if (works) painter.polygon(corners, palette.bodies[0]);
        else painter.line([...corners, corners[0]], palette.ink, 1, 0.5);
      });
    }
    const below = top + rows * cell + 12;
    painter.text('on the ground', left, below, 'left', palette.bodies[1]);
    painter.text('waits', size.width / 2, below, 'center', palette.bodies[0]);
    painter.text('no lane needs it', left + across * cell, below, 'right', palette.ink);
  }

  function draw_packs(picture, state) {
    const {painter, palette, size} = picture;
    const {columns, values} = state;
    const balls = columns.touching.length / columns.time.length, packs = balls / widths[values.width];
    const percent = (numbers, whole) => Array.from(numbers, number => (100 * number) / whole);
    const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 2},
      {label: 'in the branch', unit: '%', least: 0, most: 100});
    picture.plot = plot;
    plot.line(columns.time, percent(columns.packs, packs), palette.bodies[0]);
    plot.line(columns.time, percent(columns['on the ground'], balls), palette.bodies[1]);
    const n = step_at(state);
    plot.points([columns.time[n]], [(100 * columns.packs[n]) / packs], palette.bodies[0], 4);
    plot.legend([...(values.width > 0 ? [['packs', palette.bodies[0]]] : []), ['balls', palette.bodies[1]]]);
  }

  function draw_gain(picture, state) {
    const {painter, palette, size} = picture;
    const all = costs(state), alone = all[0].skipping;
    const plot = new live.Plot(painter, palette, size, {label: 'bodies in a pack', unit: '', least: 0, most: 16},
      {label: 'times as fast', unit: '', least: 0, most: 16});
    picture.plot = plot;
    plot.line(widths, widths, palette.ink, {width: 1, dash: [5, 4]});
    plot.line(widths, all.map(({skipping}) => alone / skipping), palette.bodies[2]);
    plot.line(widths, all.map(({both}) => alone / both), palette.bodies[3]);
    const shown = all[state.values.width];
    plot.points([shown.width, shown.width], [alone / shown.skipping, alone / shown.both], palette.ink, 4);
    plot.note('no branch', [10.5, 11.5], palette.ink, 'right');
    plot.note('skipping', [14, alone / all.at(-1).skipping], palette.bodies[2], 'right');
    plot.note('both branches', [16, 0.4], palette.bodies[3], 'right');
  }

  live.figures.waiting_lanes = {
    title: 'In a pack, all lanes wait for one',
    knobs: {
      width: {label: 'Bodies in a pack', choices: widths.map(String)},
      order: {label: 'Order of the balls', choices: orders},
      ground: {label: 'Stiffness of the ground (*ω*)'},
      branch: {label: 'Cost of the branch, the rest = 1', log: true},
    },
    duration: ({columns}) => columns.time.at(-1),
    still_time: 0.5,
    panels: [
      {label: 'The lanes of all packs at this moment: on the ground, waiting for a neighbour, or in a pack with none on the ground.', aspect: 1.25,
        draw: draw_lanes},
      {label: 'The share of balls on the ground against time, and that of packs that hold one of them.', aspect: 1.25, draw: draw_packs},
      {label: 'How many times as fast as one by one packs of each width are.', aspect: 1.25, draw: draw_gain},
    ],
    finding(state) {
      const {columns, values} = state;
      const {shown} = live;
      const width = widths[values.width], steps = columns.time.length, balls = columns.touching.length / steps;
      const on_ground = 100 * sum(columns['on the ground']) / (steps * balls);
      const packs = 100 * sum(columns.packs) / (steps * balls / width);
      const all = costs(state), alone = all[0].skipping, own = all[values.width];
      const start = `A ball is on the ground for ${shown(on_ground, 2)} % of the time. `;
      if (width === 1) return `${start}One by one, only the balls on the ground take the branch.`;
      return `${start}Of the packs of ${width}, ${shown(packs, 2)} % hold at least one such ball. If the branch is skipped where no lane needs it, they are ` +
        `${shown(alone / own.skipping, 2)} times as fast as one by one; with both branches always, ${shown(alone / own.both, 2)} times.`;
    },
  };
})();
