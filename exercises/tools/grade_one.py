"""Grades one submission and writes what came of it as JSON. A program of its own, so that each submission stands alone.

  grade_one.py < {"root": ..., "toolchain": ..., "submission": ..., "exercises": [...], "key": ..., "seconds": ..., "private": ...,
                   "caller": the process that starts this one}

Exit code 0: all was graded. Any other: the grader itself failed, the last line on stderr says how, and nothing is written.
"""

import json
import os
import sys
import time
from dataclasses import replace
from pathlib import Path

from catalogue import read_catalogue
from compiler_says import why_not
from complaint import Complaint, GraderFailed
from confined import end_strays, in_keeping
from limits import Limits
from made import CommandFailed
from programs import prepare
from run_check import BROKEN, Outcome, run_check
from submission import read_header
from toolchain import read_toolchain
from untrusted import COMPILING, Uncompiled, a_workshop, limits_of_workers, own_user
from workplace import drawn_parameters

NOT_RUN = "not run"
CLOCKS = (Limits.clock, 5 * Limits.clock)  # a check that came to no verdict is tried again, with more patience by the clock


def grade(task, user):
    began = time.monotonic()
    root, folder = Path(task["root"]), Path(task["submission"])
    toolchain = read_toolchain(task["toolchain"], root / "exercises" / "common", Path(task["toolchain"]).parent)
    catalogue = {exercise.path: exercise for exercise in read_catalogue(root, task["private"])}
    graded = []
    for path in task["exercises"]:
        exercise = catalogue[path]
        header = read_header(folder, exercise)
        reason, outcomes = _outcomes(toolchain, exercise, header, task, user)
        graded.append({"exercise": path, "title": exercise.title, "reason": reason, "flags": header.flags,
                       "checks": [_check(check, outcome) for check, outcome in zip(exercise.checks, outcomes)]})
    return {"submission": folder.name, "exercises": graded, "seconds": round(time.monotonic() - began, 2)}


def _check(check, outcome):
    return {"sentence": check.sentence, "points": check.points if outcome.status == "passed" else 0,
            "of": check.points, "status": outcome.status, "message": outcome.message}


def _outcomes(toolchain, exercise, header, task, user):
    """Why nothing was run, or an empty text; and the outcome of each check."""
    not_run = [Outcome(NOT_RUN)] * len(exercise.checks)
    if header.reason:
        return header.reason, not_run
    judge = prepare(toolchain, exercise, task["key"])
    with a_workshop(toolchain, exercise, user, COMPILING * task["seconds"]) as workshop:
        try:
            workers = workshop.compile(header.text)
        except Uncompiled as failure:
            return f"it doesn't compile: {why_not(str(failure), exercise)}", not_run
        limits, parameters = limits_of_workers(task["seconds"], user), drawn_parameters(exercise, task["key"])
        return "", [_outcome(exercise, (judge, number, workers, parameters), limits, workshop.empty)
                    for number in range(len(exercise.checks))]


def _outcome(exercise, check, limits, folder):
    for clock in CLOCKS:
        outcome = run_check(*check, replace(limits, clock=clock), folder)
        end_strays()
        if outcome.status != BROKEN:
            return outcome
    raise GraderFailed(f"{exercise.path}: {outcome.message}")


def main():
    os.umask(0o022)
    task, user = json.load(sys.stdin), own_user()

    def work():
        try:
            graded = grade(task, user)
        except (Complaint, CommandFailed, GraderFailed) as failure:
            sys.exit(str(failure))
        json.dump(graded, sys.stdout)
    return in_keeping(work, task["caller"])


if __name__ == "__main__":
    sys.exit(main())
