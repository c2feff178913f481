"""An exercise: its folder, and what exercise.json says of it."""

import json
import re
from dataclasses import dataclass
from pathlib import Path

from complaint import Complaint
from rules import (identifiers, known_keys, number, one_of, sentence, sentences, step_within, whole_number)

DIFFICULTIES = ("change", "write", "derive", "prove", "lab")


@dataclass(frozen=True)
class Check:
    sentence: str
    points: int


@dataclass(frozen=True)
class Parameter:
    """A number that may differ from student to student."""
    name: str
    unit: str
    usual: float
    least: float
    most: float
    step: float


@dataclass(frozen=True)
class Exercise:
    chapter: str
    name: str
    folder: Path
    title: str
    goals: tuple
    prerequisites: tuple
    minutes: int
    difficulty: str
    functions: tuple
    checks: tuple
    parameters: tuple
    learned: str

    @property
    def path(self):
        """Its place below exercises/, solutions/ and work/."""
        return f"{self.chapter}/{self.name}"

    @property
    def header(self):
        return f"{self.name}.hpp"

    @property
    def points(self):
        return sum(check.points for check in self.checks)


def read_exercise(folder):
    """The exercise in a folder; a Complaint where exercise.json breaks a rule."""
    file = folder / "exercise.json"
    try:
        said = json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise Complaint(f"{folder} has no exercise.json") from None
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise Complaint(f"{file} is no JSON: {error}") from None
    try:
        return _exercise(folder, said)
    except Complaint as complaint:
        raise Complaint(f"{file}: {complaint}") from None


def _exercise(folder, said):
    chapter, name = folder.parent.name, folder.name
    if not re.fullmatch(r"\d\d_[a-z0-9_]+", chapter):
        raise Complaint(f'the folder is in "{chapter}"; it must be in that of a chapter, such as 03_inertia')
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name):
        raise Complaint(f'the exercise is called "{name}"; its name must be small letters, digits and _')
    known_keys("the exercise", said, required=("title", "goals", "prerequisites", "minutes", "difficulty", "functions",
                                               "checks", "learned"), optional=("parameters",))
    return Exercise(
        chapter=chapter, name=name, folder=folder,
        title=sentence("title", said["title"]),
        goals=sentences("goals", said["goals"]),
        prerequisites=_prerequisites(chapter, said["prerequisites"]),
        minutes=whole_number("minutes", said["minutes"], 1, 600),
        difficulty=one_of("difficulty", said["difficulty"], DIFFICULTIES),
        functions=identifiers("functions", said["functions"]),
        checks=_checks(said["checks"]),
        parameters=_parameters(said.get("parameters", {})),
        learned=sentence("learned", said["learned"]))


def _prerequisites(chapter, said):
    names = sentences("prerequisites", said)
    for name in names:
        if not re.fullmatch(r"\d\d_[a-z0-9_]+(/[a-z][a-z0-9_]*)?", name):
            raise Complaint(f'prerequisites names "{name}"; it must be a chapter, such as 03_inertia, or an exercise of '
                            "one, such as 03_inertia/hammer")
        if name[:2] > chapter[:2]:
            raise Complaint(f'prerequisites names "{name}"; it must not come after the chapter of the exercise, {chapter}')
    return names


def _checks(said):
    if not isinstance(said, list) or not said:
        raise Complaint(f"checks is {json.dumps(said)}; it must be a list of one or more")
    checks = []
    for each in said:
        known_keys("a check", each, required=("sentence", "points"))
        checks.append(Check(sentence("the sentence of a check", each["sentence"]),
                            whole_number("points", each["points"], 1, 100)))
    twice = [check.sentence for check in checks if [other.sentence for other in checks].count(check.sentence) > 1]
    if twice:
        raise Complaint(f'two checks say "{twice[0]}"; each must have a sentence of its own')
    return tuple(checks)


def _parameters(said):
    if not isinstance(said, dict):
        raise Complaint(f"parameters is {json.dumps(said)}; it must be an object with a name for each")
    parameters = []
    for name, each in said.items():
        identifiers("the name of a parameter", [name])
        known_keys(f"parameter {name}", each, required=("unit", "usual", "least", "most", "step"))
        if not isinstance(each["unit"], str):
            raise Complaint(f"parameter {name}: unit is {json.dumps(each['unit'])}; it must be a text")
        values = {key: number(f"parameter {name}: {key}", each[key]) for key in ("usual", "least", "most", "step")}
        step_within(f"parameter {name}", **values)
        parameters.append(Parameter(name=name, unit=each["unit"], **values))
    return tuple(parameters)
