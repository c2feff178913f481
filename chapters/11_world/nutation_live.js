// The map of steps that let a tilt grow, and the path of the top's tip between the kicks.
(() => {
  const live = tumble_live;

  live.figures.nutation = {
    title: 'Where springs feed on a spin',
    hint: 'Drag in the map to choose a step.',
    knobs: {
      angle: {label: 'Nutation in a step *θ*'},
      kappa: {label: 'Stiffness *h*² *k*'},
      other: {label: 'In the other direction, times'},
      damping: {label: 'Damping *h c*'},
    },
    panels: [
      {
        label: 'Stiffness against the angle of the nutation in a step: bands in which a tilt grows, the curve below which the world promises that it does not, and the chosen step.',
        draw(picture, {columns, values}) {
          const {painter, palette, size} = picture;
          const plot = new live.Plot(painter, palette, size, {label: 'nutation in a step', unit: 'rad', least: 0, most: 13},
            {label: '*h*² *k*', unit: '', least: 0, most: 4.2});
          picture.plot = plot;
          plot.line(columns['band angle'], columns['band kappa'], palette.bodies[1], {width: plot.box.height / 42, opacity: 0.55});
          plot.line(columns['bound angle'], columns['bound kappa'], palette.bodies[0], {width: 2.5});
          plot.points([values.angle], [values.kappa], palette.ink, 6);
          plot.legend([['a tilt grows', palette.bodies[1]], ['promised up to here', palette.bodies[0]]]);
        },
        drag(plot, at) {
          const [angle, kappa] = plot.value_at(at);
          return {angle, kappa};
        },
        key: ([right, up], {values}) => ({angle: values.angle + 0.1 * right, kappa: values.kappa + 0.1 * up}),
      },
      {
        label: 'The path of the tip of the axis, seen from above, with a point wherever the springs kick it.',
        draw(picture, {columns}) {
          const {painter, palette, size} = picture;
          const reach = 1.15 * columns.x.reduce((most, x, n) => Math.max(most, Math.abs(x), Math.abs(columns.y[n])), 1);
          const plot = new live.Plot(painter, palette, size, {label: 'tilt', unit: 'of the first', least: -reach, most: reach},
            {label: 'tilt across', unit: '', least: -reach, most: reach}, {equal: true});
          picture.plot = plot;
          plot.line(columns.x, columns.y, palette.bodies[0], {width: 1, opacity: 0.7});
          plot.points(columns['kick x'], columns['kick y'], palette.bodies[1]);
        },
      },
    ],
    finding({columns, values}) {
      const {shown} = live;
      const degrees = shown(values.angle * 180 / Math.PI, 3);
      const bound = values.angle < Math.PI ? 2 * values.angle / Math.tan(values.angle / 2) - 2 * values.damping : 0;
      const step = `In a step of *h*² *k* = ${shown(values.kappa)} the nutation turns by ${degrees}°`;
      if (columns.grows[0] === 1) return `${step}: the springs feed on the spin, and a tilt grows.`;
      if (values.kappa < (values.angle === 0 ? 4 - 2 * values.damping : bound)) return `${step}: the world promises that no tilt grows.`;
      return `${step}: no tilt grows here, but nobody promises it.`;
    },
  };
})();
