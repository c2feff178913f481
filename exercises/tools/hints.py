"""The three hints of an exercise, each saying more than the one before: hints.md, with the headings ## 1, ## 2 and ## 3."""

import re

from complaint import Complaint


def read_hints(file):
    try:
        text = file.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise Complaint(f"{file} is missing; an exercise has three hints") from None
    parts = re.split(r"^## *(.*?) *$", text, flags=re.MULTILINE)
    headings, hints = parts[1::2], [part.strip("\n").rstrip() for part in parts[2::2]]
    if headings != ["1", "2", "3"]:
        raise Complaint(f"{file} has the headings {', '.join(headings) or 'none'}; it must have ## 1, ## 2 and ## 3")
    for number, hint in enumerate(hints, 1):
        if not hint:
            raise Complaint(f"{file}: hint {number} is empty; each must say more than the one before")
        if hint in hints[:number - 1]:
            raise Complaint(f"{file}: hint {number} says what an earlier one has said; each must say more")
    return hints
