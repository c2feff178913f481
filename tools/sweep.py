#!/usr/bin/env python3
"""./course sweep FILE             simulates every combination that FILE lists and prints one table
   ./course sweep merge PART...    the table of a sweep whose shards ran apart

FILE is JSON. Of its lists every combination is simulated; only "scenes" is required.

  {"scenes": ["t_handle", "my_scene.json"],      names of shipped scenes, or paths as seen from FILE
   "methods": ["splitting", "axis_by_axis"],     turning methods; without the key each scene's own
   "schemes": ["verlet"],                        in which order a step kicks and drifts; without the key each scene's own
   "precisions": ["float", "double"],            without the key double
   "time_steps": [0.01, 0.001],                  s; without the key each scene's own
   "seeds": [0, 1, 2],                           added to those of random bodies; a scene without any runs once
   "until": 10}                                  s; without the key each scene's duration

Results are kept in a part file as they come, and --resume takes up a run that was stopped. Merged shards give the table of one run,
to the byte. A step that can't be taken is a result; the last column says so. Ends with 0 if there is a row for each combination, 1 if
some have failed, 2 if something is wrong with what was given, 128 and the number of the signal after one.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "exercises" / "tools"))
import ctrl_c  # noqa: E402, F401

import argparse  # noqa: E402
import json  # noqa: E402
import math  # noqa: E402
import os  # noqa: E402
import subprocess  # noqa: E402
import tempfile  # noqa: E402

from complaint import Complaint  # noqa: E402
from outputs import Outputs, occupy_standard_descriptors, require_a_place_of_its_own  # noqa: E402
from plain_text import complain, plain, say  # noqa: E402
from shards import WHOLE, Part, Stopped, merge, run, shard_of, stoppable  # noqa: E402
from running import Running  # noqa: E402
from sweep_file import combinations_of, find_scene, job_of, read_sweep  # noqa: E402

COLUMNS = ["scene", "method", "scheme", "precision", "time step (s)", "seed", "bodies", "steps", "time (s)", "energy at the start (J)",
           "energy at the end (J)", "energy from turning (J)", "unexplained energy (J)", "angular momentum at the start (kg m^2/s)",
           "angular momentum from turning (kg m^2/s)", "ended"]


class Simulator:
    """Runs the program, and ends what runs."""

    def __init__(self, program):
        self.program, self.running = program, Running("sweep")

    def run(self, *options):
        """Its exit code and what it complained of."""
        done = self.running.run([self.program, *options], stdout=subprocess.DEVNULL)
        return done.returncode, done.stderr.strip().removeprefix("simulate: ")


def require_runnable(simulator, combinations):
    """Whatever differs by more than the seed is tried without a step, so that a mistake is told before hours have gone."""
    tried = {}
    for combination in combinations.values():
        tried.setdefault(json.dumps({**combination["given"], "seeds": None}), combination["options"])
    for options in tried.values():
        try:
            code, errors = simulator.running.apart(simulator.run, *options, "--plan")
        except (OSError, ValueError) as error:  # ValueError: a text with a zero in it, which no program can be given
            raise Complaint(f"{simulator.program} can't be run: {error}") from None
        if code != 0:
            raise Complaint(errors)


# --- What is answered ---------------------------------------------------------------------------------------------------------------


def row_of(simulator, combination, require_unchanged):
    """A row of the table: texts, numbers, and None where there is nothing."""
    with tempfile.TemporaryDirectory(prefix="tumble-sweep-") as scratch:
        file = Path(scratch, "books.json")
        code, errors = simulator.run(*combination["options"], "--books", file)
        if code == 2:
            raise Complaint(errors)
        if code not in (0, 1):
            raise RuntimeError(errors or f"simulate ended with {code}")
        books = json.loads(file.read_text())
    require_unchanged()
    given, precision = combination["given"], combination["given"]["precisions"] or "double"
    start, now, turning = books["at_the_start"], books["now"], turning_of(books)
    numbers = [books["bodies"], books["steps"], books["time"], total(start["energy"], books["stored_at_the_start"]),
               total(now["energy"], books["stored_now"]), turning["energy"], books["unexplained"]["energy"],
               length(start["angular_momentum"]), length(turning["angular_momentum"])]
    return [given["scenes"], given["methods"] or books["turning_method"], given["schemes"] or books["scheme"], precision, books["time_step"],
            given["seeds"], *numbers, "well" if code == 0 else errors]


def turning_of(books):
    """What the turning method put in, or nothing."""
    nothing = {"energy": 0.0, "angular_momentum": [0.0, 0.0, 0.0]}
    return next((line for line in books["effects"] if line["name"].startswith("tumbling: ")), nothing)


def total(*energies):
    return None if None in energies else sum(energies)


def length(vector):
    return None if None in vector else math.hypot(*vector)


def cell(value, digits):
    """Plain text without a tab or a line's end."""
    if isinstance(value, float):
        return f"{value:.{digits}g}" if digits else repr(value)
    return "" if value is None else plain(" ".join(str(value).split()))


def require_rows(results):
    for task, row in results.items():
        if not isinstance(row, list) or len(row) != len(COLUMNS):  # other work keeps its results in parts too
            raise Complaint(f"what is kept for {task} is no row of a sweep's table")


