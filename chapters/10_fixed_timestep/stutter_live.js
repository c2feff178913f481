// How a ball is drawn in two ways, slowly, and what there is to find.
(() => {
  const live = tumble_live;
  /** Until the page's question is answered there are two balls without a scale. */
  const is_open = () => live.answered('stutter');
  const most = 95; // cm of track

  /** How many of the frames have been drawn. */
  const drawn = ({columns, time}) => Math.max(1, columns['shown at'].findLastIndex(moment => moment <= time + 1e-9) + 1);
  const moves = list => Array.from(list.subarray(1), (place, n) => place - list[n]);

  live.figures.stutter = {
    title: 'Which of the two balls stutters?',
    knobs: {
      rate: {label: 'Steps of the world', words: value => `${Math.floor(value)} a second`},
      frames: {label: 'Frames of the screen', words: value => `${Math.floor(value)} a second`},
      slower: {label: 'Slow motion', log: true, words: value => `${live.shown(value, 2)} times slower`},
    },
    duration: ({columns}) => columns['shown at'].at(-1),
    clock: ({time, values}) => `${Math.round((1000 * time) / values.slower)} ms`,
    still_time: 4,
    panels: [
      {
        label: 'Two balls that roll to the right on two tracks: A, drawn at its last state, above B, drawn between its last two.',
        aspect: 1.6,
        draw(picture, state) {
          const {painter, palette, size} = picture, {columns} = state;
          const left = 30, wide = size.width - 2 * left, radius = Math.min(22, size.height / 10), count = drawn(state);
          [['last state', 'A', 0.38], ['between two', 'B', 0.82]].forEach(([name, letter, down], n) => {
            const ground = down * size.height, colour = palette.bodies[n ? 0 : 1];
            const place = column => left + (column / most) * wide;
            painter.line([[left - radius, ground + 1], [size.width - 6, ground + 1]], palette.ink, 1.5, 1);
            painter.text(is_open() ? `${letter}: ${n ? 'between two states' : 'at its last state'}` : letter, 8, ground - 2 * radius - 16, 'left', palette.ink);
            if (is_open())
              for (const old of columns[name].subarray(0, count)) painter.line([[place(old), ground + 4], [place(old), ground + 12]], colour, 1.5, 1);
            const x = place(columns[name][count - 1]), y = ground - radius, turn = ((x - left) / radius);
            painter.disc(x, y, radius, colour);
            const [across, along] = [0.8 * radius * Math.cos(turn), 0.8 * radius * Math.sin(turn)];
            painter.line([[x - across, y - along], [x + across, y + along]], palette.ink, 2.5, 1);
          });
        },
      },
      {
        label: 'Position of both balls against time: the frames drawn so far.',
        aspect: 1.6,
        draw(picture, state) {
          const {painter, palette, size} = picture, {columns} = state;
          const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: 0.25}, {label: 'position', unit: 'cm', least: 0, most});
          picture.plot = plot;
          if (!is_open()) return plot.ask();
          const count = drawn(state);
          ['last state', 'between two'].forEach((name, n) => {
            const colour = palette.bodies[n ? 0 : 1];
            const [time, place] = [columns.time.subarray(0, count), columns[name].subarray(0, count)];
            plot.line(time, place, colour, {width: 1, opacity: 0.6});
            plot.points(time, place, colour, 3);
          });
          plot.legend([['A', palette.bodies[1]], ['B', palette.bodies[0]]]);
        },
      },
    ],
    finding({columns, values}) {
      const {shown, with_unit} = live;
      const start = `A step lasts ${with_unit(1000 / Math.floor(values.rate), 'ms')} and a frame ${with_unit(1000 / Math.floor(values.frames), 'ms')}`;
      if (!is_open()) return `${start}. Say first how far the ball that stutters leaps.`;
      const [leaps, even] = [moves(columns['last state']), moves(columns['between two'])];
      const [least, most_moved] = [Math.min(...leaps), Math.max(...leaps)];
      const a = most_moved - least < 0.01 ? `moves ${with_unit(most_moved, 'cm')} in every frame`
        : `moves ${with_unit(least < 1e-6 ? 0 : least, 'cm')} in one frame and ${with_unit(most_moved, 'cm')} in another`;
      const beats = Math.floor(values.rate) === Math.floor(values.frames) && most_moved - least >= 0.01
        ? ' Both last equally long, but a frame is measured in whole nanoseconds and comes out a little shorter than a step: now and then one has no step, and a later one has two.' : '';
      return `${start}.${beats} Drawn at its last state the ball ${a}; drawn between two, and so one step late, it moves ${shown(Math.max(...even))} cm in every frame.`;
    },
  };
})();
