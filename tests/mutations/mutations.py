#!/usr/bin/env python3
"""Changes the headers in thousands of places, one at a time, and sees whether a check turns red.

    mutations.py BUILD_FOLDER                 all that the generator makes of the library's headers, and all lists beside
                                              this file
    mutations.py BUILD_FOLDER --write         the same, shows survivors the slow checks too, and writes what came of it into
                                              caught.tsv, which the book shows
    mutations.py BUILD_FOLDER --chapters 03_inertia,04_quaternions    those of these chapters alone; common and exact stand
                                              for the headers in common/tumble and exact
    mutations.py BUILD_FOLDER --generated 01_force    all lists, and the generated mutants of these chapters
    mutations.py BUILD_FOLDER --patient       leaves nothing out: neither float, nor the slowest of the checks that reach a
                                              mutant, nor what must be compiled alone; it takes much longer
    mutations.py BUILD_FOLDER LIST...         the mutations of these lists, as mutation_list.py describes them

All mutants of a chapter's headers are compiled together, with the chapter's checks, and chosen when those run (engine.py); what
can't be chosen so is compiled alone (alone.py). What the checks of a chapter don't see is tried on those of later chapters and
of the tools that stand on them. A check that crashes or computes 20 times as long as it should has seen the mutant.

Prints what became of each mutation of a list and which generated mutants survive; BUILD_FOLDER/mutants/all.tsv tells of all. The
exit code is 0 if nothing is wrong. Wrong is a mutation of a list that survives and is not called equivalent there, or does not
compile; whatever is called equivalent (for generated ones: in the lists of equal/) and is seen; and if of the generated ones
fewer than 95 of 100 are either caught or listed as equal."""
import argparse
import datetime
import random
import sys
import time
from dataclasses import dataclass, field
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is written beside the sources
import alone
import by_hand
from build_folder import Build
from engine import Engine, EngineError
from equal_list import lines_of, read_equal
from generator import Generator
from mutation_list import ListError, read_list

here = Path(__file__).parent
root = here.parent.parent
jobs = 2  # at a time
caught_ends = {"killed", "crashed", "endless"}
wanted_share = 0.95
# What can't be switched is compiled alone; of the generated ones a sample, unless the run is patient.
sample, seed = 24, 20261122
most_in_list = 500  # mutations


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
    seen_by: str = ""
    proof: str = ""
    result: str = ""
    check: str = ""

    def text(self):
        text = self.path.read_text()
        return text[:self.start] + self.replacement + text[self.end:]

    def lines(self):
        return lines_of(self.path.read_text(), self.start, self.end, self.replacement)

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
                               listed=mutation, seen_by=mutation.seen_by, proof=mutation.proof))
    return made


def first_number(chapter, build):
    """A chapter's mutants have numbers of their own, so that a change in one recompiles no other."""
    known = ["common", *build.chapters(), "exact", "scene_reader"]
    return 1 + 4000 * [*known, *sorted(set(build.commands) - set(known))].index(chapter)


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
                site_text = f"{first.kind}: {text[first.start:first.end]} at {text.count(chr(10), 0, first.start) + 1}"
                made.append(Mutant(chapter, name, path, one.start, one.end, one.replacement, one.number, one.edits,
                                   f"{name} {one.site}", site_text, one.is_late, one.may_be_constant, one.kind))
                made[-1].proof = equal.get((name, *made[-1].lines()), "")
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
            seen_by: str

            def __str__(self):
                return str(mutant)
        return alone.settle(Place(home_of(mutant, build), mutant.header, mutant.seen_by), mutant.text(), build)

    with ThreadPoolExecutor(jobs) as pool:
        for mutant, (end, check) in zip(mutants, pool.map(one, mutants)):
            mutant.result, mutant.check = end, check


def is_for_the_compiler(mutant):
    """Whether no check can reach a mutant because the compiler computes what it changes."""
    return mutant.result in ("unreached", "none") and (mutant.may_be_constant or mutant.listed is not None)


def try_all(by_lists, made, late, build, patient, thorough, sample):
    engine = Engine(build, jobs, patient, thorough, say)
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
            say(f"{error}\n{chapter}: its list is tried one by one, and nothing else")
            unseen.append(f"{chapter}: its generated mutants were not tried")
            for mutant in made:
                mutant.result = mutant.result or ("not tried" if mutant.chapter == chapter else "")
            continue
        for mutant in mine:
            end, check = ends.get(mutant.number, ("", ""))
            if end and not (end == "unreached" and mutant.result) and not (end == "none" and mutant.result == "survived"):
                mutant.result, mutant.check = end, f"{chapter} {check}"
    # A mutation of a list that double does not see is compiled alone, where float has its turn.
    left = [m for m in [*by_lists, *made]
            if is_for_the_compiler(m) or not m.result or (m.listed and m.result == "survived" and not m.proof)]
    slow = [m for m in left if not m.listed]
    spared = set() if patient else {m.number for m in slow} - {m.number for m in random.Random(seed).sample(slow, min(len(slow), sample))}
    left = [m for m in left if m.number not in spared]
    for mutant in slow:
        if mutant.number in spared:
            mutant.result = "not tried"
    begun = time.time()
    settle_alone(left, build)
    say(f"{len(left)} mutants compiled alone in {time.time() - begun:.0f} s; {len(spared)} more were not tried")
    return unseen if made else []


