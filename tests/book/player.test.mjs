// The geometry of the player, without a browser: solids, poses between frames, and what the first camera sees.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';
import '../../book/player/vectors.js';
import '../../book/player/solids.js';
import '../../book/player/camera.js';
import '../../book/player/scene.js';

const player = globalThis.tumble_player;
const {dot, cross, length, sum, scaled} = player;
const {PI} = Math;

/// [volume, sum of the area vectors, least component of a face's normal along its area] by Gauss' theorem on triangles.
function measured({corners, faces}) {
  let volume = 0, areas = [0, 0, 0], least = 1;
  for (const {corners: indices, normal} of faces) {
    const [a, ...rest] = indices.map(index => corners[index]);
    for (let n = 0; n + 1 < rest.length; ++n) {
      volume += dot(a, cross(rest[n], rest[n + 1])) / 6;
      const area = scaled(cross(player.difference(rest[n], a), player.difference(rest[n + 1], a)), 0.5);
      areas = sum(areas, area);
      if (length(area) > 1e-12) least = Math.min(least, dot(normal, area) / length(area));
    }
  }
  return {volume, areas, least};
}

const tetrahedron = {corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], triangles: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]};
const solids = [
  ['box', [1, 2, 3], 6, [-1.5, 1.5]],
  ['mesh', tetrahedron, 1 / 6, [0, 1]],
  ['sphere', 2, (32 / 3) * PI, [-2, 2]],
  ['ellipsoid', [1, 2, 3], 8 * PI, [-3, 3]],
  ['cylinder', [2, 3], 12 * PI, [-1.5, 1.5]],
  ['capsule', [1, 3], (4 / 3 + 3) * PI, [-2.5, 2.5]],
  ['cone', [2, 3], 4 * PI, [0, 3]],
];

for (const [kind, lengths, volume, [bottom, top]] of solids) {
  test(`A ${kind} is closed, faces outward, has its volume and lies where chapter 3 has it.`, () => {
    const [coarse, fine] = [16, 32].map(detail => player.model_of([{[kind]: lengths}], detail));
    for (const model of [coarse, fine]) {
      const {areas, least} = measured(model);
      assert.ok(length(areas) < 1e-12 * volume, `it has a hole: ${areas}`);
      assert.ok(least > 0.9, 'a normal does not belong to its face');
      const heights = model.corners.map(([, , z]) => z);
      assert.ok(Math.abs(Math.min(...heights) - bottom) < 1e-12 && Math.abs(Math.max(...heights) - top) < 1e-12);
    }
    // Inscribed polygons are smaller by a part that falls with the square of the number of faces.
    const [error, finer] = [coarse, fine].map(model => 1 - measured(model).volume / volume);
    if (kind === 'box' || kind === 'mesh') assert.ok(Math.abs(error) < 1e-12 && Math.abs(finer) < 1e-12);
    else assert.ok(finer > 0 && error / finer > 3.7 && error / finer < 4.3, `${error} ${finer}`);
  });
}

test('A part is turned and moved in its model, and a body reaches as far as its farthest corner.', () => {
  const half = Math.SQRT1_2; // a quarter turn about x takes z to -y
  const part = {cylinder: [0.1, 2], position: [0, 0, 5], orientation: [half, half, 0, 0]};
  const {corners, radius} = player.model_of([part], 16);
  const [ys, zs] = [1, 2].map(k => corners.map(corner => corner[k]));
  assert.ok(Math.abs(Math.max(...ys) - 1) < 1e-12 && Math.abs(Math.min(...ys) + 1) < 1e-12);
  assert.ok(Math.abs(Math.max(...zs) - 5.1) < 1e-12);
  assert.ok(Math.abs(radius - Math.hypot(1, 5.1)) < 1e-12);
});

test('What has no thickness has no faces of no size.', () => {
  const {faces} = player.model_of([{box: [1, 1, 0]}, {cylinder: [1, 0]}], 16);
  assert.ok(faces.length > 0);
  assert.ok(faces.every(({normal}) => Math.abs(length(normal) - 1) < 1e-12));
});

