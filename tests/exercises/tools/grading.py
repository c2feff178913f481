"""Submissions for the small course, and a grader that is run on them."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

from fixture import ROOT, FixtureCourse

RIGHT = """#pragma once
template <class Real> Real doubled(Real number) { return number + number; }
template <class Real> Real halved(Real number) { return number / 2; }
"""


class Grading(FixtureCourse):
    user = None  # who starts the grader; None: who runs the test
    python = sys.executable

    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="a class ")
        self.addCleanup(folder.cleanup)
        self.submissions = Path(folder.name)
        self.submissions.chmod(0o755)
        kept = tempfile.TemporaryDirectory(prefix="results ")
        self.addCleanup(kept.cleanup)
        self.kept = Path(kept.name)
        self.kept.chmod(0o777)  # whoever grades
        self.runs = 0

    def hand_in(self, name, text):
        place = self.submissions / name
        place.mkdir()
        if text is not None:
            (place / "doubled.hpp").write_bytes(text if isinstance(text, bytes) else text.encode())
        return place

    def started_by(self):
        """Further arguments for subprocess.run."""
        return {} if self.user is None else {"user": self.user, "group": self.user, "extra_groups": []}

    def command(self, *options, folders=None):
        folders = sorted(self.submissions.iterdir()) if folders is None else folders
        self.runs += 1
        options = ("--part", str(self.kept / f"{self.runs}.part"), *options)
        return [self.python, "-B", str(ROOT / "exercises" / "tools" / "grade.py"), "--root", str(self.root),
                "--toolchain", str(self.toolchain_file), "--seconds", "2", *options, *map(str, folders)]

    def grade(self, *options, folders=None, code=0):
        result = subprocess.run(self.command(*options, folders=folders), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, timeout=1800, **self.started_by())
        self.assertEqual(result.returncode, code, result.stderr.decode())
        return result.stdout.decode() if code == 0 else result.stderr.decode()

    def graded(self, *options, **others):
        return {result["submission"]: result for result in json.loads(self.grade("--format", "json", *options, **others))}
