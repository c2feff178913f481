"""Grades one submission and writes what came of it as JSON. A program of its own, so that each submission stands alone.

  grade_one.py < {"root": ..., "toolchain": ..., "submission": ..., "exercises": [...], "key": ..., "user": ...}
"""

import json
import os
import sys
import tempfile
import time
from pathlib import Path

from catalogue import read_catalogue
from compiler_says import why_not
from confined import adopt_strays, end_strays, run_compiler
from limits import Limits
from made import CommandFailed
from programs import build_worker, prepare
from run_check import Outcome, run_check
from submission import read_header
from toolchain import read_toolchain
from workplace import drawn_parameters

NOT_RUN = "not run"


def grade(task):
    began = time.monotonic()
    root, folder = Path(task["root"]), Path(task["submission"])
    toolchain = read_toolchain(task["toolchain"], root / "exercises" / "common", Path(task["toolchain"]).parent)
    catalogue = {exercise.path: exercise for exercise in read_catalogue(root, task["private"])}
    limits = Limits(seconds=task["seconds"], file=0, processes=1, user=task["user"], sealed=True)
    graded = []
    for path in task["exercises"]:
        exercise = catalogue[path]
        header = read_header(folder, exercise)
        with tempfile.TemporaryDirectory(prefix="graded-") as scratch:
            os.chmod(scratch, 0o711)  # another user may run what lies here, and see nothing else of it
            reason, outcomes = _outcomes(toolchain, exercise, header, Path(scratch), task, limits)
        graded.append({"exercise": path, "title": exercise.title, "reason": reason, "flags": header.flags,
                       "checks": [_check(check, outcome) for check, outcome in zip(exercise.checks, outcomes)]})
    return {"submission": folder.name, "exercises": graded, "seconds": round(time.monotonic() - began, 2)}


def _check(check, outcome):
    return {"sentence": check.sentence, "points": check.points if outcome.status == "passed" else 0,
            "of": check.points, "status": outcome.status, "message": outcome.message}


def _outcomes(toolchain, exercise, header, scratch, task, limits):
    """Why nothing was run, or an empty text; and the outcome of each check."""
    not_run = [Outcome(NOT_RUN)] * len(exercise.checks)
    if header.reason:
        return header.reason, not_run
    place = scratch / "header"
    place.mkdir()
    (place / exercise.header).write_text(header.text, encoding="utf-8")
    judge = prepare(toolchain, exercise)
    try:
        worker = build_worker(toolchain, exercise, place, scratch / "worker", run=run_compiler)
    except CommandFailed as failure:
        return f"it doesn't compile: {why_not(failure.output, exercise)}", not_run
    finally:
        end_strays()
    foreign = [file for file in worker.read if not _allowed(toolchain, exercise, scratch, file)]
    if foreign:
        return f"it includes {Path(foreign[0]).name}, which is no part of the chapters up to {exercise.chapter}", not_run
    empty = scratch / "empty"
    empty.mkdir()
    for folder in (scratch / "worker", empty):
        folder.chmod(0o755)
    parameters = drawn_parameters(exercise, task["key"])
    outcomes = []
    for number in range(len(exercise.checks)):
        outcomes.append(run_check(judge, number, worker.programs, parameters, limits, folder=empty))
        end_strays()
    return "", outcomes


def _allowed(toolchain, exercise, scratch, file):
    """Whether a student's header may make the compiler read this file."""
    allowed = [*toolchain.folders_of(exercise.chapter), *toolchain.system_folders, toolchain.common, scratch,
               toolchain.precompiled, "/usr/include", "/usr/lib", "/usr/local/include", "/usr/local/lib"]
    real = Path(os.path.realpath(file))
    return any(real.is_relative_to(os.path.realpath(folder)) for folder in allowed)


if __name__ == "__main__":
    os.umask(0o022)
    adopt_strays()
    json.dump(grade(json.load(sys.stdin)), sys.stdout)
