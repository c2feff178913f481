"""What decides on points is told apart by its digest, so that no run goes on with results of other checks."""

import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

from grade_class import _digests_of, job_of
from test_texts import exercise


class Digests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.there = self.root / "exercises" / "03_inertia" / "hammer"
        self.exercise = exercise(folder=self.there)
        for name in ("exercise.json", "checks.cpp", "beside.hpp", "task.md", self.exercise.header):
            self.write(self.there / name, name)
        self.write(self.root / "chapters" / "03_inertia" / "inertia.hpp", "")

    def write(self, file, text):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def is_told(self, file):
        before = _digests_of([self.exercise], self.root)
        self.write(file, "something else")
        return _digests_of([self.exercise], self.root) != before

    def test_whatever_the_checks_are_made_of_is_told(self):
        for file in (self.there / "exercise.json", self.there / "checks.cpp", self.there / "beside.hpp",
                     self.root / "chapters" / "03_inertia" / "inertia.hpp", self.root / "exercises" / "common" / "judge.hpp"):
            with self.subTest(file=file.name):
                self.assertTrue(self.is_told(file))

    def test_the_task_and_the_starter_decide_on_nothing(self):
        for name in ("task.md", self.exercise.header):
            self.assertFalse(self.is_told(self.there / name))

    def job(self, version="compiler 12", **changes):
        asked = types.SimpleNamespace(**{"root": self.root, "seed": "", "seconds": 5.0, "unsealed": False, **changes})
        return job_of(asked, {"ada": self.root}, [self.exercise], mock.MagicMock(**{"in_words.return_value": version})).what

    def test_whoever_grades_and_how_is_told(self):
        for name, value in (("seed", "autumn"), ("seconds", 6.0), ("unsealed", True)):
            with self.subTest(name=name):
                self.assertNotEqual(self.job(**{name: value}), self.job())
        self.assertNotEqual(self.job(version="compiler 13")["compiler"], self.job()["compiler"])

    def test_a_changed_grader_is_told_by_its_file(self):
        tools = self.root / "tools"
        self.write(tools / "run_check.py", "one")
        with mock.patch("grade_class.TOOLS", tools):
            before = self.job()["tools"]
            self.write(tools / "run_check.py", "two")
            after = self.job()["tools"]
        self.assertEqual(list(before), ["run_check.py"])
        self.assertNotEqual(before, after)
