"""The course's own checker of its exercises: what an exercise promises, it must keep.

  audit.py --root ROOT --toolchain FILE [--write] [--quick] [--only WORD] [--jobs N]

Every starter is made from its solution and warning-free, and fails every check, also where its functions answer with something
trivial such as 0, infinity or their input; every solution passes them all, warning-free, in both precisions, and a lab's makes its
replay; every wrong answer is caught by the check that it names, with its message, and what is right as well passes.
--write makes the starters anew; --quick looks at starters and solutions alone.
"""

import argparse
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from catalogue import exercise_folders
from compiler_says import first_message
from complaint import Complaint
from exercise import read_exercise
from hints import read_hints
from made import CommandFailed
from programs import build_worker, folder_of, prepare, write_if_new
from replay import has_replay, make_replay
from run_check import PASSED, TODO
from starter import starter_of
from toolchain import read_toolchain
from trivial import earned_by_little
from verdict import judge
from workplace import drawn_parameters, with_parameters
from wrong_answers import read_wrong_answers

KEYS = ("", "one", "another")  # the usual numbers, and those of two students


@dataclass(frozen=True)
class Places:
    """Where an exercise keeps what students don't get."""
    root: Path

    def solution(self, exercise):
        return self.root / "solutions" / exercise.path

    def wrong_answers(self, exercise):
        solution = (self.solution(exercise) / exercise.header).read_text(encoding="utf-8")
        return read_wrong_answers(exercise, self.root / "tests" / "exercises" / exercise.path, solution)


def look_at_files(root, exercise):
    """What can be said without a compiler: a list of complaints."""
    places, complaints = Places(root), []

    def attempt(action):
        try:
            return action()
        except Complaint as complaint:
            complaints.append(str(complaint))
        except FileNotFoundError as error:
            complaints.append(f"{exercise.path}: {error.filename} is missing")
        return None
    if (root / "chapters" / exercise.name).exists() or any(
            exercise.name == chapter.name.partition("_")[2] for chapter in (root / "chapters").glob("[0-9][0-9]_*")):
        complaints.append(f"{exercise.path} is called as a chapter is; ./course check could not tell them apart")
    for name in exercise.prerequisites:
        there = root / ("exercises" if "/" in name else "chapters") / name
        if not there.is_dir():
            complaints.append(f"{exercise.path}: prerequisites names {name}, which is not there")
    attempt(lambda: read_hints(exercise.folder / "hints.md"))
    attempt(lambda: with_parameters((exercise.folder / "task.md").read_text(encoding="utf-8"), exercise,
                                    drawn_parameters(exercise, "")))
    attempt(lambda: (exercise.folder / "checks.cpp").stat())
    if attempt(lambda: (places.solution(exercise) / "why.md").read_text(encoding="utf-8").strip()) == "":
        complaints.append(f"{exercise.path}: why.md is empty")
    solution = places.solution(exercise) / exercise.header
    made = attempt(lambda: starter_of(solution.read_text(encoding="utf-8"), str(solution)))
    found = attempt(lambda: (exercise.folder / exercise.header).read_text(encoding="utf-8"))
    if made is not None and found is not None and made != found:
        complaints.append(f"{exercise.path}: the starter is not the one that its solution makes; audit.py --write makes it")
    attempt(lambda: places.wrong_answers(exercise))
    return complaints


