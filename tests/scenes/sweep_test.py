"""sweep_test.py SIMULATE SCRATCH: a sweep simulates every combination once, whole or in shards, however often it is stopped."""
import itertools
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

SIMULATE, SCRATCH = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
ROOT = pathlib.Path(__file__).resolve().parents[2]
SWEEP, SCENES = ROOT / "tools" / "sweep.py", ROOT / "tools" / "scenes"
sys.path.insert(0, str(ROOT / "exercises" / "tools"))
from shards import Job, Part  # noqa: E402

TOPS = {"duration": 0.1, "bodies": [{"name": "top", "mass": 1, "inertia": [1, 2, 2.5],
        "many": {"count": 3, "seed": 4, "angular_velocity_between": [[1, 1, 1], [2, 2, 2]]}}]}
METHODS, STEPS, SEEDS = ["splitting", "axis_by_axis"], [0.02, 0.01], [0, 1, 2]
EULER = "semi-implicit Euler"  # what steps a scene that asks for no scheme
SPEC = {"scenes": ["tops.json", "t_handle"], "methods": METHODS, "time_steps": STEPS, "seeds": SEEDS, "until": 0.1}

# A simulate that takes its time, and says so in a list of the runs that it began.
SLOW = """#!/bin/sh
case "$*" in *--plan*) ;; *) echo "$*" | sed 's| --books.*||' >>"$0.begun"; sleep 0.2 ;; esac
exec '{simulate}' "$@"
"""


