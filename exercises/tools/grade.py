"""./course grade DIR...: points for one submission or for a class of a thousand, as text, JSON, JUnit's XML or for Gradescope.

A submission is a folder that holds a student's headers; its name is the student's. ada@1 and ada@2 are two of ada's, of which --keep
best (or last) counts.

Results are kept as they come, in grade.part or in the file that --part names, and --resume takes up a run that was stopped. --shard 3/16
grades the third of sixteen shares, for as many machines; ./course grade merge PARTS... then makes of their parts what one run would
have made.

Exit status: 0; 2 for a mistake in what was asked; 3 if submissions have no result, which is never 0 points; 128 and the signal's number
for a run that was stopped.
"""

import ctrl_c  # noqa: F401
import argparse
import contextlib
import math
import os
import sys
import tempfile
from pathlib import Path

from catalogue import find_all, read_catalogue
from command import NO_RESULT, status_of
from complaint import Complaint
from grade_class import grade_class, job_of, require_results
from limits import Limits, seconds_computed
from outputs import Outputs, occupy_standard_descriptors, require_a_place_of_its_own
from plain_text import complain, one_line, plain, say
from programs import folder_of, prepare_all
from reports import FORMATS, marks
from shards import WHOLE, Part, Stopped, job_of_part, merge, shard_of
from submission import places_of, places_of_header, when_submitted
from toolchain import read_toolchain
from untrusted import require_out_of_reach, require_seals, seals, seals_in_words

MOST_SECONDS = 3600  # of computing, for one check


def counted(results, keep):
    """The submissions that count: of each student the best, or the last."""
    if keep == "all":
        return results
    by_student = {}
    for result in sorted(results, key=lambda result: (result["student"], when_submitted(result["submission"]))):
        so_far = by_student.get(result["student"])
        if so_far is None or keep == "last" or result["points"] > so_far["points"]:
            by_student[result["student"]] = result
    return list(by_student.values())


def write_outputs(arguments, outputs, by_name, missing):
    """Whole tables, or none: who has no result is told, and is in none with --incomplete alone. Returns the exit status."""
    complain_of(missing)
    if missing and not arguments.incomplete:
        complain(f"{len(missing)} submissions have no result, which is not 0 points, so no output is written. --resume grades what is "
                 "missing; --incomplete writes the others'")
        return NO_RESULT
    results = counted(list(by_name.values()), arguments.keep)
    if arguments.format == "gradescope" and len(results) != 1:
        raise Complaint(f"{len(results)} submissions; Gradescope grades one at a time")
    text = FORMATS[arguments.format](results)
    if "output" in outputs:
        outputs["output"](text.encode())
    elif arguments.format == "text":
        say(text)
    else:
        sys.stdout.buffer.write(text.encode() + b"\n")
        sys.stdout.buffer.flush()
    if "marks" in outputs:
        outputs["marks"](marks(results).encode())
    return NO_RESULT if missing else 0


def complain_of(missing):
    """Whatever follows in further lines may be a compiler's words."""
    for name, why in missing.items():
        complain(f"{one_line(name)} has no result{': ' + plain(why).replace(chr(10), chr(10) + '| ') if why else ''}")


def merged(parts):
    """The results in the parts of a class, and the names of those that have none."""
    results, missing = merge(parts)
    require_results(results, job_of_part(parts[0]))
    return results, missing


def opened_outputs(stack, arguments, inputs):
    files = {"output": arguments.output, "marks": arguments.marks}
    for name, file in files.items():
        if file:
            require_a_place_of_its_own(f"--{name}", file, inputs)
    return {name: stack.open(f"--{name}", file) for name, file in files.items() if file}


