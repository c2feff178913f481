"""Text that is not ours, on its way to a terminal, XML, HTML and JSON; and files that are written whole or not at all."""

import contextlib
import html
import io
import json
import os
import stat
import subprocess
import sys
import threading
from pathlib import Path
from unittest import mock
from xml.etree import ElementTree

from complaint import Complaint
from outputs import Outputs, write_whole
from plain_text import all_plain, one_line, plain, say
from reports import FORMATS, marks
from test_texts import InAFolder

ROOT = Path(__file__).resolve().parents[3]
EVERY_LETTER = "".join(map(chr, range(0x110000)))
NASTY = "\x1b]0;owned\x07\x1b[2J\x9b31m\r\x08\x00\x85\u202e\u2028\ufffe\udce9\ud800<&>\"'"


class PlainText(InAFolder):
    def test_what_is_seen_stays_and_what_is_not_becomes_its_escape(self):
        seen = "\u2018caf\u00e9\u2019 \u00b7 \u221e m/s\u00b2\n\t\U0001f600"
        self.assertEqual(plain(seen), seen)
        self.assertEqual(plain("a\x1b[31mb\x07\x9b\u202e\udce9\ufffe\r|\r\n"), "a\\x1b[31mb\\x07\\x9b\\u202e\\xe9\\ufffe\\r|\n")
        self.assertEqual(plain("5\u00a0m"), "5 m")
        self.assertEqual(plain("a\u3164\u034f\ufe0f\u2800\U000e0100b"), "a\\u3164\\u034f\\ufe0f\\u2800\\U000e0100b")  # these print nothing

    def test_no_letter_at_all_gets_through_that_steers_a_terminal_or_spoils_xml_or_json(self):
        shown = plain(EVERY_LETTER)
        self.assertTrue(all(letter.isprintable() or letter in "\n\t" for letter in shown))
        self.assertEqual(plain(shown), shown)
        element = ElementTree.Element("a", said=shown)
        element.text = shown
        read = ElementTree.fromstring(ElementTree.tostring(element, encoding="utf-8"))
        self.assertEqual(read.text, shown)
        self.assertEqual(json.loads(json.dumps(shown, ensure_ascii=False).encode()), shown)
        self.assertEqual(html.unescape(html.escape(shown)), shown)

    def test_a_name_is_one_line_and_two_that_differ_stay_so(self):
        self.assertEqual(one_line("caf\u00e9 1\nbob: 5\t\\"), "caf\u00e9 1\\nbob: 5\\t\\\\")
        names = ["\x1b", "\\x1b", "\u009b", "\udc9b", "\r\n", "\n", "a b", "a\u00a0b", "a", "a\u3164", "a\u034f", "a\ufe0f", "a\u2800"]
        self.assertEqual(len({one_line(name) for name in names}), len(names))
        self.assertEqual(len({one_line(letter) for letter in EVERY_LETTER}), len(EVERY_LETTER))
        shown = one_line(EVERY_LETTER)
        self.assertEqual((len(shown.splitlines()), plain(shown)), (1, shown))

    def test_no_name_forges_a_line_of_a_report(self):
        check = {"sentence": "It flies", "points": 0, "of": 1, "status": "failed", "message": "short"}
        result = {"student": "a\nbob", "submission": "a\nbob: 9 of 9 points\tx", "points": 0, "of": 1, "seconds": 1, "exercises": [
            {"exercise": "01_force/moon", "title": "The Moon", "reason": "", "flags": [], "checks": [check]}]}
        self.assertEqual(FORMATS["text"]([result]).splitlines()[0], "a\\nbob: 9 of 9 points\\tx: 0 of 1 points")
        self.assertEqual(marks([result]).splitlines()[1], "a\\nbob,a\\nbob: 9 of 9 points\\tx,0,1,0,")

    def test_no_name_is_a_formula_of_a_spreadsheet_or_parts_its_columns(self):
        begun = {letter: f"\\x{ord(letter):02x}" for letter in "=+-@"} | {letter: f"\\u{ord(letter):04x}" for letter in "\uff1d\uff0b\uff0d\uff20"}
        for name, shown in {**{f"{letter}1+1": f"{escape}1+1" for letter, escape in begun.items()}, "\t=1": "\\t=1", "\r=1": "\\r=1",
                            "eve;eve;9;9": "eve\\x3beve\\x3b9\\x3b9", "x;=1+1;": "x\\x3b=1+1\\x3b"}.items():
            result = {"student": name, "submission": name, "points": 0, "of": 0, "exercises": []}
            self.assertEqual(marks([result]).splitlines()[1], f"{shown},{shown},0,0,")

    def test_a_terminal_without_the_letters_gets_escapes(self):
        for letters, expected in (("ascii", "\\u2018a\\u2019 \\x1b"), ("utf-8", "\u2018a\u2019 \\x1b"), ("latin-1", "\\u2018a\\u2019 \\x1b")):
            out = io.TextIOWrapper(io.BytesIO(), encoding=letters)
            say("\u2018a\u2019 \x1b", to=out)
            self.assertEqual(out.buffer.getvalue().decode(letters), expected + "\n")

    def test_every_report_is_plain_whatever_a_student_writes(self):
        check = {"sentence": "It flies", "points": 0, "of": 1, "status": "failed", "message": NASTY}
        result = {"student": NASTY, "submission": NASTY, "points": 0, "of": 1, "seconds": 1, "exercises": [
            {"exercise": "01_force/moon", "title": "The Moon", "reason": "", "flags": [NASTY], "checks": [check]},
            {"exercise": "01_force/slab", "title": "A slab", "reason": NASTY, "flags": [], "checks": [check]}]}
        for name, write in {**FORMATS, "marks": marks}.items():
            with self.subTest(name):
                text = write([result])
                self.assertEqual(text.encode().decode().replace("\r\n", "\n"), plain(text))
                self.assertIn("\\x1b[2J".replace("\\", "\\\\") if name in ("json", "gradescope") else "\\x1b[2J", text)
        self.assertEqual(ElementTree.fromstring(FORMATS["junit"]([result]))[0].find(".//failure").text, plain(NASTY))
        self.assertEqual(json.loads(FORMATS["json"]([result]))[0]["student"], one_line(NASTY))
        self.assertEqual(all_plain([{NASTY: (1, None)[0]}, NASTY, 1.5]), [{plain(NASTY): 1}, plain(NASTY), 1.5])

    def test_nothing_else_prints_or_escapes(self):
        """The tools of teachers and students print by say() alone."""
        tools = ROOT / "exercises" / "tools"
        for name in ("student", "grade", "grade_class", "release", "package", "reports", "verdict", "watch", "workplace", "submission"):
            text = (tools / f"{name}.py").read_text(encoding="utf-8")
            for word in (" print(", "sys.stderr.write", "sys.stdout.write", "escape("):
                self.assertNotIn(word, text.replace('print(f"\\r{done} of {of} graded"', ""), name)


