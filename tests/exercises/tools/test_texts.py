"""Hints, wrong answers, the compiler's message, and the parameters that are put into a task."""

import tempfile
import unittest
from pathlib import Path

from catalogue import exercise_folders
from compiler_says import first_message, why_not
from complaint import Complaint
from exercise import Check, Exercise, Parameter, read_exercise
from hints import read_hints
from workplace import drawn_parameters, with_parameters
from wrong_answers import read_wrong_answers

ROOT = Path(__file__).resolve().parents[3]


def exercise(**changes):
    usual = dict(chapter="03_inertia", name="hammer", folder=Path("there"), title="t", goals=("g",), prerequisites=(),
                 minutes=1, difficulty="write", functions=("f",), checks=(Check("It holds", 1),),
                 parameters=(Parameter("mass", "kg", 1, 0.5, 2, 0.5),), learned="l")
    return Exercise(**{**usual, **changes})


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="with a blank ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def complaint(self, action):
        with self.assertRaises(Complaint) as caught:
            action()
        return str(caught.exception)


class Hints(InAFolder):
    def test_three_are_read(self):
        self.assertEqual(read_hints(self.file("h.md", "## 1\n\na\n\n## 2\nb\nb\n## 3\nc\n")), ["a", "b\nb", "c"])

    def test_one_that_begins_with_code_keeps_its_blanks(self):
        self.assertEqual(read_hints(self.file("h.md", "## 1\n\na\n\n## 2\n\n    b;\n    c;\n\n## 3\nd\n"))[1], "    b;\n    c;")

    def test_two_are_too_few(self):
        said = self.complaint(lambda: read_hints(self.file("h.md", "## 1\na\n## 2\nb\n")))
        self.assertIn("has the headings 1, 2; it must have ## 1, ## 2 and ## 3", said)

    def test_each_says_more(self):
        self.assertIn("hint 2 is empty", self.complaint(lambda: read_hints(self.file("h.md", "## 1\na\n## 2\n\n## 3\nb\n"))))
        self.assertIn("hint 3 says what an earlier one has said",
                      self.complaint(lambda: read_hints(self.file("h.md", "## 1\na\n## 2\nb\n## 3\na\n"))))

    def test_a_missing_file_is_named(self):
        self.assertIn("h.md is missing", self.complaint(lambda: read_hints(self.folder / "h.md")))


class WrongAnswers(InAFolder):
    solution = "one;\n//! [solution]\ntwo;\ntwo;\nthree;\n"

    def answers(self, *lines, check="It holds"):
        self.file("wrong.txt", "\n".join([f"caught by: {check}", "a: m", *lines, "", "b: n", "- one;", "+ once;", "+ more;"]) + "\n")
        return read_wrong_answers(exercise(), self.folder, self.solution)

    def test_each_names_its_check_and_its_message_and_changes_the_solution_in_its_places_alone(self):
        first, second = self.answers("- one;", "+", "- two;", "- three;", "+   four;")
        self.assertEqual([(each.name, each.caught_by, each.message) for each in (first, second)], [("a", "It holds", "m"), ("b", "It holds", "n")])
        self.assertEqual(first.text, "//! [solution]\ntwo;\n  four;\n")
        self.assertEqual(second.text, "once;\nmore;\n//! [solution]\ntwo;\ntwo;\nthree;\n")

    def test_what_can_not_be_changed_so_is_named(self):
        for lines, expected in ((["- two;", "+ four;"], "a replaces lines that occur 2 times in the solution: two;"),
                                (["- five;", "+ six;"], "occur 0 times in the solution: five;"),
                                (["- one;"], 'and no "- one;"'), (["two;"], 'and no "two;"')):
            with self.subTest(expected):
                self.assertIn(expected, self.complaint(lambda lines=lines: self.answers(*lines)))

    def test_a_check_that_is_none_is_named(self):
        self.assertIn('names "It flies", which is no check of', self.complaint(lambda: self.answers("- one;", "+", check="It flies")))

    def test_one_is_too_few_and_each_has_a_head(self):
        for text, expected in (("caught by: It holds\na: m\n- one;\n+ two;\n", "has 1 wrong answers"),
                               ("a: m\n- one;\n+ two;\n", '"a: m" must be'), ("caught by: It holds\n", 'must be "NAME')):
            with self.subTest(expected):
                self.file("wrong.txt", text)
                self.assertIn(expected, self.complaint(lambda: read_wrong_answers(exercise(), self.folder, self.solution)))


    def test_what_is_right_as_well_is_told_from_what_is_wrong(self):
        blocks = [f"{name}: m\n- one;\n+ {name};" for name in "abc"]
        text = "\n\n".join(["caught by: It holds\n" + blocks[0], blocks[1], "right as well\n" + blocks[2]])
        self.file("wrong.txt", text)
        self.assertEqual([each.caught_by for each in read_wrong_answers(exercise(), self.folder, self.solution)], ["It holds", "It holds", ""])
        self.file("wrong.txt", text.replace(f"{blocks[1]}\n\n", ""))
        self.assertIn("has 1 wrong answers", self.complaint(lambda: read_wrong_answers(exercise(), self.folder, self.solution)))


