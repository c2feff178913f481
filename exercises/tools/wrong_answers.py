"""The wrong answers that an exercise must catch: each begins with

    // caught by: the sentence of the check that must fail
    // message: a part of the message that it must get

Either may go on in the next line.
"""

import re
from dataclasses import dataclass
from pathlib import Path

from complaint import Complaint


@dataclass(frozen=True)
class WrongAnswer:
    name: str
    file: Path
    caught_by: str
    message: str


def read_wrong_answers(exercise, folder):
    answers = [_read(exercise, file) for file in sorted(folder.glob("*.hpp"))]
    if len(answers) < 2:
        raise Complaint(f"{exercise.path} has {len(answers)} wrong answers in {folder}; it must have at least two")
    return answers


def _read(exercise, file):
    comment = re.match(r"(?://.*\n)*", file.read_text(encoding="utf-8")).group(0)
    head = re.fullmatch(r"caught by: (.+) message: (.+)", re.sub(r"\s*//\s*|\n", " ", comment).strip())
    if not head:
        raise Complaint(f'{file} must begin with the comments "// caught by: SENTENCE" and "// message: PART OF IT"')
    caught_by, message = head.group(1).strip(), head.group(2).strip()
    if caught_by not in [check.sentence for check in exercise.checks]:
        raise Complaint(f'{file} shall be caught by "{caught_by}", which is no check of {exercise.path}')
    return WrongAnswer(file.stem, file, caught_by, message)
