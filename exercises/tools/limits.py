"""What a student's program may use: time, memory, files, output, processes."""

import math
import os
import resource
from dataclasses import dataclass

from sealed import seal

MEBIBYTE = 1 << 20


@dataclass(frozen=True)
class Limits:
    seconds: float = 2            # of computing, for one check; of the wall's clock, four times as many
    memory: int = 1024 * MEBIBYTE  # of address space
    file: int = 16 * MEBIBYTE     # the largest file that it may write
    output: int = MEBIBYTE        # what it may print
    processes: int = 0            # more than it has; 0: as many as it likes
    user: int = 0                 # whose rights it gets; 0: those of the caller
    sealed: bool = False          # whether it can only calculate, see sealed.py


def confine(limits):
    """Called in the new process before its program begins."""
    seconds = math.ceil(limits.seconds)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_AS, (limits.memory, limits.memory))
    resource.setrlimit(resource.RLIMIT_FSIZE, (limits.file, limits.file))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if limits.processes:
        resource.setrlimit(resource.RLIMIT_NPROC, (limits.processes, limits.processes))
    if limits.user:
        os.setgroups([])
        os.setgid(limits.user)
        os.setuid(limits.user)
    if limits.sealed:
        seal()
