"""What is read of a submission, and what a person should look at."""


from submission import read_header, student_of
from test_texts import InAFolder, exercise

PLAIN = "#pragma once\n#include <exercise/todo.hpp>\n#include <tumble/force.hpp>\n"


class Headers(InAFolder):
    def read(self, text):
        (self.folder / "hammer.hpp").write_text(text, encoding="utf-8")
        return read_header(self.folder, exercise())

    def test_a_plain_one_has_nothing_to_look_at(self):
        header = self.read(PLAIN)
        self.assertEqual((header.text, header.reason, header.flags), (PLAIN, "", []))

    def test_it_may_lie_in_the_folders_of_the_course(self):
        for below in ("hammer", "03_inertia/hammer", "work/03_inertia/hammer"):
            with self.subTest(below):
                place = self.folder / below.replace("/", "_") / below
                place.mkdir(parents=True)
                (place / "hammer.hpp").write_text(PLAIN, encoding="utf-8")
                self.assertEqual(read_header(self.folder / below.replace("/", "_"), exercise()).text, PLAIN)

    def test_what_stands_in_a_comment_is_not_suspicious(self):
        for line in ("// fork();", "/*\nfork();\n*/", "/* fork();"):
            with self.subTest(line):
                self.assertEqual(self.read(f"{PLAIN}{line}\n").flags, [])

    def test_suspicious_constructs_are_flagged(self):
        for code, flag in (("fork();", "starts another program"), ("std::system ( 0 );", "starts another program"),
                           ("std::ofstream out;", "opens files"), ('asm("nop");', "holds assembly"),
                           ("std::exit(0);", "ends the program"), ("#define main x", "redefines what belongs"),
                           ("__attribute__((constructor)) void f();", "runs before or after main"),
                           ("tumble::exercise::put(line, 1.0);", "meddles with"), ("#pragma GCC poison x", "orders"),
                           ('"/proc/self/mem"', "names a file of the system")):
            with self.subTest(code):
                self.assertTrue(any(flag in each for each in self.read(f"{PLAIN}{code}\n").flags), self.read(code).flags)

    def test_words_of_mechanics_are_not_suspicious(self):
        self.assertEqual(self.read(PLAIN + "add_force(body, f); step(body, h); kick(body); // system (of bodies)\n").flags, [])

    def test_resubmissions_are_of_one_student(self):
        self.assertEqual([student_of(name) for name in ("ada", "ada@1", "ada@2026-03-01")], ["ada"] * 3)
