"""A class of a thousand, over shards that are stopped, killed and taken up again: nobody is lost, nobody is graded twice.

What takes time, the grading of one submission, is a stand-in here that looks at one line of the header; the last test uses the real one.
"""

import collections
import csv
import io
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import types
import unittest
from pathlib import Path
from unittest import mock

import grade
import grade_class
from catalogue import find, read_catalogue
from complaint import Complaint
from fixture import ROOT, TOOLCHAIN
from grading import Grading
from shards import Job, Part, job_of_part, merge
from starter import starter_of
from untrusted import require_out_of_reach
from wrong_answers import read_wrong_answers

TOOLS = ROOT / "exercises" / "tools"
# Whoever is graded is noted in the log. The header's first line says how it goes.
STAND_IN = """
import json, os, sys, time
task = json.load(sys.stdin)
name = os.fsencode(os.path.basename(task["submission"])).hex()
with open(os.path.join(task["submission"], "doubled.hpp"), encoding="utf-8") as file:
    word = file.readline().split()[1]
log = os.open(LOG, os.O_WRONLY | os.O_APPEND | os.O_CREAT)
os.write(log, f"{name}\\n".encode())
if word == "waits":
    os.write(log, f"waits {os.getpid()}\\n".encode())
    while os.path.exists(LOG + ".wait"):
        time.sleep(0.01)
if word == "breaks" or (word == "stumbles" and open(LOG).read().split().count(name) == 1):
    sys.exit("no \\x1b[31mcompiler\\ncourse: ada has no result")
points = 0 if word in ("waits", "breaks", "stumbles") else int(word)
checks = [{"sentence": "Twice two is four", "points": points, "of": 2, "status": "passed" if points == 2 else "failed",
           "message": f"\\x1b[2J {name} \\u2028"},
          {"sentence": "Half of two is one", "points": 1, "of": 1, "status": "passed", "message": ""}]
json.dump({"submission": "never asked", "seconds": time.time(), "exercises": [
    {"exercise": task["exercises"][0], "title": "Twice", "reason": "", "flags": ["is \\x07 loud"][:points], "checks": checks}]}, sys.stdout)
"""
RUNNER = """
import errno, os, sys
sys.path.insert(0, TOOLS)
import grade, grade_class
if name := os.environ.get("UNREADABLE"):
    import submission
    bytes_of = submission._bytes_of
    def fails(folder, place):
        if folder.name == name:
            raise OSError(errno.EIO, "the disk fails")
        return bytes_of(folder, place)
    submission._bytes_of = fails
grade_class.GRADE_ONE = [sys.executable, "-I", "-S", "-B", "-c", "LOG = " + repr(LOG) + STAND_IN]
sys.exit(grade.main(sys.argv[1:]))
"""


class AClassOfStandIns(Grading):
    def setUp(self):
        super().setUp()
        self.place = self.root / "results"
        self.place.mkdir()
        self.log = self.root / "log"
        self.log.touch()
        text = f"TOOLS, LOG, STAND_IN = {str(TOOLS)!r}, {str(self.log)!r}, {STAND_IN!r}\n" + RUNNER
        self.runner = self.root / "runner.py"
        self.runner.write_text(text, encoding="utf-8")

    def names(self):
        return sorted(os.listdir(self.submissions))

    def begin(self, *options, folders=None, inside=None, unreadable=""):
        folders = [] if "merge" in options[:1] else sorted(self.submissions.iterdir()) if folders is None else folders
        process = subprocess.Popen([sys.executable, "-B", str(self.runner), "--root", str(self.root), "--toolchain",
                                    str(self.toolchain_file), *map(str, options), *map(str, folders)], cwd=inside or self.place,
                                   env={**os.environ, "UNREADABLE": unreadable},
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.kill)
        return process

    def run_to_the_end(self, *options, code=0, **others):
        """What it prints, and what it says besides."""
        process = self.begin(*options, **others)
        printed, said = process.communicate(timeout=600)
        self.assertEqual(process.returncode, code, said.decode())
        return printed, said.decode()

    def graded_in_turn(self):
        return [os.fsdecode(bytes.fromhex(line)) for line in self.log.read_text(encoding="ascii").split("\n") if line and " " not in line]

    def graded_so_far(self):
        return collections.Counter(self.graded_in_turn())

    def wait_until(self, condition):
        deadline = time.monotonic() + 300
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def results_in(self, part):
        return part.read_bytes().count(b'"result"') if part.exists() else 0


