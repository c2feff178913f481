"""The compiler's own first error, shortened to what concerns the student's file."""

import re
from pathlib import Path

PLACE = re.compile(r"^(?P<file>[^\s:][^:]*):(?P<line>\d+):(?:(?P<column>\d+):)? *(?P<rest>.*)$")

LONGEST = 2000  # letters of what is handed on, as of what a worker says

NO_MEMBER = re.compile(r"‘(?:const )?struct tumble::(?P<gcc>\w+)\b[^’]*’ has no member named ‘(?P<gcc_asked>\w+)|"
                       r"no member named '(?P<asked>\w+)' in '(?:const )?tumble::(?P<clang>\w+)|"
                       r"(?:<brace-enclosed initializer list>[’'] to|does not refer to any field in type) [‘'](?:const )?tumble::(?P<list>\w+)")
MEMBER = re.compile(r"^  (?!using )(?:const )?(?:tumble::)?(?P<type>\w+)(?:<[^;{}()]*>)?&? (?P<name>\w+)(?:\s*=\s*[^;]*|\{[^;]*\})?;",
                    re.MULTILINE)

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
    why = _of_packs(message, output) or _of_members(message, exercise)
    if why:
        return f"{why}\n{message}"
    if "no matching function for call to" in message and EXPRESSION.search(output):
        return ("A sum, product or part of vectors is an expression, and no vector yet, so a template can't tell its type. Make it "
                f"one first: Vec3<Real>(a + b). Or name the type: f<Real>(a + b).\n{message}")
    return message


def _of_packs(message, output):
    """Why a number's code does not do for a pack; empty if it is not that."""
    if re.search(r"fd_set|no matching function for call to [‘']select\b", message):
        return ("With numbers, select alone is a function of the operating system; and tumble::select takes no packs, which have a select "
                'of their own. Write "using tumble::select;" first, and select(condition, if_true, if_false) finds either.')
    if "PackMask<" in message and "bool" in message:
        return ("A comparison of packs has an answer for each lane, so neither if nor ?: nor std::max can take one way for all of them. "
                "Compute both sides, and choose: select(condition, if_true, if_false).")
    function = re.search(r"no matching function for call to [‘'](?:std::)?(sqrt|abs)\b", message)
    if function and "Pack<" in output:
        return (f'std::{function[1]} takes no packs, which have one of their own. Write "using std::{function[1]};" first, and '
                f"{function[1]}(x) finds either.")
    return ""


def _of_members(message, exercise):
    """Which members a struct of the course has, where one was asked for that it hasn't; empty if it is not that."""
    found = NO_MEMBER.search(message)
    if not found:
        return ""
    root = exercise.folder.parents[2]
    struct, asked = found["gcc"] or found["clang"] or found["list"], found["gcc_asked"] or found["asked"]
    members = _members(struct, root)
    if not members:
        return ""
    *others, last = members
    said = f"The members of {struct} are {', '.join(others)} and {last}" if others else f"The only member of {struct} is {last}"
    inner = [name for name, kind in members.items() if asked in _members(kind, root)]
    return said + (f"; {asked} is a member of {' and of '.join(inner)}." if inner else ".")


def _members(struct, root):
    """The members of a struct in the chapters' headers, each with its type; none if there is no such struct."""
    for header in sorted(root.glob("chapters/*/tumble/*.hpp")):
        body = re.search(rf"^struct {struct}\b[^;{{]*{{\n(.*?)^}};", header.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
        if body:
            return {member["name"]: member["type"] for member in MEMBER.finditer(body[1])}
    return {}


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
    while quoted and re.fullmatch(r"[ |]*", quoted[-1]):  # which leads to a label that isn't quoted
        quoted.pop()
    return quoted


def _way_there(lines, index, name):
    """Where in the student's file the place in another file was asked for."""
    for line in lines[max(index - 12, 0):index + 12]:
        place = PLACE.match(line)
        if place and Path(place["file"]).name == name:
            return [f"which {name}:{place['line']} leads to"]
    return []
