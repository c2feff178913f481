"""The starter is what remains of the solution; marks that don't fit are errors with their line."""

import unittest

from complaint import Complaint
from starter import solution_without_marks, starter_of

SOLUTION = """before
  //! [solution] the "mass"
  return m;
  //! [end]
between
  //! [solution]
  return 1;
  //! [starter]
  // return 2;
  //
  //! [end]
after
"""


class Starter(unittest.TestCase):
    def test_a_sentence_becomes_a_todo_and_a_starter_part_is_uncommented(self):
        self.assertEqual(starter_of(SOLUTION), 'before\n  todo("the \\"mass\\"");\nbetween\n  return 2;\n\nafter\n')

    def test_readers_see_the_solution_without_marks(self):
        self.assertEqual(solution_without_marks(SOLUTION), "before\n  return m;\nbetween\n  return 1;\nafter\n")

    def test_a_region_may_leave_nothing(self):
        self.assertEqual(starter_of("a\n//! [solution]\nb\n//! [starter]\n//! [end]\n"), "a\n")

    def test_marks_that_do_not_fit_are_errors(self):
        for text, expected in (
                ("//! [solution] a\n", "it:1: [solution] without [end]"),
                ("//! [end]\n", "it:1: [end] without [solution] before it"),
                ("//! [starter]\n", "it:1: [starter] without [solution] before it"),
                ("//! [solution] a\n//! [solution] b\n//! [end]\n//! [end]\n", "it:2: a region inside the one of line 1"),
                ("//! [solution] a\n//! [end]\n//! [end]\n", "it:3: [end] without [solution]"),
                ("//! [solution]\nx\n//! [end]\n", "nothing would stand in the place of the region of line 1"),
                ("//! [solution] a\n//! [starter]\n//! [end]\n", 'has a sentence for todo, "a"; it must not have'),
                ("//! [solution]\n//! [starter]\n//! [starter]\n//! [end]\n", "it:3: a second [starter]"),
                ("//! [solution]\n//! [starter]\nreturn 1;\n//! [end]\n", "its lines must be comments"),
                ("//! [solution] a\n//! [end] b\n", '"b" stands after [end]'),
                ("//! [soluton] a\n//! [end]\n", "it:1: //! [soluton] a is no mark"),
                ("a\n", "it has no [solution] region, so its starter would be solved")):
            with self.subTest(text), self.assertRaises(Complaint) as caught:
                starter_of(text, "it")
            self.assertIn(expected, str(caught.exception))
