"""Imported before all else by each command: until it says what Ctrl-C does, and after its work, Ctrl-C ends it without a word."""

import signal

if signal.getsignal(signal.SIGINT) == signal.default_int_handler:  # Python's own, which tells where in the program it came
    signal.signal(signal.SIGINT, signal.SIG_DFL)
