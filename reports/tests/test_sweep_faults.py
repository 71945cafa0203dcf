# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep under faults: killed at any moment, stopped, on a full disk, with damaged files. A
resumed run gives the bytes of an undisturbed one. TRIBOCHECK_KILLS asks for more kills than five."""

import os
import random
import resource
import shutil
import signal
import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM, run, start
from sweeps import DAYS, LONG, MINI, SHORT, SweepTest, opened, sealed

KILLS = int(os.environ.get("TRIBOCHECK_KILLS", 5))


class Killed(SweepTest):
    def started(self, *options, **more):
        path = self.folder.write("sweep.toml", LONG)
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, **more}
        return start("sweep", path, "-o", self.path("out.h5"), *options, **quiet)

    def assert_resumes_to(self, whole):
        self.sweep(LONG, "--resume").ended(0)
        self.assertEqual(self.bytes_of("out.h5"), whole)
        self.assertEqual(self.names(), ["out.h5", "sweep.toml", "whole.h5"])

    def test_killed_at_random_moments_and_resumed_it_ends_in_the_same_bytes(self):
        def begin(*options):
            return [self.quietly(MINI, self.path("out.h5"), *options, "--threads", "3")]
        self.check_kills(KILLS, begin, lambda: None, lambda process, _: process.pid)

    def test_shards_that_are_killed_and_resumed_end_in_the_same_bytes(self):
        shards = [self.path(f"{i}.shard") for i in (1, 2)]

        def begin(*options):
            return [self.quietly(MINI, shard, "--shard", f"{i + 1}/2", *options) for i, shard in enumerate(shards)]

        def merge():
            run("sweep", "merge", *shards, "-o", self.path("out.h5")).ended(0)
        self.check_kills(KILLS, begin, merge, lambda process, _: process.pid)

    def quietly(self, text, out, *options):
        return start("sweep", self.folder.write("sweep.toml", text), "-o", out, *options, stdout=subprocess.DEVNULL,
                     stderr=subprocess.DEVNULL)

    def test_ctrl_c_keeps_what_is_computed_and_says_how_to_go_on(self):
        self.swept(LONG, out="whole.h5")
        whole = self.bytes_of("whole.h5")
        process = self.started(stderr=subprocess.PIPE)
        self.wait_for_parts()
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, said)
        self.assertIn(b"--resume goes on", said)
        self.assert_resumes_to(whole)

    def test_a_second_process_is_refused_whatever_it_was_asked(self):
        self.swept(SHORT, "--shard", "1/1", name="short.toml", out="short.shard")
        process = self.stopped(self.started())
        for options in ((), ("--resume",), ("--force",)):
            self.assert_refused(self.sweep(LONG, *options), "out.h5", "another process")
        merged = run("sweep", "merge", self.path("short.shard"), "-o", self.path("out.h5"), "--force")
        self.assert_refused(merged, "out.h5", "another process")
        process.send_signal(signal.SIGCONT)
        self.assertEqual(process.wait(timeout=60), 0)
        self.swept(LONG, out="whole.h5")
        self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))

    def said_after(self, disturb):
        """The exit code and the messages of a run that is stopped in the middle, disturbed, and continued."""
        process = self.stopped(self.started(stderr=subprocess.PIPE))
        disturb()
        process.send_signal(signal.SIGCONT)
        _, said = process.communicate(timeout=60)
        self.assertLessEqual(len(said.splitlines()), 1, said)
        return process.returncode, said.decode()

    def test_what_others_do_to_its_parts_is_told_or_made_good(self):
        self.swept(LONG, out="whole.h5")
        whole = self.bytes_of("whole.h5")
        self.swept(SHORT, "--shard", "1/1", name="short.toml", out="short.shard")
        os.remove(self.path("short.toml"))

        def first():
            return self.path(self.parts()[0])

        def damage():
            with open(first(), "r+b") as file:
                file.seek(os.path.getsize(first()) // 2)
                file.write(bytes(100))
        for disturb, told in ((lambda: os.remove(first()), ""), (damage, "is computed anew")):
            code, said = self.said_after(disturb)
            self.assertEqual((code, self.bytes_of("out.h5")), (0, whole), said)
            self.assertIn(told, said)
            self.assertEqual(self.names(), ["out.h5", "short.shard", "sweep.toml", "whole.h5"])
            os.remove(self.path("out.h5"))
        foreign = []

        def put_foreign():
            foreign.append(first())
            shutil.copy(self.path("short.shard"), first())
        code, said = self.said_after(put_foreign)
        self.assertEqual(code, 1, said)
        self.assertIn(os.path.basename(foreign[0]) + " is of another sweep", said)
        self.assert_refused(self.sweep(LONG, "--resume"), "another sweep")
        os.remove(foreign[0])
        os.remove(self.path("short.shard"))
        self.assert_resumes_to(whole)
        os.remove(self.path("out.h5"))
        code, said = self.said_after(lambda: os.remove(self.path("out.h5.lock")))
        self.assertEqual(code, 1, said)
        self.assertIn("out.h5.lock was removed", said)
        self.assertNotIn("out.h5", self.names())
        self.assert_resumes_to(whole)

    def test_force_keeps_the_old_result_until_the_new_one_is_whole(self):
        self.swept(SHORT, name="short.toml")
        old = self.bytes_of("out.h5")
        process = self.stopped(self.started("--force"))
        self.assertEqual(self.bytes_of("out.h5"), old)
        process.kill()
        process.wait()
        self.assertEqual(self.bytes_of("out.h5"), old)
        self.swept(LONG, out="whole.h5")
        os.remove(self.path("short.toml"))
        self.assert_resumes_to(self.bytes_of("whole.h5"))


    def test_force_that_was_stopped_before_its_first_part_is_gone_on_with(self):
        self.swept(SHORT, name="short.toml")
        old = self.bytes_of("out.h5")
        for end in (signal.SIGKILL, signal.SIGINT):
            process = start("sweep", self.folder.write("days.toml", DAYS), "-o", self.path("out.h5"), "--force",
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.wait_until(lambda: any(name.startswith("out.h5.part-") for name in self.names()))
            process.send_signal(end)
            process.wait()
            self.assertEqual((self.bytes_of("out.h5"), self.parts()), (old, []))
            self.assert_refused(self.sweep(SHORT.replace("5000", "5001"), "--resume"), "out.h5", "--force")
            process = start("sweep", self.path("days.toml"), "-o", self.path("out.h5"), "--resume",
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            self.assertIn(b"is replaced", process.stderr.readline())
            self.assertIn(b"nothing to go on with; starting anew", process.stderr.readline())
            process.send_signal(signal.SIGINT)
            process.communicate()
            self.assertEqual(process.returncode, 130)
        os.replace(self.path("out.h5"), self.path("old.h5"))
        shutil.copy(self.path("old.h5"), self.path("out.h5"))  # a copy, not the file that --force was to replace
        self.assert_refused(self.sweep(DAYS, "--resume"), "out.h5", "--force")


class Disks(SweepTest):
    def limited(self, most, *options):
        path = self.folder.write("sweep.toml", SHORT)
        # libhdf5 1.10.8 leaks the memory of a file if closing it fails.
        environment = dict(ENVIRONMENT, ASAN_OPTIONS=ENVIRONMENT["ASAN_OPTIONS"] + ":detect_leaks=0")
        done = subprocess.run(
            [PROGRAM, "sweep", path, "-o", self.path("out.h5"), *options], capture_output=True,
            env=environment, timeout=60, text=True,
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
                self.sweep(SHORT, "--resume").ended(0)
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
    """Parts in every state that a crash or a bad disk may leave them in."""

    def setUp(self):
        super().setUp()
        self.swept(SHORT, out="whole.h5")
        self.whole = self.bytes_of("whole.h5")
        self.swept(SHORT, "--shard", "1/1", out="all.shard")
        self.part = self.bytes_of("all.shard")  # a shard is a part with all its chunks

    def resumed(self, part):
        self.put("out.h5.part-0-9", part)
        return self.sweep(SHORT, "--resume")

    def assert_whole(self, result):
        self.assertEqual((result.code, self.bytes_of("out.h5")), (0, self.whole), result.err)
        self.assertEqual([name for name in self.names() if name.startswith("out.h5")], ["out.h5"])
        os.remove(self.path("out.h5"))

    def test_a_part_cut_anywhere_is_computed_anew(self):
        draw = random.Random(3)
        for cut in [0, 8, 48, *sorted(draw.randrange(len(self.part)) for _ in range(12))]:
            with self.subTest(cut=cut):
                result = self.resumed(self.part[:cut])
                if result.code == 0:
                    self.assertIn("is computed anew", result.err)
                    self.assert_whole(result)
                else:  # the file that is left lacks the mark of a part
                    self.assertEqual(result.code, 2, result.err)
                    self.assertLess(cut, 3000)
                    self.assertEqual(self.bytes_of("out.h5.part-0-9"), self.part[:cut])
                    os.remove(self.path("out.h5.part-0-9"))

    def test_a_flipped_bit_costs_its_part_alone(self):
        for part in (1, 2):
            self.swept(SHORT, "--shard", f"{part}/2", out=f"{part}.shard")
        first, second = self.bytes_of("1.shard"), self.bytes_of("2.shard")
        draw = random.Random(5)
        for _ in range(12):
            at = draw.randrange(3000, len(first))
            with self.subTest(at=at):
                damaged = bytearray(first)
                damaged[at] ^= 1 << draw.randrange(8)
                self.put("out.h5.part-0-8", damaged)
                self.put("out.h5.part-1-9", second)
                result = self.sweep(SHORT, "--resume")
                self.assertIn("out.h5.part-0-8 is damaged", result.err)
                self.assertIn("going on: 5 of 10 chunks are there", result.err)
                self.assert_whole(result)

    def test_what_is_no_part_is_left_as_it_is(self):
        for content in (b"what is this? " * 100, self.whole):
            self.assert_refused(self.resumed(content), "out.h5.part-0-9", "is left as it is")
            self.assertEqual(self.bytes_of("out.h5.part-0-9"), content)
        self.assert_whole(self.sweep(SHORT, "--force"))

    def test_a_shard_is_gone_on_with_as_the_same_shard_alone(self):
        for part in ("1/2", "2/2", "2/4"):
            self.swept(SHORT, "--shard", part, out=part.replace("/", "of"))
        for there, asked in (("1of2", "2/2"), ("2of4", "2/2"), ("2of2", "2/4"), ("2of2", "1/1")):
            with self.subTest(there=there, asked=asked):
                before = self.bytes_of(there)
                self.assert_refused(self.sweep(SHORT, "--shard", asked, "--resume", out=there),
                                    there, "another shard")
                self.assertEqual(self.bytes_of(there), before)
        self.assert_refused(self.sweep(SHORT, "--resume", out="1of2"), "1of2")
        self.sweep(SHORT, "--shard", "1/2", "--resume", out="1of2").ended(0)
        os.rename(self.path("1of2"), self.path("x.shard.part-0-8"))
        refused = self.sweep(SHORT, "--shard", "2/2", "--resume", out="x.shard")
        self.assert_refused(refused, "x.shard.part-0-8", "another shard")
        self.sweep(SHORT, "--shard", "1/2", "--resume", out="x.shard").ended(0)

    def test_a_part_of_another_sweep_is_refused_with_the_reason(self):
        self.put("out.h5.part-0-9", self.part)
        other = SHORT.replace("draws = 5000", "draws = 5001")
        self.assert_refused(self.sweep(other, "--resume"), "part-0-9", "another sweep")
        self.assert_refused(self.sweep(SHORT), "--resume goes on", "--force")
        self.assert_whole(self.sweep(SHORT, "--force"))

    def test_a_journal_of_an_older_tribocheck_gets_one_line(self):
        journal = b"\x93TBSJ1\r\n" + bytes(1000)
        self.put("out.h5.journal-0", journal)
        for options in ((), ("--resume",), ("--join",)):
            self.assert_refused(self.sweep(SHORT, *options), "out.h5.journal-0", "older tribocheck", "--force")
        self.assertEqual(self.bytes_of("out.h5.journal-0"), journal)
        for command in (["show", self.path("out.h5.journal-0")],
                        ["merge", self.path("out.h5.journal-0"), "-o", self.path("merged.h5")]):
            self.assert_refused(run("sweep", *command), "out.h5.journal-0")
        self.assert_whole(self.sweep(SHORT, "--force"))

    def changed(self, content=None, **attributes):
        """The part, or another file, with other attributes and the right checksum."""
        import h5py
        self.put("changed", (content or self.part)[:-24])
        with h5py.File(self.path("changed"), "r+") as file:
            for name, value in attributes.items():
                file.attrs.modify(name, value)
        return sealed(self.bytes_of("changed"))

    def test_a_part_of_another_version_is_gone_on_with_if_its_numbers_are_the_same(self):
        import numpy
        result = self.resumed(self.changed(tribocheck_version="0.0.9"))
        self.assertIn("going on: 10 of 10 chunks are there", result.err)
        self.assert_whole(result)
        other = self.changed(tribocheck_version="0.0.9", numbers=numpy.uint64(1))
        self.assert_refused(self.resumed(other), "part-0-9 was computed by tribocheck 0.0.9, whose numbers")
        self.put("old.shard", other)
        self.assert_refused(run("sweep", "merge", self.path("old.shard"), "-o", self.path("merged.h5")), "old.shard",
                            "whose numbers")

    def test_a_result_of_another_version_is_shown_and_done_if_its_numbers_are_the_same(self):
        for changes, is_mine in (({}, True), ({"sweep_digest": "0" * 32}, False)):
            old = self.changed(self.whole, tribocheck_version="0.0.9", **changes)
            self.put("out.h5", old)
            self.assertEqual(run("sweep", "show", self.path("out.h5"), "--format", "json").json()["tribocheck_version"], "0.0.9")
            result = self.sweep(SHORT, "--resume")
            if is_mine:
                self.assertEqual((result.code, result.err), (0, ""))
            else:
                self.assert_refused(result, "out.h5 was computed by tribocheck 0.0.9, this is ", "--force replaces it")
            self.assertEqual(self.bytes_of("out.h5"), old)
            os.remove(self.path("out.h5"))

    def test_an_arithmetic_with_other_bits_is_refused_unless_asked_for(self):
        self.swept(SHORT, "--shard", "1/2", "--without-fma", out="1.shard")
        self.swept(SHORT, "--shard", "2/2", out="2.shard")
        merge = ["sweep", "merge", self.path("1.shard"), self.path("2.shard"), "-o",
                 self.path("merged.h5")]
        own = self.set_of("whole.h5")
        if own.startswith("no FMA"):  # this machine has no FMA: both shards have the same arithmetic
            self.assertEqual(run(*merge).code, 0)
            return
        other = "no FMA"
        self.assert_refused(run(*merge), other)
        self.assertEqual(run(*merge, "--mixed-fma").code, 0)
        os.rename(self.path("1.shard"), self.path("out.h5.part-0-8"))
        self.assert_refused(self.sweep(SHORT, "--resume"), other, "--mixed-fma")
        self.sweep(SHORT, "--resume", "--mixed-fma").ended(0)
        # A result tells all arithmetics by which it was computed, whether parts were resumed, merged, or both.
        self.assertNotEqual(own, self.set_of("out.h5"))
        self.assertEqual(self.set_of("out.h5"), self.set_of("merged.h5"))
        for name in (own, other):
            self.assertIn(name, self.set_of("out.h5"))
        self.swept(SHORT, "--shard", "1/2", "--without-fma", out="x.shard.part-0-8")
        self.swept(SHORT, "--shard", "1/1", "--resume", "--mixed-fma", out="x.shard")
        self.assertEqual(run("sweep", "merge", self.path("x.shard"), "--force", *merge[-2:]).code, 0)
        self.assertEqual(self.set_of("merged.h5"), self.set_of("out.h5"))

    def set_of(self, name):
        with opened(self.path(name)) as file:
            return file.attrs["arithmetic"]

    def test_a_result_that_is_damaged_anywhere_is_refused(self):
        draw = random.Random(17)
        size = len(self.whole)
        damages = [self.whole[:draw.randrange(size)] for _ in range(5)]
        damages += [self.whole + b"x", self.whole[:1000] + self.whole[1001:], b""]
        for _ in range(30):
            flipped = bytearray(self.whole)
            flipped[draw.randrange(size)] ^= 1 << draw.randrange(8)
            damages.append(bytes(flipped))
        for at in (0, 8, size // 2, size - 40, size - 8):
            zeroed = bytearray(self.whole)
            zeroed[at:at + 8] = b"\xff" * len(zeroed[at:at + 8])
            damages.append(bytes(zeroed))
        for i, damaged in enumerate(damages):
            with self.subTest(i=i):
                self.put("out.h5", damaged)
                self.assert_refused(run("sweep", "show", self.path("out.h5")), "out.h5")
                if i % 6 == 0:
                    self.assert_refused(self.sweep(SHORT, "--resume"), "out.h5", "--force")
                self.assertEqual(self.bytes_of("out.h5"), damaged)

    def test_all_datasets_have_checksums_that_other_programs_see(self):
        import h5py
        with opened(self.path("whole.h5")) as file:
            datasets = []
            file.visititems(lambda _, item: datasets.append(item)
                            if isinstance(item, h5py.Dataset) else None)
            self.assertGreater(len(datasets), 100)
            for dataset in datasets:
                self.assertTrue(dataset.fletcher32, dataset.name)
                dataset[()]
            film = file["smooth/outputs/film"].id
            place = film.get_chunk_info(0).byte_offset
        damaged = bytearray(self.whole)
        damaged[place + 200] ^= 4
        self.put("damaged.h5", damaged)
        with opened(self.path("damaged.h5")) as file:
            with self.assertRaises(OSError):
                file["smooth/outputs/film"][()]

    def test_a_damaged_shard_is_not_merged(self):
        damaged = bytearray(self.part)
        damaged[len(damaged) // 2] ^= 1
        self.put("all.shard", damaged)
        merged = run("sweep", "merge", self.path("all.shard"), "-o", self.path("merged.h5"))
        self.assert_refused(merged, "all.shard is damaged")
        self.assertNotIn("merged.h5", self.names())

    def test_a_result_that_is_there_is_kept_or_refused(self):
        result = self.sweep(SHORT, out="whole.h5")
        self.assert_refused(result, "whole.h5", "--force")
        kept = self.sweep(SHORT, "--resume", out="whole.h5")
        self.assertEqual((kept.code, self.bytes_of("whole.h5")), (0, self.whole), kept.err)
        other = SHORT.replace("draws = 5000", "draws = 500")
        self.assert_refused(self.sweep(other, "--resume", out="whole.h5"), "another sweep")
        self.assertEqual(self.bytes_of("whole.h5"), self.whole)
        for damaged in (self.whole[: len(self.whole) // 2], b"", b"no HDF5 at all"):
            self.put("cut.h5", damaged)
            self.assert_refused(self.sweep(SHORT, "--resume", out="cut.h5"), "cut.h5")
            self.assert_refused(run("sweep", "show", self.path("cut.h5")), "cut.h5")


if __name__ == "__main__":
    unittest.main()
