"""What the book shows of the exercises, as JSON: for_the_book.py --root DIR.

Texts come with the file and line at which they begin, so that the book can say where a mistake stands. What a student's copy does not
hold, solutions and wrong answers, is null.
"""

import argparse
import json
import sys
from pathlib import Path

from catalogue import read_catalogue
from complaint import Complaint
from hints import read_hints
from starter import solution_without_marks
from workplace import drawn_parameters, with_parameters
from wrong_answers import read_wrong_answers


def described(root, exercise):
    solution = root / "solutions" / exercise.path
    wrong = root / "tests" / "exercises" / exercise.path
    return {
        "chapter": exercise.chapter, "name": exercise.name, "path": exercise.path, "title": exercise.title, "goals": exercise.goals,
        "prerequisites": [name for name in exercise.prerequisites if name != exercise.chapter],
        "minutes": exercise.minutes, "points": exercise.points, "difficulty": exercise.difficulty,
        "checks": [{"sentence": check.sentence, "points": check.points} for check in exercise.checks],
        "task": _task(root, exercise),
        "hints": [_part(root, exercise.folder / "hints.md", hint) for hint in read_hints(exercise.folder / "hints.md")],
        "starter": {"file": f"exercises/{exercise.path}/{exercise.header}",
                    "code": (exercise.folder / exercise.header).read_text(encoding="utf-8")},
        "solution": _solution(root, solution, exercise) if solution.exists() else None,
        "wrong": [{"name": each.name, "caught_by": each.caught_by, "message": each.message}
                  for each in read_wrong_answers(exercise, wrong, (solution / exercise.header).read_text(encoding="utf-8"))]
                 if solution.exists() and wrong.exists() else None,
    }


def _task(root, exercise):
    file = exercise.folder / "task.md"
    said = _without_title(file, f"# {exercise.title}")
    return _part(root, file, said, with_parameters(said, exercise, drawn_parameters(exercise, "")))


def _solution(root, folder, exercise):
    header, why = folder / exercise.header, folder / "why.md"
    return {"file": str(header.relative_to(root)),
            "code": solution_without_marks(header.read_text(encoding="utf-8"), str(header)),
            "why": _part(root, why, _without_title(why, "# Why"))}


def _without_title(file, title):
    first, _, rest = file.read_text(encoding="utf-8").partition("\n")
    if first.strip() != title:
        raise Complaint(f'{file}:1: the first line is "{first.strip()}"; it must be "{title}"')
    return rest.strip("\n").rstrip()


def _part(root, file, part, shown=None):
    """A part of a file as the book shows it, and where it stands."""
    text = file.read_text(encoding="utf-8")
    return {"text": shown or part, "file": str(file.relative_to(root)), "line": text[:text.index(part)].count("\n") + 1}


def main(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, required=True)
    root = parser.parse_args(words).root
    try:
        print(json.dumps([described(root, exercise) for exercise in read_catalogue(root)], ensure_ascii=False))
    except (Complaint, FileNotFoundError) as complaint:
        print(complaint, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
