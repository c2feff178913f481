"""Programs that a job runs, several at a time, and that end with it."""

import subprocess
import threading


class Running:
    """Starts programs, and ends those that run."""

    def __init__(self, what):
        self.what, self.running, self.lock, self.is_stopped = what, set(), threading.Lock(), False

    def run(self, words, **options):
        """What came of it: its exit code, and as text what it printed, where that is asked for, and what it complained of."""
        with self.lock:
            if self.is_stopped:
                raise RuntimeError(f"the {self.what} was stopped")
            process = subprocess.Popen(list(map(str, words)), stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **options)
            self.running.add(process)
        try:
            said, errors = process.communicate()
        finally:
            with self.lock:
                self.running.discard(process)
        return subprocess.CompletedProcess(process.args, process.returncode, said, errors)

    def stop(self):
        with self.lock:
            self.is_stopped = True
            ending = list(self.running)
        for process in ending:
            process.kill()
