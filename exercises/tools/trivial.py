"""Answers that take no thought, for the audit: the starter, each of whose functions may answer 0, infinity, its input and so on.

They are chosen while the program runs, so that one build tries them all; see exercise/trivial.hpp for what they are.
"""

import json
import re
import subprocess
from dataclasses import dataclass

from complaint import Complaint
from limits import Limits
from made import make
from programs import compile_shared, folder_of, judge_of, offers_of, write_if_new

FUNCTION = re.compile(r"^ *(?!else |return |new )(?P<result>[\w:][\w:<>, ]*?)\s+(?P<name>\w+)\((?P<parameters>[^(){};]*)\)"
                      r"\s*(?:const\s*)?\{", re.MULTILINE)


@dataclass(frozen=True)
class Place:
    """A function of a starter that may answer trivially."""
    name: str
    result: str
    parameters: tuple  # their names
    begin: int         # of its body, after the brace
    todo: int          # where todo stands, or -1
    goes_on: bool      # whether it returns something after its todo

    @property
    def may_be_left(self):
        return self.todo >= 0 and (self.goes_on or self.result == "void") or self.result == "void"


@dataclass(frozen=True)
class Earned:
    """A check that trivial answers pass; or break, which is a fault of the check."""
    sentence: str
    answers: str
    passes: bool


def places_of(starter, functions):
    """The functions that the checks ask for, and those in which something is to be written."""
    places = []
    for found in FUNCTION.finditer(starter):
        body = starter[found.end():_end_of_body(starter, found.end())]
        todo = body.find("todo(")
        if todo < 0 and found["name"] not in functions:
            continue
        names = tuple(filter(None, map(_name_of, _split(found["parameters"]))))
        places.append(Place(found["name"], found["result"], names, found.end(), todo + found.end() if todo >= 0 else -1,
                            "return " in body[max(todo, 0):]))
    return places


def trivial_header(starter, functions):
    """The starter, each of whose places first asks whether it shall answer trivially."""
    places = places_of(starter, functions)
    missing = set(functions) - {place.name for place in places}
    if missing or starter.count("todo(") != sum(place.todo >= 0 for place in places):
        raise Complaint(f"not every function of the starter could be read: {', '.join(sorted(missing)) or 'one with a todo'}")
    for number, place in reversed(list(enumerate(places))):
        if place.todo >= 0 and place.may_be_left:
            starter = starter[:place.todo] + "if (false) " + starter[place.todo:]
        arguments = ", ".join((str(number), *place.parameters))
        call = f" if (tumble::exercise::is_trivial({number})) return tumble::exercise::trivial<{place.result}>({arguments});"
        starter = starter[:place.begin] + call + starter[place.begin:]
    return starter, places


def earned_by_little(toolchain, exercise, parameters, limits=Limits(seconds=2)):
    """The checks that some combination of trivial answers passes, in double. Passing takes float, too, so more cannot."""
    folder = folder_of(toolchain, exercise) / "trivial"
    header, places = trivial_header((exercise.folder / exercise.header).read_text(encoding="utf-8"), exercise.functions)
    write_if_new(folder / exercise.header, header.encode())
    source, compiled, program = folder / "search.cpp", folder / "search.o", folder / "search"
    write_if_new(source, _source(exercise, places).encode())
    command, dependencies = toolchain.compile(source, compiled, exercise.chapter, first_folders=[folder])
    make(compiled, [*command, "-w"], inputs=[toolchain.precompiled_header], dependencies=dependencies)
    parts = [compiled, judge_of(toolchain, exercise).with_name("checks.o"),
             *(compile_shared(toolchain, name) for name in ("trivial", "serve"))]
    make(program, toolchain.link(parts, program), inputs=parts)
    words = [program, str(int(limits.seconds)), *(f"{name}={value!r}" for name, value in parameters)]
    said = json.loads(subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, check=True).stdout)
    return [Earned(exercise.checks[found["check"]].sentence, found["answers"], found["passes"])
            for found in said["found"]]


def _source(exercise, places):
    said = "".join(f'          {{"{place.name}", {_bool(place.todo < 0)}, {_bool(place.may_be_left)}}},\n' for place in places)
    return ("#include <exercise/trivial.hpp>\n"
            f"#include <{exercise.header}>\n\n"
            "int main(int argument_count, char** arguments) {\n"
            "  using tumble::exercise::answer;\n"
            "  return tumble::exercise::search(\n"
            "      argument_count, arguments,\n"
            "      {\n" + said + "      },\n      {\n" + offers_of(exercise, "double") + "      });\n"
            "}\n")


def _bool(truth):
    return "true" if truth else "false"


def _end_of_body(text, begin):
    """Where the brace is closed that was opened before `begin`."""
    depth = 1
    for index in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[index], 0)
        if depth == 0:
            return index
    return len(text)


def _split(parameters):
    """At the commas that don't stand within <>."""
    parts, depth = [""], 0
    for letter in parameters:
        depth += {"<": 1, ">": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


def _name_of(parameter):
    """Its name; none where it has only a type."""
    found = re.search(r"[\s&](\w+)$", parameter.strip())
    return found[1] if found else ""
