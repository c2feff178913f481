"""What is read of a submission, and what a person should look at."""

import errno
import fcntl
import os
import signal
import socket
import unittest.mock
from pathlib import Path

from complaint import Complaint, GraderFailed
from submission import DEEPEST_SEARCHED, LARGEST, MOST_SEARCHED, name_of, places_of, read_header, student_of, when_submitted
from test_texts import InAFolder, exercise

PLAIN = "#pragma once\n#include <exercise/todo.hpp>\n#include <tumble/force.hpp>\n"


class Headers(InAFolder):
    def read(self, text):
        (self.folder / "hammer.hpp").write_text(text, encoding="utf-8")
        return read_header(self.folder, exercise())

    def test_a_plain_one_has_nothing_to_look_at(self):
        header = self.read(PLAIN)
        self.assertEqual((header.text, header.reason, header.flags), (PLAIN, "", []))

    def test_it_may_lie_in_the_folders_of_the_course(self):
        for below in ("hammer", "03_inertia/hammer", "work/03_inertia/hammer"):
            with self.subTest(below):
                place = self.folder / below.replace("/", "_") / below
                place.mkdir(parents=True)
                (place / "hammer.hpp").write_text(PLAIN, encoding="utf-8")
                self.assertEqual(read_header(self.folder / below.replace("/", "_"), exercise()).text, PLAIN)

    def test_what_lies_where_it_is_not_looked_for_is_named(self):
        for number, place in enumerate(("homework/work/03_inertia/hammer/hammer.hpp", "Hammer.hpp", "hammer(12).hpp", "hammer (1).hpp")):
            with self.subTest(place):
                folder = self.folder / str(number)
                (folder / place).parent.mkdir(parents=True)
                (folder / place).write_text(PLAIN, encoding="utf-8")
                self.assertEqual(read_header(folder, exercise()).reason,
                                 f"hammer.hpp was not handed in; {place} may be meant, but has another name or place")
        (folder / "a\nb").mkdir()
        (folder / "a\nb" / "hammer.hpp").touch()
        (folder / place).unlink()
        self.assertIn("; a\\nb/hammer.hpp may be meant", read_header(folder, exercise()).reason)
        deep = self.folder / "deep" / "/".join("a" * (DEEPEST_SEARCHED + 1))
        deep.mkdir(parents=True)
        (deep / "hammer.hpp").touch()
        self.assertEqual(read_header(self.folder / "deep", exercise()).reason, "hammer.hpp was not handed in")
        for each in range(MOST_SEARCHED):
            (folder / f"{each}").touch()
        self.assertEqual(read_header(folder, exercise()).reason, "hammer.hpp was not handed in")

    def test_what_stands_in_a_comment_is_not_suspicious(self):
        for line in ("// fork();", "/*\nfork();\n*/", "/* fork();"):
            with self.subTest(line):
                self.assertEqual(self.read(f"{PLAIN}{line}\n").flags, [])

    def test_suspicious_constructs_are_flagged(self):
        for code, flag in (("fork();", "starts another program"), ("std::system ( 0 );", "starts another program"),
                           ("std::ofstream out;", "opens files"), ('asm("nop");', "holds assembly"),
                           ("std::exit(0);", "ends the program"), ("#define main x", "redefines what belongs"),
                           ("__attribute__((constructor)) void f();", "runs before or after main"),
                           ("tumble::exercise::put(line, 1.0);", "meddles with"), ("#pragma GCC poison x", "orders"),
                           ('"/proc/self/mem"', "names a file of the system")):
            with self.subTest(code):
                self.assertTrue(any(flag in each for each in self.read(f"{PLAIN}{code}\n").flags), self.read(code).flags)

    def test_no_text_takes_longer_than_in_proportion_to_its_length(self):
        """Were any of these looked at again from each of its letters, it would take minutes: the tests' own limit ends that."""
        for piece in ("/* ", '"', '\\"', "'", 'R"x(', 'R"()', "__attribute__((", "system ", "#", "# pragma ", " ", "\n", "\\ ", "(", "R"):
            with self.subTest(piece):
                self.read(piece * (LARGEST // len(piece)))

    def test_the_guard_of_a_header_is_no_order_however_it_is_spaced(self):
        for line in ("#pragma once", "# pragma\tonce", "#pragma   once // and no other"):
            self.assertEqual(self.read(PLAIN.replace("#pragma once", line)).flags, [])
        self.assertEqual(len(self.read(PLAIN + "#pragma  oncewards\n").flags), 1)

    def test_words_of_mechanics_are_not_suspicious(self):
        self.assertEqual(self.read(PLAIN + "add_force(body, f); step(body, h); kick(body); // system (of bodies)\n").flags, [])

    def test_resubmissions_are_of_one_student(self):
        self.assertEqual([student_of(name) for name in ("ada", "ada@1", "ada@2026-03-01")], ["ada"] * 3)

    def test_resubmissions_follow_each_other_by_their_numbers(self):
        wanted = ["ada", "ada@9", "ada@10", "ada@2026-9-30", "ada@2026-10-01", "ada@2026-10-01-2", "ada@2026-10-01-11"]
        self.assertEqual(sorted(sorted(wanted), key=when_submitted), wanted)

    def test_an_address_and_a_name_without_a_student_stay_whole(self):
        for name in ("jo@gmail.com", "jo@web.de", "jo@163.com", "@1", "@", "ada@", "@home", "ada@-", "ada@\u0661"):
            self.assertEqual(student_of(name), name)
        self.assertEqual([student_of(name) for name in ("jo@web.de@1", "@1@2", "a\nb@3")], ["jo@web.de", "@1", "a\nb"])

    def test_what_is_no_file_is_told_as_that(self):
        def bind(place):
            with socket.socket(socket.AF_UNIX) as made:
                made.bind(str(place))
        for kind, make in (("socket", bind), ("pipe", os.mkfifo), ("folder", Path.mkdir)):
            with self.subTest(kind):
                place = self.folder / kind
                place.mkdir()
                make(place / "hammer.hpp")
                self.assertEqual(read_header(place, exercise()).reason, "hammer.hpp is no file")
        (self.folder / "hammer.hpp").symlink_to(self.folder / "pipe" / "hammer.hpp")
        self.assertEqual(read_header(self.folder, exercise()).reason, "hammer.hpp is a symbolic link; hand in the file itself")

    def test_a_lease_on_a_file_keeps_nobody_from_reading_it(self):
        """A student's process may hold one, and is asked to give it back; whoever would not wait is told to come again."""
        place = self.folder / "hammer.hpp"
        place.write_text(PLAIN, encoding="utf-8")
        holder = os.open(place, os.O_RDWR)
        asked = []

        def give_back(*_):
            asked.append(fcntl.fcntl(holder, fcntl.F_SETLEASE, fcntl.F_UNLCK))
        before = signal.signal(signal.SIGIO, give_back)
        try:
            fcntl.fcntl(holder, fcntl.F_SETLEASE, fcntl.F_WRLCK)
            self.assertEqual(read_header(self.folder, exercise()).text, PLAIN)
        finally:
            os.close(holder)
            signal.signal(signal.SIGIO, before)
        self.assertEqual(len(asked), 1)

    def test_a_disk_that_fails_is_no_fault_of_the_student(self):
        (self.folder / "hammer.hpp").write_text(PLAIN, encoding="utf-8")
        for number in (errno.EIO, errno.ESTALE, errno.EMFILE, errno.ENOMEM):
            with unittest.mock.patch("os.open", side_effect=OSError(number, os.strerror(number))), self.assertRaises(GraderFailed):
                read_header(self.folder, exercise())

    def link(self, name, target):
        (self.folder / name).symlink_to(self.folder / target)
        return self.folder / name

    def test_a_submission_is_called_as_it_was_given(self):
        for owner in ("ada", "bob"):
            (self.folder / owner / "latest").mkdir(parents=True)
        with self.assertRaisesRegex(Complaint, "two submissions are called latest: "):
            places_of([self.folder / owner / "latest" for owner in ("ada", "bob")])
        before = os.getcwd()
        os.chdir(self.folder / "ada")
        try:
            self.assertEqual([name_of(Path(each)) for each in (".", "..", "latest/..", "latest/")],
                             ["ada", self.folder.resolve().name, "ada", "latest"])
        finally:
            os.chdir(before)

    def test_a_submission_that_is_a_link_is_refused(self):
        (self.folder / "ada").mkdir()
        for target in ("ada", ".", "nowhere"):
            link = self.link(f"to {Path(target).name}", target)
            with self.assertRaises(Complaint) as caught:
                places_of([self.folder / "ada", link])
            self.assertEqual(str(caught.exception), f"{link} is a symbolic link; hand on the folder itself to which it leads")

    def test_the_folder_of_the_class_may_be_a_link(self):
        (self.folder / "store" / "ada").mkdir(parents=True)
        self.link("class", "store")
        self.assertEqual(places_of([self.folder / "class" / "ada"]), {"ada": (self.folder / "store" / "ada").resolve()})

    def test_a_folder_that_turns_into_a_link_after_it_was_found_is_not_read(self):
        (self.folder / "secret").mkdir()
        (self.folder / "secret" / "hammer.hpp").write_text(PLAIN, encoding="utf-8")
        (self.folder / "eve").mkdir()
        place = places_of([self.folder / "eve"])["eve"]
        place.rmdir()
        self.link("eve", "secret")
        header = read_header(place, exercise())
        self.assertEqual(header.text, "")
        self.assertNotEqual(header.reason, "")
