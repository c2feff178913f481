#!/usr/bin/env python3
"""Changes the headers in thousands of places, one at a time, and sees whether a check turns red.

    mutations.py BUILD_FOLDER                 all that the generator makes of the library's headers, and all lists beside
                                              this file; ./course test --exhaustive calls it
    mutations.py BUILD_FOLDER --changed       those of headers that have changed since that last held (since.py), and lists
                                              that have; where nobody knows what has, those of the first three chapters
    mutations.py BUILD_FOLDER --chapters 03_inertia,04_quaternions    those of these chapters alone; common and exact stand
                                              for the headers in common/tumble and exact
    mutations.py BUILD_FOLDER LIST...         the mutations of these lists, as mutation_list.py describes them

All mutants of a chapter's headers are compiled together, with the chapter's checks, and chosen when those run (engine.py): in
double, those of lists that survive in float too. What can't be chosen so is compiled alone (alone.py). What the checks of a
chapter don't see is tried on those of later chapters that are tried, and of the tools that stand on them. A check that crashes
or computes 20 times as long as it should has seen the mutant.

Prints what became of each mutation of a list and which generated mutants survive; BUILD_FOLDER/mutants/all.tsv tells of all. The
exit code is 0 if nothing is wrong. Wrong is a mutation of a list that survives and is not called equivalent there, or does not
compile; whatever is called equivalent (for generated ones: in the lists of equal/) and is seen; whatever could not be tried;
and if of the generated ones more than ten, and more than 5 of 100, are neither caught nor listed as equal."""
import argparse
import sys
import time
from dataclasses import dataclass, field
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is written beside the sources
import alone
import by_hand
from build_folder import Build
from engine import Engine, EngineError
from equal_list import lines_of, names_of, read_equal
from generator import Generator
from mutation_list import ListError, read_list
from since import changed_since_held

here = Path(__file__).resolve().parent
root = here.parent.parent
jobs = 2  # at a time
caught_ends = {"killed", "crashed", "endless"}
most_that_survive, few = 0.05, 10  # of the generated ones: a share, and how many may even where the headers are few
most_in_list, most_in_chapter = 500, 6000  # mutations, and numbers of mutants


@dataclass
class Mutant:
    """A change of a header, from a list or from the generator, and what became of it."""
    chapter: str  # whose checks must see it
    header: str
    path: Path
    start: int
    end: int
    replacement: str
    number: int = 0
    edits: list = field(default_factory=list)
    site: str = ""
    site_text: str = ""
    is_late: bool = False
    may_be_constant: bool = False
    kind: str = ""
    listed: object = None  # the Mutation of a list
    proof: str = ""
    result: str = ""
    check: str = ""

    def text(self):
        text = self.path.read_text()
        return text[:self.start] + self.replacement + text[self.end:]

    def lines(self):
        return lines_of(self.path.read_text(), self.start, self.end, self.replacement)

    def names(self):
        """Those by which a list of equal mutants may know it."""
        return [(self.header, *name) for name in names_of(self.kind, self.path.read_text(), self.start, self.end, self.replacement)]

    def __str__(self):
        if self.listed:
            return str(self.listed)
        line = self.path.read_text().count("\n", 0, self.start) + 1
        return f"{self.header}:{line}: {self.kind}: " + "  becomes  ".join(self.lines())


def say(sentence):
    print(sentence, flush=True)


def from_lists(paths, build):
    """The mutants of lists."""
    made = []
    for path in paths:
        for mutation in read_list(path):
            header = build.header(mutation.chapter, mutation.header)
            if header is None:
                raise ListError(f"{mutation}: no such header is in reach of this chapter")
            text = header.read_text()
            mutation.apply(text)  # or refuse
            alone.checks_that_see(mutation, build)
            start = text.index(mutation.original)
            number = first_number(mutation.chapter, build) + sum(mutant.chapter == mutation.chapter for mutant in made)
            edits, is_late = by_hand.edits_of(text, start, start + len(mutation.original), mutation.replacement, number)
            made.append(Mutant(mutation.chapter, mutation.header, header, start, start + len(mutation.original),
                               mutation.replacement, number, edits, f"by hand {number}", mutation.breaks, is_late,
                               listed=mutation, proof=mutation.proof))
    return made


