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

  /** {centre, radius, drop}: a ball that holds all bodies at all times, and how far below its centre the floor lies, m. */
  function bounds_of(recording, models) {
    const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
    const each = action => {
      for (const frame of recording.frames)
        models.forEach(({radius}, body) => action(frame.slice(7 * body, 7 * body + 3), radius));
      for (const {from, to} of recording.links ?? [])
        for (const end of [from, to]) if (end.body === undefined) action(end.point, 0);
    };
    each((point, radius) => {
      for (let k = 0; k < 3; ++k) {
        least[k] = Math.min(least[k], point[k] - radius);
        most[k] = Math.max(most[k], point[k] + radius);
      }
    });
    const centre = least.map((value, k) => (value + most[k]) / 2);
    let radius = 0;
    each((point, own) => {
      radius = Math.max(radius, player.length(player.difference(point, centre)) + own);
    });
    return {centre, radius: radius > 0 ? radius : 1, drop: centre[2] - least[2]};
  }

  /**
   * A camera that looks at `target` from `distance` (m): `azimuth` is counted from the x axis towards y, `elevation` from
   * the horizon up (rad). z is up.
   */
  function first_camera({centre, radius}) {
    // A little below the middle, where the shadow lies.
    const target = player.sum(centre, [0, 0, -0.14 * radius]);
    return {target, azimuth: -Math.PI / 4, elevation: 0.4, distance: (1.08 * radius) / Math.sin(field_of_view / 2)};
  }

  /** Unit vectors of the picture in the world: to the right, up, and back to the camera. */
  function picture_axes({azimuth, elevation}) {
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    return {right: [-sa, ca, 0], up: [-se * ca, -se * sa, ce], back: [ce * ca, ce * sa, se]};
  }

  /** A function from points of the world to [pixels from the left, pixels from the top, distance before the camera]. */
  function projection(camera, {width, height}) {
    const {right, up, back} = picture_axes(camera);
    const scale = Math.min(width, height) / 2 / Math.tan(field_of_view / 2);
    return point => {
      const from_target = player.difference(point, camera.target);
      // What lies behind the camera is drawn as if it were just before it.
      const depth = Math.max(camera.distance - player.dot(from_target, back), camera.distance * 1e-3);
      return [width / 2 + (scale * player.dot(from_target, right)) / depth,
        height / 2 - (scale * player.dot(from_target, up)) / depth, depth];
    };
  }

  Object.assign(player, {duration_of, poses_at, bounds_of, first_camera, picture_axes, projection});
})();
