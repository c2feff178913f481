// How frames are drawn that one makes slow by hand, and what there is to find.
(() => {
  const live = tumble_live;

  function bars(plot, costs, colour) {
    costs.forEach((cost, n) => {
      const [left, top] = plot.place([n / 4 + 0.02, cost]), [right, bottom] = plot.place([n / 4 + 0.23, 0]);
      plot.painter.polygon([[left, top], [right, top], [right, bottom], [left, bottom]], colour);
    });
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
    panels: [
      {
        label: 'What a step costs against time, as bars that you draw by hand, and the time that it simulates as a line.',
        aspect: 1.25,
        draw(picture, {columns, figure}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 10},
            {label: 'cost of a step', unit: 'ms', least: 0, most: 60});
          picture.plot = plot;
          bars(plot, columns.cost, palette.bodies[1]);
          plot.line([0, 10], [1000 / 60, 1000 / 60], palette.ink, {width: 1.5, dash: [5, 4]});
          plot.note('what it simulates', [10, 1000 / 60], palette.ink, 'right');
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
        draw(picture, {columns}) {
          const {painter, palette, size} = picture;
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
        },
      },
      {
        label: 'Simulated time against real time, beside the diagonal on which it would keep up.',
        aspect: 1.25,
        draw(picture, {columns}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 10},
            {label: 'simulated', unit: 's', least: 0, most: 10});
          picture.plot = plot;
          plot.line([0, 10], [0, 10], palette.bodies[0], {dash: [5, 4]});
          plot.line(columns.time, columns.simulated, palette.bodies[1]);
          plot.line(columns.time, columns.dropped, palette.bodies[2]);
          plot.legend([['simulated', palette.bodies[1]], ['dropped', palette.bodies[2]]]);
        },
      },
    ],
    finding({columns}) {
      const {with_unit} = live;
      const longest = columns.frame.reduce((a, b) => Math.max(a, b)), last = columns.frame.length - 1;
      const dropped = columns.dropped[last];
      const screen = longest < 1000 ? with_unit(longest, 'ms') : with_unit(longest / 1000, 's');
      return `The longest of ${columns.frame.length} frames takes ${screen}. ` + (dropped > 0
        ? `The caps dropped ${with_unit(dropped, 's')}, counted to the nanosecond: the world is late by as much.`
        : `Nothing was dropped; at the end ${with_unit(columns.simulated[last], 's')} have been simulated.`);
    },
  };
})();
