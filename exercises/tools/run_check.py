"""Runs one check: a judge that asks and a worker, in which the student's code answers, each a process of its own."""

import errno
import json
import os
import selectors
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from confined import end_group
from limits import Limits, confine, seconds_computed
from patience import Patience

PASSED, FAILED, TODO, BROKEN = "passed", "failed", "not written yet", "broken"
OF_THE_MACHINE = (errno.EAGAIN, errno.ENOMEM, errno.EMFILE, errno.ENFILE)  # why a program does not start that is sound


@dataclass(frozen=True)
class Outcome:
    status: str
    message: str = ""
    printed: str = ""    # by the student's code
    seconds: float = 0.0


def run_check(judge, number, workers, parameters=(), limits=Limits(), folder=None):
    """The outcome of check `number` in both precisions; `workers` has a program for each. `folder` is where they run; `judge` is a
    programs.Judge."""
    began, printed = time.monotonic(), ""
    for precision, worker in workers.items():
        try:
            with _Pair(judge, number, precision, worker, parameters, limits, folder) as pair:
                reason = pair.run()
            status, message = _outcome(pair, reason, limits)
            printed = printed or pair.printed["worker"].decode("utf-8", "replace")
        except _NotStarted as error:
            status, message = FAILED, f"the program could not be started: {error}"
        if status != PASSED:
            if status == FAILED and precision == "float":
                message = f"in float, {message}"
            break
    return Outcome(status, message, printed, time.monotonic() - began)


class _NotStarted(Exception):
    """The worker is no program that the system starts."""


class _Pair:
    """The two processes, the pipes between them, and what they print."""

    def __init__(self, judge, number, precision, worker, parameters, limits, folder):
        self.limits, self.printed = limits, {"judge": b"", "worker": b""}
        self.judged = False  # whether the judge has said all that it had to say
        self.ended_from_outside = False
        self.computing = seconds_computed()
        self.worker = self.judge = self.reference = None
        pipes, parent = [], os.getpid()
        solution = judge.reference.get(precision)

        def started(start, program, limits, output):
            """A worker, and the ends of the pipes on which it is asked and answers."""
            pipes.extend((*os.pipe(), *os.pipe()))
            question_out, question_in, reply_out, reply_in = pipes[-4:]
            return start([str(program), str(question_out), str(reply_in)], pass_fds=(question_out, reply_in), stdin=subprocess.DEVNULL,
                         stdout=output, stderr=subprocess.STDOUT, cwd=folder, env={}, start_new_session=True,
                         preexec_fn=lambda: confine(limits, parent)), (question_in, reply_out)
        try:
            self.worker, ends = started(_started, worker, limits.reaching(str(worker)), subprocess.PIPE)
            others = (-1, -1)
            if solution:
                self.reference, others = started(subprocess.Popen, solution, limits.of_judge(str(solution)), subprocess.DEVNULL)
            words = [number, precision, judge.seed(number, precision), *ends, *others,
                     *(f"{name}={value!r}" for name, value in parameters)]
            self.judge = subprocess.Popen(
                [str(judge.program), *map(str, words)], pass_fds=(*ends, *(others if solution else ())), stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=_without_preloading(),
                preexec_fn=lambda: confine(limits.of_judge(str(judge.program)), parent))
        except BaseException:
            self.end()
            raise
        finally:
            for pipe in pipes:
                os.close(pipe)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def run(self):
        """Lets them talk until the judge is done. Returns why it was cut short: "time", "asleep", "output" or ""."""
        patience, asleep = Patience(self.limits.clock * self.limits.seconds), 0
        with selectors.DefaultSelector() as selector:
            selector.register(self.worker.stdout, selectors.EVENT_READ, "worker")
            selector.register(self.judge.stdout, selectors.EVENT_READ, "judge")
            listening = {"worker", "judge"}
            while "judge" in listening:
                tick = patience.tick()
                if tick == 0:
                    return "asleep" if asleep >= 4 else "time"
                heard = selector.select(tick)
                asleep = 0 if heard or not self._all_asleep() else asleep + 1
                for key, _ in heard:
                    piece = os.read(key.fd, 1 << 16)
                    if not piece:
                        selector.unregister(key.fileobj)
                        listening.discard(key.data)
                    self.printed[key.data] += piece
                    if len(self.printed[key.data]) > self.limits.output:
                        return "output"
        self.judged = True
        return ""

    def _all_asleep(self):
        """Whether each waits for another, as none does that only lacks a processor (Linux)."""
        return all(_is_asleep(process.pid) for process in (self.worker, self.judge, self.reference) if process)

    def end(self):
        """Ends what still runs, with all that the worker may have started in its session."""
        if self.judge:
            try:
                self.judge.wait(timeout=1 if self.judged else 0)
            except subprocess.TimeoutExpired:
                self.judge.kill()
                self.judge.wait()
            self.judge.stdout.close()
        if self.reference:
            self.reference.kill()
            self.reference.wait()
        if self.worker:
            try:
                self.worker.wait(timeout=0.2 if self.judged else 0)  # no more questions: a sound worker ends by itself
                self.ended_from_outside = self.worker.returncode == -signal.SIGKILL  # a worker can't end itself so
            except subprocess.TimeoutExpired:
                pass
            end_group(self.worker.pid)
            self.worker.wait()
            self.computing = seconds_computed() - self.computing
            os.set_blocking(self.worker.stdout.fileno(), False)
            self.printed["worker"] += self.worker.stdout.read(1 << 16) or b""
            self.worker.stdout.close()


