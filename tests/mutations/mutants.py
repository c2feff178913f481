#!/usr/bin/env python3
"""Changes the library's headers in thousands of places, one at a time, and sees whether a check turns red.

    mutants.py BUILD_FOLDER [--chapters 03_inertia,04_quaternions] [--report FILE]

All mutants of a chapter are compiled together and chosen when its checks run, each in a process of its own (see
mutants_main.cpp). What the checks of the chapter don't see is tried on those of later chapters."""
import argparse
import hashlib
import json
import re
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is written beside the sources
import generator
import switches

here = Path(__file__).parent
root = here.parent.parent
jobs = 2


class Failure(Exception):
    pass


class Build:
    """What a build folder knows: how each chapter's check files are compiled."""

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.commands, self.extra = {}, {}
        for entry in json.loads((self.folder / "compile_commands.json").read_text()):
            words, file = shlex.split(entry["command"]), Path(entry["file"])
            target = words.index("-o") + 1
            if file.name.endswith("_checks.cpp"):
                self.commands.setdefault(file.parent.name, {})[file] = words[:target - 1]
            elif "tumble_rungs.dir" in words[target]:
                self.extra.setdefault(file.parent.name, {})[file] = words[:target - 1]
            elif "check_main" in file.name:
                self.main_words = words[:target - 1]


def without_header(words):
    """A command without its precompiled header and without warnings."""
    kept = []
    skip = False
    for word in words:
        if skip or word in ("-include", "-Winvalid-pch", "-Werror"):
            skip = word == "-include"
            continue
        kept.append(word)
    return kept


