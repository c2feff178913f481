"""A submission: a folder with a student's headers, none of which is trusted."""

import os
import re
import stat
from dataclasses import dataclass, field

from complaint import Complaint
from plain_text import one_line

LARGEST = 256 * 1024  # bytes; the course's own solutions have two thousand

# What no exercise needs. It costs no points; a person should look at it.
SUSPICIOUS = (
    (r"\b(?:fork|vfork|clone|execl|execv|execve|execvp|system|popen|posix_spawn)\s*\(", "starts another program"),
    (r"\b(?:socket|connect|dlopen|ptrace|mmap|syscall|kill)\s*\(", "calls the system"),
    (r"\b(?:fopen|freopen|fdopen|mkstemp|tmpfile|ofstream|ifstream|fstream|filesystem)\b", "opens files"),
    (r"\b(?:write|dup|dup2)\s*\(", "writes past the language's own output"),
    (r"\b(?:exit|_exit|_Exit|quick_exit|abort|atexit|signal|longjmp)\s*\(", "ends the program or catches its end"),
    (r"\b(?:__)?asm(?:__)?\b|incbin", "holds assembly"),
    (r"__attribute__\s*\(\([^()]*(?:constructor|destructor)", "runs before or after main"),
    (r"/proc/|/dev/|/etc/", "names a file of the system"),
    (r"#\s*define\s+(?:main|return|if|while|for|double|float|TEST_CASE|CHECK|EXERCISE_\w+|template|private|public)\b",
     "redefines what belongs to the language or to the checks"),
    (r"\btumble::exercise::(?!todo)|exercise/(?:judge|answers|wire)", "meddles with the exercises' own code"),
    (r"#\s*pragma\s+(?!once)", "gives the compiler orders"),
)


@dataclass(frozen=True)
class Header:
    """One header that was handed in; without text if it can't be judged, for the reason given."""
    text: str = ""
    reason: str = ""
    flags: list = field(default_factory=list)


def read_header(folder, exercise):
    """The header for an exercise: in the folder itself, or below it in NAME/, CHAPTER/NAME/ or work/CHAPTER/NAME/."""
    for below in ("", exercise.name, exercise.path, f"work/{exercise.path}"):
        place = folder / below / exercise.header
        if os.path.lexists(place):
            try:
                return _judged(_bytes_of(folder, place))
            except (Complaint, OSError) as error:
                return Header(reason=str(error))
    return Header(reason=f"{exercise.header} was not handed in")


def _bytes_of(folder, place):
    """The file's content. Nothing on the way to it may be a symbolic link."""
    way = folder
    for part in place.relative_to(folder).parts:
        way = way / part
        if way.is_symlink():
            raise Complaint(f"{way.relative_to(folder)} is a symbolic link; hand in the file itself")
    descriptor = os.open(place, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        os.close(descriptor)
        raise Complaint(f"{place.name} is no file")
    with open(descriptor, "rb") as file:
        data = file.read(LARGEST + 1)
    if len(data) > LARGEST:
        raise Complaint(f"{place.name} is larger than {LARGEST // 1024} KB")
    if not data.strip():
        raise Complaint(f"{place.name} is empty")
    return data


def _judged(data):
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        return Header(reason=f"the header is not UTF-8: byte {error.start} is {data[error.start]:#04x}")
    if "\0" in text:
        return Header(reason="the header holds a zero byte, so it is no text")
    bare = _bare(text)
    return Header(text=text, flags=[sentence for pattern, sentence in SUSPICIOUS if re.search(pattern, bare)])


def _bare(text):
    """Without comments and without line ends that don't count. It is for the eye: whoever wants to can hide from it."""
    text = re.sub(r"\\[ \t]*\r?\n", "", text)
    return re.sub(r'//[^\n]*|/\*.*?(?:\*/|\Z)|("(?:\\.|[^"\\\n])*"?)', lambda found: found.group(1) or " ", text, flags=re.DOTALL)


def name_of(folder):
    """The submission's name: that of the folder as it was given, wherever it leads; that of the folder it is, for . and .. alone."""
    return folder.name if folder.name not in ("", "..") else folder.resolve().name


def student_of(submission):
    """Submissions called ada@1 and ada@2026-03-01 are two of ada's; what else follows an @ belongs to the name, as in an address."""
    return re.fullmatch(r"(.+?)(?:@[0-9][0-9-]*)?", submission, re.DOTALL)[1]


def require_folders(folders):
    seen = {}
    for folder in folders:
        if not folder.is_dir():
            raise Complaint(f"{one_line(str(folder))} is no folder; a submission is a folder that holds a student's headers")
        name = name_of(folder)
        if name in seen:
            raise Complaint(f"two submissions are called {one_line(name)}: {one_line(str(seen[name]))} and {one_line(str(folder))}; "
                            "the name of the folder names the student")
        seen[name] = folder
