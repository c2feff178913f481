"""Runs the compiler on code that is not trusted, within limits, and ends everything that it started."""

import ctypes
import os
import resource
import signal
import subprocess
import sys
from pathlib import Path

MEBIBYTE = 1 << 20


def run_compiler(command, limit=60, **options):
    """As subprocess.run, for made.make."""
    def confine():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
        resource.setrlimit(resource.RLIMIT_AS, (2048 * MEBIBYTE, 2048 * MEBIBYTE))
        resource.setrlimit(resource.RLIMIT_FSIZE, (64 * MEBIBYTE, 64 * MEBIBYTE))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    options.pop("timeout", None)
    with subprocess.Popen(command, start_new_session=True, preexec_fn=confine, env={"PATH": os.environ.get("PATH", "")},
                          **options) as process:
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            raise
    return subprocess.CompletedProcess(command, process.returncode, output[:MEBIBYTE], None)


def adopt_strays():
    """From now on, processes whose parents have ended become children of this one (Linux)."""
    if sys.platform.startswith("linux"):
        ctypes.CDLL(None).prctl(36, 1, 0, 0, 0)  # PR_SET_CHILD_SUBREAPER


def end_strays():
    """Ends every child that is left. To be called when none of our own is running."""
    for _ in range(1000):
        children = _children()
        if not children:
            return
        for child in children:
            try:
                os.kill(child, signal.SIGKILL)
                os.waitpid(child, 0)
            except (ProcessLookupError, ChildProcessError, PermissionError):
                pass


def _children():
    try:
        text = Path(f"/proc/self/task/{os.getpid()}/children").read_text(encoding="ascii")
    except OSError:
        return []
    return [int(word) for word in text.split()]
