"""How long to wait for a program, where the time in which the waiting one could not run itself does not count."""

import time

TICK = 0.25  # seconds between two questions how much is left


class Patience:
    """Seconds by the clock, of which a pause between two questions takes no more than two ticks. If a whole job is frozen and thawed, as
    Slurm does when it suspends one, and so does a container that is paused, then the program that is waited for was frozen as well."""

    def __init__(self, seconds):
        self.left, self.asked = seconds, time.monotonic()

    def remaining(self):
        """Seconds, or 0. To be asked once in a tick."""
        now = time.monotonic()
        self.left -= min(now - self.asked, 2 * TICK)
        self.asked = now
        return max(self.left, 0)

    def tick(self):
        """How long to wait until the next question."""
        return min(self.remaining(), TICK)