class AThousand(AClassOfStandIns):
    def test_over_eight_shards_two_of_them_killed_nobody_is_lost_and_nobody_counts_twice(self):
        for number in range(1000):
            name = {0: "merge", 1: "line\nend", 2: os.fsdecode(b"caf\xe9"), 3: "caf\u00e9", 4: "--jobs", 5: "=1+1"}.get(number)
            self.hand_in(name or f"student{number // 2}@{number % 2}", f"// {number % 3}\n")
        parts = [self.place / f"grade.{number}_of_8.part" for number in range(1, 9)]
        shards = [self.begin("--shard", f"{number}/8", "--jobs", "2") for number in range(1, 9)]
        for number, how in ((3, signal.SIGKILL), (6, signal.SIGTERM)):
            self.wait_until(lambda: self.results_in(parts[number - 1]) >= 10)
            shards[number - 1].send_signal(how)
        codes = []
        for shard in shards:
            shard.communicate(timeout=600)
            codes.append(shard.returncode)
        self.assertEqual(codes, [0, 0, -signal.SIGKILL, 0, 0, 128 + signal.SIGTERM, 0, 0])
        done = [self.results_in(part) for part in parts]
        self.assertTrue(9 <= done[2] < 125 and 9 <= done[5] < 125, done)  # the signal may undo the line that was just written
        missing = 250 - done[2] - done[5]
        _, said = self.run_to_the_end("merge", *parts, "--marks", "marks.csv", code=3)
        self.assertIn(f"{missing} submissions have no result", said)
        self.assertFalse((self.place / "marks.csv").exists())

        for number in (3, 6):
            self.run_to_the_end("--shard", f"{number}/8", "--resume", "--jobs", "2")
        times = self.graded_so_far()
        self.assertEqual(set(times), set(self.names()))
        again = sum(times.values()) - 1000
        self.assertLessEqual(again, 4, times.most_common(6))  # what two runs of two jobs were at when they were ended

        self.run_to_the_end("--part", "whole", "--format", "json", "--output", "whole.json", "--marks", "whole.csv")
        self.run_to_the_end("merge", *reversed(parts), "--format", "json", "--output", "merged.json", "--marks", "merged.csv")
        for kind in ("json", "csv"):
            self.assertEqual((self.place / f"merged.{kind}").read_bytes(), (self.place / f"whole.{kind}").read_bytes())
        for form in ("text", "junit"):
            merged, whole = (self.run_to_the_end("merge", *files, "--format", form) for files in (parts, ["whole"]))
            self.assertEqual(merged, whole)
        with open(self.place / "merged.csv", newline="", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual(len({row["submission"] for row in rows}), 1000)
        by_name = {row["submission"]: int(row["points"]) for row in rows}
        for number in range(6, 1000):
            self.assertEqual(by_name[f"student{number // 2}@{number % 2}"], number % 3 + 1)
        self.assertIn("caf\\xe9", by_name)
        self.run_to_the_end("merge", *parts, "--keep", "best", "--marks", "best.csv")
        with open(self.place / "best.csv", newline="", encoding="utf-8") as table:
            self.assertEqual(len(list(csv.DictReader(table))), 497 + 6)


class NothingLost(AClassOfStandIns):
    def hand_in_all(self, **words):
        for name, word in words.items():
            self.hand_in(name, f"// {word}\n")

    def test_a_run_that_is_stopped_keeps_what_it_has_and_is_taken_up(self):
        self.hand_in_all(ada=2, bob=1, eve="waits", fay=0)
        wait = Path(f"{self.log}.wait")
        wait.touch()
        process = self.begin("--jobs", "1", "--marks", "marks.csv")
        self.wait_until(lambda: "waits " in self.log.read_text(encoding="ascii"))
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + signal.SIGINT)
        self.assertIn("2 of 4 results are kept in grade.part; the same command with --resume goes on.", said.decode())
        stand_in, = [int(line.split()[1]) for line in self.log.read_text(encoding="ascii").split("\n") if line.startswith("waits ")]
        self.assertRaises(ProcessLookupError, os.kill, stand_in, 0)
        self.assertEqual([file.name for file in self.place.iterdir()], ["grade.part"])
        wait.unlink()
        _, said = self.run_to_the_end(code=2)
        self.assertIn("grade.part is there already, with 2 of 4 results; --resume takes it up", said)
        self.run_to_the_end("--resume", "--marks", "marks.csv")
        self.assertEqual(self.graded_so_far(), {"ada": 1, "bob": 1, "eve": 2, "fay": 1})
        self.assertEqual([file.name for file in self.place.iterdir()], ["marks.csv"])

    def test_whoever_was_being_graded_when_a_run_was_ended_comes_last(self):
        self.hand_in_all(ada="waits", bob="waits", eve=1, fay=2)
        wait = Path(f"{self.log}.wait")
        wait.touch()
        for how, name in ((signal.SIGKILL, "ada"), (signal.SIGTERM, "bob")):
            process = self.begin("--jobs", "1", "--resume")
            self.wait_until(lambda: self.graded_in_turn()[-1:] == [name])
            process.send_signal(how)
            process.communicate(timeout=60)
        self.assertEqual(self.graded_in_turn(), ["ada", "bob"])
        process = self.begin("--jobs", "1", "--resume")
        self.wait_until(lambda: len(self.graded_in_turn()) == 5)
        wait.unlink()
        process.communicate(timeout=60)
        self.assertEqual(self.graded_in_turn(), ["ada", "bob", "eve", "fay", "ada", "bob"])

    def test_who_needs_more_than_a_submission_may_take_is_tried_last_and_has_no_result(self):
        self.hand_in_all(ada="waits", bob=1, eve=2)
        Path(f"{self.log}.wait").touch()
        _, said = self.run_to_the_end("--jobs", "1", "--budget", "15", code=3)
        self.assertIn("course: ada has no result: GraderFailed: it took more than 15 seconds by the clock", said)
        self.assertEqual(self.graded_in_turn(), ["ada", "bob", "eve", "ada"])
        _, said = self.run_to_the_end("--budget", "nan", code=2)
        self.assertIn("budget is nan seconds; it must be greater than 0", said)

    def test_a_failure_of_the_grader_is_tried_again_and_is_never_0_points(self):
        self.hand_in_all(ada=2, bob="breaks", eve="stumbles")
        (self.place / "marks.csv").write_text("of last week", encoding="utf-8")
        printed, said = self.run_to_the_end("--marks", "marks.csv", code=3)
        self.assertEqual(printed, b"")
        self.assertIn("course: bob has no result: GraderFailed: no \\x1b[31mcompiler\n| course: ada has no result\n", said)
        self.assertIn("1 submissions have no result, which is not 0 points", said)
        self.assertEqual(self.graded_so_far(), {"ada": 1, "bob": 2, "eve": 2})
        self.assertEqual((self.place / "marks.csv").read_text(encoding="utf-8"), "of last week")
        printed, _ = self.run_to_the_end("--resume", "--incomplete", "--format", "json", code=3)
        self.assertEqual([result["submission"] for result in json.loads(printed)], ["ada", "eve"])
        self.assertEqual(self.graded_so_far(), {"ada": 1, "bob": 4, "eve": 2})
        (self.submissions / "bob" / "doubled.hpp").write_text("// 1\n", encoding="utf-8")
        printed, _ = self.run_to_the_end("--resume", "--format", "json")
        self.assertEqual([result["points"] for result in json.loads(printed)], [3, 2, 1])
        self.assertEqual(list(self.place.iterdir()), [self.place / "marks.csv"])

    def test_what_was_handed_in_once_more_is_graded_once_more(self):
        self.hand_in_all(ada=2, bob=1, eve="breaks")
        self.run_to_the_end(code=3)
        for name in ("bob", "eve"):
            (self.submissions / name / "doubled.hpp").write_text("// 0\n", encoding="utf-8")
        printed, _ = self.run_to_the_end("--resume", "--format", "json")
        self.assertEqual([result["points"] for result in json.loads(printed)], [3, 1, 1])
        self.assertEqual(self.graded_so_far(), {"ada": 1, "bob": 2, "eve": 3})

    def test_what_was_handed_in_once_more_and_has_no_result_has_none_when_merged(self):
        self.hand_in_all(ada=2, bob=1)
        self.run_to_the_end("--part", "kept")
        (self.submissions / "bob" / "doubled.hpp").write_text("// breaks\n", encoding="utf-8")
        self.run_to_the_end("--part", "kept", "--resume", code=3)
        _, said = self.run_to_the_end("merge", "kept", code=3)
        self.assertIn("bob has no result", said)

    def test_nobody_takes_up_what_is_about_to_be_removed(self):
        self.hand_in_all(ada=2, bob=1)
        write = grade.write_outputs

        def tries(*words):
            with self.assertRaisesRegex(Complaint, "being written by another run"):
                Part(Path("grade.part"), Job({}, []), resume=True)
            return write(*words)
        self.assertEqual(self.graded_here(tries), (0, ""))
        self.assertEqual(os.listdir("."), ["marks.txt"])

    def test_who_is_stopped_while_the_outputs_are_written_hears_what_is_kept(self):
        self.hand_in_all(ada=2, bob=1)

        def stops(*_):
            os.kill(os.getpid(), signal.SIGTERM)
            time.sleep(60)
        self.assertEqual(self.graded_here(stops),
                         (128 + signal.SIGTERM, "2 of 2 results are kept in grade.part; the same command with --resume goes on.\n"))
        self.assertEqual(os.listdir("."), ["grade.part"])
        self.assertEqual(self.graded_here(grade.write_outputs, "--resume"), (0, ""))
        self.assertEqual(os.listdir("."), ["marks.txt"])
        self.assertEqual(self.graded_so_far(), {"ada": 1, "bob": 1})

    def graded_here(self, write_outputs, *options):
        """Exit status, and what was said of results, of a grader in this process that writes its outputs so."""
        stand_in = [sys.executable, "-I", "-S", "-B", "-c", f"LOG = {str(self.log)!r}{STAND_IN}"]
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.place)
        said = io.StringIO()
        with mock.patch("grade.write_outputs", write_outputs), mock.patch("grade_class.GRADE_ONE", stand_in), mock.patch("sys.stderr", said):
            status = grade.main(["--root", str(self.root), "--toolchain", str(self.toolchain_file), "--output", "marks.txt", *options,
                                 *(str(self.submissions / name) for name in self.names())])
        return status, "".join(line for line in said.getvalue().splitlines(True) if " results " in line)

    def test_a_submission_that_cannot_be_read_is_missing_alone(self):
        self.hand_in_all(ada=2, bob=1)
        self.run_to_the_end("--part", "kept")
        _, said = self.run_to_the_end("--part", "kept", "--resume", "--incomplete", code=3, unreadable="bob")
        self.assertIn("course: bob has no result: GraderFailed: ", said)
        self.assertNotIn("ada", said)

    def test_no_folder_is_taken_for_an_option_or_a_command(self):
        for name in ("ada", "--incomplete"):
            self.hand_in(name, "// 1\n")
        names = [Path(name) for name in self.names()]
        _, said = self.run_to_the_end(folders=names, code=2, inside=self.submissions)
        self.assertIn("--incomplete could be an option or the name of what lies here", said)
        self.assertEqual(self.graded_so_far(), {})
        for way in (["--", *names], [f"./{name}" for name in names]):
            printed, _ = self.run_to_the_end("--format", "json", "--part", self.place / "kept", "--resume", folders=way,
                                             inside=self.submissions)
            self.assertEqual([result["submission"] for result in json.loads(printed)], ["--incomplete", "ada"])
        self.hand_in("merge", "// 1\n")
        _, said = self.run_to_the_end(folders=["merge", "ada"], code=2, inside=self.submissions)
        self.assertIn("merge could be the command or the name of what lies here", said)

    def test_a_name_of_two_lines_is_told_on_one(self):
        self.hand_in("ada\ncourse: bob", "// breaks\n")
        _, said = self.run_to_the_end(code=3)
        self.assertIn("course: ada\\ncourse: bob has no result", said)

    def test_what_other_work_has_kept_is_no_class(self):
        part = self.place / "sweep.part"
        with Part(part, Job({"sweep": 1}, ["t_handle"])) as kept:
            kept.add("t_handle", ["t_handle", "splitting", 0.01])
        _, said = self.run_to_the_end("merge", part, code=2)
        self.assertIn("what the parts hold for t_handle is no result of grading", said)

    def test_nobody_is_marked_by_other_checks(self):
        self.hand_in_all(ada=2, bob=1)
        self.run_to_the_end("--part", "kept", "--marks", "marks.csv")
        with Part(self.place / "kept", self.job(), resume=True) as kept:
            right = kept.done["ada"]
            exercise, = right["exercises"]
            checks = [{**check, "points": 100, "of": 100} for check in exercise["checks"]]
            kept.add("ada", {**right, "points": 200, "of": 200, "exercises": [{**exercise, "checks": checks}]})
        _, said = self.run_to_the_end("merge", "kept", "--marks", "new.csv", code=2)
        self.assertEqual(said, "course: what the parts hold for ada and for bob is not of the same checks\n")

    def job(self):
        """That of a whole part."""
        kept = self.place / "kept"
        return Job(job_of_part(kept), list(merge([kept])[0]))

    def test_a_part_that_was_edited_makes_no_marks(self):
        self.hand_in_all(ada=2, bob=1)
        self.run_to_the_end("--part", "kept", "--marks", "marks.csv")
        with Part(self.place / "kept", self.job(), resume=True) as kept:
            right = dict(kept.done["ada"])
        exercise, = right["exercises"]
        check = exercise["checks"][0]
        for change in ({"submission": "bob"}, {"student": "bob"}, {"points": 4}, {"points": float("nan")}, {"seconds": float("nan")}, {"of": 2},
                       {"exercises": []}, {"exercises": 5}, {"exercises": [exercise, exercise]}, {"exercises": [{"checks": []}]},
                       {"points": 10, "exercises": [{**exercise, "checks": [{**check, "points": 9}, exercise["checks"][1]]}]},
                       {"handed_in": None}):
            with self.subTest(change):
                with Part(self.place / "kept", self.job(), resume=True) as kept:
                    kept.add("ada", {**right, **change})
                _, said = self.run_to_the_end("merge", "kept", "--marks", "new.csv", code=2)
                self.assertEqual(said, "course: what the parts hold for ada is no result of grading\n")
                self.assertFalse((self.place / "new.csv").exists())
        _, said = self.run_to_the_end("--part", "kept", "--resume", "--marks", "new.csv", code=2)
        self.assertEqual(said, "course: what the parts hold for ada is no result of grading\n")
        with Part(self.place / "kept", self.job(), resume=True) as kept:
            kept.add("ada", right)
        self.run_to_the_end("merge", "kept", "--marks", "new.csv")
        self.assertEqual((self.place / "new.csv").read_bytes(), (self.place / "marks.csv").read_bytes())

    def test_a_part_is_of_one_job_alone(self):
        self.hand_in_all(ada=2, bob="breaks")
        self.run_to_the_end(code=3)
        _, said = self.run_to_the_end("--resume", "--seed", "autumn", code=2)
        self.assertIn('grade.part belongs to another job: its job seed is "", and here it is "autumn"', said)
        self.change(self.exercise_folder / "checks.cpp", "that is the third power", "that is far too much")
        _, said = self.run_to_the_end("--resume", code=2)
        self.assertIn("its job exercises 01_force/doubled is ", said)

    def test_headers_that_checks_and_answers_include_belong_to_the_job(self):
        self.hand_in_all(ada=2, bob="breaks")
        self.run_to_the_end(code=3)
        for place, below in ((self.root / "exercises" / "common", "exercise/judge.hpp"),
                             (self.root / "chapters", "01_force/tumble/force.hpp")):
            with self.subTest(below):
                target = place.resolve()
                place.unlink()
                shutil.copytree(target, place)
                self.run_to_the_end("--resume", code=3)  # a copy is the same
                (place / below).write_bytes((place / below).read_bytes() + b"// changed\n")
                _, said = self.run_to_the_end("--resume", code=2)
                self.assertIn("its job exercises 01_force/doubled is ", said)
                shutil.copyfile(target / below, place / below)

    def test_what_can_not_be_written_is_told_before_anything_is_graded(self):
        self.hand_in_all(ada=2, bob=1)
        (self.place / "a file").touch()
        for options, expected in (
                (("--output", "none/x"), "--output: none/x can't be written: No such file or directory"),
                (("--marks", "none/x"), "--marks: none/x can't be written: No such file or directory"),
                (("--part", "none/x"), "none/x can't be written, and results are kept there as they come: No such file or directory"),
                (("--output", "."), "--output: . can't be written: Is a directory"),
                (("--marks", "x", "--output", "x"), "--output and --marks both name x"),
                (("--exercises", "doubled,doubled"), "doubled stands twice in doubled,doubled; its points count once"),
                (("--exercises", "doubled,01_force/doubled"), "doubled stands twice"),
                (("--seconds", "inf"), "seconds is inf; it must be greater than 0 and at most 3600"),
                (("--seconds", "nan"), "seconds is nan"),
                (("--jobs", "0"), "jobs is 0; it must be at least 1"),
                (("--shard", "3/2"), "the shard is 3/2; it must be NUMBER/OF, such as 3/16"),
                (("--shard", "1/2", "--marks", "x"), "a shard writes its part alone"),
                (("--format", "gradescope"), "2 submissions; Gradescope grades one at a time")):
            with self.subTest(options):
                printed, said = self.run_to_the_end(*options, code=2)
                self.assertIn(f"course: {expected}", said)
                self.assertNotIn("Traceback", said)
                self.assertEqual(printed, b"")
        self.assertEqual(self.graded_so_far(), {})
        self.assertEqual({file.name for file in self.place.iterdir()} - {"grade.part"}, {"a file"})

    def test_no_output_goes_over_what_is_read(self):
        self.hand_in("ada", "// 2\n")
        header = self.submissions / "ada" / "doubled.hpp"
        (self.place / "link").symlink_to(header)
        for option in ("--marks", "--output"):
            for file in (header, self.place / "link"):
                self.assertIn("that is a submission's header, and it would be overwritten", self.run_to_the_end(option, file, code=2)[1])
            self.assertIn("File name too long", self.run_to_the_end(option, "n" * 300, code=2)[1])
            self.assertIn("that is where results are kept", self.run_to_the_end(option, "kept", "--part", "kept", code=2)[1])
        self.assertEqual(header.read_text(encoding="utf-8"), "// 2\n")
        self.run_to_the_end("--part", "1", "--shard", "1/1")
        self.assertIn("that is one of the parts", self.run_to_the_end("merge", "1", "--marks", "1", code=2)[1])
        self.run_to_the_end("merge", "1", "--marks", self.submissions / "ada" / "marks.csv")

    def test_checks_that_change_meanwhile_end_the_run(self):
        self.hand_in("ada", "// 2\n")
        self.hand_in("bob", "// waits\n")
        wait = Path(f"{self.log}.wait")
        wait.touch()
        process = self.begin("--jobs", "1")
        self.wait_until(lambda: "waits" in self.log.read_text(encoding="utf-8"))
        checks = self.exercise_folder / "checks.cpp"
        checks.write_text(checks.read_text(encoding="utf-8") + "\n// another\n", encoding="utf-8")
        wait.unlink()
        self.assertIn(b"the checks, headers or grader have changed since the grading began", process.communicate(timeout=60)[1])
        self.assertEqual(process.returncode, 2)
        self.assertIn("belongs to another job", self.run_to_the_end("--resume", code=2)[1])

    def test_what_every_submission_may_read_holds_nothing_of_the_course(self):
        for place in ("/usr/lib/course", "/lib/course", "/usr/local/include/course"):
            with self.assertRaisesRegex(Complaint, "which every submission may read"):
                require_out_of_reach([("the course", place)])
        require_out_of_reach([("the course", "/usr/share/course"), ("the build", self.root)])

    def test_who_does_not_listen_any_more_loses_nothing(self):
        self.hand_in_all(ada=2, bob=1)
        with open("/dev/full", "wb") as full:
            process = subprocess.run([sys.executable, "-B", str(self.runner), "--root", str(self.root), "--toolchain",
                                      str(self.toolchain_file), *map(str, sorted(self.submissions.iterdir()))], cwd=self.place,
                                     stdout=full, stderr=subprocess.PIPE)
        self.assertEqual((process.returncode, process.stderr.decode().splitlines()[-1]),
                         (2, "course: what was to be written: No space left on device"))
        self.assertEqual(self.results_in(self.place / "grade.part"), 2)
        self.run_to_the_end("--resume")
        self.assertEqual(self.graded_so_far(), {"ada": 1, "bob": 1})

    def test_a_grader_that_never_ends_is_ended_and_has_failed(self):
        deaf = "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN); print('up', flush=True); time.sleep(600)"
        arguments = types.SimpleNamespace(seconds=1, budget=None)
        graders = grade_class._Graders(arguments, [], {}, 1)
        graders.seconds = 0.5
        with mock.patch.object(grade_class, "GRADE_ONE", [sys.executable, "-c", deaf]), mock.patch.object(grade_class, "PATIENCE", 0.2):
            with self.assertRaises(grade_class.GraderFailed) as caught:
                graders._graded({})
        self.assertEqual(str(caught.exception), "it took more than 0.5 seconds by the clock")
        self.assertEqual(graders.processes, set())


