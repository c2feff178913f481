"""What a sweep asks for: the file that says so, and the combinations that it stands for."""

import hashlib
import itertools
import json
import math
import os
import sys
from pathlib import Path

from complaint import Complaint
from shards import Job

SCENES = Path(__file__).resolve().parent / "scenes"
MOST = 1000000  # combinations
LARGEST = 64 * 2**20  # bytes of the file; that many combinations need less
MOST_DIGITS = 1000  # of a whole number; the largest double has 309
LISTS = {"scenes": str, "methods": str, "schemes": str, "precisions": str, "time_steps": (int, float), "seeds": int}


def read_sweep(file):
    """The sweep in a file, with only keys that are known and lists of what belongs there."""
    try:
        sweep = json.loads(_bytes_of(file), object_pairs_hook=_unlike_keys, parse_int=_whole)
    except OSError as error:
        raise Complaint(f"{file} can't be read: {error.strerror}") from None
    except ValueError as error:
        raise Complaint(f"{file} is no JSON: {error}") from None
    except RecursionError:
        raise Complaint(f"{file} is no sweep: its lists and objects are nested too deeply") from None
    except Complaint as complaint:
        raise Complaint(f"{file}: {complaint}") from None
    if not isinstance(sweep, dict) or "scenes" not in sweep:
        raise Complaint(f'{file} must be an object of JSON with the key "scenes"')
    for key, value in sweep.items():
        if key in LISTS:
            _require_list(file, key, value)
        elif key == "until":
            _require_number(file, key, value)
        else:
            raise Complaint(f"{file}: {key} is no key of a sweep; there are {', '.join(LISTS)} and until")
    count = math.prod(len(sweep[key]) for key in LISTS if key in sweep)
    if count > MOST:
        raise Complaint(f"{file} stands for {count} combinations; at most {MOST} can be simulated")
    return sweep


def _bytes_of(file):
    """All of it; a device may have no end."""
    with open(file, "rb") as source:
        data = source.read(LARGEST + 1)
    if len(data) > LARGEST:
        raise Complaint(f"it is larger than {LARGEST // 2**20} MB")
    return data


def _whole(digits):
    if len(digits) > MOST_DIGITS:
        raise Complaint(f"the number {digits[:20]}... has {len(digits)} digits; at most {MOST_DIGITS} can be read")
    return int(digits)


def _unlike_keys(pairs):
    seen = {}
    for key, value in pairs:
        if key in seen:
            raise Complaint(f"the key {json.dumps(key, ensure_ascii=False)} stands there twice")
        seen[key] = value
    return seen


def _require_list(file, key, values):
    if not isinstance(values, list) or not values:
        raise Complaint(f"{file}: {key} must be a list with at least one element")
    if len(values) > MOST:
        raise Complaint(f"{file}: {key} has {len(values)} elements; at most {MOST} combinations can be simulated")
    seen = set()
    for value in values:
        if isinstance(value, bool) or not isinstance(value, LISTS[key]):
            raise Complaint(f"{file}: {_short(value)} stands in {key}, where it can't")
        if value in seen:
            raise Complaint(f"{file}: {_short(value)} stands in {key} twice")
        seen.add(value)
        if key in ("time_steps", "seeds"):
            _require_number(file, f"an element of {key}", value, least=0 if key == "seeds" else None)
    if key == "time_steps":
        _require_unlike_steps(file, values)


def _require_unlike_steps(file, values):
    """simulate rounds them to nanoseconds; of those that round to none it says what is wrong."""
    by_nanoseconds = {}
    for value in values:
        other = by_nanoseconds.setdefault(math.floor(float(value) * 1e9 + 0.5) if value <= 3600 else value, value)
        if other is not value:
            raise Complaint(f"{file}: {_short(other)} and {_short(value)} in time_steps are the same number of nanoseconds")


def _require_number(file, what, value, least=None):
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= sys.float_info.max
    if not is_number or not (value > 0 or value == least):
        raise Complaint(f"{file}: {what} is {_short(value)}; it must be a number greater than 0" + ("" if least is None else ", or 0"))


def _short(value):
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 80 else text[:77] + "..."


def find_scene(word, folder):
    shipped = SCENES / f"{word}.json"
    path = shipped if "/" not in word and os.path.isfile(shipped) else folder / word
    if os.path.isfile(path):  # also of what no file can be called
        return path.resolve()
    raise Complaint(f"no scene and no file is called {word}; looked for {shipped.name} among the scenes of the course, and in {folder}")


def is_random(path):
    try:
        bodies = json.loads(path.read_bytes())["bodies"]
        return any("many" in body for body in bodies)
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return False  # simulate says what is wrong with it


def combinations_of(sweep, folder):
    """The options of simulate for each combination, by a name that says which it is."""
    combinations = {}
    axes = [[(key, value) for value in sweep[key]] if key in sweep else [(key, None)] for key in LISTS]
    for cells in itertools.product(*axes):
        given = dict(cells)
        path = find_scene(given["scenes"], folder)
        if not is_random(path):
            given["seeds"] = None
        options = [path, "--threads", 1]
        for option, value in (("method", given["methods"]), ("scheme", given["schemes"]), ("precision", given["precisions"]),
                              ("dt", given["time_steps"]), ("seed", given["seeds"]), ("until", sweep.get("until"))):
            if value is not None:
                options += [f"--{option}", value if isinstance(value, str) else json.dumps(value)]
        name = " ".join(json.dumps(value, ensure_ascii=False) for value in given.values())
        combinations[name] = {"given": given, "options": options}
    return combinations


def job_of(sweep, folder, combinations):
    """What must be equal in all shards: the sweep and the bytes of its scenes."""
    scenes = {word: _hash_of(find_scene(word, folder)) for word in sweep["scenes"]}
    return Job({"sweep": sweep, "scenes": scenes}, list(combinations))


def _hash_of(file):
    try:
        return hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError as error:
        raise Complaint(f"{file} can't be read: {error.strerror}") from None
