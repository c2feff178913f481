#!/usr/bin/env python3
"""Where the library's headers call functions that each C library rounds in its own way: all such places are listed, with what
becomes of the number.

    library_functions.py SOURCES LIST

A line of LIST: tumble/damping.hpp: exp: what it is for. A place that is not listed is an error, and so is a line that names
none. The exact solutions are not looked at: all of them are made of such functions."""
import re
import sys
from pathlib import Path

# Those that IEEE 754 does not make round correctly, as it does roots and remainders.
functions = ("sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh hypot pow exp exp2 expm1 log log1p log2 log10 "
             "cbrt tgamma lgamma erf erfc").split()
call = re.compile(rf"(?<![\w.>:])(?:std::)?({'|'.join(functions)})\s*\(")
comment = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def calls_in(sources):
    found = set()
    for folder in ["common/tumble", *sorted(str(path.relative_to(sources)) for path in sources.glob("chapters/*/tumble"))]:
        for header in sorted((sources / folder).glob("*.hpp")):
            for function in call.findall(comment.sub("", header.read_text())):
                found.add((f"tumble/{header.name}", function))
    return found


def main():
    sources, path = Path(sys.argv[1]), Path(sys.argv[2])
    listed = {}
    for line in path.read_text().splitlines():
        header, function, purpose = line.split(": ", 2)
        listed[header, function] = purpose
    found = calls_in(sources)
    errors = [f"{header} calls {function}, which each library rounds in its own way, and {path.name} does not say what for"
              for header, function in sorted(found - listed.keys())]
    errors += [f"{path.name} names {function} in {header}, which does not call it" for header, function in sorted(listed.keys() - found)]
    print(*(f"error: {error}" for error in errors), sep="\n")
    print(f"{len(found)} places where the library's own numbers come from a library's functions")
    return 1 if errors or not found else 0


if __name__ == "__main__":
    sys.exit(main())
