"""Files made by a command, made again only when the command or something that it read has changed."""

import contextlib
import fcntl
import hashlib
import json
import os
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
    if (known and known["command"] == command and known["size"] == _size(target) and known["read"].keys() >= set(inputs)
            and all(_is_as_it_was(name, *was) for name, was in known["read"].items())):
        return Made(known["output"], 0.0)
    record.unlink(missing_ok=True)
    began, clock = time.monotonic(), _clock_of_files(f"{target}.lock")
    before = _states([*inputs, *(known["read"] if known else [])])
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
    read = inputs + (dependencies_in(dependencies) if dependencies else [])
    digests = {name: _digest_of(name) for name in read}
    after = _states(read)  # which come last: what is saved while a digest is taken differs in them
    # What was saved while the command ran may have been read before or after that, so it's made once more the next time, when the state
    # of each file is known before. Where it isn't, the clock is asked that says when files were changed.
    sure = all(before[name] == state if name in before else state is None or state[-1] < clock for name, state in after.items())
    record.write_text(json.dumps({"command": command if sure else [], "output": output, "size": _size(target),
                                  "read": {name: [after[name], digests[name]] for name in read}}), encoding="utf-8")
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
    words, word = [], ""
    for letter in text.partition(": ")[2]:
        if letter in " \n" and not word.endswith("\\"):
            words.append(word)
            word = ""
        elif letter in " \t#" and word.endswith("\\"):
            word = word[:-1] + letter
        else:
            word += letter
    return sorted({each.replace("$$", "$") for each in words + [word] if each})


def _read(record):
    """What was noted when it was made; None where that is missing or damaged."""
    try:
        known = json.loads(record.read_text(encoding="utf-8"))
    except (FileNotFoundError, ValueError, RecursionError):
        return None
    shape = {"command": list, "output": str, "size": int, "read": dict}
    sound = (isinstance(known, dict) and all(isinstance(known.get(key), kind) for key, kind in shape.items())
             and all(isinstance(was, list) and len(was) == 2 for was in known["read"].values()))
    if not sound:
        return None
    for name, (state, digest) in known["read"].items():
        _digests.setdefault((name, str(state)), digest)
    return known


def _is_as_it_was(name, state, digest):
    """By its state, or by its content where that has changed: a copy of the whole folder, such as a container's, is not made again."""
    now = _state(name)
    return now == state or (now is not None and state is not None and _digest_of(name) == digest)


def _size(file):
    """What a full disk or a machine that stopped has left behind is shorter."""
    return os.stat(file).st_size if os.path.exists(file) else -1


def _states(files):
    return {name: _state(name) for name in files}


def _state(name):
    """Differs as soon as anything is written, whatever time the file is given: nobody but the system sets the last of these times."""
    try:
        status = os.stat(name)
        return [status.st_ino, status.st_size, status.st_mtime_ns, status.st_ctime_ns]
    except OSError:
        return None


_digests = {}  # by name and state: a precompiled header is large, and much is made of it


def _digest_of(name):
    key = name, str(_state(name))
    if key not in _digests:
        try:
            _digests[key] = hashlib.sha256(Path(name).read_bytes()).hexdigest()
        except OSError:
            _digests[key] = None
    return _digests[key]


def _clock_of_files(file):
    """What the system notes now as the time of a change: coarser than our own clock, and another machine's for files that lie there."""
    os.utime(file)
    return os.stat(file).st_ctime_ns
