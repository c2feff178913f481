"""The lists of mutations: one file a chapter, NN_name.txt, exact.txt for the exact solutions, scene_reader.txt for its headers, and
simulate.txt and advise.txt for these programs, in which a file's path stands in place of a header's name. Such as

    tumble/force.hpp: a force replaces those before it
    particle.force += force; → particle.force = force;
    equivalent: a sentence that proves that nothing is broken

The first line names the header and says what breaks. What stands before the arrow must occur exactly once in the header, and what
stands behind it takes its place; nothing there deletes. What doesn't fit into a line stands behind "- ", as many lines as it has, and
what takes its place behind "+ ". "equivalent", which is seldom needed, says that no check can see the mutation. Blank lines stand
between mutations, and lines that begin with # are remarks."""
import re
from dataclasses import dataclass
from pathlib import Path


class ListError(Exception):
    """A list is wrong; the sentence says where and how."""


@dataclass
class Mutation:
    chapter: str
    header: str  # as it is included
    breaks: str
    original: str
    replacement: str
    proof: str = ""

    def __str__(self):
        return f"{self.chapter} {self.header}: {self.breaks}"

    def apply(self, text):
        """The text of the header with the mutation in it."""
        count = text.count(self.original)
        if count != 1:
            raise ListError(f"{self}: its header holds \"{self.original}\" {count} times; it must do so exactly once")
        return text.replace(self.original, self.replacement)


def read_mutation(chapter, block):
    """A Mutation from the lines that stand between two blank ones."""
    place = f"list of {chapter}, at \"{block[0]}\""
    headline = re.fullmatch(r"(tumble/[\w/]+\.hpp|tools/[\w/]+\.[ch]pp): (.+)", block[0])
    if not headline:
        raise ListError(f"{place}: a mutation begins with \"tumble/NAME.hpp: what it breaks\"")
    mutation = Mutation(chapter, *headline.groups(), "", "")
    lines = {"-": [], "+": []}
    for line in block[1:]:
        if line[:2] in ("-", "- ", "+", "+ "):
            lines[line[0]].append(line[2:])
        elif line.startswith("equivalent: "):
            mutation.proof = line.removeprefix("equivalent: ")
        elif " →" in line:
            old, _, new = line.partition(" →")
            lines["-"].append(old)
            lines["+"].append(new.removeprefix(" "))
        else:
            raise ListError(f"{place}: \"{line}\" has no arrow and begins with none of \"- \", \"+ \", \"equivalent: \"")
    mutation.original, mutation.replacement = "\n".join(lines["-"]), "\n".join(lines["+"])
    if not mutation.original or not lines["+"] or mutation.original == mutation.replacement:
        raise ListError(f"{place}: a mutation needs a text that is replaced, and another that replaces it")
    return mutation


def read_list(path):
    """All mutations of a list; the file's name is that of the folder that holds the checks."""
    text = "".join(line for line in Path(path).read_text().splitlines(keepends=True) if not line.startswith("#"))
    blocks = [block.strip("\n").split("\n") for block in re.split(r"\n\n+", text) if block.strip()]
    return [read_mutation(Path(path).stem, block) for block in blocks]