def first_number(chapter, build):
    """A chapter's mutants have numbers of their own, so that a change in one recompiles no other."""
    known = ["common", *build.chapters(), "exact", "scene_reader"]
    return 1 + most_in_chapter * [*known, *sorted(set(build.commands) - set(known))].index(chapter)


def generated(chapters, build, equal):
    """The mutants of the headers of `chapters` and the edits of late tables by header."""
    made, late = [], {}
    for chapter in chapters:
        number = first_number(chapter, build) + most_in_list
        folder = root / {"common": "common", "exact": "exact"}.get(chapter, f"chapters/{chapter}")
        inside = "tumble/exact" if chapter == "exact" else "tumble"
        for path in sorted((folder / inside).glob("*.hpp")):
            name, text = f"{inside}/{path.name}", path.read_text()
            generator = Generator(name, text, number)
            found = generator.everything()
            number = generator.next
            late[path] = generator.late_edits
            sites = {}
            for one in found:
                sites.setdefault(one.site, one)
            for one in found:
                first = sites[one.site]
                line = text[text.rfind("\n", 0, first.start) + 1:text.find("\n", first.start)]
                site_text = " ".join(f"{first.kind}: {text[first.start:first.end]} in {line}".split())
                made.append(Mutant(chapter, name, path, one.start, one.end, one.replacement, one.number, one.edits,
                                   f"{name} {one.site}", site_text, one.is_late, one.may_be_constant, one.kind))
                made[-1].proof = next((equal[name] for name in made[-1].names() if name in equal), "")
    return made, late


def home_of(mutant, build):
    """The chapter whose checks are compiled for a mutant alone."""
    if mutant.chapter != "common":
        return mutant.chapter
    name = Path(mutant.header).stem
    return next((chapter for chapter in build.chapters() if name in build.checks(chapter)), build.chapters()[0])


def settle_alone(mutants, build):
    """Those that no switch can choose."""
    def one(mutant):
        @dataclass
        class Place:
            chapter: str
            header: str

            def __str__(self):
                return str(mutant)
        return alone.settle(Place(home_of(mutant, build), mutant.header), mutant.text(), build)

    begun, count = time.time(), len(mutants)
    if mutants:
        say(f"{count} mutants are compiled alone")
    with ThreadPoolExecutor(jobs) as pool:
        tried = {pool.submit(one, mutant): mutant for mutant in mutants}
        for number, done in enumerate(as_completed(tried), 1):
            tried[done].result, tried[done].check = done.result()
            if number % 10 == 0 or number == count:
                say(f"{number} of {count} mutants compiled alone in {time.time() - begun:.0f} s")


def is_for_the_compiler(mutant):
    """Whether no check can reach a mutant because the compiler computes what it changes."""
    return mutant.result in ("unreached", "none") and (mutant.may_be_constant or mutant.listed is not None)


def try_all(by_lists, made, late, build):
    """Gives what could not be tried."""
    engine = Engine(build, jobs, say)
    chapters = [name for name in [*build.rooms(), "exact"] if name in build.commands]
    # Those of common have no checks of their own: they are tried at home, and on what is tried besides.
    tried = {mutant.chapter for mutant in [*by_lists, *made]} | {home_of(m, build) for m in made if m.chapter == "common"}
    unseen = []
    for chapter in chapters:
        mine = [m for m in by_lists if m.chapter == chapter]
        if chapter in tried:
            mine += [m for m in made if m.chapter == chapter or (chapter != "exact" and m.chapter != "exact" and
                m.result in ("", "survived", "unreached") and not (m.proof and m.result == "survived") and
                not is_for_the_compiler(m) and (m.chapter == "common" or m.chapter < chapter))]
        if not any(m.edits for m in mine):
            continue
        try:
            ends = engine.chapter(chapter, mine, late)
        except EngineError as error:
            unseen.append(f"{error}\n{chapter}: its mutants were not tried")
            for mutant in mine:
                mutant.result = mutant.result or "not tried"
            continue
        for mutant in mine:
            end, check = ends.get(mutant.number, ("", ""))
            if end and not (end == "unreached" and mutant.result) and not (end == "none" and mutant.result == "survived"):
                mutant.result, mutant.check = end, f"{chapter} {check}"
    settle_alone([m for m in [*by_lists, *made] if is_for_the_compiler(m) or not m.result], build)
    return unseen


