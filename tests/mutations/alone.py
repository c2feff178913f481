"""Compiles a chapter's checks with one mutation and runs them: for what can't be switched while they run."""
import re
import subprocess
import tempfile
from pathlib import Path

from build_folder import find_header, headers_of, include_folders

computing_seconds = 60  # of a processor, so that a busy machine changes no verdict
compiling_seconds = 600


def checks_that_see(mutation, build):
    """The names of the chapter's check files that include the header, its own first."""
    checks = build.checks(mutation.chapter)

    def sees(name):
        _, words, file = checks[name]
        folders = include_folders(words)
        return find_header(mutation.header, folders) in headers_of(file, folders)

    return sorted(filter(sees, checks), key=lambda name: name != Path(mutation.header).stem)


def run(seconds, *command, directory=None):
    """Runs a command that may compute for so long; longer, and a signal ends it."""
    limit = f'ulimit -t {seconds}; exec "$0" "$@"'
    return subprocess.run(["sh", "-c", limit, *map(str, command)], cwd=directory, text=True, errors="replace",
                          capture_output=True)


def turns_red(name, build, chapter, scratch, *flags):
    """How a check file ends with the header in `scratch`: an end as of mutants_main.cpp, and the check that saw it."""
    checks, program = scratch / "checks.o", scratch / "checks"
    directory, words, file = build.checks(chapter)[name]
    compiled = run(compiling_seconds, words[0], f"-I{scratch}", *flags, *words[1:], "-w", "-c", file, "-o", checks,
                   directory=directory)
    if compiled.returncode:
        return "no code", " ".join(re.findall(r"error: .*", compiled.stderr)[:1])
    objects = [made for made, _, _ in build.others.get(chapter, {}).values() if made.exists()]
    linked = subprocess.run([words[0], checks, *objects, build.main, "-o", program], capture_output=True)
    if linked.returncode:
        return "survived", ""
    checked = run(computing_seconds, program, "--abort-after=1", "--no-colors")
    if checked.returncode == 0:
        return "survived", ""
    failed = re.search(r"^TEST CASE:\s+(.+)", checked.stdout, re.MULTILINE)
    if failed:
        return "killed", f"{name}: {failed[1]}"
    return "crashed", f"{name}: no verdict within {computing_seconds} s of computing, or a crash"


def settle(mutation, text, build):
    """The end of a mutation and the check that saw it; `text` is the header with the mutation in it."""
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        header = scratch / mutation.header
        header.parent.mkdir(parents=True)
        header.write_text(text)
        names = checks_that_see(mutation, build)
        for flags in ["-DTUMBLE_ONE_PRECISION=float"], []:  # float alone at first, in half the time
            for name in names:
                end, check = turns_red(name, build, mutation.chapter, scratch, *flags)
                if end != "survived":
                    return end, check
        return "survived" if names else "unreached", ", ".join(names)
