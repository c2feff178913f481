// A painter for SVG, and the still picture of a recording: a few moments side by side, for paper and without scripts.
(() => {
  const player = (globalThis.tumble_player ??= {});

  const css = colour => `#${colour.map(value => Math.round(value).toString(16).padStart(2, '0')).join('')}`;
    const listed = points => points.map(([x, y]) => `${Math.round(x)},${Math.round(y)}`).join(' ');

  // Whole numbers are short, so these are quarters of a pixel.
  const cell = {width: 600, height: 520};

  class SvgPainter {
    svg = '';

    constructor(palette) {
      // Lines follow the page's colours. Faces, each of a shade of its own, are those of paper, which is light.
      this.names = new Map([[palette.ink, 'var(--figure-frame)'], [palette.grid, 'var(--figure-grid)'],
        ...palette.bodies.map((colour, n) => [colour, `var(--figure-${n + 1})`])]);
    }

    polygon(points, colour) {
      this.svg += `<polygon points="${listed(points)}" fill="${css(colour)}" stroke="${css(colour)}"/>`;
    }

    disc(x, y, radius, colour) {
      this.svg += `<circle cx="${Math.round(x)}" cy="${Math.round(y)}" r="${4 * radius}" fill="${css(colour)}" stroke="none"/>`;
    }

    line(points, colour, width, opacity) {
      this.svg += `<polyline points="${listed(points)}" fill="none" stroke="${this.names.get(colour)}" ` +
        `stroke-width="${4 * width}" opacity="${opacity}"/>`;
    }

    shadow(polygons, colour) {
      const path = polygons.map(points => `M${listed(points)}z`).join('');
      if (path) this.svg += `<path d="${path}" fill="${css(colour)}" stroke="none" opacity="0.14"/>`;
    }
  }

  /** A still picture for each of the scenes that stand side by side. */
  function stills_of(scenes, palette) {
    const cameras = player.first_cameras(scenes, cell);
    return scenes.map((scene, n) => still_of(scene, cameras[n], palette));
  }

  /** A row of `count` pictures at equal intervals of time, each with its time below; `palette` as for Scene.draw(). */
  function still_of(scene, camera, palette, count = 6) {
    const {recording} = scene;
    const cells = Array.from({length: count}, (_, n) => {
      const time = (player.duration_of(recording) * n) / Math.max(1, count - 1);
      const painter = new SvgPainter(palette);
      scene.draw(painter, cell, camera, time, palette, {grid_pieces: 1, grid_reach: 0.8, has_scale: false});
      return `<svg x="${n * cell.width}" y="0" width="${cell.width}" height="${cell.height}"><g stroke-width="2">${painter.svg}</g></svg>` +
        `<text x="${(n + 0.5) * cell.width}" y="${cell.height + 64}" text-anchor="middle" font-size="60" ` +
        `fill="var(--figure-frame)">${Number(time.toPrecision(3))} s</text>`;
    });
    return `<svg class="player-still" viewBox="0 0 ${count * cell.width} ${cell.height + 96}">${cells.join('')}</svg>`;
  }

  Object.assign(player, {stills_of});
})();
