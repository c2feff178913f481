"""A student's own copies in work/, which git ignores: only they are edited, so no update of the course meets them."""

import hashlib
import os
import re
from datetime import datetime
from pathlib import Path

from complaint import Complaint
from outputs import write_whole


class Workplace:
    def __init__(self, root):
        self.folder = Path(root) / "work"

    def folder_of(self, exercise):
        return self.folder / exercise.path

    def header_of(self, exercise):
        return self.folder_of(exercise) / exercise.header

    def started(self, exercise):
        """An empty file holds nobody's work: it is what a full disk leaves. What bears the name and is no file is left alone."""
        header = self.header_of(exercise)
        return os.path.lexists(header) and not (header.is_file() and header.stat().st_size == 0)

    def start(self, exercise):
        """Copies the starter and the task. A copy that is there already is left as it is; says whether it made one."""
        folder = self.folder_of(exercise)
        folder.mkdir(parents=True, exist_ok=True)
        task = (exercise.folder / "task.md").read_text(encoding="utf-8")
        write_whole(folder / "task.md", with_parameters(task, exercise, self.parameters(exercise)).encode())
        if self.started(exercise):
            return False
        write_whole(self.header_of(exercise), (exercise.folder / exercise.header).read_bytes())
        return True

    def reset(self, exercise):
        """The starter again; returns the dated copy of what was there."""
        header = self.header_of(exercise)
        if not self.started(exercise):
            raise Complaint(f"{exercise.name} was not started, so there is nothing to reset")
        if not header.is_file():
            raise Complaint(f"{header} is no file, so no copy of it can be kept; remove it first")
        stamp = datetime.now().strftime("%Y-%m-%d_%H-%M-%S")
        backup = header.with_name(f"{exercise.name}.{stamp}.hpp")
        count = 1
        while backup.exists():
            count += 1
            backup = header.with_name(f"{exercise.name}.{stamp}_{count}.hpp")
        write_whole(backup, header.read_bytes())  # so that whatever fails, what was written is there
        write_whole(header, (exercise.folder / exercise.header).read_bytes())
        return backup

    @property
    def key(self):
        """The word from which this student's parameters are drawn; empty for the usual ones."""
        try:
            return (self.folder / "key").read_text(encoding="utf-8").strip()
        except FileNotFoundError:
            return ""

    def take_key(self, key):
        # A grader's keys hold the names of folders, such as autumn-Anna B and autumn-jo@web.de.
        if not key or not key.isprintable() or key != key.strip():
            raise Complaint(f'the key is "{key}"; it must be one line of signs that can be seen, without blanks at its ends')
        self.folder.mkdir(parents=True, exist_ok=True)
        write_whole(self.folder / "key", f"{key}\n".encode())

    def parameters(self, exercise):
        return drawn_parameters(exercise, self.key)


def drawn_parameters(exercise, key):
    """Each parameter's value for the student with this key: the same on every machine."""
    values = []
    for parameter in exercise.parameters:
        value = parameter.usual
        if key:
            seed = hashlib.sha256(f"{key} {exercise.path} {parameter.name}".encode("utf-8", "surrogateescape")).digest()
            steps = round((parameter.most - parameter.least) / parameter.step)
            value = parameter.least + int.from_bytes(seed[:8], "big") % (steps + 1) * parameter.step
        values.append((parameter.name, float(f"{value:.10g}")))
    return values


def with_parameters(task, exercise, values):
    """The task with every {{parameter NAME}} replaced by its value and unit."""
    units = {parameter.name: parameter.unit for parameter in exercise.parameters}
    shown = {name: f"{value:g} {units[name]}".strip() for name, value in values}

    def value_of(found):
        name = found.group(1)
        if name not in shown:
            raise Complaint(f"{exercise.folder / 'task.md'} names the parameter {name}, which exercise.json does not")
        return shown[name]

    filled = re.sub(r"\{\{parameter ([a-z0-9_]+)\}\}", value_of, task)
    if "{{" in filled:
        left = filled[filled.index("{{"):].partition("}}")[0] + "}}"
        raise Complaint(f"{exercise.folder / 'task.md'} holds {left!r}; what a student's number replaces is written "
                        "{{parameter NAME}}, on one line")
    return filled
