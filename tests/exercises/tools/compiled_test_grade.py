"""Grading: a class of forty with known points, hostile submissions, and what is handed on."""

import csv
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

from catalogue import read_catalogue
from fixture import HERE, PLACE, ROOT, FixtureCourse
from gradescope_format import mistakes_in
from programs import build_worker, prepare
from untrusted import FIRST_USER, seals

HOSTILE = HERE.parent / "hostile"
RIGHT = """#pragma once
template <class Real> Real doubled(Real number) { return number + number; }
template <class Real> Real halved(Real number) { return number / 2; }
"""


class Grading(FixtureCourse):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="a class ")
        self.addCleanup(folder.cleanup)
        self.submissions = Path(folder.name)

    def hand_in(self, name, text):
        place = self.submissions / name
        place.mkdir()
        if text is not None:
            (place / "doubled.hpp").write_bytes(text if isinstance(text, bytes) else text.encode())
        return place

    def started_by(self):
        """Further arguments for subprocess.run."""
        return {}

    def grade(self, *options, folders=None, code=0):
        folders = sorted(self.submissions.iterdir()) if folders is None else folders
        result = subprocess.run([sys.executable, "-B", str(ROOT / "exercises" / "tools" / "grade.py"), "--root", str(self.root),
                                 "--toolchain", str(self.toolchain_file), "--seconds", "2", *options, *map(str, folders)],
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=1800,
                                **self.started_by())
        self.assertEqual(result.returncode, code, result.stderr.decode())
        return result.stdout.decode() if code == 0 else result.stderr.decode()

    def graded(self, *options, **others):
        return {result["submission"]: result for result in json.loads(self.grade("--format", "json", *options, **others))}


class AClass(Grading):
    def test_forty_submissions_get_the_points_they_earn_in_every_format(self):
        cubed = RIGHT.replace("number + number", "number * number * number")
        kinds = [(RIGHT, 3), (cubed, 1), (RIGHT.replace("number / 2", "number"), 2), ("", 0), (None, 0),
                 ((self.exercise_folder / "doubled.hpp").read_text(encoding="utf-8"), 0), ("nonsense", 0),
                 (RIGHT.replace("number + number", "number * number"), 3)]
        expected = {}
        for number in range(40):
            text, points = kinds[number * 3 % len(kinds)]
            expected[f"student{number:02}"] = points
            self.hand_in(f"student{number:02}", text)
        marks, export = self.root / "marks.csv", self.root / "export"
        results = self.graded("--marks", str(marks), "--similarity", str(export))
        self.assertEqual({name: result["points"] for name, result in results.items()}, expected)
        self.assertTrue(all(result["of"] == 3 for result in results.values()))
        with open(marks, newline="", encoding="utf-8") as table:
            self.assertEqual({row["student"]: int(row["points"]) for row in csv.DictReader(table)}, expected)
        self.assertEqual(len(list((export / "doubled").glob("student*.hpp"))), 30)
        self.assertTrue((export / "doubled" / "STARTER.hpp").exists())

    def test_what_is_handed_on(self):
        self.hand_in("ada", RIGHT)
        self.hand_in("bob", RIGHT.replace("number + number", "number * number * number"))
        text = self.grade()
        self.assertIn("ada: 3 of 3 points", text)
        self.assertIn("twice 2 m is 8 m: that is the third power", text)
        suites = ElementTree.fromstring(self.grade("--format", "junit"))
        self.assertEqual([(suite.get("name"), suite.get("tests"), suite.get("failures")) for suite in suites],
                         [("ada.01_force/doubled", "2", "0"), ("bob.01_force/doubled", "2", "1")])
        self.assertEqual(suites.find(".//failure").get("message"), "twice 2 m is 8 m: that is the third power")
        file = self.root / "results.json"
        self.grade("--format", "gradescope", "--output", str(file), folders=[self.submissions / "bob"])
        results = json.loads(file.read_text(encoding="utf-8"))
        self.assertEqual(mistakes_in(results), [])
        self.assertEqual([(test["score"], test["max_score"], test["status"]) for test in results["tests"]],
                         [(0, 2, "failed"), (1, 1, "passed")])
        self.assertIn("one at a time", self.grade("--format", "gradescope", code=2))

    def test_of_resubmissions_the_best_or_the_last_counts(self):
        for name, text in (("ada@1", RIGHT), ("ada@2", ""), ("bob@1", "")):
            self.hand_in(name, text)
        self.assertEqual({name: each["points"] for name, each in self.graded("--keep", "best").items()}, {"ada@1": 3, "bob@1": 0})
        self.assertEqual({name: each["points"] for name, each in self.graded("--keep", "last").items()}, {"ada@2": 0, "bob@1": 0})

    def test_a_seed_gives_each_student_numbers_of_their_own(self):
        for number in range(8):
            self.hand_in(f"student{number}", RIGHT.replace("number + number", "4"))  # right for 2 alone
        points = [result["points"] for result in self.graded("--seed", "autumn").values()]
        self.assertEqual(set(points), {1, 3}, points)
        self.assertEqual({result["points"] for result in self.graded().values()}, {3})

    def test_a_private_folder_works_like_the_public_one(self):
        private = self.root / "private" / "01_force" / "hidden"
        shutil.copytree(self.exercise_folder, private)
        (private / "doubled.hpp").rename(private / "hidden.hpp")
        place = self.hand_in("ada", None)
        (place / "hidden.hpp").write_text(RIGHT, encoding="utf-8")
        results = self.graded("--private", str(self.root / "private"), "--exercises", "hidden")
        self.assertEqual(results["ada"]["points"], 3)

    def test_mistakes_of_the_grader_are_named(self):
        place = self.hand_in("ada", RIGHT)
        self.assertIn("is no folder; a submission is a folder", self.grade(folders=[place / "doubled.hpp"], code=2))
        self.assertIn("two submissions are called ada", self.grade(folders=[place, place], code=2))
        self.assertIn("no exercise is called hamer", self.grade("--exercises", "hamer", code=2))
        self.assertIn("seconds is -1.0", self.grade("--seconds", "-1", code=2))


