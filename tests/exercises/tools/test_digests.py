"""What decides on points is told apart by its digest, so that no run goes on with results of other checks."""

import tempfile
import unittest
from pathlib import Path

from grade_class import _digests_of
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
