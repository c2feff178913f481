"""Waits until a file is saved, in whatever way, by looking at it again and again: that works on every disk and system."""

import os
import time

PAUSE = 0.1  # seconds


class Watch:
    """Tells when the file is another than at the last call."""

    def __init__(self, file):
        self.file, self.seen = file, _stamp_of(file)

    def wait(self, seconds=float("inf")):
        """Returns True once the file has changed and is there, False after `seconds` without a change."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            stamp = _stamp_of(self.file)
            time.sleep(PAUSE)
            # An editor may be in the middle of writing: what counts has stayed for a pause.
            if stamp is not None and stamp != self.seen and stamp == _stamp_of(self.file):
                self.seen = stamp
                return True
        return False


def _stamp_of(file):
    try:
        status = os.stat(file)
        return status.st_mtime_ns, status.st_size, status.st_ino
    except FileNotFoundError:
        return None
