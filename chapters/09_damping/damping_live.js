// How damping is drawn, and what there is to find.
(() => {
  const live = tumble_live;
  const forms = ['exp(−*k h*)', '1 − *k h*', '1/(1 + *k h*)', 'the same part in every step'];

  live.figures.damping = {
    title: 'Which form turns the puck round, and which one speeds it up?',
    hint: 'Drag in the first picture to choose *k h* by the step.',
    knobs: {
      form: {label: 'What a step leaves', choices: forms},
      rate: {label: 'Damping rate *k*', log: true},
      h: {label: 'Time step *h*', log: true},
    },
    card: {panel: 1},
    panels: [
      {
        label: 'What a step leaves of a speed against k h: the exponential, the linear form and the fractional one, with the chosen point.',
        aspect: 1.25,
        draw(picture, {columns, values}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: '*k h*', unit: '', least: 0, most: 3},
            {label: 'part left', unit: '', least: -1.5, most: 1.05});
          picture.plot = plot;
          plot.line([0, 3], [0, 0], palette.ink, {width: 1});
          plot.line([0, 3], [-1, -1], palette.ink, {width: 1, dash: [4, 4]});
          ['exponential', 'linear', 'fractional'].forEach((name, n) => plot.line(columns['k h'], columns[name], palette.bodies[n]));
          const kh = values.rate * values.h, colour = palette.bodies[Math.min(3, values.form)];
          if (values.form === 3) plot.line([0, 3], [columns.fraction[0], columns.fraction[0]], colour);
          if (kh <= 3) plot.points([kh], columns.fraction, colour, 6);
          else plot.note(`*k h* = ${live.shown(kh)} →`, [3, Math.max(-1.35, Math.min(0.9, columns.fraction[0]))], colour, 'right');
          plot.guess('damping', 0.05); // the question's step
          plot.legend([...forms.slice(0, 3), ...(values.form === 3 ? ['the same part'] : [])].map((words, n) => [words, palette.bodies[n]]));
        },
        drag: (plot, at, {values}) => ({h: plot.value_at(at)[0] / values.rate}),
        key: ([right], {values}) => ({h: values.h * 1.1 ** right}),
      },
      {
        label: 'Velocity against time: the exact solution as a line, the steps as points.',
        aspect: 1.25,
        draw(picture, {columns}) {
          const {painter, palette, size} = picture;
          const far = columns.speed.reduce((most, value) => Math.max(most, Math.abs(value)), 1);
          const least = columns.speed.reduce((a, b) => Math.min(a, b), 0);
          const plot = new live.Plot(painter, palette, size, {label: 'time', unit: 's', least: 0, most: columns.time.at(-1)},
            {label: 'velocity', unit: 'm/s', least: least < 0 ? -Math.min(far, 4) * 1.05 : 0, most: Math.min(far, 4) * 1.05});
          picture.plot = plot;
          plot.line(columns['exact time'], columns['exact speed'], palette.bodies[0]);
          plot.line(columns.time, columns.speed, palette.bodies[1], {width: 1, opacity: 0.6});
          plot.points(columns.time, columns.speed, palette.bodies[1], 3);
          plot.legend([['exact', palette.bodies[0]], ['stepped', palette.bodies[1]]]);
        },
      },
    ],
    finding({columns, values}) {
      const {shown} = live;
      const kh = values.rate * values.h, [left] = columns.fraction, [exact] = columns['exact fraction'];
      const start = `With *k h* = ${shown(kh)} a step leaves ${shown(left, 4)} of the speed, and ${shown(exact, 4)} would be right. `;
      if (values.form === 0) return `${start}The exponential is right whatever the step.`;
      if (values.form === 3)
        return `${start}The part was tuned for 60 steps a second; with another step the same number means another rate, ${shown(-Math.log(left) / values.h)} 1/s.`;
      if (left < -1) return `${start}The speed turns round in every step, and grows.`;
      if (left < 0) return `${start}The speed turns round in every step.`;
      return `${start}It never turns round, but it keeps too ${left < exact ? 'little' : 'much'} of its speed.`;
    },
  };
})();