def grade(arguments, stack):
    submissions = places_of(arguments.folders)
    exercises = find_all(read_catalogue(arguments.root, arguments.private), arguments.exercises)
    if not 0 < arguments.seconds <= MOST_SECONDS:
        raise Complaint(f"seconds is {arguments.seconds:g}; it must be greater than 0 and at most {MOST_SECONDS}")
    if arguments.budget is not None and not 0 < arguments.budget < math.inf:
        raise Complaint(f"budget is {arguments.budget:g} seconds; it must be greater than 0, and finite")
    if arguments.jobs < 1:
        raise Complaint(f"jobs is {arguments.jobs}; it must be at least 1")
    if arguments.format == "gradescope" and len(arguments.folders) != 1:
        raise Complaint(f"{len(arguments.folders)} submissions; Gradescope grades one at a time")
    outputs = opened_outputs(stack, arguments, read_by_it(arguments, submissions, exercises))
    toolchain = read_toolchain(arguments.toolchain, arguments.root / "exercises" / "common", arguments.toolchain.parent)
    with tempfile.TemporaryDirectory(prefix="grade-") as scratch:
        kept = part_of(arguments)
        job = job_of(arguments, submissions, exercises, toolchain)
        # Open until all is written: nobody is to take up what this run removes in the end.
        part = stack.enter_context(Part(kept or Path(scratch) / "part", job, arguments.shard, arguments.resume))
        try:
            return grade_into(part, kept, arguments, toolchain, submissions, exercises, outputs)
        except Stopped:
            if kept and kept.exists():
                say(f"{len(part.done)} of {len(part.tasks)} results are kept in {kept}; the same command with --resume goes on.",
                    to=sys.stderr)
            raise


def grade_into(part, kept, arguments, toolchain, submissions, exercises, outputs):
    """Returns the exit status."""
    prepare_all(toolchain, exercises, arguments.jobs)
    require_seals(toolchain, max(exercises, key=lambda exercise: exercise.chapter), arguments.seconds,
                  arguments.unsealed)
    if not arguments.unsealed:
        require_out_of_reach([("the course", arguments.root), ("the build", arguments.toolchain.parent), ("what TMPDIR names",
                              tempfile.gettempdir()), *([("what --private names", arguments.private)] if arguments.private else []),
                              *((f"the submission {one_line(name)}", place) for name, place in submissions.items())])
    if arguments.private:
        close_to_submissions(toolchain, [each for each in exercises if each.folder.is_relative_to(arguments.private)], arguments.private)
    before, computed = len(part.done), seconds_computed()
    results, failed = grade_class(arguments, submissions, exercises, part, show_how_far)
    tell_throughput(len(part.done) - before, len(exercises), seconds_computed() - computed)
    if arguments.shard != WHOLE:
        complain_of(failed)
        say(f"{len(results)} of {len(results) + len(failed)} results of shard {arguments.shard.number}/{arguments.shard.of} are in {kept}")
        return NO_RESULT if failed else 0
    status = write_outputs(arguments, outputs, results, failed)
    if status == 0 and kept and not arguments.part:
        kept.unlink(missing_ok=True)  # nothing of it is left to do
    return status


def close_to_submissions(toolchain, exercises, private):
    """Others than root, as whom root has submissions graded, may execute what is made of private exercises, and read none of it. Complains
    where nothing else keeps a submission from their files."""
    held = seals()
    if not held["files"] and not (held["user"] and private.stat().st_mode & 0o007 == 0):
        raise Complaint(f"{private} could be read by every submission, for the system offers no Landlock. Run by root, with chmod o= "
                        f"{private}, the grader keeps it to itself")
    for folder in (folder_of(toolchain, exercise) for exercise in exercises):
        for place in (folder, *folder.rglob("*")):
            place.chmod(0o711 if place.is_dir() or os.access(place, os.X_OK) else 0o600)


def read_by_it(arguments, submissions, exercises):
    """What no output may overwrite: what it is, and the file."""
    headers = [("a submission's header", place) for folder in submissions.values() for exercise in exercises
               for place in places_of_header(folder, exercise) if place.exists()]
    return [("where results are kept", part_of(arguments)), *headers] if part_of(arguments) else headers


def part_of(arguments):
    """Where results are kept. One submission alone needs no such place."""
    if arguments.part:
        return arguments.part
    if arguments.shard != WHOLE:
        return Path(f"grade.{arguments.shard.number}_of_{arguments.shard.of}.part")
    return Path("grade.part") if len(arguments.folders) > 1 or arguments.resume else None


