"""The numbers that the handbook for instructors gives are those of the tools."""

import unittest
from pathlib import Path

from limits import MEBIBYTE, Limits

HANDBOOK = Path(__file__).resolve().parents[3] / "exercises" / "instructor.md"


@unittest.skipUnless(HANDBOOK.exists(), "a student's copy has no handbook")
class Handbook(unittest.TestCase):
    def test_the_limits_of_a_worker_are_those_that_it_gets(self):
        text = HANDBOOK.read_text(encoding="utf-8")
        for row in (f"| time | {Limits.seconds} s of computing, ", f"| memory | {Limits.memory // (1024 * MEBIBYTE)} GB of address space |",
                    f"| output | {Limits.output // MEBIBYTE} MB |"):
            self.assertIn(row, text)
