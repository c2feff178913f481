"""How a mutation of a list is switched: the statements that it changes stand there twice, in the arms of an if; a number
outside of all functions becomes a choice between two."""
import re

from generator import Wrap, late_variables
from source import read


def edits_of(text, start, end, replacement, number):
    """The edits that switch a change of a range of the header, none if nothing can, and whether they need late tables."""
    source = read(text)
    for a, b, by in (without_blanks(text, start, end, replacement), narrowed(text, start, end, replacement)):
        for function in source.functions:
            if function.start < a and b < function.end and not function.is_constexpr:
                place = statements_around(function.body, a, b)
                if place:
                    return [as_if(text, *place, a, b, by, number)], False
        for words, declared in source.initialisers:
            names = [word.text for word in declared if word.kind == "name"]
            is_late = bool(names) and names[-1] in late_variables
            for word in every(words):
                if word.kind == "number" and word.start <= a and b <= word.end and (is_late or not declared):
                    changed = text[word.start:a] + by + text[b:word.end]
                    call = "late_number" if is_late else "number"
                    return [Wrap(word.start, word.end, f"::tumble_mutants::{call}({number}, ", f", {changed})")], is_late
    return [], False


def without_blanks(text, start, end, replacement):
    while start < end and text[start].isspace():
        start += 1
    while start < end and text[end - 1].isspace():
        end -= 1
    return start, end, replacement.strip()


def narrowed(text, start, end, replacement):
    """The same change of a shorter range: without what begins and ends both the old text and the new."""
    while start < end and replacement and text[start] == replacement[0]:
        start, replacement = start + 1, replacement[1:]
    while start < end and replacement and text[end - 1] == replacement[-1]:
        end, replacement = end - 1, replacement[:-1]
    return start, end, replacement


def every(words):
    for word in words:
        yield word
        yield from every(word.inside)


def statements_around(found, start, end):
    """The range of the fewest statements that hold the change."""
    found = [statement for statement in found if statement]
    touched = [statement for statement in found if statement.start < max(end, start + 1) and start < statement.end]
    if not touched or start < touched[0].start or end > touched[-1].end:
        return None
    if len(touched) == 1:
        narrower = statements_around(touched[0].inner, start, end)
        if narrower:
            return narrower
    if any(statement.kind == "declaration" for statement in touched):  # what follows uses what is declared
        return touched[0].start, found[-1].end
    return touched[0].start, touched[-1].end


def as_if(text, first, last, start, end, replacement, number):
    changed = re.sub(r"//[^\n]*", "", text[first:start] + replacement + text[end:last])
    changed = " ".join(changed.split("\n"))
    return Wrap(first, last, f"{{ if (::tumble_mutants::chosen({number})) {{ {changed} }} else {{ ", " } }")
