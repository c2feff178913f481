"""The wrong answers that an exercise must catch, as changes of its solution, in wrong.txt. Under the sentence of each check stand those
that it must catch, each with a part of the message that it must get, and a blank line after it:

    caught by: the sentence of the check that must fail
    on_earth: a part of the message
    - lines of the solution
    + what becomes of them

Under the line "right as well" stand other right answers, which must pass, each with why it is one in place of a message. Lines may be
replaced in several places, each of which occurs once in the solution.
"""

import re
from dataclasses import dataclass

from complaint import Complaint

CAUGHT_BY, RIGHT = "caught by: ", "right as well"


@dataclass(frozen=True)
class WrongAnswer:
    name: str
    text: str
    caught_by: str  # empty where it is right
    message: str


def read_wrong_answers(exercise, folder, solution):
    """Those in the folder of an exercise; `solution` is the text that they change."""
    file, check, answers = folder / "wrong.txt", None, []
    for block in re.split(r"\n\n+", file.read_text(encoding="utf-8").strip("\n")):
        lines = block.split("\n")
        if lines[0] == RIGHT:
            check = ""
            lines.pop(0)
        elif lines[0].startswith(CAUGHT_BY):
            check = lines.pop(0)[len(CAUGHT_BY):]
            if check not in [each.sentence for each in exercise.checks]:
                raise Complaint(f'{file} names "{check}", which is no check of {exercise.path}')
        answers.append(_answer(file, check, lines, solution))
    wrong = sum(1 for answer in answers if answer.caught_by)
    if wrong < 2:
        raise Complaint(f"{exercise.path} has {wrong} wrong answers in {folder}; it must have at least two")
    return sorted(answers, key=lambda answer: answer.name)


def _answer(file, check, lines, solution):
    head = re.fullmatch(r"(\w+): (.+)", lines[0]) if lines and check is not None else None
    if not head:
        raise Complaint(f'{file}: "{lines[0] if lines else check}" must be "NAME: PART OF THE MESSAGE", after "{CAUGHT_BY}SENTENCE"')
    name, message = head.groups()
    text = f"\n{solution}"
    for change in re.finditer(r"((?:^-.*\n)+)((?:^\+.*\n)+)|.+\n", "".join(f"{line}\n" for line in lines[1:]), re.MULTILINE):
        if change[1] is None:
            raise Complaint(f'{file}: {name} has lines that begin with "- " and then some with "+ ", and no "{change[0].strip()}"')
        old, new = (re.sub(r"^[-+] ?", "", part, flags=re.MULTILINE) for part in change.groups())
        times = len(re.findall(f"(?=\n{re.escape(old)})", text))  # those that overlap too
        if times != 1:
            raise Complaint(f"{file}: {name} replaces lines that occur {times} times in the solution: {old.strip()}")
        text = text.replace(f"\n{old}", "\n" if change[2] == "+\n" else f"\n{new}")
    return WrongAnswer(name, text[1:], check, message)
