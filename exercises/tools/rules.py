"""What the values of exercise.json must be. Each function returns the value or complains, naming it and the rule."""

import difflib
import json
import math
import re

from complaint import Complaint


def known_keys(what, said, required, optional=()):
    if not isinstance(said, dict):
        raise Complaint(f"{what} is {json.dumps(said)}; it must be an object")
    for key in said:
        if key not in required + optional:
            near = difflib.get_close_matches(key, required + optional, 1)
            raise Complaint(f'{what} has "{key}", which means nothing here' + (f"; is {near[0]} meant?" if near else ""))
    for key in required:
        if key not in said:
            raise Complaint(f"{what} lacks {key}")


def sentence(name, value):
    if not isinstance(value, str) or not value.strip() or "\n" in value:
        raise Complaint(f"{name} is {json.dumps(value)}; it must be a text in one line")
    return value


def sentences(name, value):
    if not isinstance(value, list) or not value:
        raise Complaint(f"{name} is {json.dumps(value)}; it must be a list of one or more texts")
    return tuple(sentence(f"an entry of {name}", each) for each in value)


def identifiers(name, value):
    for each in sentences(name, value):
        if not re.fullmatch(r"[a-z][a-z0-9_]*", each):
            raise Complaint(f'{name} has "{each}"; it must be small letters, digits and _')
    if len(set(value)) < len(value):
        raise Complaint(f"{name} is {json.dumps(value)}; each must stand there once")
    return tuple(value)


def whole_number(name, value, least, most):
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
        raise Complaint(f"{name} is {json.dumps(value)}; it must be a whole number from {least} to {most}")
    return value


def one_of(name, value, choices):
    if value not in choices:
        raise Complaint(f"{name} is {json.dumps(value)}; it must be one of {', '.join(choices)}")
    return value


def number(name, value):
    if not isinstance(value, (int, float)) or isinstance(value, bool) or not math.isfinite(value):
        raise Complaint(f"{name} is {json.dumps(value)}; it must be a finite number")
    return value


def step_within(name, usual, least, most, step):
    if not least <= usual <= most:
        raise Complaint(f"{name}: usual is {usual}; it must lie between least, {least}, and most, {most}")
    if not step > 0:
        raise Complaint(f"{name}: step is {step}; it must be greater than 0")
    for word, value in (("usual", usual), ("most", most)):
        steps = (value - least) / step
        if abs(steps - round(steps)) > 1e-9 * max(1, abs(steps)):
            raise Complaint(f"{name}: {word} is {value}; it must be a whole number of steps of {step} above {least}")
