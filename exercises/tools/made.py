"""Files made by a command, made again only when the command or something that it read has changed."""

import fcntl
import json
import os
import subprocess
import sys
import time
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

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
    """Makes `target` by `command` unless it is as new as all that it was made of.

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
    inputs = list(map(str, inputs))
    if (known and known["command"] == command and known["stamps"].keys() >= set(inputs) and target.exists()
            and _stamps(known["stamps"]) == known["stamps"]):
        return Made(known["output"], 0.0)
    record.unlink(missing_ok=True)
    began, clock = time.monotonic(), time.time_ns()
    before = _states([*inputs, *(known["stamps"] if known else [])])
    # Made beside it and given its name when it is whole: who has the old one open, such as a compiler a precompiled header, goes on.
    beside = f"{target}.new"
    words = [beside if word == str(target) else word for word in command]
    try:
        result = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=limit)
    except subprocess.TimeoutExpired:
        raise CommandFailed(command, f"it took more than {limit} seconds") from None
    output = result.stdout.decode("utf-8", "replace")
    if result.returncode != 0:
        raise CommandFailed(command, output)
    if beside in words:
        os.replace(beside, target)
    read = inputs + (dependencies_in(dependencies) if dependencies else [])
    stamps = _stamps(dict.fromkeys(read))
    # What was saved while the command ran may have been read before or after that, so it's made again the next time. Where the file's
    # state before is known, the clock isn't asked: it may have been set, and a copy may bring an old time along, or one yet to come.
    if not any(before[name] != after if name in before else _is_since(clock, after) for name, after in _states(read).items()):
        record.write_text(json.dumps({"command": command, "output": output, "stamps": stamps}), encoding="utf-8")
    return Made(output, time.monotonic() - began)


@contextmanager
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
    shape = {"command": list, "output": str, "stamps": dict}
    sound = isinstance(known, dict) and all(isinstance(known.get(key), kind) for key, kind in shape.items())
    return known if sound else None


def _stamps(files):
    stamps = {}
    for name in files:
        try:
            status = os.stat(name)
            stamps[name] = [status.st_mtime_ns, status.st_size]
        except OSError:
            stamps[name] = None
    return stamps


def _states(files):
    """Tells apart what has been written in between, whatever times it was given: nobody but the system sets that of a file's last change."""
    states = {}
    for name in files:
        try:
            status = os.stat(name)
            states[name] = (status.st_ino, status.st_size, status.st_mtime_ns, status.st_ctime_ns)
        except OSError:
            states[name] = None
    return states


def _is_since(clock, state):
    return state is not None and clock <= max(state[2:])
