"""A small course of one exercise, in a folder of its own, compiled with the real one's compiler and headers."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from starter import starter_of
from toolchain import read_toolchain

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
TOOLCHAIN = os.environ.get("TUMBLE_TOOLCHAIN", "")
PLACE = "01_force/doubled"


@unittest.skipUnless(TOOLCHAIN, "TUMBLE_TOOLCHAIN names no toolchain.json")
class FixtureCourse(unittest.TestCase):
    """Each test gets a fresh course; what is compiled from the real one's files is shared by the tests of a file, which run
    one after another."""
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="a course ")
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.root.chmod(0o755)  # the users whom a grader gives to compilers must find it
        shutil.copytree(HERE.parent / "fixture", self.root, dirs_exist_ok=True)
        (self.root / "chapters").symlink_to(ROOT / "chapters")
        (self.root / "exercises" / "common").symlink_to(ROOT / "exercises" / "common")
        (self.root / "exercises" / "tools").symlink_to(ROOT / "exercises" / "tools")
        self.exercise_folder = self.root / "exercises" / PLACE
        self.solution = self.root / "solutions" / PLACE / "doubled.hpp"
        self.make_starter()
        self.build = self.root / "build"
        self.build.mkdir()
        shared = Path(TOOLCHAIN).parent / "fixture" / type(self).__module__
        for name in ("precompiled", "shared"):
            (shared / name).mkdir(parents=True, exist_ok=True)
            (self.build / name).symlink_to(shared / name)
        self.toolchain_file = self.build / "toolchain.json"
        shutil.copyfile(TOOLCHAIN, self.toolchain_file)
        self.toolchain = read_toolchain(self.toolchain_file, ROOT / "exercises" / "common", shared)
        self.toolchain = type(self.toolchain)(**{**vars(self.toolchain), "build": self.build})

    def make_starter(self):
        starter = starter_of(self.solution.read_text(encoding="utf-8"))
        (self.exercise_folder / "doubled.hpp").write_text(starter, encoding="utf-8")

    def change(self, file, old, new):
        text = file.read_text(encoding="utf-8")
        self.assertIn(old, text)
        file.write_text(text.replace(old, new), encoding="utf-8")

    def change_json(self, **changes):
        file = self.exercise_folder / "exercise.json"
        file.write_text(json.dumps({**json.loads(file.read_text(encoding="utf-8")), **changes}), encoding="utf-8")

    def student(self, *words):
        """What ./course answers to a student: exit code and text."""
        result = subprocess.run([sys.executable, "-B", str(ROOT / "exercises" / "tools" / "student.py"), "--root", str(self.root),
                                 "--toolchain", str(self.toolchain_file), *words],
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
        return result.returncode, result.stdout.decode()

    @property
    def mine(self):
        return self.root / "work" / PLACE / "doubled.hpp"
