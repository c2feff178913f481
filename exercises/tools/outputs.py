"""Files that a command writes: opened before its work begins, so that a mistake shows then; complete in the end, or as they were."""

import contextlib
import fcntl
import os
import stat
import sys
import tempfile

from complaint import Complaint


class Outputs(contextlib.ExitStack):
    """On leaving, what was opened and not written is as it was."""

    def __init__(self):
        super().__init__()
        self.places = {}

    def open(self, option, file):
        """Returns a function that takes the file's bytes."""
        place = os.path.realpath(file)
        if place in self.places:
            raise Complaint(f"{self.places[place]} and {option} both name {file}; one would overwrite the other")
        self.places[place] = option
        try:
            if os.path.exists(file) and not os.path.isfile(file):
                return self._special(option, file)  # a device or a pipe; of a folder the system says that it is one
            return self._regular(option, file, place)
        except OSError as error:
            raise _complaint(option, file, error) from None

    def _special(self, option, file):
        out = self.enter_context(open(file, "wb", buffering=0))

        def write(data):
            try:
                while data:
                    data = data[out.write(data):]
            except OSError as error:
                raise _complaint(option, file, error) from None
        return write

    def _regular(self, option, file, place):
        mode = _mode_of(place)
        descriptor, beside = tempfile.mkstemp(dir=os.path.dirname(place), prefix=".unfinished-")
        self.callback(_remove, beside)
        out = self.enter_context(open(descriptor, "wb"))
        os.chmod(beside, mode)

        def write(data):
            try:
                with out:
                    out.write(data)
                    out.flush()
                    os.fsync(out.fileno())
                os.replace(beside, place)
            except OSError as error:
                raise _complaint(option, file, error) from None
        return write


def occupy_standard_descriptors():
    """What is closed would be given to the first file that is opened, and what is printed would land in it. Nobody hears what is printed
    where it was closed: then sys.stdout is None. A shell that finds one closed may leave its own script there, open for reading."""
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        if not _is_open(number, to_write=number > 0):
            _replace(number)
            setattr(sys, name, None)
    if sys.stderr is None:
        sys.stderr = open(2, "w", encoding="utf-8", errors="backslashreplace", closefd=False)


def _is_open(number, to_write):
    try:
        how = fcntl.fcntl(number, fcntl.F_GETFL) & os.O_ACCMODE
    except OSError:
        return False
    return how != os.O_RDONLY or not to_write


def _replace(number):
    null = os.open(os.devnull, os.O_RDWR)
    if null != number:
        os.dup2(null, number)
        os.close(null)


def require_a_place_of_its_own(option, file, inputs):
    """Neither what is read, as (what it is, file), nor what the standard output goes to is overwritten, by whatever name."""
    place = os.path.realpath(file)
    try:
        known = os.stat(file)
    except FileNotFoundError:
        known = None
    except OSError as error:
        raise _complaint(option, file, error) from None
    for what, read in inputs:
        if place == os.path.realpath(read) or (known and os.path.exists(read) and os.path.samestat(known, os.stat(read))):
            raise Complaint(f"{option} is {file}; that is {what}, and it would be overwritten")
    if known and stat.S_ISREG(known.st_mode) and any(os.path.samestat(known, os.fstat(number)) for number in (1, 2)):
        raise Complaint(f"{option} is {file}; what is printed goes there already, and would be lost")


def write_whole(file, data):
    """All of it, or the file is as it was."""
    with Outputs() as outputs:
        outputs.open("", file)(data)


def _complaint(option, file, error):
    return Complaint(f"{option and option + ': '}{file} can't be written: {error.strerror}")


def _mode_of(place):
    """That of the file that is there, which must not be write-protected; else that of any new file."""
    if os.path.exists(place):
        with open(place, "ab"):
            return os.stat(place).st_mode & 0o777
    mask = os.umask(0o022)
    os.umask(mask)
    return 0o666 & ~mask


def _remove(file):
    with contextlib.suppress(FileNotFoundError):
        os.remove(file)
