// A painter for a canvas, and the colours that the page gives it.
(() => {
  const player = (globalThis.tumble_player ??= {});

  const css = ([red, green, blue], opacity = 1) =>
    `rgb(${Math.round(red)} ${Math.round(green)} ${Math.round(blue)} / ${Math.round(1000 * opacity) / 1000})`;

  class CanvasPainter {
    constructor(canvas) {
      this.canvas = canvas;
      this.context = canvas.getContext('2d');
    }

    /** An empty picture of width and height in CSS pixels, sharp on fine screens. */
    begin({width, height}, paper) {
      this.ratio = Math.min(2, globalThis.devicePixelRatio || 1);
      const [columns, rows] = [width, height].map(length => Math.round(length * this.ratio));
      if (this.canvas.width !== columns) this.canvas.width = columns;
      if (this.canvas.height !== rows) this.canvas.height = rows;
      this.context.setTransform(columns / width, 0, 0, rows / height, 0, 0);
      this.context.lineJoin = 'round';
      this.context.lineCap = 'round';
      this.is_dark = paper[0] < 128; // where a shadow must be deeper to be seen
      const family = getComputedStyle(this.canvas).fontFamily; // the page's own letters
      this.fonts ??= [`13px ${family}`, `italic 14px KaTeX_Math, ${family}`, `10.5px ${family}`]; // words, symbols, powers
      this.paper = css(paper);
      this.context.fillStyle = this.paper;
      this.context.fillRect(0, 0, width, height);
    }

    #path(points) {
      points.forEach(([x, y], n) => (n ? this.context.lineTo(x, y) : this.context.moveTo(x, y)));
    }

    polygon(points, colour) {
      const {context} = this;
      context.beginPath();
      this.#path(points);
      context.closePath();
      context.fillStyle = context.strokeStyle = css(colour);
      context.fill();
      // The outline closes the hairline between two neighbours.
      context.lineWidth = 1.1;
      context.stroke();
    }

    disc(x, y, radius, colour) {
      this.context.beginPath();
      this.context.arc(x, y, radius, 0, 2 * Math.PI);
      this.context.fillStyle = css(colour);
      this.context.fill();
    }

    /** `dash`: lengths of strokes and gaps in turn, px; none draws it solid. */
    line(points, colour, width, opacity, dash = []) {
      if (opacity <= 0.01) return;
      this.context.beginPath();
      this.#path(points);
      this.context.strokeStyle = css(colour, opacity);
      this.context.lineWidth = width;
      this.context.setLineDash(dash);
      this.context.stroke();
      this.context.setLineDash([]);
    }

    /** What `draw` draws, as far as it lies in the box. */
    clipped({left, top, width, height}, draw) {
      this.context.save();
      this.context.beginPath();
      this.context.rect(left, top, width, height);
      this.context.clip();
      draw();
      this.context.restore();
    }

    /** All polygons as one shape, its rim soft. */
    shadow(polygons, colour) {
      const {context} = this;
      const aside = 10_000; // the shape itself falls outside the picture, and only the shadow that it throws lies inside
      context.save();
      context.shadowColor = css(colour, this.is_dark ? 0.6 : 0.2);
      context.shadowBlur = 5 * this.ratio;
      context.shadowOffsetX = aside * this.ratio;
      context.beginPath();
      for (const points of polygons) {
        this.#path(points.map(([x, y]) => [x - aside, y]));
        context.closePath();
      }
      context.fill();
      context.restore();
    }

    /**
     * The words' parts with their widths, px. What stands between stars is a symbol, and in italics. Powers are raised digits, since the
     * letters for them are smaller than one can read here.
     */
    #measured(words) {
      return words.split('*').flatMap((text, n) => text.split(/([⁻⁰¹²³⁴-⁹]+)/).map((some, m) => {
        const part = m % 2 ? [...some].map(letter => '−0123456789'['⁻⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(letter)]).join('') : some;
        const font = this.context.font = m % 2 ? this.fonts[2] : this.fonts[n % 2];
        return {part, font, up: m % 2 ? 4.5 : 0, wide: this.context.measureText(part).width};
      })).filter(({part}) => part);
    }

    /** How wide text() writes the words, px. */
    width_of(words) {
      return this.#measured(words).reduce((sum, {wide}) => sum + wide, 0);
    }

    text(words, x, y, align, colour) {
      const {context} = this, parts = this.#measured(words);
      const wide = parts.reduce((sum, part) => sum + part.wide, 0);
      const begin = x - wide * {left: 0, center: 0.5, right: 1}[align];
      context.textAlign = 'left';
      context.textBaseline = 'alphabetic'; // the middles of two fonts differ
      // Paper around the letters keeps a name on a line legible.
      context.strokeStyle = this.paper;
      context.lineWidth = 4;
      context.fillStyle = css(colour);
      for (const write of ['strokeText', 'fillText']) {
        let at = begin;
        for (const part of parts) {
          context.font = part.font;
          context[write](part.part, at, y + 4.5 - part.up);
          at += part.wide;
        }
      }
    }
  }

  /** The colours of the page at `element`, light or dark, as numbers. */
  function palette_of(element) {
    const style = getComputedStyle(element);
    const context = Object.assign(document.createElement('canvas'), {width: 1, height: 1})
      .getContext('2d', {willReadFrequently: true});
    const colour = name => {
      context.fillStyle = style.getPropertyValue(name).trim();
      context.fillRect(0, 0, 1, 1);
      return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3);
    };
    return {
      paper: colour('--player-paper'),
      ink: colour('--player-ink'),
      grid: colour('--player-grid'),
      shade: colour('--player-shade'),
      bodies: [1, 2, 3, 4, 5, 6].map(n => colour(`--figure-${n}`)),
    };
  }

  Object.assign(player, {CanvasPainter, palette_of});
})();
