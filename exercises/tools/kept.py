"""Runs a command, which ends with all that it has started when whoever started this ends, in whatever way; also by SIGKILL (Linux).

    kept.py PARENT COMMAND...     PARENT is the process that starts this one

What the command prints and its exit code are the command's own.
"""

import ctrl_c  # noqa: F401
import os
import signal
import subprocess
import sys

from confined import ORDERS_TO_END, end_strays_kindly, in_keeping

NOT_STARTED = 127  # as shells have it


def kept(command):
    """The command that runs it so for this process."""
    return [sys.executable, "-E", "-B", os.path.abspath(__file__), str(os.getpid()), *command]


def _code_of(command):
    try:
        code = subprocess.Popen(command).wait()
        return code if code >= 0 else 128 - code
    except OSError as error:
        print(f"{command[0]} can't be started: {error.strerror}", file=sys.stderr, flush=True)
        return NOT_STARTED
    except SystemExit as told_to_end:
        return told_to_end.code
    finally:
        end_strays_kindly()


def main(parent, *command):
    try:
        code = in_keeping(lambda: os._exit(_code_of(command)), int(parent), apart=False)
    except SystemExit as told_to_end:
        code = told_to_end.code
    if code - 128 in ORDERS_TO_END:  # a shell goes on unless it sees the signal itself
        signal.signal(code - 128, signal.SIG_DFL)
        os.kill(os.getpid(), code - 128)
    return code


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
