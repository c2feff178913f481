"""The one place where text that is not ours becomes text to show: a student's, a compiler's, the name of a folder.

What plain() returns moves no cursor, changes no colour, hides nothing and turns no line round, and XML and JSON can hold it. The marks of
XML, JSON and CSV themselves are for their own writers (ElementTree, json, csv) to escape; nobody else writes them.
"""

import contextlib
import os
import re
import sys
import unicodedata

# Unicode's letters that show nothing, or a blank, and that Python nevertheless calls printable.
UNSEEN = re.compile("[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180d\u180f\u2800\u3164\ufe00-\ufe0f\uffa0\U000e0100-\U000e01ef]")


def plain(text):
    """Every letter that can't be seen as its escape, such as \\x1b; a blank of another width as a blank; lines and tabs as they are."""
    if _is_seen(text):
        return text
    return "".join(letter if letter in "\n\t" or _is_seen(letter) else " " if unicodedata.category(letter) == "Zs" else _escaped(letter)
                   for letter in text.replace("\r\n", "\n"))


def one_line(name):
    """The same for a name: on one line, and unlike what any other name becomes. Its own backslashes are doubled."""
    return "".join(f"\\u{ord(letter):04x}" if "\x80" <= letter <= "\xff" and not letter.isprintable() else
                   letter if letter != "\\" and _is_seen(letter) else _escaped(letter) for letter in name)


def _is_seen(text):
    return text.isprintable() and not UNSEEN.search(text)


def _escaped(letter):
    if "\udc80" <= letter <= "\udcff":  # Python's stand-in for a byte that is no UTF-8
        return f"\\x{ord(letter) - 0xdc00:02x}"
    return letter.encode("unicode_escape").decode("ascii")


def all_plain(value):
    """The same for every text in what JSON can hold."""
    if isinstance(value, str):
        return plain(value)
    if isinstance(value, dict):
        return {plain(key): all_plain(each) for key, each in value.items()}
    if isinstance(value, list):
        return [all_plain(each) for each in value]
    return value


def say(text="", to=None):
    """Prints it plain, and with escapes for what the terminal has no letters for; or not at all where the standard output is closed.
    What is said on the way, to the standard error, ends nothing where it can't be written, as to a log on a full disk."""
    to = to or sys.stdout
    if to is None:
        return
    letters = to.encoding or "utf-8"
    try:
        print(plain(str(text)).encode(letters, "backslashreplace").decode(letters), file=to, flush=True)
    except OSError:
        if to is not sys.stderr:
            raise
        _stop_writing_to(2)


def complain(complaint):
    say(f"course: {complaint}", to=sys.stderr)


def why_unheard(error):
    """The exit status after an OSError, which is told unless whoever read what is printed has read enough."""
    if isinstance(error, BrokenPipeError):
        status = 141
    else:
        complain(f"{error.filename2 or error.filename or 'what was to be written'}: {error.strerror}")  # of a copy, where it was to go
        status = 2
    _stop_writing_to(1)
    return status


def _stop_writing_to(number):
    """What Python still holds back would fail once more at the end, and give an exit status of its own."""
    with contextlib.suppress(OSError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), number)
