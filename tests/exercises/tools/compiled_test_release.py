"""A release gives nothing away, says what it holds, and works on its own."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from catalogue import read_catalogue
from complaint import Complaint
from fixture import ROOT, TOOLCHAIN, FixtureCourse
from package import package
from release import release


class OfTheFixture(FixtureCourse):
    def setUp(self):
        super().setUp()
        for name in ("chapters", "exercises/common", "exercises/tools"):
            (self.root / name).unlink()
        shutil.copytree(ROOT / "chapters" / "01_force", self.root / "chapters" / "01_force")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.target = Path(folder.name) / "for students"
        self.git("init", "--quiet")
        (self.root / ".gitignore").write_text("/build/\n/work/\n", encoding="utf-8")
        self.commit()

    def git(self, *words):
        subprocess.run(["git", "-C", str(self.root), *words], check=True, stdout=subprocess.DEVNULL)

    def commit(self):
        self.git("add", "--all")
        self.git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "--allow-empty", "-m", "as it is now")

    def test_a_student_gets_the_exercise_and_nothing_of_its_answers(self):
        for name in ("instructor.md", "Instructor_notes.md"):
            (self.exercise_folder / name).write_text("Ask why.", encoding="utf-8")
        (self.root / "Solutions").mkdir()
        (self.root / "Solutions" / "of_last_year.txt").write_text("x", encoding="utf-8")
        (self.root / "work").mkdir()
        (self.root / "work" / "mine.hpp").write_text("mine", encoding="utf-8")
        of_a_test = "tests/book/tiny/exercises/01_tiny/stick"
        shutil.copytree(self.exercise_folder, self.root / of_a_test)
        self.commit()
        self.assertEqual(release(self.root, self.target)[1], {})
        names = {str(file.relative_to(self.target)) for file in self.target.rglob("*") if file.is_file()}
        self.assertIn("exercises/01_force/doubled/doubled.hpp", names)
        self.assertIn("exercises/01_force/doubled/hints.md", names)
        self.assertIn("chapters/01_force/tumble/force.hpp", names)
        self.assertIn(f"{of_a_test}/checks.cpp", names)
        for name in names:
            self.assertFalse(any(word in name.lower() for word in ("solutions", "wrong", "instructor", "work", "build")), name)
        manifest = json.loads((self.target / "MANIFEST.json").read_text(encoding="utf-8"))
        self.assertEqual(manifest["exercises"], [{"exercise": "01_force/doubled", "title": "Twice as much", "points": 3, "minutes": 1}])
        self.assertEqual(set(manifest["files"]), names - {"MANIFEST.json"})
        for name, digest in manifest["files"].items():
            self.assertEqual(hashlib.sha256((self.target / name).read_bytes()).hexdigest(), digest)

    def refused(self, expected):
        with self.assertRaises(Complaint) as caught:
            release(self.root, self.target)
        self.assertIn(expected, str(caught.exception))
        self.assertEqual(list(self.target.parent.iterdir()), [])

    def test_a_solution_that_is_left_stops_it_however_it_is_laid_out(self):
        for name, text in (("doubled.hpp", "Real f() {\n return\n   2*number ; // so\n}"), ("task.md", "Write `return 2 * number;`."),
                           ("checks.cpp", "/* the answer */ return 2 * number;")):
            with self.subTest(name):
                file = self.exercise_folder / name
                before = file.read_text(encoding="utf-8")
                file.write_text(before + text, encoding="utf-8")
                self.commit()
                self.refused(f"exercises/01_force/doubled/{name} holds a part of the solution of 01_force/doubled")
                file.write_text(before, encoding="utf-8")

    def test_a_mark_or_a_folder_of_solutions_stops_it(self):
        (self.root / "chapters" / "solutions").mkdir()
        (self.root / "chapters" / "solutions" / "x.txt").write_text("x", encoding="utf-8")
        self.commit()
        self.refused("chapters/solutions/x.txt lies where solutions")
        shutil.rmtree(self.root / "chapters" / "solutions")
        (self.exercise_folder / "other.hpp").write_text("//! [solution] x\n", encoding="utf-8")
        self.commit()
        self.refused("other.hpp holds the mark of a solution")

    def test_what_is_not_committed_is_not_in_it_and_is_named(self):
        task, checks = self.exercise_folder / "task.md", self.exercise_folder / "checks.cpp"
        before = task.read_text(encoding="utf-8")
        task.write_text("of next year", encoding="utf-8")
        checks.unlink()
        (self.root / "class" / "ada").mkdir(parents=True)
        for name in ("class/ada/doubled.hpp", "marks.csv", "exercises/01_force/doubled/instructor.md"):
            (self.root / name).write_text("x", encoding="utf-8")
        with mock.patch.dict(os.environ, {"GIT_DIR": str(ROOT / ".git"), "GIT_WORK_TREE": str(ROOT), "GIT_INDEX_FILE": "/none"}):
            for _, left_out in (release(self.root, self.target), (0, package(self.root, [], self.root / "autograder.zip"))):
                self.assertEqual(left_out, dict.fromkeys(["exercises/01_force/doubled/checks.cpp", "exercises/01_force/doubled/task.md", "class/",
                                                          "marks.csv"], "it is not committed as it is here"))
        released = self.target / "exercises" / "01_force" / "doubled"
        self.assertEqual((released / "task.md").read_text(encoding="utf-8"), before)
        self.assertTrue((released / "checks.cpp").exists())
        self.assertFalse((self.target / "class").exists() or (self.target / "marks.csv").exists())

    def test_links_names_that_no_zip_can_hold_and_private_folders_are_left_out_and_named(self):
        (self.root / "link to a file").symlink_to("/etc/passwd")
        (self.root / "link to a folder").symlink_to("chapters")
        odd, private = os.fsdecode(b"caf\xe9"), "it belongs to a private folder, such as grade --private takes"
        (self.root / odd).write_text("x", encoding="utf-8")
        for folder in ("hidden", "class/exam", ""):
            shutil.copytree(self.exercise_folder, self.root / folder / "02_torque" / "exam")
            (self.root / folder / "key.txt").write_text("of the exam", encoding="utf-8")
        self.commit()
        _, left_out = release(self.root, self.target)
        for name in ("link to a file", "link to a folder"):
            self.assertEqual(left_out.pop(name), "it is a symbolic link")
        self.assertEqual(left_out.pop(odd), "its name is not UTF-8, so neither MANIFEST.json nor a zip can hold it")
        self.assertEqual(set(left_out.values()), {private})
        for name in ("hidden/key.txt", "class/exam/key.txt", "02_torque/exam/checks.cpp"):
            self.assertIn(name, left_out)
        self.assertEqual(sorted(file.name for file in self.target.iterdir()),
                         [".gitignore", "MANIFEST.json", "chapters", "exercises", "key.txt"])

    def test_an_exercise_that_is_not_committed_is_neither_named_nor_packed_to_be_graded(self):
        for folder in (self.exercise_folder, self.solution.parent):
            shutil.copytree(folder, folder.with_name("exam"))
            (folder.with_name("exam") / "doubled.hpp").rename(folder.with_name("exam") / "exam.hpp")
        exam, file = self.exercise_folder.with_name("exam"), self.target.parent / "autograder.zip"
        release(self.root, self.target)
        self.assertNotIn("exam", (self.target / "MANIFEST.json").read_text(encoding="utf-8"))
        with self.assertRaisesRegex(Complaint, "the exercise exam isn't committed, so the zip would not hold it"):
            package(self.root, read_catalogue(self.root), file)
        self.assertFalse(file.exists())
        (exam / "exercise.json").write_text("{", encoding="utf-8")  # nor does a mistake in one that is being written matter
        release(self.root, self.target.with_name("once more"))

    def test_the_rights_are_those_that_git_knows(self):
        program, task = self.exercise_folder / "program.sh", self.exercise_folder / "task.md"
        program.write_text("x", encoding="utf-8")
        program.chmod(0o4711)
        task.chmod(0o400)
        self.commit()
        mask = os.umask(0o077)
        self.addCleanup(os.umask, mask)
        release(self.root, self.target)
        for file, rights in ((program, 0o755), (task, 0o644)):
            self.assertEqual((self.target / file.relative_to(self.root)).stat().st_mode & 0o7777, rights)

    def test_where_a_link_leads_the_release_lies(self):
        for made in (False, True):
            with self.subTest(made=made):
                real, link = self.target.parent / f"real {made}", self.target.parent / f"link {made}"
                if made:
                    real.mkdir()
                link.symlink_to(real)
                release(self.root, link)
                self.assertTrue(link.is_symlink() and (real / "MANIFEST.json").exists())

    def test_a_damaged_toolchain_is_told(self):
        self.toolchain_file.write_text("{", encoding="utf-8")
        with self.assertRaises(Complaint) as caught:
            release(self.root, self.target, self.toolchain_file)
        self.assertIn("toolchain.json is damaged", str(caught.exception))

    def test_a_full_standard_output_and_a_signal_are_told_and_leave_nothing(self):
        words = [sys.executable, "-B", str(ROOT / "exercises" / "tools" / "release.py"), "--root", str(self.root), "--toolchain",
                 str(self.toolchain_file), str(self.target)]
        with open("/dev/full", "wb") as full:
            done = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=full, stderr=subprocess.PIPE, timeout=300)
        self.assertEqual((done.returncode, done.stderr), (2, b"course: what was to be written: No space left on device\n"))
        shutil.rmtree(self.target)
        git = self.target.parent / "git"  # whatever git says, it never comes
        git.write_text("#!/bin/sh\nkill -TERM $PPID\nsleep 60\n", encoding="utf-8")
        git.chmod(0o755)
        with subprocess.Popen(words, env={**os.environ, "PATH": f"{git.parent}:{os.environ['PATH']}"}) as running:
            self.assertEqual(running.wait(30), 143)

    def test_without_a_commit_nobody_can_tell_what_belongs_to_the_course(self):
        shutil.rmtree(self.root / ".git")
        self.refused("Where the course came without git: git init, git add of what belongs to it, and git commit")
        self.git("init", "--quiet")
        self.refused("git has no commit")
        self.git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "--allow-empty", "-m", "nothing")
        self.refused("holds nothing")
        with mock.patch.dict(os.environ, {"PATH": "/nowhere"}):
            self.refused("(git is not installed)")

    def test_without_the_solutions_nobody_can_tell(self):
        shutil.rmtree(self.root / "solutions")
        self.refused("nobody can tell whether anything of it is left")

    def test_what_is_there_is_never_overwritten(self):
        self.target.mkdir()
        (self.target / "precious").write_text("x", encoding="utf-8")
        with self.assertRaises(Complaint):
            release(self.root, self.target)
        self.assertEqual([file.name for file in self.target.iterdir()], ["precious"])
        with self.assertRaises(Complaint):
            release(self.root, self.root / "inside")


@unittest.skipUnless(TOOLCHAIN, "TUMBLE_TOOLCHAIN names no toolchain.json")
class OfTheCourse(unittest.TestCase):
    def test_bundled_it_configures_tests_and_judges_on_its_own(self):
        with tempfile.TemporaryDirectory(prefix="a release ") as folder:
            target = Path(folder) / "tumble"
            release(ROOT, target, TOOLCHAIN)
            build = target / "build" / "default"
            self.run_in(target, "cmake", "-S", ".", "-B", str(build), "-DCMAKE_BUILD_TYPE=Release")
            cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
            for package in ("Eigen3", "doctest"):
                self.assertIn(f"{package}_DIR:PATH={target}/third_party/", cache)
            self.run_in(target, "cmake", "--build", str(build), "--target", "judge_checks")
            tests = self.run_in(target, "ctest", "--test-dir", str(build), "-L", "exercises", "--output-on-failure")
            self.assertIn("100% tests passed", tests)
            student = [sys.executable, "-B", "exercises/tools/student.py", "--root", str(target),
                       "--toolchain", str(build / "exercises" / "toolchain.json")]
            self.run_in(target, *student, "start", "moon")
            self.assertIn("that is the Earth's", self.run_in(target, *student, "check", code=1))
            self.assertTrue((target / "third_party" / "licences" / "eigen3.txt").stat().st_size > 0)

    def run_in(self, folder, *command, code=0):
        result = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                timeout=600)
        text = result.stdout.decode("utf-8", "replace")
        self.assertEqual(result.returncode, code, text)
        return text