def _is_asleep(process):
    """Whether the system says so of all its threads."""
    try:
        states = [stat.read_bytes().rpartition(b") ")[2][:1] for stat in Path(f"/proc/{process}/task").glob("*/stat")]
    except OSError:
        return False
    return set(states) == {b"S"}


def _without_preloading():
    """What a caller has preloaded, or in vain, is not to speak among the judge's words."""
    return {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}


def _started(command, **options):
    try:
        return subprocess.Popen(command, **options)
    except OSError as error:
        if error.errno in OF_THE_MACHINE:
            raise
        raise _NotStarted(error.strerror) from None


def _outcome(pair, reason, limits):
    """Status and message, from the judge's verdict and from how the worker ended."""
    if reason == "time":
        return BROKEN, (f"no verdict after {limits.clock * limits.seconds:g} s by the clock, of which {pair.computing:.1f} s were spent "
                        "computing: the machine was busy")
    if reason == "asleep":
        return FAILED, "no answer: it waits for something that never happens, such as a lock that it holds itself"
    if reason == "output":
        return FAILED, f"stopped after it had printed more than {limits.output // 1024} KB"
    try:
        verdict = json.loads(pair.printed["judge"].decode("utf-8", "replace"))
        status, message = verdict["status"], verdict["message"]
    except (ValueError, KeyError, TypeError):
        said = pair.printed["judge"].decode("utf-8", "replace").strip()
        return BROKEN, f"the check itself failed, which is no fault of yours: {said or pair.judge.returncode}"
    if status == "silent":
        out_of_time = pair.worker.returncode == -signal.SIGXCPU or pair.ended_from_outside and pair.computing >= limits.seconds
        if pair.ended_from_outside and not out_of_time:
            return BROKEN, "the program was ended from outside; is there too little memory?"
        return FAILED, _no_end(limits) if out_of_time else _silence(pair)
    if limits.sealed and f'"{os.strerror(errno.EPERM)}' in message:
        message += ". What is graded can only calculate: it may start no thread and no program, and open no file"
    return {"passed": PASSED, "todo": TODO}.get(status, FAILED), message


def _no_end(limits):
    return f"no answer after {limits.seconds:g} seconds. Is there a loop that never ends?"


def _silence(pair):
    """Why the worker gave no answer."""
    code, last = pair.worker.returncode, _last_line(pair.printed["worker"])
    said = f' Its last words: "{last}"' if last else ""
    if code >= 0:
        return f"the program ended by itself, with exit code {code}, before it had answered.{said}"
    names = {signal.SIGSEGV: "it read or wrote where nothing is, such as past the end of a list",
             signal.SIGABRT: "it gave up, as after a failed assertion or an exception that nobody caught",
             signal.SIGFPE: "a whole number was divided by zero",
             signal.SIGXFSZ: "it wrote a file larger than it may",
             signal.SIGKILL: "it went on without a way to answer, which it had closed",
             signal.SIGPIPE: "it wrote to a pipe that nobody reads"}
    return f"the program crashed: {names.get(-code, f'signal {-code}')}.{said}"


def _last_line(printed):
    lines = printed.decode("utf-8", "replace").strip().splitlines()
    return lines[-1][:300] if lines else ""
