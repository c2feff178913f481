"""A submission: a folder with a student's headers, none of which is trusted."""

import errno
import os
import re
import stat
from dataclasses import dataclass, field
from pathlib import Path

from complaint import Complaint, GraderFailed
from plain_text import one_line

LARGEST = 256 * 1024  # bytes; the course's own solutions have two thousand
MOST_SEARCHED, DEEPEST_SEARCHED = 1000, 8  # files and folders; folders in each other
OF_THE_FILE = (errno.EACCES, errno.ENOTDIR, errno.ENOENT, errno.ELOOP)  # and not of the disk or the machine
BELOW = os.O_PATH | os.O_NOFOLLOW | os.O_CLOEXEC  # a folder to go on from

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
    (r"#\s*pragma\b(?!\s+once\b)", "gives the compiler orders"),
)


@dataclass(frozen=True)
class Header:
    """One header that was handed in; without text if it can't be judged, for the reason given."""
    text: str = ""
    reason: str = ""
    flags: list = field(default_factory=list)


def places_of_header(folder, exercise):
    """Where the header for an exercise may lie: in the folder itself, or below it in NAME/, CHAPTER/NAME/ or work/CHAPTER/NAME/."""
    return [folder / below / exercise.header for below in ("", exercise.name, exercise.path, f"work/{exercise.path}")]


def read_header(folder, exercise):
    """The header for an exercise, in the first of its places that is there."""
    for place in places_of_header(folder, exercise):
        if os.path.lexists(place):
            try:
                return _judged(_bytes_of(folder, place))
            except Complaint as complaint:
                return Header(reason=str(complaint))
            except OSError as error:
                if error.errno not in OF_THE_FILE:
                    raise GraderFailed(f"{place} can't be read: {error.strerror}") from None
                return Header(reason=f"{place.relative_to(folder)} can't be read: {error.strerror}")
    return Header(reason=f"{exercise.header} was not handed in{_but_elsewhere(folder, exercise)}")


def why_not_taken(file):
    """Why a grader would give nothing for a student's own copy, whatever the compiler makes of it; empty if it is taken. A link is
    followed, since what is handed in is what it leads to."""
    place = Path(os.path.realpath(file))
    try:
        reason = _judged(_bytes_of(place.parent, place)).reason
    except Complaint as complaint:
        return str(complaint)
    except OSError as error:
        return f"{file.name} can't be read: {error.strerror}"
    return f"{reason}; save {file.name} as UTF-8" if reason else ""


def _but_elsewhere(folder, exercise):
    """Where a file lies that may be meant: in another folder, in capitals, or numbered as browsers number what they fetch twice. A person
    has to decide; who hands in a thousand files is not searched for it."""
    left, found = MOST_SEARCHED, []
    for place, folders, files in os.walk(folder):
        left -= len(folders) + len(files)
        if left < 0:
            return ""
        if len(Path(place).relative_to(folder).parts) == DEEPEST_SEARCHED:
            folders.clear()
        found += [os.path.relpath(os.path.join(place, file), folder) for file in files
                  if re.sub(r" ?\([0-9]+\)\.", ".", file).lower() == exercise.header.lower()]
    return f"; {one_line(min(found))} may be meant, but has another name or place" if found else ""


def _bytes_of(folder, place):
    """The file's content. Neither the folder nor anything on the way from there may be a symbolic link, nor turn into one meanwhile."""
    way = place.relative_to(folder)
    above = os.open(folder, BELOW | os.O_DIRECTORY)
    try:
        for part in reversed(way.parents[:-1]):
            above, before = _opened(part, above, BELOW | os.O_DIRECTORY), above
            os.close(before)
        found = _opened(way, above, BELOW)
    finally:
        os.close(above)
    try:
        mode = os.fstat(found).st_mode
        if stat.S_ISLNK(mode):
            raise Complaint(f"{way} is a symbolic link; hand in the file itself")
        if not stat.S_ISREG(mode):
            raise Complaint(f"{place.name} is no file")
        # Whoever holds a lease on a file has it broken by this, and the file is opened when the system says so, 45 s later at most
        # by default. Nothing but a plain file is opened so: a pipe or a device may block for ever.
        with open(f"/proc/self/fd/{found}", "rb") as file:
            data = file.read(LARGEST + 1)
    finally:
        os.close(found)
    if len(data) > LARGEST:
        raise Complaint(f"{place.name} is larger than {LARGEST // 1024} KB")
    if not data.strip():
        raise Complaint(f"{place.name} is empty")
    return data


def _opened(way, above, how):
    """The last part of a way, in a folder that is open."""
    try:
        return os.open(way.name, how, dir_fd=above)
    except OSError:
        if stat.S_ISLNK(os.stat(way.name, dir_fd=above, follow_symlinks=False).st_mode):
            raise Complaint(f"{way} is a symbolic link; hand in the file itself") from None
        raise


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
    """The submission's name: that of the folder as it was given; that of the folder it is, for . and .. alone."""
    return folder.name if folder.name not in ("", "..") else folder.resolve().name


def student_of(submission):
    """Submissions called ada@1 and ada@2026-03-01 are two of ada's; what else follows an @ belongs to the name, as in an address."""
    return re.fullmatch(r"(.+?)(?:@[0-9][0-9-]*)?", submission, re.DOTALL)[1]


def when_submitted(submission):
    """Compares as a student's submissions follow each other: the numbers after the @ count, as of ada@9 and ada@10, and ada comes first."""
    return [int(number) for number in re.findall("[0-9]+", submission[len(student_of(submission)):])], submission


def places_of(folders):
    """Where each submission lies, by its name. Who can make a link among the submissions must not choose by it what is graded."""
    places, given = {}, {}
    for folder in folders:
        if folder.is_symlink():
            raise Complaint(f"{one_line(str(folder))} is a symbolic link; hand on the folder itself to which it leads")
        if not folder.is_dir():
            raise Complaint(f"{one_line(str(folder))} is no folder; a submission is a folder that holds a student's headers")
        name = name_of(folder)
        if name in given:
            raise Complaint(f"two submissions are called {one_line(name)}: {one_line(str(given[name]))} and {one_line(str(folder))}; "
                            "the name of the folder names the student")
        places[name], given[name] = folder.resolve(), folder
    return places
