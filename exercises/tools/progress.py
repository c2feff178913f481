"""What a student has done so far: work/progress.txt, to which lines are added and from which none is ever removed.

    2026-03-02T14:05:31 03_inertia/hammer solved 6/6

A line that says something else, or half of something, is passed over.
"""

import re
from dataclasses import dataclass
from datetime import datetime

LINE = re.compile(r"(\S+) (\d\d_[a-z0-9_]+/[a-z0-9_]+) (started|checked|solved|hint|compared|reset)(?: (\d{1,6})(?:/(\d{1,6}))?)?")


@dataclass
class Standing:
    """Where somebody stands with one exercise."""
    best: int = 0       # points
    solved: bool = False
    hints: int = 0      # how many were shown


class Progress:
    def __init__(self, file):
        self.file = file

    def note(self, exercise, word, detail=""):
        """Adds a line. What was cut off in the middle of one gets its line's end first."""
        self.file.parent.mkdir(parents=True, exist_ok=True)
        when = datetime.now().isoformat(timespec="seconds")
        with open(self.file, "ab+") as out:
            length = out.seek(0, 2)
            out.seek(max(length - 1, 0))
            begin = "" if length == 0 or out.read(1) == b"\n" else "\n"
            out.write(f"{begin}{when} {exercise} {word}{f' {detail}' if detail else ''}\n".encode())

    def standings(self):
        """Standing by exercise, in the order in which each was last worked on."""
        standings = {}
        for exercise, word, first, _ in self._lines():
            standing = standings.pop(exercise, Standing())
            standings[exercise] = standing
            if word in ("checked", "solved") and first:
                standing.best = max(standing.best, int(first))
            standing.solved |= word == "solved"
            if word == "hint" and first:
                standing.hints = max(standing.hints, int(first))
        return standings

    def standing(self, exercise):
        return self.standings().get(exercise, Standing())

    def _lines(self):
        try:
            text = self.file.read_text(encoding="utf-8", errors="replace")
        except FileNotFoundError:
            return
        for line in text.splitlines():
            found = LINE.fullmatch(line.strip())
            if found:
                yield found.groups()[1:]


def bar(part, whole, width=30):
    """[#####...]: a bar that any terminal can show."""
    filled = width * part // whole if whole else 0
    return "[" + "#" * filled + "." * (width - filled) + "]"
