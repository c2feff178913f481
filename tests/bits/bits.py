#!/usr/bin/env python3
"""Whether rungs and shipped scenes end with the bits that they end with everywhere.

    bits.py RUNG_BITS SIMULATE SCENES EXPECTED          compare with the digests in the file EXPECTED
    bits.py RUNG_BITS SIMULATE SCENES EXPECTED --write  make that file anew, after a change that changes motion

Each line of the file holds what was run, the precision, and a digest: of every state of a top, or of the state that
`simulate` writes at the end, whose numbers are the shortest that are read back as the same bits."""
import hashlib
import subprocess
import sys
import tempfile
from pathlib import Path


def digests(rung_bits, simulate, scenes):
    """What was run and in which precision, with its digest."""
    found = {}
    for line in subprocess.run([rung_bits], check=True, capture_output=True, text=True).stdout.splitlines():
        what, precision, digest = line.split("\t")
        found[what, precision] = digest
    for scene in sorted(Path(scenes).glob("*.json")):
        if scene.name == "scene.schema.json":
            continue
        for precision in ("float", "double"):
            found[f"scene {scene.stem}", precision] = digest_of(simulate, scene, precision)
    return found


def digest_of(simulate, scene, precision):
    """Of where all bodies are after a second and how they move then."""
    with tempfile.TemporaryDirectory() as folder:
        trajectory = Path(folder, "trajectory.csv")
        subprocess.run([simulate, scene, "--precision", precision, "--until", "1", "--every", "1000000", "--no-ledger",
                        "--csv", trajectory], check=True, capture_output=True)
        return hashlib.sha256(trajectory.read_bytes()).hexdigest()[:16]


def main():
    rung_bits, simulate, scenes, expected = sys.argv[1:5]
    found = digests(rung_bits, simulate, scenes)
    if sys.argv[5:] == ["--write"]:
        Path(expected).write_text("".join(f"{what}\t{precision}\t{digest}\n" for (what, precision), digest in found.items()))
        return 0
    known = {tuple(line.split("\t")[:2]): line.split("\t")[2] for line in Path(expected).read_text().splitlines()}
    others = [key for key in known.keys() | found.keys() if known.get(key) != found.get(key)]
    for what, precision in sorted(others):
        print(f"error: {what} in {precision}: {found.get((what, precision), 'not run')}, "
              f"and everywhere else {known.get((what, precision), 'not known')}")
    print(f"{len(found) - len(others)} of {len(found)} motions end with the same bits as everywhere")
    return 1 if others else 0


if __name__ == "__main__":
    sys.exit(main())