class Work:
    def __init__(self, build, options):
        self.build, self.options = build, options
        self.scratch = build.folder / "mutants"
        self.scratch.mkdir(exist_ok=True)
        self.timings = {}

    def run(self, command, **more):
        return subprocess.run([str(word) for word in command], text=True, errors="replace", capture_output=True, **more)

    def optimisation(self):
        return self.options.optimise.split()

    def headers_ready(self):
        """The precompiled header: the course's, and the switches."""
        words = [w for w in without_header(self.build.main_words) if not w.startswith("-I")]
        folder = self.scratch / "pch"
        folder.mkdir(exist_ok=True)
        source = folder / "all.hpp"
        text = "#include <doctest/doctest.h>\n" + "".join(f"#include <{n}>\n" for n in (
            "Eigen/Core", "Eigen/Geometry", "Eigen/Eigenvalues", "string", "vector", "array", "random")) + (
            here / "mutants.hpp").read_text().replace("#pragma once", "")
        command = [*words, *self.optimisation(), "-w", "-D_GLIBCXX_ASSERTIONS"]
        key = hashlib.sha256((text + " ".join(command)).encode()).hexdigest()
        stamp = folder / "key"
        if not stamp.exists() or stamp.read_text() != key:
            source.write_text(text)
            done = self.run([*command, "-x", "c++-header", source, "-o", f"{source}.gch"])
            if done.returncode:
                raise Failure(done.stderr)
            main = self.run([*[w for w in words], "-O1", "-w", f"-I{here}", "-c", here / "mutants_main.cpp", "-o", self.scratch / "main.o"])
            if main.returncode:
                raise Failure(main.stderr)
            stamp.write_text(key)
        main = self.scratch / "main.o"
        if main.stat().st_mtime < (here / "mutants_main.cpp").stat().st_mtime:
            done = self.run([*words, "-O1", "-w", f"-I{here}", "-c", here / "mutants_main.cpp", "-o", main])
            if done.returncode:
                raise Failure(done.stderr)
        return ["-include", source, *self.optimisation(), "-w", "-Wno-narrowing", "-fpermissive", "-D_GLIBCXX_ASSERTIONS", "-fmax-errors=0",
                "-fdiagnostics-column-unit=byte"]

    def compile(self, chapter, sources, folder, key):
        """Objects by source, or the complaints."""
        flags = self.headers_ready()

        def one(item):
            file, words = item
            words = without_header(words)
            target = folder / f"{file.stem}.o"
            stamp = folder / f"{file.stem}.key"
            digest = hashlib.sha256((key + file.read_text() + " ".join(map(str, [*words, *flags]))).encode()).hexdigest()
            if target.exists() and stamp.exists() and stamp.read_text() == digest:
                return target, "", 0
            begun = time.time()
            done = self.run(["nice", "-n", "10", words[0], f"-I{folder}", *words[1:], *flags, "-c", file, "-o", target])
            if done.returncode:
                return None, done.stderr, time.time() - begun
            stamp.write_text(digest)
            return target, "", time.time() - begun

        with ThreadPoolExecutor(jobs) as pool:
            return dict(zip(sources, pool.map(one, sources.items())))

    def chapter(self, chapter, headers, mutants):
        """Compiles the chapter's checks with these mutants and runs each. `headers`: path of each header by its name as it
        is included. Gives (end, check) by number, and the mutants that must be compiled alone."""
        folder = self.scratch / chapter
        folder.mkdir(exist_ok=True)
        sources = {**self.build.commands[chapter], **self.build.extra.get(chapter, {})}
        dropped_path = folder / "dropped.json"
        known = json.loads(dropped_path.read_text()) if dropped_path.exists() else {}
        dropped = {}
        for attempt in range(25):
            written, parts = {}, []
            for old in (folder / "tumble").rglob("*.hpp"):
                if str(old.relative_to(folder)) not in headers:
                    old.unlink()
            for name, path in headers.items():
                text = path.read_text()
                own = [m for m in mutants if m.header == name and m.edits]
                gone = dropped.setdefault(name, set(map(tuple, known.get(hashlib.sha256(text.encode()).hexdigest(), []))))
                sites = {}
                for m in own:
                    if (m.kind_of_site, m.site_start, m.site_end) not in gone:
                        sites.setdefault(m.site, m.edits)
                target = folder / name
                if not sites:
                    if target.exists():
                        target.unlink()
                    continue
                written[name] = switches.switched(text, list(sites.items()))
                target.parent.mkdir(parents=True, exist_ok=True)
                if not target.exists() or target.read_text() != written[name].text:
                    target.write_text(written[name].text)
                parts.append(written[name].text)
            key = hashlib.sha256("".join(parts).encode()).hexdigest()
            begun = time.time()
            objects = self.compile(chapter, sources, folder, key)
            errors = [stderr for _, stderr, _ in objects.values() if stderr]
            self.say(f"{chapter}: compiled {len(sources)} files in {time.time() - begun:.0f} s: " +
                     ", ".join(f"{f.stem} {s:.0f}" for f, (_, _, s) in objects.items()))
            if not errors:
                break
            blamed = 0
            by_site = {m.site: m for m in mutants}
            for stderr in errors:
                for block in switches.complaints(stderr, folder):
                    for name, line, column in block:
                        if name not in written:
                            continue
                        keys = switches.blamed(written[name], line, column)
                        if keys:
                            for site in keys:
                                m = by_site[site]
                                item = (m.kind_of_site, m.site_start, m.site_end)
                                if item not in dropped[name]:
                                    blamed += 1
                                    dropped[name].add(item)
                            break
            (folder / f"errors{attempt}.txt").write_text("\n".join(errors))
            self.say(f"{chapter}: {blamed} sites can't be switched")
            if not blamed:
                raise Failure(f"{chapter} does not compile:\n" + "\n".join(errors)[:3000])
            known = {hashlib.sha256(headers[name].read_text().encode()).hexdigest(): sorted(gone) for name, gone in dropped.items()}
            dropped_path.write_text(json.dumps(known))
        program = folder / "checks"
        linked = self.run([list(sources.values())[0][0], *[o for o, _, _ in objects.values()], self.scratch / "main.o", "-pthread", "-o", program])
        if linked.returncode:
            raise Failure(linked.stderr[:3000])
        wanted, alone = [], []
        for m in mutants:
            if m.edits and (m.kind_of_site, m.site_start, m.site_end) not in dropped[m.header]:
                wanted.append(m)
            else:
                alone.append(m)
        (folder / "wanted.txt").write_text("\n".join(str(m.number) for m in wanted))
        begun = time.time()
        ran = self.run(["nice", "-n", "10", program, folder / "wanted.txt", jobs], cwd=folder)
        (folder / "ran.tsv").write_text(ran.stdout)
        if ran.returncode:
            raise Failure(f"{chapter}: the checks end with {ran.returncode}: {ran.stderr[:1000]}")
        ends = {}
        red = []
        for row in ran.stdout.splitlines():
            number, end, check = row.split("\t")
            if number == "0":
                if end != "holds":
                    red.append(check)
            else:
                ends[int(number)] = (end, check)
        self.say(f"{chapter}: ran {len(wanted)} mutants in {time.time() - begun:.0f} s")
        if red:
            raise Failure(f"{chapter}: without any mutant these checks fail: {red}")
        return ends, alone

    def say(self, sentence):
        print(sentence, flush=True)


