"""A lab's result as something to look at: show.cpp records what the student's code does, and writes a page that replays it."""

import os
import subprocess

from limits import Limits, confine
from made import CommandFailed
from programs import build_show

LIMITS = Limits(seconds=20)


def has_replay(exercise):
    return (exercise.folder / "show.cpp").exists()


def make_replay(toolchain, exercise, header_folder, folder, page):
    """Writes the page. Returns why it could not, or an empty text; and the compiler's warnings."""
    parent = os.getpid()
    try:
        program, warnings = build_show(toolchain, exercise, header_folder, folder)
        result = subprocess.run([str(program), str(page)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, timeout=4 * LIMITS.seconds, preexec_fn=lambda: confine(LIMITS, parent))
    except subprocess.TimeoutExpired:
        return "its program took too long", ""
    except CommandFailed as failure:
        return f"its program doesn't compile with this code:\n{failure.output[:1000]}", ""
    if result.returncode != 0:
        return result.stdout.decode("utf-8", "replace").strip()[:500] or f"its program ended with {result.returncode}", warnings
    return "", warnings
