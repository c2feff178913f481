"""What is handed on, and the judge of Gradescope's format, which must find mistakes."""

import copy
import csv
import io
import json
import unittest
from xml.etree import ElementTree

from grade import counted
from gradescope_format import mistakes_in
from catalogue import find_all
from reports import gradescope, junit, marks, text
from test_texts import exercise

RESULT = {"student": "ada", "submission": "ada@1", "points": 2, "of": 6, "seconds": 1.6, "exercises": [
    {"exercise": "03_inertia/hammer", "title": "A hammer", "reason": "", "flags": ["opens files"], "checks": [
        {"sentence": "It is heavy", "points": 2, "of": 2, "status": "passed", "message": ""},
        {"sentence": "It is <long> & thin", "points": 0, "of": 1, "status": "failed", "message": "it is \x07 short"},
        {"sentence": "It flies", "points": 0, "of": 1, "status": "not written yet", "message": "the flight"}]},
    {"exercise": "01_force/moon", "title": "The Moon", "reason": "moon.hpp is empty", "flags": [], "checks": [
        {"sentence": "It falls", "points": 0, "of": 2, "status": "not run", "message": ""}]}]}


class Reports(unittest.TestCase):
    def test_gradescopes_fields_are_those_published(self):
        results = json.loads(gradescope([RESULT]))
        self.assertEqual(mistakes_in(results), [])
        self.assertEqual((results["score"], results["execution_time"]), (2, 2))
        self.assertEqual([test["output"] for test in results["tests"]],
                         ["", "it is \\x07 short", "not written yet: the flight", "moon.hpp is empty"])
        self.assertEqual(sum(test["max_score"] for test in results["tests"]), 6)
        self.assertEqual(results["extra_data"], {"flags": ["03_inertia/hammer opens files"]})

    def test_the_judge_of_that_format_finds_mistakes(self):
        sound = json.loads(gradescope([RESULT]))
        for change in (lambda results: results["tests"][0].update(status="ok"),
                       lambda results: results["tests"][0].update(visibility="public"),
                       lambda results: results["tests"][0].update(score=3),
                       lambda results: results["tests"][0].update(score="2"),
                       lambda results: results["tests"][0].update(tags=[1]),
                       lambda results: results["tests"][0].update(points=1),
                       lambda results: results.update(score=True),
                       lambda results: results.update(stdout_visibility="no"),
                       lambda results: (results.pop("score"), results.pop("tests"))):
            results = copy.deepcopy(sound)
            change(results)
            self.assertNotEqual(mistakes_in(results), [])

    def test_junit_counts_and_holds_no_letter_that_xml_forbids(self):
        suites = ElementTree.fromstring(junit([RESULT]))
        self.assertEqual([(suite.get("tests"), suite.get("failures")) for suite in suites], [("3", "2"), ("1", "1")])
        self.assertEqual([failure.get("message") for failure in suites.iter("failure")],
                         ["it is \\x07 short", "not written yet: the flight", "moon.hpp is empty"])

    def test_junit_names_the_submission_in_each_case_since_readers_gather_by_class(self):
        suites = ElementTree.fromstring(junit([RESULT]))
        self.assertEqual([case.get("classname") for case in suites.iter("testcase")],
                         ["ada@1.03_inertia.hammer"] * 3 + ["ada@1.01_force.moon"])

    def test_the_text_names_reasons_and_what_to_look_at(self):
        said = text([RESULT])
        for expected in ("ada@1: 2 of 6 points", "    | moon.hpp is empty", "! look at it: it opens files", "    x It is <long>", "    . It flies",
                         "        | not written yet: the flight"):
            self.assertIn(expected, said)

    def test_no_line_that_a_student_or_a_compiler_wrote_looks_like_one_of_the_report(self):
        ours = text([{**RESULT, "exercises": RESULT["exercises"][:1]}]).splitlines()
        forged = "\n".join(["it doesn't compile: moon.hpp:1: error:", *ours, "", *("x" * 99 + " " + line for line in ours)])
        moon = RESULT["exercises"][1]
        checked = {**moon, "reason": "", "checks": [{**moon["checks"][0], "status": "failed", "message": forged}]}
        for each in ({**moon, "reason": forged}, checked):
            lines = text([{**RESULT, "exercises": [each]}]).splitlines()
            quoted = [line for line in lines if line.lstrip().startswith("|")]
            self.assertGreater(len(quoted), 2 * len(ours))
            self.assertLessEqual(len(lines) - len(quoted), 3)  # the report's own

    def test_marks_stand_in_the_column_of_their_exercise(self):
        other = {**RESULT, "submission": "bob", "student": "bob", "exercises": RESULT["exercises"][::-1]}
        rows = list(csv.DictReader(io.StringIO(marks([RESULT, other]))))
        self.assertEqual([(row["03_inertia/hammer"], row["01_force/moon"]) for row in rows], [("2", "0")] * 2)

    def test_exercises_come_in_one_order_however_they_are_named(self):
        catalogue = [exercise(name=name) for name in ("moon", "slab", "hammer")]
        for words in ("slab,moon", "moon,slab"):
            self.assertEqual([each.name for each in find_all(catalogue, words)], ["moon", "slab"])

    def test_the_best_or_the_last_counts(self):
        results = [{"student": "ada", "submission": f"ada@{number}", "points": points} for number, points in ((3, 1), (1, 5), (2, 5))]
        self.assertEqual([result["submission"] for result in counted(results, "best")], ["ada@1"])
        self.assertEqual([result["submission"] for result in counted(results, "last")], ["ada@3"])