def tell_of_lists(mutants):
    """Prints what became of each; gives what is wrong."""
    wrong = []
    for mutant in (mutant for mutant in mutants if mutant.result != "not tried"):
        seen = mutant.result in caught_ends
        check = mutant.check.removeprefix(f"{mutant.chapter} ")
        end = f"killed by {check}" if seen else "does not compile: " + check if mutant.result == "no code" else (
            f"survived; {mutant.proof}" if mutant.proof else "survived")
        say(f"{mutant} -- {end}")
        if mutant.result == "no code":
            wrong.append(f"{mutant} -- must compile")
        elif seen and mutant.proof:
            wrong.append(f"{mutant} -- is listed as equivalent, but a check sees it")
        elif not seen and not mutant.proof:
            wrong.append(f"{mutant} -- survived: add a check, or the proof that it is equivalent")
    return wrong


def tell_of_generated(mutants, equal, path):
    """Prints the survivors and a line for each chapter; gives what is wrong."""
    if not mutants:
        return []
    path.write_text("".join("\t".join([str(m.number), m.header, m.kind, m.result, m.check, str(m)]) + "\n" for m in mutants))
    real = [m for m in mutants if m.result not in ("none", "no code", "not tried")]
    wrong = [f"{m} -- is listed as equal, but seen: {m.check}" for m in real if m.proof and m.result in caught_ends]
    for mutant in real:
        if mutant.result not in caught_ends and not mutant.proof:
            say(f"survivor, {mutant.result}: {mutant}")
    used = {name for m in mutants for name in m.names()}
    headers = {m.header for m in mutants}
    wrong += [f"{header}: the lists of equal mutants name one that is not made: {old}  becomes  {new}"
              for header, old, new in equal if header in headers and (header, old, new) not in used]
    nowhere = sum(m.result in ("none", "no code") for m in mutants)
    say(f"{len(mutants)} generated, of which {nowhere} compile nowhere")
    for chapter in [*dict.fromkeys(m.chapter for m in mutants), "all"]:
        own = [m for m in real if chapter in (m.chapter, "all")]
        ends = [m.result if m.result in caught_ends else "equal" if m.proof else "survived" for m in own]
        survive = ends.count("survived")
        say(f"{chapter}: {len(own)} mutants, {ends.count('killed')} killed, {ends.count('crashed')} crashed, "
            f"{ends.count('endless')} endless, {ends.count('equal')} equal, {survive} survive")
    if survive > max(few, most_that_survive * len(real)):
        wrong.append(f"of the generated mutants more than {most_that_survive:.0%} survive and are not listed as equal")
    return wrong


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build")
    parser.add_argument("lists", nargs="*")
    parser.add_argument("--chapters", default="")
    parser.add_argument("--changed", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    global jobs
    jobs = options.jobs
    try:
        build = Build(options.build)
        every = ["common", *(name for name in [*build.rooms(), "exact"] if name in build.commands)]
        changed = changed_since_held(root) if options.changed else None
        wanted = options.chapters.split(",") if options.chapters else every
        if options.changed and changed is None:
            wanted = build.chapters()[:3]
            say(f"what has changed is not known, so these are tried: {', '.join(wanted)}")
        paths = options.lists or [path for path in sorted(here.glob("*.txt")) if path.stem in build.commands and path.stem in wanted]
        by_lists = from_lists(paths, build)
        equal = read_equal(sorted((here / "equal").glob("*.txt")))
        made, late = ([], {}) if options.lists else generated([name for name in every if name in wanted], build, equal)
        if changed is not None:
            by_lists = [m for m in by_lists if m.path in changed or here / f"{m.chapter}.txt" in changed]
            made = [m for m in made if m.path in changed]
            say(f"{len({m.path for m in [*by_lists, *made]})} headers have changed or are named by a list that has")
        if len({m.number for m in [*by_lists, *made]}) < len(by_lists) + len(made):
            raise ListError("two mutants have the same number, so most_in_list or most_in_chapter is too small")
        wrong = try_all(by_lists, made, late, build) if by_lists or made else []
    except (ListError, EngineError, OSError) as error:
        sys.exit(f"mutations: {error}")
    wrong += tell_of_lists(by_lists)
    wrong += tell_of_generated(made, equal, build.folder / "mutants" / "all.tsv")
    say(f"\n{len(by_lists)} mutations, {len(made)} generated mutants, {len(wrong)} wrong{':' if wrong else '.'}")
    print(*wrong, sep="\n")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
