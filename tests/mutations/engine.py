"""Compiles a chapter's checks once with all mutants in them, and runs each.

Everything is kept in BUILD/mutants/CHAPTER, so that what has not changed is not compiled again: the switched headers, the
objects, the programs `checks` and `checks_in_float`, and what their runs said: ran.tsv, slow.tsv of the mutants that needed the
slow checks too, and float.tsv. TUMBLE_MUTANT=17 checks runs one mutant as doctest would."""
import hashlib
import os
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import switches
from build_folder import headers_of, include_folders, launcher_of

here = Path(__file__).resolve().parent
precompiled = ["doctest/doctest.h", "Eigen/Core", "Eigen/Geometry", "Eigen/Eigenvalues", "string", "vector", "array",
               "random"]
# What a mutation leaves unused is no error, nor a number that is no constant any more where it is narrowed. An index out of
# bounds ends the program, as it does in the checks that the sanitizers see.
flags = ["-w", "-Wno-narrowing", "-fmax-errors=0", "-D_GLIBCXX_ASSERTIONS"]
part = "\x1f"  # between the name of a place and what tells its changes from one another; neither holds one

# At first the checks run in double, and the slowest of them are left out.
longest = 1.0  # s of a processor, which the checks that are run on a mutant take without it
most = 1 << 17  # numbers of mutants, as in mutants.hpp


class EngineError(Exception):
    """Something that is no mutant's fault; the sentence says what."""


def digest(*parts):
    return hashlib.sha256("\0".join(map(str, parts)).encode()).hexdigest()


def run(command, folder=None):
    """In complaints ccache leaves whole paths, by which the place is found."""
    return subprocess.run([str(word) for word in command], cwd=folder, env={**os.environ, "CCACHE_ABSSTDERR": "yes"}, text=True,
                          errors="replace", capture_output=True)


def object_of(file, precision):
    return f"{file.stem}.{precision}.o"


def program_of(precision):
    return "checks_in_float" if precision == "float" else "checks"


def plain_words(words):
    """A compiler's command without the course's precompiled header, which knows no switches."""
    kept, words = [], iter(words)
    for word in words:
        if word == "-include":
            next(words)
        elif word not in ("-Winvalid-pch", "-Werror"):
            kept.append(word)
    return kept


