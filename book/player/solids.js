// From the parts of a body to the corners and faces that are drawn.
(() => {
  const player = (globalThis.tumble_player ??= {});

  /** Corners and faces of a part in its own axes; a face lists its corners anticlockwise, seen from outside. */
  class Faces {
    corners = [];
    faces = [];

    corner(x, y, z) {
      return this.corners.push([x, y, z]) - 1;
    }

    face(corners, is_marked = false) {
      this.faces.push({corners, is_marked});
    }
  }

  /**
   * A surface of revolution about z through [radius, z], from the bottom up. Its quarters are marked alternately, and where
   * `marks_halves` those above z = 0 the other way, so that one sees a round body spin.
   */
  function revolved(profile, segments, marks_halves) {
    const solid = new Faces();
    const rings = profile.map(([radius, z]) => {
      if (!(radius > 0)) return [solid.corner(0, 0, z)];
      return Array.from({length: segments}, (_, n) => {
        const angle = (2 * Math.PI * n) / segments;
        return solid.corner(radius * Math.cos(angle), radius * Math.sin(angle), z);
      });
    });
    for (let k = 0; k + 1 < rings.length; ++k)
      for (let n = 0; n < segments; ++n) {
        const at = (ring, index) => ring[index % ring.length];
        const corners = [at(rings[k], n), at(rings[k], n + 1), at(rings[k + 1], n + 1), at(rings[k + 1], n)];
        const is_odd = Math.floor((4 * n) / segments) % 2 === 1;
        const is_above = profile[k][1] + profile[k + 1][1] > 0;
        solid.face([...new Set(corners)], is_odd !== (marks_halves && is_above));
      }
    return solid;
  }

  /** Points from `start` to `end`, so that no face is long: what is sorted by its middle must not be. */
  function steps(start, end, count) {
    return Array.from({length: count + 1}, (_, n) => start.map((value, k) => value + ((end[k] - value) * n) / count));
  }

  const many = (ratio, detail) => Math.max(1, Math.min(Math.round(detail / 4), Math.round(ratio)));

  /** A quarter of a circle about [0, z], from the angle `start` (of the z axis' plane) to `end`. */
  function arc(radius, z, start, end, count) {
    return Array.from({length: count + 1}, (_, n) => {
      const angle = start + ((end - start) * n) / count;
      const cosine = Math.cos(angle);
      return [cosine < 1e-9 ? 0 : radius * cosine, z + radius * Math.sin(angle)];
    });
  }

  /** Of two sides that face each other one is marked, so that one sees whether it has turned over. */
  function box([a, b, c], cuts) {
    const solid = new Faces();
    const size = [a, b, c];
    for (let axis = 0; axis < 3; ++axis)
      for (const side of [-0.5, 0.5]) {
        const [u, v] = side > 0 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
        const at = (i, j) => {
          const point = [0, 0, 0];
          point[axis] = side * size[axis];
          point[u] = (i / cuts - 0.5) * size[u];
          point[v] = (j / cuts - 0.5) * size[v];
          return solid.corner(...point);
        };
        for (let i = 0; i < cuts; ++i)
          for (let j = 0; j < cuts; ++j) solid.face([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], side > 0);
      }
    return solid;
  }

  function mesh({corners, triangles}) {
    const solid = new Faces();
    solid.corners = corners;
    for (const triangle of triangles) solid.face(triangle);
    return solid;
  }

  // Centred as in chapter 3's solids: a cone stands on z = 0 with its tip up, the others lie about the origin.
  const kinds = {
    box: (size, detail) => box(size, detail > 12 ? 3 : 1),
    sphere: (radius, detail) => revolved(arc(radius, 0, -Math.PI / 2, Math.PI / 2, detail / 2), detail, true),
    ellipsoid: ([a, b, c], detail) => {
      const solid = kinds.sphere(1, detail);
      solid.corners = solid.corners.map(([x, y, z]) => [a * x, b * y, c * z]);
      return solid;
    },
    cylinder: ([radius, height], detail) => {
      const side = steps([radius, -height / 2], [radius, height / 2], many((height / radius) * 3, detail));
      return revolved([[0, -height / 2], ...side, [0, height / 2]], detail, false);
    },
    capsule: ([radius, length], detail) => {
      const below = arc(radius, -length / 2, -Math.PI / 2, 0, detail / 4);
      const above = arc(radius, length / 2, 0, Math.PI / 2, detail / 4);
      const side = steps(below.at(-1), above[0], many((length / radius) * 3, detail));
      return revolved([...below, ...side.slice(1, -1), ...above], detail, false);
    },
    cone: ([radius, height], detail) => {
      const side = steps([radius, 0], [0, height], many((height / radius) * 3, detail));
      return revolved([[0, 0], ...side], detail, false);
    },
    mesh,
  };

  /** Twice the area times the outward normal, by Newell's sum, which forgives corners that coincide. */
  function area_vector(points) {
    return points.reduce((total, point, n) => player.sum(total, player.cross(point, points[(n + 1) % points.length])),
      [0, 0, 0]);
  }

  /**
   * A body's corners and faces in its model axes, its points, and its radius about the model's origin.
   * `detail`, a multiple of four, is the number of faces round a circle.
   */
  function model_of(parts, detail) {
    const model = {corners: [], faces: [], points: [], radius: 0};
    for (const part of parts) {
      const matrix = player.matrix_of(part.orientation ?? [1, 0, 0, 0]);
      const placed = point => player.sum(part.position ?? [0, 0, 0], player.turned(matrix, point));
      if (part.point) {
        model.points.push(placed([0, 0, 0]));
        continue;
      }
      const kind = Object.keys(kinds).find(name => name in part);
      if (!kind) throw new Error(`a part of an unknown kind: ${JSON.stringify(part)}`);
      const solid = kinds[kind](part[kind], detail);
      const first = model.corners.length;
      model.corners.push(...solid.corners.map(placed));
      for (const {corners, is_marked} of solid.faces) {
        const own = corners.map(corner => first + corner);
        const vector = area_vector(own.map(corner => model.corners[corner]));
        const area = player.length(vector);
        if (area > 0) model.faces.push({corners: own, is_marked, normal: player.scaled(vector, 1 / area)});
      }
    }
    for (const corner of [...model.corners, ...model.points])
      model.radius = Math.max(model.radius, player.length(corner));
    return model;
  }

  Object.assign(player, {model_of});
})();
