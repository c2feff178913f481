"""The verdict on one exercise: each check by its sentence, then points and times."""

import textwrap
from dataclasses import dataclass

from limits import Limits
from run_check import BROKEN, FAILED, PASSED, TODO, run_check

SIGNS = {PASSED: "+", FAILED: "x", TODO: ".", BROKEN: "?"}


@dataclass(frozen=True)
class Verdict:
    outcomes: list  # of the checks, in their order

    @property
    def solved(self):
        return all(outcome.status == PASSED for outcome in self.outcomes)

    def points(self, exercise):
        return sum(check.points for check, outcome in zip(exercise.checks, self.outcomes) if outcome.status == PASSED)


def judge(exercise, judge_program, workers, parameters, limits=Limits(), folder=None):
    """Runs every check. After one that took too long, the others still get their turn."""
    numbers = range(len(exercise.checks))
    return Verdict([run_check(judge_program, number, workers, parameters, limits, folder) for number in numbers])


def said(exercise, verdict, width=100):
    """The verdict as lines. The first failure is told in full, others after it too; what was printed comes once."""
    lines = []
    for check, outcome in zip(exercise.checks, verdict.outcomes):
        passed = outcome.status == PASSED
        points = f"{check.points if passed else 0} of {check.points}"
        lines += _wrapped(f" {SIGNS[outcome.status]} {check.sentence}", width - 10, "   ", points)
        if outcome.status == TODO:
            lines += _indented(f"not written yet: {outcome.message}", width)
        elif not passed:
            lines += _indented(outcome.message, width)
    printed = next((outcome.printed for outcome in verdict.outcomes if outcome.printed.strip()), "")
    if printed:
        shown = printed.strip().splitlines()
        lines += ["", "Your code printed, in the first check that made it print:"]
        lines += ["  | " + line[:width] for line in shown[:10]] + (["  | ..."] if len(shown) > 10 else [])
    return lines


def _wrapped(text, width, indent, points):
    lines = textwrap.wrap(text, width, subsequent_indent=indent, drop_whitespace=False)
    lines = [lines[0]] + [indent + line.strip() for line in lines[1:]]
    lines[0] = f"{lines[0]:<{width}}{points:>10}"
    return lines


def _indented(text, width):
    return textwrap.wrap(text, width, initial_indent="     ", subsequent_indent="     ")
