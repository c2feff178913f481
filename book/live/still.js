// The still picture of a live figure, for paper, without scripts, and until the module is there: SVG that takes the page's
// colours.
(() => {
  const live = (globalThis.tumble_live ??= {figures: {}, modules: {}});

  const css = colour => `#${colour.map(value => Math.round(Math.max(0, Math.min(255, value))).toString(16).padStart(2, '0')).join('')}`;
  const short = value => String(Math.round(Math.max(-9999, Math.min(9999, value)) * 10) / 10);
  const listed = points => points.map(([x, y]) => `${short(x)},${short(y)}`).join(' ');
  const escape = text => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');

  class SvgPainter {
    svg = '';
    is_silent = false; // on a card, where words would be too small to read

    constructor(palette) {
      this.names = new Map([[palette.ink, 'var(--figure-frame)'], [palette.grid, 'var(--figure-grid)'],
        [palette.paper, 'var(--figure-paper)'], ...palette.bodies.map((colour, n) => [colour, `var(--figure-${n + 1})`])]);
    }

    #colour(colour) {
      return this.names.get(colour) ?? css(colour);
    }

    polygon(points, colour) {
      const fill = this.#colour(colour);
      this.svg += `<polygon points="${listed(points)}" fill="${fill}" stroke="${fill}"/>`;
    }

    disc(x, y, radius, colour) {
      this.svg += `<circle cx="${short(x)}" cy="${short(y)}" r="${radius}" fill="${this.#colour(colour)}" stroke="none"/>`;
    }

    line(points, colour, width, opacity, dash = []) {
      if (opacity <= 0.01) return;
      this.svg += `<polyline points="${listed(points)}" fill="none" stroke="${this.#colour(colour)}" stroke-width="${width}"` +
        `${opacity < 1 ? ` opacity="${opacity}"` : ''}${dash.length ? ` stroke-dasharray="${dash.join(' ')}"` : ''}/>`;
    }

    clipped({left, top, width, height}, draw) {
      const box = [left, top, width, height].map(short);
      this.svg += `<svg x="${box[0]}" y="${box[1]}" width="${box[2]}" height="${box[3]}" viewBox="${box.join(' ')}">`;
      draw();
      this.svg += '</svg>';
    }

    width_of(words) {
      return 6.4 * words.replace(/\*/g, '').length; // about
    }

    shadow() {} // light from above is for what moves

    text(words, x, y, align, colour) {
      if (this.is_silent) return;
      const anchor = {left: 'start', center: 'middle', right: 'end'}[align];
      this.svg += `<text x="${short(x)}" y="${short(y + 4)}" text-anchor="${anchor}" font-size="12" ` +
        `fill="${this.#colour(colour)}">${escape(words).replace(/\*([^*]+)\*/g, '<tspan font-style="italic">$1</tspan>')}</text>`;
    }
  }

  /**
   * The figure's panels at the time that it names, side by side where there is room as the live ones are, with what its questions ask
   * for: paper asks nobody. `of_card`: the one panel that stands for it on a card, small and silent, where no question is answered
   * unless the figure says so.
   */
  function still_of(figure, run, palette, {of_card = false} = {}) {
    const state = live.state_of(figure, run, figure.still_time ?? 0);
    const shown = of_card ? [figure.panels[figure.card?.panel ?? 0]] : figure.panels;
    live.is_told = of_card ? figure.card?.is_told ?? false : true;
    const pictures = shown.map(panel => {
      const aspect = of_card ? 1.7 : panel.aspect ?? 1;
      const has_a_row = shown.length === 1 || (figure.timeline && panel === shown.at(-1));
      const width = of_card ? 300 : has_a_row ? 670 : 330, height = Math.round(width / aspect);
      const painter = Object.assign(new SvgPainter(palette), {is_silent: of_card});
      panel.draw({painter, palette, size: {width, height}, view: {...panel.view}}, state);
      return `<svg viewBox="0 0 ${width} ${height}" style="--aspect: ${aspect}">${painter.svg}</svg>`;
    });
    delete live.is_told;
    return of_card ? pictures[0] : `<div class="live-still">${pictures.join('')}</div>`;
  }

  /** What a figure draws from: the columns, the words, the knobs' values by name, and the time shown, s. */
  function state_of(figure, run, time, values = undefined) {
    const by_name = Object.fromEntries(run.knobs.map(({name, start}, n) => [name, values?.[n] ?? start]));
    return {columns: run.columns, units: run.units, said: run.said, values: by_name, time, figure};
  }

  Object.assign(live, {still_of, state_of});
})();