def tell_of_lists(mutants):
    """Prints what became of each; gives what is wrong."""
    wrong = []
    for mutant in mutants:
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
    """Prints the survivors; gives what is wrong, and a row for each chapter: (chapter, generated, caught, crashed or endless,
    equal, survivors)."""
    if not mutants:
        return [], []
    path.write_text("".join("\t".join([str(m.number), m.header, m.kind, m.result, m.check, str(m)]) + "\n" for m in mutants))
    real = [m for m in mutants if m.result not in ("none", "no code", "not tried")]
    wrong = [f"{m} -- is listed as equal, but seen: {m.check}" for m in real if m.proof and m.result in caught_ends]
    rows = []
    for chapter in [*dict.fromkeys(m.chapter for m in mutants), "all"]:
        own = [m for m in real if chapter in (m.chapter, "all")]
        caught = [m for m in own if m.result in caught_ends]
        same = [m for m in own if m.proof and m.result not in caught_ends]
        rows.append((chapter, len(own), len(caught), sum(m.result != "killed" for m in caught), len(same),
                     len(own) - len(caught) - len(same)))
    for mutant in real:
        if mutant.result not in caught_ends and not mutant.proof:
            say(f"survivor, {mutant.result}: {mutant}")
    used = {(m.header, *m.lines()) for m in mutants}
    headers = {m.header for m in mutants}
    wrong += [f"{header}: the lists of equal mutants name one that is not made: {old}  becomes  {new}"
              for header, old, new in equal if header in headers and (header, old, new) not in used]
    nowhere = sum(m.result in ("none", "no code") for m in mutants)
    say(f"{len(mutants)} generated, of which {nowhere} compile nowhere")
    for row in rows:
        say("{}: {} mutants, {} caught, of which {} by a crash or no end; {} equal, {} survive".format(*row))
    if rows[-1][5] > (1 - wanted_share) * rows[-1][1]:
        wrong.append(f"of the generated mutants fewer than {wanted_share:.0%} are caught or listed as equal")
    return wrong, rows


def write_table(rows):
    """Replaces the rows of these chapters; the last row sums all."""
    path, today = here / "caught.tsv", datetime.date.today().isoformat()
    names = ["headers of", "mutants", "caught", "by a crash or a hang", "equal", "survive", "when"]
    old = [line.split("\t") for line in path.read_text().splitlines()[1:]] if path.exists() else []
    table = {row[0]: row for row in old} | {row[0]: [*map(str, row), today] for row in rows}
    table.pop("all", None)
    chapters = sorted(table.values(), key=lambda row: (row[0] != "common", row[0]))
    sums = [str(sum(int(row[column]) for row in chapters)) for column in range(1, 6)]
    path.write_text("".join("\t".join(row) + "\n" for row in [names, *chapters, ["all", *sums, max(row[6] for row in chapters)]]))


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build")
    parser.add_argument("lists", nargs="*")
    parser.add_argument("--chapters", default="")
    parser.add_argument("--generated", default="")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--patient", action="store_true")
    parser.add_argument("--sample", type=int, default=sample)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    global jobs
    jobs = options.jobs
    try:
        build = Build(options.build)
        every = [name for name in [*build.rooms(), "exact"] if name in build.commands]
        wanted = [name for name in every if not options.chapters or name in options.chapters.split(",")]
        paths = options.lists or [path for path in sorted(here.glob("*.txt")) if path.stem in build.commands and (
            not options.chapters or path.stem in options.chapters.split(","))]
        by_lists = from_lists(paths, build)
        equal = read_equal(sorted((here / "equal").glob("*.txt")))
        if options.generated:
            wanted = [name for name in wanted if name in options.generated.split(",")]
        elif wanted == every or "common" in options.chapters.split(","):
            wanted.insert(0, "common")
        made, late = ([], {}) if options.lists else generated(wanted, build, equal)
        unseen = try_all(by_lists, made, late, build, options.patient, options.write, options.sample)
    except (ListError, EngineError, OSError) as error:
        sys.exit(f"mutations: {error}")
    wrong = unseen + tell_of_lists(by_lists)
    complaints, rows = tell_of_generated(made, equal, build.folder / "mutants" / "all.tsv")
    wrong += complaints
    if options.write:
        write_table(rows)
    say(f"\n{len(by_lists)} mutations, {len(made)} generated mutants, {len(wrong)} wrong{':' if wrong else '.'}")
    print(*wrong, sep="\n")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
