// How the weight on a spring is drawn, and what there is to find.
(() => {
  const live = tumble_live;
  /** Until the page's first question is answered there are only the circle and the start. */
  const is_open = () => live.answered('two_lines');
  const rules = ['explicit Euler', 'kick, then drift', 'implicit Euler'];
  const colours = [1, 0, 3]; // as in the chapter's other figures

  const largest = list => list.reduce((most, value) => (Number.isFinite(value) ? Math.max(most, Math.abs(value)) : most), 0);
  /** The radius of the circle, and something where there is none. */
  const circle = columns => Math.max(0.5, largest(columns['exact velocity']));
  const farthest = 4; // circles; what runs away is followed so far
  /** The step to which both pictures go: the last, or the one after which the weight has left. */
  const last_step = columns => {
    const left = columns.velocity.findIndex((v, n) => !(Math.hypot(v, columns['scaled place'][n]) < farthest * circle(columns)));
    return left < 0 ? columns.time.length - 1 : Math.max(5, left);
  };

  live.figures.phase_portrait = {
    title: 'Where does each rule lead the weight?',
    hint: 'Drag in the plane to start the weight elsewhere.',
    knobs: {
      rule: {label: 'Rule', choices: rules},
      h: {label: 'Time step *h*', log: true},
      w: {label: 'Angular frequency *ω*'},
      x: {label: 'Initial position'},
      v: {label: 'Initial velocity'},
    },
    duration: ({columns}) => columns.time[last_step(columns)],
    speed: ({columns}) => columns.time[last_step(columns)] / Math.max(4, last_step(columns) / 16),
    still_time: 7,
    card: {is_told: true}, // whose sentence tells it as well
    panels: [
      {
        label: 'Velocity v against ωx: the exact circle, the curve that the rule keeps if it keeps one, and the stepped weight.',
        draw(picture, {columns, values, time}) {
          const {painter, palette, size} = picture;
          const round = circle(columns);
          const drawn = is_open() ? ['scaled place', 'velocity', 'curve scaled place', 'curve velocity'] : [];
          const reach = 1.15 * Math.min(farthest * round, Math.max(round, ...drawn.map(name => largest(columns[name]))));
          const plot = new live.Plot(painter, palette, size, {label: '*ωx*', unit: 'm/s', least: -reach, most: reach},
            {label: '*v*', unit: 'm/s', least: -reach, most: reach}, {equal: true});
          picture.plot = plot;
          const colour = palette.bodies[colours[values.rule]];
          plot.line(columns['exact scaled place'], columns['exact velocity'], palette.ink, {dash: [2, 3]});
          if (is_open()) plot.line(columns['curve scaled place'], columns['curve velocity'], colour, {dash: [6, 4]});
          const shown = is_open() ? Math.floor(time / values.h + 1e-9) + 1 : 1;
          const [x, v] = [columns['scaled place'].subarray(0, shown), columns.velocity.subarray(0, shown)];
          plot.line(x, v, colour, {width: 1, opacity: 0.6});
          plot.points(x, v, colour);
          plot.points([x.at(-1)], [v.at(-1)], colour, 6);
          const curve = is_open() && columns['curve velocity'].some(Number.isFinite) ? [['its curve', colour, [6, 4]]] : [];
          plot.legend([['exact', palette.ink, [2, 3]], [rules[values.rule], colour], ...curve]);
        },
        drag(plot, at, {values}) {
          const [scaled, v] = plot.value_at(at);
          return {x: scaled / values.w, v};
        },
        key: ([right, up], {values}) => ({x: values.x + 0.1 * right, v: values.v + 0.1 * up}),
      },
      {
        label: 'Energy, relative to its initial value, against the number of steps, on a logarithmic axis.',
        draw(picture, {columns, values, time}) {
          const {painter, palette, size} = picture;
          const last = is_open() ? last_step(columns) : columns.time.length - 1;
          const energies = columns.energy.subarray(0, is_open() ? last + 1 : 1), steps = energies.map((_, n) => n);
          const inside = energies.filter(energy => energy > 1e-12 && energy < 1e12);
          const least = inside.reduce((a, b) => Math.min(a, b), 0.1), most = inside.reduce((a, b) => Math.max(a, b), 10);
          const plot = new live.Plot(painter, palette, size, {label: 'steps', unit: '', least: 0, most: last},
            {label: 'energy', unit: 'relative', least: 10 ** Math.floor(Math.log10(least)), most: 10 ** Math.ceil(Math.log10(most)), log: true});
          picture.plot = plot;
          const colour = palette.bodies[colours[values.rule]];
          plot.line([0, last], [1, 1], palette.ink, {dash: [2, 3]});
          if (!is_open()) return plot.ask();
          plot.line(steps, energies, colour);
          const now = Math.min(last, Math.floor(time / values.h + 1e-9));
          plot.points([now], [energies[now]], colour, 5);
          plot.legend([['exact', palette.ink, [2, 3]], [rules[values.rule], colour]]);
        },
      },
    ],
    finding({columns, values}) {
      const {shown} = live;
      if (!is_open()) return 'Say first with which order the weight swings farther every time, and the steps are drawn.';
      const wh = values.w * values.h, energies = columns.energy;
      if (energies[0] === 0 || (values.x === 0 && values.v === 0)) return 'A weight at rest where the spring is slack stays at rest under every rule.';
      const start = `With *ωh* = ${shown(wh)}`;
      if (values.rule === 0)
        return `${start} it spirals out: each step multiplies the energy by 1 + ${shown(energies[1] / energies[0] - 1)}, which is 1 + (*ωh*)².`;
      if (values.rule === 2)
        return `${start} it spirals in: each step divides the energy by 1 + ${shown(energies[0] / energies[1] - 1)}, which is 1 + (*ωh*)².`;
      const most = energies.reduce((a, b) => Math.max(a, b)), least = energies.reduce((a, b) => Math.min(a, b));
      if (wh < 2)
        return `${start} it stays on an ellipse: in 240 steps the energy varies between ${shown(least)} and ${shown(most)} of its initial value and always comes back.`;
      if (wh === 2) return `${start} it is at the limit: the ellipse has become a pair of lines.`;
      return `${start}, which is beyond 2, there is no ellipse left: after 240 steps the energy is ${shown(energies.at(-1))} times its initial value.`;
    },
  };
})();
