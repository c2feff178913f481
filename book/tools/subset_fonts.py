"""The fonts that come with the book, cut down to the letters that it has: python3 subset_fonts.py BOOK_FOLDER JOBS.json

JOBS.json is a list of {"from": a font, "to": its place in the book, "without": a font whose letters need not be in it, or null}.
Needs fonttools, and brotli for what browsers read, WOFF2.
"""

import json
import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter, load_font, save_font


def letters_of(folder):
    """All letters of its pages and scripts, and those of ASCII, which a reader may type."""
    letters = {chr(code) for code in range(0x20, 0x7F)}
    for file in folder.iterdir():
        if file.suffix in (".html", ".js"):
            letters |= set(file.read_text(encoding="utf-8"))
    return {ord(letter) for letter in letters if letter >= " "}


def has(file):
    return set(load_font(file, Options(), lazy=True).getBestCmap())


def main():
    folder = Path(sys.argv[1])
    letters = letters_of(folder)
    for job in json.loads(Path(sys.argv[2]).read_text(encoding="utf-8")):
        options = Options(flavor="woff2", layout_features=["kern", "mark", "mkmk", "ccmp", "tnum", "lnum"], hinting=False, notdef_outline=True, drop_tables=["DSIG"])
        font = load_font(job["from"], options)
        wanted = letters - (has(job["without"]) if job["without"] else set())
        subsetter = Subsetter(options=options)
        subsetter.populate(unicodes=wanted)
        subsetter.subset(font)
        target = folder / job["to"]
        target.parent.mkdir(parents=True, exist_ok=True)
        save_font(font, str(target), options)


if __name__ == "__main__":
    main()
