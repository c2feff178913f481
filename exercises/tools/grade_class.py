"""Grades the submissions of a class, each by a process of its own, and keeps what came of them in a part of a job; see shards.py."""

import hashlib
import json
import math
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

from complaint import Complaint, GraderFailed
from limits import Limits
from patience import Patience
from plain_text import one_line
from programs import solution_of
from shards import Job, run
from submission import read_header, student_of
from untrusted import COMPILING

TOOLS = Path(__file__).resolve().parent
GRADE_ONE = [sys.executable, "-E", "-B", str(TOOLS / "grade_one.py")]
PATIENCE = 20  # seconds that the grader of one submission has to tidy up


def job_of(arguments, submissions, exercises, toolchain):
    """What must be equal in all its shards, and in a run that is taken up: all that decides on points but the submissions."""
    return Job({"exercises": _digests_of(exercises, arguments.root), "tools": _digests_of_tools(), "compiler": toolchain.in_words(),
                "seed": arguments.seed, "seconds": arguments.seconds, "unsealed": arguments.unsealed}, list(submissions))


def require_results(results, job):
    """Complains of what can't have come of grading the job's submissions. Other work keeps its results in parts too, and a part may have
    been edited on its way."""
    for name, result in results.items():
        if not _is_result(name, result, job):
            raise Complaint(f"what the parts hold for {one_line(name)} is no result of grading")
    asked = {name: [(check["sentence"], check["of"]) for check in _checks_of(result)] for name, result in results.items()}
    for first, name in zip(asked, list(asked)[1:]):
        if asked[first] != asked[name]:
            raise Complaint(f"what the parts hold for {one_line(first)} and for {one_line(name)} is not of the same checks")


def _checks_of(result):
    return [check for exercise in result["exercises"] for check in exercise["checks"]]


def _is_result(name, result, job):
    """Of the job's exercises, for who is named, with points that are there and add up."""
    try:
        checks = _checks_of(result)
        return ((result["submission"], result["student"]) == (name, student_of(name)) and isinstance(result["handed_in"], str) and
                [each["exercise"] for each in result["exercises"]] == list(job["exercises"]) and 0 <= result["seconds"] < math.inf and
                all(0 <= check["points"] <= check["of"] for check in checks) and
                all(result[key] == sum(check[key] for check in checks) for key in ("points", "of")))
    except (KeyError, TypeError):
        return False


def grade_class(arguments, folders, exercises, part, tell):
    """Grades what the part lacks. Returns the results by submission, of those that have one, and why the others have none."""
    require_results(part.done, part.job.what)
    for name in [name for name, result in part.done.items() if not _is_of(result, folders[name], exercises)]:
        part.void(name)
    graders = _Graders(arguments, exercises, (part.job.what["exercises"], part.job.what["tools"]), min(arguments.jobs, len(folders)))
    failed = run(part, lambda name: graders.grade(name, folders[name]), graders.most, graders.end, tell)
    return {name: part.done[name] for name in part.tasks if name in part.done}, failed


