"""Processes end with the grader, however that ends; where the grader fails nobody gets 0 points."""

import errno
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from dataclasses import replace
from pathlib import Path
from unittest import mock

import untrusted
from catalogue import read_catalogue
from complaint import GraderFailed
from confined import Ran, run_confined
from fixture import PLACE, ROOT
from grading import RIGHT, Grading
from limits import Limits
from programs import Judge, prepare
from run_check import BROKEN, FAILED, run_check
from untrusted import Uncompiled, a_workshop, own_user, seals

COMPUTES = "#include <ctime>\n" + RIGHT.replace("return number", "while (clock() < CLOCKS_PER_SEC / 3) {}\n  return number")
SLEEPS = "#include <unistd.h>\n" + RIGHT.replace("return number + number;", "for (;;) pause();\n  return number;")
COMPILES = """template <int n> constexpr int slow() {
  int seed = n;
  for (int i = 0; i < 200000; ++i) seed = (seed * 5 + i) % 1000003;
  return seed;
}
template <int n> struct Slow { static constexpr int value = slow<n>() % 2 + Slow<n - 1>::value; };
template <> struct Slow<0> { static constexpr int value = 0; };
""" + RIGHT.replace("number + number", "number * Slow<800>::value")
KILLED = "fatal error: Killed signal terminated program cc1plus\ncompilation terminated."
LACKS_LANDLOCK = Path(__file__).with_name("without_landlock.py")


