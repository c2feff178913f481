// Axes with units, and what is drawn between them, with any painter: a canvas' or the still picture's. In words that a painter
// writes a symbol stands between stars, "asked, *ωh*", and is written in italics, as in the text.
(() => {
  const live = (globalThis.tumble_live ??= {figures: {}, modules: {}});

  const superscripts = {'-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹'};

  /** A number as a reader wants it, with `digits` that count: "0.0167", "3.2 × 10⁻⁶", "−4"; as a power of ten from `large` on. */
  function shown(value, digits = 3, large = 1e6) {
    if (Number.isNaN(value)) return 'not a number';
    if (!Number.isFinite(value)) return 'more than a number can hold';
    const size = Math.abs(value);
    if (size !== 0 && (size < 1e-3 || size >= large)) {
      const [mantissa, power] = value.toExponential(digits - 1).split('e');
      const factor = Number(mantissa) === 1 ? '' : `${String(Number(mantissa)).replace('-', '−')}\u00a0×\u00a0`;
      return `${factor}10${[...String(Number(power))].map(c => superscripts[c]).join('')}`;
    }
    return String(Number(value.toPrecision(digits))).replace('-', '−');
  }

  const with_unit = (value, unit, digits) => `${shown(value, digits)}${unit && unit !== '°' ? '\u00a0' : ''}${unit ?? ''}`;

  /** Where the lines of the grid are, [[value, words]]: five or so, 1, 2 or 5 apart; or powers of ten. */
  function ticks_of({least: one, most: other, log, unit}) {
    const [least, most] = [Math.min(one, other), Math.max(one, other)]; // an axis may point down
    if (log) {
      const [first, last] = [Math.ceil(Math.log10(least) - 1e-9), Math.floor(Math.log10(most) + 1e-9)];
      const apart = Math.max(1, Math.ceil((last - first) / 6));
      return Array.from({length: Math.floor((last - first) / apart) + 1}, (_, n) => 10 ** (first + n * apart))
        .map(value => [value, shown(value, 3, 1e4)]); // shorter than "10000"
    }
    const power = 10 ** Math.floor(Math.log10((most - least) / 4));
    const of_turns = unit === '°' && most - least > 90; // quarters and halves of a turn
    const apart = (of_turns ? [30, 45, 90, 180, 360] : [1, 2, 5, 10].map(factor => factor * power)).find(step => (most - least) / step <= 6);
    const first = Math.ceil(least / apart - 1e-9), last = Math.floor(most / apart + 1e-9);
    const decimals = Math.max(0, -Math.floor(Math.log10(apart) + 1e-9));
    return Array.from({length: last - first + 1}, (_, n) => (first + n) * apart)
      .map(value => [value, Math.abs(value) < 1e6 && decimals <= 6 ? String(Number(value.toFixed(decimals))).replace('-', '−') : shown(value)]);
  }

  /** The least and the most of numbers that are some, none above `limit`, with a margin; at least `smallest` wide. */
  function range_of(numbers, {smallest = 0, margin = 0.05, limit = Infinity} = {}) {
    let least = Infinity, most = -Infinity;
    for (const list of numbers)
      for (const value of list)
        if (Number.isFinite(value)) {
          if (value < least) least = value;
          if (value > most) most = value;
        }
    if (least > most) [least, most] = [0, 1];
    most = Math.min(most, limit);
    const missing = Math.max(0, smallest - (most - least)) / 2;
    const wide = (most - least + 2 * missing) * margin || 1e-9;
    return {least: least - missing - wide, most: most + missing + wide};
  }

  /**
   * A plot that fills the picture. x and y: {label, unit, least, most, log}; `equal` makes a unit of both equally long.
   * `place([x, y])` and `value_at([x, y])` go between the axes' numbers and pixels.
   */
  class Plot {
    constructor(painter, palette, {width, height}, x, y, {equal = false} = {}) {
      Object.assign(this, {painter, palette, x: {...x}, y: {...y}});
      const label_width = Math.max(...ticks_of(y).map(([, words]) => painter.width_of(words)));
      this.box = {left: 14 + label_width, top: 26, width: width - label_width - 28, height: height - 66};
      if (equal) this.#make_equal();
      this.#draw_axes();
    }

    #make_equal() {
      const {x, y, box} = this;
      const scale = Math.max((x.most - x.least) / box.width, (y.most - y.least) / box.height);
      for (const [axis, pixels] of [[x, box.width], [y, box.height]]) {
        const middle = (axis.least + axis.most) / 2;
        [axis.least, axis.most] = [middle - (scale * pixels) / 2, middle + (scale * pixels) / 2];
      }
    }

    #along(axis, value) {
      const part = axis.log ? Math.log(value / axis.least) / Math.log(axis.most / axis.least)
        : (value - axis.least) / (axis.most - axis.least);
      return Math.max(-50, Math.min(50, part)); // far outside is far enough
    }

    place([x, y]) {
      const {box} = this;
      return [box.left + this.#along(this.x, x) * box.width, box.top + (1 - this.#along(this.y, y)) * box.height];
    }

    value_at([left, top]) {
      const {box} = this;
      const at = (axis, part) => axis.log ? axis.least * (axis.most / axis.least) ** part
        : axis.least + part * (axis.most - axis.least);
      return [at(this.x, (left - box.left) / box.width), at(this.y, 1 - (top - box.top) / box.height)];
    }

    #draw_axes() {
      const {painter, palette, box, x, y} = this;
      const bottom = box.top + box.height, right = box.left + box.width;
      for (const [tick, words] of ticks_of(x)) {
        const [at] = this.place([tick, y.least]);
        painter.line([[at, box.top], [at, bottom]], palette.grid, 1, 1);
        painter.text(words, at, bottom + 12, 'center', palette.ink);
      }
      for (const [tick, words] of ticks_of(y)) {
        const [, at] = this.place([x.least, tick]);
        painter.line([[box.left, at], [right, at]], palette.grid, 1, 1);
        painter.text(words, box.left - 6, at, 'right', palette.ink);
      }
      painter.line([[box.left, box.top], [box.left, bottom], [right, bottom]], palette.ink, 1, 1);
      const name = ({label, unit}) => (unit ? `${label} (${unit})` : label);
      painter.text(name(y), 4, 10, 'left', palette.ink);
      painter.text(name(x), (box.left + right) / 2, bottom + 30, 'center', palette.ink);
    }

    /** A line through the points; it is broken where a number is none. */
    line(xs, ys, colour, {width = 2, opacity = 1, dash = []} = {}) {
      this.painter.clipped(this.box, () => {
        let part = [];
        const end = () => {
          if (part.length > 1) this.painter.line(part, colour, width, opacity, dash);
          part = [];
        };
        for (let n = 0; n < xs.length; ++n) {
          if (Number.isFinite(xs[n]) && Number.isFinite(ys[n])) part.push(this.place([xs[n], ys[n]]));
          else end();
        }
        end();
      });
    }

    /** Points; a large one marks a place, and paper around it sets it off from what lies below. */
    points(xs, ys, colour, radius = 2.5) {
      const {left, top, width, height} = this.box, beyond = radius + 1.5; // a point on the frame is drawn whole
      this.painter.clipped({left: left - beyond, top: top - beyond, width: width + 2 * beyond, height: height + 2 * beyond}, () => {
        for (let n = 0; n < xs.length; ++n)
          if (Number.isFinite(xs[n]) && Number.isFinite(ys[n])) {
            const at = this.place([xs[n], ys[n]]);
            if (at[0] < left - 0.5 || at[0] > left + width + 0.5 || at[1] < top - 0.5 || at[1] > top + height + 0.5) continue;
            if (radius >= 4) this.painter.disc(...at, radius + 1.5, this.palette.paper);
            this.painter.disc(...at, radius, colour);
          }
      });
    }

    /** In place of what a question asks for, until it is answered. */
    ask() {
      const {left, top, width, height} = this.box;
      this.painter.text('answer first', left + width / 2, top + 0.3 * height, 'center', this.palette.ink);
    }

    /** Words beside a point, in its colour. */
    note(words, at, colour, align = 'left') {
      const [x, y] = this.place(at);
      this.painter.text(words, x + {left: 6, right: -6, center: 0}[align], y - 8, align, colour);
    }

    /** The number that a reader predicted, along x in units of the axis; nothing where there is none. */
    guess(prediction, unit = 1) {
      let kept = null;
      try {
        kept = globalThis.localStorage?.getItem(`tumble.prediction.${prediction}`);
      } catch { /* a browser that keeps nothing */ }
      const {x, y, palette} = this, at = unit * Number.parseFloat(kept);
      if (!(at >= x.least && at <= x.most)) return;
      this.line([at, at], [y.least, y.most], palette.ink, {width: 1, dash: [2, 3]});
      this.note('your guess', [at, y.least], palette.ink, at > (x.least + x.most) / 2 ? 'right' : 'left');
    }

    /** What the marks mean, at the top right: [[words, colour, mark]]; a mark is the dash of a line, or 'dot' or 'cross'. */
    legend(entries) {
      const {painter, box} = this;
      if (painter.is_silent) return;
      const wide = ([words]) => 21 + painter.width_of(words) + 12;
      let left = box.left + box.width + 12 - entries.reduce((sum, entry) => sum + wide(entry), 0);
      for (const entry of entries) {
        const [words, colour, mark = []] = entry;
        if (mark === 'dot') painter.disc(left + 10, 10, 3, colour);
        else if (mark === 'cross') this.cross([left + 10, 10], colour);
        else painter.line([[left, 10], [left + 16, 10]], colour, 2, 1, mark);
        painter.text(words, left + 21, 10, 'left', colour);
        left += wide(entry);
      }
    }

    /** A cross at a place in the picture. */
    cross([x, y], colour) {
      for (const way of [-4, 4]) this.painter.line([[x - 4, y - way], [x + 4, y + way]], colour, 1.5, 1);
    }
  }

  /** Whether the page's reader has answered a prediction, or only wants to see; a still picture is told. */
  function answered(prediction) {
    live.asks = true;
    if (live.is_told !== undefined) return live.is_told;
    const form = globalThis.document?.querySelector(`form[data-prediction="${prediction}"]`);
    return form?.classList.contains('answered') ?? false;
  }

  const made = new WeakMap();

  /** What `make` makes from these columns, made once; `name` tells it from other things. */
  function once(columns, name, make) {
    if (!made.has(columns)) made.set(columns, new Map());
    const kept = made.get(columns);
    if (!kept.has(name)) kept.set(name, make());
    return kept.get(name);
  }

  const models = new Map();

  /** A body in a pose, drawn with the player's parts; `name` tells it from other bodies. */
  function draw_body({painter, palette, size}, camera, name, parts, orientation, {has_axes = false} = {}) {
    if (models.get(name)?.parts !== parts) {
      const recording = {title: '', seconds_between_frames: 1, bodies: [{name, parts}], frames: [[0, 0, 0, 1, 0, 0, 0]]};
      models.set(name, {parts, scene: new globalThis.tumble_player.Scene(recording, 32)});
    }
    const {scene} = models.get(name);
    scene.has_shadows = false; // it floats
    scene.recording.frames[0].splice(3, 4, ...orientation);
    scene.draw(painter, size, camera, 0, palette, {grid_reach: 0, has_axes, has_scale: false});
  }

  /** An arrow in the picture. */
  function arrow(painter, [x, y], [to_x, to_y], colour, width = 2.5) {
    const length = Math.hypot(to_x - x, to_y - y);
    painter.line([[x, y], [to_x, to_y]], colour, width, 1);
    if (length < 4) return;
    const [along_x, along_y] = [(to_x - x) / length, (to_y - y) / length];
    const head = side => [to_x - 9 * along_x - side * 4.5 * along_y, to_y - 9 * along_y + side * 4.5 * along_x];
    painter.polygon([[to_x, to_y], head(1), head(-1)], colour);
  }

  Object.assign(live, {Plot, range_of, shown, with_unit, arrow, draw_body, once, answered});
})();
