#!/usr/bin/env python3
"""Breaks the programs simulate and advise as their lists say, one mutation at a time, and sees whether one of their tests turns red.

    tools_by_list.py BUILD_FOLDER [NAME...]      simulate or advise; both if none is named
    tools_by_list.py BUILD_FOLDER --changed      those of which sources, tests or list have changed since ./course test --exhaustive
                                                 last held (since.py), or all where nobody knows what has

All mutations of a program are compiled together, and TUMBLE_MUTANT in the environment chooses one while its tests run.
What they said is in BUILD_FOLDER/mutants/NAME/NUMBER.log. A mutation is seen if a test fails or a program
computes for a minute. The exit code is 0 if all are seen but those that the lists call equivalent."""
import argparse
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
import alone
import by_hand
import switches
from build_folder import Build
from engine import Engine, EngineError, run
from mutation_list import ListError, read_list
from mutations import say, tell_of_lists
from since import changed_since_held

here = Path(__file__).resolve().parent
root = here.parent.parent
tests_of = {"simulate": root / "tests/scenes", "advise": root / "tests/advise"}


class Program:
    """A program and its checks with all mutations of its list in them, and the tests that run these."""

    def __init__(self, name, engine, jobs):
        self.name, self.engine, self.jobs = name, engine, jobs
        self.build, self.folder, self.sources = engine.build.folder, engine.folder / name, root / "tools" / name
        self.copy = self.folder / "source"
        self.mutations = read_list(here / f"{name}.txt")

    def switch(self):
        """Writes a copy of the sources in which each mutation can be chosen."""
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(self.sources, self.copy)
        edits_of_file = {}
        for number, mutation in enumerate(self.mutations, 1):
            text = (root / mutation.header).read_text()
            mutation.apply(text)  # or refuse
            start = text.index(mutation.original)
            edits, _ = by_hand.edits_of(text, start, start + len(mutation.original), mutation.replacement, number)
            if not edits:
                raise ListError(f"{mutation}: this can't be switched; change statements or a number")
            edits_of_file.setdefault(root / mutation.header, []).append((number, edits))
        for path, sites in edits_of_file.items():
            (self.copy / path.relative_to(self.sources)).write_text(switches.switched(path.read_text(), sites).text)

    def make(self, target):
        """Compiles and links a target anew; gives the paths of the original and of what is made."""
        entries = [(entry, shlex.split(entry["command"])) for entry in json.loads((self.build / "compile_commands.json").read_text())]
        entries = [(entry, words[:words.index("-o")]) for entry, words in entries if f"/{target}.dir/" in words[words.index("-o") + 1]]

        def compiled(pair):
            entry, words = pair
            file = Path(entry["file"])
            made = self.folder / f"{target}.{file.name}.o"
            file = self.copy / file.name if file.parent == self.sources else file
            command = self.engine.command(words, self.copy, here / "mutants.hpp")
            self.engine.must(run([*self.engine.launcher, *command, "-O1", "-c", file, "-o", made], entry["directory"]))
            return made

        with ThreadPoolExecutor(self.jobs) as pool:
            objects = [self.engine.folder / "switch.o", *pool.map(compiled, entries)]
        folder = Path(entries[0][0]["directory"])
        said = folder / "CMakeFiles" / f"{target}.dir" / "link.txt"  # make has it there, and ninja says it
        command = said.read_text() if said.exists() else run(["ninja", "-C", folder, "-t", "commands", target]).stdout.splitlines()[-1]
        words = [word for word in shlex.split(command) if word not in (":", "&&") and f"/{target}.dir/" not in word]
        at = words.index("-o") + 1
        original, words[at] = (folder / words[at]).resolve(), self.folder / target
        self.engine.must(run([*words[:at + 1], *objects, *words[at + 1:]], folder))
        return str(original), str(self.folder / target)

    def tests(self, made):
        """Names and commands of the tests that are called after it, the quickest first, but for the slow ones."""
        asked = json.loads(run(["ctest", "--test-dir", self.build, "--show-only=json-v1"]).stdout)
        found = {}
        for test in asked["tests"]:
            labels = next((each["value"] for each in test["properties"] if each["name"] == "LABELS"), [])
            if re.match(rf"(checks|programs)\.{self.name}", test["name"]) and "slow" not in labels:
                one = test["name"], [made.get(word, word) for word in test["command"]]
                begun = time.monotonic()
                end, check = self.end_of(0, [one])
                if end != "survived":
                    raise ListError(f"{self.name}: without any mutation a test fails: {check}")
                found[time.monotonic() - begun] = one
        if not found:
            raise ListError(f"{self.name}: it has no tests")
        return [one for _, one in sorted(found.items())]

    def end_of(self, number, tests):
        """How the tests end with this mutation; 0 is none."""
        for name, command in tests:
            scratch, log = self.folder / f"scratch {number}", self.folder / f"{number}.log"
            # A folder of the build's tests, which the command may empty, is another one for each mutation.
            own = [str(scratch) if word.startswith(str(self.build / "tests")) and not Path(word).is_file() else word for word in command]
            limit = f'ulimit -t {alone.computing_seconds}; exec "$0" "$@"'
            with log.open("w") as output:
                done = subprocess.run(["sh", "-c", limit, *own], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                                      env={**os.environ, "TUMBLE_MUTANT": str(number), "TUMBLE_FIRST_FAILURE_ENDS": "yes"})
            shutil.rmtree(scratch, ignore_errors=True)
            if done.returncode:
                failed = re.search(r"^(?:error|TEST CASE|FAIL): +(.+)", log.read_text(errors="replace"), re.MULTILINE)
                return "killed", f"{name}: {failed[1] if failed else f'it ended with {done.returncode}'}"
        return "survived", ""

    def try_all(self):
        """What is wrong."""
        self.switch()
        say(f"{self.name}: compiled with {len(self.mutations)} mutations")
        tests = self.tests(dict(map(self.make, (self.name, f"{self.name}_checks"))))
        wrong = []
        with ThreadPoolExecutor(self.jobs) as pool:
            ends = pool.map(lambda number: self.end_of(number, tests), range(1, len(self.mutations) + 1))
            for mutation, (mutation.result, mutation.check) in zip(self.mutations, ends):
                wrong += tell_of_lists([mutation])
        return wrong


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build")
    parser.add_argument("names", nargs="*", default=list(tests_of))
    parser.add_argument("--changed", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_intermixed_args()
    changed = changed_since_held(root) if options.changed else None
    wrong = []
    try:
        engine = Engine(Build(options.build), options.jobs, say)
        for name in options.names:
            watched = {here / f"{name}.txt", root / "tools" / name, tests_of[name]}
            if changed is None or any(watched & {path, *path.parents} for path in changed):
                wrong += Program(name, engine, options.jobs).try_all()
            else:
                say(f"{name}: nothing has changed")
    except (ListError, EngineError, OSError) as error:
        sys.exit(f"tools_by_list: {error}")
    say(f"{len(wrong)} wrong{':' if wrong else '.'}")
    print(*wrong, sep="\n")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
