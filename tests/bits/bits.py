#!/usr/bin/env python3
"""Whether rungs and shipped scenes end with the bits that they end with everywhere.

    bits.py RUNG_BITS EXACT_BITS SCENE_BITS SCENES EXPECTED          compare with the digests in the file EXPECTED
    bits.py RUNG_BITS EXACT_BITS SCENE_BITS SCENES EXPECTED --write  make that file anew, after a change that changes motion

Each line of the file holds what was run, the precision, and a digest of all states. A scene's three ways, by plan, by
reference and in packs, must have one digest. everywhere.py does the same with other compilers.

The exact solutions ask the C library for sines, logarithms and roots of any order. Each library rounds those in its own way, and glibc
in several, by what the processor can do. So where another one is at work, theirs are told and not judged."""
import os
import platform
import subprocess
import sys
from pathlib import Path

exact_by = "glibc 2.36 on x86-64 with FMA"  # the library in which the digests of exact solutions were made


def library_here():
    """The C library at work, in the words of exact_by."""
    processor = Path("/proc/cpuinfo")
    fuses = processor.exists() and " fma " in processor.read_text() and "-FMA" not in os.environ.get("GLIBC_TUNABLES", "")
    return f"{' '.join(platform.libc_ver())} on {platform.machine().replace('_', '-')}{' with FMA' if fuses else ''}"


def digests(rung_bits, exact_bits, scene_bits, scenes):
    """What was run and in which precision, with its digest."""
    paths = [path for path in sorted(Path(scenes).glob("*.json")) if path.name != "scene.schema.json"]
    found = {}
    for command in ([rung_bits], [exact_bits], [scene_bits, *paths]):
        for line in subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines():
            what, precision, digest = line.split("\t")
            found[what, precision] = digest
    return found


def ways_that_differ(found):
    """Scenes whose ways have not one digest."""
    return [key for key in found if key[0].startswith("scene ")
            and found[key] != found[key[0].split(",")[0], key[1]]]


def main():
    *programs, scenes, expected = sys.argv[1:6]
    found = digests(*programs, scenes)
    for what, precision in ways_that_differ(found):
        print(f"error: {what} in {precision} is not what it is by plan")
    if ways_that_differ(found):
        return 1
    if sys.argv[6:] == ["--write"]:
        Path(expected).write_text("".join(f"{what}\t{precision}\t{digest}\n" for (what, precision), digest in found.items()))
        return 0
    known = {tuple(line.split("\t")[:2]): line.split("\t")[2] for line in Path(expected).read_text().splitlines()}
    others = [key for key in known.keys() | found.keys() if known.get(key) != found.get(key)]
    of_the_library = [key for key in others if key[0].startswith("exact ") and library_here() != exact_by]
    for what, precision in sorted(others):
        if (what, precision) in of_the_library:
            print(f"{what} in {precision} has other bits here, {library_here()}, than {exact_by}")
            continue
        print(f"error: {what} in {precision}: {found.get((what, precision), 'not run')}, "
              f"and everywhere else {known.get((what, precision), 'not known')}")
    print(f"{len(found) - len(others)} of {len(found)} motions end with the same bits as everywhere")
    return 1 if len(others) > len(of_the_library) else 0


if __name__ == "__main__":
    sys.exit(main())
