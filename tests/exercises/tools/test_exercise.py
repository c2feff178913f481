"""exercise.json: what it must hold, and what is said of it otherwise."""

import json
import tempfile
import unittest
from pathlib import Path

from catalogue import read_catalogue
from complaint import Complaint
from exercise import read_exercise
from toolchain import Toolchain

SOUND = {
    "title": "A hammer", "goals": ["see"], "prerequisites": ["03_inertia"], "minutes": 20, "difficulty": "write",
    "functions": ["mass"], "checks": [{"sentence": "It is heavy", "points": 2}, {"sentence": "It is long", "points": 1}],
    "parameters": {"mass": {"unit": "kg", "usual": 1, "least": 0.5, "most": 2, "step": 0.5}}, "learned": "Much."}


class ExerciseFile(unittest.TestCase):
    def read(self, said, place="03_inertia/hammer"):
        with tempfile.TemporaryDirectory() as folder:
            where = Path(folder) / place
            where.mkdir(parents=True)
            (where / "exercise.json").write_text(said if isinstance(said, str) else json.dumps(said), encoding="utf-8")
            return read_exercise(where)

    def refused(self, expected, place="03_inertia/hammer", **changes):
        said = {key: value for key, value in {**SOUND, **changes}.items() if value is not None}
        with self.assertRaises(Complaint) as caught:
            self.read(said, place)
        self.assertIn(expected, str(caught.exception))
        self.assertIn("exercise.json", str(caught.exception))

    def test_a_sound_one_is_read(self):
        exercise = self.read(SOUND)
        self.assertEqual((exercise.path, exercise.header, exercise.points), ("03_inertia/hammer", "hammer.hpp", 3))
        self.assertEqual(exercise.parameters[0].least, 0.5)

    def test_parameters_may_be_left_out(self):
        self.assertEqual(self.read({key: value for key, value in SOUND.items() if key != "parameters"}).parameters, ())

    def test_each_mistake_is_named_with_its_rule(self):
        self.refused('"minuets", which means nothing here; is minutes meant?', minuets=3)
        self.refused("lacks learned", learned=None)
        self.refused("title is 3; it must be a text in one line", title=3)
        self.refused('title is "  "', title="  ")
        self.refused("goals is []; it must be a list of one or more texts", goals=[])
        self.refused("minutes is -5; it must be a whole number from 1 to 600", minutes=-5)
        self.refused("minutes is 2.5;", minutes=2.5)
        self.refused("minutes is true;", minutes=True)
        self.refused('difficulty is "hard"; it must be one of change, write, derive, prove, lab', difficulty="hard")
        self.refused('functions has "Mass"', functions=["Mass"])
        self.refused("each must stand there once", functions=["mass", "mass"])
        self.refused("checks is []", checks=[])
        self.refused("points is 0; it must be a whole number from 1 to 100", checks=[{"sentence": "a", "points": 0}])
        self.refused("a check lacks points", checks=[{"sentence": "a"}])
        self.refused('two checks say "a"', checks=[{"sentence": "a", "points": 1}, {"sentence": "a", "points": 2}])
        self.refused('prerequisites names "inertia"', prerequisites=["inertia"])
        self.refused("must not come after the chapter of the exercise, 03_inertia", prerequisites=["04_quaternions"])
        self.refused("in that of a chapter", place="inertia/hammer")
        self.refused("small letters, digits and _", place="03_inertia/Hammer")

    def test_parameters_have_rules_of_their_own(self):
        mass = SOUND["parameters"]["mass"]
        for change, expected in (({"usual": 3}, "usual is 3; it must lie between least, 0.5, and most, 2"),
                                 ({"step": 0}, "step is 0; it must be greater than 0"),
                                 ({"step": 0.4}, "usual is 1; it must be a whole number of steps of 0.4 above 0.5"),
                                 ({"least": "1"}, 'least is "1"; it must be a finite number'),
                                 ({"unit": 1}, "unit is 1; it must be a text")):
            self.refused(expected, parameters={"mass": {**mass, **change}})
        self.refused('has "Mass"', parameters={"Mass": mass})
        self.refused("lacks step", parameters={"mass": {key: value for key, value in mass.items() if key != "step"}})

    def test_a_private_folder_is_told_which_chapters_there_are(self):
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder) / "inertia" / "hammer"
            place.mkdir(parents=True)
            (place / "exercise.json").write_text(json.dumps(SOUND), encoding="utf-8")
            with self.assertRaisesRegex(Complaint, "CHAPTER/NAME/exercise.json, CHAPTER being one of the course, such as 03_inertia"):
                read_catalogue(folder, folder)
        floors = {"common": [], "01_force": [], "03_inertia": []}
        with self.assertRaises(Complaint) as caught:
            Toolchain("c++", [], [], [], floors, Path(), Path()).folders_of("04_inertia")
        self.assertEqual(str(caught.exception), "there is no chapter 04_inertia; the chapters are 01_force, 03_inertia")

    def test_what_is_no_json_is_said_with_its_place(self):
        with self.assertRaises(Complaint) as caught:
            self.read('{"title": ')
        self.assertIn("is no JSON", str(caught.exception))
        self.assertIn("line 1", str(caught.exception))
