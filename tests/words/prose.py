"""Finds what a person reads in the files of the course: pages, comments, and sentences in strings.

A passage is a paragraph of a page, the comment lines that stand together, or a string that holds more than a word. Code,
formulas, directives and addresses within it are left out. Each letter keeps its line, so that a complaint can name it."""

import json
import pathlib
import re

FOLDERS = ("book", "chapters", "cmake", "common", "exact", "exercises", "solutions", "tests", "tools", ".")
SKIPPED = ("build/", "work/", "third_party/", ".git/", "tests/scenes/corpus/", "tests/words/", "node_modules/", "package-lock.json",
           "search_words.json", "tests/book/search.test.mjs")  # the last two hold what readers may type
SLASHES = {".hpp", ".cpp", ".h", ".mjs", ".js", ".css"}
HASHES = {".py", ".sh", ".cmake", ".gp", ".txt", ".in"}

# What a page holds beside prose. The order counts: what is set off goes first.
SET_OFF = r"(?m)^(?: {4}|\t).*$"
NOT_PROSE = [re.compile(pattern) for pattern in (
    r"(?s)```.*?```", r"(?s)\\f\[.*?\\f\]", r"(?s)\\f\$.*?\\f\$", r"(?s)\\\(.*?\\\)", r"`[^`]*`", r"(?m)^\s*\[[\w ]+\]\s*$",
    r"\{\{(?!figure|player|table|fold|section)[^{}]*\}\}", r"\{\{(?:figure|players?|table) [^|{}]*\|", r"\{\{section.*?\}\}",
    r"\{#\w+\}", r"\]\([^)]*\)", r"https?://\S+", r"</?[a-z][^>]*>", r"[@\\](?:param|tparam|throws|ref|subpage|page|file)\s+\S+",
    r"\\[a-z]+", r"\bf'", r"%[-+0-9.]*l?[a-z]", r"&\w+;")]
CODE_TOKEN = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)|R"(?P<mark>\w*)\((?P<raw>.*?)\)(?P=mark)"
    |"(?P<double>(?:[^"\\\n]|\\.)*)"|'(?P<single>(?:[^'\\\n]|\\.)*)'|(?P<skip>\#\s*include[^\n]*)""", re.S | re.X)
HASH_TOKEN = re.compile(r"""(?P<docstring>\"\"\"(?:[^\\]|\\.)*?\"\"\")|(?P<comment>(?:(?<=\s)|^)\#[^\n]*)
    |"(?P<double>(?:[^"\\\n]|\\.)*)"|'(?P<single>(?:[^'\\\n]|\\.)*)'""", re.S | re.X | re.M)


class Passage:
    """A text, and the line on which each of its letters stands."""

    def __init__(self, text: str, line: int):
        self.text = text
        self.first = line
        self.breaks = [place.start() for place in re.finditer("\n", text)]

    def line(self, offset: int) -> int:
        return self.first + sum(1 for place in self.breaks if place < offset)


def blanked(text: str, markdown: bool) -> str:
    """The text without what is no prose, letter by letter, so that lines stay; a dot marks where a formula or a name was."""
    for pattern in ([re.compile(SET_OFF)] if markdown else []) + NOT_PROSE:
        text = pattern.sub(lambda found: re.sub(r"[^\n]", " ", found[0][:-1]) + ("\n" if found[0][-1] == "\n" else "·"), text)
    return text


def paragraphs(text: str, line: int = 1) -> list:
    found, start = [], 0
    for gap in list(re.finditer(r"\n[ \t]*\n", text)) + [None]:
        end = gap.start() if gap else len(text)
        if text[start:end].strip():
            found.append(Passage(text[start:end], line + text.count("\n", 0, start)))
        start = gap.end() if gap else end
    return found


def is_sentence(text: str) -> bool:
    """Whether a string is one to read: some words with blanks between them."""
    return len(re.findall(r"(?:^|(?<=\s))[A-Za-z][a-z]+(?=$|[\s.,:;?!])", text)) > 1 and not re.match(r"[-/\w]+$", text)


def of_code(text: str, token: re.Pattern) -> list:
    """Comments whose lines stand together are one passage, and so are strings with nothing but blanks between them."""
    found, pending, kind, end = [], "", None, 0
    start = 0

    def close():
        if pending and (kind == "comment" or is_sentence(pending)):
            found.extend(paragraphs(blanked(pending, False), 1 + text.count("\n", 0, start)))

    for match in token.finditer(text):
        groups = match.groupdict()
        if groups.get("skip") or match.lastgroup is None:
            continue
        comment = groups.get("comment") or groups.get("docstring")
        string = next((groups[name] for name in ("raw", "double", "single") if groups.get(name) is not None), None)
        this = "comment" if comment else "string"
        if comment:
            piece = re.sub(r"^[ \t]*(?:///?[!<]?<?|#!?|/?\*+/?|\"\"\")|(?:\*/|\"\"\")$", lambda found: " " * len(found[0]),
                           comment, flags=re.M)
        else:
            piece = string.replace("\\n", "  ").replace('\\"', ' "').replace("\\'", "'")
        between = text[end:match.start()]
        if kind == this and not between.strip(" \t\n") and between.count("\n") <= 1 and (
                this == "string" or not groups.get("docstring")):
            pending += ("\n" if "\n" in between else " ") + piece
        else:
            close()
            pending, kind, start = piece, this, match.start()
        end = match.end()
    close()
    return found


def of_json(text: str) -> list:
    """The strings of a JSON file that are sentences."""
    found = []
    for match in re.finditer(r'"((?:[^"\\]|\\.)*)"', text):
        if is_sentence(match[1]):
            found.append(Passage(blanked(json.loads(match[0]).replace("\n", " "), False), 1 + text.count("\n", 0, match.start())))
    return found


def passages(path: pathlib.Path) -> list:
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        return paragraphs(blanked(text, True))
    if path.suffix == ".json":
        return of_json(text)
    if path.suffix in SLASHES:
        return of_code(text, CODE_TOKEN)
    return of_code(text, HASH_TOKEN)


def files(root: pathlib.Path) -> list:
    """Every file of the course that holds prose, without what is made and what a student wrote."""
    found = []
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root).as_posix()
        if any(name.startswith(skip) or f"/{skip}" in f"/{name}" for skip in SKIPPED) or name.startswith("."):
            continue
        if path.is_file() and (path.suffix in SLASHES | HASHES | {".md", ".json"} or name == "course"):
            found.append(path)
    return found
