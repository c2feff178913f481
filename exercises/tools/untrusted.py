"""What confines a submission here, and how its header becomes a program: what each stage may reach, as whom, for how long."""

import errno
import functools
import glob
import math
import os
import re
import resource
import shutil
import signal
import stat
import subprocess
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import landlock
from complaint import Complaint, GraderFailed
from confined import end_strays, environment, run_confined
from landlock import Reach
from limits import MEBIBYTE, Limits, seconds_computed
from made import dependencies_in
from patience import Patience
from programs import PRECISIONS, answers_source, judge_of, shared, solution_folder_of
from sealed import can_seal
from toolchain import Toolchain

LIBRARIES = ("/lib", "/lib32", "/lib64", "/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/libexec", "/usr/local/lib",
             "/etc/ld.so.cache")
HEADERS = ("/usr/include", "/usr/local/include")
PARTS_OF_COMPILERS = ("cc1plus", "collect2", "as", "ld")
FIRST_USER = 0x70000000  # from here to 0x7fffffff no system gives numbers to accounts; a process's number is below 1 << 22
FEW_USERS = 62000        # where a container has but 65536 numbers: beyond those of accounts
COMPILING = 12           # times as long as a check may take
MEMORY_OF_COMPILERS, FILES_OF_COMPILERS = 2048 * MEBIBYTE, 64 * MEBIBYTE
ROOM = 256 * MEBIBYTE    # which a compiler must find on the disk
# The last that the compiler says then; a text can make it say so too, with a static_assert.
ENDED_FROM_OUTSIDE = re.compile(r"fatal error: (Killed signal terminated program \w+|ld terminated with signal 9 \[Killed\])\n"
                                r"compilation terminated\.\s*\Z")
# What a system can lack for a while, in its own words; and a right, which a file of the course may have lost to a strict umask.
LACKS = re.compile("|".join(re.escape(os.strerror(each)) for each in (errno.ENOSPC, errno.EDQUOT, errno.EAGAIN, errno.ENOMEM, errno.EMFILE,
                                                                      errno.ENFILE, errno.EIO, errno.EACCES)))


class Uncompiled(Exception):
    """The text is no program; the compiler's words, or why it was cut short."""


class Doubtful(Uncompiled):
    """The compiler says that one of its programs was killed or that the system lacks something, which a text can make it say too.
    `otherwise` is what is wrong where it's not the text."""

    def __init__(self, said, otherwise):
        super().__init__(said)
        self.otherwise = otherwise


def seals():
    """What confines a submission here: name and means, which is empty where nothing does."""
    version = landlock.version()
    return {"files": f"Landlock {version}" if version else "", "calls": "seccomp" if can_seal() else "",
            "user": "a number that no account has" if own_user() else ""}


def seals_in_words():
    held = seals()
    parts = [f"{name} by {means}" for name, means in held.items() if means]
    missing = [name for name, means in held.items() if not means]
    return (f"Submissions were confined in {', '.join(parts)}" if parts else "Submissions were not confined") + (
        f"; not in {', '.join(missing)}." if missing and parts else ".")


def own_user():
    """A user for what this process runs, whom nothing else has that runs at the same time; 0 for none, which only root gives."""
    return _user(os.getpid(), 1 + os.getpid() % 3000)


def _user(number, among_few):
    if os.geteuid() != 0:
        return 0
    numbers = (FIRST_USER + number, FEW_USERS + among_few)
    return next((number for number in numbers if _has("uid", number) and _has("gid", number)), 0)


def _has(kind, number):
    """Whether this container has such a user or group."""
    try:
        ranges = Path(f"/proc/self/{kind}_map").read_text(encoding="ascii").split()
    except OSError:
        return True
    return any(int(first) <= number < int(first) + int(count) for first, count in zip(ranges[0::3], ranges[2::3]))


