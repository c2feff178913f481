"""What a program can reach that was told what to reach, and what not."""

import os
import socket
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import landlock
from landlock import Reach
from limits import Limits, confine

SYSTEM = ("/usr", "/lib", "/lib64", "/bin", "/etc/ld.so.cache", sys.base_prefix)
PARENT = os.getpid()


@unittest.skipUnless(landlock.version(), "this kernel has no Landlock")
class Reached(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("theirs", "mine", "shown"):
            (self.folder / name).mkdir()
            (self.folder / name / "file").write_text("as it was", encoding="utf-8")

    def run_confined(self, code):
        """The last line of what a Python says that may write in mine, read shown, and execute itself alone."""
        reach = Reach(readable=(*SYSTEM, str(self.folder / "shown"), str(self.folder / "missing")),
                      executable=(os.path.realpath(sys.executable), *map(str, Path("/").glob("lib*/ld-*.so*"))),
                      writable=(str(self.folder / "mine"),))
        result = subprocess.run([sys.executable, "-B", "-S", "-E", "-c", f"import os, socket\n{code}"], stdin=subprocess.DEVNULL,
                                capture_output=True, text=True, timeout=60, cwd=self.folder, check=False,
                                preexec_fn=lambda: confine(Limits(reach=reach), PARENT))
        return ((result.stdout + result.stderr).strip().splitlines() or ["nothing was refused"])[-1]

    def test_it_reads_what_it_is_shown_and_writes_what_is_its_own(self):
        self.assertEqual(self.run_confined("print(open('shown/file').read(), os.listdir('shown'))"), "as it was ['file']")
        self.assertEqual(self.run_confined("open('mine/new', 'w').write('x'); os.rename('mine/new', 'mine/file'); os.mkdir('mine/a')"),
                         "nothing was refused")

    def test_all_else_is_refused(self):
        refused = ["open('theirs/file')", "os.listdir('theirs')", "os.listdir('.')", "open('shown/file', 'a')", "os.remove('shown/file')",
                   "open('shown/new', 'w')", "os.mkdir('theirs/new')", "os.symlink('a', 'theirs/new')", "os.remove('theirs/file')",
                   "os.execv('/bin/sh', ['sh', '-c', 'echo executed'])", "open('/proc/self/environ')", "os.listdir('/proc')",
                   "os.mkfifo('theirs/pipe')", "os.rename('mine/file', 'shown/new')", "os.rename('theirs/file', 'mine/new')"]
        if landlock.version() >= 3:
            refused.append("os.truncate('shown/file', 0)")
        if landlock.version() >= 4:
            refused.append("socket.create_connection(('127.0.0.1', PORT))")
        if landlock.version() >= 6:
            refused.append(f"os.kill({os.getpid()}, 0)")
        with socket.create_server(("127.0.0.1", 0)) as server:
            for code in refused:
                with self.subTest(code):
                    said = self.run_confined(code.replace("PORT", str(server.getsockname()[1])))
                    self.assertRegex(said, r"^(PermissionError|OSError: \[Errno 18\])")
        for name in ("theirs", "shown"):
            self.assertEqual((self.folder / name / "file").read_text(encoding="utf-8"), "as it was")
