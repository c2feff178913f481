"""run.py TOOLS PATTERN: the tests in this folder whose file matches, with the tools where they find them."""

import sys
import unittest
from pathlib import Path

if __name__ == "__main__":
    here = Path(__file__).resolve().parent
    sys.dont_write_bytecode = True
    sys.path.insert(0, sys.argv[1])
    tests = unittest.TestLoader().discover(str(here), pattern=sys.argv[2], top_level_dir=str(here))
    if tests.countTestCases() == 0:
        raise SystemExit(f"no test is in a file called {sys.argv[2]}")
    result = unittest.TextTestRunner(verbosity=2).run(tests)
    raise SystemExit(not result.wasSuccessful())
