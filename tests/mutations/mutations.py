#!/usr/bin/env python3
"""Breaks the chapters' headers on purpose, one line at a time, and sees whether a check of the same chapter turns red.

    mutations.py BUILD_FOLDER [LIST...]    the lists are described in mutation_list.py; without any: all beside this file

The changed header goes into a scratch folder that comes first in the include path, so the sources stay untouched. The
compiler and its flags are those of the build folder, whose compile_commands.json, precompiled header and object with
doctest's main must exist. A check file is compiled with the mutation only if it includes the header, directly or not, and
the first one that turns red ends the matter. So does one that computes for over a minute. At first the checks run in float
alone; only what survives that is tried in every precision, which takes twice as long.

Prints a line for each mutation as it is settled, then what is wrong; the exit code is 0 if nothing is. Wrong is a mutation
that survives and is not listed as equivalent, one that is listed so and does not survive, and one that does not compile."""
import json
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is written beside the sources
from mutation_list import ListError, read_list

jobs = 2
computing_seconds = 60  # of a processor, so that a busy machine changes no verdict


class Build:
    """What a build folder knows: how each chapter's check files are compiled, and with what they are linked."""

    def __init__(self, folder):
        self.commands = {}  # by chapter, then by the file's name without _checks.cpp
        self.main = None
        path = Path(folder, "compile_commands.json")
        if not path.exists():
            raise ListError(f"{path} does not exist; configure the build with CMAKE_EXPORT_COMPILE_COMMANDS")
        for entry in json.loads(path.read_text()):
            # What the course compiles once for many programs is compiled here with the mutation in it.
            words = [word for word in shlex.split(entry["command"]) if not word.startswith("-DTUMBLE_COMPILED_")]
            file, target = Path(entry["file"]), words.index("-o") + 1
            if file.name == "check_main.cpp":
                self.main = Path(entry["directory"], words[target])
            elif file.name.endswith("_checks.cpp"):
                words[target - 1:] = ["-w", "-c", str(file)]  # what a mutation leaves unused is no error
                checks = self.commands.setdefault(file.parent.name, {})
                checks[file.name.removesuffix("_checks.cpp")] = (entry["directory"], words)
        if self.main is None or not self.main.exists():
            raise ListError(f"{self.main} does not exist; build the targets tumble_check_main and tumble_check_headers")

    def checks(self, chapter):
        if chapter not in self.commands:
            raise ListError(f"no chapter with checks is called {chapter}; there are {', '.join(self.commands)}")
        return self.commands[chapter]


def include_folders(words):
    return [Path(word[2:]) for word in words if word.startswith("-I")]


def find_header(name, folders):
    return next((folder / name for folder in folders if (folder / name).exists()), None)


def includes(file, header, folders, seen):
    """Whether `file` includes `header`, itself or by way of others of ours."""
    seen.add(file)
    for name in re.findall(r"#include <((?:tumble|course)/[\w/]+\.hpp)>", file.read_text()):
        path = find_header(name, folders)
        if path and (path == header or (path not in seen and includes(path, header, folders, seen))):
            return True
    return False


def checks_that_see(mutation, build):
    """The names of the chapter's check files that include the header, the likeliest to see the mutation first."""
    checks = build.checks(mutation.chapter)
    likeliest = mutation.seen_by or Path(mutation.header).stem
    if mutation.seen_by and mutation.seen_by not in checks:
        raise ListError(f"{mutation}: {mutation.chapter} has no checks called {mutation.seen_by}")

    def sees(name):
        words = checks[name][1]
        folders = include_folders(words)
        return includes(Path(words[-1]), find_header(mutation.header, folders), folders, set())

    return sorted(filter(sees, checks), key=lambda name: name != likeliest)


def mutated_header(mutation, build):
    """The text of the header with the mutation in it."""
    for _, words in build.checks(mutation.chapter).values():
        path = find_header(mutation.header, include_folders(words))
        if path:
            return mutation.apply(path.read_text())
    raise ListError(f"{mutation}: no such header is in reach of this chapter")


def run(*command, directory=None):
    """Runs a command that may compute for `computing_seconds`; longer, and a signal ends it."""
    limit = f'ulimit -t {computing_seconds}; exec "$0" "$@"'
    return subprocess.run(["sh", "-c", limit, *command], cwd=directory, text=True, errors="replace", capture_output=True)


def turns_red(name, directory, words, main, scratch, *flags):
    """How the check file ends with the header in `scratch`: "" if green, otherwise what went wrong, and whether a check
    saw it."""
    checks, program = scratch / "checks.o", scratch / "checks"
    compiled = run(words[0], f"-I{scratch}", *flags, *words[1:], "-o", checks, directory=directory)
    if compiled.returncode:
        return "\n".join(["does not compile", *re.findall(r".*error: .*", compiled.stderr)[:2]]), False
    subprocess.run([words[0], checks, main, "-o", program], check=True)
    checked = run(program, "--abort-after=1", "--no-colors")
    if checked.returncode == 0:
        return "", False
    failed = re.search(r"^TEST CASE:\s+(.+)", checked.stdout, re.MULTILINE)
    if failed:
        return f"{name}: {failed[1]}", True
    return f"{name}: no verdict within {computing_seconds} s of computing, or a crash", True


def settle(mutation, build):
    """(what became of the mutation, what is wrong with that or "")"""
    names = checks_that_see(mutation, build)
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        header = scratch / mutation.header
        header.parent.mkdir(parents=True)
        header.write_text(mutated_header(mutation, build))
        for flags in ["-DTUMBLE_ONE_PRECISION=float"], []:
            for name in names:
                end, is_killed = turns_red(name, *build.checks(mutation.chapter)[name], build.main, scratch, *flags)
                if is_killed:
                    return f"killed by {end}", "is listed as equivalent, but a check sees it" if mutation.proof else ""
                if end:
                    return end, "must compile"
    if mutation.proof:
        return f"survived; {mutation.proof}", ""
    return f"survived {', '.join(names)}", "survived: add a check, or the proof that it is equivalent"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    here = Path(__file__).parent
    lists = sys.argv[2:] or sorted(set(here.glob("*.txt")) - {here / "CMakeLists.txt"})
    wrong = []
    try:
        build = Build(sys.argv[1])
        mutations = [mutation for path in lists for mutation in read_list(path)]
        for mutation in mutations:  # before anything is compiled
            mutated_header(mutation, build)
            checks_that_see(mutation, build)
    except (ListError, OSError) as error:
        sys.exit(f"mutations: {error}")
    with ThreadPoolExecutor(jobs) as pool:
        for mutation, (end, complaint) in zip(mutations, pool.map(lambda m: settle(m, build), mutations)):
            print(f"{mutation} -- {end}", flush=True)
            if complaint:
                wrong.append(f"{mutation} -- {complaint}")
    print(f"\n{len(mutations)} mutations, {len(wrong)} of them wrong{':' if wrong else '.'}", *wrong, sep="\n")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
