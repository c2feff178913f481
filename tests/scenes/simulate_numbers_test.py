"""simulate_numbers_test.py SIMULATE SCRATCH: the numbers that simulate writes for a body that is turned, off-centre and made of
parts, against numbers worked out here from the textbook: mass, centre of mass and inertia of the parts, Euler's equations without
principal axes, and a fall. Nothing of the library is used."""
import csv
import json
import math
import os
import pathlib
import pty
import re
import resource
import shutil
import subprocess
import sys
import time
import unittest

SIMULATE, SCRATCH = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
ROUNDING = 2.0 ** -53
FLOAT_ROUNDING = 2.0 ** -24  # a replay holds numbers with a float's digits

# --- A scene ------------------------------------------------------------------------------------------------------------------------

RATE, STEPS, EVERY = 240, 120, 10
GRAVITY = (0.5, -1.0, -9.81)
HEIGHT, RADIUS = 4.0, 1.0
PARTS = [
    {"mass": 2, "solid": {"shape": "cone", "radius": RADIUS, "height": HEIGHT}, "position": [1, 0, 0.5]},
    {"mass": 3, "solid": {"shape": "box", "size": [1, 2, 3]}, "position": [-1, 0.5, 0], "orientation": [0.6, 0, 0.8, 0]},
    {"mass": 1, "solid": {"shape": "spherical_shell", "inner_radius": 0.5, "outer_radius": 1}, "position": [0, -2, 1]},
]
BODY = {"name": "odd", "solid": {"shape": "compound", "parts": PARTS}, "position": [10, 20, 30],
        "orientation": [0.5, 0.5, -0.5, 0.5], "velocity": [1, -2, 3], "angular_velocity": [1.5, 2.5, -0.5]}
ANCHOR, ATTACHMENT = [11, 22, 33], [0.25, 0.5, 0.75]
SCENE = {"title": "numbers", "step": {"per_second": RATE}, "duration": STEPS / RATE, "turning_method": "splitting_kahan_li_8",
         "bodies": [BODY], "effects": [{"kind": "gravity", "name": 'a "pull"', "acceleration": GRAVITY}]}

# --- Vectors, matrices and quaternions (the real part first) -----------------------------------------------------------------------


