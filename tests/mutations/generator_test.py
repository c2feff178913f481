#!/usr/bin/env python3
"""What the generator makes of C++, how it is switched, and how mutations by hand are. Compiles nothing."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import by_hand
import switches
from equal_list import lines_of, names_of, read_equal
from generator import Generator
from mutation_list import read_list
from source import read

here = Path(__file__).resolve().parent
root = here.parent.parent


def function(body):
    return f"template <class Real>\nReal f(Real a, Real b, int i) {{\n  {body}\n}}\n"


def made_of(text):
    """(kind, old, new) of each mutant."""
    return [(m.kind, text[m.start:m.end], m.replacement) for m in Generator("tumble/x.hpp", text, 1).everything()]


def switched(text):
    sites = {m.site: m.edits for m in Generator("tumble/x.hpp", text, 1).everything() if m.edits}
    return switches.switched(text, list(sites.items())).text


class Generated(unittest.TestCase):
    def test_each_kind_of_change_is_made_and_what_can_not_matter_is_not(self):
        for text, made in ((function("return 2 * a - b / 4;"), [("a sign", "-", "+"), ("a factor", "*", "/"), ("a constant", "2", "1"),
                                                                ("a factor", "/", "*"), ("a constant", "4", "5")]),
                           (function("b += h(a, b);"), [("a dropped statement", "b += h(a, b);", ";"), ("a sign", "+=", "-="),
                                                        ("a sign", "+=", "="), ("swapped arguments", "a, b", "b, a")]),
                           (function("static_assert(sizeof(Real) < 16 - 4);"), []), (function("std::array<Real, 3> v;"), []),
                           (function('throw Error("a" + text_of(a) + "b");'), [])):
            self.assertEqual(made_of(text), made, text)
        made = made_of(function("if (a < b && !g(i)) return 1;"))
        for one in (("a negated condition", "a < b && !g(i)", "!(a < b && !g(i))"), ("a dropped statement", "a < b && !g(i)", "false"),
                    ("a comparison", "<", "<="), ("and, or", "&&", "||"), ("a dropped negation", "!", "")):
            self.assertIn(one, made)


class Switched(unittest.TestCase):
    def test_an_expression_is_a_call_a_statement_an_if_and_what_may_change_something_is_called_once(self):
        self.assertIn("return ::tumble_mutants::minus(1, a , b);", switched(function("return a - b;")))
        self.assertIn("{ if (!::tumble_mutants::chosen(1)) step(); }", switched(function("step();")))
        self.assertIn("first_called(2, [&]() -> decltype(auto) { return ::tumble_mutants::kept(i); }, [&]() -> decltype(auto) { return ::tumble_mutants::kept(list.append(a)); })",
                      switched(function("came(i, list.append(a));")))

    def test_lines_stay_where_they_were(self):
        for path in [*root.glob("common/tumble/*.hpp"), *root.glob("chapters/*/tumble/*.hpp")]:
            text = path.read_text()
            self.assertEqual(switched(text).count("\n"), text.count("\n"), path)


class ByHand(unittest.TestCase):
    def edited(self, text, old, new):
        start = text.index(old)
        edits, _ = by_hand.edits_of(text, start, start + len(old), new, 7)
        return switches.switched(text, [("by hand", edits)]).text if edits else ""

    def test_a_statement_stands_there_twice(self):
        self.assertIn("{ if (::tumble_mutants::chosen(7)) { b += a; } else { b -= a; } }",
                      self.edited(function("b -= a;"), "-= a", "+= a"))

    def test_a_declaration_takes_along_what_follows(self):
        self.assertIn("{ if (::tumble_mutants::chosen(7)) { const Real c = b;   return c; } else { const Real c = a;\n  return c; } }",
                      self.edited(function("const Real c = a;\n  return c;"), "= a", "= b"))

    def test_a_type_can_not_be_switched(self):
        self.assertEqual(self.edited("struct A {\n  double x;\n};\n", "double", "float"), "")


class Lines(unittest.TestCase):
    def test_a_change_is_told_by_its_lines(self):
        text = "one(a,\n    b);\ntwo();\n"
        self.assertEqual(lines_of(text, 4, 12, "b, a"), ("one(a, b);", "one(b, a);"))

    def test_every_list_names_what_its_header_holds(self):
        folders = [root, root / "common", root / "exact", root / "tools/scene_reader", *root.glob("chapters/*")]
        for path in set(here.glob("*.txt")) - {here / "CMakeLists.txt", here / "not_switched.txt"}:
            for mutation in read_list(path):
                header = next(folder / mutation.header for folder in folders if (folder / mutation.header).exists())
                mutation.apply(header.read_text())  # or refuse

    def test_every_equal_mutant_is_one_that_is_made(self):
        made = set()
        for path in [*root.glob("*/tumble/*.hpp"), *root.glob("exact/tumble/exact/*.hpp"), *root.glob("chapters/*/tumble/*.hpp")]:
            text, name = path.read_text(), path.as_posix()[path.as_posix().index("/tumble/") + 1:]
            made |= {(name, *known) for m in Generator(name, text, 1).everything()
                     for known in names_of(m.kind, text, m.start, m.end, m.replacement)}
        self.assertEqual(set(read_equal((here / "equal").glob("*.txt"))) - made, set())

    def test_all_headers_can_be_read(self):
        for path in root.glob("chapters/*/tumble/*.hpp"):
            self.assertIsNotNone(read(path.read_text()), path)


if __name__ == "__main__":
    unittest.main()
