"""The compiler's own first error, shortened to what concerns the student's file."""

import re
from pathlib import Path

PLACE = re.compile(r"^(?P<file>[^\s:][^:]*):(?P<line>\d+):(?:(?P<column>\d+):)? *(?P<rest>.*)$")

LONGEST = 2000  # letters of what is handed on, as of what a worker says

EXPRESSION = re.compile(r"(?:\bEigen::|')(?:Cwise\w+Op|Product|Transpose|Block|VectorBlock|Diagonal)\b")


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
    """The first error for whoever wrote the exercise's header, which can make it as long as it likes."""
    said = _why_not(output, exercise)
    return said if len(said) <= LONGEST else f"{said[:LONGEST]} ..."


def _why_not(output, exercise):
    """Where the error lies in the code that calls the header's functions, one of them is missing or declared in another way, and the
    compiler's own words are of no use; nor are they where a brace is missing."""
    brace = _open_brace(output, exercise.header)
    if brace:
        return brace
    message = first_message(output, exercise.header)
    if re.match(r"answers(?:_\w+\.cpp|\.hpp):", message) and f"{exercise.header}:" not in message:
        return f"{exercise.header} must declare, as its starter does: {', '.join(exercise.functions)}.\n{message}"
    if re.search(r"fatal error: .*: No such file or directory|fatal error: '.*' file not found", message):
        return (f"{exercise.header} is handed in alone: besides the standard library it may include the headers of the chapters up to "
                f"{exercise.chapter}.\n{message}")
    if "no matching function for call to" in message and EXPRESSION.search(output):
        return ("A sum, product or part of vectors is an expression, and no vector yet, so a template can't tell its type. Make it "
                f"one first: Vec3<Real>(a + b). Or name the type: f<Real>(a + b).\n{message}")
    return message


def _open_brace(output, header):
    """Which brace of the student's file is still open at its end; empty if none is."""
    if not re.search(r"error: expected [‘']}[’'](?: at end of input)?$", output, re.MULTILINE):
        return ""
    lines = output.splitlines()
    for index, line in enumerate(lines):
        place = PLACE.match(line)
        if place and Path(place["file"]).name == header and place["rest"].startswith("note: to match this"):
            return "\n".join([f"{header}:{place['line']}: error: a closing brace is missing: this one is still open where the file "
                              "ends", *_quoted(lines[index + 1:])])
    return ""


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