test('An unknown part and a recording without frames are refused.', () => {
  assert.throws(() => player.model_of([{torus: [1, 2]}], 16), /unknown kind: \{"torus":\[1,2\]\}/);
  const empty = {title: 'Nothing', seconds_between_frames: 1, bodies: [], frames: []};
  assert.throws(() => player.scenes_of([empty], 16), /"Nothing" holds no frame/);
});

test('The matrix of a quaternion, unit or not, turns a vector as the product q v q* does.', () => {
  const [w, ...u] = [0.5, -0.1, 0.7, 0.5]; // of length 1
  for (const v of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
    const once = sum(cross(u, v), scaled(v, w));
    const expected = sum(v, scaled(cross(u, once), 2));
    for (const factor of [1, -1, 3]) {
      const turned = player.turned(player.matrix_of([w, ...u].map(value => factor * value)), v);
      assert.ok(length(player.difference(turned, expected)) < 1e-12, `${turned} is not ${expected}`);
    }
  }
});

test('Half-way between two orientations is half the angle, on the shortest arc.', () => {
  const turn = angle => [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)];
  const close = (p, q) => assert.ok(p.every((value, n) => Math.abs(value - q[n]) < 1e-12), `${p} is not ${q}`);
  close(player.between(turn(0.2), turn(1.2), 0.5), turn(0.7));
  close(player.between(turn(0.2), turn(1.2).map(value => -value), 0.5), turn(0.7));
  close(player.between(turn(-1.4), turn(1.4), 0.25), turn(-0.7));
  close(player.between(turn(1), turn(1), 0.3), turn(1));
});

const recording = {
  title: 'Two', seconds_between_frames: 0.5, bodies: [{name: 'one', parts: [{box: [1, 1, 1]}]}, {name: 'two', parts: [{sphere: 0.5}]}],
  links: [{from: {body: 0, point: [0, 0, 0]}, to: {point: [0, 0, 9]}}],
  frames: [[0, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1, 0, 0, 0], [4, 0, 0, 1, 0, 0, 0, 1, 2, 5, 1, 0, 0, 0]],
};

test('Between frames a body is between its places, and outside the recording it stays at an end.', () => {
  const places = time => player.poses_at(recording, time).map(({position}) => position);
  assert.deepEqual(places(0.125), [[1, 0, 0], [1, 2, 3.5]]);
  assert.deepEqual(places(-1), [[0, 0, 0], [1, 2, 3]]);
  assert.deepEqual(places(7), [[4, 0, 0], [1, 2, 5]]);
  assert.equal(player.duration_of(recording), 0.5);
});

test('The first camera sees every body all the time, and every end of a link, in a picture of any shape.', () => {
  for (const size of [{width: 300, height: 200}, {width: 200, height: 300}, {width: 900, height: 100}]) {
    const scenes = player.scenes_of([recording], 16);
    const [camera] = player.first_cameras(scenes, size);
    const project = player.projection(camera, size);
    const points = recording.frames.flatMap((_, frame) => player.poses_at(recording, 0.5 * frame).flatMap(({position}, body) =>
      scenes[0].models[body].corners.map(corner => sum(position, corner))));
    let [least, most] = [Infinity, -Infinity];
    for (const point of [...points, [0, 0, 9]]) {
      const [x, y] = project(point);
      assert.ok(x > 0 && x < size.width && y > 0 && y < size.height, `${point} is at ${x}, ${y} of ${size.width}, ${size.height}`);
      [least, most] = [Math.min(least, y / size.height, x / size.width), Math.max(most, y / size.height, x / size.width)];
    }
    assert.ok(most - least > 0.6, `it fills ${most - least} of the picture at most`);
  }
});