class Parameters(InAFolder):
    def test_no_task_says_that_something_is_taken_once(self):
        for folder in exercise_folders(ROOT):
            real = read_exercise(folder)
            task = (folder / "task.md").read_text(encoding="utf-8")
            self.assertNotIn(" 1 times ", with_parameters(task, real, drawn_parameters(real, "")))

    def test_without_a_key_they_are_the_usual_ones(self):
        self.assertEqual(drawn_parameters(exercise(), ""), [("mass", 1)])

    def test_a_key_draws_from_the_steps_and_always_the_same(self):
        drawn = {key: drawn_parameters(exercise(), key)[0][1] for key in map(str, range(60))}
        self.assertEqual(set(drawn.values()), {0.5, 1.0, 1.5, 2.0})
        self.assertEqual(drawn["7"], drawn_parameters(exercise(), "7")[0][1])
        self.assertEqual(drawn_parameters(exercise(), "autumn-ada"), [("mass", 1.5)])  # on every machine and for ever

    def test_they_stand_in_the_task_with_their_unit(self):
        self.assertEqual(with_parameters("of {{parameter mass}}.", exercise(), [("mass", 1.5)]), "of 1.5 kg.")

    def test_an_unknown_one_is_named(self):
        self.assertIn("names the parameter length",
                      self.complaint(lambda: with_parameters("{{parameter length}}", exercise(), [("mass", 1)])))

    def test_one_that_is_written_in_another_way_is_refused(self):
        for task in ("{{parameter\nmass}}", "{{Parameter mass}}", "{{mass}}"):
            with self.subTest(task):
                self.assertIn(f"holds {task!r}; ", self.complaint(lambda task=task: with_parameters(task, exercise(), [("mass", 1)])))