def table_of(rows, digits):
    return "".join("\t".join(cell(value, digits) for value in row) + "\n" for row in (COLUMNS, *rows))


def opened_output(outputs, path, inputs):
    """A function that takes the table."""
    if path is None:
        if sys.stdout is None:
            raise Complaint("the standard output is closed; --output names a file for the table")
        return print_text
    require_a_place_of_its_own("--output", path, inputs)
    write = outputs.open("--output", path)
    return lambda text: write(text.encode())


def print_text(text):
    try:
        with open(1, "wb", closefd=False) as out:
            out.write(text.encode())
    except OSError as error:
        raise Complaint(f"the standard output can't be written: {error.strerror}") from None


def tell(done, of):
    """How far it is: on a terminal always, elsewhere each quarter."""
    if sys.stderr.isatty():
        print(f"\r{done} of {of}", end="\n" if done == of else "", file=sys.stderr, flush=True)
    elif 4 * done // of != 4 * (done - 1) // of:
        say(f"{done} of {of}", to=sys.stderr)


def simulate_share(arguments):
    """The exit code."""
    if len(arguments.words) > 1:
        raise Complaint(f"one word too many: {arguments.words[1]}")
    file = Path(arguments.words[0])
    shard = shard_of(arguments.shard) if arguments.shard else WHOLE
    if shard != WHOLE and arguments.output:
        raise Complaint("--output is for a whole sweep; the table of shards comes from ./course sweep merge")
    jobs = (os.cpu_count() or 1) if arguments.jobs is None else arguments.jobs
    if jobs < 1:
        raise Complaint(f"--jobs is {jobs}; it must be 1 or more")
    sweep = read_sweep(file)
    combinations = combinations_of(sweep, file.parent)
    job = job_of(sweep, file.parent, combinations)
    name = arguments.part or Path(f"{file.stem}.part" if shard == WHOLE else f"{file.stem}.{shard.number}-of-{shard.of}.part")
    scenes = [(f"the scene {word}", find_scene(word, file.parent)) for word in sweep["scenes"]]
    simulator = Simulator(arguments.simulate)

    def require_unchanged():
        if job_of(sweep, file.parent, combinations) != job:
            raise Complaint("a scene has changed since the sweep began; what was simulated of it before is kept, and no more")
    with Outputs() as outputs:
        write = opened_output(outputs, arguments.output, [("the sweep itself", file), ("where its results are kept", name), *scenes])
        require_runnable(simulator, combinations)
        with Part(name, job, shard, arguments.resume) as part:
            require_rows(part.done)
            failed = run(part, lambda task: row_of(simulator, combinations[task], require_unchanged), jobs, simulator.running.stop, tell)
            rows = [part.done[task] for task in part.tasks if task in part.done]
        for task, why in failed.items():
            complain(f"{task} failed twice: {why}")
        if failed:
            return 1
        if shard == WHOLE:
            write(table_of(rows, arguments.digits))
            name.unlink(missing_ok=True)
    return 0


def merge_parts(arguments):
    for option, value in (("shard", arguments.shard), ("part", arguments.part), ("jobs", arguments.jobs),
                          ("resume", arguments.resume or None)):
        if value is not None:
            raise Complaint(f"--{option} is for a sweep; merge takes parts, --output and --digits")
    parts = [Path(word) for word in arguments.words[1:]]
    with Outputs() as outputs:
        write = opened_output(outputs, arguments.output, [("one of the parts", part) for part in parts])
        results, missing = merge(parts)
        if missing:
            raise Complaint(f"{len(missing)} of {len(results) + len(missing)} combinations have no row yet, such as {missing[0]}; "
                            "run their shards with --resume")
        require_rows(results)
        write(table_of(results.values(), arguments.digits))
    return 0


def main():
    occupy_standard_descriptors()
    parser = argparse.ArgumentParser(prog="./course sweep", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     usage="%(prog)s FILE [OPTION...] | merge PART... [--output TABLE]")
    parser.add_argument("--simulate", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("words", nargs="+", metavar="FILE", help=argparse.SUPPRESS)
    parser.add_argument("--shard", help="the part of the combinations to simulate, such as 3/16")
    parser.add_argument("--part", type=Path, help="where results are kept as they come; NAME.part or NAME.3-of-16.part if not given")
    parser.add_argument("--resume", action="store_true", help="continue a run that was stopped")
    parser.add_argument("--output", type=Path, help="the file for the table, tabs between columns; the standard output if not given")
    parser.add_argument("--digits", type=int, choices=range(1, 18), metavar="N", help="digits of each number, 1 to 17; all if not given")
    parser.add_argument("--jobs", type=int, help="simulations at a time; one for each processor if not given")
    parser.print_help = lambda: print_text(parser.format_help())  # argparse's own is silent where it can't be written
    is_merge = False
    try:
        arguments = parser.parse_args()
        is_merge = arguments.words[0] == "merge" and len(arguments.words) > 1
        with stoppable():
            return merge_parts(arguments) if is_merge else simulate_share(arguments)
    except Complaint as complaint:
        complain(complaint)
        return 2
    except Stopped as stopped:
        print("\ncourse: stopped" + ("" if is_merge else "; --resume takes it up"), file=sys.stderr)
        return 128 + stopped.signal


if __name__ == "__main__":
    sys.exit(main())
