"""Runs programs that are not trusted, or read text that is not, and ends all that they and the grader have started."""

import contextlib
import ctypes
import os
import select
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from limits import confine, end_with

ADOPT_STRAYS = 36  # an order to prctl
ORDERS_TO_END = (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
PATIENCE = 5       # seconds that a worker has to tidy up when its keeper is told to end
KINDNESS = 2       # seconds that a compiler has


@dataclass(frozen=True)
class Ran:
    code: int         # as subprocess has it: negative for a signal
    output: bytes    # its errors
    cut: str = ""     # why it was cut short: "time", "output" or nothing


def environment():
    """What such a program gets of the caller's: so nothing that steers a compiler, such as COMPILER_PATH."""
    return {"PATH": os.environ.get("PATH", "")}


def run_confined(command, limits, folder, patience):
    """Runs a program in `folder`, where it keeps its temporary files too, as long as the patience lasts."""
    parent = os.getpid()
    with subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, cwd=folder, start_new_session=True,
                          env={**environment(), "TMPDIR": str(folder)},
                          preexec_fn=lambda: confine(limits, parent)) as process:
        try:
            output, cut = _read(process.stderr, limits.output, patience)
            if not cut and not _has_ended(process, patience):
                cut = "time"
        finally:
            end_group(process.pid)
    return Ran(process.returncode, output, cut)


def _read(pipe, most, patience):
    """What comes until the end, and why it was cut short."""
    said = b""
    while tick := patience.tick():
        if not select.select([pipe], [], [], tick)[0]:
            continue
        piece = os.read(pipe.fileno(), 1 << 16)
        said += piece
        if not piece:
            return said, ""
        if len(said) > most:
            return said[:most], "output"
    return said, "time"


def _has_ended(process, patience):
    while tick := patience.tick():
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(tick)
            return True
    return False


def end_group(leader, by=signal.SIGKILL):
    """Ends the processes of a group, whose leader is not yet waited for."""
    try:
        os.killpg(leader, by)
    except (ProcessLookupError, PermissionError):
        pass


def in_keeping(work, caller, apart=True):
    """Does `work` in a process of its own and returns its exit code. What it has started ends with it, however it ends.

    `caller` is the process that started this one. It is told and not asked for, since by now it may have ended. `apart`: what a terminal
    tells the group of the caller isn't heard.

    Two processes watch each other. When the one that called this ends, or is told to, the keeper tells the worker to end and then
    ends whatever is left; when the keeper is killed, the worker ends by itself. Both get a signal from the kernel, so that also
    SIGKILL leaves nothing behind.
    """
    if apart and os.getpgrp() != os.getpid():
        os.setsid()  # a signal to the group of the caller must not end keeper and worker at once
    for number in ORDERS_TO_END:
        if number == signal.SIGTERM or signal.getsignal(number) != signal.SIG_IGN:  # as nohup has it ignored
            signal.signal(number, _end)
    end_with(caller, signal.SIGTERM)
    adopt_strays()
    keeper = os.getpid()
    worker = os.fork()
    if worker == 0:
        end_with(keeper, signal.SIGTERM)
        adopt_strays()
        work()
        return 0
    try:
        return os.waitstatus_to_exitcode(os.waitpid(worker, 0)[1])
    except SystemExit:
        os.kill(worker, signal.SIGTERM)
        _wait_for(worker)
        raise
    finally:
        _ignore_orders()
        end_strays()


def _end(number, _):
    _ignore_orders()
    raise SystemExit(128 + number)


def _ignore_orders():
    """Who tidies up is not to be disturbed."""
    for number in ORDERS_TO_END:
        signal.signal(number, signal.SIG_IGN)


def _wait_for(worker):
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline and os.waitpid(worker, os.WNOHANG)[0] == 0:
        time.sleep(0.02)


def adopt_strays():
    """From now on, processes whose parents have ended become children of this one (Linux)."""
    if sys.platform.startswith("linux"):
        ctypes.CDLL(None).prctl(ADOPT_STRAYS, 1, 0, 0, 0)


def end_strays_kindly():
    """The same, with time to tidy up: a compiler removes its temporary files, and who builds what it has half made."""
    deadline = time.monotonic() + KINDNESS
    for process in _descendants(os.getpid()):
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.kill(process, signal.SIGTERM)
    with contextlib.suppress(ChildProcessError):
        while time.monotonic() < deadline:
            if os.waitpid(-1, os.WNOHANG)[0] == 0:
                time.sleep(0.02)
    end_strays()


def end_strays():
    """Ends every child that is left. To be called when none of our own is running."""
    for _ in range(1000):
        children = _children_of(os.getpid())
        if not children:
            return
        for child in children:
            try:
                os.kill(child, signal.SIGKILL)
                os.waitpid(child, 0)
            except (ProcessLookupError, ChildProcessError, PermissionError):
                pass


def _descendants(process):
    """Those that were started last come last."""
    children = _children_of(process)
    return children + [each for child in children for each in _descendants(child)]


def _children_of(process):
    """Of its main thread."""
    try:
        text = Path(f"/proc/{process}/task/{process}/children").read_text(encoding="ascii")
    except OSError:
        return []
    return [int(word) for word in text.split()]
