# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep under faults: killed at any moment, stopped, on a full disk, with damaged files. What
is resumed ends in the bytes of an undisturbed run. TRIBOCHECK_KILLS asks for more kills than five."""

import os
import random
import resource
import signal
import subprocess
import time
import unittest

from program import ENVIRONMENT, PROGRAM, run, start
from sweeps import LONG, UNIFORM, SweepTest, sweep

KILLS = int(os.environ.get("TRIBOCHECK_KILLS", 5))
SHORT = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 1.0]"}, draws=5000)


class Killed(SweepTest):
    def started(self, *options, **more):
        path = self.folder.write("sweep.toml", LONG)
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, **more}
        return start("sweep", path, "-o", self.path("out.h5"), *options, **quiet)

    def undisturbed(self):
        begin = time.monotonic()
        self.swept(LONG, out="whole.h5")
        return time.monotonic() - begin

    def assert_resumes_to(self, whole):
        result = self.sweep(LONG, "--resume")
        self.assertEqual(result.code, 0, result.err)
        self.assertEqual(self.bytes_of("out.h5"), whole)
        self.assertEqual(self.names(), ["out.h5", "sweep.toml", "whole.h5"])

    def test_killed_at_random_moments_and_resumed_it_ends_in_the_same_bytes(self):
        seconds = self.undisturbed()
        whole = self.bytes_of("whole.h5")
        draw = random.Random(7)
        kept = []
        for kill in range(KILLS):
            with self.subTest(kill=kill):
                process = self.started()
                time.sleep(draw.uniform(0, seconds))
                process.kill()
                process.wait()
                if draw.random() < 0.5 and not os.path.exists(self.path("out.h5")):
                    self.killed_once_more(draw.uniform(0, seconds / 2))
                kept.append(self.kept_bytes())
                self.assert_resumes_to(whole)
                os.remove(self.path("out.h5"))
        print(f"{KILLS} kills; bytes in the journal: {kept}", flush=True)

    def killed_once_more(self, seconds):
        process = self.started("--resume")
        time.sleep(seconds)
        process.kill()
        process.wait()

    def kept_bytes(self):
        path = self.path("out.h5.journal-0")
        return os.path.getsize(path) if os.path.exists(path) else 0

    def test_ctrl_c_keeps_what_is_computed_and_says_how_to_go_on(self):
        self.undisturbed()
        whole = self.bytes_of("whole.h5")
        process = self.started(stderr=subprocess.PIPE)
        self.wait_for_journal()
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, said)
        self.assertIn(b"--resume goes on", said)
        self.assert_resumes_to(whole)

    def wait_for_journal(self):
        end = time.monotonic() + 30
        while self.kept_bytes() < 5000 and time.monotonic() < end:
            time.sleep(0.002)

    def test_a_second_process_does_not_write_into_the_same_journal(self):
        process = self.started()
        self.wait_for_journal()
        process.send_signal(signal.SIGSTOP)
        second = self.sweep(LONG, "--resume")
        process.kill()
        process.wait()
        self.assertEqual((second.code, second.out), (1, ""))
        self.assertIn("journal-0", second.err)


class Disks(SweepTest):
    def limited(self, most, *options):
        path = self.folder.write("sweep.toml", SHORT)
        done = subprocess.run(
            [PROGRAM, "sweep", path, "-o", self.path("out.h5"), *options], capture_output=True,
            env=ENVIRONMENT, timeout=60, text=True,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)))
        return done

    def test_a_full_disk_is_told_and_what_is_computed_is_kept(self):
        self.swept(SHORT, out="whole.h5")
        whole = self.bytes_of("whole.h5")
        size = len(whole)
        for most in (100, 5000, size // 2, size - 100):
            with self.subTest(most=most):
                done = self.limited(most)
                self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertIn("out.h5", done.stderr)
                self.assertNotIn("out.h5.part", self.names())
                resumed = self.sweep(SHORT, "--resume")
                self.assertEqual(resumed.code, 0, resumed.err)
                self.assertEqual(self.bytes_of("out.h5"), whole)
                os.remove(self.path("out.h5"))

    def test_a_folder_that_is_not_there_or_not_writable(self):
        for out in ("none/out.h5", "sweep.toml/out.h5"):
            result = self.sweep(SHORT, out=out)
            self.assertEqual((result.code, result.out), (1, ""), result.err)
            self.assertEqual(len(result.error_lines), 1, result.err)
            self.assertIn(out, result.err)
        self.assert_refused(self.sweep(SHORT, out="."), "directory")

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full")
    def test_stdout_that_is_full(self):
        path = self.folder.write("sweep.toml", SHORT)
        with open("/dev/full", "wb") as full:
            process = start("sweep", path, "-o", self.path("out.h5"), stdout=full,
                            stderr=subprocess.PIPE)
            _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, said)
        self.assertTrue(os.path.exists(self.path("out.h5")))


class Damage(SweepTest):
    """A journal of some chunks, in every state that a crash or a bad disk may leave it in."""

    def setUp(self):
        super().setUp()
        self.swept(SHORT, out="whole.h5")
        self.whole = self.bytes_of("whole.h5")
        self.swept(SHORT, "--shard", "1/1", out="all.shard")
        self.journal = self.bytes_of("all.shard")

    def resumed(self, journal):
        with open(self.path("out.h5.journal-0"), "wb") as file:
            file.write(journal)
        return self.sweep(SHORT, "--resume")

    def test_a_journal_cut_anywhere_is_gone_on_with(self):
        draw = random.Random(3)
        for cut in sorted(draw.randrange(len(self.journal)) for _ in range(12)):
            with self.subTest(cut=cut):
                result = self.resumed(self.journal[:cut])
                if result.code == 0:
                    self.assertEqual(self.bytes_of("out.h5"), self.whole)
                    os.remove(self.path("out.h5"))
                else:  # not even the header is whole
                    self.assertEqual(result.code, 2, result.err)
                    self.assertLess(cut, 3000)
                    os.remove(self.path("out.h5.journal-0"))

    def test_a_flipped_bit_costs_its_chunk_alone(self):
        draw = random.Random(5)
        for _ in range(12):
            at = draw.randrange(3000, len(self.journal))
            with self.subTest(at=at):
                damaged = bytearray(self.journal)
                damaged[at] ^= 1 << draw.randrange(8)
                result = self.resumed(bytes(damaged))
                self.assertEqual(result.code, 0, result.err)
                self.assertIn("no whole record", result.err)
                self.assertEqual(self.bytes_of("out.h5"), self.whole)
                os.remove(self.path("out.h5"))

    def test_a_journal_of_another_sweep_or_of_none_is_refused_with_the_reason(self):
        with open(self.path("out.h5.journal-0"), "wb") as file:
            file.write(self.journal)
        other = SHORT.replace("draws = 5000", "draws = 5001")
        self.assert_refused(self.sweep(other, "--resume"), "journal-0", "another sweep")
        self.assert_refused(self.sweep(SHORT), "--resume goes on", "--force")
        self.assert_refused(self.resumed(b"what is this? " * 100), "journal-0")
        forced = self.sweep(SHORT, "--force")
        self.assertEqual(forced.code, 0, forced.err)
        self.assertEqual(self.bytes_of("out.h5"), self.whole)

    def test_a_journal_of_another_version_is_refused(self):
        self.assertIn(b"0.1.0", self.journal)
        changed = self.resumed(self.journal.replace(b"0.1.0", b"0.0.9"))
        self.assert_refused(changed, "journal-0")  # its checksum does not hold either

    def test_another_instruction_set_is_refused_unless_asked_for(self):
        sets = run("sweep", "sweep.toml", "-o", "x", "--instruction-set", "?").err
        other = [name.strip() for name in sets.split("allowed here:")[1].split(",")][-1]
        self.swept(SHORT, "--shard", "1/2", "--instruction-set", other, out="1.shard")
        self.swept(SHORT, "--shard", "2/2", out="2.shard")
        merge = ["sweep", "merge", self.path("1.shard"), self.path("2.shard"), "-o",
                 self.path("merged.h5")]
        self.assert_refused(run(*merge), other)
        self.assertEqual(run(*merge, "--any-instruction-set").code, 0)
        os.rename(self.path("1.shard"), self.path("out.h5.journal-0"))
        self.assert_refused(self.sweep(SHORT, "--resume"), other, "--any-instruction-set")
        went_on = self.sweep(SHORT, "--resume", "--any-instruction-set")
        self.assertEqual(went_on.code, 0, went_on.err)

    def test_a_result_that_is_there_is_kept_or_refused(self):
        result = self.sweep(SHORT, out="whole.h5")
        self.assert_refused(result, "whole.h5", "--force")
        kept = self.sweep(SHORT, "--resume", out="whole.h5")
        self.assertEqual((kept.code, self.bytes_of("whole.h5")), (0, self.whole), kept.err)
        other = SHORT.replace("draws = 5000", "draws = 500")
        self.assert_refused(self.sweep(other, "--resume", out="whole.h5"), "another sweep")
        self.assertEqual(self.bytes_of("whole.h5"), self.whole)
        for damaged in (self.whole[: len(self.whole) // 2], b"", b"no HDF5 at all"):
            with open(self.path("cut.h5"), "wb") as file:
                file.write(damaged)
            self.assert_refused(self.sweep(SHORT, "--resume", out="cut.h5"), "cut.h5")
            self.assert_refused(run("sweep", "show", self.path("cut.h5")), "cut.h5")


if __name__ == "__main__":
    unittest.main()
