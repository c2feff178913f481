"""Changes the exercises' solutions by one mark each, as tests/mutations changes headers: whatever the checks let pass is an answer
that earns full marks and may be wrong.

  changed_solutions.py --root ROOT --toolchain FILE [--only NAME] [--sample COUNT] [--jobs N]

A change that passes must stand in same_answers.txt, which says why no check can, or needs to, tell it from the solution. The list is
held against the solutions: what it says of a change that is no longer made is told as wrong, and so is a change of it that is caught.
--sample tries so many of them, drawn anew whenever a solution or a check of it changes.
"""

import argparse
import hashlib
import random
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE.parent / "mutations"), str(HERE.parents[1] / "exercises" / "tools")]

from audit import KEYS, Places  # noqa: E402
from catalogue import exercise_folders  # noqa: E402
from complaint import Complaint  # noqa: E402
from equal_list import lines_of, read_equal  # noqa: E402
from exercise import Exercise, read_exercise  # noqa: E402
from generator import Generator  # noqa: E402
from made import CommandFailed  # noqa: E402
from programs import build_worker, folder_of, prepare  # noqa: E402
from toolchain import read_toolchain  # noqa: E402
from verdict import judge  # noqa: E402
from workplace import drawn_parameters  # noqa: E402

CAUGHT, PASSED, NOT_COMPILED = "caught", "passed", "not compiled"


@dataclass(frozen=True)
class Change:
    exercise: Exercise
    number: int  # of those of its solution
    text: str    # the header as it became
    old: str     # the lines that were changed, as one
    new: str

    @property
    def key(self):
        """As which same_answers.txt knows it."""
        return f"{self.exercise.path}.hpp", self.old, self.new

    def __str__(self):
        return f"{self.exercise.path}.hpp\n  - {self.old}\n  + {self.new}"


def changes_of(exercise, text):
    """The changes of a solution where a student writes it."""
    found = []
    for mutant in Generator(exercise.header, text, 1).everything():
        begins = text.rfind("//! [solution]", 0, mutant.start)
        if begins > text.rfind("//! [end]", 0, mutant.start):
            changed = text[:mutant.start] + mutant.replacement + text[mutant.end:]
            found.append(Change(exercise, mutant.number, changed, *lines_of(text, mutant.start, mutant.end, mutant.replacement)))
    return found


def outcome_of(change, toolchain, judge_program):
    """What becomes of it in the checks: of those who draw numbers, for the same students as in the audit."""
    exercise = change.exercise
    name = f"changed/{change.number}"
    folder = folder_of(toolchain, exercise) / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / exercise.header).write_text(change.text, encoding="utf-8")
    try:
        worker = build_worker(toolchain, exercise, folder, folder)
    except CommandFailed:
        return NOT_COMPILED
    solved = all(judge(exercise, replace(judge_program, key=key), worker.programs, drawn_parameters(exercise, key)).solved
                 for key in (KEYS if exercise.parameters else KEYS[:1]))
    return PASSED if solved else CAUGHT


def drawn(changes, count):
    """So many of them, the same ones as long as nothing changes."""
    digest = hashlib.sha256()
    for change in changes:
        digest.update(change.text.encode())
    for folder in sorted({change.exercise.folder for change in changes}):
        digest.update((folder / "checks.cpp").read_bytes())
    return random.Random(digest.digest()).sample(changes, min(count, len(changes)))


def try_changes(changes, toolchain, jobs):
    """(change, outcome) of each. The judges are made before, one after the other."""
    judges = {exercise.path: prepare(toolchain, exercise) for exercise in {change.exercise.path: change.exercise for change in changes}.values()}
    with ThreadPoolExecutor(jobs) as pool:
        yield from zip(changes, pool.map(lambda change: outcome_of(change, toolchain, judges[change.exercise.path]), changes))


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--toolchain", type=Path, required=True)
    parser.add_argument("--only", default="", help="an exercise, such as hammer")
    parser.add_argument("--sample", type=int, help="how many to try; all if not given")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args(words)
    exercises = [read_exercise(folder) for folder in exercise_folders(arguments.root) if arguments.only in ("", folder.name)]
    places, changes = Places(arguments.root), []
    for exercise in exercises:
        changes += changes_of(exercise, (places.solution(exercise) / exercise.header).read_text(encoding="utf-8"))
    paths = {f"{exercise.path}.hpp" for exercise in exercises}
    same = {key: why for key, why in read_equal([HERE / "same_answers.txt"]).items() if not arguments.only or key[0] in paths}
    wrong = [f"same_answers.txt names a change that is not made: {key}" for key in same.keys() - {change.key for change in changes}]

    build = arguments.toolchain.parent / "changed"
    toolchain = read_toolchain(arguments.toolchain, arguments.root / "exercises" / "common", build, launched=True)
    tried = changes if arguments.sample is None else drawn(changes, arguments.sample)
    counts = {CAUGHT: 0, PASSED: 0, NOT_COMPILED: 0}
    for change, outcome in try_changes(tried, toolchain, arguments.jobs):
        counts[outcome] += 1
        if outcome == PASSED and change.key not in same:
            wrong.append(f"it passes every check: {change}")
        if outcome == CAUGHT and change.key in same:
            wrong.append(f"same_answers.txt says of it that no check can tell it, and one does: {change}")
    for each in wrong:
        print(f"error: {each}", file=sys.stderr)
    print(f"{len(tried)} of {len(changes)} changes tried: {counts[CAUGHT]} are caught, {counts[PASSED]} pass, of which "
          f"{counts[PASSED] - sum(each.startswith('it passes') for each in wrong)} are listed, {counts[NOT_COMPILED]} don't compile")
    return 1 if wrong else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Complaint as complaint:
        sys.exit(f"error: {complaint}")