/// Draws and tells what was drawn: {faces, lines}, each a list of points in the picture.
function drawn(scene, size, camera, time, options) {
  const faces = [], lines = [], black = [0, 0, 0];
  const painter = {
    polygon: points => faces.push(points), line: (points, colour, width) => lines.push({points, colour, width}),
    shadow: polygons => faces.push(...polygons), disc() {}, text() {},
  };
  scene.draw(painter, size, camera, time, {paper: black, ink: 'ink', shade: black, grid: 'grid', bodies: [[1, 1, 1], [2, 2, 2]]},
    {has_scale: false, ...options});
  return {faces, lines};
}

const size = {width: 300, height: 200};

test('A camera that follows a body has it in the middle of the picture all the time, and near enough to see it.', () => {
  const [scene] = player.scenes_of([recording], 16), [first] = player.first_cameras([scene], size);
  for (const time of [0, 0.2, 0.5]) {
    const {position} = player.poses_at(recording, time)[0];
    const camera = player.following(first, scene, 0, position);
    assert.deepEqual(player.projection(camera, size)(position).slice(0, 2), [150, 100]);
    assert.deepEqual([camera.azimuth, camera.elevation], [first.azimuth, first.elevation]);
    assert.ok(camera.distance < first.distance && camera.distance > 3 * scene.models[0].radius);
  }
});

test('The path of a body that is followed is drawn through every frame behind it, however many bodies there are.', () => {
  const crowd = Array.from({length: 13}, (_, n) => ({name: `${n}`, parts: [{point: true}]}));
  const frames = Array.from({length: 600}, (_, frame) => crowd.flatMap((_, n) => [frame, n, 0, 1, 0, 0, 0]));
  const [scene] = player.scenes_of([{title: 'Crowd', seconds_between_frames: 1, bodies: crowd, frames}], 16);
  const [camera] = player.first_cameras([scene], size);
  const paths = options => drawn(scene, size, camera, 500.5, options).lines.filter(({colour}) => colour !== 'grid');
  assert.equal(paths({}).length, 0);
  const path = paths({followed: 3});
  assert.ok(path.every(({colour}) => colour[0] === 2));
  // 240 frames each by itself, the 261 before them by threes.
  assert.equal(path.length, 240 + 87);
  const project = player.projection(camera, size);
  for (const [x, from] of [[500.5, 500], [499, 498], [261, 258], [3, 0]]) {
    const [start, end] = [from, x].map(place => project([place, 3, 0]));
    const close = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-6;
    assert.ok(path.some(({points}) => close(points[0], start) && close(points[1], end)), `no line from ${from} to ${x}`);
  }
});

test('Beside a camera in the midst of a scene nothing is drawn that lies behind it, and of lines the part before it.', () => {
  const [scene] = player.scenes_of([recording], 16);
  const camera = {target: [4, 0, 0], azimuth: Math.PI, elevation: 0.1, distance: 2}; // from x = 2: one body before it, one behind
  const {faces, lines} = drawn(scene, size, camera, 0.5, {followed: 0});
  assert.ok(faces.length > 0 && faces.every(points => points.every(([, , depth]) => depth > 1e-3 * camera.distance)));
  const floor = lines.filter(({colour}) => colour === 'grid');
  assert.ok(floor.length > 0 && floor.every(({points}) => points.every(([, , depth]) => depth >= (1 - 1e-9) * 1e-3 * camera.distance)));
  const half = player.projection(camera, size).line([4, 0, 0], [-4, 0, 0]);
  assert.deepEqual(half[0].slice(0, 2), [150, 100]);
  assert.ok(Math.abs(half[1][2] - 1e-3 * camera.distance) < 1e-12);
  assert.equal(player.projection(camera, size).line([-4, 0, 0], [-4, 1, 0]), undefined);
});