def is_running(pid):
    try:
        return pathlib.Path("/proc", str(pid), "stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


class Sweep(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        SCRATCH.mkdir(parents=True)
        self.write("tops.json", TOPS)
        self.write("sweep.json", SPEC)

    def write(self, name, content):
        (SCRATCH / name).write_text(json.dumps(content))

    def words(self, *words, simulate=SIMULATE):
        return [sys.executable, "-B", str(SWEEP), "--simulate", str(simulate), *words]

    def sweep(self, *words, code=0, simulate=SIMULATE):
        done = subprocess.run(self.words(*words, simulate=simulate), cwd=SCRATCH, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout if code == 0 else done.stderr

    def slow(self):
        program = SCRATCH / "slow"
        program.write_text(SLOW.format(simulate=SIMULATE))
        program.chmod(0o755)
        return program

    def test_every_combination_has_a_row(self):
        head, *rows = [line.split("\t") for line in self.sweep("sweep.json").splitlines()]
        self.assertEqual(head[:6], ["scene", "method", "scheme", "precision", "time step (s)", "seed"])
        steps = [str(step) for step in STEPS]
        expected = [["tops.json", method, EULER, "double", step, str(seed)]
                    for method, step, seed in itertools.product(METHODS, steps, SEEDS)]
        expected += [["t_handle", method, EULER, "double", step, ""] for method, step in itertools.product(METHODS, steps)]
        self.assertEqual([row[:6] for row in rows], expected)
        self.assertEqual({row[head.index("ended")] for row in rows}, {"well"})
        self.assertEqual([row[head.index("steps")] for row in rows[:6]], ["5"] * 3 + ["10"] * 3)
        self.assertFalse(list(SCRATCH.glob("*.part*")))

    def test_a_row_holds_what_the_books_of_its_run_say(self):
        head, *rows = [line.split("\t") for line in self.sweep("sweep.json").splitlines()]
        row = dict(zip(head, rows[4]))  # splitting, 0.01 s, the second seed
        subprocess.run([SIMULATE, "tops.json", "--method", "splitting", "--dt", "0.01", "--seed", "1", "--until", "0.1", "--books",
                        "books.json"], cwd=SCRATCH, check=True, stdout=subprocess.DEVNULL)
        books = json.loads((SCRATCH / "books.json").read_text())
        turning = next(line for line in books["effects"] if line["name"] == "tumbling: splitting")
        self.assertEqual(float(row["energy at the start (J)"]), books["at_the_start"]["energy"])
        self.assertEqual(float(row["energy at the end (J)"]), books["now"]["energy"])
        self.assertEqual(float(row["energy from turning (J)"]), turning["energy"])
        self.assertNotEqual(turning["energy"], 0)
        self.assertEqual(float(row["unexplained energy (J)"]), books["unexplained"]["energy"])

    def test_a_scheme_is_that_of_its_row(self):
        self.write("sweep.json", {"scenes": ["orbit"], "schemes": ["suzuki", "verlet"], "until": 1})
        head, *rows = [line.split("\t") for line in self.sweep("sweep.json").splitlines()]
        self.assertEqual([row[head.index("scheme")] for row in rows], ["suzuki", "verlet"])
        for row in rows:
            scheme = row[head.index("scheme")]
            subprocess.run([SIMULATE, SCENES / "orbit.json", "--scheme", scheme, "--until", "1", "--books", "books.json"],
                           cwd=SCRATCH, check=True, stdout=subprocess.DEVNULL)
            books = json.loads((SCRATCH / "books.json").read_text())
            energy = books["now"]["energy"] + books["stored_now"]
            self.assertEqual(float(row[head.index("energy at the end (J)")]), energy)
            self.assertEqual(books["scheme"].lower(), scheme)
        self.assertNotEqual(*(row[head.index("energy at the end (J)")] for row in rows))

    def test_two_shards_of_which_one_was_stopped_give_the_table_of_one_run_to_the_byte(self):
        whole = self.sweep("sweep.json", "--jobs", "1")
        self.sweep("sweep.json", "--shard", "2/2", "--jobs", "3")
        program, part, other = self.slow(), SCRATCH / "sweep.1-of-2.part", "sweep.2-of-2.part"
        running = subprocess.Popen(self.words("sweep.json", "--shard", "1/2", "--jobs", "1", simulate=program), cwd=SCRATCH,
                                   stderr=subprocess.DEVNULL)
        while not part.exists() or part.read_bytes().count(b'"result"') < 2:  # the signal may undo the line that was just written
            self.assertIsNone(running.poll())
            time.sleep(0.01)
        running.terminate()
        self.assertEqual(running.wait(), 128 + signal.SIGTERM)
        self.assertIn("--resume takes it up", self.sweep("sweep.json", "--shard", "1/2", code=2))
        self.assertIn("have no row yet", self.sweep("merge", part.name, other, code=2))
        self.sweep("sweep.json", "--shard", "1/2", "--resume", simulate=program)
        self.assertEqual(self.sweep("merge", other, part.name), whole)
        begun = (SCRATCH / "slow.begun").read_text().splitlines()
        self.assertEqual(len(set(begun)), 8)  # of 16 combinations, this shard's
        self.assertLessEqual(len(begun), 9)  # only what was interrupted is done again
        for table, words in (("merged.tsv", ["merge", part.name, other]), ("whole.tsv", ["sweep.json"])):
            self.sweep(*words, "--output", table, "--digits", "3")
        self.assertEqual((SCRATCH / "merged.tsv").read_bytes(), (SCRATCH / "whole.tsv").read_bytes())

    def test_a_scene_that_changes_meanwhile_ends_the_sweep(self):
        program = SCRATCH / "slow"
        program.write_text(f"#!/bin/sh\ncase \"$*\" in *--plan*) ;; *) echo ' ' >>'{SCRATCH}/tops.json' ;; esac\nexec '{SIMULATE}' \"$@\"\n")
        program.chmod(0o755)
        self.assertIn("a scene has changed since the sweep began", self.sweep("sweep.json", "--jobs", "1", simulate=program, code=2))
        self.assertIn("belongs to another job", self.sweep("sweep.json", "--resume", code=2))

    def test_the_table_goes_over_nothing_that_is_read(self):
        for number in (1, 2):
            self.sweep("sweep.json", "--shard", f"{number}/2", "--part", f"{number}.part")
        os.link(SCRATCH / "tops.json", SCRATCH / "hard.json")
        os.symlink("sweep.json", SCRATCH / "soft.json")
        os.symlink("new.part", SCRATCH / "soon")
        before = {path.name: path.read_bytes() for path in SCRATCH.iterdir() if path.exists()}
        for what, output, words in (("the sweep itself", "sweep.json", ["sweep.json"]), ("the sweep itself", "soft.json", ["sweep.json"]),
                                    ("the scene tops.json", "./tops.json", ["sweep.json"]),
                                    ("the scene tops.json", "hard.json", ["sweep.json"]),
                                    ("where its results are kept", "sweep.part", ["sweep.json"]),
                                    ("where its results are kept", "soon", ["sweep.json", "--part", "new.part"]),
                                    ("one of the parts", str(SCRATCH / "2.part"), ["merge", "1.part", "2.part"])):
            with self.subTest(output):
                self.assertIn(f"that is {what}, and it would be overwritten", self.sweep(*words, "--output", output, code=2))
        with open(SCRATCH / "log", "wb") as log:
            log.write(b"before")
            log.flush()
            done = subprocess.run(self.words("sweep.json", "--output", "/dev/stdout"), cwd=SCRATCH, stdout=log, stderr=subprocess.PIPE)
        self.assertEqual((done.returncode, (SCRATCH / "log").read_bytes()), (2, b"before"))
        self.assertIn(b"what is printed goes there already", done.stderr)
        (SCRATCH / "log").unlink()
        self.assertEqual({path.name: path.read_bytes() for path in SCRATCH.iterdir() if path.exists()}, before)

    def test_a_device_a_pipe_and_a_link_stay_what_they_are(self):
        table = self.sweep("sweep.json")
        os.mkfifo(SCRATCH / "pipe")
        os.symlink("/dev/full", SCRATCH / "full")
        os.symlink("there.tsv", SCRATCH / "link.tsv")
        reader = subprocess.Popen(["cat", "pipe"], cwd=SCRATCH, stdout=subprocess.PIPE, text=True)
        self.sweep("sweep.json", "--output", "pipe")
        self.assertEqual(reader.communicate()[0], table)
        self.assertTrue((SCRATCH / "pipe").is_fifo())
        self.assertIn("full can't be written: No space left on device", self.sweep("sweep.json", "--output", "full", code=2))
        self.assertTrue((SCRATCH / "full").is_symlink())
        self.sweep("sweep.json", "--resume", "--output", "link.tsv")
        self.assertTrue((SCRATCH / "link.tsv").is_symlink())
        self.assertEqual((SCRATCH / "there.tsv").read_text(), table)

    def test_a_table_that_has_no_place_is_told_before_anything_is_simulated(self):
        for output in ("", ".", "..", str(SCRATCH), "n" * 300, "tops.json/table"):
            with self.subTest(output):
                self.assertIn("can't be written: ", self.sweep("sweep.json", "--output", output, code=2))
        self.assertEqual(sorted(path.name for path in SCRATCH.iterdir()), ["sweep.json", "tops.json"])

    def test_what_other_work_has_kept_is_no_table(self):
        with Part(SCRATCH / "grades.part", Job({}, ["ada"])) as part:
            part.add("ada", {"points": 1})
        self.assertIn("what is kept for ada is no row of a sweep's table", self.sweep("merge", "grades.part", code=2))

    def test_closed_outputs_lose_nothing(self):
        def run(words, redirections):
            return subprocess.run(["sh", "-c", f'"$@" {redirections}', "sh", *self.words(*words)], cwd=SCRATCH,
                                  capture_output=True, text=True)
        table = self.sweep("sweep.json")
        done = run(["sweep.json"], ">&-")
        self.assertEqual((done.returncode, done.stderr),
                         (2, "course: the standard output is closed; --output names a file for the table\n"))
        done = run(["sweep.json"], "2>&-")
        self.assertEqual((done.returncode, done.stdout), (0, table))
        done = run(["sweep.json"], "2>/dev/full")  # a log on a full disk
        self.assertEqual((done.returncode, done.stdout), (0, table))
        done = run(["sweep.json"], ">sweep.part")
        self.assertEqual((done.returncode, done.stderr),
                         (2, "course: what is printed goes to sweep.part, where results are kept, and would be lost with it\n"))
        (SCRATCH / "sweep.part").unlink()
        done = run(["sweep.json", "--output", "table.tsv"], "<&- >&- 2>&-")
        self.assertEqual((done.returncode, (SCRATCH / "table.tsv").read_text()), (0, table))
        done = run(["--help"], ">/dev/full")
        self.assertEqual((done.returncode, done.stderr), (2, "course: the standard output can't be written: No space left on device\n"))
        self.assertTrue(run(["--help"], "").stdout.startswith("usage: ./course sweep FILE [OPTION...] | merge PART..."))
        done = run(["sweep.json"], ">/dev/full")
        self.assertEqual(done.returncode, 2)
        self.assertTrue(done.stderr.endswith("course: the standard output can't be written: No space left on device\n"), done.stderr)
        self.assertEqual(self.sweep("sweep.json", "--resume"), table)

    def test_a_signal_ends_all_that_runs(self):
        self.write("sweep.json", {**SPEC, "seeds": list(range(16))})
        for plan in ("exit 0", f"echo $$ >>'{SCRATCH}/running'; exec sleep 60"):  # while it simulates, and before
            program, pids = SCRATCH / "idle", SCRATCH / "running"
            program.write_text("#!/bin/sh\ncase \"$*\" in *--plan*) " + plan + f" ;; esac\necho $$ >>'{pids}'\nexec sleep 60\n")
            program.chmod(0o755)
            for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL):
                pids.write_text("")
                running = subprocess.Popen(self.words("sweep.json", "--jobs", "16", simulate=program), cwd=SCRATCH,
                                           stderr=subprocess.PIPE, text=True)
                while len(pids.read_text().splitlines()) < (16 if plan == "exit 0" else 1):
                    self.assertIsNone(running.poll())
                    time.sleep(0.01)
                running.send_signal(number)
                errors = running.communicate(timeout=50)[1]  # the simulations themselves would take longer
                self.assertEqual((running.returncode, errors), (-9, "") if number == signal.SIGKILL else
                                 (128 + number, "\ncourse: stopped; --resume takes it up\n"))
                deadline = time.monotonic() + 50
                for pid in pids.read_text().splitlines():
                    while is_running(int(pid)):
                        self.assertLess(time.monotonic(), deadline, pid)

    def test_a_run_that_fails_is_tried_again_and_is_no_row(self):
        broken = SCRATCH / "broken"
        broken.write_text("#!/bin/sh\ncase \"$*\" in *--plan*) exit 0 ;; *'--dt 0.02 --seed 1 '*) echo simulate: no memory >&2; exit 4 ;; "
                          f"esac\nexec '{SIMULATE}' \"$@\"\n")
        broken.chmod(0o755)
        errors = self.sweep("sweep.json", code=1, simulate=broken)
        self.assertEqual(errors.count("failed twice: RuntimeError: no memory"), 2)
        self.sweep("sweep.json", "--resume", "--output", "table.tsv")
        self.assertEqual((SCRATCH / "table.tsv").read_text(), self.sweep("sweep.json"))

    def test_a_step_that_can_not_be_taken_is_a_row(self):
        self.write("crash.json", {"duration": 9, "step": {"nanoseconds": 250000000}, "bodies": [
            {"name": "comet", "mass": 1, "position": [2, 0, 0], "velocity": [-4, 0, 0]}],
            "effects": [{"kind": "point_gravity", "strength": 1e-200}]})
        self.write("sweep.json", {"scenes": ["crash.json"]})
        row = self.sweep("sweep.json").splitlines()[1].split("\t")
        self.assertEqual(row[7], "2")
        self.assertTrue(row[-1].startswith("'comet' at 0.5 s (step 2): point gravity gives a force of"), row[-1])

    def test_the_table_holds_plain_text(self):
        self.write("a\x1b[31m\tb.json", TOPS)
        self.write("sweep.json", {**SPEC, "scenes": ["a\x1b[31m\tb.json"]})
        self.assertEqual({line.split("\t")[0] for line in self.sweep("sweep.json").splitlines()[1:]}, {r"a\x1b[31m b.json"})

    def test_mistakes_are_told_before_anything_is_simulated(self):
        (SCRATCH / "deep.json").write_text('{"bodies": ' + "[" * 5000 + "]" * 5000 + "}")
        for change, complaint in (
                ({"scenes": []}, "scenes must be a list with at least one element"),
                ({"scenes": ["nowhere"]}, "no scene and no file is called nowhere"),
                ({"methods": ["spliting"]}, "no method is called spliting; did you mean splitting?"),
                ({"schemes": ["verlett"]}, "no scheme is called verlett; did you mean verlet?"),
                ({"time_steps": [0.01, 0.01]}, "0.01 stands in time_steps twice"),
                ({"time_steps": [0.01, 0.02, 0.0100000000001]},
                 "0.01 and 0.0100000000001 in time_steps are the same number of nanoseconds"),
                ({"time_steps": [0]}, "an element of time_steps is 0; it must be a number greater than 0"),
                ({"time_steps": [1]}, "that is less than half a step of 1 s"),
                ({"seeds": [1.5]}, "1.5 stands in seeds, where it can't"),
                ({"seeds": list(range(1000001))}, "seeds has 1000001 elements; at most 1000000 combinations can be simulated"),
                ({"until": "1"}, 'until is "1"; it must be a number'),
                ({"scenes": ["a\x1b[2Jb\x9b"]}, r"no scene and no file is called a\x1b[2Jb\x9b"),
                ({"methods": ["\x1b[31m"]}, r"no method is called \x1b[31m"),
                ({"seeds": list(range(1001)), "time_steps": list(range(1, 1001))},
                 "stands for 4004000 combinations; at most 1000000 can be simulated"),
                ({"scenes": ["n" * 300]}, "no scene and no file is called nnn"),
                ({"scenes": ["caf\u00e9"]}, "no scene and no file is called caf\u00e9"),
                ({"scenes": ["/proc/self/mem"]}, "can't be read: Input/output error"),  # a file that can't be read, not even by root
                ({"scenes": ["deep.json"]}, "deep.json"),
                ({"methods": ["a\0b"]}, "can't be run: embedded null byte"),
                ({"methods": ["\u00e9"]}, "no method is called \u00e9"),
                ({"seeds": [10**400]}, f"an element of seeds is 1{'0' * 76}...; it must be a number"),
                ({"time_steps": [10**400]}, "an element of time_steps is 1"),
                ({"until": 10**400}, "until is 1"),
                ({"until": -10**400}, "until is -1"),
                ({"until": float("nan")}, "until is NaN"),
                ({"colour": ["red"]}, "colour is no key of a sweep")):
            with self.subTest(complaint):
                self.write("sweep.json", {**SPEC, **change})
                self.assertIn(complaint, self.sweep("sweep.json", code=2))
        for text, complaint in (("[" * 10**6 + "]" * 10**6, "nested too deeply"), ("9" * 5000, "the number 99999999999999999999... has 5000 digits"),
                                ('{"scenes": ["t_handle"], "scenes": ["rain"]}', 'sweep.json: the key "scenes" stands there twice')):
            with self.subTest(complaint):
                (SCRATCH / "sweep.json").write_text(text)
                self.assertIn(complaint, self.sweep("sweep.json", code=2))
        (SCRATCH / "deep.json").unlink()
        self.write("sweep.json", SPEC)
        self.assertIn("nowhere/simulate can't be run", self.sweep("sweep.json", code=2, simulate="nowhere/simulate"))
        for words, complaint in ((["sweep.json", "--part", "/dev/full"], "/dev/full is no part of a job: it is no file"),
                                 (["merge", "/dev/zero"], "/dev/zero is no part of a job: it is no file"),
                                 (["merge", "a", "--shard", "1/2"], "--shard is for a sweep"),
                                 (["merge", "a", "--jobs", "0"], "--jobs is for a sweep"),
                                 (["merge", "a", "--part", "b"], "--part is for a sweep"),
                                 (["merge", "a", "--resume"], "--resume is for a sweep"),
                                 (["/dev/zero"], "/dev/zero: it is larger than 64 MB"),
                                 (["sweep.json", "--shard", "4/3"], "the shard is 4/3"), (["none.json"], "none.json can't be read"),
                                 (["sweep.json", "--output", "nowhere/table"], "nowhere/table can't be written"),
                                 (["sweep.json", "--part", "nowhere/part"], "nowhere/part can't be written"),
                                 (["sweep.json", "extra"], "one word too many: extra")):
            with self.subTest(complaint):
                self.assertIn(complaint, self.sweep(*words, code=2))
        self.assertEqual(sorted(path.name for path in SCRATCH.iterdir()), ["sweep.json", "tops.json"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
