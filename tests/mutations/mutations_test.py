#!/usr/bin/env python3
"""mutations_test.py BUILD_FOLDER: what mutations.py says of lists that are wrong and of a compiler that crashes, and what it takes
for changed."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
from since import changed_since_held

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
of_float = """tumble/drag.hpp: in float the coefficient is not halved
- area / 2;
+ area / (sizeof(Real) == 4 ? 1 : 2);
"""
crashing = """tumble/step_clock.hpp: a step is due once more
- return due;
+ return due + 4711;
"""
# A compiler that crashes where the mutant above can be switched, and else does what the one behind it does.
crashing_compiler = """#!/bin/sh
for word; do case $word in -I*/mutants/*) folder=${word#-I} ;; esac; done
if [ -n "$folder" ] && grep --recursive -q -s --include=*.hpp "chosen([0-9]*)) { return due + 4711" "$folder"; then
  echo "c++: internal compiler error: Segmentation fault signal terminated program cc1plus" >&2
  exit 4
fi
exec %s "$@"
"""
no_code = """tumble/step_clock.hpp: nothing compiles
- return due;
+ return overdue;
"""


class Lists(unittest.TestCase):
    def run_lists(self, build=build, **lists):
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder, f"{chapter}.txt") for chapter in lists]
            for path in paths:
                path.write_text(lists[path.stem])
            return subprocess.run([sys.executable, script, build, *paths], text=True, capture_output=True)

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

    def test_what_only_float_shows_is_seen_and_not_compiled_alone(self):
        run = self.run_lists(**{"09_damping": of_float})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("in float the coefficient is not halved -- killed by terminal_speed: ", run.stdout)
        self.assertIn("compiled in float", run.stdout)
        self.assertNotIn("alone", run.stdout)

    def test_a_crash_of_the_compiler_names_its_mutation_and_the_others_are_switched(self):
        with tempfile.TemporaryDirectory() as folder:
            compiler = Path(folder, "crashing")
            commands = json.loads(Path(build, "compile_commands.json").read_text())
            for entry in commands:
                real, rest = entry["command"].split(" ", 1)
                entry["command"] = f"{compiler} {rest}"
            compiler.write_text(crashing_compiler % real)
            compiler.chmod(0o755)
            Path(folder, "compile_commands.json").write_text(json.dumps(commands))
            run = self.run_lists(folder, **{"10_fixed_timestep": f"{fatal}\n{crashing}"})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertIn("what stops the compiler in step_clock_checks.cpp is tumble/step_clock.hpp a step is due once more", run.stdout)
        self.assertIn("1 of 1 mutants compiled alone", run.stdout)
        self.assertIn("no step is due -- killed by", run.stdout)
        self.assertIn("a step is due once more -- killed by", run.stdout)


class Changed(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve()
        (self.root / "tests").mkdir()
        for name in "old.hpp", "new.hpp":
            (self.root / name).write_text("one\n")

    def git(self, *words):
        alone = {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull}
        return subprocess.run(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b", *words], text=True, check=True,
                              capture_output=True, env={**os.environ, **alone}).stdout.strip()

    def held(self, text):
        (self.root / "tests/exhaustive.txt").write_text(text)

    def test_what_differs_from_the_commit_that_held_has_changed(self):
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-qm", "one")
        self.held(f"# what held last\n{self.git('rev-parse', 'HEAD')} 2026-11-27\n")
        self.assertEqual(changed_since_held(self.root), {self.root / "tests/exhaustive.txt"})
        (self.root / "new.hpp").write_text("two\n")
        (self.root / "newer.hpp").write_text("one\n")
        self.assertEqual({path.name for path in changed_since_held(self.root)}, {"new.hpp", "newer.hpp", "exhaustive.txt"})
        self.git("commit", "-qam", "two")
        self.assertIn(self.root / "new.hpp", changed_since_held(self.root))

    def test_nobody_knows_without_a_commit_or_its_history(self):
        for text in None, "", "\n", "# nothing held yet\n", "0123456789 2026-11-27\n":
            if text is not None:
                self.held(text)
            self.assertIsNone(changed_since_held(self.root), text)
        self.git("init", "-q")
        self.assertIsNone(changed_since_held(self.root))


if __name__ == "__main__":
    unittest.main()
