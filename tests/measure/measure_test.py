"""measure_test.py TINY_ITEMS_DEMO LONG_PROGRAMS SCRATCH: measurements are the same whole and in shards, however often they are stopped."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

TINY, LISTED, SCRATCH = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
MEASURE = pathlib.Path(__file__).resolve().parents[2] / "tools" / "measure.py"

# A program without items. It must not run beside another one: whoever finds the other's mark says so.
ALONE = """#!/bin/sh
mkdir "$0.runs" || echo "expected, but not so: I am alone" >&2
sleep 0.1
printf 'a line\\r\\n' >"$1/alone.tsv"
echo "$2 and full: $TUMBLE_FULL"
rmdir "$0.runs"
"""


class Measurements(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        (SCRATCH / "chapters").mkdir(parents=True)
        (SCRATCH / "chapters" / "tiny.cpp").write_text("// what is measured\n")
        self.begun = SCRATCH / "begun"
        self.programs = [self.program("tiny_items_demo", TINY, items=True)]
        for name in ("first_alone", "second_alone"):
            script = SCRATCH / "alone.sh"
            script.write_text(ALONE)
            script.chmod(0o755)
            self.programs.append(self.program(name, str(script), measures=True, arguments=["--full"]))
        self.list_programs()

    def program(self, name, program, items=False, measures=False, arguments=()):
        return {"name": name, "chapter": "01_tiny", "program": program, "arguments": list(arguments), "items": items, "measures": measures}

    def list_programs(self, compiler="tiny 1"):
        (SCRATCH / "programs.json").write_text(json.dumps({"compiler": compiler, "programs": self.programs}))

    def words(self, *words):
        return [sys.executable, "-B", str(MEASURE), "--root", str(SCRATCH), "--programs", "programs.json", *words]

    def measure(self, *words, code=0, **environment):
        done = subprocess.run(self.words(*words), cwd=SCRATCH, capture_output=True, text=True, env={**os.environ, **environment})
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout if code == 0 else done.stderr

    def merged(self, *parts):
        self.measure("--into", "measured", "--merge", *parts)
        return self.files_in("measured")

    def files_in(self, folder):
        return {str(file.relative_to(SCRATCH / folder)): file.read_bytes()
                for file in sorted((SCRATCH / folder).rglob("*")) if file.is_file() and file.name != "where.txt"}

    def whole(self):
        """What one run of each program leaves: the build does the same."""
        found = {}
        for program in self.programs:
            folder = SCRATCH / "whole" / program["name"]
            folder.mkdir(parents=True)
            done = subprocess.run([program["program"], folder, *program["arguments"]], capture_output=True,
                                  env={**os.environ, "TUMBLE_FULL": "1"})
            (folder / f"{program['name']}.txt").write_bytes(done.stdout)
            for ending in ("errors", "failed") if done.returncode else ("errors",):
                (folder / f"{program['name']}.{ending}").write_bytes(done.stderr)
            found |= {f"{program['name']}/{file.name}": file.read_bytes() for file in folder.iterdir()}
        return found

    def test_two_shards_of_which_one_was_stopped_are_one_run_to_the_byte(self):
        self.measure("--shard", "2/2")
        part, other = SCRATCH / "measured.1-of-2.part", "measured.2-of-2.part"
        running = subprocess.Popen(self.words("--shard", "1/2"), cwd=SCRATCH, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   env={**os.environ, "TINY_ITEMS_BEGUN": str(self.begun)})
        while not part.exists() or part.read_bytes().count(b'"result"') < 2:  # the signal may undo the line that was just written
            self.assertIsNone(running.poll())
            time.sleep(0.01)
        running.terminate()
        self.assertEqual(running.wait(), 128 + signal.SIGTERM)
        self.assertIn("--resume takes it up", self.measure("--shard", "1/2", code=2))
        self.assertIn("have no result yet", self.measure("--into", "measured", "--merge", part.name, other, code=2))
        self.measure("--shard", "1/2", "--resume", TINY_ITEMS_BEGUN=str(self.begun))
        whole = self.whole()
        self.assertEqual(self.merged(other, part.name), whole)
        begun = self.begun.read_text().split()
        self.assertEqual(set(begun), {"1", "3", "5", "7", "9", "20", "100"})  # this shard's
        self.assertLessEqual(len(begun), 7 + (os.cpu_count() or 1))  # only what was interrupted is done again
        self.assertIn(b"a sum is less than three", whole["tiny_items_demo/tiny_items_demo.failed"])
        self.assertIn(b"full\tyes", whole["tiny_items_demo/tiny_items_demo.values.tsv"])
        self.assertEqual(whole["first_alone/alone.tsv"], b"a line\r\n")
        self.assertRegex((SCRATCH / "measured" / "where.txt").read_text(), r"^the full set, measured in 2 parts on .+ \(tiny 1\)\n$")

    def test_what_measures_time_runs_alone(self):
        self.measure("--shard", "1/1", "--part", "all")
        self.assertNotIn("first_alone/first_alone.failed", self.merged("all"))

    def test_what_was_merged_before_stays_when_a_merge_is_stopped(self):
        self.measure("--shard", "1/1", "--part", "all")
        before = self.merged("all")
        slow = SCRATCH / "slow.sh"
        slow.write_text(f'#!/bin/sh\n[ "${{TUMBLE_ITEMS%% *}}" != from ] || {{ touch "{self.begun}"; exec sleep 60 2>/dev/null; }}\nexec "{TINY}" "$@"\n')
        slow.chmod(0o755)
        self.programs[0]["program"] = str(slow)
        self.list_programs()
        for how in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            with self.subTest(how=how):
                self.begun.unlink(missing_ok=True)
                merging = subprocess.Popen(self.words("--into", "measured", "--merge", "all"), cwd=SCRATCH, stderr=subprocess.PIPE, text=True)
                while not self.begun.exists():
                    self.assertIsNone(merging.poll())
                    time.sleep(0.01)
                merging.send_signal(how)
                self.assertIn("course: stopped\n", merging.communicate()[1])
                self.assertEqual(merging.returncode, 128 + how)
                self.assertEqual(self.files_in("measured"), before)
                self.assertEqual(sorted(file.name for file in SCRATCH.glob("measured*")), ["measured"])

    def test_what_was_merged_before_stays_when_a_merge_fails(self):
        self.measure("--shard", "1/1", "--part", "all")
        before = self.merged("all")
        failing = SCRATCH / "failing.sh"
        failing.write_text(f'#!/bin/sh\n[ "${{TUMBLE_ITEMS%% *}}" != from ] || {{ echo out of luck >&2; exit 3; }}\nexec "{TINY}" "$@"\n')
        failing.chmod(0o755)
        self.programs[0]["program"] = str(failing)
        self.list_programs()
        self.assertIn("can't be put together: it ended with 3: out of luck", self.measure("--into", "measured", "--merge", "all", code=2))
        self.programs[0]["program"] = TINY
        self.list_programs()
        (SCRATCH / "file").write_text("")
        self.assertIn("file/measured can't be written: Not a directory", self.measure("--into", "file/measured", "--merge", "all", code=2))
        self.assertEqual(self.files_in("measured"), before)
        self.assertEqual(sorted(file.name for file in SCRATCH.glob("measured*")), ["measured"])

    def test_parts_of_another_course_compiler_or_share_are_refused(self):
        for number in (1, 2):
            self.measure("--shard", f"{number}/2")
        parts = [f"measured.{number}-of-2.part" for number in (1, 2)]
        self.list_programs(compiler="tiny 2")
        self.measure("--shard", "2/2", "--part", "other")
        self.assertIn('its job compiler is "tiny 2"', self.measure("--into", "measured", "--merge", parts[0], "other", code=2))
        self.merged(*parts)  # on a machine with another compiler than that of all shares
        (SCRATCH / "chapters" / "tiny.cpp").write_text("// what is measured, changed\n")
        self.assertIn("another version of the course", self.measure("--into", "measured", "--merge", *parts, code=2))

    def test_what_fails_is_told_and_is_no_result(self):
        self.programs.append(self.program("crashing", "/bin/false"))
        self.list_programs()
        self.assertIn("crashing failed twice: RuntimeError: it ended with 1", self.measure("--shard", "1/1", "--part", "all", code=1))
        self.assertIn("1 of 17 items have no result yet, such as crashing", self.measure("--into", "measured", "--merge", "all", code=2))

    def test_a_program_that_is_compiled_anew_meanwhile_ends_the_share(self):
        script = SCRATCH / "anew.sh"
        script.write_text('#!/bin/sh\ntouch "$0"\n')
        script.chmod(0o755)
        self.programs.append(self.program("anew", str(script)))
        self.list_programs()
        self.assertIn("anew was compiled anew meanwhile", self.measure("--shard", "1/1", "--part", "all", code=2))

    def test_a_part_that_was_edited_is_refused(self):
        self.measure("--shard", "1/1", "--part", "all")
        sys.path.insert(0, str(MEASURE.parents[1] / "exercises" / "tools"))
        from shards import Job, Part, job_of_part, merge  # noqa: PLC0415
        (results, _), job = merge([SCRATCH / "all"]), job_of_part(SCRATCH / "all")
        for task, forged, what, said in (
                ("first_alone", {"files": {"../../stolen": ""}}, {}, "no program of the course leaves"),
                ("first_alone", results["first_alone"], {"compiler": 5}, "the parts are of other work than measuring"),
                ("first_alone", results["first_alone"], {"more": ""}, "the parts are of other work than measuring")):
            with self.subTest(forged=forged, what=what):
                with Part(SCRATCH / "forged", Job({**job, **what}, list(results))) as part:
                    for each, result in results.items():
                        part.add(each, forged if each == task else result)
                self.assertIn(said, self.measure("--into", "measured", "--merge", "forged", code=2))
                (SCRATCH / "forged").unlink()
        self.assertFalse((SCRATCH / "stolen").exists())

    def test_each_item_of_the_course_has_a_name_of_its_own(self):
        for program in json.loads(LISTED.read_text())["programs"]:
            if program["items"] and os.path.exists(program["program"]):
                names = subprocess.run([program["program"]], env={**os.environ, "TUMBLE_ITEMS": "names"}, capture_output=True, text=True,
                                       check=True).stdout.splitlines()
                self.assertGreater(len(names), 1)
                self.assertEqual(len(set(names)), len(names))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