def require_seals(toolchain, exercise, seconds, unsealed):
    """Complains unless a submission can be confined here and the compiler works there; `unsealed`: unless the compiler works."""
    held = seals()
    if not unsealed and not (held["files"] and held["calls"]):
        lacking = " and ".join(what for what, name in (("Landlock", "files"), ("seccomp", "calls")) if not held[name])
        raise Complaint(f"here a submission can't be confined, for the system offers no {lacking}. The handbook says what it could do "
                        "then; --unsealed grades nevertheless")
    _require_high_limits(math.ceil(COMPILING * seconds) + 1)
    try:
        with a_workshop(toolchain, exercise, own_user(), COMPILING * 5) as workshop:
            workshop.require_readable()
            workshop.try_out()
    except GraderFailed as failure:
        raise Complaint(failure) from None


def _require_high_limits(seconds):
    """Complains where the caller has less than a compiler gets: submissions would be graded by that."""
    for name, option, kind, wanted, unit, size in (("memory", "v", resource.RLIMIT_AS, MEMORY_OF_COMPILERS, "MB", MEBIBYTE),
                                                   ("a file's size", "f", resource.RLIMIT_FSIZE, FILES_OF_COMPILERS, "MB", MEBIBYTE),
                                                   ("computing time", "t", resource.RLIMIT_CPU, seconds, "s", 1)):
        most = resource.getrlimit(kind)[1]
        if most != resource.RLIM_INFINITY and most < wanted:
            raise Complaint(f"the limit of {name} is {most / size:g} {unit} here (ulimit -{option}), and a compiler gets "
                            f"{wanted // size} {unit}")


def require_out_of_reach(places):
    """Complains of what lies where every submission may read, in the system's own folders; (what it is, folder)."""
    for what, place in places:
        real = Path(os.path.realpath(place))
        for folder in (*LIBRARIES, *HEADERS):
            if real.is_relative_to(os.path.realpath(folder)):
                raise Complaint(f"{what} lies in {folder}, which every submission may read; grade where it lies elsewhere")


def limits_of_workers(seconds=Limits.seconds, user=0):
    """The same for a student's own check as for a submission."""
    return Limits(seconds=seconds, file=0, user=user, user_of_judge=_user(0, 0) if user else 0, sealed=True,
                  reach=Reach(readable=LIBRARIES, executable=_loaders()))


@contextmanager
def a_workshop(toolchain, exercise, user, seconds):
    """Folders of its own for what becomes of one header; they are gone at the end."""
    with tempfile.TemporaryDirectory(prefix="graded-") as folder:
        place = Path(os.path.abspath(folder))  # a relative TMPDIR makes relative folders
        for name, mode in (("text", 0o755), ("made", 0o700), ("empty", 0o755)):
            (place / name).mkdir()
            (place / name).chmod(mode)
        if user:
            os.chown(place, 0, user)
            place.chmod(0o710)
            os.chown(place / "made", user, user)
        yield Workshop(toolchain, exercise, place, user, seconds)