@unittest.skipUnless(TOOLCHAIN, "TUMBLE_TOOLCHAIN names no toolchain.json")
class OfTheCourse(Grading):
    def test_two_shards_of_real_exercises_are_what_one_run_gives(self):
        moon = (ROOT / "solutions" / "01_force" / "moon" / "moon.hpp").read_text(encoding="utf-8")
        for name, text in (("ada", moon), ("bob", (ROOT / "exercises" / "01_force" / "moon" / "moon.hpp").read_text(encoding="utf-8")),
                           ("eve", "#include <stdexcept>\n" + moon.replace("return", 'throw std::runtime_error("\\xc2\\x9b" "31m"); return', 1)),
                           ("fay", "nonsense"), ("guy", None)):
            place = self.hand_in(name, None)
            if text:
                (place / "moon.hpp").write_text(text, encoding="utf-8")
        for options in (("--shard", "1/2"), ("--shard", "2/2"),
                        ("--part", "whole", "--output", "one.xml", "--marks", "one.csv", "--format", "junit")):
            self.of_the_course(*options, "--exercises", "moon,no_lag", *sorted(self.submissions.iterdir()))
        self.of_the_course("merge", "grade.2_of_2.part", "grade.1_of_2.part", "--output", "two.xml", "--marks", "two.csv", "--format",
                           "junit")
        for kind in ("xml", "csv"):
            self.assertEqual((self.root / f"two.{kind}").read_bytes(), (self.root / f"one.{kind}").read_bytes())
        self.assertIn(b"\\x9b31m", (self.root / "two.xml").read_bytes())
        with open(self.root / "two.csv", newline="", encoding="utf-8") as table:
            self.assertEqual([(row["student"], row["01_force/moon"]) for row in csv.DictReader(table)],
                             [("ada", "2"), ("bob", "0"), ("eve", "0"), ("fay", "0"), ("guy", "0")])

    def test_the_class_of_three_that_the_book_shows_is_graded_as_it_shows(self):
        plate = find(read_catalogue(ROOT), "plate")
        solution = (ROOT / "solutions" / plate.path / "plate.hpp").read_text(encoding="utf-8")
        wrong = read_wrong_answers(plate, ROOT / "tests" / "exercises" / plate.path, solution)
        [remembered] = [answer.text for answer in wrong if answer.name == "as_feynman_remembered"]
        for name, text in (("a", solution), ("b", remembered), ("c", starter_of(solution))):
            (self.hand_in(name, None) / "plate.hpp").write_text(text, encoding="utf-8")
        report = self.of_the_course("--exercises", "plate", *sorted(self.submissions.iterdir()))
        shown = (ROOT / "book" / "pages" / "class_of_three.txt").read_text(encoding="utf-8")
        self.assertEqual(report, shown, "write what is graded now to book/pages/class_of_three.txt")

    def of_the_course(self, *words):
        """The report."""
        result = subprocess.run([sys.executable, "-E", "-B", str(TOOLS / "grade.py"), "--root", str(ROOT), "--toolchain", TOOLCHAIN,
                                 *map(str, words)], cwd=self.root, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, timeout=900, encoding="utf-8")
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout
