"""without_landlock.py COMMAND...: runs it as on a kernel that has no Landlock."""

import ctypes
import errno
import os
import struct
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "exercises/tools"))
from sealed import EQUALS, FILTER, LOAD, NO_NEW_PRIVILEGES, NUMBER, RETURN, SET_SECCOMP, ALLOWED

LACKING = 0x00050000 | errno.ENOSYS


def take_away():
    steps = [(LOAD, 0, 0, NUMBER)]
    for call in (444, 445, 446):
        steps += [(EQUALS, 0, 1, call), (RETURN, 0, 0, LACKING)]
    steps.append((RETURN, 0, 0, ALLOWED))
    packed = b"".join(struct.pack("=HBBI", *step) for step in steps)
    text = ctypes.create_string_buffer(packed, len(packed))
    program = ctypes.create_string_buffer(struct.pack("@HP", len(steps), ctypes.addressof(text)))
    library = ctypes.CDLL(None, use_errno=True)
    if library.prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0) != 0 or library.prctl(SET_SECCOMP, FILTER, program, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "the filter was refused")


if __name__ == "__main__":
    take_away()
    os.execv(sys.argv[1], sys.argv[1:])
