"""The handbook's own scripts for a cluster and for a server of continuous integration, run as those run them."""

import os
import re
import shutil
import socket
import subprocess
import tempfile
import unittest
from pathlib import Path

from compiled_test_class import AClassOfStandIns
from fixture import ROOT

HANDBOOK = ROOT / "exercises" / "instructor.md"
DAEMONS = ("munged", "slurmctld", "slurmd")
COURSE = """#!/usr/bin/env bash
[ "$1 $2" = "grade --no-install" ] && shift
exec python3 -B '{runner}' --root '{root}' --toolchain '{toolchain}' "${{@:2}}"
"""
CONFIGURATION = """
ClusterName=tumble
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmUser=root
SlurmdUser=root
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SchedulerParameters=sched_interval=1,bf_interval=1
KillWait=5
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs=8 RealMemory=65536
PartitionName=all Nodes={host} Default=YES MaxTime=UNLIMITED State=UP
"""


def written_in_the_handbook(beginning):
    """The indented block of the handbook that begins so."""
    blocks = re.findall(r"(?:^    .*\n|^\n(?=    ))+", HANDBOOK.read_text(encoding="utf-8"), flags=re.MULTILINE)
    found, = [block for block in blocks if block.lstrip().startswith(beginning)]
    return "".join(line[4:] or "\n" for line in found.splitlines(keepends=True)).strip("\n") + "\n"


@unittest.skipUnless(HANDBOOK.exists(), "a student's copy has no handbook")
class AClassInAFolder(AClassOfStandIns):
    def setUp(self):
        super().setUp()
        for number in range(12):
            self.hand_in(f"student{number:02}", "// waits\n" if number == 4 else f"// {number % 3}\n")
        (self.place / "class").symlink_to(self.submissions)
        course = self.place / "course"
        course.write_text(COURSE.format(runner=self.runner, root=self.root, toolchain=self.toolchain_file), encoding="utf-8")
        course.chmod(0o755)
        self.script = self.place / "grade.sh"
        self.script.write_text(written_in_the_handbook("#!/usr/bin/env bash\n    #SBATCH"), encoding="utf-8")

    def words(self):
        return ["--exercises", "doubled", *(f"class/{name}" for name in self.names())]

    def require_all(self):
        self.run_to_the_end("merge", *sorted(self.place.glob("grade.*.part")), "--format", "json", "--output", "merged.json")
        self.run_to_the_end("--part", "whole", "--format", "json", "--output", "whole.json", "--exercises", "doubled")
        self.assertEqual((self.place / "merged.json").read_bytes(), (self.place / "whole.json").read_bytes())


class OnAnyMachine(AClassInAFolder):
    def test_the_script_for_a_cluster_grades_a_class_task_by_task(self):
        for task in (2, 3, 1):
            subprocess.run(["bash", str(self.script), *self.words()], cwd=self.place, check=True, stdin=subprocess.DEVNULL,
                           stdout=subprocess.DEVNULL, env={**os.environ, "SLURM_ARRAY_TASK_ID": str(task), "SLURM_ARRAY_TASK_COUNT": "3",
                                                           "SLURM_CPUS_PER_TASK": "2"})
        self.assertEqual(set(self.graded_so_far().values()), {1})
        self.require_all()

    def test_the_jobs_for_continuous_integration_grade_a_class(self):
        lines = written_in_the_handbook("grade:\n")
        self.assertEqual(re.search(r"parallel: (\d+)", lines)[1], "8")
        shard, marks = re.findall(r"script: (.*)", lines)
        shard, marks = (line.replace("moon,no_lag", "doubled") for line in (shard, marks))
        for number in range(1, 9):
            self.shell(shard, CI_NODE_INDEX=str(number), CI_NODE_TOTAL="8")
        self.shell(marks)
        self.assertEqual(len((self.place / "marks.csv").read_text(encoding="utf-8").splitlines()), 13)
        self.require_all()

    def shell(self, line, **environment):
        subprocess.run(["bash", "-c", line], cwd=self.place, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                       env={**os.environ, **environment})


@unittest.skipUnless(all(map(shutil.which, DAEMONS)), "Skipped, for this is not installed: slurm-wlm, munge")
@unittest.skipUnless(os.geteuid() == 0, "Skipped, for only root can start a cluster")
class OnSlurm(AClassInAFolder):
    """A cluster of one machine, started by the test and ended with it."""

    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="cluster-")  # slurm.conf can't hold a blank
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.folder.chmod(0o755)
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        with socket.socket() as one, socket.socket() as other:
            for each in (one, other):
                each.bind(("127.0.0.1", 0))
            ports = one.getsockname()[1], other.getsockname()[1]
        host = socket.gethostname().partition(".")[0]
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(host=host, ports=ports, folder=self.folder), encoding="utf-8")
        key = self.folder / "key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.daemon("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket", "--num-threads=1",
                    f"--log-file={self.folder}/munge.log", f"--pid-file={self.folder}/munge.pid", f"--seed-file={self.folder}/seed")
        self.wait_until((self.folder / "munge.socket").exists)
        self.daemon("slurmctld", "-D")
        self.daemon("slurmd", "-D")
        self.wait_until(lambda: "idle" in self.slurm("sinfo", may_fail=True))

    def daemon(self, *command):
        with open(self.folder / f"{command[0]}.out", "wb") as out:
            process = subprocess.Popen(command, env=self.environment, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        self.addCleanup(self.end, process)

    @staticmethod
    def end(process):
        process.terminate()
        try:
            process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def slurm(self, *command, may_fail=False):
        result = subprocess.run(command, env=self.environment, cwd=self.place, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, timeout=120)
        self.assertTrue(may_fail or result.returncode == 0, result.stdout.decode())
        return result.stdout.decode()

    def test_an_array_of_jobs_one_of_them_cancelled_and_submitted_again(self):
        (wait := self.root / "log.wait").touch()
        job = self.slurm("sbatch", "--parsable", "--array=1-3", "grade.sh", *self.words()).strip()
        self.wait_until(lambda: len(self.slurm("squeue", "--noheader").splitlines()) == 1)
        self.wait_until(lambda: self.results_in(self.place / "grade.2_of_3.part") == 3)  # only the one that waits is left
        self.slurm("scancel", f"{job}_2")
        self.wait_until(lambda: not self.slurm("squeue", "--noheader").strip())
        wait.unlink()
        self.slurm("sbatch", "--wait", "--array=1-3", "grade.sh", *self.words())
        graded = self.graded_so_far()
        # A cancelled task ends process by process, so the one that waited may have been tried once more before its end came.
        self.assertIn(graded.pop("student04"), (2, 3))
        self.assertEqual(graded, {name: 1 for name in self.names() if name != "student04"})
        self.assertEqual(sorted(file.name for file in self.place.glob("grade.*.part")),
                         [f"grade.{number}_of_3.part" for number in (1, 2, 3)])
        self.require_all()
