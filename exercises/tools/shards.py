"""A long job in shards, whose results are kept as they come, so that a run that was stopped is taken up again and nothing is done twice.

A job is what must be equal in every shard, and the names of its tasks in the order in which their results are wanted:

    job = Job({"seed": 7, "inputs": {"ada": "sha256..."}}, ["ada", "bob", "eve"])    # any JSON; names are unlike each other
    with Part(file, job, shard_of("3/16"), resume=True) as part:                     # a Complaint at once if it can't be written
        failed = run(part, work, workers=4, stop=end_what_runs)                      # work(name) returns any JSON
    results, missing = merge([Path("1.part"), Path("2.part")])                       # {name: result} in the job's order

Shard 3/16 has the third task and every sixteenth after it. A part is a file of lines, each JSON and a checksum: first the job and the
shard, then that a task is begun, its result, or that this is void; of two results of a task the later counts. What was cut off in the middle of a
line is done again. A part of another job, and one that another run is writing, is refused. run() tries a task that raises an exception a
second time, when all others are done, and returns {name: why} of those that failed twice: a failure is no result, so --resume tries it again. What was begun and has
no result comes last, so that no task keeps a run from the others. A Complaint, a full
disk among them, and Ctrl-C or SIGTERM (as Stopped) end the run after stop().
The merged results are those of the unsharded run if work() depends on nothing but the job and the name.

In tools/ it's found by sys.path.insert(0, str(ROOT / "exercises" / "tools")).
"""

import errno
import fcntl
import json
import os
import re
import signal
import threading
import zlib
from collections import Counter, namedtuple
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from pathlib import Path

from complaint import Complaint

Job = namedtuple("Job", "what tasks")
Shard = namedtuple("Shard", "number of")
WHOLE = Shard(1, 1)
ATTEMPTS = 2
BEGINNING = b'{"job": '  # of every part


class Stopped(BaseException):
    """Somebody wants the run to end: `signal` says how."""

    def __init__(self, number):
        super().__init__()
        self.signal = number


def shard_of(word):
    """From 3/16: the third of sixteen."""
    found = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", word)
    shard = Shard(*map(int, found.groups())) if found else Shard(0, 0)
    if not 1 <= shard.number <= shard.of:
        raise Complaint(f"the shard is {word}; it must be NUMBER/OF, such as 3/16, with a number from 1 to OF")
    return shard


def share(tasks, shard):
    return tasks[shard.number - 1::shard.of]


