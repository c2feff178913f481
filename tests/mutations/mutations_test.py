#!/usr/bin/env python3
"""mutations_test.py BUILD_FOLDER: what mutations.py says of lists that are wrong."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

script = Path(__file__).with_name("mutations.py")
build = sys.argv.pop()

harmless = """tumble/drag.hpp: nothing
- area / 2;
+ area * Real(0.5);
"""
fatal = """tumble/step_clock.hpp: no step is due
- return due;
+ return 0;
"""
no_code = """tumble/step_clock.hpp: nothing compiles
- return due;
+ return overdue;
"""


class Lists(unittest.TestCase):
    def run_lists(self, **lists):
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder, f"{chapter}.txt") for chapter in lists]
            for path in paths:
                path.write_text(lists[path.stem])
            return subprocess.run([sys.executable, script, build, *paths], text=True, capture_output=True)

    def refused(self, text, *sentence):
        run = self.run_lists(**{"10_fixed_timestep": text})
        self.assertNotEqual(run.returncode, 0)
        for part in sentence:
            self.assertIn(part, run.stderr)

    def test_a_survivor_is_reported(self):
        run = self.run_lists(**{"09_damping": harmless})
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("drag.hpp: nothing -- survived: add a check", run.stdout)

    def test_only_what_is_proved_may_survive_and_what_is_killed_names_its_check(self):
        proved = harmless + "equivalent: 0.5 is a power of two, so the product rounds as the quotient does\n"
        run = self.run_lists(**{"09_damping": proved, "10_fixed_timestep": fatal})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("no step is due -- killed by step_clock: ", run.stdout)

    def test_a_false_proof_and_code_that_does_not_compile_are_reported(self):
        run = self.run_lists(**{"10_fixed_timestep": fatal + "equivalent: who needs steps\n\n" + no_code})
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("is listed as equivalent, but a check sees it", run.stdout)
        self.assertIn("does not compile", run.stdout)
        self.assertIn("2 mutations, 0 generated mutants, 2 wrong", run.stdout)

    def test_a_line_that_is_not_there_once_is_refused_before_anything_is_compiled(self):
        self.refused(fatal.replace("return due", "return dew"), "holds \"return dew;\" 0 times; it must do so exactly once")
        self.refused(fatal.replace("return due;", "return "), "times; it must do so exactly once")

    def test_what_is_misspelt_in_a_list_is_refused(self):
        self.refused(fatal.replace("step_clock", "step_cluck"), "no such header is in reach")
        self.refused(fatal + "seen by: nobody\n", "has no checks called nobody")
        self.refused(fatal + "killed by: step_clock\n", "begins with none of")
        self.refused(fatal.replace("+ return 0;\n", ""), "needs \"- \" lines and other \"+\" lines")


if __name__ == "__main__":
    unittest.main()
