// Where the bodies are at a time, and where a point of the world is in the picture.
(() => {
  const player = (globalThis.tumble_player ??= {});
  const field_of_view = (28 * Math.PI) / 180;

  /** The time of the last frame, s. */
  const duration_of = recording => (recording.frames.length - 1) * recording.seconds_between_frames;

  /** [{position, orientation}] of every body's model at a time between two frames. */
  function poses_at(recording, time) {
    const last = recording.frames.length - 1;
    const place = Math.max(0, Math.min(last, time / recording.seconds_between_frames));
    const index = Math.min(Math.floor(place), Math.max(0, last - 1)), fraction = place - index;
    const before = recording.frames[index], after = recording.frames[Math.min(index + 1, last)];
    return recording.bodies.map((_, body) => {
      const [p, q] = [before, after].map(frame => frame.slice(7 * body, 7 * body + 7));
      return {
        position: [0, 1, 2].map(k => p[k] + (q[k] - p[k]) * fraction),
        orientation: player.between(p.slice(3), q.slice(3), fraction),
      };
    });
  }

  const common_divisor = (a, b) => (b ? common_divisor(b, a % b) : a);

  /**
   * What a recording fills: {balls, centre, radius, floor}. The balls, each {centre, radius}, hold the bodies, of which a
   * sample is enough where they are many; one of `radius` about `centre` would hold them all; the lowest touches the height
   * `floor`. Lengths in m.
   */
  function bounds_of(recording, models) {
    const balls = [];
    const count = models.length, all = count * recording.frames.length;
    let stride = Math.ceil(all / 20_000);
    while (common_divisor(stride, count) > 1) ++stride; // so that every body gets its turn
    for (let n = 0; n < all; n += stride) {
      const body = n % count;
      const frame = recording.frames[Math.floor(n / count)];
      balls.push({centre: frame.slice(7 * body, 7 * body + 3), radius: models[body].radius});
    }
    for (const {from, to} of recording.links ?? [])
      for (const end of [from, to]) if (end.body === undefined) balls.push({centre: end.point, radius: 0});
    const extent = k => {
      const least = balls.reduce((least, {centre, radius}) => Math.min(least, centre[k] - radius), Infinity);
      const most = balls.reduce((most, {centre, radius}) => Math.max(most, centre[k] + radius), -Infinity);
      return [least, most];
    };
    const extents = [0, 1, 2].map(extent);
    const radius = player.length(extents.map(([least, most]) => (most - least) / 2));
    return {balls, centre: extents.map(([least, most]) => (least + most) / 2), radius: radius || 1, floor: extents[2][0]};
  }

  /**
   * A camera looks at `target` from `distance` (m); `azimuth` is counted from the x axis towards y, `elevation` from the
   * horizon up (rad). z is up. The first one sees every ball and, on the floor, its shadow.
   */
  function first_camera({balls, floor, radius}, {width, height}) {
    const camera = {azimuth: -Math.PI / 4, elevation: 0.4};
    const axes = picture_axes(camera);
    const seen = balls.flatMap(({centre, radius: own}) =>
      [[...centre], [centre[0], centre[1], floor]].map((point, is_shadow) => ({
        right: player.dot(point, axes.right), up: player.dot(point, axes.up), back: player.dot(point, axes.back),
        half_width: own, half_height: is_shadow ? own * Math.sin(camera.elevation) : own,
      })));
    const middle = (along, half) => {
      const least = seen.reduce((least, ball) => Math.min(least, ball[along] - ball[half]), Infinity);
      return (least + seen.reduce((most, ball) => Math.max(most, ball[along] + ball[half]), -Infinity)) / 2;
    };
    const [right, up] = [middle('right', 'half_width'), middle('up', 'half_height')];
    const back = player.dot(seen.length ? balls[0].centre : [0, 0, 0], axes.back);
    camera.target = [axes.right, axes.up, axes.back].reduce((point, axis, k) =>
      player.sum(point, player.scaled(axis, [right, up, back][k])), [0, 0, 0]);
    // Half of the picture's sides, a metre before the camera, less a margin.
    const [across, along] = [width, height].map(side => (0.93 * Math.tan(field_of_view / 2) * side) / Math.min(width, height));
    camera.distance = seen.reduce((distance, ball) => Math.max(distance, ball.back - back +
      Math.max((Math.abs(ball.right - right) + ball.half_width) / across, (Math.abs(ball.up - up) + ball.half_height) / along)),
    1e-3 * radius);
    return camera;
  }

  /** First cameras of scenes that stand side by side: equally far away, so that lengths can be compared. */
  function first_cameras(scenes, size) {
    const cameras = scenes.map(({bounds}) => first_camera(bounds, size));
    const distance = Math.max(...cameras.map(camera => camera.distance));
    return cameras.map(camera => ({...camera, distance}));
  }

  /** The camera, now aimed at a body, from so near that one sees what it does: {target, distance}, the rest as it was. */
  function following(camera, {bounds, models}, body, position) {
    return {...camera, target: position, distance: Math.min(camera.distance, Math.max(20 * models[body].radius, 0.6 * bounds.radius))};
  }

  /** Unit vectors of the picture in the world: to the right, up, and back to the camera. */
  function picture_axes({azimuth, elevation}) {
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    return {right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], back: [ce * ca, ce * sa, se]};
  }

  /**
   * A function from points of the world to [pixels from the left, pixels from the top, distance before the camera], with
   * a property `line`: from two points to the part between them that lies before the camera, or to nothing; and with
   * `is_before`: whether what it makes of a point lies before the camera.
   */
  function projection(camera, {width, height}) {
    const {right, up, back} = picture_axes(camera);
    const scale = Math.min(width, height) / 2 / Math.tan(field_of_view / 2);
    const nearest = camera.distance * 1e-3;
    const distance_to = point => camera.distance - player.dot(player.difference(point, camera.target), back);
    const project = point => {
      const from_target = player.difference(point, camera.target);
      // What lies behind the camera is taken as if it were just before it.
      const depth = Math.max(camera.distance - player.dot(from_target, back), nearest);
      return [width / 2 + (scale * player.dot(from_target, right)) / depth,
        height / 2 - (scale * player.dot(from_target, up)) / depth, depth];
    };
    project.line = (start, end) => {
      const [from, to] = [distance_to(start), distance_to(end)];
      if (from <= nearest && to <= nearest) return undefined;
      const cut = player.sum(start, player.scaled(player.difference(end, start), (nearest - from) / (to - from)));
      return [from < nearest ? cut : start, to < nearest ? cut : end].map(project);
    };
    project.is_before = ([, , depth]) => depth > nearest;
    return project;
  }

  Object.assign(player, {duration_of, poses_at, bounds_of, first_cameras, following, picture_axes, projection});
})();
