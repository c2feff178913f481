"""Compiles a chapter's checks once with all mutants in them, and runs each.

Everything is kept in BUILD/mutants/CHAPTER, so that what has not changed is not compiled again: the switched headers, the
objects, the program `checks`, and what its runs said: ran.tsv, and slow.tsv of the mutants that needed the slow checks too.
TUMBLE_MUTANT=17 checks runs one mutant as doctest would."""
import hashlib
import json
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import switches
from build_folder import headers_of, include_folders

here = Path(__file__).parent
precompiled = ["doctest/doctest.h", "Eigen/Core", "Eigen/Geometry", "Eigen/Eigenvalues", "string", "vector", "array",
               "random"]
# What a mutation leaves unused is no error, nor a number that is no constant any more where it is narrowed. An index out of
# bounds ends the program, as it does in the checks that the sanitizers see.
flags = ["-w", "-Wno-narrowing", "-fmax-errors=0", "-D_GLIBCXX_ASSERTIONS"]
part = "\x1f"  # between the name of a place and what tells its changes from one another; neither holds one

# The checks run in one precision, and the slowest of them are left out. A run that is patient leaves out nothing.
longest = 1.0  # s of a processor, which the checks that are run on a mutant take without it
most = 1 << 16  # numbers of mutants, as in mutants.hpp


class EngineError(Exception):
    """Something that is no mutant's fault; the sentence says what."""


def digest(*parts):
    return hashlib.sha256("\0".join(map(str, parts)).encode()).hexdigest()


def run(command, folder=None):
    return subprocess.run([str(word) for word in command], cwd=folder, text=True, errors="replace", capture_output=True)


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
    def __init__(self, build, jobs, patient, thorough, say):
        self.build, self.jobs, self.thorough, self.say = build, jobs, thorough, say
        self.longest = float("inf") if patient else longest
        self.precision = [] if patient else ["-DTUMBLE_ONE_PRECISION=double"]
        self.folder = build.folder / "mutants"
        self.folder.mkdir(exist_ok=True)
        self.columns = []
        self.make_headers()

    # --- What is compiled once -----------------------------------------------------------------------------------------

    def make_headers(self):
        """The precompiled header, with the switches in it, and the object that runs the mutants."""
        words = [word for word in plain_words(self.build.main_words) if not word.startswith("-I")]
        version = run([words[0], "--version"]).stdout
        self.columns = ["-fdiagnostics-column-unit=byte"] if "Free Software" in version else []
        switch_text = (here / "mutants.hpp").read_text().replace("#pragma once", "")
        text = "".join(f"#include <{name}>\n" for name in precompiled) + switch_text
        self.header, main = self.folder / "all.hpp", here / "mutants_main.cpp"
        self.key = digest(text, version, words, flags)
        if self.is_new("all", self.key):
            self.header.write_text(text)
            self.must(run([*words, *flags, "-x", "c++-header", self.header, "-o", f"{self.header}.gch"]))
            self.note("all", self.key)
        key = digest(self.key, main.read_text())
        if self.is_new("main", key):
            self.must(run([*words, "-O1", "-w", f"-I{here}", "-c", main, "-o", self.folder / "main.o"]))
            self.note("main", key)

    def is_new(self, name, key):
        stamp = self.folder / f"{name}.key"
        return not stamp.exists() or stamp.read_text() != key

    def note(self, name, key):
        (self.folder / f"{name}.key").write_text(key)

    def must(self, done):
        if done.returncode:
            raise EngineError(done.stderr[:2000])

    # --- A chapter -----------------------------------------------------------------------------------------------------

    def chapter(self, chapter, mutants, late):
        """(end, check) by number for those of the mutants that can be switched; ends are those of mutants_main.cpp. `late`:
        the edits of each header, by path, without which its tables can't be switched."""
        folder = self.folder / chapter
        folder.mkdir(exist_ok=True)
        switched = [mutant for mutant in mutants if mutant.edits]
        if switched and max(mutant.number for mutant in switched) >= most:
            raise EngineError(f"{chapter}: a mutant's number is beyond the {most} that mutants.hpp has room for")
        refused = self.read_refused(folder)
        while True:
            active = [mutant for mutant in switched if self.site(mutant) not in refused]
            written = self.write_headers(folder, active, late)
            stderrs = self.compile(chapter, folder, written, {mutant.path for mutant in active})
            if not stderrs:
                break
            found = self.sites_to_blame(stderrs, folder, written) - refused
            if not found:
                errors = [line for line in stderrs[0].splitlines() if "error" in line]
                raise EngineError("\n".join([f"{chapter} does not compile with its mutants:", *errors])[:2000])
            self.say(f"{chapter}: {len(found)} places can't be switched")
            refused |= found
            (folder / "refused.json").write_text(json.dumps(sorted(refused)))
        ends = self.run_mutants(chapter, folder, active, self.longest)
        # What somebody thought out is not given up for the sake of time, nor a survivor of a run that will be quoted, which
        # must not depend on which checks were slow that day.
        left = [mutant for mutant in active
                if (mutant.listed or self.thorough) and ends.get(mutant.number, ("",))[0] == "survived"]
        return {**ends, **self.run_mutants(chapter, folder, left, float("inf"), "slow")} if left else ends

    def site(self, mutant):
        """What a place is called in the list of those that can't be switched: that outlives a change somewhere else."""
        return f"{mutant.header} {mutant.site_text}"

    def read_refused(self, folder):
        path = folder / "refused.json"
        return set(json.loads(path.read_text())) if path.exists() else set()

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

    def compile(self, chapter, folder, written, mutated):
        """Makes the program of the files that include a header with a mutant in it; gives what the compiler complained of."""
        included = {}
        for source in [*self.build.checks(chapter).values(), *self.build.others.get(chapter, {}).values()]:
            headers = headers_of(source[2], include_folders(source[1]))
            if headers & mutated:
                included[source[2]] = source, sorted(headers)
        sources = [source for source, _ in included.values()]
        begun = time.time()

        def one(source):
            directory, words, file = source
            target, stamp = folder / f"{file.stem}.o", folder / f"{file.stem}.key"
            command = [words[0], f"-I{folder}", *plain_words(words)[1:], "-include", self.header, "-Og", "-UNDEBUG", "-g0",
                       *flags, *self.columns, *self.precision]
            seen = {path.name for path in included[file][1]}
            texts = sorted((name, header.text) for name, header in written.items() if Path(name).name in seen)
            key = digest(texts, self.key, command, *(path.read_text() for path in [file, *included[file][1]]))
            if target.exists() and stamp.exists() and stamp.read_text() == key:
                return ""
            done = run([*command, "-c", file, "-o", target], directory if Path(directory).is_dir() else None)
            if done.returncode:
                return done.stderr
            stamp.write_text(key)
            return ""

        with ThreadPoolExecutor(self.jobs) as pool:
            stderrs = [stderr for stderr in pool.map(one, sources) if stderr]
        if not stderrs:
            objects = [folder / f"{file.stem}.o" for _, _, file in sources]
            self.must(run([sources[0][1][0], *objects, self.folder / "main.o", "-pthread", "-o", folder / "checks"]))
        self.say(f"{chapter}: {len(sources)} files compiled in {time.time() - begun:.0f} s")
        return stderrs

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
        (folder / "wanted.txt").write_text("\n".join(str(mutant.number) for mutant in active))
        begun = time.time()
        command = [str(word) for word in (folder / "checks", folder / "wanted.txt", self.jobs, longest)]
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
