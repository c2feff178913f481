#!/usr/bin/env python3
"""What the generator makes of C++, how it is switched, and how mutations by hand are. Compiles nothing."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import by_hand
import switches
from equal_list import lines_of
from generator import Generator
from source import read

root = Path(__file__).parent.parent.parent


def function(body):
    return f"template <class Real>\nReal f(Real a, Real b, int i) {{\n  {body}\n}}\n"


def made_of(text):
    """(kind, old, new) of each mutant."""
    return [(m.kind, text[m.start:m.end], m.replacement) for m in Generator("tumble/x.hpp", text, 1).everything()]


def switched(text):
    sites = {m.site: m.edits for m in Generator("tumble/x.hpp", text, 1).everything() if m.edits}
    return switches.switched(text, list(sites.items())).text


class Generated(unittest.TestCase):
    def test_signs_factors_and_constants(self):
        made = made_of(function("return 2 * a - b / 4;"))
        self.assertEqual(made, [("a sign", "-", "+"), ("a factor", "*", "/"), ("a constant", "2", "1"), ("a factor", "/", "*"),
                                ("a constant", "4", "5")])

    def test_conditions_and_what_hangs_on_them(self):
        made = made_of(function("if (a < b && !g(i)) return 1;"))
        self.assertIn(("a negated condition", "a < b && !g(i)", "!(a < b && !g(i))"), made)
        self.assertIn(("a dropped statement", "a < b && !g(i)", "false"), made)
        self.assertIn(("a comparison", "<", "<="), made)
        self.assertIn(("and, or", "&&", "||"), made)
        self.assertIn(("a dropped negation", "!", ""), made)

    def test_statements_sums_and_arguments(self):
        made = made_of(function("b += h(a, b);"))
        self.assertEqual(made, [("a dropped statement", "b += h(a, b);", ";"), ("a sign", "+=", "-="), ("a sign", "+=", "="),
                                ("swapped arguments", "a, b", "b, a")])

    def test_types_sentences_and_what_is_asked_of_a_type_stay(self):
        for text in (function("static_assert(sizeof(Real) < 16 - 4);"), function('throw Error("a" + text_of(a) + "b");'),
                     function("std::array<Real, 3> v;"), "using Row = std::array<int, 4 * 2>;\n",
                     "template <class T>\nconcept Small = sizeof(T) <= 8 && T::ok;\n"):
            self.assertEqual(made_of(text), [], text)

    def test_bodies_of_lambdas_are_read_and_pure_functions_are_not(self):
        self.assertIn(("a sign", "-", "+"), made_of(function("const auto g = [&](int k) { return a - k; };")))
        self.assertEqual(made_of("struct A {\n  virtual int f() const = 0;\n  ~A() = default;\n};\n"), [])

    def test_a_constant_of_the_compiler_has_no_switch(self):
        mutants = Generator("tumble/x.hpp", "constexpr int n = 3;\n", 1).everything()
        self.assertEqual([(m.replacement, m.edits) for m in mutants], [("4", [])])


class Switched(unittest.TestCase):
    def test_an_expression_is_a_call_and_a_statement_an_if(self):
        self.assertIn("return ::tumble_mutants::minus(1, a , b);", switched(function("return a - b;")))
        self.assertIn("{ if (!::tumble_mutants::chosen(1)) step(); }", switched(function("step();")))

    def test_what_may_change_something_is_called_once(self):
        text = switched(function("came(i, list.append(a));"))
        self.assertIn("first_called(2, [&]() -> decltype(auto) { return (i); }, [&]() -> decltype(auto) { return (list.append(a)); })", text)
        self.assertIn("first_called(2, ", switched(function("cut(std::unique(i), a);")))
        self.assertIn("first_of(2, i, list.size())", switched(function("came(i, list.size());")))

    def test_lines_stay_where_they_were(self):
        for path in [*root.glob("common/tumble/*.hpp"), *root.glob("chapters/*/tumble/*.hpp")]:
            text = path.read_text()
            self.assertEqual(switched(text).count("\n"), text.count("\n"), path)

    def test_a_complaint_is_about_the_narrowest_place(self):
        text = function("return a - b * a;")
        sites = {m.site: m.edits for m in Generator("tumble/x.hpp", text, 1).everything()}
        header = switches.switched(text, list(sites.items()))
        row = header.text.split("\n")[2]
        self.assertEqual(switches.blamed(header, 3, row.index("b , a") + 1), {2})
        stderr = "/m/tumble/x.hpp:3:9: error: no\n"
        self.assertEqual(switches.complaints(stderr, "/m"), [[("tumble/x.hpp", 3, 9)]])


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

    def test_all_headers_can_be_read(self):
        for path in root.glob("chapters/*/tumble/*.hpp"):
            self.assertIsNotNone(read(path.read_text()), path)


if __name__ == "__main__":
    unittest.main()