class Part:
    """The file with the results of one shard, locked while it is open. `done` holds them by the task's name."""

    def __init__(self, file, job, shard=WHOLE, resume=False):
        self.name, self.job, self.tasks, self.done = file, job, share(job.tasks, shard), {}
        self.begun = Counter()
        _require_no_device(file)
        try:
            self.file = open(file, "a+b", buffering=0)
        except OSError as error:
            raise Complaint(f"{file} can't be written, and results are kept there as they come: {error.strerror}") from None
        try:
            self._require_unheard()
            self._lock()
            self._take_up(job, shard, resume)
        except BaseException:
            self.file.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()

    def to_do(self):
        """First what was never begun, last what was begun most often."""
        return sorted((name for name in self.tasks if name not in self.done), key=lambda name: self.begun[name])

    def begin(self, name):
        self._append(_line({"task": name, "begun": True}))

    def add(self, name, result):
        line = _line({"task": name, "result": result})
        self._append(line)
        self.done[name] = _said(line.rstrip(b"\n"))["result"]

    def void(self, name):
        """The task's result counts no longer: it's to be done, and until then merge() finds none."""
        self._append(_line({"task": name, "void": True}))
        del self.done[name]

    def _require_unheard(self):
        for number in (1, 2):
            with suppress(OSError):  # it is closed
                if os.path.sameopenfile(number, self.file.fileno()):
                    raise Complaint(f"what is printed goes to {self.name}, where results are kept, and would be lost with it")

    def _lock(self):
        try:
            fcntl.flock(self.file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Complaint(f"{self.name} is being written by another run") from None
        except OSError:
            pass  # a file system without locks; what two runs add is sound all the same

    def _take_up(self, job, shard, resume):
        self.file.seek(0)
        header, results, begun, length = _read(self.file.readall(), self.name)
        if results and not resume:
            raise Complaint(f"{self.name} is there already, with {len(results)} of {len(self.tasks)} results; --resume takes it up, "
                            "--part names another file")
        if header is not None and resume:
            _require_equal(self.name, header, {"job": job.what, "shard": list(shard), "tasks": job.tasks})
            self.done, self.begun = results, begun
        else:
            header, length = None, 0
        self.file.truncate(length)
        if header is None:
            self._append(_line({"job": job.what, "shard": shard, "tasks": job.tasks}))

    def _append(self, line):
        """The whole line or nothing of it."""
        length = os.fstat(self.file.fileno()).st_size
        try:
            if os.fstat(self.file.fileno()).st_nlink == 0:
                raise FileNotFoundError(errno.ENOENT, "somebody has removed it")
            written = 0
            while written < len(line):
                written += self.file.write(line[written:])
            os.fsync(self.file.fileno())
        except BaseException as error:
            self.file.truncate(length)
            if not isinstance(error, OSError):
                raise
            raise Complaint(f"{self.name} can't be written: {error.strerror}. {len(self.done)} of {len(self.tasks)} results are in it; "
                            "--resume takes it up") from None


def run(part, work, workers=1, stop=lambda: None, tell=lambda done, of: None, only=lambda name: True):
    """Does what the part lacks, `workers` tasks at a time; the results are in part.done. Returns why, by the name of what failed twice.
    Of the tasks, `only` those are done that it says."""
    waiting = [(name, 1) for name in reversed(part.to_do()) if only(name)]
    running, failed = {}, {}
    with stoppable(), ThreadPoolExecutor(workers) as pool:
        try:
            while waiting or running:
                while waiting and len(running) < workers:
                    name, attempt = waiting.pop()
                    part.begin(name)
                    running[pool.submit(work, name)] = name, attempt
                # Python notices a signal that comes just before it waits only when it has waited.
                for future in wait(running, timeout=1, return_when=FIRST_COMPLETED).done:
                    name, attempt = running.pop(future)
                    error = future.exception()
                    if error is None:
                        part.add(name, future.result())
                        tell(len(part.done), len(part.tasks))
                    elif isinstance(error, Complaint):
                        raise error
                    elif attempt < ATTEMPTS:
                        waiting.insert(0, (name, attempt + 1))
                    else:
                        failed[name] = f"{type(error).__name__}: {error}"
        except BaseException:
            stop()
            raise
    return failed


@contextmanager
def stoppable():
    """Signals that ask for the end raise Stopped, in the main thread, where alone Python handles any. A second one changes nothing."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    signals = [each for each in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP) if signal.getsignal(each) != signal.SIG_IGN]

    def raise_stopped(number, _):
        for each in signals:
            signal.signal(each, signal.SIG_IGN)
        raise Stopped(number)
    before = [signal.signal(each, raise_stopped) for each in signals]
    try:
        yield
    finally:
        for each, handler in zip(signals, before):
            signal.signal(each, handler)


def merge(files):
    """The results of a job's parts, {name: result} in the order of its tasks, and the names of the tasks that have none."""
    first, shards, results = None, {}, {}
    for file in files:
        _require_no_device(file)
        try:
            header, found, _, _ = _read(Path(file).read_bytes(), file)
        except OSError as error:
            raise Complaint(f"{file} can't be read: {error.strerror}") from None
        if header is None:
            raise Complaint(f"{file} is no part of a job: it holds nothing")
        number, of = header["shard"]
        first = first or {**header, "shard": [1, of]}
        _require_equal(file, {**header, "shard": [1, of]}, first)
        if number in shards:
            raise Complaint(f"{shards[number]} and {file} are both shard {number}/{of}; each counts once")
        shards[number] = file
        results.update(found)
    tasks = first["tasks"]
    return {name: results[name] for name in tasks if name in results}, [name for name in tasks if name not in results]


def job_of_part(file):
    """What must be equal in all shards of the job, as one of them says it."""
    merge([file])  # or a Complaint
    return _read(Path(file).read_bytes(), file)[0]["job"]


def _require_no_device(file):
    """A pipe has no results to come back to, and a device may never end."""
    if os.path.exists(file) and not os.path.isfile(file) and not os.path.isdir(file):  # of a folder the system says that it is one
        raise Complaint(f"{file} is no part of a job: it is no file")


def _line(said):
    text = json.dumps(said).encode("ascii")
    return b"%s %08x\n" % (text, zlib.crc32(text))


def _said(line):
    """What a line says. Raises ValueError if it isn't what was written."""
    text, _, checksum = line.rpartition(b" ")
    if checksum != b"%08x" % zlib.crc32(text):
        raise ValueError
    return json.loads(text)


def _read(text, name):
    """The header, or None where there is none yet; the results by name; how often each task was begun; and how many bytes of whole lines
    there are."""
    *lines, rest = text.split(b"\n")
    header, mine, results, begun = None, (), {}, Counter()
    for count, line in enumerate(lines, 1):
        try:
            said = _said(line)
            if header is None:
                header = {key: said[key] for key in ("job", "shard", "tasks")}
                mine = set(_share_in(header))
            elif said["task"] not in mine:
                raise ValueError
            elif said.get("begun"):
                begun[said["task"]] += 1
            elif said.get("void"):
                results.pop(said["task"], None)
            else:
                results[said["task"]] = said["result"]
        except (ValueError, KeyError, TypeError, RecursionError):
            raise Complaint(f"{name} is no part of a job; see its line {count}") from None
    if header is None and not rest.startswith(BEGINNING[:len(rest)]):
        raise Complaint(f"{name} is no part of a job; see its line 1")
    return header, results, begun, len(text) - len(rest)


def _share_in(header):
    (number, of), tasks = header["shard"], header["tasks"]
    if not (type(number) is type(of) is int and 1 <= number <= of and isinstance(tasks, list)):
        raise ValueError
    if not all(isinstance(name, str) for name in tasks) or len(set(tasks)) < len(tasks):
        raise ValueError
    return share(tasks, Shard(number, of))


def _require_equal(file, found, wanted):
    place, one, other = _difference(found, wanted, "")
    if place is not None:
        raise Complaint(f"{file} belongs to another job: its {place} is {_short(one)}, and here it is {_short(other)}")


def _difference(one, other, place):
    """Where two values differ first, and how; None where they don't."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in [*one, *(key for key in other if key not in one)]:
            found = _difference(one.get(key), other.get(key), f"{place} {key}".strip())
            if found[0] is not None:
                return found
        return None, None, None
    if json.dumps(one) == json.dumps(other):
        return None, None, None
    return place, one, other


def _short(value):
    text = "nothing" if value is None else json.dumps(value)
    return text if len(text) <= 80 else text[:77] + "..."