class Hostile(Grading):
    """Each is handed in once to a grader that root started, and once to one that somebody else did."""
    user = None  # who starts the grader; None: who runs the test

    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="temporary-")
        self.addCleanup(folder.cleanup)
        self.temporary = Path(folder.name)
        self.temporary.chmod(0o1777)
        self.submissions.chmod(0o755)
        self.secret = self.root / "secret"
        self.secret.write_text("the_secret_word\n", encoding="utf-8")
        self.secret.chmod(0o600)
        prepare(self.toolchain, read_catalogue(self.root)[0])
        self.built = self.build / PLACE / "solution"
        build_worker(self.toolchain, read_catalogue(self.root)[0], self.solution.parent, self.built)
        for name in ("worker", "made"):  # a classmate's scratch, as open as it could be
            shutil.copytree(self.built, self.temporary / "graded-classmate" / name)
        (self.temporary / "graded-classmate").chmod(0o755)

    def started_by(self):
        return {"env": {**os.environ, "TMPDIR": str(self.temporary)}, "user": self.user, "group": self.user,
                "extra_groups": None if self.user is None else []}

    def hand_in_all(self):
        expected = {}
        for file in sorted(HOSTILE.glob("*.hpp")):
            text = file.read_bytes().decode()
            head = re.match(r"// earns: (\d)\n// because: (.+?)\n(?!//)", text, flags=re.DOTALL)
            expected[file.stem] = int(head[1]), re.sub(r"\s*\n// ", " ", head[2])
            for name, place in (("ROOT", self.root), ("SECRET", self.secret), ("BUILT", self.built),
                                ("TEMPORARY", self.temporary), ("SUBMISSIONS", self.submissions)):
                text = text.replace(f"@{name}@", str(place))
            self.hand_in(file.stem, text)
        for name, text, reason in (("is_empty", b"", "doubled.hpp is empty"), ("is_blank", b" \n\n", "doubled.hpp is empty"),
                                   ("is_not_utf8", b"// caf\xe9\n" + RIGHT.encode(), "not UTF-8: byte 6 is 0xe9"),
                                   ("holds_a_zero", RIGHT.encode() + b"\0", "holds a zero byte"),
                                   ("is_huge", b"/" * 300_000, "larger than 256 KB"),
                                   ("opens_87000_comments", b"/* " * 87_000, "it doesn't compile"),
                                   ("has_17000_attributes", b"__attribute__((" * 17_000, "it doesn't compile"),
                                   ("is_missing", None, "doubled.hpp was not handed in")):
            self.hand_in(name, text)
            expected[name] = 0, reason
        link = self.hand_in("is_a_link", None) / "doubled.hpp"
        link.symlink_to(self.solution)
        expected["is_a_link"] = 0, "doubled.hpp is a symbolic link"
        (self.hand_in("has_a_linked_folder", None) / "doubled").symlink_to(self.solution.parent)
        expected["has_a_linked_folder"] = 0, "doubled is a symbolic link"
        (self.hand_in("is_a_folder", None) / "doubled.hpp").mkdir()
        expected["is_a_folder"] = 0, "is no file"
        os.mkfifo(self.hand_in("is_a_pipe", None) / "doubled.hpp")
        expected["is_a_pipe"] = 0, "is no file"
        for name in ("aaa_honest", "zzz_honest"):
            self.hand_in(name, RIGHT)
            expected[name] = 3, ""
        return expected

    def test_each_gets_what_it_earns_and_nobody_else_is_touched(self):
        expected = self.hand_in_all()
        self.assertGreaterEqual(len(expected), 70)
        self.grade(folders=[self.submissions / "aaa_honest"])  # so that everything is made
        before = self.files()
        results = self.graded("--jobs", "2")
        for name, (points, because) in expected.items():
            with self.subTest(name):
                exercise, = results[name]["exercises"]
                said = " ".join([exercise["reason"], *exercise["flags"], *(check["message"] for check in exercise["checks"])])
                self.assertEqual(results[name]["points"], points, said)
                self.assertIn(because, said)
        self.assertNotIn("the_secret_word", json.dumps(results))
        self.assertEqual(self.files(), before)
        self.assertEqual(self.processes_of_students(), [])
        self.assertEqual([place.name for place in self.temporary.iterdir()], ["graded-classmate"])

    def files(self):
        """What the grader's own files hold, judge included."""
        folders = [self.root / name for name in ("exercises/01_force", "solutions", "build/01_force")] + [ROOT / "exercises"]
        return {str(file): hashlib.sha256(file.read_bytes()).hexdigest()
                for folder in folders for file in sorted(folder.rglob("*")) if file.is_file()}

    @staticmethod
    def processes_of_students():
        found = []
        for status in Path("/proc").glob("[0-9]*/status"):
            try:
                user = re.search(r"^Uid:\s+(\d+)", status.read_text(encoding="utf-8"), flags=re.MULTILINE)
            except OSError:
                continue
            if user and FIRST_USER <= int(user[1]) < FIRST_USER + (1 << 22):
                found.append(status.parent.name)
        return found
