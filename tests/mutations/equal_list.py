"""The lists of generated mutants that no check can tell from the original: equal/NN_name.txt, such as

    tumble/mesh.hpp: to reserve more or less than is needed changes no value
    a dropped statement; 3 → 4: edges.reserve(3 * mesh.triangles.size());

The first line names the header and says why. In the others stand, behind ": ", the lines of the header that mutants change, as one
and with single blanks, and before it which: all of a kind, or all that put one text in place of another. Where that would name too
many, "- " and the lines as they are is followed by "+ " and the lines as they become, once or more often. Blank lines stand between
the reasons."""
import re
from pathlib import Path

from mutation_list import ListError

kinds = {"a sign", "a factor", "a constant", "a comparison", "and, or", "a dropped negation", "a dropped statement",
         "a negated condition", "swapped arguments"}


def read_equal(files):
    """A reason for each (header, old lines, which of their changes), from such lists. The third is one of names_of()."""
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
                elif all(name in kinds or " → " in name for name in row.partition(": ")[0].split("; ")):
                    names, _, lines = row.partition(": ")
                    reasons |= {(headline[1], lines, name): headline[2] for name in names.split("; ")}
                else:
                    raise ListError(f"{path.name}, at \"{row}\": a line begins with a kind or \"OLD → NEW\", and a colon, or with "
                                    "\"- \", and after that with \"+ \"")
    return reasons


def lines_of(text, start, end, replacement):
    """The lines of the header that a change touches, and what becomes of them."""
    first, last = text.rfind("\n", 0, start) + 1, text.find("\n", end)
    old, new = text[first:last], text[first:start] + replacement + text[end:last]
    return " ".join(old.split()), " ".join(new.split())


def names_of(kind, text, start, end, replacement):
    """The three names by which a list may know a generated change, each behind the lines that it touches."""
    old, new = lines_of(text, start, end, replacement)
    return [(old, name) for name in (new, kind, " → ".join(" ".join(part.split()) for part in (text[start:end], replacement)))]
