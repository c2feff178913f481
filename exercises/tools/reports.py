"""What a grader hands on: text for a person, JSON, JUnit's XML, Gradescope's results.json, and marks as CSV."""

import csv
import functools
import io
import json
import re
import textwrap
from xml.etree import ElementTree

from plain_text import all_plain, one_line


def _plain(write):
    """Whatever is handed on holds plain text alone, and names of one line."""
    return functools.wraps(write)(lambda results: write([
        {**all_plain(result), **{key: one_line(result[key]) for key in ("student", "submission")}} for result in results]))


@_plain
def text(results):
    lines = []
    for result in results:
        lines.append(f"{result['submission']}: {result['points']} of {result['of']} points")
        for exercise in result["exercises"]:
            points = sum(check["points"] for check in exercise["checks"])
            lines.append(f"  {exercise['exercise']}: {points} of {sum(check['of'] for check in exercise['checks'])}")
            if exercise["reason"]:
                lines += _quoted(exercise["reason"], "    ")
            for check in exercise["checks"] if not exercise["reason"] else []:
                sign = {"passed": "+", "not written yet": "."}.get(check["status"], "x")
                lines.append(f"    {sign} {check['sentence']}  {check['points']} of {check['of']}")
                lines += _quoted(_said_of(exercise, check), "        ")
            lines += [f"    ! look at it: it {flag}" for flag in exercise["flags"]]
    return "\n".join(lines)


@_plain
def as_json(results):
    told = ("submission", "student", "points", "of", "exercises")  # the time is another in each run
    return json.dumps([{key: result[key] for key in told} for result in results], indent=1, ensure_ascii=False)


@_plain
def junit(results):
    suites = ElementTree.Element("testsuites")
    for result in results:
        for exercise in result["exercises"]:
            failures = [check for check in exercise["checks"] if check["status"] != "passed"]
            of = f"{result['submission']}.{exercise['exercise']}"
            suite = ElementTree.SubElement(suites, "testsuite", name=of, tests=str(len(exercise["checks"])),
                                           failures=str(len(failures)), errors="0", skipped="0")
            for check in exercise["checks"]:
                # Whoever reads it may gather cases by class and name alone, whatever the suite.
                case = ElementTree.SubElement(suite, "testcase", classname=of.replace("/", "."), name=check["sentence"])
                if check["status"] != "passed":
                    said = _said_of(exercise, check)
                    ElementTree.SubElement(case, "failure", message=said, type=check["status"]).text = said
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(suites, encoding="unicode")


@_plain
def gradescope(results):
    """One submission, in the form that Gradescope publishes for results.json of an autograder."""
    result, = results
    tests = []
    for part, exercise in enumerate(result["exercises"], 1):
        for number, check in enumerate(exercise["checks"], 1):
            tests.append({"score": check["points"], "max_score": check["of"],
                          "status": "passed" if check["status"] == "passed" else "failed",
                          "name": f"{exercise['title']}: {check['sentence']}", "name_format": "text",
                          "number": f"{part}.{number}", "output": _said_of(exercise, check), "output_format": "text",
                          "tags": [exercise["exercise"]], "visibility": "visible"})
    flags = [f"{exercise['exercise']} {flag}" for exercise in result["exercises"] for flag in exercise["flags"]]
    return json.dumps({"score": result["points"], "execution_time": round(result["seconds"]), "output": "",
                       "visibility": "visible", "stdout_visibility": "hidden", "tests": tests,
                       "extra_data": {"flags": flags}}, indent=1, ensure_ascii=False)


@_plain
def marks(results):
    """student, submission, points, of, and the points of each exercise."""
    out = io.StringIO(newline="")
    table = csv.writer(out)
    columns = [exercise["exercise"] for result in results[:1] for exercise in result["exercises"]]
    table.writerow(["student", "submission", "points", "of", *columns, "to look at"])
    for result in results:
        points = {exercise["exercise"]: sum(check["points"] for check in exercise["checks"]) for exercise in result["exercises"]}
        flags = "; ".join(f"{exercise['exercise']} {flag}" for exercise in result["exercises"] for flag in exercise["flags"])
        names = [_of_one_cell(result[key]) for key in ("student", "submission")]
        table.writerow([*names, result["points"], result["of"], *(points[column] for column in columns), flags])
    return out.getvalue()


def _said_of(exercise, check):
    said = exercise["reason"] or check["message"]
    return f"not written yet: {said}" if check["status"] == "not written yet" else said


def _of_one_cell(name):
    """The name with escapes for a first letter by which a spreadsheet knows what it evaluates, some taking those of full width too, and for
    semicolons, at which some begin another column."""
    return re.sub(r"\A[=+@\-＝＋－＠]|;", lambda found: found[0].encode("unicode_escape").decode() if found[0] > "~"
                  else f"\\x{ord(found[0]):02x}", name)


def _quoted(said, indent):
    """Each line with a mark, for part of it may be a student's words or a compiler's, which could imitate a line of the report."""
    mark = f"{indent}| "
    return [line for part in said.splitlines() for line in textwrap.wrap(part, 100, initial_indent=mark, subsequent_indent=mark)]


FORMATS = {"text": text, "json": as_json, "junit": junit, "gradescope": gradescope}