class Engine:
    def __init__(self, build, jobs, say):
        self.build, self.jobs, self.say = build, jobs, say
        self.folder = build.folder / "mutants"
        self.folder.mkdir(exist_ok=True)
        self.columns = []
        self.launcher = launcher_of(build.folder)
        # Places that can't be switched, in whatever chapter that was found. The list in the tree, a copy of one that a whole run
        # wrote, spares another machine the search.
        self.refused = {line for file in (here / "not_switched.txt", self.folder / "not_switched.txt") if file.exists()
                        for line in file.read_text().splitlines()}
        self.make_headers()

    # --- What is compiled once -----------------------------------------------------------------------------------------

    def make_headers(self):
        """The precompiled header, with the switches in it, and the objects that run the mutants and choose one."""
        words = [word for word in plain_words(self.build.main_words) if not word.startswith("-I")]
        version = run([words[0], "--version"]).stdout
        self.columns = ["-fdiagnostics-column-unit=byte"] if "Free Software" in version else []
        switch_text = (here / "mutants.hpp").read_text().replace("#pragma once", "")
        text = "".join(f"#include <{name}>\n" for name in precompiled) + switch_text
        self.header = self.folder / "all.hpp"
        self.key = digest(text, version, words, flags)
        if self.is_new("all", self.key):
            self.header.write_text(text)
            self.must(run([*self.launcher, *words, *flags, "-x", "c++-header", self.header, "-o", f"{self.header}.gch"]))
            self.note("all", self.key)
        for name in "main", "switch":
            file = here / f"mutants_{name}.cpp"
            key = digest(self.key, file.read_text())
            if self.is_new(name, key):
                self.must(run([*self.launcher, *words, "-O1", "-w", f"-I{here}", "-c", file, "-o", self.folder / f"{name}.o"]))
                self.note(name, key)

    def is_new(self, name, key):
        stamp = self.folder / f"{name}.key"
        return not stamp.exists() or stamp.read_text() != key

    def note(self, name, key):
        (self.folder / f"{name}.key").write_text(key)

    def must(self, done):
        if done.returncode:
            raise EngineError(done.stderr[:2000])

    def command(self, words, folder, header):
        """The compiler's command of a file, with the changed copies in `folder` before all others. `header` has the switches."""
        return [words[0], f"-I{folder}", *plain_words(words)[1:], "-include", header, "-Og", "-UNDEBUG", "-g0", *flags,
                *self.columns]

    # --- A chapter -----------------------------------------------------------------------------------------------------

    def chapter(self, chapter, mutants, late):
        """(end, check) by number for those of the mutants that can be switched; ends are those of mutants_main.cpp. `late`:
        the edits of each header, by path, without which its tables can't be switched."""
        folder = self.folder / chapter
        folder.mkdir(exist_ok=True)
        switched = [mutant for mutant in mutants if mutant.edits]
        if switched and max(mutant.number for mutant in switched) >= most:
            raise EngineError(f"{chapter}: a mutant's number is beyond the {most} that mutants.hpp has room for")
        active = self.make_program(chapter, folder, switched, late, "double")
        ends = self.run_mutants(chapter, folder, active, longest)
        left = [mutant for mutant in active if not mutant.proof and ends[mutant.number][0] == "survived"]
        ends |= self.run_mutants(chapter, folder, left, float("inf"), "slow")
        # What somebody thought out has its turn in float too, in a program of its own.
        left = [mutant for mutant in active
                if mutant.listed and not mutant.proof and ends[mutant.number][0] in ("survived", "unreached")]
        left = self.make_program(chapter, folder, left, late, "float")
        in_float = self.run_mutants(chapter, folder, left, float("inf"), "float")
        return ends | {number: end for number, end in in_float.items() if end[0] != "unreached"}

    def make_program(self, chapter, folder, mutants, late, precision):
        """Compiles the checks with all of the mutants that can be switched, and gives these."""
        while True:
            active = [mutant for mutant in mutants if self.site(mutant) not in self.refused]
            if not active:
                return []
            written = self.write_headers(folder, active, late)
            failed = self.compile(chapter, folder, written, active, precision)
            if not failed:
                return active
            found = self.sites_to_blame(failed.values(), folder, written) - self.refused
            if not found:
                for file, stderr in failed.items():
                    left = [mutant for mutant in active if self.site(mutant) not in found]
                    found |= self.search_culprit(folder, left, late, file, stderr, precision)
            self.say(f"{chapter}: {len(found)} places can't be switched")
            self.refused |= found
            (self.folder / "not_switched.txt").write_text("".join(f"{line}\n" for line in sorted(self.refused)))

    def search_culprit(self, folder, active, late, file, stderr, precision):
        """The place that a compiler's complaint doesn't name, as where it crashes: the first in a row of which the places up to
        it make it complain, and those before it don't. None if it complains no more, as where memory had run out."""
        sites = sorted({self.site(mutant) for mutant in active if mutant.path in self.sources[file][1]})

        def complaint(count):
            some = [mutant for mutant in active if self.site(mutant) in sites[:count]]
            return self.compile_file(folder, self.write_headers(folder, some, late), file, precision)

        error = next((line for line in stderr.splitlines() if "error" in line), stderr[:200])
        self.say(f"{folder.name}: which of {len(sites)} places stops the compiler in {file.name} is searched: {error}")
        if complaint(0):
            raise EngineError(f"{folder.name}: {file.name} does not compile, and not without mutants either: {error}")
        if not complaint(len(sites)):
            return set()
        holds, fails = 0, len(sites)
        while fails - holds > 1:
            middle = (holds + fails) // 2
            holds, fails = (holds, middle) if complaint(middle) else (middle, fails)
        self.say(f"{folder.name}: what stops the compiler in {file.name} is {sites[fails - 1]}")
        return {sites[fails - 1]}

    def site(self, mutant):
        """What a place is called in the list of those that can't be switched: that outlives a change somewhere else."""
        return f"{mutant.header} {mutant.site_text}"

    def write_headers(self, folder, active, late):
        by_path = {}
        if any(mutant.is_late for mutant in active):  # tables lean on tables
            by_path = {path: {"": edits} for path, edits in late.items() if edits}
        for mutant in active:
            by_path.setdefault(mutant.path, {}).setdefault(self.site(mutant) + f"{part}{mutant.site}", mutant.edits)
        names = {mutant.path: mutant.header for mutant in active}
        written = {}
        for path, sites in by_path.items():
            name = names.get(path, f"tumble/{path.name}")
            written[name] = switches.switched(path.read_text(), list(sites.items()))
        for old in folder.rglob("*.hpp"):
            if str(old.relative_to(folder)) not in written:
                old.unlink()
        for name, header in written.items():
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_text() != header.text:
                target.write_text(header.text)
        return written

    def compile(self, chapter, folder, written, active, precision):
        """Makes the program of the files that include a header with a mutant in it; gives the compiler's complaints by file."""
        mutated, others, self.sources = {mutant.path for mutant in active}, self.build.others.get(chapter, {}), {}
        for source in [*self.build.checks(chapter).values(), *others.values()]:
            headers = headers_of(source[2], include_folders(source[1]))
            if headers & mutated or (source[2].stem in others and not source[0].exists()):
                self.sources[source[2]] = source, headers
        begun, failed, count = time.time(), {}, len(self.sources)
        self.say(f"{chapter}: {count} files are compiled in {precision} with {len(active)} mutants")
        with ThreadPoolExecutor(self.jobs) as pool:
            files = {pool.submit(self.compile_file, folder, written, file, precision): file for file in self.sources}
            for number, done in enumerate(as_completed(files), 1):
                if done.result():
                    failed[files[done]] = done.result()
                self.say(f"{chapter}: {number} of {count} files compiled in {time.time() - begun:.0f} s")
        if not failed:
            objects = [folder / object_of(file, precision) for file in self.sources]
            objects += [made for made, _, file in others.values() if file not in self.sources]
            objects += [self.folder / "main.o", self.folder / "switch.o", "-pthread"]
            self.must(run([self.build.main_words[0], *objects, "-o", folder / program_of(precision)]))
        return failed

    def compile_file(self, folder, written, file, precision):
        """What the compiler complains of."""
        (directory, words, _), included = self.sources[file]
        target = folder / object_of(file, precision)
        stamp = target.with_suffix(".key")
        command = [*self.command(words, folder, self.header), f"-DTUMBLE_ONE_PRECISION={precision}"]
        seen = {path.name for path in included}
        texts = sorted((name, header.text) for name, header in written.items() if Path(name).name in seen)
        key = digest(texts, self.key, command, *(path.read_text() for path in [file, *sorted(included)]))
        if target.exists() and stamp.exists() and stamp.read_text() == key:
            return ""
        done = run([*self.launcher, *command, "-c", file, "-o", target], directory if Path(directory).is_dir() else None)
        if done.returncode:
            return done.stderr or f"the compiler ended with {done.returncode}"
        stamp.write_text(key)
        return ""

    def sites_to_blame(self, stderrs, folder, written):
        """For each error the innermost place of its chain of instantiations that is in a switched header."""
        found = set()
        for stderr in stderrs:
            for block in switches.complaints(stderr, folder):
                for name, line, column in block:
                    keys = switches.blamed(written[name], line, column) if name in written else set()
                    if keys:
                        found |= {key.split(part)[0] for key in keys if key}
                        break
        return found

    def run_mutants(self, chapter, folder, active, longest, name="ran"):
        if not active:
            return {}
        self.say(f"{chapter}: {len(active)} mutants are run ({name}.tsv)")
        (folder / "wanted.txt").write_text("\n".join(str(mutant.number) for mutant in active))
        begun = time.time()
        program = program_of("float" if name == "float" else "double")
        command = [str(word) for word in (folder / program, folder / "wanted.txt", self.jobs, longest)]
        with (folder / f"{name}.tsv").open("w") as output:
            ran = subprocess.run(command, cwd=folder, stdout=output, stderr=subprocess.PIPE, text=True, errors="replace")
        if ran.returncode:
            raise EngineError(f"{chapter}: the program of all mutants ended with {ran.returncode}: {ran.stderr[:1000]}")
        ends, red = {}, []
        for row in (folder / f"{name}.tsv").read_text(errors="replace").splitlines():
            number, end, check = row.split("\t")
            if number != "0":
                ends[int(number)] = end, check.replace("_checks.cpp: ", ": ", 1)
            elif end != "holds":
                red.append(check)
        if red:
            raise EngineError(f"{chapter}: without any mutant these checks fail: {'; '.join(red)}")
        self.say(f"{chapter}: {len(active)} mutants run in {time.time() - begun:.0f} s")
        return ends
