"""A long job in shards: nothing of it is lost, and nothing done twice."""

import os
import random
import signal
import threading
import time
import zlib

from complaint import Complaint
from shards import WHOLE, Job, Part, Shard, Stopped, _line, merge, run, share, shard_of
from test_texts import InAFolder

NAMES = [f"task {number}" for number in range(20)] + ["caf\udce9", "line\nend", "merge"]
JOB = Job({"seed": 7, "inputs": {"a": "1", "b": "2"}}, NAMES)


def work(name):
    return {"said": f"{name} \x1b[31m \u2028", "number": 0.1}


class Shards(InAFolder):
    def part(self, name="part", job=JOB, shard=WHOLE, resume=False):
        return Part(self.folder / name, job, shard, resume)

    def refused(self, expected, call, *arguments, **options):
        with self.assertRaises(Complaint) as caught:
            call(*arguments, **options)
        self.assertIn(expected, str(caught.exception))

    def test_each_task_is_in_one_shard(self):
        for of in (1, 2, 7, 23, 40):
            shares = [share(NAMES, Shard(number, of)) for number in range(1, of + 1)]
            self.assertEqual(sorted(name for each in shares for name in each), sorted(NAMES))
        self.assertEqual(shard_of("3/16"), (3, 16))
        for word in ("0/4", "5/4", "3", "3/", "-1/4", "1/0", "1/2/3", "\u0663/4", ""):
            self.refused(f"the shard is {word}", shard_of, word)

    def test_merged_they_are_what_one_run_gives(self):
        with self.part("whole") as part:
            self.assertEqual(run(part, work), {})
        files = []
        for number in (2, 3, 1):
            with self.part(f"{number}", shard=Shard(number, 3)) as part:
                run(part, work, workers=2)
            files.append(self.folder / f"{number}")
        self.assertEqual(list(merge(files)[0].items()), [(name, work(name)) for name in NAMES])
        self.assertEqual(merge(files), merge([self.folder / "whole"]))

    def test_a_part_says_which_share_it_is_of_tasks_with_names_unlike_each_other(self):
        lines = [_line({"job": 1, "shard": [1, 1], "tasks": tasks}) for tasks in ([1, 2], [None], ["a", "a"], [["a"]], {"a": 1}, "ab", None)]
        lines += [_line({"job": 1, "shard": shard, "tasks": ["a"]}) for shard in ([1], [0, 0], [2, 1], ["1", "1"], 3)]
        deep = b"[" * 100000 + b"]" * 100000
        for line in (*lines, b"%s %08x\n" % (deep, zlib.crc32(deep))):
            (self.folder / "part").write_bytes(line)
            self.refused("is no part of a job; see its line 1", merge, [self.folder / "part"])

    def test_a_run_cut_off_at_any_byte_is_taken_up_again(self):
        with self.part() as part:
            run(part, work)
        whole = (self.folder / "part").read_bytes()
        lines = whole.split(b"\n")[:-1]
        chance = random.Random(1)
        for length in [0, 1, len(lines[0]), len(lines[0]) + 1, len(whole) - 1, *(chance.randrange(len(whole)) for _ in range(30))]:
            with self.subTest(length):
                (self.folder / "part").write_bytes(whole[:length])
                kept = [line for line in whole[:length].split(b"\n")[:-1] if b'"result"' in line]
                done = []
                with self.part(resume=True) as part:
                    run(part, lambda name: done.append(name) or work(name))
                self.assertEqual(sorted(done), sorted(NAMES[len(kept):]))
                self.assertEqual(merge([self.folder / "part"])[0], {name: work(name) for name in NAMES})

    def test_a_part_is_taken_up_only_where_it_belongs(self):
        with self.part() as part:
            run(part, lambda name: 1)
            self.refused("is being written by another run", self.part, resume=True)
        self.refused("with 23 of 23 results; --resume takes it up", self.part)
        self.refused('its job seed is 7, and here it is 8', self.part, job=Job({**JOB.what, "seed": 8}, NAMES), resume=True)
        self.refused('its job inputs b is "2", and here it is nothing', self.part, resume=True,
                     job=Job({"seed": 7, "inputs": {"a": "1"}}, NAMES))
        self.refused("its shard is [1, 1], and here it is [1, 2]", self.part, shard=Shard(1, 2), resume=True)
        self.refused("can't be written, and results are kept there as they come: No such file", self.part, "missing/part")
        self.refused("can't be written, and results are kept there as they come: Is a directory", self.part, "")
        with self.part("removed") as part:
            (self.folder / "removed").unlink()
            self.refused("somebody has removed it", run, part, work)

    def test_another_file_is_never_taken_for_a_part(self):
        for text in (b"precious", b"precious\n", b"{}\n", b'{"job": 1}\n', b"\xff\xfe\n", b"\n"):
            (self.folder / "mine").write_bytes(text)
            self.refused("is no part of a job", self.part, "mine", resume=True)
            self.refused("is no part of a job", self.part, "mine")
            self.refused("is no part of a job" , merge, [self.folder / "mine"])
            self.assertEqual((self.folder / "mine").read_bytes(), text)

    def test_a_part_that_is_damaged_in_any_byte_is_refused(self):
        with self.part() as part:
            run(part, work)
        whole = (self.folder / "part").read_bytes()
        chance = random.Random(1)
        for place in (0, 1, whole.index(b"result"), *(chance.randrange(len(whole) - 1) for _ in range(200))):
            with self.subTest(place):
                damaged = bytearray(whole)
                damaged[place] ^= 1 << chance.randrange(8)
                (self.folder / "part").write_bytes(damaged)
                self.refused("is no part of a job; see its line ", merge, [self.folder / "part"])
                self.refused("is no part of a job; see its line ", self.part, resume=True)
                self.assertEqual((self.folder / "part").read_bytes(), damaged)

    def test_merging_names_what_does_not_fit(self):
        for number, of in ((1, 2), (2, 2), (1, 3)):
            with self.part(f"{number}{of}", shard=Shard(number, of)) as part:
                run(part, work)
        one, two, third = (self.folder / name for name in ("12", "22", "13"))
        copy = self.folder / "copy"
        copy.write_bytes(one.read_bytes())
        self.refused(f"{one} and {copy} are both shard 1/2", merge, [one, copy, two])
        self.refused("its shard is [1, 3], and here it is [1, 2]", merge, [one, third])
        self.refused("can't be read: No such file", merge, [one, self.folder / "none"])
        (self.folder / "empty").touch()
        self.refused("it holds nothing", merge, [self.folder / "empty"])
        self.assertEqual(merge([two])[1], NAMES[::2])
        one.write_bytes(one.read_bytes() + two.read_bytes().split(b"\n")[1] + b"\n")
        self.refused(f"{one} is no part of a job; see its line 26", merge, [one, two])

    def test_what_is_done_once_more_replaces_what_was_done_before(self):
        with self.part() as part:
            run(part, lambda name: "before")
            for name in NAMES[2:4]:
                part.void(name)
            self.assertEqual(merge([self.folder / "part"])[1], NAMES[2:4])
        with self.part(resume=True) as part:
            self.assertEqual(part.to_do(), NAMES[2:4])
            run(part, lambda name: "after")
        with self.part(resume=True) as part:
            self.assertEqual(part.done, {name: "after" if name in NAMES[2:4] else "before" for name in NAMES})
        self.assertEqual(list(merge([self.folder / "part"])[0]), NAMES)

    def test_a_part_without_results_is_begun_anew(self):
        with self.part():
            pass
        with self.part(job=Job({}, ["other"])) as part:
            run(part, lambda name: 1)
        self.assertEqual(merge([self.folder / "part"]), ({"other": 1}, []))

    def test_a_failure_is_tried_again_and_is_no_result(self):
        tried = []

        def fails(name):
            tried.append(name)
            if name in NAMES[3:5] and (name == NAMES[3] or tried.count(name) == 1):
                raise OSError(f"no {name}")
            return work(name)
        with self.part() as part:
            self.assertEqual(run(part, fails, workers=3), {NAMES[3]: f"OSError: no {NAMES[3]}"})
            self.assertEqual(part.to_do(), [NAMES[3]])
        self.assertEqual([tried.count(name) for name in NAMES[2:6]], [1, 2, 2, 1])
        self.assertEqual(merge([self.folder / "part"])[1], [NAMES[3]])
        with self.part(resume=True) as part:
            self.assertEqual(run(part, work), {})
            self.assertEqual(part.to_do(), [])

    def test_a_signal_ends_the_run_and_what_was_done_is_kept(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number):
                ended = threading.Event()

                def waits_at_the_fifth(name):
                    if name == NAMES[4]:
                        os.kill(os.getpid(), number)
                        ended.wait(60)
                    return work(name)
                before = signal.getsignal(number)
                with self.part(f"part {number}") as part, self.assertRaises(Stopped) as caught:
                    run(part, waits_at_the_fifth, stop=ended.set)
                self.assertEqual((caught.exception.signal, list(part.done)), (number, NAMES[:4]))
                self.assertEqual(signal.getsignal(number), before)
                with self.part(f"part {number}", resume=True) as part:
                    self.assertEqual(part.to_do(), [*NAMES[5:], NAMES[4]])  # what was begun comes last

    def test_a_full_disk_ends_the_run_and_leaves_whole_lines(self):
        with self.part() as part:
            whole = os.fstat(part.file.fileno()).st_size

            class Full:  # of 40 bytes that are wanted it takes 10, and then no more
                def __init__(self, file):
                    self.file, self.left = file, 500
                    self.fileno, self.truncate, self.close = file.fileno, file.truncate, file.close

                def write(self, data):
                    if self.left == 0:
                        raise OSError(28, "No space left on device")
                    piece = data[:self.left]
                    self.left -= len(piece)
                    return self.file.write(piece)
            part.file = Full(part.file)
            self.refused("can't be written: No space left on device. ", run, part, work)
        lines = (self.folder / "part").read_bytes()
        self.assertTrue(lines.endswith(b"\n"))
        self.assertGreater(len(lines), whole)
        with self.part(resume=True) as part:
            self.assertEqual(sorted(part.to_do()), sorted(NAMES[lines.count(b'"result"'):]))

    def test_no_more_than_the_wanted_number_run_at_once(self):
        running, most, guard = 0, 0, threading.Lock()

        def counts(name):
            nonlocal running, most
            with guard:
                running += 1
                most = max(most, running)
            time.sleep(0.002)
            with guard:
                running -= 1
            return name
        with self.part() as part:
            run(part, counts, workers=3)
        self.assertLessEqual(most, 3)
