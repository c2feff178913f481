"""What a student's program, or the compiler that reads its text, may use: time, memory, files, output, processes."""

import ctypes
import math
import os
import resource
import signal
import sys
from dataclasses import dataclass, replace

from landlock import Reach, restrict
from sealed import seal

MEBIBYTE = 1 << 20
END_WITH_PARENT = 1  # an order to prctl


@dataclass(frozen=True)
class Limits:
    seconds: float = 5            # of computing, for one check
    clock: float = 4              # times as many by the clock, since others may use the machine as well
    memory: int = 1024 * MEBIBYTE  # of address space
    file: int = 16 * MEBIBYTE     # the largest file that it may write
    output: int = MEBIBYTE        # what it may print
    user: int = 0                 # whose rights it gets; 0: those of the caller
    user_of_judge: int = 0        # the same for the judge
    reach: Reach = None           # the files that it may use; None: all that its rights allow
    sealed: bool = False          # whether it can only calculate, see sealed.py

    def of_judge(self, program):
        """Those of the judge and of the solution's worker: the same but for more time and a user of their own, whom no submission has."""
        return replace(self.reaching(program), user=self.user_of_judge, seconds=4 * self.seconds)

    def reaching(self, program):
        """The same for a program that lies outside: it may read and execute itself."""
        if self.reach is None:
            return self
        return replace(self, reach=replace(self.reach, executable=(*self.reach.executable, program)))


def confine(limits, parent):
    """Called in the new process before its program begins; `parent` is the process with which it ends."""
    seconds = math.ceil(limits.seconds)
    _limit(resource.RLIMIT_CPU, seconds, seconds + 1)
    _limit(resource.RLIMIT_AS, limits.memory, limits.memory)
    _limit(resource.RLIMIT_FSIZE, limits.file, limits.file)
    _limit(resource.RLIMIT_CORE, 0, 0)
    if limits.user:
        os.setgroups([])
        os.setgid(limits.user)
        os.setuid(limits.user)
    end_with(parent)  # a change of user would undo it
    if limits.reach:
        restrict(limits.reach)
    if limits.sealed:
        seal()


def seconds_computed():
    """By the processes that were started and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _limit(kind, warned, ended):
    """No higher than the caller's own limit, above which the system lets nobody go but root."""
    most = resource.getrlimit(kind)[1]
    resource.setrlimit(kind, tuple(each if most == resource.RLIM_INFINITY else min(each, most) for each in (warned, ended)))


def end_with(parent, by=signal.SIGKILL):
    """This process gets the signal when `parent`, the one that started it, has ended in whatever way (Linux)."""
    if sys.platform.startswith("linux"):
        ctypes.CDLL(None).prctl(END_WITH_PARENT, int(by), 0, 0, 0)
        if os.getppid() != parent:
            os.kill(os.getpid(), by)
