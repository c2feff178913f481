"""Where trivial answers go into a starter: every function that is asked for, and every one with a todo."""

import unittest

from complaint import Complaint
from trivial import places_of, trivial_header

STARTER = """#pragma once

template <class Real>
struct Effect {
  tumble::Vec3<Real> push(const tumble::Top<Real>& top, Real) const {
    todo("the push");
  }
};

template <class Real>
std::vector<std::pair<int, Real>> listed(int count, const std::pair<int,
                                         Real>& first) {
  std::vector<std::pair<int, Real>> list;
  for (int i = 0; i < count; ++i) {
    if (i > 3) continue;
    todo("the list");
  }
  return list;
}

template <class Real>
void step(Real& time) {
  todo("a step");
}

template <class Real>
Real helper(Real number) {
  return number;
}

template <class Real>
Real asked(Real number) {
  while (number > helper(number)) {
    number -= 1;
  }
  return number;
}
"""


class Places(unittest.TestCase):
    def test_functions_are_read_with_result_parameters_and_todo(self):
        found = [(place.name, place.result, place.parameters, place.todo >= 0, place.may_be_left)
                 for place in places_of(STARTER, ("asked",))]
        self.assertEqual(found, [("push", "tumble::Vec3<Real>", ("top",), True, False),
                                 ("listed", "std::vector<std::pair<int, Real>>", ("count", "first"), True, True),
                                 ("step", "void", ("time",), True, True),
                                 ("asked", "Real", ("number",), False, False)])

    def test_each_first_asks_whether_it_is_trivial_and_goes_on_past_a_todo_where_it_can(self):
        header, _ = trivial_header(STARTER, ("asked", "step"))
        self.assertIn("if (tumble::exercise::is_trivial(2)) return tumble::exercise::trivial<void>(2, time);\n  if (false) todo", header)
        self.assertIn('if (false) todo("the list");', header)
        self.assertIn("is_trivial(3)) return tumble::exercise::trivial<Real>(3, number);\n  while", header)

    def test_a_function_that_cannot_be_read_is_a_complaint(self):
        with self.assertRaisesRegex(Complaint, "could be read: other"):
            trivial_header(STARTER, ("asked", "other"))
