"""Files made by a command, made again only when the command or something that it read has changed."""

import contextlib
import fcntl
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import confined
from confined import end_group
from kept import kept
from plain_text import say

PATIENCE = 10  # seconds for which others are waited for without a word


class CommandFailed(Exception):
    """A command that makes a file failed; `output` is what it said."""

    def __init__(self, command, output):
        super().__init__(output)
        self.command, self.output = command, output


@dataclass
class Made:
    """What came of it: the command's output (warnings, for a compiler) and the seconds that it took, 0 for none."""
    output: str = ""
    seconds: float = 0.0


def make(target, command, inputs=(), dependencies=None, limit=120):
    """Makes `target` by `command` unless all that it was made of is as it was then.

    `dependencies` is a file in make's form that the command writes, and names what else it read.

    Who else makes it at the same time waits: a compiler that reads half a precompiled header takes all memory.
    """
    target = Path(target)
    target.parent.mkdir(parents=True, exist_ok=True)
    with held(target):
        return _make(target, [str(word) for word in command], inputs, dependencies, limit)


def _make(target, command, inputs, dependencies, limit):
    record = Path(f"{target}.made")
    known = _read(record)
    inputs = [shutil.which(command[0]) or command[0], *map(str, inputs)]
    before = _digests_of([*inputs, *known["read"]])
    if (known["command"], known["size"], known["read"]) == (command, _size(target), before):
        return Made(known["output"], 0.0)
    record.unlink(missing_ok=True)
    began, clock = time.monotonic(), _clock_of_files(f"{target}.lock")
    # Made beside it and given its name when it is whole: who has the old one open, such as a compiler a precompiled header, goes on.
    beside = f"{target}.new"
    words = [beside if word == str(target) else word for word in command]
    try:
        code, output = _ran(words, limit)
    except subprocess.TimeoutExpired:
        raise CommandFailed(command, f"it took more than {limit} seconds") from None
    if code != 0:
        raise CommandFailed(command, output)
    if beside in words:
        os.replace(beside, target)
    read = _digests_of(inputs + (dependencies_in(dependencies) if dependencies else []))
    # What was saved while the command ran may have been read before or after that, so it's made once more the next time, when the content
    # of each file is known before. Where it isn't, the clock is asked that says when files were changed.
    sure = all(before[name] == digest if name in before else digest is None or os.stat(name).st_ctime_ns < clock
               for name, digest in read.items())
    known = {"command": command if sure else [], "output": output, "size": _size(target), "read": read}
    record.write_text(json.dumps(known), encoding="utf-8")
    return Made(output, time.monotonic() - began)


def _ran(words, limit):
    """Exit code and output. If the wait is cut short, or this process ends, a compiler ends with all that it has started."""
    with subprocess.Popen(kept(words), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          start_new_session=True) as process:
        _running.add(process.pid)
        try:
            output, _ = process.communicate(timeout=limit)
        except BaseException:
            _end_kindly(process)
            raise
        finally:
            _running.discard(process.pid)
    return process.returncode, output.decode("utf-8", "replace")


_running = set()  # leaders of groups


def end_running():
    """Ends what other threads are having made: they hear of no signal."""
    for leader in list(_running):
        end_group(leader, signal.SIGTERM)


def _end_kindly(process):
    """A compiler removes its temporary files when it is asked to end."""
    end_group(process.pid, signal.SIGTERM)
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(confined.PATIENCE)
    end_group(process.pid)


@contextlib.contextmanager
def held(target):
    """Keeps others, threads and processes, from making the same; the lock goes with its holder, however that ends. Nobody else can open
    it, for whoever can open a lock can hold it."""
    with open(os.open(f"{target}.lock", os.O_CREAT | os.O_RDWR | os.O_CLOEXEC, 0o600), "wb") as lock:
        _wait_for(lock, f"{target}.lock")
        yield


def _wait_for(lock, name):
    """Says so if it takes long."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        try:
            return fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            time.sleep(0.05)
    say(f"Waiting for another run, which holds {name}", to=sys.stderr)
    return fcntl.flock(lock, fcntl.LOCK_EX)


def dependencies_in(file):
    """The files named in a rule as compilers write them for make."""
    text = Path(file).read_text(encoding="utf-8", errors="surrogateescape").replace("\\\n", " ")
    words = re.findall(r"(?:\\[ \t#]|[^ \n])+", text.partition(": ")[2])
    return sorted({re.sub(r"\\([ \t#])", r"\1", word).replace("$$", "$") for word in words})


def _read(record):
    """What was noted when it was made; nothing where that is missing or damaged."""
    with contextlib.suppress(FileNotFoundError, ValueError, RecursionError, TypeError, KeyError):
        known = json.loads(record.read_text(encoding="utf-8"))
        if isinstance(known["output"], str) and isinstance(known["read"], dict) and "command" in known and "size" in known:
            return known
    return {"command": [], "size": -1, "read": {}}


def _size(file):
    """What a full disk or a machine that stopped has left behind is shorter."""
    return os.stat(file).st_size if os.path.exists(file) else -1


def _digests_of(files):
    return {name: _digest_of(name) for name in files}


def _digest_of(name):
    """That of the content, whatever time the file is given; None where it isn't there. What was made itself is what was noted then, which
    is shorter than a precompiled header by far."""
    for file in (f"{name}.made", name):
        with contextlib.suppress(OSError, ValueError), open(file, "rb") as source:
            return hashlib.sha256(source.read()).hexdigest()
    return None


def _clock_of_files(file):
    """What the system notes now as the time of a change: coarser than our own clock, and another machine's for files that lie there."""
    os.utime(file)
    return os.stat(file).st_ctime_ns
