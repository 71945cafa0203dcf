# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep in a folder that others write to. It does not follow their links, and does not replace or remove their
files. It ends soon when it is stopped or its folder is removed. TRIBOCHECK_ATTACKS asks for more attacks than four."""

import errno
import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from program import ENVIRONMENT, PROGRAM, run, scene, start
from sweeps import DAYS, LONG, SHORT, SweepTest, preloadable

ATTACKS = int(os.environ.get("TRIBOCHECK_ATTACKS", 4))
NOBODY = 65534
BESIDE = (".lock", ".part", ".part-0-3.lock")


class Shared(SweepTest):
    def commands(self):
        """A sweep, a shard and a merge, all to out.h5."""
        self.swept(SHORT, "--shard", "1/1", out="all.shard")
        path, out = self.path("sweep.toml"), self.path("out.h5")
        return (["sweep", path, "-o", out], ["sweep", path, "-o", out, "--shard", "1/1"],
                ["sweep", "merge", self.path("all.shard"), "-o", out])

    def test_what_is_not_ours_is_left_as_it_is_and_named(self):
        commands = self.commands()
        self.put("precious", b"of somebody")
        self.put("empty", b"")
        kinds = {"file": lambda path: self.put(path, b"of somebody"),
                 "link": lambda path: os.symlink(self.path("precious"), path),
                 "link to nothing": lambda path: os.symlink(self.path("nothing"), path),
                 "second name": lambda path: os.link(self.path("precious"), path),
                 "second name of an empty file": lambda path: os.link(self.path("empty"), path),
                 "folder": os.mkdir, "pipe": os.mkfifo}
        if os.geteuid() == 0:
            def of_nobody(path):
                self.put(path, b"")
                os.chown(path, NOBODY, NOBODY)
            kinds["file of another user"] = of_nobody
        for ending in BESIDE:
            for kind, make in kinds.items():
                for command in commands:
                    if "merge" in command and ending == ".part-0-3.lock":
                        continue  # a merge computes no cases
                    with self.subTest(ending=ending, kind=kind, command=command):
                        path = self.path("out.h5" + ending)
                        make(path)
                        before = os.lstat(path)
                        names = self.names()
                        self.assert_refused(run(*command), "out.h5" + ending)
                        self.assertEqual(self.names(), names)
                        after = os.lstat(path)
                        self.assertEqual((after.st_ino, after.st_mode, after.st_size, after.st_uid),
                                         (before.st_ino, before.st_mode, before.st_size, before.st_uid))
                        self.assertEqual(self.bytes_of("precious"), b"of somebody")
                        (os.rmdir if kind == "folder" else os.remove)(path)

    def of_days(self, out, **options):
        """Starts a sweep that would take days, whose result cannot be kept. It has to end at once with one line."""
        path = self.folder.write("sweep.toml", DAYS)
        names = self.names()
        done = subprocess.run([PROGRAM, "sweep", path, "-o", out, *options.pop("arguments", [])], capture_output=True,
                              text=True, timeout=20, **{"env": ENVIRONMENT, **options})
        self.assertEqual((done.stdout, len(done.stderr.splitlines())), ("", 1), done.stderr)
        self.assertEqual(self.names(), names)
        return done

    @unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
    def test_a_file_system_that_gives_files_another_owner_is_told_before_anything_is_computed(self):
        environment = dict(ENVIRONMENT, LD_PRELOAD=preloadable("own_host"), OTHER_OWNER="1")
        environment["ASAN_OPTIONS"] += ":verify_asan_link_order=0"
        done = self.of_days(self.path("out.h5"), env=environment)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("belong to another user", done.stderr)

    @unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
    def test_a_file_system_whose_renames_take_no_flags_keeps_the_result(self):
        self.swept(SHORT, out="whole.h5")
        for code in (errno.EINVAL, errno.ENOSYS, errno.EPERM):
            environment = dict(ENVIRONMENT, LD_PRELOAD=preloadable("own_host"), RENAME_ERROR=str(code))
            environment["ASAN_OPTIONS"] += ":verify_asan_link_order=0"
            done = subprocess.run([PROGRAM, "sweep", self.path("sweep.toml"), "-o", self.path("out.h5")],
                                  capture_output=True, text=True, timeout=20, env=environment)
            if code == errno.EPERM:  # an error that also has other causes than flags
                self.assertEqual(done.returncode, 1)
                self.assertIn(os.strerror(code), done.stderr)
                self.assertNotIn("out.h5", self.names())
            else:
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))
                os.remove(self.path("out.h5"))

    def test_a_name_that_has_no_room_for_that_of_a_part_is_told_before_anything_is_computed(self):
        most = os.pathconf(self.folder.name, "PC_NAME_MAX")
        done = self.of_days(self.path("o" * (most - len(".part-0-3.lock"))))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("cannot write", done.stderr)

    @unittest.skipUnless(os.geteuid() == 0, "only root makes files of other users")
    def test_a_result_of_another_user_that_cannot_be_replaced_is_told_before_anything_is_computed(self):
        os.chmod(self.folder.name, 0o1777)
        self.put("out.h5", b"of root")
        for arguments in (["--force"], ["--force", "--shard", "1/2"]):
            try:
                done = self.of_days(self.path("out.h5"), arguments=arguments, user=NOBODY, group=NOBODY,
                                    extra_groups=[])
            except PermissionError:
                self.skipTest("another user cannot run the program")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("is of another user", done.stderr)
            self.assertEqual(self.bytes_of("out.h5"), b"of root")

    def test_what_our_own_killed_process_left_is_taken_up(self):
        commands = self.commands()
        self.swept(SHORT, out="whole.h5")
        whole, shard = self.bytes_of("whole.h5"), self.bytes_of("all.shard")
        draw = random.Random(9)
        for command in commands:
            wanted, left = (shard, shard) if "--shard" in command else (whole, whole)
            cuts = [0, 48]
            cuts += [draw.randrange(7000, len(left)) for _ in range(4)] + [len(left)]
            for cut in cuts:
                with self.subTest(command=command, cut=cut):
                    self.put("out.h5.part", left[:cut])
                    self.put("out.h5.lock", b"")
                    self.put("out.h5.part-0-3.lock", b"")
                    self.put(".out.h5.part-0-3.77-0", shard[:cut])
                    run(*command).ended(0)
                    self.assertEqual(self.bytes_of("out.h5"), wanted)
                    self.assertEqual([name for name in self.names() if "out.h5" in name], ["out.h5"])
                    os.remove(self.path("out.h5"))

    def test_no_file_of_others_is_touched_however_links_are_put_in_its_way(self):
        """Another process makes the links; if the test runs as root, that process is of another user."""
        os.chmod(self.folder.name, 0o755)
        os.mkdir(self.path("shared"))
        os.chmod(self.path("shared"), 0o777)
        self.put("precious", b"of root")
        path = self.folder.write("sweep.toml", SHORT)
        self.swept(SHORT, out="whole.h5")
        out = self.path("shared/out.h5")
        refused = 0
        for attack in range(ATTACKS):
            endings = [(".part",), (".part", ".lock"), (".part-0-3.lock",), (".part", "", ".part-0-3")][attack % 4]
            attacker = os.fork()
            if attacker == 0:
                self.attack([out + ending for ending in endings], attack)
            try:
                done = run("sweep", path, "-o", out, "--force")
            finally:
                os.kill(attacker, signal.SIGKILL)
                os.waitpid(attacker, 0)
            with self.subTest(attack=attack, said=done.err):
                self.assertEqual(self.bytes_of("precious"), b"of root")
                self.assertFalse(os.path.exists(self.path("nothing")))
                self.assertIn(done.code, (0, 1, 2))
                self.assertNotIn("terminate", done.err)
                refused += done.code != 0
            shutil.rmtree(self.path("shared"))
            os.mkdir(self.path("shared"))
            os.chmod(self.path("shared"), 0o777)
        print(f"{ATTACKS} attacks, {refused} of them told", flush=True)

    def attack(self, places, seed):
        """Makes links at the places again and again, until the process is killed."""
        try:
            if os.geteuid() == 0:
                os.setgid(NOBODY)
                os.setuid(NOBODY)
            draw = random.Random(seed)
            while True:
                place = draw.choice(places)
                target = self.path(draw.choice(("precious", "nothing")))
                beside = os.path.join(os.path.dirname(place), "made")
                for step in (lambda: os.symlink(target, place), lambda: os.unlink(place),
                             lambda: os.symlink(target, beside), lambda: os.rename(beside, place)):
                    try:
                        step()
                    except OSError:
                        pass
                time.sleep(draw.choice((0, 0, 0.0005)))
        finally:
            os._exit(1)

    @unittest.skipUnless(os.geteuid() == 0, "only root makes files of other users")
    def test_a_link_of_another_user_at_the_output_is_not_followed(self):
        os.symlink(self.path("nothing"), self.path("out.h5"))
        os.chown(self.path("out.h5"), NOBODY, NOBODY, follow_symlinks=False)
        for options in ((), ("--force",)):
            self.assert_refused(self.sweep(SHORT, *options), "out.h5", "another user")
        self.assertNotIn("nothing", self.names())


class Meanwhile(SweepTest):
    """While a sweep computes, others change files, or it is stopped."""

    def started(self, *arguments):
        return self.ended_at_last(start("sweep", *arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE))

    def stopped_in_the_middle(self, *options):
        return self.stopped(self.started(self.folder.write("sweep.toml", LONG), "-o", self.path("out.h5"), *options), 1)

    def ended(self, process):
        process.send_signal(signal.SIGCONT)
        _, said = process.communicate(timeout=60)
        return process.returncode, said.decode()

    def put_output(self, content=b"of somebody"):
        self.put("made", content)
        os.replace(self.path("made"), self.path("out.h5"))

    def test_a_file_put_at_the_output_is_replaced_with_force_alone(self):
        self.swept(LONG, out="whole.h5")
        whole = self.bytes_of("whole.h5")
        process = self.stopped_in_the_middle()
        self.put_output()
        code, said = self.ended(process)
        self.assertEqual((code, len(said.splitlines())), (1, 1), said)
        self.assertIn("out.h5 was put there by another process", said)
        self.assertIn("--resume", said)
        self.assertEqual(self.bytes_of("out.h5"), b"of somebody")
        self.assertNotIn("out.h5.part", self.names())
        self.assert_refused(self.sweep(LONG, "--resume"), "out.h5", "move it away")
        self.assertEqual(self.bytes_of("out.h5"), b"of somebody")
        os.remove(self.path("out.h5"))
        resumed = self.sweep(LONG, "--resume")  # no computed part is lost
        self.assertIn("going on", resumed.err)
        self.assertEqual((resumed.code, self.bytes_of("out.h5")), (0, whole), resumed.err)
        process = self.stopped_in_the_middle("--force")
        self.put_output()
        code, said = self.ended(process)
        self.assertEqual((code, self.bytes_of("out.h5")), (0, whole), said)

    def test_after_a_kill_resume_replaces_only_the_file_that_force_was_to_replace(self):
        self.put_output(b"old")
        process = self.stopped_in_the_middle("--force")
        process.kill()
        process.communicate()
        os.rename(self.path("out.h5"), self.path("old.h5"))
        self.put_output()
        self.assert_refused(self.sweep(LONG, "--resume"), "out.h5", "move it away")
        self.assertEqual(self.bytes_of("out.h5"), b"of somebody")
        os.rename(self.path("old.h5"), self.path("out.h5"))
        self.assertEqual(self.sweep(LONG, "--resume").code, 0)
        self.swept(LONG, out="whole.h5")
        self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))

    def test_a_folder_that_is_removed_or_moved_is_told_at_once(self):
        path = self.folder.write("sweep.toml", DAYS)
        for away in (lambda: shutil.rmtree(self.path("in")),
                     lambda: os.rename(self.path("in"), self.path("elsewhere"))):
            os.mkdir(self.path("in"))
            process = self.started(path, "-o", self.path("in/out.h5"))
            self.wait_until(lambda: any(name.startswith("out.h5.part-") for name in os.listdir(self.path("in"))))
            away()
            _, said = process.communicate(timeout=60)
            self.assertEqual((process.returncode, len(said.splitlines())), (1, 1), said)
            self.assertIn(b"the folder of", said)

    def test_a_stop_does_not_wait_for_the_chunk(self):
        path = self.folder.write("sweep.toml", DAYS)
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.started(path, "-o", self.path("out.h5"), "--force")
            self.wait_until(lambda: any(name.startswith("out.h5.part-") for name in self.names()))
            time.sleep(0.1)
            process.send_signal(number)
            _, said = process.communicate(timeout=40)
            self.assertEqual(process.returncode, 128 + number, said)
            self.assertIn(b"--resume goes on", said)

    def test_a_merge_and_a_writing_sweep_are_stopped_too(self):
        self.swept(LONG, out="whole.h5")
        self.swept(LONG, "--shard", "1/1", out="all.shard")
        merge = ["merge", self.path("all.shard")]
        for command in (merge, [self.path("sweep.toml")]):
            stopped = 0
            for _ in range(20):
                process = self.started(*command, "-o", self.path("out.h5"), "--force")
                self.wait_until(lambda: process.poll() is not None or os.path.exists(self.path("out.h5.part")))
                process.send_signal(signal.SIGINT)
                _, said = process.communicate(timeout=60)
                names = [name for name in self.names() if name.startswith("out.h5.")]
                if process.returncode == 130:
                    stopped += 1
                    self.assertIn(b"stopped: ", said)
                    self.assertEqual(names, [] if command is merge else self.parts())
                else:  # the result was complete before the signal
                    self.assertIn(process.returncode, (0, -signal.SIGINT), said)
                    self.assertTrue(os.path.exists(self.path("out.h5")))
                if stopped == 2:
                    break
            self.assertGreater(stopped, 0)
            if command is not merge:
                self.assertEqual(self.sweep(LONG, "--resume").code, 0)
            self.assertTrue(command is merge or self.bytes_of("out.h5") == self.bytes_of("whole.h5"))


@unittest.skipUnless(shutil.which("cc"), "no C compiler is installed")
class Threads(SweepTest):
    """A sweep where the system allows fewer threads than are asked for."""

    def run_with(self, most, *arguments, **more):
        environment = dict(ENVIRONMENT, LD_PRELOAD=preloadable("few_threads"), MOST_THREADS=str(most), **more)
        environment["ASAN_OPTIONS"] += ":verify_asan_link_order=0"
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=100, env=environment)

    def test_a_sweep_goes_on_with_those_that_there_are_or_says_so(self):
        self.swept(SHORT, out="whole.h5")
        path = self.path("sweep.toml")
        for most in range(5):
            with self.subTest(most=most):
                done = self.run_with(most, "sweep", path, "-o", self.path("out.h5"), "--threads", "16", "--force")
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertIn("thread", done.stderr)
                self.assertEqual(done.returncode, 1 if most == 0 else 0, done.stderr)
                if most > 0:
                    self.assertIn(f"the system allows {most} of the 16 threads", done.stderr)
                    self.assertEqual(self.bytes_of("out.h5"), self.bytes_of("whole.h5"))
        self.assertEqual([name for name in self.names() if name.startswith("out.")], ["out.h5"])

    def test_a_sweep_that_may_start_no_process_to_read_a_result_says_nothing_of_the_result(self):
        self.swept(SHORT)
        done = self.run_with(99, "sweep", self.path("sweep.toml"), "-o", self.path("out.h5"), "--resume", NO_PROCESSES="1")
        self.assertEqual((done.returncode, done.stderr), (1, "tribocheck: cannot start a process: Resource temporarily unavailable\n"))

    def test_as_many_threads_are_taken_as_processors_are_allowed(self):
        path = self.folder.write("sweep.toml", SHORT)
        allowed = os.sched_getaffinity(0)
        for some in ({min(allowed)}, allowed):
            os.sched_setaffinity(0, some)
            try:
                said = run("sweep", path, "--estimate").out
            finally:
                os.sched_setaffinity(0, allowed)
            self.assertRegex(said, rf"(?m)^time .* on {len(some)} threads?$")

    def test_solve_and_reproduce_give_the_same_with_any_number(self):
        path = self.folder.write("scene.toml", scene(speed={"from": 1e-4, "to": 3, "count": 9000}))
        for command in (["solve", path, "--format", "csv", "--threads", "16"], ["reproduce"]):
            wanted = run(*command).out
            for most in (0, 1):
                done = self.run_with(most, *command)
                self.assertEqual((done.returncode, done.stdout), (0, wanted), done.stderr)


if __name__ == "__main__":
    unittest.main()