def look_at_behaviour(root, toolchain, exercise, quick=False):
    """What only running it can tell."""
    places, complaints = Places(root), []
    try:
        judge_program = prepare(toolchain, exercise)
    except CommandFailed as failure:
        return [f"{exercise.path}: checks.cpp doesn't compile:\n{first_message(failure.output, 'checks.cpp')}"]
    said = _sentences(judge_program.program)
    if said != [check.sentence for check in exercise.checks]:
        return [f"{exercise.path}: checks.cpp says {said}, and exercise.json {[c.sentence for c in exercise.checks]}; they must "
                "be the same, in the same order"]

    keys = KEYS if exercise.parameters else KEYS[:1]

    def verdicts(header_folder, name):
        """The outcome by sentence, for the numbers of one student after the other."""
        worker = build_worker(toolchain, exercise, header_folder, folder_of(toolchain, exercise) / name)
        if worker.warnings.strip():
            complaints.append(f"{exercise.path}: the compiler warns of {name}:\n"
                              f"{first_message(worker.warnings, exercise.header, 'warning') or worker.warnings[:300]}")
        for key in keys:
            outcomes = judge(exercise, replace(judge_program, key=key), worker.programs, drawn_parameters(exercise, key)).outcomes
            yield dict(zip(said, outcomes))
    try:
        for sentence, outcome in next(verdicts(exercise.folder, "starter")).items():
            if outcome.status == PASSED:
                complaints.append(f'{exercise.path}: the unsolved starter passes "{sentence}"')
        for outcomes in verdicts(places.solution(exercise), "solution"):
            complaints += [f'{exercise.path}: the solution fails "{sentence}": {outcome.message}'
                           for sentence, outcome in outcomes.items() if outcome.status != PASSED]
        for key in keys:
            complaints += [f'{exercise.path}: "{earned.sentence}" {"is passed" if earned.passes else "breaks down"} where '
                           f"{earned.answers}" for earned in earned_by_little(toolchain, exercise, drawn_parameters(exercise, key))]
        if quick:
            return complaints
        if has_replay(exercise):
            complaints += _look_at_replay(toolchain, exercise, places.solution(exercise))
        for wrong in places.wrong_answers(exercise):
            folder = folder_of(toolchain, exercise) / "wrong" / wrong.name
            write_if_new(folder / exercise.header, wrong.text.encode())
            for outcomes in verdicts(folder, f"wrong/{wrong.name}"):
                if not wrong.caught_by:
                    complaints += [f'{exercise.path}: "{sentence}" refuses {wrong.name}, which is right: {outcome.message}'
                                   for sentence, outcome in outcomes.items() if outcome.status != PASSED]
                    continue
                outcome = outcomes[wrong.caught_by]
                if outcome.status in (PASSED, TODO):
                    complaints.append(f'{exercise.path}: "{wrong.caught_by}" doesn\'t catch {wrong.name}')
                elif wrong.message not in outcome.message:
                    complaints.append(f'{exercise.path}: {wrong.name} gets the message "{outcome.message}"; it must hold '
                                      f'"{wrong.message}"')
    except Complaint as complaint:
        complaints.append(f"{exercise.path}: {complaint}")
    except CommandFailed as failure:
        complaints.append(f"{exercise.path} doesn't compile: {' '.join(failure.command[-3:])}\n"
                          f"{first_message(failure.output, exercise.header)}")
    return complaints


def _look_at_replay(toolchain, exercise, header_folder):
    folder = folder_of(toolchain, exercise) / "solution"
    page = folder / "replay.html"
    page.unlink(missing_ok=True)
    failure, warnings = make_replay(toolchain, exercise, header_folder, folder, page)
    if failure:
        return [f"{exercise.path}: the replay of the solution was not made: {failure}"]
    if warnings.strip():
        return [f"{exercise.path}: the compiler warns of show.cpp:\n{warnings[:1000]}"]
    return [] if page.exists() and "player-recording" in page.read_text(encoding="utf-8") else [
        f"{exercise.path}: show.cpp wrote no page that replays anything"]


def _sentences(judge_program):
    return json.loads(subprocess.run([judge_program, "--list"], capture_output=True, check=True).stdout)


def write_starters(root):
    for folder in exercise_folders(root):
        exercise = read_exercise(folder)
        solution = Places(root).solution(exercise) / exercise.header
        (folder / exercise.header).write_text(starter_of(solution.read_text(encoding="utf-8"), str(solution)), encoding="utf-8")


def audit(root, toolchain, folders, jobs=1, quick=False):
    """All complaints about the exercises in these folders."""
    complaints, sound = [], []
    for folder in folders:
        try:
            exercise = read_exercise(folder)
        except Complaint as complaint:
            complaints.append(str(complaint))
            continue
        found = look_at_files(root, exercise)
        complaints += found
        if not found:
            sound.append(exercise)
    names = [exercise.name for exercise in sound]
    complaints += [f"two exercises are called {name}" for name in sorted(set(names)) if names.count(name) > 1]
    if toolchain and sound:
        try:
            prepare(toolchain, sound[0])  # the precompiled header, before anything happens side by side
        except CommandFailed:
            pass  # the complaint comes below
        with ThreadPoolExecutor(jobs) as pool:
            for found in pool.map(lambda exercise: look_at_behaviour(root, toolchain, exercise, quick), sound):
                complaints += found
    return complaints


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--toolchain", type=Path, help="without it, only what needs no compiler is checked")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", default="", help="an exercise, such as hammer")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args(words)
    if arguments.write:
        write_starters(arguments.root)
    folders = [folder for folder in exercise_folders(arguments.root) if arguments.only in ("", folder.name)]
    if not folders:
        print("no exercise to look at", file=sys.stderr)
        return 2
    toolchain = None
    if arguments.toolchain:
        build = arguments.toolchain.parent / "audit"
        toolchain = read_toolchain(arguments.toolchain, arguments.root / "exercises" / "common", build, launched=True)
    complaints = audit(arguments.root, toolchain, folders, arguments.jobs, arguments.quick)
    for complaint in complaints:
        print(f"error: {complaint}", file=sys.stderr)
    print(f"looked at {len(folders)} exercises, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