test('The body at a place of the picture is the nearest one that covers it, else a small one within a finger\'s breadth, or none.', () => {
  const bodies = [{name: 'far', parts: [{box: [4, 4, 4]}]}, {name: 'near', parts: [{sphere: 1}]}, {name: 'speck', parts: [{point: true}]}];
  const frames = [[0, 0, 0, 1, 0, 0, 0, 5, 0, 0, 1, 0, 0, 0, 0, 6, 0, 1, 0, 0, 0]];
  const [scene] = player.scenes_of([{title: 'Three', seconds_between_frames: 1, bodies, frames}], 16);
  const camera = {target: [0, 0, 0], azimuth: 0, elevation: 0, distance: 40}; // from +x
  const project = player.projection(camera, size);
  const at = (point, [x, y] = [0, 0]) => {
    const [a, b] = project(point);
    return scene.body_at([a + x, b + y], size, camera, 0);
  };
  assert.equal(at([5, 0, 0]), 1);
  assert.equal(at([2, 1.8, 1.8]), 0);
  assert.equal(at([0, 6, 0]), 2);
  assert.equal(at([0, 6, 0], [9, -9]), 2);
  assert.equal(at([0, 6, 0], [15, 0]), undefined);
  assert.equal(at([0, -6, 0]), undefined);
});

test('Only a body that goes somewhere can be followed.', () => {
  const turning = {...recording, frames: [recording.frames[0], recording.frames[0]]};
  assert.equal(player.scenes_of([recording], 16)[0].can_follow, true);
  assert.equal(player.scenes_of([turning], 16)[0].can_follow, false);
});

test('Only the faces on the side of the camera are drawn, far ones first and over the floor.', () => {
  const [scene] = player.scenes_of([recording], 16);
  const [camera] = player.first_cameras([scene], size);
  const order = [], polygons = [];
  const painter = {
    line: (points, colour) => order.push(colour === 'grid' ? 'floor' : 'link'), shadow: () => order.push('floor'), text() {},
    polygon: points => polygons.push(points) && order.push('face'),
  };
  const black = [0, 0, 0];
  scene.draw(painter, size, camera, 0, {paper: black, ink: black, shade: black, grid: 'grid', bodies: [black]}, {has_scale: false});
  assert.ok(order.lastIndexOf('floor') < order.indexOf('face'));
  assert.equal(order.filter(kind => kind === 'link').length, 8);
  // Anticlockwise in the world is a negative area where y grows downwards.
  const area = points => points.reduce((total, [x, y], n) => {
    const [u, v] = points[(n + 1) % points.length];
    return total + x * v - y * u;
  }, 0);
  assert.ok(polygons.every(points => area(points) < 1e-9));
  const faces = scene.models.flatMap(model => model.faces).length;
  assert.ok(polygons.length > 0.35 * faces && polygons.length < 0.6 * faces, `${polygons.length} of ${faces}`);
  const depths = polygons.map(points => points.reduce((total, point) => total + point[2] / points.length, 0));
  assert.ok(depths.every((depth, n) => n === 0 || depth <= depths[n - 1] + 1e-12));
});

test('Scenes side by side are seen from equally far.', () => {
  const big = {...recording, frames: recording.frames.map(frame => frame.map((value, n) => n % 7 < 3 ? 3 * value : value))};
  const cameras = player.first_cameras(player.scenes_of([recording, big], 16), {width: 300, height: 200});
  assert.equal(cameras[0].distance, cameras[1].distance);
});

test("The page of its own has the book's colours, light and dark.", () => {
  const read = path => readFileSync(new URL(path, import.meta.url), 'utf8');
  const colours_of = style => style.match(/\{[^{}]*--figure-1: #[^{}]*\}/g).map(block => Object.fromEntries(
    [...block.matchAll(/--(figure-\w+|primary-color|separator-color|page-secondary-foreground-color): (#\w+);/g)]
      .map(([, name, colour]) => [name, colour])));
  const [book, page] = ['../../book/theme/book.css', '../../book/player/player.css'].map(path => colours_of(read(path)));
  assert.equal(page.length, 2);
  for (const [mode, colours] of page.entries()) {
    assert.ok(Object.keys(colours).length >= 12);
    for (const [name, colour] of Object.entries(colours)) assert.equal(colour, book[mode][name], name);
  }
});
