# SPDX-License-Identifier: Apache-2.0
"""Endless input, huge output, readers that go away, disks that are full: bounded memory, no hang."""

import contextlib
import resource
import subprocess
import threading
import unittest

from program import ProgramTest, json_value, quiet_scene, run, start, strict_json, wait_for

MEMORY = 100  # MB
GIGABYTE = 1000 * (1 << 20)


def feed(process, parts):
    """Writes to the program from a thread, until the program reads no more."""
    def write():
        with contextlib.suppress(BrokenPipeError):
            for part in parts:
                process.stdin.write(part)
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
    thread = threading.Thread(target=write)
    thread.start()
    return thread


def repeated(part, total):
    for _ in range(total // len(part)):
        yield part


class Limits(ProgramTest):
    def fed(self, parts, *arguments):
        """Exit code, memory, stdout and stderr."""
        with open(self.folder.path("err"), "w+") as err, open(self.folder.path("out"), "w+") as out:
            process = start(*arguments, stdin=subprocess.PIPE, stdout=out, stderr=err, bufsize=0)
            thread = feed(process, parts)
            code, memory = wait_for(process)
            thread.join()
            out.seek(0)
            err.seek(0)
            return code, memory, out.read(), err.read()


class Input(Limits):
    def test_a_line_of_1_gb_to_stream(self):
        def parts():
            yield from repeated(b"x" * (1 << 20), GIGABYTE)
            yield b"\n" + json_value(quiet_scene(speed=1)).encode()
        code, memory, out, _ = self.fed(parts(), "stream")
        first, second = map(strict_json, out.splitlines())
        self.assertEqual((code, first["id"], second["id"]), (0, None, "rough"))
        self.assertEqual(first["error"]["field"], "")
        self.assertLess(memory, MEMORY)

    def test_a_scene_of_1_gb_on_stdin(self):
        for start_of_it in [b"{", b"#", b" "]:
            for command in ["solve", "curve", "onset"]:
                parts = repeated(start_of_it * (1 << 20), GIGABYTE)
                code, memory, out, err = self.fed(parts, command, "-")
                self.assertEqual((code, out, len(err.splitlines())), (2, "", 1))
                self.assertLess(memory, MEMORY)

    def test_many_lines(self):
        lines = "".join(json_value(quiet_scene(id=f"p{i}", speed=1e-3 * (1 + i))) + "\n" for i in range(100))
        code, memory, out, _ = self.fed(repeated(lines.encode(), 200 * len(lines)), "stream")
        self.assertEqual((code, out.count("\n")), (0, 20000))
        self.assertLess(memory, MEMORY)

    def test_stdin_that_cannot_be_read(self):
        for arguments in [["stream"], ["solve", "-"]]:
            with open(self.folder.path("x"), "w") as closed:  # open for writing only
                process = start(*arguments, stdin=closed, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)
                out, err = process.communicate()
            self.assertEqual((process.returncode, out, len(err.splitlines())), (2, b"", 1))


class Output(Limits):
    def long(self, **changes):
        return self.folder.write("long.toml", quiet_scene(speed={"from": 1e-4, "to": 3, **changes}))

    def test_memory_does_not_grow_with_the_rows(self):
        path = self.long(count=30000)
        for command in ["solve", "curve"]:
            for style in ["table", "csv", "json"]:
                process = start(command, path, "--format", style, stdout=subprocess.DEVNULL)
                code, memory = wait_for(process)
                self.assertEqual(code, 0)
                self.assertLess(memory, MEMORY)

    def assert_ends_quietly(self, *arguments, **options):
        process = start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        thread = feed(process, repeated(json_value(quiet_scene(speed=1)).encode() + b"\n", 1 << 40)) \
            if process.stdin else None
        process.stdout.readline()
        process.stdout.close()
        with process.stderr as err:
            self.assertEqual((err.read(), process.wait()), (b"", 0))
        if thread:
            thread.join()

    def test_a_reader_that_goes_away(self):
        path = self.long(count=10_000_000)
        for command in ["solve", "curve"]:
            for style in ["table", "csv", "json"]:
                with self.subTest(command=command, style=style):
                    self.assert_ends_quietly(command, path, "--format", style)
        self.assert_ends_quietly("stream", stdin=subprocess.PIPE)

    def test_a_full_disk(self):
        path = self.folder.write("rough.toml", quiet_scene())
        for arguments in [["solve", path], ["curve", path], ["onset", path], ["stream"], ["--help"],
                          ["solve", "--version"]]:
            with self.subTest(arguments=arguments), open("/dev/full", "w") as full:
                process = start(*arguments, stdin=subprocess.PIPE, stdout=full,
                                stderr=subprocess.PIPE)
                _, err = process.communicate(b"junk\n" if arguments == ["stream"] else b"")
                self.assertEqual(process.returncode, 1)
                self.assertEqual(len(err.splitlines()), 1)
                self.assertTrue(err.startswith(b"tribocheck: "))

    def test_a_disk_that_is_full_in_the_middle_of_the_results(self):
        path = self.folder.write("rough.toml", quiet_scene())
        for style in ["table", "csv", "json"]:
            half = len(run("solve", path, "--format", style).out.encode()) // 2
            def limit():
                resource.setrlimit(resource.RLIMIT_FSIZE, (half, half))
            with self.subTest(style), open(self.folder.path("out"), "wb") as out:
                process = start("solve", path, "--format", style, stdout=out, stderr=subprocess.PIPE,
                                preexec_fn=limit, restore_signals=False)  # SIGXFSZ stays ignored
                _, err = process.communicate()
                self.assertEqual((process.returncode, len(err.splitlines())), (1, 1), err)

    def test_a_stderr_that_is_full(self):
        with open("/dev/full", "w") as full:
            process = start("solve", self.folder.path("none"), stdout=subprocess.PIPE, stderr=full)
            out, _ = process.communicate()
        self.assertEqual((process.returncode, out), (2, b""))

    def test_no_colour_and_no_progress_but_on_a_terminal(self):
        result = run("solve", self.folder.write("rough.toml", quiet_scene()))
        self.assertNotIn("\x1b", result.out)
        self.assertEqual(result.err, "")


if __name__ == "__main__":
    unittest.main()