def descendants(process):
    """Numbers of the processes that it started, and that those started."""
    parents = {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            text = status.read_text(encoding="utf-8", errors="replace")
            number, parent = re.match(r"(\d+) \(.*\) [^Z] (\d+)", text, re.DOTALL).groups()
        except (OSError, AttributeError):
            continue
        parents[int(number)] = int(parent)
    found = {process}
    while True:
        more = {number for number, parent in parents.items() if parent in found} - found
        if not more:
            return found - {process}
        found |= more


def name_of(process):
    try:
        return Path(f"/proc/{process}/cmdline").read_text(encoding="utf-8", errors="replace").replace("\0", " ")
    except OSError:
        return ""


class Endings(Grading):
    def setUp(self):
        super().setUp()
        self.exercise = read_catalogue(self.root)[0]
        prepare(self.toolchain, self.exercise)

    def until(self, found):
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            if found():
                return
            time.sleep(0.05)
        self.fail("it did not come to that")

    def one(self):
        """grade_one with its task, as grade starts it."""
        task = {"root": str(self.root), "toolchain": str(self.toolchain_file), "submission": str(self.submissions / "ada"),
                "exercises": [PLACE], "seconds": 60, "key": "", "private": None, "caller": os.getpid()}
        return [sys.executable, "-B", str(ROOT / "exercises" / "tools" / "grade_one.py")], json.dumps(task).encode()

    def after_an_end(self, text, stage, end):
        """Starts a grader, waits until a process whose command holds `stage` runs, and lets `end` end something of it."""
        shutil.rmtree(self.submissions / "ada", ignore_errors=True)
        self.hand_in("ada", text)
        temporary = Path(tempfile.mkdtemp(dir=self.root))
        temporary.chmod(0o755)
        with subprocess.Popen(self.command("--seconds", "60"), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, env={**os.environ, "TMPDIR": str(temporary)}) as grader:
            try:
                self.until(lambda: any(stage in name_of(each) for each in descendants(grader.pid)))
                started = descendants(grader.pid)
                end(grader, started)
                self.until(lambda: not any(name_of(each) for each in started))
            finally:
                grader.kill()
        return list(temporary.iterdir())

    def test_whatever_signal_ends_the_grader_nothing_runs_on_and_nothing_is_left(self):
        for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGKILL):
            with self.subTest(number.name):
                left = self.after_an_end(SLEEPS, "made/answers_double", lambda grader, _: grader.send_signal(number))
                self.assertEqual([place for place in left if place.name.startswith("graded-")], [])

    def test_a_compiler_ends_with_the_grader(self):
        for number in (signal.SIGTERM, signal.SIGKILL):
            with self.subTest(number.name):
                self.after_an_end(COMPILES, "text/answers_double.cpp", lambda grader, _: grader.send_signal(number))

    def test_who_comes_to_work_after_the_grader_has_ended_goes_again(self):
        self.hand_in("ada", COMPILES)
        with subprocess.Popen(["true"]) as ended:
            pass
        command, task = self.one()
        task = json.dumps({**json.loads(task), "caller": ended.pid}).encode()
        result = subprocess.run(command, input=task, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=30)
        self.assertEqual((result.returncode != 0, result.stdout), (True, b""))

    def test_of_keeper_and_worker_either_ends_what_the_other_leaves(self):
        for which in (0, 1):
            with self.subTest(which):
                def end(_, started):
                    graders = sorted(each for each in started if "grade_one.py" in name_of(each))
                    os.kill(graders[which], signal.SIGKILL)
                self.after_an_end(COMPILES, "text/answers_double.cpp", end)

    def test_a_job_that_is_suspended_for_longer_than_a_check_may_take_loses_nobody_a_point(self):
        self.hand_in("ada", COMPUTES)
        with subprocess.Popen(self.command("--format", "json", "--seconds", "1"), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL) as grader:
            self.addCleanup(grader.kill)
            self.until(lambda: self.worker_of(grader))
            self.freeze({grader.pid, *descendants(grader.pid)}, 5)  # a check has four seconds by the clock
            result, = json.loads(grader.communicate(timeout=300)[0])
        self.assertEqual(result["points"], 3, result["exercises"])

    def worker_of(self, grader):
        return next((each for each in descendants(grader.pid) if "/made/answers_double" in name_of(each).split(" ")[0]), None)

    def test_an_answer_that_gets_no_processor_gets_the_marks_of_one_that_does(self):
        self.hand_in("ada", COMPUTES)
        self.hand_in("bob", COMPUTES)
        with subprocess.Popen(self.command("--format", "json", "--seconds", "1", "--jobs", "1"), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as grader:
            self.addCleanup(grader.kill)
            while not (worker := self.worker_of(grader)):
                time.sleep(0.05)
            os.kill(worker, signal.SIGSTOP)  # as where others have all the machine's time
            results = json.loads(grader.communicate(timeout=600)[0])
        self.assertEqual([result["points"] for result in results], [3, 3], results)

    def test_who_waits_for_ever_has_no_points_and_who_is_never_let_run_has_no_result(self):
        self.hand_in("eve", "#include <mutex>\n" + RIGHT.replace("return number", "std::mutex once;\n  once.lock();\n  once.lock();\n  return number"))
        graded = self.graded("--seconds", "0.5")["eve"]
        self.assertEqual(graded["points"], 0)
        self.assertIn("no answer: it waits for something that never happens", graded["exercises"][0]["checks"][0]["message"])
        stopped = self.root / "stopped"
        stopped.write_text("#!/bin/sh\nkill -STOP $$\n", encoding="utf-8")
        stopped.chmod(0o755)
        outcome = run_check(prepare(self.toolchain, self.exercise), 0, {"double": stopped}, (("number", 2),), Limits(seconds=0.5))
        self.assertEqual(outcome.status, BROKEN)
        self.assertIn("no verdict after 2 s by the clock, of which 0.0 s", outcome.message)

    def test_the_clock_alone_ends_no_compiler_at_a_students_cost(self):
        for ran, error, expected in ((Ran(-9, b"", "time"), GraderFailed, "the compiler came to no end in 240 s by the clock"),
                                     (Ran(1, b"CPU time limit exceeded"), Uncompiled, "it took more than 60 seconds")):
            with a_workshop(self.toolchain, self.exercise, own_user(), 60) as workshop:
                with mock.patch.object(untrusted, "run_confined", lambda *_, ran=ran: ran), self.assertRaisesRegex(error, expected):
                    workshop._workers(RIGHT, workshop._patience())

    def test_a_compiler_that_is_suspended_is_waited_for(self):
        program = ("from confined import run_confined; from limits import Limits; from patience import Patience;"
                   "print(run_confined(['sleep', '1'], Limits(), '/', Patience(2)).cut or 'to its end')")
        with subprocess.Popen([sys.executable, "-B", "-c", program], cwd=ROOT / "exercises" / "tools", stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE) as waiting:
            self.addCleanup(waiting.kill)
            self.until(lambda: any(name_of(each).startswith("sleep") for each in descendants(waiting.pid)))
            self.freeze({waiting.pid, *descendants(waiting.pid)}, 3)
            self.assertEqual(waiting.communicate(timeout=60)[0], b"to its end\n")

    def freeze(self, processes, seconds):
        for number in (signal.SIGSTOP, signal.SIGCONT):
            for process in processes:
                os.kill(process, number)
            if number == signal.SIGSTOP:
                time.sleep(seconds)

    def test_two_graders_at_once_do_not_meet(self):
        for number in range(4):
            self.hand_in(f"student{number}", RIGHT)
        graders = [subprocess.Popen(self.command("--format", "json", "--jobs", "2"), stdin=subprocess.DEVNULL,
                                    stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) for _ in range(2)]
        for grader in graders:
            self.assertEqual({result["points"] for result in json.loads(grader.communicate(timeout=600)[0])}, {3})

    def fails(self, text):
        """What grade_one says, which must write no result."""
        self.hand_in("ada", text)
        command, task = self.one()
        result = subprocess.run(command, input=task, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600)
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(result.stdout, b"")
        return result.stderr.decode().strip().splitlines()[-1]

    def test_a_judge_that_fails_is_no_fault_of_a_student(self):
        judge = self.build / PLACE / "judge"
        # As long as the judge itself: one of another size would be made anew.
        judge.write_text("#!/bin/sh\necho no memory\nexit 1\n".ljust(judge.stat().st_size, "#"), encoding="utf-8")
        self.assertRegex(self.fails(RIGHT), "no memory|judge")  # whose script no seal lets in

    def test_a_compiler_that_fails_is_no_fault_of_a_student(self):
        broken = replace(self.toolchain, options=[*self.toolchain.options, "-include", str(self.root / "missing.hpp")])
        with a_workshop(broken, self.exercise, own_user(), 60) as workshop:
            with self.assertRaisesRegex(GraderFailed, "the compiler does not work"):
                workshop.compile(RIGHT)

    def test_a_text_that_claims_the_compilers_end_is_graded_all_the_same(self):
        said = KILLED.replace("\n", "\\n")
        linker = "fatal error: ld terminated with signal 9 [Killed]\\ncompilation terminated."
        self.hand_in("ada", f'{RIGHT}#line 1 "/nonexistent"\nstatic_assert(false, "{said}");\n')
        self.hand_in("bob", f"""{RIGHT}asm(".warning \\"{linker.replace(chr(92), chr(92) * 2)}\\"");\n""")
        self.hand_in("eve", f"""{RIGHT}asm(".pushsection .gnu.warning\\n .string \\"{linker.replace(chr(92), chr(92) * 2)}\\"\\n .popsection");\n""")
        self.hand_in("fay", f'{RIGHT}static_assert(false, "{os.strerror(errno.ENOSPC)}");\n')
        results = self.graded()
        self.assertEqual({name: result["points"] for name, result in results.items()}, {"ada": 0, "bob": 3, "eve": 3, "fay": 0})
        self.assertIn("static assertion failed: No space left on device", results["fay"]["exercises"][0]["reason"])
        self.assertEqual(results["ada"]["exercises"][0]["reason"],
                         "it doesn't compile: the compiler was ended from outside, twice, but not on the starter")

    def compiled_where(self, is_killed, said=KILLED):
        """RIGHT, where the compiler is killed on each text that `is_killed`, or says something else."""
        place = []

        def run(command, limits, folder, patience):
            if is_killed((place[0] / "text" / "doubled.hpp").read_text(encoding="utf-8")):
                return Ran(1, f"g++: {said}\n".encode())
            return run_confined(command, limits, folder, patience)
        with a_workshop(self.toolchain, self.exercise, own_user(), 60) as workshop:
            place.append(workshop.place)
            with mock.patch.object(untrusted, "run_confined", run):
                return list(workshop.compile(RIGHT))

    def test_a_compiler_that_is_killed_for_want_of_memory_is_no_fault_of_a_student(self):
        with self.assertRaisesRegex(GraderFailed, "the compiler was ended from outside; is there too little memory?"):
            self.compiled_where(lambda text: True)
        times = iter((True,))
        self.assertEqual(sorted(self.compiled_where(lambda text: next(times, False))), ["double", "float"])

    def test_what_the_system_lacks_for_a_while_is_no_fault_of_a_student(self):
        for code in (errno.ENOSPC, errno.EAGAIN, errno.ENOMEM, errno.EACCES):
            with self.subTest(code):
                said = f"fatal error: error writing to doubled.s: {os.strerror(code)}"
                times = iter((True,))
                self.assertEqual(sorted(self.compiled_where(lambda text: next(times, False), said)), ["double", "float"])
                with self.assertRaisesRegex(GraderFailed, said):
                    self.compiled_where(lambda text: True, said)

    @unittest.skipUnless(os.geteuid() == 0, "only root gives the compiler a user of its own")
    def test_what_a_strict_umask_keeps_from_the_compiler_is_no_fault_of_a_student(self):
        ada = self.hand_in("ada", RIGHT)
        self.grade()  # makes what is taken away below
        for file in (self.build / "shared" / "serve.o", self.build / "precompiled" / "exercise.hpp"):
            with self.subTest(file.name):
                mode = file.stat().st_mode
                file.chmod(0o600)
                try:
                    self.assertIn("must be readable for everybody", self.grade(folders=[ada], code=2))
                finally:
                    file.chmod(mode)
        made = (self.build / "precompiled").resolve()
        (self.build / "precompiled").unlink()
        shutil.copytree(made, self.build / "precompiled")
        self.root.chmod(0o750)  # as many systems make a home
        self.assertIn(f"{self.root} must be readable for everybody: run by root, the compiler has a user of its own. chmod o+x lets it in",
                      self.grade(folders=[ada], code=2))
        self.root.chmod(0o755)
        self.assertEqual(self.graded(folders=[ada])["ada"]["points"], 3)

    def test_where_a_cache_comes_first_on_the_path_the_compiler_itself_is_confined(self):
        cache = self.root / "ccache"
        cache.write_text("#!/bin/sh\necho no home >&2\nexit 1\n", encoding="utf-8")
        cache.chmod(0o755)
        toolchain = json.loads(self.toolchain_file.read_text(encoding="utf-8"))
        first = self.root / "first" / Path(toolchain["compiler"]).name
        first.parent.mkdir()
        first.symlink_to(cache)
        self.toolchain_file.write_text(json.dumps({**toolchain, "compiler": str(first)}), encoding="utf-8")
        ada = self.hand_in("ada", RIGHT)
        with mock.patch.dict(os.environ, PATH=f"{first.parent}:{os.environ['PATH']}"):
            self.assertEqual(self.graded(folders=[ada])["ada"]["points"], 3)
        with mock.patch.dict(os.environ, PATH=str(first.parent)):
            self.assertIn(f"{first} is {cache}, and the PATH holds no {first.name} besides", self.grade(folders=[ada], code=2))

    def test_what_the_system_does_not_start_earns_nothing(self):
        worker = self.root / "worker"
        worker.write_text("no program", encoding="utf-8")
        worker.chmod(0o755)
        outcome = run_check(Judge(self.build / PLACE / "judge", {}), 0, {"double": worker})
        self.assertEqual((outcome.status, outcome.message), (FAILED, "the program could not be started: Exec format error"))

    @unittest.skipUnless(seals()["files"], "there is none to take away")
    def test_without_landlock_marks_are_refused_unless_asked_for(self):
        self.hand_in("ada", RIGHT)

        def grade(*options):
            return subprocess.run([sys.executable, "-B", str(LACKS_LANDLOCK), *self.command("--format", "json", *options)],
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=600)
        refused = grade()
        self.assertEqual((refused.returncode, refused.stdout), (2, b""))
        self.assertIn(b"the system offers no Landlock", refused.stderr)
        told = grade("--unsealed")
        self.assertEqual([result["points"] for result in json.loads(told.stdout)], [3], told.stderr)
        self.assertIn(b"not in files", told.stderr)
