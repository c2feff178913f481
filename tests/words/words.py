#!/usr/bin/env python3
"""Spells the course's prose as the British do (hunspell and dictionary.txt), and finds the phrases that it does not use (phrases.tsv).

    words.py ROOT    reads the pages, the comments, and the strings with a blank in them; the exit code is 0 if nothing is found"""
import re
import subprocess
import sys
from pathlib import Path

here = Path(__file__).resolve().parent
skipped = re.compile(r"(build|work|third_party|\.git|tests/(words|scenes/corpus))/|(.*/)?node_modules/|.*(package-lock|search_words)\.json$|"
                     r"tests/book/search.test.mjs$")  # two of these hold what readers may type
in_code = r'#include[^\n]*|(?P<prose>//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)* (?:[^"\\\n]|\\.)*")|"(?:[^"\\\n]|\\.)*"'
in_script = in_code.replace("//[^\\n]*|/\\*.*?\\*/", '"""(?:[^\\\\]|\\\\.)*?"""|(?:(?<=\\s)|^)#[^\\n]*').removeprefix("#include[^\\n]*|")
kinds = {".md": None, **dict.fromkeys((".hpp", ".cpp", ".mjs", ".js", ".css"), in_code),
         **dict.fromkeys((".py", ".sh", ".cmake", ".gp", ".txt", ".in", ".json", ""), in_script)}
no_prose = re.compile(
    r"```.*?```|\\f\[.*?\\f\]|\\f\$.*?\\f\$|\\\(.*?\\\)|`[^`\n]*`|^\s*\[[\w ]+\]\s*$|\{\{(?!figure|player|table|fold|section)[^{}]*\}\}|"
    r"\{\{(?:figure|players?|table) [^|{}]*\||\{\{section.*?\}\}|\{#\w+\}|\]\([^)]*\)|https?://\S+|</?[a-z][^>]*>|"
    r"[@\\](?:param|tparam|throws|ref|subpage|page|file)\s+\S+|\\n|\\[a-z]+|%[-+0-9.]*l?[a-z]|&\w+;", re.S | re.M)
# No word: what touches a sign of code, a name in mixed letters, an abbreviation, and what has fewer than three letters.
word = re.compile(r"(?<![\w.$@/\\%:_·&#'’-])[A-Za-zÀ-ÿ][a-zà-ÿ]{2,}(?:['’][a-z]+)*(?![\w(/=]|::|\.[a-z])")


def blank(text):
    return re.sub(r"[^\n]", " ", text)


def prose_of(name, text):
    """The text with blanks in place of what nobody reads as English, so that every letter keeps its line."""
    pattern, kept, end = kinds[Path(name).suffix], "", 0
    for match in re.finditer(pattern, text, re.S | re.M) if pattern else ():
        kept += blank(text[end:match.start()]) + (re.sub(r'^[ \t]*(?:///?[!<]*|#+!?|\*)|"', lambda sign: blank(sign[0]), match[0], flags=re.M)
                                                  if match["prose"] else blank(match[0]))
        end = match.end()
    rest = blank(text[end:]) if pattern else re.sub(r"^(?: {4}|\t)[^\n]*", lambda set_off: blank(set_off[0]), text, flags=re.M)
    return no_prose.sub(lambda found: blank(found[0][:-1]) + "·", kept + rest)


def complaints(texts):
    """(file, line, what) of all that is misspelt and each phrase that stands there; `texts` holds files and their prose."""
    lines = (here / "dictionary.txt").read_text().splitlines()
    known = {each for line in lines if not line.startswith("#") for each in line.split()}
    words = [(file, prose.count("\n", 0, found.start()) + 1, re.sub(r"['’]s?$", "", found[0]).replace("’", "'"))
             for file, prose in texts for found in word.finditer(prose)]
    strange = {each for _, _, each in words} - known
    said = subprocess.run(["hunspell", "-d", "en_GB", "-i", "utf-8", "-l"], input="\n".join(sorted(strange)), text=True, capture_output=True, check=True)
    strange = {each for each in said.stdout.split() if each.lower() not in known}
    rows = [line.split("\t") for line in (here / "phrases.tsv").read_text().splitlines() if not line.startswith("#")]
    phrases = [(re.compile(row[0].replace(" ", r"\s+"), re.I), row[1]) for row in rows]
    yield from (each for each in words if each[2] in strange)
    yield from ((file, prose.count("\n", 0, found.start()) + 1, f'"{" ".join(found[0].split())}"; we write {instead}')
                for file, prose in texts for phrase, instead in phrases for found in phrase.finditer(prose))


control = {"page.md": "A torqe of `qcode` is square\nto the color.\n", "code.hpp": '#include <qx.hpp>\nint qy; // a remarc\nsay("one sentense", "qz");\n',
           "script.py": 'qa = "square to b"  # a coment\n'}
seen = [(line, what.split(";")[0]) for _, line, what in complaints([(name, prose_of(name, text)) for name, text in control.items()])]
if seen != [(1, "torqe"), (2, "color"), (2, "remarc"), (3, "sentense"), (1, "coment"), (1, '"square to"'), (2, '"color"'), (1, '"square to"')]:
    sys.exit(f"The checker itself is wrong: of its own examples it finds {seen}")
for row in (here / "phrases.tsv").read_text().splitlines():
    if not row.startswith("#") and not re.search(row.split("\t")[0].replace(" ", r"\s+"), row.split("\t")[2], re.I):
        sys.exit(f"This phrase doesn't find its own example: {row}")
root = Path(sys.argv[1])
files = [str(path.relative_to(root)) for path in sorted(root.rglob("*")) if path.is_file() and (path.suffix in kinds and path.suffix or path.name == "course")]
files = [name for name in files if not skipped.match(name) and not name.startswith(".")]
found = [f"{file}:{line}: {what}" for file, line, what in complaints([(name, prose_of(name, (root / name).read_text())) for name in files])]
print(f"{len(found)} places in {len(files)} files", *found, sep="\n")
sys.exit(1 if found else 0)
