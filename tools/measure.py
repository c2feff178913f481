#!/usr/bin/env python3
"""./course book --full --shard 3/16    does the third of sixteen shares of the long measurements and keeps what came of it in a part
   ./course book merge PART...          sets the book from the parts of all shares, with nothing long to run

A share has items of the programs that CMake calls LONG: one problem of chapter 13, one rung of chapter 14's random tops in one precision,
or a whole program. Whatever is compared by its time is one item, so each quotient is measured in one go, alone on its machine: give that
nothing else to do meanwhile. Items that measure no time run side by side before. All shares want the same processor and the same compiler.

Results are kept as they come, in measured.3-of-16.part where you are or in the file that --part names; --resume takes up a run that was
stopped. Ends with 0, 1 if items have failed twice, 2 if something is wrong with what was given, 128 and the signal's number after one.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "exercises" / "tools"))
import ctrl_c  # noqa: E402, F401

import argparse  # noqa: E402
import hashlib  # noqa: E402
import json  # noqa: E402
import os  # noqa: E402
import platform  # noqa: E402
import re  # noqa: E402
import shutil  # noqa: E402
import subprocess  # noqa: E402
import tempfile  # noqa: E402

from complaint import Complaint  # noqa: E402
from outputs import occupy_standard_descriptors  # noqa: E402
from plain_text import complain, say  # noqa: E402
from running import Running  # noqa: E402
from shards import Job, Part, Stopped, job_of_part, merge, run, shard_of, stoppable  # noqa: E402

IN_VAIN = "expected, but not so: "  # so begins what a program tells of an expectation
SOURCES = ("CMakeLists.txt", "CMakePresets.json", "cmake", "common", "chapters", "exact", "tools/bench")
KINDS = {".hpp", ".cpp", ".h", ".cmake", ".txt", ".json"}


# --- What is to be done -------------------------------------------------------------------------------------------------------------


def read_programs(file):
    """{name: what CMake says of it}: chapter, program, arguments, measures (time) and items (or only itself)."""
    return {program["name"]: program for program in json.loads(file.read_text(encoding="utf-8"))["programs"]}


def items_of(program):
    """The names of its items; None stands for the program as a whole."""
    if not program["items"]:
        return [None]
    named = subprocess.run([program["program"]], env={**os.environ, "TUMBLE_ITEMS": "names"}, stdin=subprocess.DEVNULL,
                           stdout=subprocess.PIPE, text=True, check=True)
    return named.stdout.splitlines()


def tasks_of(programs):
    """{a task's name: (program, item)}."""
    return {name if item is None else f"{name}: {item}": (program, item)
            for name, program in programs.items() for item in items_of(program)}


def what_is_measured(arguments):
    """What must be equal in every shard."""
    digest = hashlib.sha256()
    for file in sources(arguments.root):
        digest.update(f"{file.relative_to(arguments.root)}\0".encode() + hashlib.sha256(file.read_bytes()).digest())
    return {"programs": digest.hexdigest(), "set": "quick" if arguments.quick else "full", "processor": processor(),
            "compiler": json.loads(arguments.programs.read_text(encoding="utf-8"))["compiler"]}


def sources(root):
    found = [file for name in SOURCES for file in ([root / name] if (root / name).is_file() else (root / name).rglob("*"))]
    return sorted(file for file in found if file.suffix in KINDS and file.is_file())


def processor():
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
        name = re.search(r"^(?:model name|Processor|cpu model)\s*:\s*(.+)$", text, re.MULTILINE)[1].strip()
        return re.sub(r"[^\w ()@.,:+/-]", "?", name)  # it's set into pages and files
    except (OSError, TypeError):
        return platform.processor() or platform.machine()


# --- A share ------------------------------------------------------------------------------------------------------------------------


class Measuring:
    """Runs programs as the build of the book would."""

    def __init__(self, quick):
        self.running = Running("measuring")
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith("TUMBLE_")}
        if not quick:
            self.environment["TUMBLE_FULL"] = "1"

    def result_of(self, program, item):
        """Of an item its text and what it expected in vain; of a program the texts of all files that it leaves."""
        if item is not None:
            done = self.run([program["program"]], TUMBLE_ITEMS=f"only {item}", stdout=subprocess.PIPE)
            return {"text": done.stdout, "errors": done.stderr if done.returncode else ""}
        with tempfile.TemporaryDirectory(prefix="tumble-measure-") as scratch:
            self.run_into(Path(scratch), program)
            return {"files": {file.name: file.read_bytes().decode("utf-8") for file in sorted(Path(scratch).iterdir())}}

    def run_into(self, folder, program, **environment):
        """Leaves what the build leaves: files of its own, what it printed, and what it expected in vain."""
        name = program["name"]
        with open(folder / f"{name}.txt", "wb") as out:
            done = self.run([program["program"], folder, *program["arguments"]], stdout=out, **environment)
        for ending in (["errors", "failed"] if done.returncode else ["errors"]):
            (folder / f"{name}.{ending}").write_text(done.stderr, encoding="utf-8")

    def run(self, words, stdout, **environment):
        """Raises RuntimeError unless it ends well, or with nothing but expectations in vain."""
        done = self.running.run(words, stdout=stdout, env={**self.environment, **environment})
        in_vain = done.stderr and all(line.startswith(IN_VAIN) for line in done.stderr.splitlines())
        if done.returncode and not (done.returncode == 1 and in_vain):
            raise RuntimeError(f"it ended with {done.returncode}: {done.stderr.strip()[-2000:]}")
        return done


