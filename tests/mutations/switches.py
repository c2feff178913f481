"""Writes a header in which all its mutants can be switched, and finds the one that a compiler's complaint is about."""
import re
from dataclasses import dataclass, field

from generator import Wrap


@dataclass
class Switched:
    text: str
    spans: list = field(default_factory=list)  # (start, end, site), of what was written


class Overlap(Exception):
    """Two ranges overlap, and neither holds the other."""


def switched(text, sites):
    """`sites` are pairs of a key and its edits."""
    wraps, replaces, order = [], {}, 0
    for key, edits in sites:
        for edit in edits:
            order += 1
            if isinstance(edit, Wrap):
                wraps.append((edit, order, key))
            else:
                replaces[edit.start] = (edit, key)
    opening = sorted(wraps, key=lambda w: (w[0].start, -w[0].end, w[1]))
    out, spans, stack = [], [], []
    length, place, next_open = 0, 0, 0

    def write(part):
        nonlocal length
        out.append(part)
        length += len(part)

    positions = sorted({w[0].start for w in wraps} | {w[0].end for w in wraps} | set(replaces))
    for position in positions:
        if position < place:
            raise Overlap("an edit inside of what is replaced")
        write(text[place:position])
        place = position
        while stack and stack[-1][0].end == position:
            wrap, key, begun = stack.pop()
            write(wrap.after)
            spans.append((begun, length, key))
        if stack and stack[-1][0].end < position:
            raise Overlap("two ranges overlap")
        while next_open < len(opening) and opening[next_open][0].start == position:
            wrap, _, key = opening[next_open]
            if stack and stack[-1][0].end < wrap.end:
                raise Overlap("two ranges overlap")
            stack.append((wrap, key, length))
            write(wrap.before)
            next_open += 1
        if position in replaces:
            edit, key = replaces[position]
            begun = length
            write(edit.by)
            spans.append((begun, length, key))
            place = edit.end
    write(text[place:])
    return Switched("".join(out), spans)


def offset_of(text, line, column):
    """Where a compiler's line and column are; it counts columns in bytes."""
    lines = text.split("\n")
    if line > len(lines):
        return len(text)
    before = sum(len(row) + 1 for row in lines[:line - 1])
    return before + len(lines[line - 1].encode()[:max(column - 1, 0)].decode(errors="ignore"))


def blamed(switched_header, line, column):
    """The site of the narrowest span around a place; where none is around it, all that begin in the line."""
    place = offset_of(switched_header.text, line, column)
    around = [(end - start, key) for start, end, key in switched_header.spans if start <= place < end]
    if around:
        return {min(around)[1]}
    start = offset_of(switched_header.text, line, 1)
    end = offset_of(switched_header.text, line + 1, 1)
    return {key for a, b, key in switched_header.spans if start <= a < end}


def complaints(stderr, folder):
    """(header, line, column) for each error: the first place of its block that lies in the folder of switched headers, told
    as a list of places from the innermost out."""
    blocks, block = [], []
    for row in stderr.splitlines():
        place = re.match(rf"(?:In file included from |\s+from )?{re.escape(str(folder))}/(\S+?):(\d+):(\d+)", row)
        here = (place[1], int(place[2]), int(place[3])) if place and "included from" not in row and not row.startswith(" ") else None
        if here:
            block.append(here)
        if ": error: " in row or "fatal error" in row or "compilation terminated" in row:
            blocks.append(block)
            block = []
    return [block for block in blocks if block]
