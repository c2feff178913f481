"""What is kept between two commands: a student's copies and their progress."""

import os
import resource
import threading
import time

from complaint import Complaint
from progress import Progress, bar
from submission import LARGEST, why_not_taken
from test_texts import InAFolder, exercise
from watch import Watch
from workplace import Workplace


class ProgressFile(InAFolder):
    def test_the_best_points_stay(self):
        progress = Progress(self.folder / "work" / "progress.txt")
        for word, detail in (("started", ""), ("checked", "3/6"), ("hint", "2"), ("solved", "6/6"), ("checked", "1/6")):
            progress.note("03_inertia/hammer", word, detail)
        standing = progress.standing("03_inertia/hammer")
        self.assertEqual((standing.best, standing.solved, standing.hints), (6, True, 2))

    def test_the_last_worked_on_comes_last(self):
        progress = Progress(self.folder / "progress.txt")
        for name in ("01_force/a", "01_force/b", "01_force/a"):
            progress.note(name, "started")
        self.assertEqual(list(progress.standings()), ["01_force/b", "01_force/a"])

    def test_it_survives_damage(self):
        file = self.folder / "progress.txt"
        beyond = b"9" * 5000
        file.write_bytes(b"\xff\xfe nonsense\n2026-01-01T00:00:00 01_force/c solved " + beyond + b"/" + beyond +
                         b"\n2026-01-01T00:00:00 01_force/a solved 2/2\n2026-01-01T00:00:00 01_fo")
        progress = Progress(file)
        progress.note("01_force/b", "solved", "3/3")
        self.assertEqual(set(progress.standings()), {"01_force/a", "01_force/b"})

    def test_without_a_file_nothing_is_done(self):
        self.assertEqual(Progress(self.folder / "none").standings(), {})

    def test_bars(self):
        self.assertEqual([bar(0, 4, 4), bar(1, 4, 4), bar(4, 4, 4), bar(0, 0, 4)], ["[....]", "[#...]", "[####]", "[....]"])


class Copies(InAFolder):
    def setUp(self):
        super().setUp()
        there = self.folder / "exercises" / "03_inertia" / "hammer"
        there.mkdir(parents=True)
        (there / "hammer.hpp").write_text("starter", encoding="utf-8")
        (there / "task.md").write_text("{{parameter mass}}", encoding="utf-8")
        self.exercise, self.place = exercise(folder=there), Workplace(self.folder)

    def test_start_copies_once_and_never_overwrites(self):
        self.assertTrue(self.place.start(self.exercise))
        self.place.header_of(self.exercise).write_text("mine", encoding="utf-8")
        self.assertFalse(self.place.start(self.exercise))
        self.assertEqual(self.place.header_of(self.exercise).read_text(encoding="utf-8"), "mine")
        self.assertEqual((self.place.folder_of(self.exercise) / "task.md").read_text(encoding="utf-8"), "1 kg")

    def test_reset_keeps_dated_copies_however_quickly_they_follow(self):
        self.place.start(self.exercise)
        for text in ("first", "second", "third"):
            self.place.header_of(self.exercise).write_text(text, encoding="utf-8")
            self.place.reset(self.exercise)
        backups = sorted(self.place.folder_of(self.exercise).glob("hammer.2*.hpp"))
        self.assertEqual({backup.read_text(encoding="utf-8") for backup in backups}, {"first", "second", "third"})
        self.assertEqual(self.place.header_of(self.exercise).read_text(encoding="utf-8"), "starter")

    def test_what_a_grader_would_not_take_is_told_to_whoever_wrote_it(self):
        file = self.folder / "hammer.hpp"
        for data, why in ((b"// H\xf6he\n", "not UTF-8: byte 4 is 0xf6; save hammer.hpp as UTF-8"),
                          ("// one\n".encode("utf-16"), "not UTF-8: byte 0 is 0xff; save hammer.hpp as UTF-8"),
                          ("// one\n".encode("utf-16-le"), "zero byte"), (b" \n", "is empty"),
                          (b" " * LARGEST + b"x", f"larger than {LARGEST // 1024} KB")):
            with self.subTest(why=why):
                file.write_bytes(data)
                self.assertIn(why, why_not_taken(file))
        for data in (b"\xef\xbb\xbfint a;", b"int a;\r\nint b;", b"x" * LARGEST):
            file.write_bytes(data)
            self.assertEqual(why_not_taken(file), "")
        link = self.folder / "link.hpp"
        link.symlink_to("hammer.hpp")
        self.assertEqual(why_not_taken(link), "")
        file.unlink()
        self.assertIn("No such file", why_not_taken(link))

    def test_what_bears_the_name_and_is_no_file_is_left_alone(self):
        header = self.place.header_of(self.exercise)
        header.parent.mkdir(parents=True)
        for put, away in ((header.mkdir, header.rmdir), (lambda: os.mkfifo(header), header.unlink),
                          (lambda: header.symlink_to("nowhere"), header.unlink)):
            put()
            self.assertFalse(self.place.start(self.exercise))
            self.assertNotEqual(why_not_taken(header), "")
            with self.assertRaises(Complaint):
                self.place.reset(self.exercise)
            away()
        self.assertEqual([each.name for each in header.parent.iterdir()], ["task.md"])

    def test_on_a_full_disk_reset_leaves_no_half_of_a_copy(self):
        self.place.start(self.exercise)
        header = self.place.header_of(self.exercise)
        header.write_text("x" * 20000, encoding="utf-8")
        before = sorted(header.parent.iterdir())
        soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (10000, hard))  # what is longer can't be written
        try:
            with self.assertRaisesRegex(Complaint, "can't be written: File too large"):
                self.place.reset(self.exercise)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        self.assertEqual(sorted(header.parent.iterdir()), before)
        self.assertEqual(header.stat().st_size, 20000)

    def test_reset_of_nothing_is_refused(self):
        with self.assertRaises(Complaint):
            self.place.reset(self.exercise)

    def test_a_key_is_kept_and_a_strange_one_refused(self):
        for key in ("autumn-ada", "autumn-Anna Bø", "autumn-jo@web.de", "../x y"):  # a grader makes such of folders' names
            self.place.take_key(key)
            self.assertEqual(Workplace(self.folder).key, key)
        for key in ("", "ada ", "a\nb", "a\x1bb"):
            with self.assertRaises(Complaint):
                self.place.take_key(key)


class Watching(InAFolder):
    @staticmethod
    def in_place(file):
        file.write_text("after, and longer", encoding="utf-8")

    @staticmethod
    def by_renaming(file):  # as many editors do
        beside = file.with_suffix(".new")
        beside.write_text("after, and longer", encoding="utf-8")
        os.replace(beside, file)

    @staticmethod
    def gone_for_a_while(file):
        file.unlink()
        time.sleep(0.3)
        file.write_text("after, and longer", encoding="utf-8")

    def test_any_way_of_saving_is_seen(self):
        for save in (self.in_place, self.by_renaming, self.gone_for_a_while):
            with self.subTest(save=save.__name__):
                file = self.folder / "hammer.hpp"
                file.write_text("before", encoding="utf-8")
                watch = Watch(file)
                self.assertFalse(watch.wait(0.05))
                timer = threading.Timer(0.1, save, [file])
                timer.start()
                self.addCleanup(timer.join)
                self.assertTrue(watch.wait(30))
                self.assertFalse(watch.wait(0.3))
