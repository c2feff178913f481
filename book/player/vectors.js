// Vectors are [x, y, z], quaternions [q0, q1, q2, q3] with the real part first. Every file of the player adds to one
// object, so that a page, node and a file that holds them all one after another can use them alike.
(() => {
  const player = (globalThis.tumble_player ??= {});

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const sum = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
  const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const scaled = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = a => Math.hypot(a[0], a[1], a[2]);
  const unit = a => scaled(a, 1 / length(a));

  /** The rows of the matrix that turns model axes into the world's. */
  function matrix_of([w, x, y, z]) {
    const s = 2 / (w * w + x * x + y * y + z * z);
    return [
      [1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
      [s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)],
      [s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)],
    ];
  }

  const turned = (matrix, a) => [dot(matrix[0], a), dot(matrix[1], a), dot(matrix[2], a)];

  /** From p to q on the shortest arc, for q and -q are one orientation. */
  function between(p, q, fraction) {
    let cosine = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
    const sign = cosine < 0 ? -1 : 1;
    cosine = Math.min(1, Math.abs(cosine));
    const angle = Math.acos(cosine), sine = Math.sin(angle);
    // Closer than this the arc is straight, and 0/0 is near.
    const [of_p, of_q] = sine < 1e-6 ? [1 - fraction, fraction]
      : [Math.sin((1 - fraction) * angle) / sine, Math.sin(fraction * angle) / sine];
    return p.map((component, n) => of_p * component + of_q * sign * q[n]);
  }

  Object.assign(player, {dot, sum, difference, scaled, cross, length, unit, matrix_of, turned, between});
})();
