"""Ctrl-C while a command has hardly begun."""

import signal
import subprocess
import sys
import unittest
from pathlib import Path

import ctrl_c

ROOT = Path(ctrl_c.__file__).resolve().parents[2]

# Runs a command, and gives it Ctrl-C as soon as it asks for a module of that name.
INTERRUPTED = """
import os, runpy, signal, sys
class Finder:
    def find_spec(name, *_):
        if name == sys.argv[1]:
            os.kill(os.getpid(), signal.SIGINT)
signal.signal(signal.SIGINT, signal.default_int_handler)  # whoever started the test may ignore it
sys.modules.pop(sys.argv[1], None)
sys.meta_path.insert(0, Finder)
sys.path.insert(0, os.path.dirname(sys.argv[2]))
runpy.run_path(sys.argv[2], run_name="__main__")
"""


class CtrlC(unittest.TestCase):
    def test_it_ends_a_command_without_a_word(self):
        for tool in ("exercises/tools/student", "exercises/tools/grade", "exercises/tools/release", "exercises/tools/package",
                     "tools/sweep", "tools/measure"):
            with self.subTest(tool):
                done = subprocess.run([sys.executable, "-E", "-B", "-c", INTERRUPTED, "argparse", f"{ROOT / tool}.py"],
                                      stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
                self.assertEqual((done.returncode, done.stdout, done.stderr), (-signal.SIGINT, "", ""))