def plus(a, b, times=1.0):
    return [x + times * y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def applied(matrix, vector):
    return [dot(row, vector) for row in matrix]


def product(p, q):
    return [p[0] * q[0] - dot(p[1:], q[1:]), *plus(plus([p[0] * x for x in q[1:]], p[1:], q[0]), cross(p[1:], q[1:]))]


def turned(q, vector):
    w, axis = q[0], q[1:]
    twice = [2 * x for x in cross(axis, vector)]
    return plus(plus(vector, twice, w), cross(axis, twice))


def back(q):
    return [q[0], -q[1], -q[2], -q[3]]


def inverse(m):
    columns = [cross(m[(n + 1) % 3], m[(n + 2) % 3]) for n in range(3)]
    determinant = dot(m[0], columns[0])
    return [[columns[column][row] / determinant for column in range(3)] for row in range(3)]


# --- The body, from the textbook ---------------------------------------------------------------------------------------------------


def solid_of_one_kg(solid):
    """Its centre of mass and its three moments about that, in its own axes."""
    if solid["shape"] == "cone":  # its base at z = 0
        r, h = solid["radius"], solid["height"]
        return [0, 0, h / 4], [3 * r * r / 20 + 3 * h * h / 80] * 2 + [3 * r * r / 10]
    if solid["shape"] == "box":
        x, y, z = (edge * edge / 12 for edge in solid["size"])
        return [0, 0, 0], [y + z, x + z, x + y]
    a, b = solid["inner_radius"], solid["outer_radius"]
    return [0, 0, 0], [2 / 5 * (b**5 - a**5) / (b**3 - a**3)] * 3


def mass_properties():
    """Mass, centre of mass and inertia about that of all parts, in the model's axes."""
    mass = sum(part["mass"] for part in PARTS)
    places = []
    for part in PARTS:
        centre, _ = solid_of_one_kg(part["solid"])
        places.append(plus(part["position"], turned(part.get("orientation", [1, 0, 0, 0]), centre)))
    centre = [sum(part["mass"] * place[n] for part, place in zip(PARTS, places)) / mass for n in range(3)]
    inertia = [[0.0] * 3 for _ in range(3)]
    for part, place in zip(PARTS, places):
        _, moments = solid_of_one_kg(part["solid"])
        axes = [turned(part.get("orientation", [1, 0, 0, 0]), unit) for unit in ([1, 0, 0], [0, 1, 0], [0, 0, 1])]
        arm = plus(place, centre, -1)
        for i in range(3):
            for j in range(3):
                own = sum(moment * axis[i] * axis[j] for moment, axis in zip(moments, axes))
                inertia[i][j] += part["mass"] * (own + (dot(arm, arm) if i == j else 0) - arm[i] * arm[j])
    return mass, centre, inertia


MASS, CENTRE, INERTIA = mass_properties()
INVERSE = inverse(INERTIA)


def spin_of(q, momentum):
    """World axes, from L in the world, which no torque changes."""
    return turned(q, applied(INVERSE, turned(back(q), momentum)))


MOMENTUM = turned(BODY["orientation"], applied(INERTIA, turned(back(BODY["orientation"]), BODY["angular_velocity"])))


def orientations(steps_between):
    """At each step of the scene: the classical rule of Runge and Kutta, with so many steps between."""
    def rate(q):
        return [x / 2 for x in product([0, *spin_of(q, MOMENTUM)], q)]
    h, q = 1 / RATE / steps_between, list(BODY["orientation"])
    list_of_all = [q]
    for _ in range(STEPS):
        for _ in range(steps_between):
            first = rate(q)
            second = rate(plus(q, first, h / 2))
            third = rate(plus(q, second, h / 2))
            fourth = rate(plus(q, third, h))
            q = [x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(q, first, second, third, fourth)]
        list_of_all.append(q)
    return list_of_all


TURNED = orientations(8)
# Halving the step of a rule of fourth order takes 15/16 of the error away: what is left is below what was taken. The scene's rule of
# order eight errs less still, by far: its steps turn the body by 3 rad/s / 240. Each of its steps rounds some dozens of times.
ANGLE_ERROR = max(abs(a - b) for p, q in zip(TURNED, orientations(4)) for a, b in zip(p, q)) + 100 * STEPS * ROUNDING


def state_at(step):
    """Position of the centre of mass, orientation of the model, velocity and angular velocity: in each step of the fall the velocity
    grows first, by h g, and the position follows."""
    h, q = 1 / RATE, TURNED[step]
    velocity = plus(BODY["velocity"], GRAVITY, step * h)
    start = plus(BODY["position"], turned(BODY["orientation"], CENTRE))
    position = plus(plus(start, BODY["velocity"], step * h), GRAVITY, h * h * step * (step + 1) / 2)
    return position, q, velocity, spin_of(q, MOMENTUM)


def holdings(step):
    """Kinetic energy, momentum, angular momentum about the world's origin."""
    position, _, velocity, spin = state_at(step)
    momentum = [MASS * v for v in velocity]
    return MASS * dot(velocity, velocity) / 2 + dot(spin, MOMENTUM) / 2, momentum, plus(cross(position, momentum), MOMENTUM)


# --- What simulate says ------------------------------------------------------------------------------------------------------------

# A gnuplot that keeps what it should draw.
FAKE_GNUPLOT = f"""#!/bin/sh
cp ./*.tsv '{SCRATCH}/drawn' && printf '%s' "$*" >'{SCRATCH}/drawn/words' && echo '<svg></svg>' >figure.svg
"""


def run(scene, *options, path=None):
    (SCRATCH / "scene.json").write_text(json.dumps(scene))
    environment = {**os.environ, **({"PATH": f"{path}:{os.environ['PATH']}"} if path else {})}
    done = subprocess.run([SIMULATE, "scene.json", *options], cwd=SCRATCH, capture_output=True, text=True, env=environment)
    if done.returncode:
        raise AssertionError(f"simulate ended with {done.returncode}: {done.stderr}")
    return done.stdout


def recording(file):
    page = (SCRATCH / file).read_text()
    return json.loads(re.search(r'class="player-recording">(.*?)</script>', page, re.DOTALL)[1])


def table(file):
    with open(SCRATCH / "drawn" / file, newline="") as lines:
        return list(csv.reader(lines, delimiter="\t"))


class Numbers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        (SCRATCH / "fake").mkdir(parents=True)
        (SCRATCH / "drawn").mkdir()
        gnuplot = SCRATCH / "fake" / "gnuplot"
        gnuplot.write_text(FAKE_GNUPLOT)
        gnuplot.chmod(0o755)
        begun = time.monotonic()
        cls.said = run(SCENE, "--csv", "odd.csv", "--jsonl", "odd.jsonl", "--view", "odd.html", "--plot", "odd.svg", "--books",
                       "books.json", "--every", str(EVERY), path=SCRATCH / "fake")
        cls.took = time.monotonic() - begun
        with open(SCRATCH / "odd.csv", newline="") as lines:
            cls.rows = list(csv.DictReader(lines))
        cls.recording = recording("odd.html")
        cls.drawn = {file: table(file) for file in ("energy.tsv", "path1.tsv")}

    def near(self, values, expected, relative=0.0, angle=0.0, said=""):
        """`angle` is how far a unit vector may be turned; rounding is counted by steps."""
        size = max(1.0, *map(abs, expected))
        for value, wanted in zip(values, expected, strict=True):
            self.assertLessEqual(abs(value - wanted), size * (relative + 4 * angle + 8 * STEPS * ROUNDING), said)

    def near_orientation(self, value, expected, **tolerance):
        if dot(value, expected) < 0:
            value = [-x for x in value]
        self.near(value, expected, **tolerance)

    def test_csv(self):
        self.assertEqual(len(self.rows), STEPS // EVERY + 1)
        for n, row in enumerate(self.rows):
            vector = {name: [float(row[f"{name} {axis}{unit}"]) for axis in "xyz"] for name, unit in (
                ("position", " (m)"), ("orientation", ""), ("velocity", " (m/s)"), ("angular velocity", " (rad/s)"))}
            position, orientation, velocity, spin = state_at(n * EVERY)
            self.near([float(row["time (s)"])], [n * EVERY / RATE])
            self.assertEqual(row["body"], "odd")
            self.near(vector["position"], position)
            self.near_orientation([float(row["orientation w"]), *vector["orientation"]], orientation, angle=ANGLE_ERROR)
            self.near(vector["velocity"], velocity)
            self.near(vector["angular velocity"], spin, angle=ANGLE_ERROR * math.dist((0, 0, 0), spin))

    def test_the_times_of_float_are_those_of_double(self):
        times = []
        for precision in ("double", "float"):
            run(SCENE, "--dt", "0.001", "--until", "0.7", "--csv", "times.csv", "--books", "times.json", "--precision", precision)
            books = json.loads((SCRATCH / "times.json").read_text())
            rows = (SCRATCH / "times.csv").read_text().splitlines()
            times.append([books["time_step"], books["time"], *[row.split(",")[0] for row in rows]])
        self.assertEqual(*times)

    def test_a_bill_adds_up(self):
        many = {"mass": 1, "many": {"count": 400, "seed": 1, "velocity_between": [[1, 1, 1], [2, 2, 2]]}}
        said = run({"duration": 0.1, "bodies": [{"name": name, **many} for name in "ab"],
                    "effects": [{"kind": "quadratic_drag", "coefficient": 1e-9, "bodies": ["a"]}]}, "--bill")
        _, *rows = said[said.index("effect  "):].splitlines()

        def interval(text):
            number, rounding = float(text), 0.05 if "." in text else 0.5
            return [number - rounding, number + rounding]
        parts = [re.split(r"  +", row.strip()) for row in rows if row.endswith("%")]
        self.assertEqual(dict(row[:2] for row in parts)["quadratic drag"], "400")
        # What each body costs, times their number, is a part of all; and all parts are the whole.
        costs = [[int(bodies) * cost for cost in interval(each)] for _, bodies, each, _ in parts]
        shares = [interval(share.removesuffix(" %")) for *_, share in parts]
        least, most = (sum(cost[n] for cost in costs) for n in (0, 1))
        for cost, share in zip(costs, shares, strict=True):
            self.assertLessEqual(100 * cost[0] / most, share[1], said)
            self.assertLessEqual(share[0], 100 * cost[1] / max(least, 1e-300), said)
        self.assertLessEqual(sum(share[0] for share in shares), 100, said)
        self.assertLessEqual(100, sum(share[1] for share in shares), said)

    def test_json_lines_say_what_csv_says(self):
        lines = [json.loads(line) for line in (SCRATCH / "odd.jsonl").read_text().splitlines()]
        for line, row in zip(lines, self.rows, strict=True):
            numbers = [line["time"], *line["position"], *line["orientation"], *line["velocity"], *line["angular_velocity"]]
            self.assertEqual(numbers, [float(cell) for name, cell in row.items() if name != "body"])
            self.assertEqual(line["body"], row["body"])

    def test_frames_of_the_view(self):
        frames = self.recording["frames"]
        self.assertEqual(self.recording["seconds_between_frames"], EVERY / RATE)
        self.assertEqual(len(frames), STEPS // EVERY + 1)
        for n, frame in enumerate(frames):
            position, orientation, _, _ = state_at(n * EVERY)
            self.near(frame[:3], plus(position, turned(orientation, CENTRE), -1), relative=FLOAT_ROUNDING, angle=ANGLE_ERROR)
            self.near_orientation(frame[3:], orientation, relative=FLOAT_ROUNDING, angle=ANGLE_ERROR)

    def test_a_last_moment_that_comes_early_is_in_the_tables_and_the_plot_and_not_in_the_view(self):
        run(SCENE, "--csv", "early.csv", "--jsonl", "early.jsonl", "--plot", "early.svg", "--view", "early.html", "--every", "7",
            path=SCRATCH / "fake")
        self.assertEqual(len(recording("early.html")["frames"]), STEPS // 7 + 1)
        rows = [row.split(",") for row in (SCRATCH / "early.csv").read_text().splitlines()[1:]]
        lines = [json.loads(line) for line in (SCRATCH / "early.jsonl").read_text().splitlines()]
        for times in ([row[0] for row in rows], [line["time"] for line in lines], [row[0] for row in table("energy.tsv")[1:]]):
            self.near(map(float, times), [*(n * 7 / RATE for n in range(STEPS // 7 + 1)), STEPS / RATE])
        self.near([float(cell) for cell in table("path1.tsv")[-1]], [float(cell) for cell in rows[-1][2:4]])

    def test_parts_of_the_view(self):
        parts = self.recording["bodies"][0]["parts"]
        self.assertEqual([part.get("cone") or part.get("box") or part.get("sphere") for part in parts],
                         [[RADIUS, HEIGHT], [1, 2, 3], 1])
        for part, given in zip(parts, PARTS, strict=True):
            self.near(part["position"], given["position"], relative=FLOAT_ROUNDING)
            self.near(part["orientation"], given.get("orientation", [1, 0, 0, 0]), relative=FLOAT_ROUNDING)

    def test_a_view_is_called_as_its_scene_and_its_bodies_as_the_file_does(self):
        bodies = [{"name": "wall", "static": True}, {"name": "dust", "mass": 1, "many": {"count": 2, "seed": 1}}, {"name": "rock", "mass": 1}]
        run({"title": "A view", "description": "Of walls.", "duration": 0.1, "bodies": bodies}, "--view", "names.html")
        self.assertEqual(recording("names.html")["title"], "A view")
        self.assertEqual([body["name"] for body in recording("names.html")["bodies"]], ["wall", "dust", "dust", "rock"])

    def test_every_shape_of_a_view(self):
        mesh = {"shape": "mesh", "corners": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}
        shapes = [
            ({"shape": "sphere", "radius": 2}, {"sphere": 2}),
            ({"shape": "hollow_sphere", "radius": 2}, {"sphere": 2}),
            ({"shape": "spherical_shell", "inner_radius": 1, "outer_radius": 2}, {"sphere": 2}),
            ({"shape": "box", "size": [1, 2, 3]}, {"box": [1, 2, 3]}),
            ({"shape": "ellipsoid", "semi_axes": [1, 2, 3]}, {"ellipsoid": [1, 2, 3]}),
            ({"shape": "cylinder", "radius": 2, "height": 6}, {"cylinder": [2, 6]}),
            ({"shape": "cone", "radius": 2, "height": 5}, {"cone": [2, 5]}),
            ({"shape": "capsule", "radius": 2, "length": 5}, {"capsule": [2, 5]}),
            ({"shape": "thin_rod", "length": 200}, {"cylinder": [2, 200]}),  # as thick as a hundredth of it
            ({"shape": "thin_plate", "width": 1, "height": 2}, {"box": [1, 2, 0]}),
            (mesh, {"mesh": {"corners": mesh["corners"], "triangles": mesh["triangles"]}}),
        ]
        bodies = [{"name": f"body {n}", "solid": solid, "static": True} for n, (solid, _) in enumerate(shapes)]
        run({"duration": 0.1, "bodies": [*bodies, {"name": "point", "mass": 1}]}, "--view", "shapes.html")
        drawn = recording("shapes.html")["bodies"]
        for (_, expected), body in zip(shapes, drawn[:-1], strict=True):
            (part,) = body["parts"]
            self.assertEqual({key: part[key] for key in part if key not in ("position", "orientation")}, expected)
        self.assertEqual(drawn[-1]["parts"], [{"point": True}])

    def test_links_of_the_view(self):
        static = {"name": "wall", "static": True, "position": [10, 20, 30]}
        spring = {"kind": "spring", "bodies": ["odd"], "stiffness": 0, "anchor": ANCHOR}
        between = {"kind": "spring_between", "first": "wall", "second": "odd", "stiffness": 0, "attachment_second": ATTACHMENT}
        run({**SCENE, "bodies": [static, BODY], "effects": [{**spring, "attachment": ATTACHMENT}, spring, between]}, "--until", "0.1",
            "--view", "links.html")
        held, central, joining = recording("links.html")["links"]
        self.assertEqual(joining, {"from": {"body": 0, "point": [0, 0, 0]}, "to": {"body": 1, "point": ATTACHMENT}})
        self.assertEqual(held, {"from": {"body": 1, "point": ATTACHMENT}, "to": {"point": ANCHOR}})
        self.near(central["from"]["point"], CENTRE, relative=FLOAT_ROUNDING)
        self.near(recording("links.html")["frames"][0][7:10], BODY["position"], relative=FLOAT_ROUNDING)

    def test_plot(self):
        heading, *rows = self.drawn["energy.tsv"]
        self.assertEqual(heading, ["time (s)", "kinetic", "stored", "sum"])
        for n, row in enumerate(rows):
            position, *_ = state_at(n * EVERY)
            kinetic, stored = holdings(n * EVERY)[0], -MASS * dot(GRAVITY, position)
            self.near([float(cell) for cell in row], [n * EVERY / RATE, kinetic, stored, kinetic + stored], angle=ANGLE_ERROR)
        heading, *rows = self.drawn["path1.tsv"]  # it moves farther along x and along y than up and down
        self.assertEqual(heading, ["across", "odd"])
        for n, row in enumerate(rows):
            self.near([float(cell) for cell in row], state_at(n * EVERY)[0][:2])

    def test_a_plot_shows_the_two_axes_along_which_paths_reach_farthest(self):
        for across, up, *still in (0, 2), (1, 2), (0, 1), (0, 2, 2):  # along x alone it is x and z
            velocity = [float(axis in (across, up) and axis not in still) * (axis + 1) for axis in range(3)]
            body = {"name": "a", "mass": 1, "position": [3, 5, 7], "velocity": velocity}
            run({"title": "It's\nhere", "duration": 1, "bodies": [body]}, "--plot", "path.svg", path=SCRATCH / "fake")
            self.near([float(cell) for cell in table("path1.tsv")[-1]], [body["position"][axis] + velocity[axis] for axis in (across, up)])
            self.assertIn(f"paths=1; across='{'xyz'[across]}'; up='{'xyz'[up]}'; scene='It''s here'",
                          (SCRATCH / "drawn" / "words").read_text())

    def test_it_looks_for_these_axes_in_all_paths(self):
        moving = [{"name": "xyz"[axis], "mass": 1, "velocity": [speed * float(n == axis) for n in range(3)]}
                  for axis, speed in enumerate((1, 3, 2))]
        run({"duration": 1, "bodies": moving}, "--plot", "paths.svg", path=SCRATCH / "fake")
        self.assertIn("across='y'; up='z'", (SCRATCH / "drawn" / "words").read_text())
        for path, ends in enumerate(([0, 0], [3, 0], [0, 2]), 1):
            self.near([float(cell) for cell in table(f"path{path}.tsv")[-1]], ends)

    def test_a_plot_of_few_bodies_shows_all_and_one_of_many_six_at_equal_distances(self):
        for count, shown in (3, (0, 1, 2)), (6, (0, 1, 2, 3, 4, 5)), (13, (0, 2, 4, 6, 8, 10)), (17, (0, 2, 5, 8, 11, 14)):
            bodies = [{"name": f'a\n"body"\t{n}', "mass": 1, "position": [n, 0, 0]} for n in range(count)]
            run({"duration": 0.1, "bodies": bodies}, "--plot", "many.svg", path=SCRATCH / "fake")
            self.assertIn(f"paths={len(shown)};", (SCRATCH / "drawn" / "words").read_text())
            for path, body in enumerate(shown, 1):
                heading, first, *_ = table(f"path{path}.tsv")
                self.assertEqual((heading[1], float(first[0])), (f"a  body  {body}", body), f"{count} bodies")

    def test_a_terminal_shows_a_bar_which_no_failure_overwrites(self):
        ours, its = pty.openpty()
        with subprocess.Popen([SIMULATE, "everything", "--until", "0.1", "--csv", "full.csv", "--view", "bar.html"], cwd=SCRATCH, stdout=its,
                              stderr=its, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000))) as simulate:
            os.close(its)
            said = b""
            try:
                while part := os.read(ours, 4096):
                    said += part
            except OSError:
                pass  # so a terminal ends
        self.assertEqual(simulate.returncode, 3)
        said = said.decode().replace("\r\n", "\n")
        self.assertRegex(said, r"\n\r\[#\.{29}\]   4 %  step 1 of 24, .+ left\x1b\[K")
        self.assertRegex(said, r"\[K\nsimulate: .*/full\.csv is given up, and the other outputs go on: cannot write .*/full\.csv: the disk may be full\n")
        self.assertRegex(said, rf"\r\[{30 * '#'}\] 100 %  step 24 of 24, 0 s left\x1b\[K\n24 steps in ")

    def test_steps_are_counted_per_second(self):
        steps, seconds, rate = map(float, re.search(r"(\d+) steps in (\S+) s: (\S+) steps per second", self.said).groups())
        self.assertEqual(steps, STEPS)
        self.assertLessEqual(abs(rate * seconds / steps - 1), 0.006)  # three digits and four
        self.assertLessEqual(0.995 * seconds, self.took)

    def test_what_is_no_number_is_null_in_the_books(self):
        run({"duration": 0.1, "bodies": [{"name": "a", "mass": 1e20, "velocity": [1e150, 0, 0]}]}, "--books", "null.json")
        now = json.loads((SCRATCH / "null.json").read_text())["now"]
        self.assertEqual((now["energy"], now["momentum"]), (None, [1e170, 0, 0]))

    def test_books_say_how_many_bodies_there_are_and_how_they_are_stepped(self):
        bodies = [{"name": "a", "mass": 1, "many": {"count": 3, "seed": 1}}, {"name": "wall", "static": True}]
        for scheme, name in ("semi_implicit_euler", "semi-implicit Euler"), ("verlet", "Verlet"), ("suzuki", "Suzuki"):
            run({"duration": 0.1, "scheme": scheme, "bodies": bodies}, "--books", "many.json")
            books = json.loads((SCRATCH / "many.json").read_text())
            self.assertEqual((books["bodies"], books["scheme"]), (4, name))

    def test_books(self):
        books = json.loads((SCRATCH / "books.json").read_text())
        self.assertEqual((books["bodies"], books["steps"], books["turning_method"]), (1, STEPS, "splitting, Kahan-Li 8"))
        self.near([books["time_step"], books["time"]], [1 / RATE, STEPS / RATE])
        for key, step in (("at_the_start", 0), ("now", STEPS)):
            energy, momentum, angular_momentum = holdings(step)
            self.near([books[key]["energy"]], [energy], angle=ANGLE_ERROR)
            self.near(books[key]["momentum"], momentum)
            self.near(books[key]["angular_momentum"], angular_momentum, angle=ANGLE_ERROR)
        for key, step in (("stored_at_the_start", 0), ("stored_now", STEPS)):
            self.near([books[key]], [-MASS * dot(GRAVITY, state_at(step)[0])])
        time = STEPS / RATE
        pull = [MASS * g for g in GRAVITY]
        mean_velocity = plus(BODY["velocity"], GRAVITY, time / 2)
        gravity = next(line for line in books["effects"] if line["name"] == 'a "pull"')
        self.near(gravity["momentum"], [time * f for f in pull])
        self.near([gravity["energy"]], [time * dot(pull, mean_velocity)])
        # Each kick of h m g acts where the body is before it moves.
        kicks = [cross(state_at(step)[0], pull) for step in range(STEPS)]
        self.near(gravity["angular_momentum"], [sum(kick[n] for kick in kicks) / RATE for n in range(3)])
        self.near([books["unexplained"]["energy"] / holdings(STEPS)[0]], [0])
        self.near([x / 1000 for x in books["unexplained"]["angular_momentum"]], [0, 0, 0])  # L is some 1000 kg m^2/s
        printed = next(line for line in self.said.splitlines() if line.startswith("now "))
        energy, momentum, angular_momentum = holdings(STEPS)
        self.assertEqual(printed.split()[1:], [f"{x:.3g}" for x in (energy, *momentum, *angular_momentum)])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
