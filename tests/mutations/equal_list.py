"""The lists of generated mutants that no check can tell from the original: equal/NN_name.txt, such as

    tumble/mesh.hpp: to reserve more or less than is needed changes no value
    - edges.reserve(3 * mesh.triangles.size());
    + edges.reserve(4 * mesh.triangles.size());
    + ;

The first line names the header and says why. Behind "- " stand the lines of the header that a mutant changes, as one and with
single blanks, behind each "+ " what becomes of them. Several pairs may follow one reason. Blank lines stand between the
reasons."""
import re
from pathlib import Path

from mutation_list import ListError


def read_equal(files):
    """A reason for each (header, old lines, new lines), from such lists."""
    reasons = {}
    for path in map(Path, files):
        for block in re.split(r"\n\n+", path.read_text().strip("\n")):
            rows = block.split("\n")
            headline = re.fullmatch(r"([\w/]+\.hpp): (.+)", rows[0])
            if not headline:
                raise ListError(f"{path.name}, at \"{rows[0]}\": a reason begins with the header, as in \"tumble/mesh.hpp: why\"")
            old = None
            for row in rows[1:]:
                if row.startswith("- "):
                    old = row[2:]
                elif row[:2] in ("+ ", "+") and old is not None:
                    reasons[headline[1], old, row[2:]] = headline[2]
                else:
                    raise ListError(f"{path.name}, at \"{row}\": a line begins with \"- \", and after one with \"+ \"")
    return reasons


def lines_of(text, start, end, replacement):
    """The lines of the header that a change touches, and what becomes of them."""
    first, last = text.rfind("\n", 0, start) + 1, text.find("\n", end)
    old, new = text[first:last], text[first:start] + replacement + text[end:last]
    return " ".join(old.split()), " ".join(new.split())