def chapters_of(build):
    return [name for name in sorted(build.commands) if re.match(r"\d\d_", name)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build")
    parser.add_argument("--chapters", default="")
    parser.add_argument("--report", default="")
    parser.add_argument("--optimise", default="")
    options = parser.parse_args()
    build = Build(options.build)
    work = Work(build, options)
    number = 1
    below = {}
    all_mutants, owner = [], {}
    order = chapters_of(build)
    for chapter in ["common", *order]:
        folder = root / "common" if chapter == "common" else root / "chapters" / chapter
        for path in sorted((folder / "tumble").glob("*.hpp")):
            name = f"tumble/{path.name}"
            made = generator.Generator(name, path.read_text(), number)
            made.sites = all_mutants[-1].site if all_mutants else 0
            mutants = made.everything()
            number = made.next
            for m in mutants:
                m.chapter = chapter
                m.path = path
                owner[m.site] = m if m.site not in owner else owner[m.site]
            for m in mutants:
                m.kind_of_site, m.site_start, m.site_end = owner[m.site].kind, owner[m.site].start, owner[m.site].end
            all_mutants += mutants
    ends = {}
    wanted = options.chapters.split(",") if options.chapters else order
    try:
        for chapter in order:
            if chapter not in wanted:
                continue
            mine = [m for m in all_mutants if (m.chapter == chapter or m.chapter == "common" and chapter in wanted) and
                    ends.get(m.number, ("", ""))[0] not in ("killed", "crashed", "endless", "none")]
            mine += [m for m in all_mutants if m.chapter in order and m.chapter < chapter and m.chapter in wanted and
                     ends.get(m.number, ("", ""))[0] in ("survived", "unreached")]
            headers = {m.header: m.path for m in mine}
            found, alone = work.chapter(chapter, headers, mine)
            for n, (end, check) in found.items():
                if n not in ends or end not in ("unreached",) :
                    ends[n] = (end, f"{chapter} {check}")
            for m in alone:
                ends.setdefault(m.number, ("alone", ""))
    except Failure as failure:
        sys.exit(f"mutants: {failure}")
    counts = {}
    for m in all_mutants:
        if m.number in ends:
            counts.setdefault(m.chapter, {}).setdefault(ends[m.number][0], []).append(m)
    for chapter, by_end in counts.items():
        print(chapter, {end: len(found) for end, found in by_end.items()})
    if options.report:
        rows = []
        for m in all_mutants:
            if m.number in ends:
                text = m.path.read_text()
                line = text.count("\n", 0, m.start) + 1
                rows.append("\t".join([str(m.number), m.header, str(line), m.kind, ends[m.number][0], ends[m.number][1],
                                       before_and_after(text, m)]))
        Path(options.report).write_text("\n".join(rows) + "\n")


def before_and_after(text, m):
    begin, end = text.rfind("\n", 0, m.start) + 1, text.find("\n", m.end)
    old, new = text[begin:end], text[begin:m.start] + m.replacement + text[m.end:end]
    return " ".join(old.split()) + "  =>  " + " ".join(new.split())


if __name__ == "__main__":
    main()
