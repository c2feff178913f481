"""./course start, check, watch, hint, next, progress, reset, compare: a student's way through the exercises."""

import ctrl_c  # noqa: F401
import argparse
import difflib
import os
import signal
import sys
import time
from pathlib import Path

from catalogue import find, read_catalogue
from compiler_says import first_message, why_not
from command import status_of
from complaint import Complaint
from hints import read_hints
from made import CommandFailed, dependencies_in, held
from outputs import occupy_standard_descriptors
from plain_text import say
from programs import build_worker, folder_of, judge_of, prepare, read_for_worker, write_if_new
from progress import Progress, bar
from replay import has_replay, make_replay
from shards import Stopped
from starter import solution_without_marks
from submission import why_not_taken
from toolchain import read_toolchain
from untrusted import limits_of_workers, why_foreign
from verdict import judge, said
from watch import Watch
from workplace import Workplace


class Student:
    def __init__(self, root, toolchain_file=None):
        self.root = root
        self.catalogue = read_catalogue(root)
        self.place = Workplace(root)
        self.progress = Progress(self.place.folder / "progress.txt")
        self.toolchain_file = toolchain_file

    def named(self, word):
        """The exercise of that name; without one, the one last worked on."""
        if word:
            exercise = find(self.catalogue, word)
            name = Path(word).name
            if Path(name).suffix and not any((folder / name).exists() for folder in (exercise.folder, self.place.folder_of(exercise))):
                raise Complaint(f"{word} names {name}, which is no file of {exercise.name}; yours is {exercise.header}")
            return exercise
        for path in reversed(self.progress.standings()):
            for exercise in self.catalogue:
                if exercise.path == path and self.place.started(exercise):
                    return exercise
        raise Complaint("which exercise? ./course next names the one to begin with")

    def toolchain(self):
        build = Path(self.toolchain_file).parent
        return read_toolchain(self.toolchain_file, self.root / "exercises" / "common", build)

    # --- commands --------------------------------------------------------------------------------------------------

    def start(self, arguments):
        exercise = find(self.catalogue, arguments.word) if arguments.word else self._next()
        if arguments.key:
            self.place.take_key(arguments.key)
        fresh = self.place.start(exercise)
        self.progress.note(exercise.path, "started")
        say(f"{exercise.title}, about {exercise.minutes} minutes, {exercise.points} points")
        say(f"  the task   {self._shown(self.place.folder_of(exercise) / 'task.md')}")
        say(f"  your copy  {self._shown(self.place.header_of(exercise))}" + ("" if fresh else ", kept as you left it"))
        if not judge_of(self.toolchain(), exercise).exists():
            say("Its checks are compiled once; then you can begin.")
        prepare(self.toolchain(), exercise)  # so that the first verdict comes as soon as all others
        say(f"Edit your copy, then ./course check {exercise.name}; or leave ./course watch {exercise.name} running.")
        return 0

    def check(self, arguments):
        exercise = self.named(arguments.word)
        self._require_start(exercise)
        return 0 if self._check(exercise, arguments.show) else 1

    def watch(self, arguments):
        exercise = self.named(arguments.word)
        self._require_start(exercise)
        watch = Watch(self.place.header_of(exercise))
        try:
            self._check(exercise)
            say(f"\nWatching {self._shown(self.place.header_of(exercise))}; end with Ctrl-C.")
            while watch.wait():
                say(f"\n--- saved at {time.strftime('%H:%M:%S')}")
                self._check(exercise)
        except Stopped as stopped:
            if stopped.signal != signal.SIGINT:
                raise
            say()
        return 0

    def hint(self, arguments):
        exercise = self.named(arguments.word)
        hints = read_hints(exercise.folder / "hints.md")
        shown = min(self.progress.standing(exercise.path).hints + 1, len(hints))
        self.progress.note(exercise.path, "hint", str(shown))
        say(f"Hint {shown} of {len(hints)} for {exercise.title}\n\n{hints[shown - 1]}")
        return 0

    def next(self, _):
        exercise = self._next()
        say(f"{exercise.title} ({exercise.path}), about {exercise.minutes} minutes, {exercise.points} points")
        say("You will " + "; ".join(exercise.goals) + ".")
        say(f"./course start {exercise.name}")
        return 0

    def show_progress(self, _):
        standings = self.progress.standings()
        chapter = points = whole = 0
        for exercise in self.catalogue:
            if exercise.chapter != chapter:
                chapter = exercise.chapter
                say(chapter)
            standing = standings.get(exercise.path)
            best = min(standing.best, exercise.points) if standing else 0
            points, whole = points + best, whole + exercise.points
            state = "" if not standing else "solved" if standing.solved else "begun"
            if standing and standing.hints:
                state += f", {standing.hints} of 3 hints"
            say(f"  {exercise.name:<20}{bar(best, exercise.points, 10)} {best:>2} of {exercise.points:<3}{state}".rstrip())
        solved = sum(1 for exercise in self.catalogue if exercise.path in standings and standings[exercise.path].solved)
        say(f"\n{bar(points, whole)} {points} of {whole} points, {solved} of {len(self.catalogue)} exercises solved")
        return 0

    def reset(self, arguments):
        exercise = self.named(arguments.word)
        backup = self.place.reset(exercise)
        self.progress.note(exercise.path, "reset")
        say(f"{self._shown(self.place.header_of(exercise))} is the starter again; what was there is {backup.name}")
        return 0

    def compare(self, arguments):
        exercise = self.named(arguments.word)
        self._require_start(exercise)
        solutions = self.root / "solutions" / exercise.path
        if not (solutions / exercise.header).exists():
            raise Complaint("this copy of the course holds no solutions, so there is nothing to compare with")
        if not self.progress.standing(exercise.path).solved:
            raise Complaint(f"first solve it: ./course check {exercise.name}. ./course hint {exercise.name} helps")
        why = why_not_taken(self.place.header_of(exercise))
        if why:
            raise Complaint(why)
        mine = self.place.header_of(exercise).read_text(encoding="utf-8", errors="replace")
        other = solution_without_marks((solutions / exercise.header).read_text(encoding="utf-8"))
        difference = difflib.unified_diff(mine.splitlines(), other.splitlines(), "yours", "the course's", lineterm="", n=2)
        text = "\n".join(difference)
        say(text if text else "Yours is the course's, to the letter.")
        why = solutions / "why.md"
        say(f"\n--- {self._shown(why)}\n\n{why.read_text(encoding='utf-8').strip()}")
        self.progress.note(exercise.path, "compared")
        return 0

    # --- helpers ---------------------------------------------------------------------------------------------------

    def _check(self, exercise, show=False):
        """Compiles, judges, prints the verdict; returns whether it is solved."""
        began = time.monotonic()
        toolchain, header = self.toolchain(), self.place.header_of(exercise)
        folder = folder_of(toolchain, exercise) / "mine"
        say(exercise.title)
        why = why_not_taken(header)
        if why:
            say(f"\nIt can't be graded: {why}.")
            self._times(began, None)
            return False
        folder.mkdir(parents=True, exist_ok=True)
        with held(folder / "check"):  # or another check of the same exercise would change the programs that are judged
            return self._check_alone(exercise, toolchain, header, folder, began, show)

    def _check_alone(self, exercise, toolchain, header, folder, began, show):
        try:
            judge_program = prepare(toolchain, exercise, self.place.key)
            alone = folder / "handed_in"  # so that nothing else in work/ is found, as where it is graded
            write_if_new(alone / exercise.header, header.read_bytes())
            worker = build_worker(toolchain, exercise, alone, folder)
        except CommandFailed as failure:
            say("\nIt doesn't compile. The compiler's first complaint:\n")
            say(why_not(failure.output, exercise))
            self._times(began, None)
            return False
        compiled = time.monotonic() - began
        compilers = {Path(file).parent for file in dependencies_in(f"{toolchain.precompiled_header}.d")}
        foreign = why_foreign(read_for_worker(folder), toolchain, exercise, folder, *compilers)
        if foreign:
            say(f"\nIt can't be graded: {foreign}.")
            self._times(began, None)
            return False
        verdict = judge(exercise, judge_program, worker.programs, self.place.parameters(exercise), limits_of_workers())
        warning = first_message(worker.warnings, header, "warning")
        say("\n".join(said(exercise, verdict)))
        if warning:
            say("\nThe compiler wonders:\n" + warning)
        points = verdict.points(exercise)
        self.progress.note(exercise.path, "solved" if verdict.solved else "checked", f"{points}/{exercise.points}")
        if not judge_program.reference:
            say("\nThis is practice: no solution is here, so nothing was asked beyond the checks, as it is where answers are graded.")
        self._times(began, compiled, f"{points} of {exercise.points} points {bar(points, exercise.points, 20)}")
        if has_replay(exercise) and (verdict.solved or show):
            page = header.with_suffix(".html")
            say("\nMaking the replay, for which one more program is compiled: some seconds ...")
            failure, _ = make_replay(toolchain, exercise, alone, folder, page)
            say(f"\nThe replay was not made: {failure}" if failure else f"\nSee it move: open {self._shown(page)} in a browser.")
        if verdict.solved:
            self._praise(exercise)
        return verdict.solved

    def _times(self, began, compiled, points="no points yet"):
        whole = time.monotonic() - began
        parts = "" if compiled is None else f", of which {compiled:.1f} s to compile"
        say(f"\n{points}   ({whole:.1f} s{parts})")

    def _praise(self, exercise):
        say(f"\nSolved. {exercise.learned}")
        if (self.root / "solutions" / exercise.path).exists():
            say(f"The course's own way, and why: ./course compare {exercise.name}")
        try:
            say(f"Next: {self._next().title}, ./course start {self._next().name}")
        except Complaint as complaint:
            say(complaint)

    def _next(self):
        """The first unsolved exercise after the one last worked on, or else from the beginning on."""
        standings = self.progress.standings()
        paths = [exercise.path for exercise in self.catalogue]
        begin = next((paths.index(path) for path in reversed(standings) if path in paths), 0)
        for exercise in self.catalogue[begin:] + self.catalogue[:begin]:
            if not (exercise.path in standings and standings[exercise.path].solved):
                return exercise
        raise Complaint("Every exercise is solved. What is left is to invent one." if self.catalogue
                        else "there are no exercises here")

    def _require_start(self, exercise):
        if not self.place.started(exercise):
            raise Complaint(f"{exercise.name} was not started yet: ./course start {exercise.name}")

    def _shown(self, path):
        return os.path.relpath(path, self.root)


def main(words):
    occupy_standard_descriptors()
    parser = argparse.ArgumentParser(prog="course", usage="./course COMMAND [NAME] [OPTION]; ./course help lists them")
    parser.add_argument("--root", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--toolchain", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("command", choices=("start", "check", "watch", "hint", "next", "progress", "reset", "compare"))
    parser.add_argument("word", nargs="?", default="", help="an exercise, such as hammer")
    parser.add_argument("--key", help="start: the word from which your own numbers are drawn, if your teacher gave you one")
    parser.add_argument("--show", action="store_true", help="check: make the replay of a lab though it isn't solved yet")
    arguments = parser.parse_args(words)
    method = {"progress": "show_progress"}.get(arguments.command, arguments.command)
    return status_of(lambda: getattr(Student(arguments.root, arguments.toolchain), method)(arguments))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
