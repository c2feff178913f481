"""A student's whole way: start, fail, ask, solve, compare, and all of it without solutions/ as well."""

import contextlib
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from compiled_test_endings import COMPILES, descendants, name_of
from fixture import PLACE, ROOT, FixtureCourse
from made import held

SOLVED = """#pragma once
template <class Real> Real doubled(Real number) { return number + number; }
template <class Real> Real halved(Real number) { return number / 2; }
"""


class Way(FixtureCourse):
    def says(self, *words, code=0):
        found, text = self.student(*words)
        self.assertEqual(found, code, text)
        return text

    def write(self, text):
        self.mine.write_text(text, encoding="utf-8")

    def test_from_start_to_compare(self):
        self.assertIn("./course start doubled", self.says("next"))
        self.assertIn("which exercise?", self.says("check", code=2))
        self.assertIn("was not started yet: ./course start doubled", self.says("check", "doubled", code=2))
        self.assertIn("your copy  work/01_force/doubled/doubled.hpp", self.says("start", "doubled"))
        self.assertEqual((self.mine.parent / "task.md").read_text(encoding="utf-8"), "Double 2 m.\n")

        text = self.says("check", code=1)
        self.assertIn(" . Twice two is four", text)
        self.assertIn("not written yet: twice the number", text)
        self.assertIn(" x Half of two is one", text)
        self.assertIn("half of 2 m is 2 m; it must be 1 m", text)
        self.assertIn("0 of 3 points", text)
        self.assertIn("first solve it", self.says("compare", code=2))

        self.write(SOLVED.replace("number + number", "number * number * number"))
        text = self.says("check", str(self.mine), code=1)
        self.assertIn("twice 2 m is 8 m: that is the third power", text)
        self.assertIn("1 of 3 points", text)

        self.write(SOLVED)
        text = self.says("check", "01_force/doubled")
        self.assertIn("Solved. How to double.", text)
        self.assertIn("Every exercise is solved", text)
        self.assertIn("[##########]  3 of 3  solved", self.says("progress"))
        text = self.says("compare")
        self.assertIn("+  return 2 * number;", text)
        self.assertNotIn("[solution]", text)
        self.assertIn("Why: because.", text)

    def test_the_next_one_comes_after_the_one_last_worked_on_and_the_first_after_the_last(self):
        for name in ("tripled", "first"):
            folder = self.exercise_folder.with_name(name)
            shutil.copytree(self.exercise_folder, folder)
            (folder / "doubled.hpp").rename(folder / f"{name}.hpp")
        for name, expected in (("first", "tripled"), ("tripled", "doubled")):
            self.says("start", name)
            (self.root / "work" / "01_force" / name / f"{name}.hpp").write_text(SOLVED, encoding="utf-8")
            self.assertIn(f"./course start {expected}", self.says("check"))
            self.assertIn(f"./course start {expected}", self.says("next"))

    def test_a_missing_brace_and_an_expression_in_a_vectors_place_are_explained(self):
        self.says("start", "doubled")
        self.write(SOLVED.replace("number / 2; }", "number / 2;"))
        text = self.says("check", code=1)
        self.assertIn("doubled.hpp:3: error: a closing brace is missing", text)
        self.assertNotIn("answers_double.cpp", text)
        self.write("#include <tumble/real.hpp>\n" + SOLVED.replace("#pragma once", """#pragma once
            template <class Real> Real length(const tumble::Vec3<Real>& v) { return v.norm(); }
            """).replace("number / 2", "length(tumble::Vec3<Real>(number, 0, 0) / 2)"))
        text = self.says("check", code=1)
        self.assertIn("Make it one first: Vec3<Real>(a + b)", text)
        self.assertIn("error: no matching function", text)

    def test_three_hints_each_saying_more(self):
        self.says("start", "doubled")
        self.assertIn("Hint 1 of 3", self.says("hint"))
        self.assertIn("Add it to itself.", self.says("hint"))
        self.assertIn("number + number", self.says("hint"))
        self.assertIn("Hint 3 of 3", self.says("hint"))
        self.assertIn("begun, 3 of 3 hints", self.says("progress"))

    def test_without_solutions_all_works_but_compare(self):
        shutil.rmtree(self.root / "solutions")
        shutil.rmtree(self.root / "tests")
        self.says("start", "doubled")
        self.write(SOLVED)
        self.assertNotIn("compare", self.says("check"))
        self.assertIn("holds no solutions", self.says("compare", code=2))
        self.says("hint")
        self.says("reset")

    def test_the_compilers_first_error_is_shown_with_the_students_line(self):
        self.says("start", "doubled")
        self.write(SOLVED.replace("number / 2", "numbre / 2"))
        text = self.says("check", code=1)
        self.assertIn("doubled.hpp:3: error: ‘numbre’ was not declared", text)
        self.assertNotIn("answers_double.cpp", text)
        self.assertLess(len(text.splitlines()), 12)

    def test_a_warning_is_shown_and_is_no_failure(self):
        self.says("start", "doubled")
        self.write(SOLVED.replace("{ return number / 2", "{ int unused = 1; return number / 2"))
        self.assertIn("The compiler wonders:\ndoubled.hpp:3: warning: unused variable", self.says("check"))

    def test_accidents_are_explained(self):
        self.says("start", "doubled")
        for code, expected in (
                ("for (;;) {}", "no answer after 5 seconds. Is there a loop that never ends?"),
                ("int* p = nullptr; *p = 1; return number;", "the program crashed: it read or wrote where nothing is"),
                ("throw std::runtime_error(\"no idea\");", "doubled gave up where it should have answered: \"no idea\""),
                ("std::exit(0);", "ended by itself, with exit code 0, before it had answered"),
                ("Eigen::VectorXd v(2); return Real(v(3));", "failed assertion"),
                ("std::vector<double> v(1ul << 40); return Real(v.size());", "bad_alloc"),
                ("return number / 0;", "twice 2 m is inf m; it must be 4 m"),
                ("return std::numeric_limits<Real>::quiet_NaN();", "twice 2 m is nan m: that is not a number")):
            with self.subTest(code):
                self.write(SOLVED.replace("return number + number;", code))
                text = " ".join(self.says("check", code=1).split())
                self.assertIn(expected, text)
                self.assertIn("+ Half of two is one", text)

    def test_what_compiles_and_a_grader_would_not_take_gets_no_points_here_either(self):
        self.says("start", "doubled")
        self.mine.write_bytes(b"// H\xf6he\n" + SOLVED.encode())
        text = self.says("check", code=1)
        self.assertIn("It can't be graded: the header is not UTF-8: byte 4 is 0xf6; save doubled.hpp as UTF-8.", text)
        self.assertIn("no points yet", text)

    def test_what_a_grader_would_refuse_is_refused_here_for_the_same_reason(self):
        self.says("start", "doubled")
        with_threads = """#pragma once
#include <thread>
template <class Real> Real doubled(Real number) { Real twice = 0; std::thread([&] { twice = 2 * number; }).join(); return twice; }
template <class Real> Real halved(Real number) { return number / 2; }
"""
        (self.mine.parent / "helper.hpp").write_text("#pragma once\n", encoding="utf-8")
        elsewhere = self.root / "elsewhere.hpp"
        elsewhere.write_text("#pragma once\n", encoding="utf-8")
        for text, words in ((with_threads, "it may start no thread"),
                            (f'#include "helper.hpp"\n{SOLVED}', "doubled.hpp is handed in alone"),
                            (f'#include "{elsewhere}"\n{SOLVED}', "it includes elsewhere.hpp, which is no part of the chapters")):
            with self.subTest(words):
                self.write(text)
                self.assertIn(words, " ".join(self.says("check", code=1).split()))
                graded = subprocess.run([sys.executable, "-B", str(ROOT / "exercises" / "tools" / "grade.py"), "--root", str(self.root),
                                         "--toolchain", str(self.toolchain_file), "--unsealed", "--part", str(self.root / words[:9]), "--format",
                                         "json", str(self.root / "work")], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=True,
                                        timeout=300).stdout.decode()
                self.assertNotIn('"points": 3', graded)
                # A file that can't be reached at all is told as the compiler does.
                self.assertIn("elsewhere.hpp" if "elsewhere" in words else words, graded)

    def test_nothing_that_a_student_writes_steers_the_terminal(self):
        self.says("start", "doubled")
        steering = '\\x1b]0;owned\\x07\\x1b[2J\\xc2\\x9b" "31m'
        self.write("#include <cstdio>\n" + SOLVED.replace("return number + number", f'std::puts("{steering}"); return number + number'))
        text = self.says("check")
        self.assertIn("  | \\x1b]0;owned\\x07\\x1b[2J\\x9b31m", text)
        for code in (f'throw std::runtime_error("{steering}"); return number + number', "return \x1b[2J number"):
            self.write("#include <stdexcept>\n" + SOLVED.replace("return number + number", code))
            text += self.says("check", code=1)
        self.assertTrue(all(letter.isprintable() or letter == "\n" for letter in text), ascii(text))

    def test_a_file_that_is_not_there_is_no_file_of_the_exercise(self):
        self.says("start", "doubled")
        text = self.says("check", "work/01_force/doubled/nosuch.hpp", code=2)
        self.assertIn("nosuch.hpp, which is no file of doubled; yours is doubled.hpp", text)
        self.says("check", "work/01_force/doubled/doubled.hpp", code=1)

    def test_an_empty_file_was_not_started(self):
        self.says("start", "doubled")
        self.write("")
        self.assertIn("was not started yet: ./course start doubled", self.says("check", "doubled", code=2))
        self.assertNotIn("kept as you left it", self.says("start", "doubled"))
        self.assertEqual(self.mine.read_bytes(), (self.exercise_folder / "doubled.hpp").read_bytes())

    def test_where_nothing_can_be_written_a_sentence_says_so(self):
        work = self.root / "work"
        work.write_text("in the way", encoding="utf-8")
        for words in (("start", "doubled"), ("hint", "doubled"), ("start", "doubled", "--key", "k3")):
            self.assertRegex(self.says(*words, code=2), r"^course: .*work.*: (Not a directory|File exists)\n$")
        work.unlink()
        self.says("start", "doubled")
        self.write(SOLVED)
        (work / "progress.txt").unlink()
        (work / "progress.txt").mkdir()
        self.assertRegex(self.says("check", "doubled", code=2), r"course: .*work/progress\.txt: Is a directory\n$")

    @unittest.skipUnless(os.geteuid() == 0, "only root can make a small disk")
    def test_on_a_full_disk_nothing_is_half_written(self):
        work = self.root / "work"
        work.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", str(work)], stderr=subprocess.DEVNULL).returncode != 0:
            self.skipTest("here nothing can be mounted")
        self.addCleanup(subprocess.run, ["umount", "--lazy", str(work)])
        filler = work / "filler"
        with open(filler, "wb", buffering=0) as out, contextlib.suppress(OSError):
            while True:
                out.write(bytes(4096))
        self.assertRegex(self.says("start", "doubled", code=2), "^course: .*No space left on device\n$")
        os.truncate(filler, filler.stat().st_size - 4096)  # now there is room for the task and for nothing else
        self.assertRegex(self.says("start", "doubled", code=2), "^course: .*No space left on device\\n$")
        self.assertEqual({file.name for file in work.rglob("*") if file.is_file()}, {"filler", "task.md"})
        filler.unlink()
        self.says("start", "doubled")
        self.write(SOLVED)
        with open(filler, "wb", buffering=0) as out, contextlib.suppress(OSError):
            while True:
                out.write(bytes(4096))
        self.assertRegex(self.says("reset", "doubled", code=2), "No space left on device\n$")
        self.assertEqual(self.mine.read_text(encoding="utf-8"), SOLVED)
        subprocess.run(["mount", "-o", "remount,ro", str(work)], check=True)
        self.assertRegex(self.says("reset", "doubled", code=2), "^course: .*Read-only file system\n$")
        self.assertRegex(self.says("hint", "doubled", code=2), "^course: .*progress.txt: Read-only file system\n$")

    def test_two_first_checks_at_once_both_get_their_verdict(self):
        for name in ("precompiled", "shared"):  # those of all the tests would be there already
            (self.build / name).unlink()
            (self.build / name).mkdir()
        self.place_a_solved_copy()
        words = [sys.executable, "-B", str(ROOT / "exercises" / "tools" / "student.py"), "--root", str(self.root),
                 "--toolchain", str(self.toolchain_file), "check", "doubled"]
        both = [subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT) for _ in range(2)]
        for process in both:
            text = process.communicate(timeout=300)[0].decode()
            self.assertEqual(process.returncode, 0, text)
            self.assertIn("3 of 3 points", text)

    def place_a_solved_copy(self):
        self.mine.parent.mkdir(parents=True)
        self.write(SOLVED)

    def test_what_the_code_prints_is_shown(self):
        self.says("start", "doubled")
        self.write("#include <cstdio>\n" + SOLVED.replace("return number + number", 'std::puts("hello"); return number + number'))
        self.assertIn("  | hello", self.says("check"))

    def test_a_key_draws_other_numbers(self):
        self.says("start", "doubled", "--key", "k3")
        task = (self.mine.parent / "task.md").read_text(encoding="utf-8")
        self.assertIn(f"twice {task.split()[1]} m is", self.says_after_writing("return 100 * number;"))

    def says_after_writing(self, code):
        self.write(SOLVED.replace("return number + number;", code))
        return self.says("check", code=1)

    def test_unknown_words_get_the_nearest_one(self):
        text = self.says("start", "dubled", code=2)
        self.assertIn("no exercise is called dubled\nDid you mean doubled?\nThe exercises are: doubled", text)

    def test_reset_brings_the_starter_back_and_keeps_a_copy(self):
        self.says("start", "doubled")
        self.write(SOLVED)
        self.assertIn("is the starter again; what was there is doubled.2", self.says("reset"))
        self.assertIn("todo", self.mine.read_text(encoding="utf-8"))
        self.assertEqual([file.read_text(encoding="utf-8") for file in self.mine.parent.glob("doubled.2*.hpp")], [SOLVED])

    def test_a_pull_never_meets_a_students_file(self):
        """Everything that the commands write is below work/, which git ignores, or in the build."""
        self.says("start", "doubled")
        self.write(SOLVED)
        before = self.files()
        for words in (("check",), ("hint",), ("progress",), ("compare",), ("reset",)):
            self.says(*words)
        self.assertEqual(self.files(), before)
        self.assertIn("/work/\n", (ROOT / ".gitignore").read_text(encoding="utf-8"))

    def files(self):
        return {str(file): file.stat().st_mtime_ns for folder in ("exercises/01_force", "solutions", "tests")
                for file in (self.root / folder).rglob("*") if file.is_file()}

    def test_watch_gives_a_verdict_at_every_save_until_it_is_interrupted(self):
        self.says("start", "doubled")
        shutil.copyfile(self.exercise_folder / "doubled.hpp", self.mine)
        process = self.begin("watch", "doubled")
        self.wait_for(process, b"Watching")
        beside = self.mine.with_suffix(".new")
        beside.write_text(SOLVED, encoding="utf-8")
        os.replace(beside, self.mine)
        self.wait_for(process, b"Solved.")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=30), 0)

    def begin(self, *words):
        process = subprocess.Popen([sys.executable, "-B", str(ROOT / "exercises" / "tools" / "student.py"), "--root", str(self.root),
                                    "--toolchain", str(self.toolchain_file), *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def test_a_replay_is_announced_before_it_is_made(self):
        self.says("start", "doubled")
        self.write(SOLVED)
        (self.exercise_folder / "show.cpp").write_text("""#include <filesystem>
            #include <fstream>
            int main(int, char** arguments) {
              while (!std::filesystem::exists(std::string(arguments[1]) + ".seen")) {}
              std::ofstream(arguments[1]) << "a page";
            }""", encoding="utf-8")
        page = self.mine.with_suffix(".html")
        process = self.begin("check", "doubled")
        self.assertTrue(any(b"Making the replay" in line for line in process.stdout))
        self.assertFalse(page.exists())
        Path(f"{page}.seen").touch()
        self.assertIn(b"See it move", process.stdout.read())
        self.assertEqual(page.read_text(encoding="utf-8"), "a page")

    def test_whatever_signal_ends_a_check_no_compiler_runs_on(self):
        self.says("start", "doubled")
        self.write(COMPILES)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            with self.subTest(number.name):
                process = self.begin("check", "doubled")
                deadline, compilers = time.monotonic() + 120, set()
                while not any("cc1plus" in name_of(each) and "answers_double" in name_of(each) for each in compilers):
                    self.assertLess(time.monotonic(), deadline)
                    time.sleep(0.05)
                    compilers = descendants(process.pid)
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=60), -number if number == signal.SIGKILL else 128 + number)
                while any(name_of(each) for each in compilers):
                    self.assertLess(time.monotonic(), deadline)
                    time.sleep(0.05)

    def test_a_second_check_waits_for_the_first(self):
        self.says("start", "doubled")
        self.write(SOLVED)
        mine = self.build / PLACE / "mine"
        mine.mkdir(parents=True, exist_ok=True)
        with held(mine / "check"):
            process = self.begin("check", "doubled")
            self.wait_for(process, b"Waiting for another run")
            self.assertFalse((mine / "worker_double").exists())
        self.wait_for(process, b"3 of 3 points")

    def wait_for(self, process, word):
        seen, deadline = b"", time.monotonic() + 120
        while word not in seen:
            self.assertLess(time.monotonic(), deadline, seen)
            piece = os.read(process.stdout.fileno(), 4096)
            self.assertTrue(piece, seen)
            seen += piece
