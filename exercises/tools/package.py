"""./course package gradescope: the zip that Gradescope takes for a programming assignment.

It holds setup.sh, which Gradescope runs once to make its image, run_autograder, which it runs for each submission, the course as
students get it, and what grades those of --exercises that come from the folder of --private: to grade, no solution is needed. The
image must be Debian 12 or Ubuntu 24.04 or later.
"""

import ctrl_c  # noqa: F401
import argparse
import io
import os
import sys
import tempfile
import zipfile
from pathlib import Path

from catalogue import find_all, read_catalogue
from command import status_of
from complaint import Complaint
from outputs import Outputs, occupy_standard_descriptors, require_a_place_of_its_own
from plain_text import say
from release import git, release, tell_left_out

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
[ ! -d "$autograder/source/private" ] || chmod -R go= "$autograder/source/private"
nothing=$(mktemp -d)
"$autograder/source/course/course" grade --no-install --unsealed --exercises {exercises}{private} "$nothing" >/dev/null
rmdir "$nothing"
"""

RUN = """#!/usr/bin/env bash
# Run for each submission, which has this container for itself: no solution is in it and nobody else's work. So it is graded also
# where the kernel has no Landlock; the output's last line says what held. Private checks are for root alone then.
autograder=${{AUTOGRADER:-/autograder}}
mkdir -p "$autograder/results"
exec "$autograder/source/course/course" grade --no-install --unsealed --exercises {exercises}{private} --format gradescope \\
  --output "$autograder/results/results.json" "$autograder/submission"
"""


PRIVATE = ' --private "$autograder/source/private"'


def package(root, exercises, target, private=None):
    """Writes the zip; it is complete or not there. Returns what it leaves out."""
    held_back = [exercise for exercise in exercises if private and exercise.folder.is_relative_to(private)]
    gaps = {"exercises": ",".join(exercise.name for exercise in exercises), "private": PRIVATE if held_back else ""}
    files_held_back = [file for exercise in held_back for file in _files_that_grade(exercise)]
    committed = [root / os.fsdecode(name) for name in git(root, "ls-tree", "-r", "-z", "--name-only", "HEAD").split(b"\0") if name]
    require_a_place_of_its_own("--output", target, [*(("a file of the course", file) for file in committed),
                                                    *(("a file of a private exercise", file) for file in files_held_back)])
    with Outputs() as outputs, tempfile.TemporaryDirectory(prefix="package-") as scratch:
        course = Path(scratch) / "course"
        _, left_out = release(root, course)  # before the zip is begun, which may lie among what isn't committed
        write = outputs.open("--output", target)
        held_names = {exercise.name for exercise in read_catalogue(course)}
        for exercise in exercises:
            if exercise.name not in held_names and exercise not in held_back:
                raise Complaint(f"the exercise {exercise.name} isn't committed, so the zip would not hold it; git add it and its solution, "
                                "and git commit")
        held = io.BytesIO()
        with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED, strict_timestamps=False) as packed:
            for name, text in (("setup.sh", SETUP), ("run_autograder", RUN)):
                entry = zipfile.ZipInfo(name)
                entry.external_attr = 0o100755 << 16
                entry.compress_type = zipfile.ZIP_DEFLATED
                packed.writestr(entry, text.format(**gaps))
            for file in sorted(course.rglob("*")):
                if file.is_file():
                    _pack(packed, file, f"course/{file.relative_to(course)}")
            for file in files_held_back:
                _pack(packed, file, f"private/{file.relative_to(private)}")
        write(held.getvalue())
    return left_out


def _files_that_grade(exercise):
    return [exercise.folder / "exercise.json", *sorted(exercise.folder.glob("*.[ch]pp"))]


def _pack(packed, file, name):
    entry = zipfile.ZipInfo.from_file(file, name, strict_timestamps=False)
    # Whatever the umask of whoever packs: the compiler reads it there as a user of its own.
    entry.external_attr = (0o100755 if os.access(file, os.X_OK) else 0o100644) << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    packed.writestr(entry, file.read_bytes())


def main(words):
    occupy_standard_descriptors()
    parser = argparse.ArgumentParser(prog="./course package", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--toolchain", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("kind", choices=("gradescope",))
    parser.add_argument("--exercises", required=True, help="those of the assignment, such as moon,no_lag")
    parser.add_argument("--private", type=Path, help="a folder of further exercises, laid out as exercises/ is")
    parser.add_argument("--output", type=Path, default=Path("autograder.zip"))
    arguments = parser.parse_args(words)

    def run():
        exercises = find_all(read_catalogue(arguments.root, arguments.private), arguments.exercises)
        left_out = package(arguments.root, exercises, arguments.output, arguments.private)
        say(f"{arguments.output} is for Gradescope: {', '.join(exercise.title for exercise in exercises)}; "
            f"{sum(exercise.points for exercise in exercises)} points.")
        tell_left_out(left_out)
    return status_of(run)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