@dataclass(frozen=True)
class Workshop:
    """Where a header is compiled: the compiler reads `text` and may write to `made` alone; workers run in `empty`."""
    toolchain: Toolchain
    exercise: object
    place: Path
    user: int
    seconds: float  # of computing, for the compiler

    def compile(self, text):
        """The workers by precision, both made of the same text. Raises Uncompiled, or GraderFailed where it's not the text's fault."""
        patience = self._patience()
        try:
            try:
                return self._workers(text, patience)
            except Doubtful:
                self._try_out_on_the_starter()
            return self._workers(text, patience)
        except Uncompiled:
            self.try_out()
            raise

    def _patience(self):
        return Patience(Limits.clock * self.seconds)

    def _workers(self, text, patience):
        self._write(self.exercise.header, text)
        for real in PRECISIONS:
            self._write(f"answers_{real}.cpp", answers_source(self.exercise, real))
        return {real: self._made(f"answers_{real}", patience) for real in PRECISIONS}

    def _try_out_on_the_starter(self):
        """Raises GraderFailed if the same happens there. The starter asks for as much memory as an answer, an empty program
        for far less."""
        starter = self.exercise.folder / self.exercise.header
        try:
            self._workers(starter.read_text(encoding="utf-8") if starter.exists() else "", self._patience())
        except Doubtful as doubtful:
            raise GraderFailed(doubtful.otherwise) from None
        except Uncompiled:
            pass  # a private exercise without a starter; what counts is that nobody ended the compiler

    def require_readable(self):
        """Raises GraderFailed if a header, the worker's loop, the judge or the solution is kept from the users whom root gives to programs:
        what was fetched or made under a strict umask. Whoever includes it would be told that the own text doesn't compile."""
        if not self.user:
            return
        folders = [Path(folder) for folder in self._headers()]
        found = [each for folder in folders for each in sorted(folder.rglob("*")) if each.is_dir() or each.suffix in (".hpp", ".gch")]
        judge, solution = judge_of(self.toolchain, self.exercise), solution_folder_of(self.toolchain, self.exercise)
        way = sorted({above for folder in folders for above in Path(os.path.realpath(folder)).parents} - {Path(os.path.realpath(self.place))})
        run = [file for file in (*way, judge.parent, judge, solution, *(solution / f"worker_{real}" for real in PRECISIONS)) if file.exists()]
        for file in (*folders, *found, shared(self.toolchain, "serve.o"), *run):
            wanted = stat.S_IXOTH if file in run else stat.S_IROTH | stat.S_IXOTH if file.is_dir() else stat.S_IROTH
            if ~file.stat().st_mode & wanted:
                raise GraderFailed(f"{file} must be readable for everybody: run by root, the compiler has a user of its own. chmod "
                                   f"o+{'x' if file in way else 'rX'} lets it in; or grade without root, or a course that lies elsewhere")

    def try_out(self):
        """Raises GraderFailed unless the compiler works here, on a text that is beyond doubt."""
        free = os.statvfs(self.place)
        if free.f_bavail * free.f_frsize < ROOM:
            raise GraderFailed(f"{self.place.parent} has less than {ROOM // MEBIBYTE} MB left")
        self._write("nothing.cpp", "int main() {}\n")
        try:
            self._made("nothing", self._patience())
        except Doubtful as doubtful:
            raise GraderFailed(doubtful.otherwise) from None
        except Uncompiled as failure:
            why = "; run by root it has a user of its own, who must be able to read the course and its build" if self.user else ""
            raise GraderFailed(f"the compiler does not work where it is confined{why}: {failure}") from None

    @property
    def empty(self):
        return self.place / "empty"

    def _made(self, name, patience):
        """The program that is made of one file, which may include what is allowed, and nothing else."""
        compiled, program = self.place / "made" / f"{name}.o", self.place / "made" / name
        command, dependencies = self.toolchain.compile(self.place / "text" / f"{name}.cpp", compiled, self.exercise.chapter,
                                            first_folders=[self.place / "text"])
        self._run(command, patience)
        self._run(self.toolchain.link([compiled, shared(self.toolchain, "serve.o")], program), patience)
        foreign = why_foreign(_listed(dependencies), self.toolchain, self.exercise, self.place / "text")
        if foreign:
            raise Uncompiled(foreign)
        return program

    def _run(self, command, patience):
        """Raises Uncompiled with what the compiler said, GraderFailed where somebody else ended it."""
        made = self.place / "made"
        limits = Limits(seconds=self.seconds, memory=MEMORY_OF_COMPILERS, file=FILES_OF_COMPILERS, user=self.user,
                        reach=Reach(readable=(*LIBRARIES, *HEADERS, *self._headers(), shared(self.toolchain, "serve.o")),
                                    executable=(*_tools(self.toolchain.compiler), *_loaders()), writable=(made,)))
        before = seconds_computed()
        try:
            ran = run_confined(command, limits, made, patience)
        except (OSError, subprocess.SubprocessError) as error:
            raise GraderFailed(f"the compiler does not work where it is confined: {command[0]} was not started: {error}") from None
        end_strays()
        said = self._without_places(ran.output.decode("utf-8", "replace"))
        if ran.code == -signal.SIGKILL and not ran.cut:
            raise GraderFailed("the compiler was ended from outside; is there too little memory?")
        if seconds_computed() - before > self.seconds or "CPU time limit exceeded" in said or ran.code == -signal.SIGXCPU:
            raise Uncompiled(f"it took more than {self.seconds:g} seconds")
        if ran.cut == "time":
            raise GraderFailed(f"the compiler came to no end in {Limits.clock * self.seconds:g} s by the clock, though it computed for less "
                               f"than {self.seconds:g} s; was the machine busy?")
        if ran.cut == "output":
            raise Uncompiled(f"it printed more than {limits.output // 1024} KB")
        if ran.code != 0 and ENDED_FROM_OUTSIDE.search(said):
            raise Doubtful("the compiler was ended from outside, twice, but not on the starter",
                           "the compiler was ended from outside; is there too little memory?")
        if ran.code != 0 and LACKS.search(said):
            raise Doubtful(said, f"the compiler does not work where it is confined: {said}")
        if ran.code != 0:
            raise Uncompiled(said)

    def _without_places(self, said):
        """What the compiler said, the same in every run and on every machine: a folder of this run's or machine's is no part of it, nor
        is the name that chance gave to a file of the compiler's own."""
        made = f"{self.place}/made/"
        said = re.sub(re.escape(made) + r"cc[0-9A-Za-z]{6}\.", "temporary.", said)
        for folder in (made, f"{self.place}/text/", f"{shared(self.toolchain, 'serve.o').parent}/"):
            said = said.replace(folder, "")
        return said

    def _headers(self):
        return _headers(self.toolchain, self.exercise, self.place / "text")

    def _write(self, name, text):
        file = self.place / "text" / name
        file.write_text(text, encoding="utf-8", newline="")
        file.chmod(0o644)


