# SPDX-License-Identifier: Apache-2.0
"""The children of a program end with it, however it ends, and each command stops soon after Ctrl-C."""

import os
import pathlib
import shlex
import signal
import stat
import subprocess
import sys
import time
import unittest

from program import ENVIRONMENT, PROGRAM, ProgramTest, quiet_scene

ROOT = pathlib.Path(os.environ["TRIBOCHECK_ROOT"])
PYTHON = sys.executable
SOON = 10  # seconds; an end takes some milliseconds, more on a busy machine; processes that are left would run for 60 or more

# Leaves a child in its group, one in a session of its own, and one whose parent has ended; all ignore the signals that can be ignored.
LEAVER = f'''
import os, signal, sys, time
def leave(prepare):
    if os.fork() == 0:
        prepare()
        for one in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(one, signal.SIG_IGN)
        with open(sys.argv[1] + "/" + str(os.getpid()), "w"):
            pass
        signal.alarm(90)
        while True:
            time.sleep(60)
def daemon():
    os.setsid()
    if os.fork():
        os._exit(0)
leave(lambda: None)
leave(os.setsid)
leave(daemon)
while len(os.listdir(sys.argv[1])) < 3:
    time.sleep(0.01)
how = sys.argv[2]
if how == "exits":
    sys.exit(0)
if how == "crashes":
    os.abort()
if how == "answers":
    sys.path.insert(0, {str(ROOT / "verification/conformance/subjects/python_stdlib")!r})
    import subject
    for line in sys.stdin:
        print(subject.answer_text(line), flush=True)
open(sys.argv[1] + "/waits", "w").close()
signal.alarm(90)
while True:
    time.sleep(60)
'''


def is_running(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


def wait_until(what, seconds):
    end = time.monotonic() + seconds
    while not what() and time.monotonic() < end:
        time.sleep(0.01)
    return what()


class Left(ProgramTest):
    """Processes that a subject leaves behind, with a new session and a new parent."""

    def setUp(self):
        super().setUp()
        self.script = self.folder.write("leaver.py", LEAVER)
        self.addCleanup(lambda: [os.kill(one, signal.SIGKILL) for one in self.left() if is_running(one)])

    def pids(self):
        return pathlib.Path(self.folder.path("pids"))

    def left(self):
        return [int(one) for one in os.listdir(self.pids()) if one.isdigit()] if self.pids().exists() else []

    def verify(self, how, *options):
        self.pids().mkdir(exist_ok=True)
        command = shlex.join([PYTHON, "-B", self.script, str(self.pids()), how])
        # AddressSanitizer would turn SIGSEGV into an exit code.
        return subprocess.Popen([PROGRAM, "verify", "--subject", command, "--sample", "1", *options],
                                env={**ENVIRONMENT, "ASAN_OPTIONS": ENVIRONMENT["ASAN_OPTIONS"] + ":handle_segv=0"},
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def assert_none_left(self, how):
        self.assertGreaterEqual(len(self.left()), 3, how)
        self.assertTrue(wait_until(lambda: not any(map(is_running, self.left())), SOON),
                        f"{how}: {[one for one in self.left() if is_running(one)]} are left")
        for one in list(self.pids().iterdir()):
            one.unlink()

    def test_none_is_left_however_the_subject_ends(self):
        for how, options in {"exits": (), "crashes": (), "answers": (), "waits": ("--case-timeout", "0.3",
                                                                                  "--start-timeout", "2")}.items():
            with self.verify(how, *options) as process:
                process.wait(60)
                self.assert_none_left(how)

    def test_none_is_left_however_verify_ends(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGSEGV, signal.SIGKILL):
            with self.verify("waits") as process:
                self.assertTrue(wait_until((self.pids() / "waits").exists, 20), number)
                process.send_signal(number)
                self.assertEqual(process.wait(SOON), -number)
                self.assert_none_left(number)

    def test_what_the_shell_starts_beside_the_subject_ends_with_it(self):
        self.pids().mkdir()
        pid = shlex.quote(str(self.pids()))
        with subprocess.Popen([PROGRAM, "verify", "--sample", "1", "--subject",
                               f"sleep 90 & touch {pid}/$!; setsid sleep 90 & touch {pid}/$!; touch {pid}/$$; true"],
                              env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            process.wait(60)
            self.assert_none_left("shell")

    def test_nobody_else_is_ended(self):
        with subprocess.Popen(["sleep", "60"]) as other:
            with self.verify("exits") as process:
                process.wait(60)
            self.assertIsNone(other.poll())
            other.kill()


class Stopping(ProgramTest):
    """Ctrl-C reaches each process of the terminal's group; `kill` reaches the program alone."""

    def fake(self, name):
        """A folder for PATH with a program of that name, which tells that it runs and then never ends."""
        path = pathlib.Path(self.folder.write(name, f"#!/bin/sh\necho $$ > {self.folder.path('pid')}\n"
                                                    "trap '' INT TERM\nwhile :; do sleep 1; done\n"))
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return {**ENVIRONMENT, "PATH": f"{self.folder.name}:{os.environ['PATH']}"}

    def assert_stops(self, command, environment, ready, stdin=None):
        for number in (signal.SIGINT, signal.SIGTERM):
            for of_group in (True, False):
                with self.subTest(command=command, number=number, of_group=of_group):
                    pathlib.Path(self.folder.path("pid")).unlink(missing_ok=True)
                    process = subprocess.Popen([PROGRAM, *command], env=environment, stdin=stdin, stdout=subprocess.PIPE,
                                               stderr=subprocess.STDOUT, start_new_session=True)
                    with process:
                        self.assertTrue(wait_until(ready, 60))
                        (os.killpg if of_group else os.kill)(process.pid, number)
                        process.wait(SOON)
                        self.assertIn(process.returncode, (-number, 128 + number))
                        process.stdout.read()  # ends, because no process holds it any longer

    def says_pid(self):
        path = pathlib.Path(self.folder.path("pid"))
        return path.exists() and path.read_text().strip() != ""

    def assert_child_gone(self):
        pid = int(pathlib.Path(self.folder.path("pid")).read_text())
        self.assertTrue(wait_until(lambda: not is_running(pid), SOON))

    def test_verify_of_a_slow_subject(self):
        subject = f"echo $$ > {self.folder.path('pid')}; sleep 60"
        self.assert_stops(["verify", "--subject", subject], ENVIRONMENT, self.says_pid)
        self.assert_child_gone()

    def test_report_while_gnuplot_runs(self):
        out = self.folder.path("out")
        self.assert_stops(["report", "--out", out, "--section", "figures"], self.fake("gnuplot"), self.says_pid)
        self.assert_child_gone()

    def test_bench_while_its_child_runs(self):
        bench = pathlib.Path(PROGRAM).parent / "tribocheck_bench"
        if not bench.exists():  # a build with sanitizers has none
            return

        def ready():
            time.sleep(0.5)
            return True
        self.assert_stops(["bench", "--quick", "--filter", "curve_200"], ENVIRONMENT, ready)

    def test_reproduce_and_stream_and_solve(self):
        def soon():
            time.sleep(0.1)
            return True
        self.assert_stops(["stream"], ENVIRONMENT, soon, stdin=subprocess.PIPE)
        scene = quiet_scene(speed={"from": 1e-4, "to": 3, "count": 1000000})
        path = self.folder.write("long.toml", scene)
        self.assert_stops(["solve", path], ENVIRONMENT, soon)
        self.assert_stops(["reproduce"], ENVIRONMENT, soon)


if __name__ == "__main__":
    unittest.main()
