"""What a student's program may ask of the system: what a calculation needs, and nothing else. The rest is refused with "not permitted",
also to sleep or to wait for others: it computes until it has answered or its time is over.

Linux alone has such a filter (seccomp). It needs no rights, and whatever the program becomes keeps it.
"""

import ctypes
import os
import platform
import signal
import struct
import sys

# By machine: the number that names its calls, and of each call its number.
CALLS = {
    "x86_64": (0xC000003E, dict(
        read=0, write=1, open=2, close=3, stat=4, fstat=5, lstat=6, lseek=8, mmap=9, mprotect=10, munmap=11, brk=12,
        rt_sigaction=13, rt_sigprocmask=14, rt_sigreturn=15, pread64=17, readv=19, writev=20, access=21, sched_yield=24, mremap=25,
        madvise=28, getpid=39, execve=59, exit=60, uname=63, fcntl=72, getcwd=79, readlink=89,
        gettimeofday=96, getrlimit=97, getrusage=98, sysinfo=99, times=100, getuid=102, getgid=104, geteuid=107, getegid=108,
        getppid=110, sigaltstack=131, arch_prctl=158, gettid=186, time=201, futex=202, sched_getaffinity=204, getdents64=217,
        set_tid_address=218, restart_syscall=219, clock_gettime=228, clock_getres=229, exit_group=231,
        tgkill=234, openat=257, newfstatat=262, readlinkat=267, faccessat=269, set_robust_list=273,
        getrandom=318, statx=332, rseq=334, close_range=436, faccessat2=439)),
    "aarch64": (0xC00000B7, dict(
        getcwd=17, fcntl=25, faccessat=48, openat=56, close=57, getdents64=61, lseek=62, read=63, write=64, readv=65, writev=66,
        pread64=67, readlinkat=78, newfstatat=79, fstat=80, exit=93, exit_group=94, set_tid_address=96, futex=98,
        set_robust_list=99, clock_gettime=113, clock_getres=114, sched_getaffinity=123,
        sched_yield=124, restart_syscall=128, tgkill=131, sigaltstack=132, rt_sigaction=134, rt_sigprocmask=135, rt_sigreturn=139,
        times=153, uname=160, getrlimit=163, getrusage=165, gettimeofday=169, getpid=172, getppid=173, getuid=174, geteuid=175,
        getgid=176, getegid=177, gettid=178, sysinfo=179, brk=214, munmap=215, mremap=216, execve=221, mmap=222, mprotect=226,
        madvise=233, getrandom=278, statx=291, rseq=293, close_range=436, faccessat2=439)),
}
# A file that is opened with one of these could be changed.
CHANGES = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND | 0o20000000  # the last: a file without a name

LOAD, EQUALS, EXCEEDS, HOLDS_ANY_OF, RETURN = 0x20, 0x15, 0x25, 0x45, 0x06
ALLOWED, REFUSED = 0x7FFF0000, 0x00050000 | 1  # EPERM
NUMBER, MACHINE, FIRST_ARGUMENT = 0, 4, 16     # where they stand in what the filter is shown
NO_NEW_PRIVILEGES, GET_SECCOMP, SET_SECCOMP, FILTER = 38, 21, 22, 2

_library = ctypes.CDLL(None, use_errno=True)


def can_seal():
    return (sys.platform.startswith("linux") and platform.machine() in CALLS and struct.calcsize("P") == 8 and
            _library.prctl(GET_SECCOMP, 0, 0, 0, 0) >= 0)


def seal():
    """Called in the new process, before its program begins."""
    if not can_seal():
        return
    steps = b"".join(struct.pack("=HBBI", *step) for step in _filter(*CALLS[platform.machine()], os.getpid()))
    text = ctypes.create_string_buffer(steps, len(steps))
    program = ctypes.create_string_buffer(struct.pack("@HP", len(steps) // 8, ctypes.addressof(text)))
    if _library.prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0) != 0 or _library.prctl(SET_SECCOMP, FILTER, program, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "the system does not let a program be sealed")


def _refusals(process):
    """Of calls that could do harm: which arguments, and when each is refused. The last word: whether that is when the test holds."""
    return {"open": [(1, HOLDS_ANY_OF, CHANGES, True)], "openat": [(2, HOLDS_ANY_OF, CHANGES, True)],
            "fcntl": [(1, EXCEEDS, 3, True)],  # beyond 3 are orders to send signals
            # It may end itself, as abort() does: neither as the system ends a program when memory runs out, nor stop itself.
            "tgkill": [(0, EQUALS, process, False), (2, EQUALS, int(signal.SIGABRT), False)]}


def _filter(machine, calls, process):
    """The filter's steps: what it does, how many steps to skip if so and if not, and a number."""
    refusals = _refusals(process)
    yield LOAD, 0, 0, MACHINE
    yield EQUALS, 1, 0, machine
    yield RETURN, 0, 0, REFUSED
    yield LOAD, 0, 0, NUMBER
    for name, number in calls.items():
        if name not in refusals:
            yield EQUALS, 0, 1, number
            yield RETURN, 0, 0, ALLOWED
            continue
        yield EQUALS, 0, 3 * len(refusals[name]) + 1, number
        for argument, test, value, refused_if in refusals[name]:
            yield LOAD, 0, 0, FIRST_ARGUMENT + 8 * argument
            yield test, int(not refused_if), int(refused_if), value
            yield RETURN, 0, 0, REFUSED
        yield RETURN, 0, 0, ALLOWED
    yield RETURN, 0, 0, REFUSED
