"""The table of PACKAGES.md and what tools/packages.sh installs are the same packages: python3 packages_test.py ROOT"""

import re
import sys
from pathlib import Path

ASKED_FOR_BY_HAND = {"git"}  # who releases a course has it already


def installed(text):
    """The packages in the lists of packages.sh, without the programs that stand in for them."""
    lists = re.findall(r'^\w+_packages="([^"]*)"', text, re.MULTILINE)
    return {entry.partition(":")[0] for words in lists for entry in words.split()}


def listed(text):
    """The first column of the table of packages, whose rows have a reason as well."""
    table = text.split("| package in Debian |")[1].split("\n\n")[0].splitlines()[2:]
    rows = [[cell.strip() for cell in row.strip("|").split("|")] for row in table]
    empty = [row[0] for row in rows if len(row) != 3 or not all(row)]
    if empty:
        sys.exit(f"PACKAGES.md: these rows lack what the package is for, or why it is the one: {', '.join(empty)}")
    return {name for row in rows for name in row[0].split(", ")}


def main():
    root = Path(sys.argv[1])
    of_script = installed((root / "tools/packages.sh").read_text(encoding="utf-8"))
    of_table = listed((root / "PACKAGES.md").read_text(encoding="utf-8")) - ASKED_FOR_BY_HAND
    if not of_script:
        sys.exit("tools/packages.sh lists no package")
    faults = [f"PACKAGES.md has no row for {name}, which ./course installs" for name in sorted(of_script - of_table)]
    faults += [f"PACKAGES.md lists {name}, which ./course does not install" for name in sorted(of_table - of_script)]
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
