"""Makes the starter from the solution.

    //! [solution] the moment about the hinge       the starter says todo("the moment about the hinge");
    return mass * length * length / 3;
    //! [end]

    //! [solution]                                  the starter has the lines of the part [starter] instead
    return Real(1.62);
    //! [starter]
    // return Real(9.81);
    //! [end]

A region holds no other, each one is ended, and one without a sentence has a [starter] part, which may be empty.
"""

import json
import re

from complaint import Complaint

MARK = re.compile(r"^(\s*)//!\s*\[(solution|starter|end)\](.*)$")


def starter_of(solution, name="the solution"):
    return _split(solution, name)[0]


def solution_without_marks(solution, name="the solution"):
    """What a reader is shown: the whole solution, without the marks and without the starter's own lines."""
    return _split(solution, name)[1]


def regions_of(solution, name="the solution"):
    """The code of each region: what a student shall write."""
    return _split(solution, name)[2]


def _split(solution, name):
    """The starter, the solution as it is shown, and the regions' code."""
    starter, shown, regions = [], [], []
    opened, part = None, ""  # the line of the open region, and the part of it that we are in
    for count, line in enumerate(solution.splitlines(), 1):
        where = f"{name}:{count}: "
        mark = MARK.match(line)
        if not mark:
            if re.match(r"\s*//!\s*\[", line):
                raise Complaint(f"{where}{line.strip()} is no mark; the marks are [solution], [starter] and [end]")
            if part != "starter":
                shown.append(line)
            if part == "solution":
                regions[-1] += line + "\n"
            if part == "":
                starter.append(line)
            elif part == "starter":
                starter.append(_uncommented(line, where))
            continue
        indent, word, sentence = mark.group(1), mark.group(2), mark.group(3).strip()
        if word == "solution":
            if opened:
                raise Complaint(f"{where}a region inside the one of line {opened}; regions must not be nested")
            opened, part, said = count, "solution", sentence
            regions.append("")
            if said:
                starter.append(f"{indent}todo({json.dumps(said, ensure_ascii=False)});")
            continue
        if not opened:
            raise Complaint(f"{where}[{word}] without [solution] before it")
        if sentence:
            raise Complaint(f'{where}"{sentence}" stands after [{word}]; a sentence may follow [solution] only')
        if word == "starter":
            if part == "starter":
                raise Complaint(f"{where}a second [starter] in the region of line {opened}")
            if said:
                raise Complaint(f'{where}the region of line {opened} has a sentence for todo, "{said}"; it must not have a '
                                "[starter] part too")
            part = "starter"
        else:
            if part == "solution" and not said:
                raise Complaint(f"{where}nothing would stand in the place of the region of line {opened}; say after "
                                "[solution] what is to be done, or give a [starter] part")
            opened, part = None, ""
    if opened:
        raise Complaint(f"{name}:{opened}: [solution] without [end]")
    if not regions:
        raise Complaint(f"{name} has no [solution] region, so its starter would be solved")
    return _joined(starter), _joined(shown), regions


def _uncommented(line, where):
    found = re.fullmatch(r"(\s*)//(?: (.*)|)", line)
    if not found:
        raise Complaint(f"{where}{line.strip()!r} in a [starter] part; its lines must be comments, // and a blank before each")
    return (found.group(1) + (found.group(2) or "")).rstrip()


def _joined(lines):
    return "\n".join(lines) + "\n"
