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

    def test_a_solution_that_fails_in_float_alone_is_rejected(self):
        self.change(self.solution, "return number / 2;\n  //! [starter]", "return number / 2 + (sizeof(Real) == 4);\n  //! [starter]")
        self.rejected('"Half of two is one": in float, half of 2 m is 2 m')

    def test_a_solution_that_fails_with_another_students_numbers_is_rejected(self):
        self.change(self.solution, "return 2 * number;", "return number + 2;")
        self.rejected('the solution fails "Twice two is four": twice ')

    def test_a_wrong_answer_that_slips_through_is_rejected(self):
        self.change(self.root / "tests" / "exercises" / PLACE / "wrong.txt", "\ncaught by: Half of two is one", "")
        self.rejected('"Twice two is four" doesn\'t catch not_halved')

    def test_a_right_answer_that_is_refused_is_named(self):
        file = self.root / "tests" / "exercises" / PLACE / "wrong.txt"
        with file.open("a", encoding="utf-8") as more:
            more.write("\nright as well\nas_a_sum: number and number\n-   return 2 * number;\n+   return number + number + number;\n")
        self.rejected('"Twice two is four" refuses as_a_sum, which is right: ')
        self.change(file, " + number + number", " + number")
        self.assertEqual(self.complaints(), [])

    def test_a_wrong_answer_with_another_message_is_rejected(self):
        self.change(self.root / "tests" / "exercises" / PLACE / "wrong.txt", "third power", "fourth power")
        self.rejected('it must hold "that is the fourth power"')


class Files(FixtureCourse):
    def rejected(self, expected):
        complaints = look_at_files(self.root, read_exercise(self.exercise_folder))
        self.assertEqual(len(complaints), 1, complaints)
        self.assertIn(expected, complaints[0])

    def test_a_starter_out_of_step_is_rejected(self):
        self.change(self.exercise_folder / "doubled.hpp", "return number;", "return 3 * number;")
        self.rejected("the starter is not the one that its solution makes")

    def test_a_missing_why_is_rejected(self):
        (self.root / "solutions" / "01_force" / "doubled" / "why.md").unlink()
        self.rejected("why.md is missing")

    def test_a_prerequisite_that_is_not_there_is_rejected(self):
        self.change_json(prerequisites=["01_force/nothing"])
        self.rejected("names 01_force/nothing, which is not there")

    def test_an_exercise_called_as_a_chapter_is_rejected(self):
        self.exercise_folder.rename(self.exercise_folder.parent / "torque")
        for place in ("solutions", "tests/exercises"):
            (self.root / place / "01_force" / "doubled").rename(self.root / place / "01_force" / "torque")
        complaints = look_at_files(self.root, read_exercise(self.exercise_folder.parent / "torque"))
        self.assertIn("called as a chapter is", complaints[0])
