#!/usr/bin/env python3
"""Reads the course's prose as an editor would who knows spelling and a list of phrases, and nothing else.

  words.py spelling ROOT   every word is English as the British spell it (hunspell), or stands in dictionary.txt
  words.py phrases ROOT    no phrase of phrases.tsv stands anywhere"""

import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import prose  # noqa: E402

HERE = pathlib.Path(__file__).parent
# No word: what touches a sign of code, a name in mixed letters, an abbreviation, and what has fewer than three letters.
WORD = re.compile(r"(?<![\w.$@/\\%:_·&#'’])[A-Za-zÀ-ÿ]{3,}(?:['’][a-z]+)*(?![\w(/=]|::|\.[a-z])")


def words(passage) -> list:
    """The words of a passage, each with its line."""
    return [(re.sub(r"['’]s?$", "", found[0]).replace("’", "'"), passage.line(found.start())) for found in WORD.finditer(passage.text)
            if not re.search(r"[a-z][A-Z]", found[0]) and not found[0].isupper()]


def dictionary(text: str) -> dict:
    """Of each word the files in which it may stand: a path's beginning, empty for all."""
    rows = [line.split("\t") for line in text.splitlines() if line and not line.startswith("#")]
    return {row[0]: row[1] if len(row) > 1 else "" for row in rows}


def unknown(candidates: set) -> set:
    """Those that hunspell does not know."""
    said = subprocess.run(["hunspell", "-d", "en_GB", "-i", "utf-8", "-l"], input="\n".join(sorted(candidates)) + "\n",
                          text=True, capture_output=True, check=False, encoding="utf-8")
    if said.returncode != 0 or "Can't open" in said.stderr:
        sys.exit(f"hunspell does not run: {said.stderr.strip()}")
    return set(said.stdout.split())


def misspelt(texts: list, known: dict) -> list:
    """(file, line, word) of each word that neither hunspell nor the dictionary knows; `texts` holds (file, passages)."""
    found = [(file, line, word) for file, passages in texts for passage in passages for word, line in words(passage)
             if not any(file.startswith(known[each]) for each in (word, word.lower()) if each in known)]
    strange = unknown({word for _, _, word in found})
    return [each for each in found if each[2] in strange]


def phrases(text: str) -> list:
    """(pattern, what is written instead) of each line."""
    rows = [line.split("\t") for line in text.splitlines() if line and not line.startswith("#")]
    return [(re.compile(row[0].replace(" ", r"\s+"), re.I), row[1]) for row in rows]


def unwanted(texts: list, listed: list) -> list:
    """(file, line, phrase, instead) of each phrase that stands in a text, over the ends of lines too."""
    found = []
    for file, passages in texts:
        for passage in passages:
            for pattern, instead in listed:
                found += [(file, passage.line(place.start()), " ".join(place[0].split()), instead)
                          for place in pattern.finditer(passage.text)]
    return found


def main(task: str, root: str) -> int:
    texts = [(path.relative_to(root).as_posix(), prose.passages(path)) for path in prose.files(pathlib.Path(root))]
    if task == "spelling":
        complaints = [f"{file}:{line}: {word}" for file, line, word in
                      misspelt(texts, dictionary((HERE / "dictionary.txt").read_text(encoding="utf-8")))]
        rule = "Each is misspelt, or is missing in tests/words/dictionary.txt."
    else:
        complaints = [f'{file}:{line}: "{phrase}"; we write {instead}' for file, line, phrase, instead in
                      unwanted(texts, phrases((HERE / "phrases.tsv").read_text(encoding="utf-8")))]
        rule = "The list and its reasons: tests/words/phrases.tsv, and English in CONTRIBUTING.md."
    print(f"{len(complaints)} places in {sum(len(passages) for _, passages in texts)} passages of {len(texts)} files.")
    if complaints:
        print("\n".join([rule] + complaints))
    return 1 if complaints else 0


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("spelling", "phrases"):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
