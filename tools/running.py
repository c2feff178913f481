"""Programs that a job runs, several at a time, and that end with it, however it ends."""

import os
import subprocess
import threading
from concurrent.futures import ThreadPoolExecutor, wait

from limits import end_with


class Running:
    """Starts programs, and ends those that run."""

    def __init__(self, what):
        self.what, self.running, self.lock, self.is_stopped = what, set(), threading.Lock(), False

    def run(self, words, **options):
        """What came of it: its exit code, and as text what it printed, where that is asked for, and what it complained of."""
        parent = os.getpid()
        with self.lock:
            if self.is_stopped:
                raise RuntimeError(f"the {self.what} was stopped")
            process = subprocess.Popen(list(map(str, words)), stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                       preexec_fn=lambda: end_with(parent), **options)
            self.running.add(process)
        try:
            said, errors = process.communicate()
        finally:
            with self.lock:
                self.running.discard(process)
        return subprocess.CompletedProcess(process.args, process.returncode, said, errors)

    def apart(self, work, *arguments, **options):
        """What the work returns. Another thread does it, for the main one gets the signals, and what they raise while it starts a program
        is lost."""
        with ThreadPoolExecutor(1) as pool:
            try:
                future = pool.submit(work, *arguments, **options)
                while not wait([future], timeout=1).done:  # a signal just before it waits is noticed only afterwards
                    pass
            except BaseException:
                self.stop()
                raise
            return future.result()

    def stop(self):
        with self.lock:
            self.is_stopped = True
            ending = list(self.running)
        for process in ending:
            process.kill()
