"""What a program may reach of the files: what it is told, and nothing else. The rest is refused with "permission denied".

Linux has such a rule since 5.13 (Landlock). It needs no rights, and whatever the program starts or becomes keeps it.
"""

import ctypes
import os
import struct
import sys
from dataclasses import dataclass

CREATE, ADD, RESTRICT = 444, 445, 446  # the calls have the same numbers on every machine
ASK_VERSION, BENEATH = 1, 1
NO_NEW_PRIVILEGES = 38

EXECUTE, WRITE, READ, LIST = 1 << 0, 1 << 1, 1 << 2, 1 << 3
TRUNCATE = 1 << 14
OF_A_FILE = EXECUTE | WRITE | READ | TRUNCATE  # the others are of folders
DEVICE_NODES = 1 << 6 | 1 << 11
NETWORK, OTHERS = 0b11, 0b11  # TCP both ways; sockets by name and signals out of the confinement

_library = ctypes.CDLL(None, use_errno=True)


@dataclass(frozen=True)
class Reach:
    """Files, or folders with all that is in them. What is missing is left out."""
    readable: tuple = ()
    executable: tuple = ()
    writable: tuple = ()  # folders: what is in them may be read, made, changed and removed


def version():
    """What this kernel's Landlock can do, as its own number; 0 if there is none."""
    if not sys.platform.startswith("linux"):
        return 0
    return max(_library.syscall(CREATE, None, ctypes.c_size_t(0), ASK_VERSION), 0)


def restrict(reach):
    """Called in the new process, before its program begins. Does nothing where there is no Landlock."""
    known = version()
    if known == 0:
        return
    handled = _file_rights(known)
    rules = struct.pack("=QQQ", handled, NETWORK if known >= 4 else 0, OTHERS if known >= 6 else 0)
    rules = _checked(_library.syscall(CREATE, rules, ctypes.c_size_t(len(rules)), 0))
    for rights, names in ((READ | LIST, reach.readable), (READ | EXECUTE, reach.executable),
                          (handled & ~EXECUTE & ~DEVICE_NODES, reach.writable)):
        for name in names:
            _allow(rules, rights & handled, name)
    _checked(_library.prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0))
    _checked(_library.syscall(RESTRICT, rules, 0))
    os.close(rules)


def _file_rights(known):
    """All that this version can refuse: rights of files, then moving, then shortening, then orders to devices."""
    return (1 << (13 + (known >= 2) + (known >= 3) + (known >= 5))) - 1


def _allow(rules, rights, name):
    try:
        place = os.open(name, os.O_PATH | os.O_CLOEXEC)
    except (FileNotFoundError, NotADirectoryError, PermissionError):
        return  # what it can't get at need not be allowed
    if not os.path.isdir(name):
        rights &= OF_A_FILE
    _checked(_library.syscall(ADD, rules, BENEATH, struct.pack("=Qi", rights, place), 0))
    os.close(place)


def _checked(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), "the system does not let a program be confined")
    return result
