# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep: files that -o may lead to, and streams that are closed when the program starts."""

import os
import shutil
import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM, run
from sweeps import SHORT, SweepTest


class Closed(SweepTest):
    """Where a standard stream is closed when the program starts, no part or result gets its file descriptor."""

    def run_without(self, streams, *arguments):
        def close():
            for stream in streams:
                os.close(stream)
        return subprocess.run([PROGRAM, *arguments], preexec_fn=close, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, env=ENVIRONMENT, timeout=60)

    def test_of_stdin_stdout_and_stderr_any_may_be_closed(self):
        whole = self.swept(SHORT, out="whole.h5")
        self.swept(SHORT, "--shard", "1/2", out="half.shard")
        for streams in ((0,), (1,), (2,), (1, 2), (0, 1, 2)):
            with self.subTest(closed=streams):
                shutil.copy(self.path("half.shard"), self.path("out.h5.part-0-8"))
                done = self.run_without(streams, "sweep", self.path("sweep.toml"), "--resume", "-o",
                                        self.path("out.h5"))
                # That results cannot be printed is a failure, but the file is there.
                self.assertEqual(done.returncode, 1 if 1 in streams else 0, done.stderr)
                self.assertEqual(done.stdout, b"" if 1 in streams else whole.out.encode())
                self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))
                os.remove(self.path("out.h5"))

    def test_other_commands_fail_where_stdout_is_closed(self):
        self.assertEqual(self.run_without((1,), "--version").returncode, 1)
        self.assertEqual(self.run_without((0, 2), "--version").returncode, 0)


class Outputs(SweepTest):
    """Files that -o may lead to."""

    def test_an_input_is_not_replaced(self):
        path = self.folder.write("sweep.toml", SHORT)
        for options in ((), ("--force",), ("--resume",)):
            self.assert_refused(run("sweep", path, "-o", path, *options), "sweep.toml")
        os.symlink(path, self.path("link"))
        self.assert_refused(run("sweep", path, "-o", self.path("link"), "--force"), "link")
        self.assertEqual(self.bytes_of("sweep.toml"), SHORT.encode())
        self.swept(SHORT, "--shard", "1/1", out="all.shard")
        shard = self.bytes_of("all.shard")
        for out in ("all.shard", "./all.shard"):
            merged = run("sweep", "merge", self.path("all.shard"), "-o", self.path(out), "--force")
            self.assert_refused(merged, "all.shard")
        os.rename(self.path("all.shard"), self.path("out.h5.part-0-9"))
        merged = run("sweep", "merge", self.path("out.h5.part-0-9"), "-o", self.path("out.h5"),
                     "--force")
        self.assert_refused(merged, "part of", "another file")
        self.assertEqual(self.bytes_of("out.h5.part-0-9"), shard)

    def test_a_merge_does_not_throw_away_a_stopped_sweeps_parts_unless_forced(self):
        self.swept(SHORT, "--shard", "1/1", out="all.shard")
        self.swept(SHORT, "--shard", "1/2", out="out.h5.part-0-8")
        merge = ["sweep", "merge", self.path("all.shard"), "-o", self.path("out.h5")]
        self.assert_refused(run(*merge), "out.h5.part-0-8", "--force")
        self.assertEqual(run(*merge, "--force").code, 0)
        self.assertEqual(self.names(), ["all.shard", "out.h5", "sweep.toml"])

    def test_symbolic_links_are_followed(self):
        self.swept(SHORT, out="whole.h5")
        os.mkdir(self.path("elsewhere"))
        os.symlink("elsewhere/behind.h5", self.path("out.h5"))
        os.symlink("out.h5", self.path("more.h5"))
        for out in ("out.h5", "more.h5"):  # the link leads to no file, then to a result
            self.swept(SHORT, "--force", out=out)
            self.assertTrue(os.path.islink(self.path(out)))
            self.assertEqual(self.bytes_of("elsewhere/behind.h5"), self.bytes_of("whole.h5"))
        self.assertEqual(os.listdir(self.path("elsewhere")), ["behind.h5"])
        os.symlink("circle.h5", self.path("circle.h5"))
        self.assert_refused(self.sweep(SHORT, out="circle.h5"), "circle.h5", "circle")

    def test_what_is_no_regular_file_is_refused_and_hangs_nothing(self):
        os.mkfifo(self.path("fifo"))
        path = self.folder.write("sweep.toml", SHORT)
        for options in ((), ("--force",), ("--resume",)):
            self.assert_refused(self.sweep(SHORT, *options, out="fifo"), "fifo", "no regular file")
        self.assert_refused(run("sweep", path, "-o", "/dev/null", "--force"), "/dev/null")
        self.assert_refused(run("sweep", "show", self.path("fifo")), "fifo", "no regular file")
        merged = run("sweep", "merge", self.path("fifo"), "-o", self.path("out.h5"))
        self.assert_refused(merged, "fifo", "no regular file")
        os.rename(self.path("fifo"), self.path("out.h5.part-0-9"))
        self.assert_refused(self.sweep(SHORT, "--resume"), "part-0-9", "no regular file")
        os.rename(self.path("out.h5.part-0-9"), self.path("out.h5.lock"))
        self.assert_refused(self.sweep(SHORT), "out.h5.lock", "no regular file")
        os.rename(self.path("out.h5.lock"), self.path("out.h5.part"))
        self.assert_refused(self.sweep(SHORT), "out.h5.part", "no regular file")
        os.remove(self.path("out.h5.part"))
        self.swept(SHORT)


if __name__ == "__main__":
    unittest.main()
