"""./course grade DIR... --format text|json|junit|gradescope: points for one submission or for hundreds.

A submission is a folder that holds a student's headers; its name is the student's. ada@1 and ada@2 are two of ada's, of which --keep
best (or last) counts.
"""

import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from catalogue import find, read_catalogue
from complaint import Complaint
from made import CommandFailed
from programs import prepare_all
from reports import FORMATS, write_marks
from submission import read_header, require_folders, student_of
from toolchain import read_toolchain
from untrusted import require_seals, seals_in_words

SECONDS = 5  # of computing, for one check


def grade_all(arguments, exercises):
    """What came of each submission, in their order."""
    with ThreadPoolExecutor(arguments.jobs) as pool:
        return list(pool.map(lambda folder: _grade_one(arguments, exercises, folder), arguments.folders))


def _grade_one(arguments, exercises, folder):
    student = student_of(folder.name)
    task = {"root": str(arguments.root), "toolchain": str(arguments.toolchain), "submission": str(folder.resolve()),
            "exercises": [exercise.path for exercise in exercises], "seconds": arguments.seconds,
            "key": f"{arguments.seed}-{student}" if arguments.seed else "",
            "private": str(arguments.private) if arguments.private else None}
    most = sum(120 + 2 * (4 * arguments.seconds + 2) * len(exercise.checks) for exercise in exercises)
    try:
        result = subprocess.run([sys.executable, "-B", str(Path(__file__).with_name("grade_one.py"))],
                                input=json.dumps(task).encode(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=most)
        graded = json.loads(result.stdout)
    except (subprocess.TimeoutExpired, ValueError) as error:
        why = "took too long" if isinstance(error, subprocess.TimeoutExpired) else result.stderr.decode("utf-8", "replace")[-2000:]
        graded = {"submission": folder.name, "seconds": 0, "exercises": [
            {"exercise": exercise.path, "title": exercise.title, "reason": f"the grader itself failed: {why}", "flags": [],
             "checks": [{"sentence": check.sentence, "points": 0, "of": check.points, "status": "not run", "message": ""}
                        for check in exercise.checks]} for exercise in exercises]}
    checks = [check for exercise in graded["exercises"] for check in exercise["checks"]]
    return {"student": student, "points": sum(check["points"] for check in checks),
            "of": sum(check["of"] for check in checks), **graded}


def counted(results, keep):
    """The submissions that count: of each student the best, or the last by name."""
    by_student = {}
    for result in sorted(results, key=lambda result: result["submission"]):
        so_far = by_student.get(result["student"])
        if so_far is None or keep == "last" or result["points"] > so_far["points"]:
            by_student[result["student"]] = result
    return list(by_student.values())


def export_for_similarity(folder, submissions, exercises):
    """EXERCISE/STUDENT.hpp: the layout that programs which look for copied code take."""
    for exercise in exercises:
        place = folder / exercise.name
        place.mkdir(parents=True, exist_ok=True)
        for submission in submissions:
            header = read_header(submission, exercise)
            if header.text:
                (place / f"{submission.name}.hpp").write_text(header.text, encoding="utf-8")
        starter = exercise.folder / exercise.header
        if starter.exists():
            shutil.copyfile(starter, place / "STARTER.hpp")


def main(words):
    parser = argparse.ArgumentParser(prog="./course grade", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--toolchain", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("folders", nargs="+", type=Path, metavar="DIR")
    parser.add_argument("--format", choices=FORMATS, default="text")
    parser.add_argument("--output", type=Path, help="the file to write instead of the standard output")
    parser.add_argument("--exercises", help="those that count, such as moon,no_lag; without it all of them")
    parser.add_argument("--private", type=Path, help="a folder of further exercises, laid out as exercises/ is")
    parser.add_argument("--seed", default="", help="students' numbers are drawn with the key SEED-STUDENT")
    parser.add_argument("--keep", choices=("all", "best", "last"), default="all", help="of resubmissions, such as ada@1 and ada@2")
    parser.add_argument("--marks", type=Path, help="a table of points as CSV")
    parser.add_argument("--similarity", type=Path, help="a folder for programs that look for copied code")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="of computing, for one check")
    parser.add_argument("--unsealed", action="store_true", help="grade also where a submission can't be confined")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    arguments = parser.parse_args(words)
    try:
        require_folders(arguments.folders)
        catalogue = read_catalogue(arguments.root, arguments.private)
        exercises = [find(catalogue, word) for word in arguments.exercises.split(",")] if arguments.exercises else catalogue
        if not arguments.seconds > 0 or arguments.jobs < 1:
            raise Complaint(f"seconds is {arguments.seconds} and jobs is {arguments.jobs}; both must be greater than 0")
        if arguments.format == "gradescope" and len(arguments.folders) != 1:
            raise Complaint(f"{len(arguments.folders)} submissions; Gradescope grades one at a time")
        toolchain = read_toolchain(arguments.toolchain, arguments.root / "exercises" / "common", arguments.toolchain.parent)
        prepare_all(toolchain, exercises, arguments.jobs)
        require_seals(toolchain, exercises[0], arguments.unsealed)
        results = grade_all(arguments, exercises)
    except Complaint as complaint:
        print(f"course: {complaint}", file=sys.stderr)
        return 2
    except CommandFailed as failure:
        print(f"course: the checks themselves don't compile:\n{failure.output}", file=sys.stderr)
        return 2
    if arguments.keep != "all":
        results = counted(results, arguments.keep)
    text = FORMATS[arguments.format](results)
    if arguments.output:
        arguments.output.write_text(text, encoding="utf-8")
    else:
        print(text)
    if arguments.marks:
        write_marks(arguments.marks, results)
    if arguments.similarity:
        export_for_similarity(arguments.similarity, arguments.folders, exercises)
    print(seals_in_words(), file=sys.stderr)
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # what was started ends by itself then
    sys.exit(main(sys.argv[1:]))
