"""A lab's result as something to look at: show.cpp records what the student's code does, and writes a page that replays it."""

import subprocess

from limits import Limits, confine
from made import CommandFailed
from programs import build_show


def replay(toolchain, exercise, header_folder, folder, shown):
    """Makes the page beside the student's copy, for an exercise that has a show.cpp, and says where it is."""
    if not (exercise.folder / "show.cpp").exists():
        return None
    page = header_folder / f"{exercise.name}.html"
    limits = Limits(seconds=20)
    try:
        program, _ = build_show(toolchain, exercise, header_folder, folder)
        result = subprocess.run([str(program), str(page)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, timeout=limits.seconds, preexec_fn=lambda: confine(limits))
    except subprocess.TimeoutExpired:
        print("\nThe replay was not made: its program took too long.")
        return None
    except CommandFailed as failure:
        print(f"\nThe replay was not made: its program doesn't compile with your code.\n{failure.output[:1000]}")
        return None
    if result.returncode != 0:
        print(f"\nThe replay was not made: {result.stdout.decode('utf-8', 'replace').strip()[:500]}")
        return None
    print(f"\nSee it move: open {shown(page)} in a browser.")
    return page