def parsers():
    """That of both commands, that of grading, and that of merging."""
    both = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    both.add_argument("--format", choices=FORMATS, default="text")
    both.add_argument("--output", type=Path, help="the file to write instead of the standard output")
    both.add_argument("--marks", type=Path, help="a table of points as CSV")
    both.add_argument("--keep", choices=("all", "best", "last"), default="all", help="of resubmissions, such as ada@1 and ada@2")
    both.add_argument("--incomplete", action="store_true", help="write the outputs even if submissions have no result")
    form = {"formatter_class": argparse.RawDescriptionHelpFormatter, "parents": [both], "allow_abbrev": False}
    grading = argparse.ArgumentParser(prog="./course grade", description=__doc__, **form)
    grading.add_argument("folders", nargs="+", type=Path, metavar="DIR")
    grading.add_argument("--exercises", help="those that count, such as moon,no_lag; if not given, all of them")
    grading.add_argument("--private", type=Path, help="a folder of further exercises, laid out as exercises/ is")
    grading.add_argument("--seed", default="", help="students' numbers are drawn with the key SEED-STUDENT")
    grading.add_argument("--seconds", type=float, default=Limits.seconds, help="of computing time, for one check")
    grading.add_argument("--budget", type=float, metavar="SECONDS", help="by the clock, after which a submission has no result")
    grading.add_argument("--unsealed", action="store_true", help="grade even where a submission can't be confined")
    grading.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="submissions that are graded at the same time")
    grading.add_argument("--shard", default="1/1", help="NUMBER/OF: only this share, for ./course grade merge")
    grading.add_argument("--part", type=Path, help="the file in which results are kept as they come")
    grading.add_argument("--resume", action="store_true", help="continue the run that left its part, if there is one")
    merging = argparse.ArgumentParser(prog="./course grade merge", description="Makes of all shards' parts what one run makes.", **form)
    merging.add_argument("parts", nargs="+", type=Path, metavar="PART")
    return grading, merging


def commanded(words):
    """What is asked: of grading, or of merging where the first word is merge."""
    course = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    course.add_argument("--root", type=Path, required=True)
    course.add_argument("--toolchain", type=Path, required=True)
    known, rest = course.parse_known_args(told_apart(words))
    grading, merging = parsers()
    if rest[:1] == ["merge"]:
        if os.path.lexists("merge"):
            raise Complaint("merge could be the command or the name of what lies here; write ./* for all that lies here, or merge from "
                            "another folder")
        return merging.parse_intermixed_args(rest[1:])
    arguments = grading.parse_intermixed_args(rest)
    arguments.root, arguments.toolchain = known.root, known.toolchain
    return arguments


def told_apart(words):
    """The words, of which none is both an option and the name of what lies here: a student may call a folder --unsealed, and where the
    teacher writes * the shell hands it on. After -- all are names."""
    options = words[:words.index("--")] if "--" in words else words
    for word in options:
        if word.startswith("-") and os.path.lexists(word):
            raise Complaint(f"{one_line(word)} could be an option or the name of what lies here; write ./* for all that lies here, or "
                            "give the option from another folder")
    return [*options, *(f"./{word}" if word.startswith("-") else word for word in words[len(options) + 1:])]


def tell_throughput(submissions, exercises, seconds):
    """How large a cluster has to be is reckoned from this."""
    if submissions:
        say(f"Computing took {seconds / submissions / exercises:.2f} s for each exercise of a submission.", to=sys.stderr)


def show_how_far(done, of):
    if sys.stderr.isatty():
        with contextlib.suppress(OSError):  # the terminal has gone
            print(f"\r{done} of {of} graded", end="\n" if done == of else "", file=sys.stderr, flush=True)


def main(words):
    occupy_standard_descriptors()
    return status_of(lambda: asked(words))


def asked(words):
    """Returns the exit status."""
    arguments = commanded(words)
    if sys.stdout is None:
        if not arguments.output:
            raise Complaint("the standard output is closed; --output names a file for what is handed on")
        sys.stdout = open(1, "w", encoding="utf-8", closefd=False)
    with Outputs() as stack:
        if "parts" in arguments:
            outputs = opened_outputs(stack, arguments, [("one of the parts", part) for part in arguments.parts])
            results, missing = merged(arguments.parts)
            return write_outputs(arguments, outputs, results, dict.fromkeys(missing, ""))
        arguments.shard = shard_of(arguments.shard)
        if arguments.shard != WHOLE and (arguments.output or arguments.marks):
            raise Complaint("a shard writes its part alone; --output and --marks are for ./course grade merge")
        status = grade(arguments, stack)
    say(seals_in_words(), to=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
