"""The two programs of an exercise: the judge, which holds the checks, and the worker, which holds a student's code."""

import hashlib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from made import dependencies_in, end_running, held, make
from outputs import write_whole


PRECISIONS = ("double", "float")


@dataclass(frozen=True)
class Worker:
    """A student's code as a program for each precision: two, so that they compile side by side."""
    programs: dict  # by precision
    warnings: str


@dataclass(frozen=True)
class Judge:
    """What judges a worker. `reference`: the solution's own workers by precision; none where no solution is at hand."""
    program: Path
    reference: dict
    secret: bytes = b""  # which nobody knows who doesn't have the solution
    key: str = ""        # of the student who is judged

    def seed(self, number, precision):
        """From which the questions of a check are drawn that nobody else is asked."""
        words = f"{self.key} {number} {precision} ".encode("utf-8", "surrogateescape")
        return int.from_bytes(hashlib.sha256(words + self.secret).digest()[:8], "big")


def solution_of(exercise):
    """Where its solution lies: in solutions/ beside the folder of exercises, which a student's copy doesn't have."""
    return exercise.folder.parents[2] / "solutions" / exercise.path / exercise.header


def prepare(toolchain, exercise, key=""):
    """Makes what doesn't depend on a student's code: precompiled header, worker's loop, judge, and the solution. Returns the judge."""
    header, command, target, dependencies = toolchain.precompile()
    write_if_new(header, b"#include <exercise/precompiled.hpp>\n")
    make(target, command, dependencies=dependencies)
    compile_shared(toolchain, "serve")
    compile_shared(toolchain, "judge")
    judge = judge_of(toolchain, exercise)
    checks = judge.with_name("checks.o")
    _compile(toolchain, exercise.folder / "checks.cpp", checks, exercise.chapter)
    parts = [checks, shared(toolchain, "judge.o")]
    make(judge, toolchain.link(parts, judge), inputs=parts)
    solution = solution_of(exercise)
    if not solution.exists():
        return Judge(judge, {}, key=key)
    reference = build_worker(toolchain, exercise, solution.parent, solution_folder_of(toolchain, exercise))
    return Judge(judge, reference.programs, solution.read_bytes(), key)


def build_worker(toolchain, exercise, header_folder, folder):
    """Compiles a student's header, found in `header_folder`, into a worker in `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    made = _side_by_side(lambda real: _build_answers(toolchain, exercise, real, header_folder, folder), PRECISIONS, len(PRECISIONS))
    return Worker({real: folder / f"worker_{real}" for real in PRECISIONS}, made[0].output)


def read_for_worker(folder):
    """The files that the compiler read for the worker in this folder."""
    return sorted({file for real in PRECISIONS for file in dependencies_in(folder / f"answers_{real}.o.d")})


def _build_answers(toolchain, exercise, real, header_folder, folder):
    source = folder / f"answers_{real}.cpp"
    write_if_new(source, answers_source(exercise, real).encode())
    compiled, worker = folder / f"answers_{real}.o", folder / f"worker_{real}"
    command, dependencies = toolchain.compile(source, compiled, exercise.chapter, first_folders=[header_folder])
    read = [toolchain.precompiled_header, header_folder / exercise.header]
    made = make(compiled, command, inputs=read, dependencies=dependencies)
    parts = [compiled, shared(toolchain, "serve.o")]
    make(worker, toolchain.link(parts, worker), inputs=parts)
    return made


def build_show(toolchain, exercise, header_folder, folder):
    """Compiles show.cpp, with which a lab records what the student's code does; it may use every chapter."""
    compiled = folder / "show.o"
    folders = toolchain.player_folders
    command, dependencies = toolchain.compile(exercise.folder / "show.cpp", compiled, list(toolchain.floors)[-1],
                                              first_folders=[header_folder], last_folders=folders)
    made = make(compiled, command, inputs=[toolchain.precompiled_header], dependencies=dependencies)
    show = folder / "show"
    make(show, toolchain.link([compiled], show), inputs=[compiled])
    return show, made.output


def prepare_all(toolchain, exercises, jobs):
    """The judges of many exercises; the precompiled header comes first, then the others side by side."""
    judges = {exercises[0].path: prepare(toolchain, exercises[0])} if exercises else {}
    judges.update(_side_by_side(lambda exercise: (exercise.path, prepare(toolchain, exercise)), exercises[1:], jobs))
    return judges


def _side_by_side(work, items, most):
    """What comes of each. Who is told to end doesn't wait for compilers."""
    with ThreadPoolExecutor(most) as pool:
        try:
            return list(pool.map(work, items))
        except BaseException as error:
            if not isinstance(error, Exception):
                end_running()
            raise


def answers_source(exercise, real):
    """The worker's main: every function of the exercise by name."""
    return ("#include <exercise/answers.hpp>\n"
            f"#include <{exercise.header}>\n\n"
            "int main(int argument_count, char** arguments) {\n"
            "  using tumble::exercise::answer;\n"
            "  return tumble::exercise::serve(\n"
            "      argument_count, arguments,\n"
            "      {\n" + offers_of(exercise, real) + "      });\n"
            "}\n")


def offers_of(exercise, real):
    """The functions and their names, as the lines of a list."""
    return "".join(f'          {{"{name}", answer<&{name}<{real}>>}},\n' for name in exercise.functions)


def judge_of(toolchain, exercise):
    return folder_of(toolchain, exercise) / "judge"


def solution_folder_of(toolchain, exercise):
    return folder_of(toolchain, exercise) / "solution"


def folder_of(toolchain, exercise):
    return toolchain.build / exercise.chapter / exercise.name


def compile_shared(toolchain, name):
    """Makes an object file of the code that all exercises share."""
    compiled = shared(toolchain, f"{name}.o")
    _compile(toolchain, toolchain.common / "exercise" / f"{name}.cpp", compiled, "common")
    return compiled


def shared(toolchain, name):
    """What is compiled once for all exercises."""
    return (toolchain.build / "shared").resolve() / name


def _compile(toolchain, source, target, floor):
    command, dependencies = toolchain.compile(source, target, floor)
    make(target, command, inputs=[toolchain.precompiled_header, source], dependencies=dependencies)


def write_if_new(file, data):
    """Unless it holds that already. Others may be about to compile it, so it is never there in part."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with held(file):
        if not file.exists() or file.read_bytes() != data:
            write_whole(file, data)
