#!/usr/bin/env python3
"""Runs clang-tidy over every .cpp file of common/, chapters/, exact/ and tools/, many files at a time.

    tidy.py BUILD_FOLDER [JOBS]    the build folder holds compile_commands.json, made for clang

Most of what clang-tidy does for a file it does for the headers that the file includes: Eigen's, doctest's. So the files of a
folder that share a standard of C++ are read as one. Each is put into a namespace of its own, that their names may meet; what
they include is included before, outside of it. Only where that does not compile does each file go alone. Prints what is found; the exit code is 0 if
that is nothing."""
import json
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

root = Path(__file__).resolve().parent.parent
include = re.compile(r'^#include (?:<(.+)>|"(.+)")', re.MULTILINE)
# What must stand outside of any other namespace, and what of that must come last: no declaration may follow what it declares.
has_a_place = re.compile(r"^namespace \w|^(?:extern )?template [^<]|^\S.*\btumble::[\w:<>]+\(.*\{$", re.MULTILINE)
instantiates = re.compile(r"^(?:extern )?template [^<]", re.MULTILINE)


def flags_of(entry):
    """The words that say what the compiler reads: folders, macros, the standard, warnings."""
    words = iter(shlex.split(entry["command"])[1:])
    flags = []
    for word in words:
        if word == "-isystem":
            flags.append(word + next(words))
        elif word in ("-o", "-c", "-Xclang"):
            next(words)
        elif re.match("-[IDW]|-std=", word):
            flags.append(word)
    return flags


def folders_of(entries):
    """For each folder its files, each with its flags: its own where it is compiled, else those of all that are compiled in the
    folder or in the one around it. The longest list comes first, so that in the end none is waited for."""
    own, together = {}, {}
    for entry in entries:
        file, flags = Path(entry["file"]), flags_of(entry)
        own[file] = flags
        together.setdefault(file.parent, {}).update(dict.fromkeys(flags))
    folders = {}
    for file in sorted(file for name in ("common", "chapters", "exact", "tools") for file in root.glob(f"{name}/**/*.cpp")):
        if file.name == "live_module.cpp":  # compiled for WebAssembly alone, with attributes of that machine
            continue
        nearest = next((together[folder] for folder in file.parents if folder in together), {})
        flags = own.get(file, list(nearest))
        standard = [flag for flag in flags if flag.startswith("-std=")][-1:]
        # Every live figure defines the same function, so no two of them can be read as one.
        figure = file if file.stem.endswith("_live") else None
        folders.setdefault((file.parent, figure, *standard), {})[file] = flags
    return sorted(folders.values(), key=len, reverse=True)


def read_as_one(files):
    """The text of a file that includes all of these."""
    lines = []
    for file in files:
        for system, own in include.findall(file.read_text()):
            beside = file.parent / own
            lines.append(f"#include <{system}>" if system else f'#include "{beside if beside.exists() else own}"')
    lines = sorted(set(lines), key=lines.index)
    for number, file in enumerate(sorted(files, key=lambda file: bool(instantiates.search(file.read_text())))):
        text = f'#include "{file}"'
        lines.append(text if has_a_place.search(file.read_text()) else f"namespace file_{number} {{\n{text}\n}}")
    return "\n".join(lines) + "\n"


def tidy(file, flags):
    """What clang-tidy says of a file, or nothing. In a namespace main() is a function like others, and needs a return."""
    command = ["clang-tidy", f"--config-file={root / '.clang-tidy'}", "--checks=-bugprone-suspicious-include", "--quiet"]
    looked = subprocess.run([*command, file, "--", *flags, "-Wno-return-type"], text=True, capture_output=True)
    errors = re.sub(r"^\d+ warnings? .*generated\.\n", "", looked.stderr, flags=re.MULTILINE)
    return looked.stdout + errors if looked.returncode else ""


def tidy_folder(files, scratch):
    """What clang-tidy says of a folder's files, and how often it had to read."""
    one = Path(tempfile.mkdtemp(dir=scratch), "many.cpp")
    one.write_text(read_as_one(files))
    said = tidy(one, dict.fromkeys(flag for flags in files.values() for flag in flags))
    if "clang-diagnostic-error" not in said:
        return said, 1
    return "".join(tidy(file, flags) for file, flags in files.items()), len(files)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    entries = json.loads(Path(sys.argv[1], "compile_commands.json").read_text())
    folders = folders_of(entries)
    found = 0
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(int((sys.argv + ["2"])[2])) as pool:
        looks = pool.map(lambda files: tidy_folder(files, scratch), folders)
        for files, (said, times) in zip(folders, looks):
            alone = " alone" if times > 1 else ""
            print(f"{next(iter(files)).parent.relative_to(root)}: {len(files)} files{alone}", flush=True)
            if said:
                found += 1
                print(said, flush=True)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