class CompilerSays(unittest.TestCase):
    def test_an_error_in_the_students_file_is_shown_with_its_line(self):
        output = ("In file included from a.cpp:2:\nwork/hammer.hpp: In function f:\n"
                  "work/hammer.hpp:16:5: error: no such thing\n   16 |  x\n      |  ^\nother\n"
                  "work/hammer.hpp:20:5: error: second\n")
        self.assertEqual(first_message(output, "work/hammer.hpp"), "hammer.hpp:16: error: no such thing\n   16 |  x\n      |  ^")

    def test_an_error_elsewhere_leads_back_to_it(self):
        output = ("work/hammer.hpp:16:5:   required from here\n/usr/include/eigen3/Eigen/Core:120:9: error: YOU_MIXED_SIZES\n")
        self.assertEqual(first_message(output, "work/hammer.hpp"),
                         "Core:120: error: YOU_MIXED_SIZES\nwhich hammer.hpp:16 leads to")

    def test_the_linkers_words_are_passed_on(self):
        self.assertIn("undefined reference", first_message("x.o: undefined reference to f\n", "hammer.hpp"))

    def test_a_function_that_is_missing_is_named(self):
        missing = "/b/mine/answers_double.cpp:9:9: error: 'f' was not declared in this scope\n"
        self.assertTrue(why_not(missing, exercise()).startswith("hammer.hpp must declare, as its starter does: f.\n"))
        own = "/w/hammer.hpp:3:1: error: 'g' was not declared in this scope\n"
        self.assertEqual(why_not(own, exercise()), "hammer.hpp:3: error: 'g' was not declared in this scope")

    def test_a_brace_that_is_never_closed_is_named_and_not_where_the_file_that_includes_it_ends(self):
        gcc = ("/b/answers_double.cpp:4:12: error: a function-definition is not allowed here before ‘{’ token\n"
               "/b/answers_double.cpp:9:2: error: expected ‘}’ at end of input\n    9 | }\n      |  ^\n"
               "In file included from /b/answers_double.cpp:2:\nwork/hammer.hpp:7:29: note: to match this ‘{’\n"
               "    7 | Real f() {\n      |          ^\n")
        clang = ("/b/answers_double.cpp:4:12: error: function definition is not allowed here\n"
                 "/b/answers_double.cpp:9:2: error: expected '}'\n./hammer.hpp:7:29: note: to match this '{'\n")
        for output in (gcc, clang):
            self.assertTrue(why_not(output, exercise()).startswith("hammer.hpp:7: error: a closing brace is missing"))
        self.assertIn("7 | Real f() {", why_not(gcc, exercise()))

    def test_an_expression_handed_to_a_template_is_explained(self):
        gcc = ("hammer.hpp:8:16: error: no matching function for call to ‘f(const Eigen::CwiseBinaryOp<Eigen::internal::scalar_sum_op"
               "<double, double>, const Eigen::Matrix<double, 3, 1>, const Eigen::Matrix<double, 3, 1> >)’\n")
        clang = ("./hammer.hpp:8:10: error: no matching function for call to 'f'\n"
                 "./hammer.hpp:5:28: note: candidate template ignored: could not match 'Matrix' against 'CwiseBinaryOp'\n")
        for output in (gcc, clang):
            self.assertIn("Make it one first: Vec3<Real>(a + b)", why_not(output, exercise()))
        other = "hammer.hpp:8:16: error: no matching function for call to ‘f(int)’\n"
        self.assertNotIn("Vec3", why_not(other, exercise()))

    def test_a_choice_that_packs_can_not_make_is_explained(self):
        mask, truth = "‘tumble::Pack<double, 2>::Mask’ {aka ‘tumble::PackMask<double, 2>’}", "‘bool’"
        for said, expected in (
                (f"could not convert ‘tumble::operator<(h, 0)’ from {mask} to {truth}", "neither if nor ?: nor std::max can take one way"),
                ("value of type 'tumble::Pack<double, 2>::Mask' (aka 'PackMask<double, 2>') is not contextually convertible to 'bool'",
                 "neither if nor ?: nor std::max can take one way"),
                ("cannot convert ‘double’ to ‘fd_set*’", 'Write "using tumble::select;" first'),
                ("no matching function for call to 'select'", 'Write "using tumble::select;" first'),
                ("no matching function for call to ‘sqrt(tumble::Pack<double, 2>&)’", 'Write "using std::sqrt;" first')):
            text = why_not(f"hammer.hpp:3:7: error: {said}\n    3 |  if (h < 0)\n      |      ~~^~~\n      |        |\n      |        {mask}\n",
                           exercise())
            with self.subTest(said):
                self.assertIn(expected, text)
                self.assertTrue(text.endswith(f"hammer.hpp:3: error: {said}\n    3 |  if (h < 0)\n      |      ~~^~~"), text)
        self.assertNotIn("using", why_not("hammer.hpp:3:7: error: no matching function for call to ‘sqrt(int*)’\n", exercise()))

    def test_the_members_of_a_struct_are_named_where_one_is_missing(self):
        here = exercise(folder=ROOT / "exercises" / "11_world" / "viscous_joint")
        bodies = "The members of BodyState are centre and top"
        pushes = "The members of PairPush are force_on_first, torque_on_first and torque_on_second."
        for said, expected in (
                ("‘const struct tumble::BodyState<double>’ has no member named ‘position’", f"{bodies}; position is a member of centre."),
                ("no member named 'torque' in 'tumble::BodyState<double>'", f"{bodies}; torque is a member of top."),
                ("‘const struct tumble::BodyState<double>’ has no member named ‘angular_velocity’", f"{bodies}."),
                ("‘struct tumble::PairPush<float>’ has no member named ‘force’", pushes),
                ("could not convert ‘{f}’ from ‘<brace-enclosed initializer list>’ to ‘tumble::PairPush<double>’", pushes),
                ("field designator 'force' does not refer to any field in type 'tumble::Pose<double>'",
                 "The members of Pose are position and orientation.")):
            with self.subTest(said):
                self.assertEqual(why_not(f"hammer.hpp:3:7: error: {said}\n", here), f"{expected}\nhammer.hpp:3: error: {said}")
        own = "hammer.hpp:3:7: error: ‘struct Mine’ has no member named ‘position’"
        self.assertTrue(why_not(f"{own}\n", here).startswith("hammer.hpp:3: error"))

    def test_no_error_floods_a_report(self):
        line = f"#error {'so ' * 70_000}"
        said = why_not(f"hammer.hpp:2:2: error: {line}\n    2 | {line}\n      |  ^~~~~\n", exercise())
        self.assertTrue(said.startswith("hammer.hpp:2: error: #error so so") and said.endswith(" ..."))
        self.assertLess(len(said), 2010)

    def test_no_warning_is_an_empty_text(self):
        self.assertEqual(first_message("", "hammer.hpp", "warning"), "")
