"""All exercises, in the order in which they are meant to be done, and how one of them is found by a word."""

import difflib
from pathlib import Path

from complaint import Complaint
from exercise import DIFFICULTIES, read_exercise


def exercise_folders(root):
    return sorted(file.parent for file in Path(root).glob("exercises/[0-9][0-9]_*/*/exercise.json"))


def read_catalogue(root, private=None):
    """The course's exercises, and those of a private folder that is laid out as exercises/ is."""
    folders = exercise_folders(root)
    if private:
        found = sorted(file.parent for file in Path(private).glob("[0-9][0-9]_*/*/exercise.json"))
        if not found:
            raise Complaint(f"{private} holds no exercise; it must hold CHAPTER/NAME/exercise.json, CHAPTER being one of the course, such as "
                            "03_inertia/hammer/exercise.json")
        folders += found
    exercises = [read_exercise(folder) for folder in folders]
    names = [exercise.name for exercise in exercises]
    for exercise in exercises:
        if names.count(exercise.name) > 1:
            raise Complaint(f"two exercises are called {exercise.name}; each must have a name of its own")
    return sorted(exercises, key=lambda each: (each.chapter, DIFFICULTIES.index(each.difficulty), each.minutes, each.name))


def find(catalogue, word):
    """From hammer, 03_inertia/hammer, or the path of a file that belongs to it."""
    parts = Path(word).parts
    for exercise in catalogue:
        if word == exercise.name:
            return exercise
        for chapter, name in zip(parts, parts[1:]):
            if (chapter, name) == (exercise.chapter, exercise.name):
                return exercise
    names = [exercise.name for exercise in catalogue]
    near = difflib.get_close_matches(word, names, 1)
    raise Complaint(f"no exercise is called {word}" + (f"\nDid you mean {near[0]}?" if near else "") +
                    "\nThe exercises are: " + " ".join(names))


def find_all(catalogue, words):
    """Those of a list such as moon,no_lag, each of which may stand there once, in the catalogue's order; without a list, all."""
    if words is None:
        return catalogue
    found = [find(catalogue, word) for word in words.split(",")]
    for exercise in found:
        if found.count(exercise) > 1:
            raise Complaint(f"{exercise.name} stands twice in {words}; its points count once")
    return [exercise for exercise in catalogue if exercise in found]
