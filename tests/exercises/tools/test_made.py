import io
import json
import multiprocessing
import os
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

from made import CommandFailed, dependencies_in, held, make
from programs import build_show, build_worker, compile_shared


def make_slowly(folder):
    """Each run of the command leaves a line, and takes its time."""
    source, target, runs = (Path(folder, name) for name in ("source", "target", "runs"))
    command = ["sh", "-c", f"echo once >> '{runs}'; sleep 0.3; cp '{source}' '{target}'"]
    return make(target, command, inputs=[source]).seconds


class Made(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "source").write_text("1", encoding="utf-8")

    def runs(self):
        return len((self.folder / "runs").read_text(encoding="utf-8").splitlines())

    def test_what_several_want_at_once_is_made_once_and_never_seen_half_made(self):
        with multiprocessing.get_context("fork").Pool(4) as pool:
            seconds = pool.map(make_slowly, [self.folder] * 4, chunksize=1)
        self.assertEqual(self.runs(), 1)
        self.assertEqual(sum(each > 0 for each in seconds), 1)

    def test_what_is_saved_while_the_command_runs_is_made_again(self):
        source, target = self.folder / "source", self.folder / "target"
        saving = f"cp '{source}' '{target}'; sleep 0.1; echo 2 > '{source}'"
        make(target, ["sh", "-c", saving], inputs=[source])
        self.assertEqual(target.read_text(encoding="utf-8"), "1")
        make(target, ["sh", "-c", saving], inputs=[source])
        self.assertEqual(target.read_text(encoding="utf-8"), "2\n")

    def test_what_was_made_of_less_is_made_again(self):
        source, target = self.folder / "source", self.folder / "target"
        self.assertGreater(make(target, ["cp", source, target]).seconds, 0)
        self.assertGreater(make(target, ["cp", source, target], inputs=[source]).seconds, 0)
        self.assertEqual(make(target, ["cp", source, target], inputs=[source]).seconds, 0)

    def test_who_has_the_old_one_open_goes_on(self):
        source, target = self.folder / "source", self.folder / "target"
        make(target, ["cp", source, target], inputs=[source])
        with open(target, encoding="utf-8") as old:
            source.write_text("2", encoding="utf-8")
            make(target, ["cp", source, target], inputs=[source])
            self.assertEqual((old.read(), target.read_text(encoding="utf-8")), ("1", "2"))
        source.unlink()
        with self.assertRaises(CommandFailed):
            make(target, ["cp", source, target], inputs=[target])
        self.assertEqual(target.read_text(encoding="utf-8"), "2")

    def test_nobody_else_can_hold_what_is_made(self):
        make_slowly(self.folder)
        self.assertEqual((self.folder / "target.lock").stat().st_mode & 0o077, 0)

    def test_a_wait_is_told_when_it_takes_long(self):
        said = io.StringIO()
        with mock.patch("made.PATIENCE", 0.1), mock.patch("sys.stderr", said), held(self.folder / "target"):
            waiting = threading.Thread(target=make_slowly, args=[self.folder])
            waiting.start()
            deadline = time.monotonic() + 20
            while not said.getvalue() and time.monotonic() < deadline:
                time.sleep(0.01)
        waiting.join()
        self.assertIn(f"Waiting for another run, which holds {self.folder / 'target.lock'}", said.getvalue())
        self.assertEqual(self.runs(), 1)

    def test_it_is_made_again_when_what_it_was_made_of_changes_and_not_before(self):
        make_slowly(self.folder)
        make_slowly(self.folder)
        self.assertEqual(self.runs(), 1)
        (self.folder / "source").write_text("22", encoding="utf-8")
        make_slowly(self.folder)
        self.assertEqual(self.runs(), 2)
        self.assertEqual((self.folder / "target").read_text(encoding="utf-8"), "22")

    def test_what_was_changed_and_given_its_size_and_time_again_is_told(self):
        source = self.folder / "source"
        make_slowly(self.folder)
        time_of = source.stat().st_mtime_ns
        source.write_text("2", encoding="utf-8")
        os.utime(source, ns=(time_of, time_of))
        make_slowly(self.folder)
        self.assertEqual((self.folder / "target").read_text(encoding="utf-8"), "2")

    def test_what_was_saved_again_and_says_the_same_is_not_made_again(self):
        make_slowly(self.folder)
        (self.folder / "source").unlink()
        (self.folder / "source").write_text("1", encoding="utf-8")
        make_slowly(self.folder)
        self.assertEqual(self.runs(), 1)

    def made_with(self, found):
        """The seconds of making a target that a compiler would make of what it finds by itself."""
        target, rule = self.folder / "target", self.folder / "rule"
        return make(target, ["sh", "-c", f"cp '{found}' '{target}'; echo 'target: {found}' > '{rule}'"], dependencies=rule).seconds

    def test_a_time_yet_to_come_makes_nothing_again(self):
        found = self.folder / "source"
        os.utime(found, (1e10, 1e10))
        time.sleep(0.02)  # of a clock that files have
        self.assertGreater(self.made_with(found), 0)
        self.assertEqual(self.made_with(found), 0)

    def test_what_may_have_been_saved_meanwhile_is_made_once_more_whatever_the_clock_says(self):
        with mock.patch("made._clock_of_files", return_value=0):
            self.assertGreater(self.made_with(self.folder / "source"), 0)
            self.assertGreater(self.made_with(self.folder / "source"), 0)
            self.assertEqual(self.made_with(self.folder / "source"), 0)

    def test_what_was_cut_off_is_made_again(self):
        make_slowly(self.folder)
        (self.folder / "target").write_bytes(b"")
        make_slowly(self.folder)
        self.assertEqual((self.folder / "target").read_text(encoding="utf-8"), "1")

    def test_a_damaged_record_makes_the_target_again(self):
        target = self.folder / "target"
        command = [sys.executable, "-c", f"open({str(target)!r}, 'w').close()"]
        whole = {"command": [sys.executable, *command[1:]], "output": "", "size": 0, "read": {}}
        damages = ({"command": 1}, {"output": 3}, {"size": "0"}, {"read": 7}, {"read": {"a": 5}}, {"read": {"a": [1]}},
                   {"read": {sys.executable: [5, {}]}}, {"read": {sys.executable: [[1, 2], None]}}, {"read": {}})
        for damaged in ("", "5", "[]", "{}", "[" * 100000, *(json.dumps({**whole, **damage}) for damage in damages)):
            with self.subTest(record=damaged[:50]):
                Path(f"{target}.made").write_text(damaged, encoding="utf-8")
                self.assertGreater(make(target, command).seconds, 0)

    def test_dependencies_with_blanks(self):
        file = self.folder / "d"
        file.write_text("a.o: a\\ b/c.hpp \\\n d.hpp e$$f.hpp\n", encoding="utf-8")
        self.assertEqual(dependencies_in(file), ["a b/c.hpp", "d.hpp", "e$f.hpp"])

    def test_a_new_compiler_makes_it_again(self):
        compiler, target = self.folder / "compiler", self.folder / "target"
        for version in ("1", "2"):
            compiler.write_text(f"#!/bin/sh\necho {version} > '{target}'\n", encoding="utf-8")
            compiler.chmod(0o755)
            make(target, [compiler])
            self.assertEqual(target.read_text(encoding="utf-8"), f"{version}\n")

    def test_what_takes_too_long_ends_with_all_that_it_has_started(self):
        noted, target = self.folder / "noted", self.folder / "target"
        for limit in (1, 8, 64):  # on a machine with much to do it hardly begins
            with self.assertRaises(CommandFailed):
                make(target, ["sh", "-c", f"sleep 300 & echo $! > '{noted}'; wait"], limit=limit)
            if noted.exists():
                break
        status = Path(f"/proc/{noted.read_text(encoding='ascii').strip()}/stat")
        deadline = time.monotonic() + 20
        while status.exists() and status.read_text(encoding="ascii").rpartition(")")[2].split()[0] != "Z":
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def test_after_a_failure_the_next_one_may_try(self):
        target = self.folder / "target"
        for _ in range(2):
            with self.assertRaises(CommandFailed) as failed:
                make(target, ["sh", "-c", "echo no; exit 3"])
            self.assertEqual(failed.exception.output, "no\n")
        self.assertEqual(make(target, ["sh", "-c", f"touch '{target}'"]).output, "")

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
