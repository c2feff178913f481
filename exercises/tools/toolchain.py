"""The compiler's commands for an exercise, called without CMake: the headers precompiled, -O1, no debugging symbols."""

import json
import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from complaint import Complaint

# Unused parameters are no fault in an exercise: in a starter none is used yet. Eigen without vector instructions compiles a
# tenth sooner.
OPTIONS = ["-std=c++20", "-O1", "-g0", "-DEIGEN_DONT_VECTORIZE", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion",
           "-Wno-unused-parameter", "-fdiagnostics-color=never"]


CACHES = ("ccache", "sccache", "distcc", "icecc")  # which are found under a compiler's name where their folder comes first on the PATH


@dataclass(frozen=True)
class Toolchain:
    compiler: str
    options: list
    system_folders: list
    player_folders: list
    floors: dict
    common: Path  # where <exercise/...> is found
    build: Path   # where everything made goes
    launcher: tuple = ()  # what starts the compiler, such as ccache

    def folders_of(self, floor):
        if floor not in self.floors:
            chapters = [each for each in self.floors if each[0].isdigit()]  # and no floor below them all
            raise Complaint(f"there is no chapter {floor}; the chapters are {', '.join(chapters)}")
        return self.floors[floor]

    @property
    def precompiled(self):
        """The folder of the precompiled header; by its real name, for a compiler asked by another would make it again."""
        return (self.build / "precompiled").resolve()

    @property
    def precompiled_header(self):
        """Each file that is compiled with it depends on it; a compiler that ccache calls doesn't name it."""
        return self.precompiled / "exercise.hpp.gch"

    def compile(self, source, target, floor, first_folders=(), last_folders=(), precompiled=True):
        """The command that compiles one file, and the file in which it names what it has read."""
        dependencies = f"{target}.d"
        folders = [*first_folders, self.common, *self.folders_of(floor), *last_folders]
        command = [*self.launcher, self.compiler, *OPTIONS, *self.options, "-MD", "-MF", dependencies]
        if precompiled:
            command += ["-include", self.precompiled / "exercise.hpp"]
        command += [word for folder in self.system_folders for word in ("-isystem", folder)]
        command += [f"-I{folder}" for folder in folders if folder not in self.system_folders]
        return [*command, "-c", source, "-o", target], dependencies

    def precompile(self):
        """The command for the precompiled header, its target, and the file that names what it read."""
        header = self.precompiled / "exercise.hpp"
        target = self.precompiled_header
        command, dependencies = self.compile(header, target, "common", precompiled=False)
        command[command.index("-c"):command.index("-c") + 1] = ["-x", "c++-header"]
        return header, command, target, dependencies

    def in_words(self):
        """Compiler, version and options. Where its folders lie decides on nothing."""
        try:
            said = subprocess.run([self.compiler, "--version"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        except OSError as error:
            raise Complaint(f"the compiler {self.compiler} can't be started: {error.strerror}") from None
        return " ".join([said.stdout.decode("utf-8", "replace").partition("\n")[0], *OPTIONS, *self.options])

    def link(self, objects, target):
        return [self.compiler, *objects, "-o", target]


def itself(compiler):
    """The compiler for which a cache stands, as the cache would find it: confined, a cache has neither a home nor files to keep."""
    if os.path.basename(os.path.realpath(compiler)) not in CACHES:
        return compiler
    name = os.path.basename(compiler)
    found = (shutil.which(name, path=folder) for folder in os.get_exec_path())
    real = next((each for each in found if each and os.path.basename(os.path.realpath(each)) not in CACHES), None)
    if not real:
        raise Complaint(f"{compiler} is {os.path.realpath(compiler)}, and the PATH holds no {name} besides; add its folder to the PATH")
    return real


def read_toolchain(file, common, build, launched=False):
    """`launched`: by ccache, where that is installed. It asks for time where a file is new, and saves it where none is."""
    try:
        said = json.loads(Path(file).read_text(encoding="utf-8"))
        return Toolchain(compiler=itself(said["compiler"]), options=said["options"], system_folders=said["system_folders"],
                         player_folders=said["player_folders"], floors=said["floors"], common=Path(common).resolve(), build=build,
                         launcher=tuple(word for word in said["launcher"] if word) if launched else ())
    except FileNotFoundError:
        raise Complaint(f"{file} is missing; CMake writes it when it configures the build") from None
    except (ValueError, KeyError, TypeError):
        raise Complaint(f"{file} is damaged; once it is removed, CMake writes it anew") from None
