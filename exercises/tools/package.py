"""./course package gradescope: the zip that Gradescope takes for a programming assignment.

It holds setup.sh, which Gradescope runs once to make its image, run_autograder, which it runs for each submission, and the course as
students get it: to grade, no solution is needed. The image must be Debian 12 or Ubuntu 24.04 or later.
"""

import argparse
import sys
import tempfile
import zipfile
from pathlib import Path

from catalogue import find, read_catalogue
from complaint import Complaint
from release import release

SETUP = """#!/usr/bin/env bash
# Run once, when Gradescope makes the image: installs what is needed, and compiles the checks.
set -e
missing=
autograder=${{AUTOGRADER:-/autograder}}
for program in g++ make cmake python3; do command -v $program >/dev/null || missing=yes; done
if [ -n "$missing" ] || ! [ -d /usr/include/eigen3 ] || ! [ -d /usr/include/doctest ]; then
  apt-get update
  apt-get install -y --no-install-recommends g++ make cmake python3 libeigen3-dev doctest-dev
fi
nothing=$(mktemp -d)
"$autograder/source/course/course" grade --no-install --exercises {exercises} "$nothing" >/dev/null
rmdir "$nothing"
"""

RUN = """#!/usr/bin/env bash
# Run for each submission.
autograder=${{AUTOGRADER:-/autograder}}
mkdir -p "$autograder/results"
exec "$autograder/source/course/course" grade --no-install --exercises {exercises} --format gradescope \\
  --output "$autograder/results/results.json" "$autograder/submission"
"""


def package(root, exercises, target):
    """Writes the zip; it is complete or not there."""
    words = ",".join(exercise.name for exercise in exercises)
    unfinished = target.with_name(target.name + ".unfinished")
    with tempfile.TemporaryDirectory(prefix="package-") as scratch:
        course = Path(scratch) / "course"
        release(root, course)
        try:
            with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED) as packed:
                for name, text in (("setup.sh", SETUP), ("run_autograder", RUN)):
                    entry = zipfile.ZipInfo(name)
                    entry.external_attr = 0o100755 << 16
                    entry.compress_type = zipfile.ZIP_DEFLATED
                    packed.writestr(entry, text.format(exercises=words))
                for file in sorted(course.rglob("*")):
                    if file.is_file():
                        packed.write(file, f"course/{file.relative_to(course)}")
            unfinished.replace(target)
        finally:
            unfinished.unlink(missing_ok=True)


def main(words):
    parser = argparse.ArgumentParser(prog="./course package", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--toolchain", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("kind", choices=("gradescope",))
    parser.add_argument("--exercises", required=True, help="those of the assignment, such as moon,no_lag")
    parser.add_argument("--output", type=Path, default=Path("autograder.zip"))
    arguments = parser.parse_args(words)
    try:
        catalogue = read_catalogue(arguments.root)
        exercises = [find(catalogue, word) for word in arguments.exercises.split(",")]
        package(arguments.root, exercises, arguments.output)
    except Complaint as complaint:
        print(f"course: {complaint}", file=sys.stderr)
        return 2
    print(f"{arguments.output} is for Gradescope: {', '.join(exercise.title for exercise in exercises)}; "
          f"{sum(exercise.points for exercise in exercises)} points.")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
