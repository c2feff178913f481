#!/usr/bin/env python3
"""The checker of words sees what it shall see, and nothing in code, formulas and directives."""

import pathlib
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import prose  # noqa: E402
import words  # noqa: E402

PAGE = """# A page {#page_one}

A torqe of `qwerty` and \\f$ \\omega_{qx} \\f$ turns
the bodie, see {{value demo.qzx}} and [there](qpath.md).

{{figure fig | What it shews.}}

    set_off(qcode);

It stands square
to the wall.
"""
CODE = """#include <qheader.hpp>
/// The centre's angel, square
/// to the axis. `qname` is \\p fine.
const char* text = "The momentun is "  // a remark
                   "square to the arm";
const char* key = "qkey"; // wrng
int qvariable = snake_case_qname + camelQcase;
"""
SCRIPT = '''#!/usr/bin/env python3
"""What a docstrng says."""
qname = "one sentense of a string"  # a coment
'''


class Words(unittest.TestCase):
    def passages(self, name, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / name
            path.write_text(text, encoding="utf-8")
            return [(name, prose.passages(path))]

    def misspelt(self, name, text, known=None):
        return [(line, word) for _, line, word in words.misspelt(self.passages(name, text), known or {})]

    def unwanted(self, name, text):
        listed = words.phrases("square to\tperpendicular to\n# a comment\n")
        return [(line, phrase) for _, line, phrase, _ in words.unwanted(self.passages(name, text), listed)]

    @unittest.skipUnless(shutil.which("hunspell"), "hunspell is not installed")
    def test_misspelt_words_are_found_with_their_lines_in_pages_comments_and_strings(self):
        self.assertEqual(self.misspelt("page.md", PAGE), [(3, "torqe"), (4, "bodie"), (6, "shews")])
        self.assertEqual(self.misspelt("code.hpp", CODE), [(4, "momentun"), (6, "wrng")])
        self.assertEqual(self.misspelt("script.py", SCRIPT), [(2, "docstrng"), (3, "sentense"), (3, "coment")])

    def test_what_others_have_written_is_not_read(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("README.md", "chapters/a.hpp", "build/a.md", "work/01_force/moon/moon.hpp", "third_party/include/b.hpp"):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).touch()
            self.assertEqual([path.name for path in prose.files(root)], ["README.md", "a.hpp"])

    @unittest.skipUnless(shutil.which("hunspell"), "hunspell is not installed")
    def test_american_spelling_is_misspelt(self):
        self.assertEqual(self.misspelt("page.md", "The color of its center is gray.\n"), [(1, "color"), (1, "center")])

    @unittest.skipUnless(shutil.which("hunspell"), "hunspell is not installed")
    def test_the_dictionary_knows_words_everywhere_or_in_one_place(self):
        everywhere, in_one_place = words.dictionary("# names\ntorqe\n"), words.dictionary("torqe\tchapters/\n")
        self.assertEqual(self.misspelt("page.md", "A torqe.\n", everywhere), [])
        self.assertEqual(self.misspelt("page.md", "A torqe.\n", in_one_place), [(1, "torqe")])

    def test_phrases_are_found_over_the_ends_of_lines(self):
        self.assertEqual(self.unwanted("page.md", PAGE), [(10, "square to")])
        self.assertEqual(self.unwanted("code.hpp", CODE), [(2, "square to"), (5, "square to")])

    def test_each_phrase_of_the_list_finds_its_own_example(self):
        for line in (words.HERE / "phrases.tsv").read_text(encoding="utf-8").splitlines():
            if line and not line.startswith("#"):
                pattern, _, example = line.split("\t")
                self.assertTrue(words.phrases(line)[0][0].search(example), pattern)


if __name__ == "__main__":
    unittest.main()
