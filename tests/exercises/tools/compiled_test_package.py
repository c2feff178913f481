"""The zip for Gradescope, unpacked and run where Gradescope would."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

from catalogue import find, find_all, read_catalogue
from complaint import Complaint
from fixture import ROOT, TOOLCHAIN
from gradescope_format import mistakes_in
from package import package


@unittest.skipUnless(TOOLCHAIN, "TUMBLE_TOOLCHAIN names no toolchain.json")
class Gradescope(unittest.TestCase):
    def test_a_mistake_is_told_before_anything_is_packed(self):
        catalogue = read_catalogue(ROOT)
        with self.assertRaises(Complaint) as caught:
            package(ROOT, [find(catalogue, "moon")], Path("/nowhere/autograder.zip"))
        self.assertIn("--output: /nowhere/autograder.zip can't be written: No such file", str(caught.exception))
        with self.assertRaises(Complaint) as caught:
            find_all(catalogue, "moon,no_lag,01_force/moon")
        self.assertIn("moon stands twice in moon,no_lag,01_force/moon", str(caught.exception))

    def test_no_file_of_the_course_is_overwritten(self):
        readme = (ROOT / "README.md").read_bytes()
        with self.assertRaises(Complaint) as caught:
            package(ROOT, [find(read_catalogue(ROOT), "moon")], ROOT / "README.md")
        self.assertIn("that is a file of the course, and it would be overwritten", str(caught.exception))
        self.assertEqual((ROOT / "README.md").read_bytes(), readme)

    def test_whoever_packs_with_a_strict_umask_packs_what_everybody_may_read(self):
        mask = os.umask(0o077)
        try:
            with tempfile.TemporaryDirectory(prefix="autograder") as folder:
                package(ROOT, [find(read_catalogue(ROOT), "moon")], Path(folder) / "autograder.zip")
                with zipfile.ZipFile(Path(folder) / "autograder.zip") as packed:
                    rights = {entry.filename: entry.external_attr >> 16 & 0o777 for entry in packed.infolist()}
        finally:
            os.umask(mask)
        self.assertEqual(set(rights.values()), {0o644, 0o755})
        self.assertEqual((rights["course/course"], rights["course/README.md"]), (0o755, 0o644))

    def test_it_grades_a_submission_as_gradescope_runs_it(self):
        with tempfile.TemporaryDirectory(prefix="autograder") as folder:
            autograder = Path(folder)
            autograder.chmod(0o755)  # as Gradescope's is: run by root, the compiler has a user of its own
            file, private = autograder / "autograder.zip", autograder / "hidden"
            shutil.copytree(ROOT / "exercises" / "01_force" / "moon", private / "01_force" / "far_moon")
            (private / "01_force" / "far_moon" / "moon.hpp").rename(private / "01_force" / "far_moon" / "far_moon.hpp")
            os.utime(private / "01_force" / "far_moon" / "checks.cpp", (0, 0))  # of a clock that no zip knows
            (private / "01_force" / "far_moon" / "answer.txt").write_text("for my eyes alone")
            package(ROOT, find_all(read_catalogue(ROOT, private), "moon,far_moon"), file, private)
            shutil.rmtree(private)
            with zipfile.ZipFile(file) as packed:
                names = packed.namelist()
                self.assertFalse([name for name in names if "solutions/" in name or "wrong.txt" in name])
                self.assertEqual([name for name in names if name.startswith("private/")],
                                 [f"private/01_force/far_moon/{name}" for name in ("exercise.json", "checks.cpp", "far_moon.hpp")])
                for entry in packed.infolist():  # as unzip does, with the rights that are noted in the zip
                    os.chmod(packed.extract(entry, autograder / "source"), entry.external_attr >> 16)
            (autograder / "submission").mkdir()
            for name in ("moon", "far_moon"):
                shutil.copyfile(ROOT / "solutions" / "01_force" / "moon" / "moon.hpp", autograder / "submission" / f"{name}.hpp")
            # A private check must be safe also where the kernel lacks Landlock, which only root makes up for.
            without = [sys.executable, "-B", str(Path(__file__).with_name("without_landlock.py"))] if os.geteuid() == 0 else []

            def run(script, code=0):
                result = subprocess.run([*without, str(autograder / "source" / script)], cwd="/", stdin=subprocess.DEVNULL,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        env={**os.environ, "AUTOGRADER": str(autograder)}, timeout=900)
                self.assertEqual(result.returncode, code, result.stdout.decode())
                return result.stdout.decode()
            run("setup.sh")
            run("run_autograder")
            file = autograder / "results" / "results.json"
            results = json.loads(file.read_text(encoding="utf-8"))
            self.assertEqual(mistakes_in(results), [])
            self.assertEqual((results["score"], len(results["tests"])), (4, 4))
            if without:
                place, built = "01_force/far_moon", autograder / "source" / "course" / "build" / "default" / "exercises"
                for name, target in (("moon", autograder / "source" / "private" / place / "checks.cpp"), ("far_moon", built / place / "judge")):
                    self.assertTrue(target.is_file())
                    with open(autograder / "submission" / f"{name}.hpp", "a", encoding="utf-8") as header:
                        header.write(f'asm(".incbin \\"{target}\\"");\n')
                run("run_autograder")
                results = json.loads(file.read_text(encoding="utf-8"))
                self.assertEqual(results["score"], 0)
                self.assertEqual({"Assembler messages" in test["output"] for test in results["tests"]}, {True})
                (autograder / "source" / "private").chmod(0o755)
                self.assertIn("private could be read by every submission", run("run_autograder", code=2))