class Files(InAFolder):
    def test_a_file_is_whole_or_as_it_was(self):
        file = self.folder / "marks.csv"
        file.write_text("before", encoding="utf-8")
        os.chmod(file, 0o640)
        with contextlib.suppress(ZeroDivisionError), Outputs() as outputs:
            outputs.open("--marks", file)
            raise ZeroDivisionError
        self.assertEqual((file.read_text(encoding="utf-8"), list(self.folder.iterdir())), ("before", [file]))
        with Outputs() as outputs, open(file, encoding="utf-8") as reader:
            write = outputs.open("--marks", file)
            self.assertEqual(file.read_text(encoding="utf-8"), "before")
            write(b"after")
            self.assertEqual(reader.read(), "before")  # whoever reads it has the old one or the new one, and never half of one
        self.assertEqual((file.read_bytes(), list(self.folder.iterdir())), (b"after", [file]))
        self.assertEqual(stat.S_IMODE(file.stat().st_mode), 0o640)

    def test_a_link_stays_one_and_a_new_file_has_the_usual_rights(self):
        (self.folder / "link").symlink_to(self.folder / "there")
        before = os.umask(0o027)
        try:
            write_whole(self.folder / "link", b"text")
        finally:
            os.umask(before)
        self.assertTrue((self.folder / "link").is_symlink())
        self.assertEqual(((self.folder / "there").read_bytes(), stat.S_IMODE((self.folder / "there").stat().st_mode)), (b"text", 0o640))

    def refused(self, expected, *files):
        with self.assertRaises(Complaint) as caught, Outputs() as outputs:
            for option, file in files:
                outputs.open(option, file)
        self.assertIn(expected, str(caught.exception))

    def test_what_can_not_be_written_is_told_before_any_work(self):
        self.refused(f"--output: {self.folder}/none/x can't be written: No such file or directory", ("--output", self.folder / "none" / "x"))
        self.refused("can't be written: Is a directory", ("--output", self.folder))
        self.refused("can't be written: ", ("--output", self.folder / ("n" * 300) / "x"))
        (self.folder / "link").symlink_to("same")
        self.refused("--marks and --output both name", ("--marks", self.folder / "same"), ("--output", self.folder / "link"))
        self.assertEqual([file.name for file in self.folder.iterdir()], ["link"])

    def test_a_pipe_is_written_as_it_is(self):
        pipe, read = self.folder / "pipe", []
        os.mkfifo(pipe)
        reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()))
        reader.start()
        write_whole(pipe, b"text" * 50000)
        reader.join()
        self.assertEqual(read, [b"text" * 50000])
        self.assertTrue(stat.S_ISFIFO(pipe.stat().st_mode))

    def test_a_full_disk_leaves_the_file_as_it_was(self):
        file = self.folder / "marks.csv"
        file.write_text("before", encoding="utf-8")
        with mock.patch("os.fsync", side_effect=OSError(28, "No space left on device")), self.assertRaises(Complaint) as caught:
            write_whole(file, b"after")
        self.assertIn(f"{file} can't be written: No space left on device", str(caught.exception))
        self.assertEqual((file.read_text(encoding="utf-8"), list(self.folder.iterdir())), ("before", [file]))
        if Path("/dev/full").exists():
            self.assertRaises(Complaint, write_whole, "/dev/full", b"x")

    def test_what_can_not_be_printed_is_told_in_a_sentence(self):
        if not Path("/dev/full").exists():
            self.skipTest("here is no /dev/full")
        with open("/dev/full", "wb") as full:
            result = subprocess.run([sys.executable, "-E", "-B", str(ROOT / "exercises" / "tools" / "student.py"), "--root", str(ROOT), "next"],
                                    stdout=full, stderr=subprocess.PIPE)
        self.assertEqual((result.returncode, result.stderr.decode()), (2, "course: what was to be written: No space left on device\n"))

    def test_of_a_copy_that_fails_it_is_told_where_it_was_to_go(self):
        code = "from plain_text import why_unheard; why_unheard(OSError(28, 'No space left on device', 'from', None, 'to'))"
        said = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True, cwd=ROOT / "exercises" / "tools")
        self.assertEqual(said.stderr, "course: to: No space left on device\n")
