"""Gradescope's results.json, field by field, after the documentation of its autograders."""

VISIBILITIES = ("hidden", "after_due_date", "after_published", "visible")
FORMATS = ("text", "html", "simple_format", "md", "ansi")

NUMBER, TEXT = (int, float), str
WHOLE = {"score": NUMBER, "execution_time": NUMBER, "output": TEXT, "output_format": FORMATS, "test_output_format": FORMATS,
         "test_name_format": FORMATS, "visibility": VISIBILITIES, "stdout_visibility": VISIBILITIES, "extra_data": dict,
         "tests": list, "leaderboard": list}
TEST = {"score": NUMBER, "max_score": NUMBER, "status": ("passed", "failed"), "name": TEXT, "name_format": FORMATS, "number": TEXT,
        "output": TEXT, "output_format": FORMATS, "tags": list, "visibility": VISIBILITIES, "extra_data": dict}


def mistakes_in(results):
    mistakes = _mistakes("results", results, WHOLE)
    if "score" not in results and not results.get("tests"):
        mistakes.append("results has neither score nor tests")
    for test in results.get("tests", []):
        found = _mistakes("a test", test, TEST)
        mistakes += found
        if not found and test.get("score", 0) > test.get("max_score", 0):
            mistakes.append(f"a test has {test['score']} of {test['max_score']} points")
        if not all(isinstance(tag, str) for tag in test.get("tags", [])):
            mistakes.append(f"tags is {test['tags']}")
    return mistakes


def _mistakes(what, said, fields):
    mistakes = [f"{what} has {key}, which is not published" for key in said if key not in fields]
    for key, value in said.items():
        rule = fields.get(key)
        if isinstance(rule, tuple) and isinstance(rule[0], str):
            if value not in rule:
                mistakes.append(f"{what}: {key} is {value!r}; it must be one of {rule}")
        elif rule and (not isinstance(value, rule) or isinstance(value, bool)):
            mistakes.append(f"{what}: {key} is {value!r}")
    return mistakes
