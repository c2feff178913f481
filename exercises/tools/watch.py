"""Waits until a file is saved: told by the system where that is possible, else by looking at it again and again."""

import ctypes
import os
import select
import sys
import time

CLOSE_WRITE, MOVED_TO = 0x8, 0x80


def stamp_of(file):
    try:
        status = os.stat(file)
        return status.st_mtime_ns, status.st_size, status.st_ino
    except FileNotFoundError:
        return None


class Watch:
    """Tells when the file is another than at the last call; any way of saving it will do."""

    def __init__(self, file, polling=False):
        self.file, self.seen = file, stamp_of(file)
        self.descriptor = None if polling else _told_of(file.parent)

    def wait(self, seconds=None):
        """Returns True once the file has changed and is there, False after `seconds` without a change."""
        deadline = None if seconds is None else time.monotonic() + seconds
        while True:
            stamp = stamp_of(self.file)
            if stamp is not None and stamp != self.seen:
                self.seen = stamp
                return True
            remaining = None if deadline is None else deadline - time.monotonic()
            if remaining is not None and remaining <= 0:
                return False
            self._pause(remaining)

    def _pause(self, remaining):
        if self.descriptor is None:
            time.sleep(min(0.2, remaining if remaining is not None else 0.2))
        elif select.select([self.descriptor], [], [], min(2, remaining if remaining is not None else 2))[0]:
            os.read(self.descriptor, 1 << 16)

    def close(self):
        if self.descriptor is not None:
            os.close(self.descriptor)


def _told_of(folder):
    """A descriptor that can be read when something in the folder was written (Linux), or None."""
    if not sys.platform.startswith("linux"):
        return None
    try:
        library = ctypes.CDLL(None, use_errno=True)
        descriptor = library.inotify_init1(os.O_CLOEXEC)
        if descriptor < 0:
            return None
        if library.inotify_add_watch(descriptor, os.fsencode(folder), CLOSE_WRITE | MOVED_TO) < 0:
            os.close(descriptor)
            return None
        return descriptor
    except (OSError, AttributeError):
        return None
