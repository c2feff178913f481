"""Hostile submissions: each gets what it earns, reads nothing that is not for it, and leaves nothing behind."""

import hashlib
import json
import os
import re
import shutil
import tempfile
import unittest
from pathlib import Path

from catalogue import read_catalogue
from fixture import HERE, PLACE, ROOT
from grading import RIGHT, Grading
from programs import build_worker, prepare
from untrusted import seals

HOSTILE = HERE.parent / "hostile"
NOBODY = 65534
HEADERS = "cstdio", "cstdlib", "fcntl.h", "signal.h", "stdexcept", "string", "unistd.h", "vector"
DOUBLED = "\ntemplate <class Real>\nReal doubled(Real number) {{\n{inside}  return {answer} * number;\n}}\n"
HALVED = "\ntemplate <class Real>\nReal halved(Real number) {\n  return number / 2;\n}\n"
SYSTEMS_PYTHON = shutil.which("python3", path="/usr/local/bin:/usr/bin:/bin")


def attacks():
    """(name, text, points, a part of what is said) of each attack: of those in attacks.list, where behind "| " stand lines of `doubled`,
    which is wrong if one point is earned, and around them what most have in common; and of whole headers, whose first lines say as much."""
    for block in (HOSTILE / "attacks.list").read_text(encoding="utf-8").strip().split("\n\n"):
        headline, *lines = block.split("\n")
        name, points, because = re.fullmatch(r"(\w+) earns (\d): (.+)", headline).groups()
        text = "#pragma once\n" + "".join(f"#include <{each}>\n" for each in HEADERS)
        text += "".join(f"{line}\n" for line in lines if not line.startswith("| "))
        if "doubled(" not in text:
            inside = "".join(f"  {line[2:]}\n" for line in lines if line.startswith("| "))
            text += DOUBLED.format(inside=inside, answer=5 if points == "1" else 2)
        yield name, text + ("" if "halved(" in text else HALVED), int(points), because
    for file in sorted(HOSTILE.glob("*.hpp")):
        text = file.read_bytes().decode()
        head = re.match(r"// earns: (\d)\n// because: (.+?)\n(?!//)", text, flags=re.DOTALL)
        yield file.stem, text, int(head[1]), re.sub(r"\s*\n// ", " ", head[2])


@unittest.skipUnless(seals()["files"] and seals()["calls"], "here a submission can't be confined")
class Hostile(Grading):
    """The grader is started by whoever runs the test."""
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="temporary-")
        self.addCleanup(folder.cleanup)
        self.temporary = Path(folder.name)
        self.temporary.chmod(0o1777)
        self.secret = self.root / "secret"
        self.secret.write_text("the_secret_word\n", encoding="utf-8")
        self.secret.chmod(0o600)
        prepare(self.toolchain, read_catalogue(self.root)[0])
        self.built = self.build / PLACE / "solution"
        build_worker(self.toolchain, read_catalogue(self.root)[0], self.solution.parent, self.built)
        for name in ("worker", "made"):  # a classmate's scratch, as open as it could be
            shutil.copytree(self.built, self.temporary / "graded-classmate" / name)
        (self.temporary / "graded-classmate").chmod(0o755)

    def started_by(self):
        return {**super().started_by(), "env": {**os.environ, "TMPDIR": str(self.temporary)}}

    def hand_in_all(self):
        expected = {}
        for attack, text, points, because in attacks():
            expected[attack] = points, because
            for name, place in (("ROOT", self.root), ("SECRET", self.secret), ("BUILT", self.built),
                                ("TEMPORARY", self.temporary), ("SUBMISSIONS", self.submissions)):
                text = text.replace(f"@{name}@", str(place))
            self.hand_in(attack, text)
        for name, text, reason in (("is_empty", b"", "doubled.hpp is empty"), ("is_blank", b" \n\n", "doubled.hpp is empty"),
                                   ("is_not_utf8", b"// caf\xe9\n" + RIGHT.encode(), "not UTF-8: byte 6 is 0xe9"),
                                   ("holds_a_zero", RIGHT.encode() + b"\0", "holds a zero byte"),
                                   ("is_huge", b"/" * 300_000, "larger than 256 KB"),
                                   ("opens_87000_comments", b"/* " * 87_000, "it doesn't compile"),
                                   ("has_17000_attributes", b"__attribute__((" * 17_000, "it doesn't compile"),
                                   ("is_missing", None, "doubled.hpp was not handed in")):
            self.hand_in(name, text)
            expected[name] = 0, reason
        link = self.hand_in("is_a_link", None) / "doubled.hpp"
        link.symlink_to(self.solution)
        expected["is_a_link"] = 0, "doubled.hpp is a symbolic link"
        (self.hand_in("has_a_linked_folder", None) / "doubled").symlink_to(self.solution.parent)
        expected["has_a_linked_folder"] = 0, "doubled is a symbolic link"
        (self.hand_in("is_a_folder", None) / "doubled.hpp").mkdir()
        expected["is_a_folder"] = 0, "is no file"
        os.mkfifo(self.hand_in("is_a_pipe", None) / "doubled.hpp")
        expected["is_a_pipe"] = 0, "is no file"
        for name in ("aaa_honest", "zzz_honest"):
            self.hand_in(name, RIGHT)
            expected[name] = 3, ""
        return expected

    def test_each_gets_what_it_earns_and_nobody_else_is_touched(self):
        expected = self.hand_in_all()
        self.assertGreaterEqual(len(expected), 70)
        self.grade(folders=[self.submissions / "aaa_honest"])  # so that everything is made
        before = self.files()
        results = self.graded("--jobs", "2")
        for name, (points, because) in expected.items():
            with self.subTest(name):
                exercise, = results[name]["exercises"]
                said = " ".join([exercise["reason"], *exercise["flags"], *(check["message"] for check in exercise["checks"])])
                self.assertEqual(results[name]["points"], points, said)
                self.assertIn(because, said)
        self.assertNotIn("the_secret_word", json.dumps(results))
        self.assertEqual(self.files(), before)
        self.assertEqual(self.processes_of_students(), [])
        self.assertEqual([place.name for place in self.temporary.iterdir()], ["graded-classmate"])

    def files(self):
        """What the grader's own files hold, judge included."""
        folders = [self.root / name for name in ("exercises/01_force", "solutions", "build/01_force")] + [ROOT / "exercises"]
        return {str(file): hashlib.sha256(file.read_bytes()).hexdigest()
                for folder in folders for file in sorted(folder.rglob("*")) if file.is_file()}

    def processes_of_students(self):
        """Compilers and workers of this run: their commands name its folder of temporary files."""
        found = []
        for command in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                if os.fsencode(self.temporary) in command.read_bytes():
                    found.append(command.parent.name)
            except OSError:
                continue
        return found


@unittest.skipUnless(os.geteuid() == 0 and SYSTEMS_PYTHON, "only root can start a grader as somebody else, whose Python it must be")
class HostileToNobody(Hostile):
    """The grader is started by a user without rights, who owns the course."""
    user = NOBODY
    python = SYSTEMS_PYTHON

    def setUp(self):
        super().setUp()
        for name in ("precompiled", "shared"):  # those in the build belong to who runs the test
            made = (self.build / name).resolve()
            (self.build / name).unlink()
            shutil.copytree(made, self.build / name)
        for place in (self.root, *self.root.rglob("*")):
            if not place.is_symlink():
                os.chown(place, self.user, self.user)