class _Graders:
    """The processes that grade, no more than `most` at a time."""

    def __init__(self, arguments, exercises, digests, most):
        self.arguments, self.exercises, self.most = arguments, exercises, most
        self.digests = digests
        self.lock, self.processes, self.ended = threading.Lock(), set(), False
        # By the clock, for one submission; the last is for what is neither compiling nor checking.
        self.seconds = arguments.budget or (
            Limits.clock * arguments.seconds * sum(COMPILING + 2 * len(exercise.checks) for exercise in exercises) + 300)

    def grade(self, name, folder):
        student = student_of(name)
        handed_in = _handed_in(folder, self.exercises)
        graded = self._graded({
            "root": str(self.arguments.root), "toolchain": str(self.arguments.toolchain), "submission": str(folder),
            "exercises": [exercise.path for exercise in self.exercises], "seconds": self.arguments.seconds,
            "key": f"{self.arguments.seed}-{student}" if self.arguments.seed else "",
            "private": str(self.arguments.private) if self.arguments.private else None, "caller": os.getpid()})
        if (_digests_of(self.exercises, self.arguments.root), _digests_of_tools()) != self.digests:
            raise Complaint("the checks, headers or grader have changed since the grading began; what was graded before is kept, and no "
                            "more")
        checks = _checks_of(graded)
        return {"student": student, "submission": name, "points": sum(check["points"] for check in checks),
                "of": sum(check["of"] for check in checks), "exercises": graded["exercises"], "seconds": graded["seconds"],
                "handed_in": handed_in}

    def _graded(self, task):
        with self.lock:
            if self.ended:
                raise GraderFailed("stopped")
            process = subprocess.Popen(GRADE_ONE, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       start_new_session=True)  # Ctrl-C is for us, who end it in its turn
            self.processes.add(process)
        try:
            output, said = self._said(process, json.dumps(task).encode("ascii"))
            if process.returncode == 0:
                return json.loads(output)
        except ValueError:
            pass
        finally:
            with self.lock:
                self.processes.discard(process)
            _end(process)
        why = said.decode("utf-8", "replace").strip()[-2000:]
        raise GraderFailed(why or f"it ended with {process.returncode} and said nothing that can be read")

    def _said(self, process, task):
        patience = Patience(self.seconds)
        while tick := patience.tick():
            try:
                return process.communicate(task, timeout=tick)
            except subprocess.TimeoutExpired:
                task = None  # which is sent once
        raise GraderFailed(f"it took more than {self.seconds:g} seconds by the clock")

    def end(self):
        with self.lock:
            self.ended = True
            for process in self.processes:
                process.terminate()


def _end(process):
    """Kindly first, so that it can end what it has started."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        if process.poll() is None:
            process.send_signal(number)
            try:
                process.communicate(timeout=PATIENCE)
            except subprocess.TimeoutExpired:
                continue
    process.wait()


def _digests_of(exercises, root):
    """By exercise, of what decides on points: its checks, and the headers that these and the answers may include, those beside the checks
    among them. The starter decides on nothing."""
    last = max(exercise.chapter for exercise in exercises)
    chapters = sorted(folder for folder in (root / "chapters").glob("[0-9]*") if folder.name <= last)
    folders = [root / "common", root / "exercises" / "common", *chapters, root / "exact"]
    headers = [(folder.name, _digest(*(part for header in sorted(folder.rglob("*.[ch]pp"))
                                       for part in (os.fsencode(header.relative_to(folder)), header.read_bytes()))))
               for folder in folders]
    return {exercise.path: _digest(*(part for file in _files_of_checks(exercise) for part in (os.fsencode(file.name), file.read_bytes())),
                                   *(digest.encode() for name, digest in headers if name in ("common", "exact") or name <= exercise.chapter))
            for exercise in exercises}


def _digests_of_tools():
    """By file, of what grades."""
    return {file.name: _digest(file.read_bytes()) for file in sorted(TOOLS.glob("*.py"))}


def _files_of_checks(exercise):
    beside = sorted(file for file in exercise.folder.glob("*.hpp") if file.name != exercise.header)
    solution = solution_of(exercise)
    return [exercise.folder / "exercise.json", exercise.folder / "checks.cpp", *beside, *([solution] if solution.exists() else [])]


def _is_of(result, folder, exercises):
    """Whether it is of what lies there now. What can't be read is graded once more, and fails alone."""
    try:
        return result["handed_in"] == _handed_in(folder, exercises)
    except GraderFailed:
        return False


def _handed_in(folder, exercises):
    headers = [read_header(folder, exercise) for exercise in exercises]
    return _digest(*(f"{header.text}\0{header.reason}".encode("utf-8", "surrogateescape") for header in headers))


def _digest(*texts):
    digest = hashlib.sha256()
    for text in texts:
        digest.update(hashlib.sha256(text).digest())
    return digest.hexdigest()
