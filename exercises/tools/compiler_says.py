"""The compiler's own first error, shortened to what concerns the student's file."""

import re
from pathlib import Path

PLACE = re.compile(r"^(?P<file>[^\s:][^:]*):(?P<line>\d+):(?:(?P<column>\d+):)? *(?P<rest>.*)$")


def first_message(output, header, kind="error"):
    """The first error (or warning), with the student's line that led to it; empty if there is none."""
    name = Path(header).name
    lines = output.splitlines()
    for index, line in enumerate(lines):
        place = PLACE.match(line)
        if not place or not re.match(rf"(fatal )?{kind}: ", place["rest"]):
            continue
        if Path(place["file"]).name == name:
            return "\n".join([f"{name}:{place['line']}: {place['rest']}", *_quoted(lines[index + 1:])])
        return "\n".join([f"{Path(place['file']).name}:{place['line']}: {place['rest']}",
                          *_way_there(lines, index, name)])
    if kind == "error":
        return "\n".join(lines[:5])  # the linker's, or none that we know
    return ""


def why_not(output, exercise):
    """The first error for whoever wrote the exercise's header. Where it lies in the code that calls its functions, one of them is
    missing or declared in another way, and the compiler's own words are of no use."""
    message = first_message(output, exercise.header)
    if re.match(r"answers(?:_\w+\.cpp|\.hpp):", message) and f"{exercise.header}:" not in message:
        return f"{exercise.header} must declare, as its starter does: {', '.join(exercise.functions)}.\n{message}"
    return message


def _quoted(lines):
    """The lines with which the compiler shows the place: "   12 |   return 1;" and the mark below it."""
    quoted = []
    for line in lines[:3]:
        if not re.match(r"\s*\d* \|", line):
            break
        quoted.append(line)
    return quoted


def _way_there(lines, index, name):
    """Where in the student's file the place in another file was asked for."""
    for line in lines[max(index - 12, 0):index + 12]:
        place = PLACE.match(line)
        if place and Path(place["file"]).name == name:
            return [f"which {name}:{place['line']} leads to"]
    return []