def stamp_of(program):
    try:
        status = os.stat(program["program"])
    except OSError as error:
        raise Complaint(f"{program['program']} is not there: {error.strerror}") from None
    return status.st_mtime_ns, status.st_size, status.st_ino


def tell(done, of):
    say(f"{done} of {of}", to=sys.stderr)


def do_share(arguments):
    shard, programs = shard_of(arguments.shard), read_programs(arguments.programs)
    tasks = tasks_of(programs)
    name = arguments.part or Path(f"measured.{shard.number}-of-{shard.of}.part")
    measuring = Measuring(arguments.quick)
    failed, compiled = {}, {name: stamp_of(program) for name, program in programs.items()}

    def result_of(task):
        result = measuring.result_of(*tasks[task])
        if stamp_of(tasks[task][0]) != compiled[tasks[task][0]["name"]]:
            raise Complaint(f"{tasks[task][0]['name']} was compiled anew meanwhile; what was measured before is kept, and no more")
        return result
    with Part(name, Job(what_is_measured(arguments), list(tasks)), shard, arguments.resume) as part:
        for is_alone in (False, True):
            failed |= run(part, result_of, 1 if is_alone else os.cpu_count() or 1,
                          measuring.running.stop, tell, lambda task: tasks[task][0]["measures"] == is_alone)
    for task, why in failed.items():
        complain(f"{task} failed twice: {why}")
    say(f"{len(part.done)} of {len(part.tasks)} results of shard {shard.number}/{shard.of} are in {name}")
    return 1 if failed else 0


# --- All of them --------------------------------------------------------------------------------------------------------------------


def put_together(arguments):
    """Makes the folder with a folder for each program, in which lies what it would have left, and a line on where it was measured."""
    results, missing = merge(arguments.merge)
    if missing:
        raise Complaint(f"{len(missing)} of {len(results) + len(missing)} items have no result yet, such as {missing[0]}; "
                        "run their shards with --resume")
    what, here = job_of_part(arguments.merge[0]), what_is_measured(arguments)
    programs = read_programs(arguments.programs)
    tasks = tasks_of(programs)
    if not (isinstance(what, dict) and has_texts(what, *here)):
        raise Complaint("the parts are of other work than measuring")
    if list(results) != list(tasks) or any(what[key] != here[key] for key in ("programs", "set")):
        raise Complaint("the parts are of another version of the course than this one; only its own can be set into its book")
    count = len(arguments.merge)
    where = f"the full set, measured in {count} part{'s' * (count > 1)} on {what['processor']} ({what['compiler']})\n"
    unfinished = arguments.into.with_name(arguments.into.name + ".unfinished")
    shutil.rmtree(unfinished, ignore_errors=True)
    try:
        fill(unfinished, programs, tasks, results, Measuring(arguments.quick))
        write(unfinished, {"where.txt": where})
        replace(arguments.into, unfinished)
    except RuntimeError as error:
        raise Complaint(f"what the parts hold can't be put together: {error}") from None
    except OSError as error:
        raise Complaint(f"{arguments.into} can't be written: {error.strerror}; what it held is as it was") from None
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)
    return 0


def fill(folder, programs, tasks, results, measuring):
    """Leaves there a folder for each program, with what it would have left."""
    for name, program in programs.items():
        own = folder / name
        own.mkdir(parents=True)
        parts = [results[task] for task in tasks if tasks[task][0] is program]
        if program["items"]:
            with tempfile.TemporaryDirectory(prefix="tumble-measure-") as scratch:
                for number, result in enumerate(parts):
                    write(Path(scratch), {f"{number}.txt": result["text"], f"{number}.errors": result["errors"]})
                measuring.running.apart(measuring.run_into, own, program, TUMBLE_ITEMS=f"from {scratch}")
        else:
            write(own, parts[0]["files"])


def replace(folder, new):
    """Puts a folder into the place of another one, which is kept until then."""
    before = folder.with_name(folder.name + ".before")
    shutil.rmtree(before, ignore_errors=True)
    if folder.exists():
        folder.rename(before)
    try:
        new.rename(folder)
    except BaseException:
        if before.exists() and not folder.exists():
            before.rename(folder)
        raise
    shutil.rmtree(before, ignore_errors=True)


def has_texts(value, *keys):
    return value.keys() == set(keys) and all(isinstance(text, str) for text in value.values())


def write(folder, files):
    for name, text in files.items():
        if Path(name).name != name or name.startswith("."):
            raise Complaint(f"a part holds a file called {name}, which no program of the course leaves")
        (folder / name).write_text(text, encoding="utf-8", newline="")


def main():
    parser = argparse.ArgumentParser(prog="./course book", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     usage="%(prog)s --full --shard NUMBER/OF [--part FILE] [--resume] | merge PART...")
    parser.add_argument("--root", type=Path, default=ROOT, help=argparse.SUPPRESS)
    parser.add_argument("--programs", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--into", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--merge", type=Path, nargs="+", metavar="PART", help=argparse.SUPPRESS)
    parser.add_argument("--shard", help="the share of the items to do, such as 3/16")
    parser.add_argument("--part", type=Path, help="where results are kept as they come; measured.3-of-16.part if not given")
    parser.add_argument("--resume", action="store_true", help="continue a run that was stopped")
    occupy_standard_descriptors()
    arguments = parser.parse_args()
    try:
        with stoppable():
            return put_together(arguments) if arguments.merge else do_share(arguments)
    except Complaint as complaint:
        complain(complaint)
        return 2
    except Stopped as stopped:
        print("\ncourse: stopped" + ("" if arguments.merge else "; --resume takes it up"), file=sys.stderr)
        return 128 + stopped.signal


if __name__ == "__main__":
    sys.exit(main())
