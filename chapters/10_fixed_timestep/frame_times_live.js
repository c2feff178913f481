// How frames are drawn that one makes slow by hand, and what there is to find.
(() => {
  const live = tumble_live;

  function bars(plot, costs, colour) {
    costs.forEach((cost, n) => {
      const [left, top] = plot.place([n / 4 + 0.02, cost]), [right, bottom] = plot.place([n / 4 + 0.23, 0]);
      plot.painter.polygon([[left, top], [right, top], [right, bottom], [left, bottom]], colour);
    });
  }

  /** The frame that is on the screen. */
  const frame_at = ({columns, time}) => Math.max(0, columns.time.findLastIndex(begin => begin <= time + 1e-9));

  /** Where in time that is. */
  function now(plot, {columns, ...state}) {
    const at = columns.time[frame_at({columns, ...state})], {least, most} = plot.y;
    plot.line([at, at], [least, most], plot.palette.bodies[0], {width: 1});
  }

  live.figures.frame_times = {
    title: 'What do slow steps do to the frames?',
    hint: 'Draw in the first picture how long a step takes to compute from moment to moment. By keys: left and right choose a ' +
      'quarter of a second, up and down change it.',
    knobs: {
      'most steps': {label: 'Most steps in a frame', log: true, whole: true, words: value => (value === 1000 ? 'no cap' : String(value))},
      'longest frame': {label: 'Longest frame that counts', log: true, words: value => (value === 5 ? 'no cap' : live.with_unit(value, 's'))},
      picture: {label: 'Time for the picture itself'},
    },
    duration: () => 10,
    still_time: 3.5,
    panels: [
      {
        label: 'What a step costs against time, as bars that you draw by hand, and the time that it simulates as a line.',
        aspect: 1.25,
        draw(picture, state) {
          const {painter, palette, size} = picture, {columns, figure} = state;
          const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 10},
            {label: 'cost of a step', unit: 'ms', least: 0, most: 60});
          picture.plot = plot;
          bars(plot, columns.cost, palette.bodies[1]);
          plot.line([0, 10], [1000 / 60, 1000 / 60], palette.ink, {width: 1.5, dash: [5, 4]});
          plot.note('what it simulates', [10, 1000 / 60], palette.ink, 'right');
          now(plot, state);
          if (figure.slot !== undefined) plot.points([figure.slot / 4 + 0.125], [columns.cost[figure.slot]], palette.bodies[0], 5);
        },
        drag(plot, at, {columns, figure}) {
          const [time, cost] = plot.value_at(at);
          figure.slot = Math.max(0, Math.min(39, Math.floor(4 * time)));
          const drawn = [...columns.cost];
          drawn[figure.slot] = Math.max(0, Math.min(60, Math.round(cost)));
          return {drawn};
        },
        key([right, up], {columns, figure}) {
          figure.slot = Math.max(0, Math.min(39, (figure.slot ?? 0) + right));
          const drawn = [...columns.cost];
          drawn[figure.slot] = Math.max(0, Math.min(60, drawn[figure.slot] + up));
          return {drawn};
        },
      },
      {
        label: 'Duration of each frame against time, on a logarithmic axis.',
        aspect: 1.25,
        draw(picture, state) {
          const {painter, palette, size} = picture, {columns} = state;
          const most = Math.max(1000, columns.frame.reduce((a, b) => Math.max(a, b)));
          const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 10},
            {label: 'frame', unit: 'ms', least: 10, most: 10 ** Math.ceil(Math.log10(most)), log: true});
          picture.plot = plot;
          const time = [], frame = [];
          columns.time.forEach((begin, n) => {
            time.push(begin, begin + columns.frame[n] / 1000);
            frame.push(columns.frame[n], columns.frame[n]);
          });
          plot.line(time, frame, palette.bodies[1]);
          now(plot, state);
        },
      },
      {
        label: 'The account of the frame: the time that is paid in, the whole steps that are cut out of it with the rest that waits, and the time that is dropped.',
        aspect: 1.25,
        draw(picture, state) {
          const {painter, palette, size} = picture, {columns} = state;
          const n = frame_at(state), step = 1000 / 60, [paid_in, taken_colour] = [palette.bodies[0], palette.bodies[2]];
          const [waited, paid, steps, waits, lost] = ['waited', 'paid in', 'steps', 'waits', 'lost'].map(name => columns[name][n]);
          const full = Math.max(100, ...columns['paid in'].map((time, k) => time + columns.waited[k]));
          const [top, bottom, wide] = [34, size.height - 46, size.width / 3];
          const height = ms => ((bottom - top) * ms) / full;
          /** A block of so many ms in a column, on what lies there; the column's height with it. */
          const block = (column, from, ms, colour, gap = 0) => {
            const [left, right] = [(column + 0.2) * wide, (column + 0.8) * wide], [low, high] = [bottom - height(from), bottom - height(from + ms) + gap];
            if (low - high > 0.3) painter.polygon([[left, low], [right, low], [right, high], [left, high]], colour);
            return from + ms;
          };
          painter.text(`frame ${n + 1}, at ${columns.time[n].toFixed(2)} s`, 8, 12, 'left', palette.ink);
          painter.line([[0.1 * wide, bottom], [2.9 * wide, bottom]], palette.ink, 1, 1);
          block(0, block(0, 0, waited, palette.grid), paid, paid_in);
          let level = 0;
          for (let k = 0; k < steps; ++k) level = block(1, level, step, taken_colour, Math.min(1.5, 0.3 * height(step)));
          block(1, level, waits, palette.grid);
          block(2, 0, lost, palette.bodies[1]);
          const say = (column, words, below, colour) => painter.text(words, (column + 0.5) * wide, bottom + 13 + 16 * below, 'center', colour);
          say(0, 'the frame took', 0, palette.ink);
          say(0, `${Math.round(paid)} ms`, 1, paid_in);
          say(1, steps === 1 ? '1 step' : `${steps} steps`, 0, palette.ink);
          say(1, `${waits.toFixed(1)} ms wait`, 1, palette.ink);
          say(2, 'dropped', 0, palette.ink);
          say(2, `${columns.dropped[n].toFixed(2)} s in all`, 1, palette.bodies[1]);
        },
      },
    ],
    finding({columns}) {
      const {with_unit} = live;
      const longest = columns.frame.reduce((a, b) => Math.max(a, b)), last = columns.frame.length - 1;
      const dropped = columns.dropped[last];
      const screen = longest < 1000 ? with_unit(longest, 'ms') : with_unit(longest / 1000, 's');
      return `The longest of ${columns.frame.length} frames takes ${screen}. ` + (dropped > 0
        ? `The caps dropped ${with_unit(dropped, 's')}, counted to the nanosecond: the world is late by that much.`
        : `Nothing was dropped; at the end ${with_unit(columns.simulated[last], 's')} have been simulated.`);
    },
  };
})();