def why_foreign(files, toolchain, exercise, own, *more):
    """Which of these files a student's header, which lies in the folder `own`, may not make the compiler read; empty if none is. `more`:
    other folders with headers of the compiler."""
    allowed = [os.path.realpath(folder) for folder in (*HEADERS, *LIBRARIES, *_headers(toolchain, exercise, own), *more)]
    foreign = [file for file in files if not any(Path(os.path.realpath(file)).is_relative_to(folder) for folder in allowed)]
    return f"it includes {Path(foreign[0]).name}, which is no part of the chapters up to {exercise.chapter}" if foreign else ""


def _headers(toolchain, exercise, own):
    return (*toolchain.folders_of(exercise.chapter), *toolchain.system_folders, toolchain.common, toolchain.precompiled, own)


def _listed(dependencies):
    """The compiler's own list of what it has read. The file lies where the compiler may write, so it is looked at first."""
    status = os.lstat(dependencies)
    if not stat.S_ISREG(status.st_mode) or status.st_size > MEBIBYTE:
        raise Uncompiled("it includes more than can be listed")
    return dependencies_in(dependencies)


def _loaders():
    """What starts a program that uses libraries."""
    return tuple(glob.glob("/lib*/ld-*.so*"))


@functools.lru_cache
def _tools(compiler):
    """The compiler's own programs; one that lies outside of the system's folders may read what it was installed with."""
    found = [shutil.which(compiler)]
    for part in PARTS_OF_COMPILERS:
        asked = subprocess.run([compiler, f"-print-prog-name={part}"], stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False, env=environment())
        found.append(shutil.which(asked.stdout.decode().strip()))
    return tuple(os.path.realpath(each) for each in found if each)
