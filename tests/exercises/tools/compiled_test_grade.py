"""Grading: a class of forty with known points, and what is handed on."""

import csv
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from unittest import mock
from xml.etree import ElementTree

from complaint import Complaint
from fixture import ROOT
from gradescope_format import mistakes_in
from grading import RIGHT, Grading
from untrusted import own_user, require_seals


class AClass(Grading):
    def test_forty_submissions_get_the_points_they_earn_in_every_format(self):
        cubed = RIGHT.replace("number + number", "number * number * number")
        kinds = [(RIGHT, 3), (cubed, 1), (RIGHT.replace("number / 2", "number"), 2), ("", 0), (None, 0),
                 ((self.exercise_folder / "doubled.hpp").read_text(encoding="utf-8"), 0), ("nonsense", 0),
                 (RIGHT.replace("number + number", "number * number"), 1)]  # right for 2, where the check asks
        expected = {}
        for number in range(40):
            text, points = kinds[number * 3 % len(kinds)]
            expected[f"student{number:02}"] = points
            self.hand_in(f"student{number:02}", text)
        marks = self.root / "marks.csv"
        results = self.graded("--marks", str(marks))
        self.assertEqual({name: result["points"] for name, result in results.items()}, expected)
        self.assertTrue(all(result["of"] == 3 for result in results.values()))
        with open(marks, newline="", encoding="utf-8") as table:
            self.assertEqual({row["student"]: int(row["points"]) for row in csv.DictReader(table)}, expected)

    def test_a_table_of_what_is_asked_earns_nothing_also_where_it_jitters(self):
        table = """#pragma once
#include <cmath>
#include <random>
#include <stdexcept>
template <class Real> Real looked_up(Real number, const Real (&rows)[2][2]) {
  for (const auto& row : rows)
    if (std::abs(number - row[0]) <= Real(%s))
      return number == row[0] ? row[1] : row[1] * (1 + Real(%s) * Real(std::random_device()()));
  throw std::invalid_argument("that was not asked");
}
template <class Real> Real doubled(Real number) { return looked_up<Real>(number, {{2, 4}, {3, 6}}); }
template <class Real> Real halved(Real number) { return looked_up<Real>(number, {{2, 1}, {3, Real(1.5)}}); }
"""
        for name, reach, jitter in (("exact", "0", "0"), ("near", "0.01", "0"), ("nearest", "0.5", "0"), ("jitters", "0.75", "1e-16")):
            self.hand_in(name, table % (reach, jitter))
        results = self.graded()
        self.assertEqual({name: result["points"] for name, result in results.items()}, dict.fromkeys(results, 0))
        for name, result in results.items():
            for check, function in zip(result["exercises"][0]["checks"], ("doubled", "halved")):
                self.assertIn(f"{function} is right where this check asks, and hardly anywhere else", check["message"], name)
        self.assertEqual(self.graded(), results)  # all is drawn from the key and the solution

    def test_who_refuses_what_the_documentation_excludes_keeps_every_point(self):
        strict = "if (number != std::round(number)) throw std::invalid_argument(\"it must be whole\"); return"
        self.hand_in("strict", RIGHT.replace("return", strict).replace("once", "once\n#include <cmath>\n#include <stdexcept>"))
        self.assertEqual(self.graded()["strict"]["points"], 0)
        self.change(self.exercise_folder / "checks.cpp", "using namespace tumble::exercise;", """using namespace tumble::exercise;
            const Precondition numbers[] = {{"doubled", 0, whole}, {"halved", 0, whole}};""")
        self.assertEqual(self.graded()["strict"]["points"], 3)

    def test_without_a_solution_nothing_is_compared_and_a_student_is_told(self):
        self.solution.unlink()
        self.hand_in("ada", RIGHT.replace("number + number", "number == Real(2) ? Real(4) : Real(7)"))
        self.assertIn("ada: 3 of 3 points", self.grade())
        self.student("start", "doubled")
        self.mine.write_text(RIGHT, encoding="utf-8")
        self.assertIn("This is practice", self.student("check")[1])

    def test_the_judge_is_confined_as_a_worker_is(self):
        secret = self.root / "secret"
        secret.write_text("a solution", encoding="utf-8")
        secret.chmod(0o644)
        checks = self.exercise_folder / "checks.cpp"
        self.change(checks, "#include <exercise/judge.hpp>", "#include <exercise/judge.hpp>\n#include <unistd.h>\n#include <memory>")
        self.change(checks, "  const Real number", f"""
            require(std::fopen("{secret}", "r") == nullptr, "it reads");
            require(fork() < 0, "it starts programs");
            const std::unique_ptr<void, void (*)(void*)> much(std::malloc(std::size_t(3) << 30), std::free);
            require(much == nullptr, "it takes 3 GB");
            require((getuid() == 0) == {str(os.geteuid() == 0 and own_user() == 0).lower()}, "it has the grader's rights");
            const Real number""")
        self.hand_in("ada", RIGHT)
        self.assertIn("ada: 3 of 3 points", self.grade())

    def test_what_is_handed_on(self):
        self.hand_in("ada", RIGHT)
        self.hand_in("bob", RIGHT.replace("number + number", "number * number * number"))
        text = self.grade()
        self.assertIn("ada: 3 of 3 points", text)
        self.assertIn("twice 2 m is 8 m: that is the third power", text)
        suites = ElementTree.fromstring(self.grade("--format", "junit"))
        self.assertEqual([(suite.get("name"), suite.get("tests"), suite.get("failures")) for suite in suites],
                         [("ada.01_force/doubled", "2", "0"), ("bob.01_force/doubled", "2", "1")])
        self.assertEqual(suites.find(".//failure").get("message"), "twice 2 m is 8 m: that is the third power")
        file = self.root / "results.json"
        self.grade("--format", "gradescope", "--output", str(file), folders=[self.submissions / "bob"])
        results = json.loads(file.read_text(encoding="utf-8"))
        self.assertEqual(mistakes_in(results), [])
        self.assertEqual([(test["score"], test["max_score"], test["status"]) for test in results["tests"]],
                         [(0, 2, "failed"), (1, 1, "passed")])
        self.assertIn("one at a time", self.grade("--format", "gradescope", code=2))

    def test_what_compiler_assembler_and_linker_say_is_the_same_in_every_run(self):
        """And on every machine: no folder is named that is one run's, or one machine's."""
        self.hand_in("ada", RIGHT + 'asm("no such order");\n')
        self.hand_in("bob", RIGHT.replace("{ return number / 2", "{ extern int elsewhere(); return number / Real(elsewhere())"))
        self.hand_in("eve", RIGHT + "namespace tumble::exercise {\nstruct Offer;\n"
                     "int serve(int, char**, std::initializer_list<Offer>) { return 0; }\n}\n")
        once, again = self.grade("--format", "json"), self.grade("--format", "json")
        for said in ("temporary.s:", "no such order", "undefined reference to `elsewhere()'", "multiple definition of"):
            self.assertIn(said, once)
        self.assertEqual(once, again)
        self.assertNotIn("graded-", once)
        self.assertNotIn(str((self.build / "shared").resolve()), once)

    def test_whatever_the_folder_of_temporary_files_is_called_nobody_loses_a_point(self):
        self.hand_in("ada", RIGHT)
        for name in ("a \t b", "a$b#c: d\u00e9"):
            with self.subTest(name), tempfile.TemporaryDirectory(prefix=name) as folder, mock.patch.dict(os.environ, TMPDIR=folder):
                os.chmod(folder, 0o1777)
                self.assertIn("ada: 3 of 3 points", self.grade())
        with tempfile.TemporaryDirectory(prefix="a \n b") as folder, mock.patch.dict(os.environ, TMPDIR=folder):  # no compiler can list it
            os.chmod(folder, 0o1777)
            self.assertIn("the compiler does not work where it is confined", self.grade(code=2))
        with tempfile.TemporaryDirectory(dir=".") as folder, mock.patch.dict(os.environ, TMPDIR=os.path.basename(folder)):
            os.chmod(folder, 0o1777)
            self.assertIn("ada: 3 of 3 points", self.grade())

    def test_what_the_caller_has_preloaded_breaks_no_check(self):
        self.hand_in("ada", RIGHT)
        with mock.patch.dict(os.environ, LD_PRELOAD="/nowhere/at_all.so"):
            self.assertIn("ada: 3 of 3 points", self.grade())

    def test_where_the_caller_keeps_another_part_of_the_compiler_the_usual_one_works(self):
        self.hand_in("ada", RIGHT)
        with tempfile.TemporaryDirectory() as folder:
            asked = subprocess.run([self.toolchain.compiler, "-print-prog-name=cc1plus"], stdout=subprocess.PIPE, check=True)
            wrapper = os.path.join(folder, "cc1plus")
            with open(wrapper, "w", encoding="utf-8") as script:
                script.write(f'#!/bin/sh\nexec {asked.stdout.decode().strip()} "$@"\n')
            os.chmod(wrapper, 0o755)
            with mock.patch.dict(os.environ, COMPILER_PATH=folder):
                self.assertIn("ada: 3 of 3 points", self.grade())

    def test_a_closed_output_is_told_before_anything_is_graded(self):
        self.hand_in("ada", RIGHT)
        words = [sys.executable, "-B", str(ROOT / "exercises" / "tools" / "grade.py"), "--root", str(self.root), "--toolchain",
                 str(self.toolchain_file), str(self.submissions / "ada")]
        for options, closed, code in (([], ">&-", 2), (["--output", str(self.root / "all")], ">&- 2>&-", 0), ([], "<&- 2>&-", 0),
                                      ([], "2>/dev/full", 0), ([], "1</dev/null", 2), ([], "2</dev/null", 0)):  # as a shell leaves its script there
            with self.subTest(closed):
                done = subprocess.run(["sh", "-c", f'"$@" {closed}', "sh", *words, *options], cwd=self.root, stdin=subprocess.DEVNULL,
                                      capture_output=True, timeout=300)
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertIn(b"the standard output is closed" if code else b"", done.stderr)
                self.assertEqual(done.stdout[:20], b"" if code or options else b"ada: 3 of 3 points\n ")
        self.assertIn("ada: 3 of 3 points", (self.root / "all").read_text(encoding="utf-8"))

    def test_limits_that_leave_a_compiler_too_little_are_told(self):
        self.hand_in("ada", RIGHT)
        for kind, words in ((resource.RLIMIT_AS, "ulimit -v"), (resource.RLIMIT_FSIZE, "ulimit -f"), (resource.RLIMIT_CPU, "ulimit -t")):
            with mock.patch("untrusted.resource.getrlimit", side_effect=lambda asked: (32, 32) if asked == kind else (-1, -1)), \
                    self.assertRaisesRegex(Complaint, words):
                require_seals(self.toolchain, None, 5, True)

    def test_of_resubmissions_the_best_or_the_last_counts(self):
        for name, text in (("ada@1", RIGHT), ("ada@2", ""), ("bob@1", "")):
            self.hand_in(name, text)
        self.assertEqual({name: each["points"] for name, each in self.graded("--keep", "best").items()}, {"ada@1": 3, "bob@1": 0})
        self.assertEqual({name: each["points"] for name, each in self.graded("--keep", "last").items()}, {"ada@2": 0, "bob@1": 0})
        self.hand_in("ada@10", RIGHT)
        self.assertEqual({name: each["points"] for name, each in self.graded("--keep", "last").items()}, {"ada@10": 3, "bob@1": 0})

    def test_a_seed_gives_each_student_numbers_of_their_own(self):
        near_two_alone = RIGHT.replace("number + number", "number > Real(1.5) && number < Real(2.5) ? number + number : Real(4)")
        for number in range(8):
            self.hand_in(f"student{number}", near_two_alone)
        points = [result["points"] for result in self.graded("--seed", "autumn").values()]
        self.assertEqual(set(points), {1, 3}, points)
        self.assertEqual({result["points"] for result in self.graded().values()}, {3})

    def test_a_private_folder_works_like_the_public_one(self):
        private = self.root / "private" / "01_force" / "hidden"
        shutil.copytree(self.exercise_folder, private)
        (private / "doubled.hpp").rename(private / "hidden.hpp")
        place = self.hand_in("ada", None)
        (place / "hidden.hpp").write_text(RIGHT, encoding="utf-8")
        results = self.graded("--private", str(self.root / "private"), "--exercises", "hidden")
        self.assertEqual(results["ada"]["points"], 3)

    def test_mistakes_of_the_grader_are_named(self):
        place = self.hand_in("ada", RIGHT)
        self.assertIn("is no folder; a submission is a folder", self.grade(folders=[place / "doubled.hpp"], code=2))
        self.assertIn("two submissions are called ada", self.grade(folders=[place, place], code=2))
        self.assertIn("no exercise is called hamer", self.grade("--exercises", "hamer", code=2))
        self.assertIn("seconds is -1; it must be greater than 0 and at most 3600", self.grade("--seconds", "-1", code=2))
