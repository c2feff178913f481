// Draws a moment of a recording, far things first, with whatever painter it is given: a canvas' or the still picture's.
(() => {
  const player = (globalThis.tumble_player ??= {});

  const mixed = (colour, other, share) => colour.map((value, k) => value + (other[k] - value) * share);
  const white = [255, 255, 255];

  /** 1, 2 or 5 times a power of ten, at most `length`. */
  function round_length(length) {
    const power = 10 ** Math.floor(Math.log10(length));
    return power * [5, 2, 1].find(factor => factor * power <= length);
  }

  /** "5 cm" */
  function shown_length(length) {
    const [unit, metres] = [['km', 1e3], ['m', 1], ['cm', 1e-2], ['mm', 1e-3], ['µm', 1e-6]]
      .find(([, size]) => length >= 0.999 * size) ?? ['nm', 1e-9];
    return `${Number((length / metres).toPrecision(3))}\u00a0${unit}`;
  }

  /** Whether a convex polygon in the picture holds a point. */
  function holds(points, [x, y]) {
    const sides = points.map(([a, b], n) => {
      const [c, d] = points[(n + 1) % points.length];
      return (c - a) * (y - b) - (d - b) * (x - a);
    });
    return sides.every(side => side >= 0) || sides.every(side => side <= 0);
  }

  class Scene {
    first_colour = 0;

    /** `detail`: the faces round a circle; fewer where there are many bodies. */
    constructor(recording, detail) {
      if (!recording.frames.length) throw new Error(`the recording "${recording.title}" holds no frame`);
      this.recording = recording;
      const parts = recording.bodies.reduce((total, body) => total + body.parts.length, 0);
      const affordable = parts <= 20 ? detail : parts <= 200 ? 16 : 8;
      this.models = recording.bodies.map(body => player.model_of(body.parts, Math.min(detail, affordable)));
      this.bounds = player.bounds_of(recording, this.models);
      this.has_shadows = parts <= 200;
      this.trails = this.#travelling();
    }

    /** The distance between the lines of the floor, m. */
    get grid() {
      return round_length(this.bounds.radius / 3);
    }

    /** Whether a body goes somewhere. */
    #travels(body) {
      const {frames} = this.recording, [x, y, z] = [0, 1, 2].map(k => 7 * body + k);
      return frames.some(frame => Math.hypot(frame[x] - frames[0][x], frame[y] - frames[0][y], frame[z] - frames[0][z]) >
        2 * this.models[body].radius);
    }

    /** Whether there is a body that a camera could follow. */
    get can_follow() {
      return this.models.some((_, body) => this.#travels(body));
    }

    /** The bodies whose paths are always drawn: those that go somewhere, as long as the bodies are few. */
    #travelling() {
      return this.models.length > 12 ? [] : [...this.models.keys()].filter(body => this.#travels(body));
    }

    /**
     * The body that one sees at [x, y] in the picture, px, or nothing. A body too small to be met is met within a finger's
     * breadth, where no other is seen.
     */
    body_at([x, y], size, camera, time) {
      const project = player.projection(camera, size);
      const camera_place = player.sum(camera.target, player.scaled(player.picture_axes(camera).back, camera.distance));
      let seen, nearest, [depth, miss] = [Infinity, 14];
      player.poses_at(this.recording, time).forEach(({position, orientation}, body) => {
        const centre = project(position);
        if (!project.is_before(centre)) return;
        const away = Math.hypot(centre[0] - x, centre[1] - y);
        if (away < miss) [nearest, miss] = [body, away];
        const met = {polygon: points => {
          if (points[0][2] < depth && holds(points, [x, y])) [seen, depth] = [body, points[0][2]];
        }};
        const marks = [], pose = {position, matrix: player.matrix_of(orientation)};
        this.#mark_faces(marks, met, project, this.models[body], pose, camera_place, () => undefined);
        for (const [, mark] of marks) mark();
      });
      return seen ?? nearest;
    }

    #colour_of(body, {bodies}) {
      return bodies[(this.first_colour + body) % bodies.length];
    }

    /** `palette` holds colours as [red, green, blue]: paper, ink, grid, and bodies, which take them in turn. The path of the body `followed` is drawn in any case. */
    draw(painter, size, camera, time, palette, {grid_pieces = 10, grid_reach = 1.25, has_scale = true, has_axes = has_scale, followed = undefined} = {}) {
      const project = player.projection(camera, size);
      const axes = player.picture_axes(camera);
      const poses = player.poses_at(this.recording, time)
        .map(({position, orientation}) => ({position, matrix: player.matrix_of(orientation)}));
      if (axes.back[2] > 0.02) this.#draw_floor(painter, project, poses, palette, grid_pieces, grid_reach);
      const light = player.unit(player.sum(player.sum([0, 0, 1], player.scaled(axes.back, 0.7)),
        player.scaled(axes.right, -0.6)));
      const shine = player.unit(player.sum(light, axes.back));
      const camera_place = player.sum(camera.target, player.scaled(axes.back, camera.distance));
      const marks = []; // [distance, function that draws]
      poses.forEach((pose, body) => {
        const colour = this.#colour_of(body, palette);
        this.#mark_faces(marks, painter, project, this.models[body], pose, camera_place, ({normal, is_marked}) => {
          const base = is_marked ? mixed(colour, white, 0.2) : colour;
          const facing = player.dot(normal, light);
          const gleam = Math.max(0, player.dot(normal, shine)) ** 20;
          return mixed(mixed(base, palette.shade, 0.42 * (1 - facing) ** 1.2), white, 0.1 * Math.max(0, facing) + 0.3 * gleam);
        });
        for (const point of this.models[body].points) {
          const place = project(player.sum(pose.position, player.turned(pose.matrix, point)));
          if (project.is_before(place)) marks.push([place[2], () => painter.disc(place[0], place[1], 2.2, colour)]);
        }
      });
      this.#mark_trails(marks, painter, project, time, palette, followed);
      this.#mark_links(marks, painter, project, poses, palette);
      marks.sort((one, other) => other[0] - one[0]);
      for (const [, mark] of marks) mark();
      if (has_axes) this.#draw_axes(painter, size, axes, palette);
      if (has_scale) painter.text(`squares of ${shown_length(this.grid)}`, size.width - 12, size.height - 14, 'right', palette.ink);
    }

    #mark_faces(marks, painter, project, model, {position, matrix}, camera_place, colour_of) {
      const in_world = model.corners.map(corner => player.sum(position, player.turned(matrix, corner)));
      const in_picture = in_world.map(project);
      for (const face of model.faces) {
        const normal = player.turned(matrix, face.normal);
        if (player.dot(normal, player.difference(camera_place, in_world[face.corners[0]])) <= 0) continue;
        const points = face.corners.map(corner => in_picture[corner]);
        if (!points.every(project.is_before)) continue;
        const depth = points.reduce((total, point) => total + point[2], 0) / points.length;
        marks.push([depth, () => painter.polygon(points, colour_of({normal, is_marked: face.is_marked}))]);
      }
    }

    #mark_line(marks, painter, project, points, colour, width, opacity) {
      for (let n = 0; n + 1 < points.length; ++n) {
        const piece = project.line(points[n], points[n + 1]);
        if (piece) marks.push([(piece[0][2] + piece[1][2]) / 2, () => painter.line(piece, colour, width, opacity)]);
      }
    }

    #mark_trails(marks, painter, project, time, palette, followed) {
      const {frames, seconds_between_frames} = this.recording;
      const stride = Math.max(1, Math.ceil(frames.length / 240));
      const now = player.poses_at(this.recording, time);
      const passed = Math.min(frames.length, Math.ceil(time / seconds_between_frames)); // frames before this moment
      for (const body of new Set(followed === undefined ? this.trails : [...this.trails, followed])) {
        const path = [];
        // Whoever follows a body sees from near where it has just been.
        for (let n = 0; n < passed; n += body === followed && n >= passed - 240 ? 1 : stride)
          path.push(frames[n].slice(7 * body, 7 * body + 3));
        const [width, opacity] = body === followed ? [2.5, 0.9] : [1.5, 0.6];
        this.#mark_line(marks, painter, project, [...path, now[body].position], this.#colour_of(body, palette), width, opacity);
      }
    }

    #mark_links(marks, painter, project, poses, palette) {
      const place = ({body, point}) => (body === undefined ? point
        : player.sum(poses[body].position, player.turned(poses[body].matrix, point)));
      for (const {from, to} of this.recording.links ?? []) {
        const [start, end] = [place(from), place(to)];
        const points = Array.from({length: 9}, (_, n) => player.sum(start, player.scaled(player.difference(end, start), n / 8)));
        this.#mark_line(marks, painter, project, points, palette.ink, 1.5, 0.75);
      }
    }

    /** A grid that fades towards its rim, and the shadows that light from straight above throws on it. */
    #draw_floor(painter, project, poses, palette, pieces, grid_reach) {
      const {centre, radius, floor} = this.bounds;
      const reach = grid_reach * radius;
      for (const [along, across] of [[0, 1], [1, 0]]) {
        const first = Math.ceil((centre[across] - reach) / this.grid), last = Math.floor((centre[across] + reach) / this.grid);
        for (let n = first; n <= last; ++n) {
          const aside = n * this.grid - centre[across];
          const half = Math.sqrt(Math.max(0, reach * reach - aside * aside));
          const at = part => {
            const point = [0, 0, floor];
            point[along] = centre[along] + (2 * part - 1) * half;
            point[across] = n * this.grid;
            return point;
          };
          for (let piece = 0; piece < pieces; ++piece) {
            const middle = ((2 * piece + 1) / pieces - 1) * half;
            const opacity = pieces === 1 ? 0.8 : 1 - (aside * aside + middle * middle) / (reach * reach);
            const line = project.line(at(piece / pieces), at((piece + 1) / pieces));
            if (line) painter.line(line, palette.grid, 1, opacity);
          }
        }
      }
      if (!this.has_shadows) return;
      const shadow = [];
      poses.forEach(({position, matrix}, body) => {
        const {corners, faces} = this.models[body];
        const below = corners.map(corner => {
          const [x, y] = player.sum(position, player.turned(matrix, corner));
          return project([x, y, floor]);
        });
        for (const face of faces)
          if (player.dot(matrix[2], face.normal) > 0 && face.corners.every(corner => project.is_before(below[corner])))
            shadow.push(face.corners.map(corner => below[corner]));
      });
      painter.shadow(shadow, palette.shade);
    }

    /** In the corner: which way the axes point. */
    #draw_axes(painter, {height}, {right, up}, palette) {
      const [x, y, long] = [34, height - 34, 20];
      ['x', 'y', 'z'].forEach((name, k) => {
        const [a, b] = [right[k], -up[k]];
        painter.line([[x, y], [x + long * a, y + long * b]], palette.ink, 1.5, 0.8);
        painter.text(`*${name}*`, x + (long + 8) * a, y + (long + 8) * b, 'center', palette.ink);
      });
    }
  }

  /** Scenes of recordings that stand side by side: on floors of the same size and grid. */
  function scenes_of(recordings, detail) {
    const scenes = recordings.map(recording => new Scene(recording, detail));
    const radius = Math.max(...scenes.map(({bounds}) => bounds.radius));
    for (const {bounds} of scenes) bounds.radius = radius;
    // One body here and one there are told apart by their colours too; several keep those by which one finds them again.
    if (recordings.every(({bodies}) => bodies.length === 1)) scenes.forEach((scene, n) => { scene.first_colour = n; });
    return scenes;
  }

  Object.assign(player, {Scene, scenes_of});
})();
