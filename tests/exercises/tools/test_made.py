"""What is made is made once, again when something of it has changed, and never seen half made."""

import io
import json
import multiprocessing
import os
import sys
import threading
import time
from pathlib import Path
from unittest import mock

from made import CommandFailed, dependencies_in, held, make
from programs import build_show, build_worker, compile_shared
from test_texts import InAFolder


def make_slowly(folder):
    """Each run of the command leaves a line, and takes its time."""
    source, target, runs = (Path(folder, name) for name in ("source", "target", "runs"))
    command = ["sh", "-c", f"echo once >> '{runs}'; sleep 0.3; cp '{source}' '{target}'; echo said"]
    return make(target, command, inputs=[source])


class Made(InAFolder):
    def setUp(self):
        super().setUp()
        self.source, self.target, self.rule = (self.folder / name for name in ("source", "target", "rule"))
        self.source.write_text("1", encoding="utf-8")
        named = str(self.source).replace(" ", "\\ ")
        self.found = f"cp '{self.source}' '{self.target}'; echo 'target: {named}' > '{self.rule}'"  # by itself, as a compiler does

    def runs(self):
        return len((self.folder / "runs").read_text(encoding="utf-8").splitlines())

    def test_what_several_want_at_once_is_made_once_and_never_seen_half_made(self):
        with multiprocessing.get_context("fork").Pool(4) as pool:
            made = pool.map(make_slowly, [self.folder] * 4, chunksize=1)
        self.assertEqual((self.runs(), sum(each.seconds > 0 for each in made)), (1, 1))
        self.assertEqual({each.output for each in made}, {"said\n"})

    def test_it_is_made_again_when_what_it_was_made_of_changes_and_not_before(self):
        def older():
            self.source.write_text("2", encoding="utf-8")
            os.utime(self.source, (1e9, 1e9))

        def same():
            self.source.unlink()
            self.source.write_text("2", encoding="utf-8")
        changes = {"nothing": (lambda: None, 1), "another file put there with an older time": (older, 2), "the same saved again": (same, 2),
                   "its source": (lambda: self.source.write_text("22", encoding="utf-8"), 3),
                   "what was made, cut off": (lambda: self.target.write_bytes(b""), 4)}
        make_slowly(self.folder)
        for what, (change, times) in changes.items():
            with self.subTest(what):
                change()
                make_slowly(self.folder)
                self.assertEqual(self.runs(), times)
        self.assertEqual(self.target.read_text(encoding="utf-8"), "22")

    def test_what_was_made_of_less_or_with_another_compiler_or_option_is_made_again(self):
        compiler = self.folder / "compiler"
        for version in ("1", "2"):
            compiler.write_text(f"#!/bin/sh\necho {version} $1 > '{self.target}'\n", encoding="utf-8")
            compiler.chmod(0o755)
            for option, inputs in (("-a", []), ("-b", []), ("-b", [self.source])):
                self.assertGreater(make(self.target, [compiler, option], inputs).seconds, 0)
                self.assertEqual(self.target.read_text(encoding="utf-8"), f"{version} {option}\n")
        self.assertEqual(make(self.target, [compiler, option], inputs).seconds, 0)

    def test_what_is_made_of_what_was_made_is_made_again_with_it(self):
        for text, again in (("1", True), ("1", False), ("2", True)):
            self.source.write_text(text, encoding="utf-8")
            make(self.target, ["cp", self.source, self.target], inputs=[self.source])
            made = make(self.rule, ["cp", self.target, self.rule], inputs=[self.target])
            self.assertEqual((made.seconds > 0, self.rule.read_text(encoding="utf-8")), (again, text))

    def test_what_is_saved_while_the_command_runs_is_made_again(self):
        saving = ["sh", "-c", f"{self.found}; sleep 0.1; echo 2 > '{self.source}'"]
        for given in ({"inputs": [self.source]}, {"dependencies": self.rule}):
            with self.subTest(given):
                self.source.write_text("1", encoding="utf-8")
                Path(f"{self.target}.made").unlink(missing_ok=True)
                for text, again in (("1", True), ("2\n", True), ("2\n", False)):
                    self.assertEqual(make(self.target, saving, **given).seconds > 0, again)
                    self.assertEqual(self.target.read_text(encoding="utf-8"), text)

    def test_whatever_the_clock_of_files_says_what_it_found_by_itself_is_made_once_more_at_most(self):
        with mock.patch("made._clock_of_files", return_value=0):
            made = [make(self.target, ["sh", "-c", self.found], dependencies=self.rule) for _ in range(3)]
        self.assertEqual([each.seconds > 0 for each in made], [True, True, False])

    def test_who_has_the_old_one_open_goes_on(self):
        make(self.target, ["cp", self.source, self.target], inputs=[self.source])
        with open(self.target, encoding="utf-8") as old:
            self.source.write_text("2", encoding="utf-8")
            make(self.target, ["cp", self.source, self.target], inputs=[self.source])
            self.assertEqual((old.read(), self.target.read_text(encoding="utf-8")), ("1", "2"))
        self.source.unlink()
        with self.assertRaises(CommandFailed):
            make(self.target, ["cp", self.source, self.target], inputs=[self.target])
        self.assertEqual(self.target.read_text(encoding="utf-8"), "2")

    def test_nobody_else_can_hold_what_is_made(self):
        make_slowly(self.folder)
        self.assertEqual((self.folder / "target.lock").stat().st_mode & 0o077, 0)

    def test_a_wait_is_told_when_it_takes_long(self):
        said = io.StringIO()
        with mock.patch("made.PATIENCE", 0.1), mock.patch("sys.stderr", said), held(self.target):
            waiting = threading.Thread(target=make_slowly, args=[self.folder])
            waiting.start()
            deadline = time.monotonic() + 20
            while not said.getvalue() and time.monotonic() < deadline:
                time.sleep(0.01)
        waiting.join()
        self.assertIn(f"Waiting for another run, which holds {self.target}.lock", said.getvalue())
        self.assertEqual(self.runs(), 1)

    def test_a_damaged_record_makes_the_target_again(self):
        command = [sys.executable, "-c", f"open({str(self.target)!r}, 'w').close()"]
        whole = {"command": command, "output": "", "size": 0, "read": {}}
        damages = ({"command": 1}, {"output": 3}, {"size": "0"}, {"read": 7}, {"read": {"a": 5}}, {"read": {"\0": None}}, {"read": {}})
        for damaged in ("", "5", "[]", "{}", "[" * 100000, *(json.dumps({**whole, **damage}) for damage in damages)):
            with self.subTest(record=damaged[:50]):
                Path(f"{self.target}.made").write_text(damaged, encoding="utf-8")
                self.assertGreater(make(self.target, command).seconds, 0)

    def test_dependencies_with_blanks(self):
        self.rule.write_text("a.o: a\\ b/c.hpp \\\n d.hpp e$$f.hpp g\\#.hpp\n", encoding="utf-8")
        self.assertEqual(dependencies_in(self.rule), ["a b/c.hpp", "d.hpp", "e$f.hpp", "g#.hpp"])

    def test_a_failure_is_told_and_the_next_one_may_try(self):
        for _ in range(2):
            with self.assertRaises(CommandFailed) as failed:
                make(self.target, ["sh", "-c", "echo no; exit 3"])
            self.assertEqual(failed.exception.output, "no\n")
        self.assertEqual(make(self.target, ["sh", "-c", f"touch '{self.target}'"]).output, "")

    def test_what_takes_too_long_ends_with_all_that_it_has_started(self):
        noted = self.folder / "noted"
        for limit in (1, 8, 64):  # on a machine with much to do it hardly begins
            with self.assertRaises(CommandFailed):
                make(self.target, ["sh", "-c", f"sleep 300 & echo $! > '{noted}'; wait"], limit=limit)
            if noted.exists():
                break
        status = Path(f"/proc/{noted.read_text(encoding='ascii').strip()}/stat")
        deadline = time.monotonic() + 20
        while status.exists() and status.read_text(encoding="ascii").rpartition(")")[2].split()[0] != "Z":
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def test_whatever_is_compiled_is_made_again_with_a_new_precompiled_header(self):
        toolchain, exercise = mock.MagicMock(build=self.folder, floors={"01_force": []}), mock.MagicMock(chapter="01_force", functions=[])
        toolchain.compile.return_value = ["compiler"], "dependencies"
        exercise.name = "moon"
        for build in (lambda: build_worker(toolchain, exercise, self.folder, self.folder),
                      lambda: build_show(toolchain, exercise, self.folder, self.folder),
                      lambda: compile_shared(toolchain, "judge")):
            with mock.patch("programs.make") as made:
                build()
            compiled = [call for call in made.call_args_list if call.args[1] == ["compiler"]]
            self.assertTrue(compiled)
            for call in compiled:
                self.assertIn(toolchain.precompiled_header, call.kwargs["inputs"])
