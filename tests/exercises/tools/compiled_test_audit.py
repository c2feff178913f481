"""The checker is checked: exercises that break a promise are rejected, each for its own reason."""

from audit import audit, look_at_files
from catalogue import exercise_folders
from exercise import read_exercise
from fixture import PLACE, FixtureCourse


class Audit(FixtureCourse):
    def complaints(self):
        return audit(self.root, self.toolchain, exercise_folders(self.root))

    def rejected(self, expected):
        complaints = self.complaints()
        self.assertTrue(any(expected in complaint for complaint in complaints), f"{expected!r} is not in {complaints}")

    def test_a_sound_exercise_is_accepted(self):
        self.assertEqual(self.complaints(), [])

    def test_an_exercise_that_passes_unsolved_is_rejected(self):
        self.change(self.solution, "// return number;", "// return number / 2;")
        self.make_starter()
        self.rejected('the unsolved starter passes "Half of two is one"')

    def test_a_check_that_a_constant_passes_is_rejected(self):
        self.change(self.exercise_folder / "checks.cpp", 'Found("half of 3 m"', 'if (false) Found("half of 3 m"')
        self.rejected('"Half of two is one" is passed where halved answers with 1')

    def test_a_check_that_a_refusal_passes_is_rejected(self):
        self.change(self.exercise_folder / "checks.cpp", '  Found("half of 2 m", "m", ask<Real>("halved", Real(2))).must_be(1, 0);\n'
                    '  Found("half of 3 m", "m", ask<Real>("halved", Real(3))).must_be(1.5, 0);\n',
                    '  ask_refusal("an answer", "halved", Real(-1));\n')
        self.rejected('"Half of two is one" is passed where halved answers with a refusal')

    def test_a_check_that_the_input_passes_in_one_function_of_two_is_rejected(self):
        self.change(self.exercise_folder / "checks.cpp", 'ask<Real>("halved", Real(2))).must_be(1, 0)',
                    'ask<Real>("halved", Real(2)) + ask<Real>("doubled", Real(5))).must_be(7, 0);\n  return')
        self.rejected('"Half of two is one" is passed where halved answers with its own code; doubled answers with the 1st input')

    def test_a_tolerance_made_from_an_answer_is_rejected(self):
        self.change(self.exercise_folder / "checks.cpp", "2 * number, 0", '2 * number, double(ask<Real>("doubled", number)) / 4')
        self.rejected('"Twice two is four" breaks down where doubled answers with NaN')

    def test_an_answer_that_never_ends_costs_no_more_than_itself(self):
        self.change(self.solution, "// return number;", "// while (number < 9) number -= 1;\n  // return number;")
        self.make_starter()
        self.assertEqual(self.complaints(), [])

    def test_a_solution_that_fails_is_rejected(self):
        self.change(self.solution, "return number / 2;\n  //! [starter]", "return number / 3;\n  //! [starter]")
        self.rejected('the solution fails "Half of two is one": half of 2 m is 0.66667 m; it must be 1 m')

    def test_a_solution_that_fails_in_float_alone_is_rejected(self):
        self.change(self.solution, "return number / 2;\n  //! [starter]", "return number / 2 + (sizeof(Real) == 4);\n  //! [starter]")
        self.rejected('"Half of two is one": in float, half of 2 m is 2 m')

    def test_a_solution_that_fails_with_another_students_numbers_is_rejected(self):
        self.change(self.solution, "return 2 * number;", "return number + 2;")
        self.rejected('the solution fails "Twice two is four": twice ')

    def test_a_wrong_answer_that_slips_through_is_rejected(self):
        self.change(self.root / "tests" / "exercises" / PLACE / "wrong.txt", "\ncaught by: Half of two is one", "")
        self.rejected('"Twice two is four" doesn\'t catch not_halved')

    def test_a_wrong_answer_with_another_message_is_rejected(self):
        self.change(self.root / "tests" / "exercises" / PLACE / "wrong.txt", "third power", "fourth power")
        self.rejected('it must hold "that is the fourth power"')

    def test_checks_other_than_those_promised_are_rejected(self):
        self.change(self.exercise_folder / "checks.cpp", "Half of two is one", "Half of 2 is 1")
        self.rejected("they must be the same, in the same order")

    def test_a_warning_is_rejected(self):
        self.change(self.solution, "return 2 * number;", "int unused = 1;\n  return 2 * number;")
        self.rejected("the compiler warns of solution:\ndoubled.hpp:")

    def test_a_starter_that_does_not_compile_is_rejected(self):
        self.change(self.solution, "// return number;", "// return numbre;")
        self.make_starter()
        self.rejected("doubled.hpp:12: error: ‘numbre’ was not declared")


class Files(FixtureCourse):
    def rejected(self, expected):
        complaints = look_at_files(self.root, read_exercise(self.exercise_folder))
        self.assertEqual(len(complaints), 1, complaints)
        self.assertIn(expected, complaints[0])

    def test_a_starter_out_of_step_is_rejected(self):
        self.change(self.exercise_folder / "doubled.hpp", "return number;", "return 3 * number;")
        self.rejected("the starter is not the one that its solution makes")

    def test_two_hints_are_rejected(self):
        self.change(self.exercise_folder / "hints.md", "## 3", "")
        self.rejected("it must have ## 1, ## 2 and ## 3")

    def test_one_wrong_answer_is_rejected(self):
        wrong = self.root / "tests" / "exercises" / PLACE / "wrong.txt"
        wrong.write_text(wrong.read_text().partition("\n\n")[0])
        self.rejected("has 1 wrong answers")

    def test_a_missing_why_is_rejected(self):
        (self.root / "solutions" / "01_force" / "doubled" / "why.md").unlink()
        self.rejected("why.md is missing")

    def test_a_parameter_that_the_task_invents_is_rejected(self):
        self.change(self.exercise_folder / "task.md", "parameter number", "parameter height")
        self.rejected("names the parameter height")

    def test_a_prerequisite_that_is_not_there_is_rejected(self):
        self.change_json(prerequisites=["01_force/nothing"])
        self.rejected("names 01_force/nothing, which is not there")

    def test_an_exercise_called_as_a_chapter_is_rejected(self):
        self.exercise_folder.rename(self.exercise_folder.parent / "torque")
        for place in ("solutions", "tests/exercises"):
            (self.root / place / "01_force" / "doubled").rename(self.root / place / "01_force" / "torque")
        complaints = look_at_files(self.root, read_exercise(self.exercise_folder.parent / "torque"))
        self.assertIn("called as a chapter is", complaints[0])
