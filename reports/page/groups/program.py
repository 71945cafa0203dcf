# SPDX-License-Identifier: Apache-2.0
"""Runs the program's own commands, as any user can."""
import contextlib
import json
import subprocess
import threading

from group import Missing


def members(text, whole=int):
    """The members of a JSON document of the program, without its head. `whole` converts its whole numbers."""
    document = json.loads(text, parse_int=whole)
    return {name: value for name, value in document.items() if name not in ("schema", "version")}


class Program:
    """The program. One `tribocheck stream` answers all lines of ask(), and ends with this object's context."""

    def __init__(self, path):
        self.path, self.stream = path, None

    def __enter__(self):
        return self

    def __exit__(self, *error):
        if self.stream is not None:
            self.stream.kill()
            self.stream.communicate()

    def run(self, *arguments, text=""):
        """Runs a command that reads this text. Returns its exit code, its output, and its complaints: the lines of its stderr."""
        done = subprocess.run([self.path, *map(str, arguments)], input=text, capture_output=True, encoding="utf-8", errors="replace")
        return done.returncode, done.stdout, [line.removeprefix("tribocheck: ") for line in done.stderr.splitlines()]

    def said(self, *arguments, text=""):
        """A command's output, and its complaints. Raises Missing, with the first complaint,
        where it has no output or refuses what it is given."""
        code, told, complaints = self.run(*arguments, text=text)
        if not told or code not in (0, 1):
            errors = [line for line in complaints if not line.startswith("warning: ")]
            raise Missing(errors[0] if errors else f"{arguments[0]} ended with exit code {code}")
        return told, complaints

    def answer(self, *arguments, whole=int, text=""):
        """The members of a command's answer. `whole` converts its whole numbers: float where no number is a count."""
        return members(self.said(*arguments, "--format", "json", text=text)[0], whole)

    def ask(self, *lines):
        """The answers of `tribocheck stream` to these lines of JSON. Raises Missing where one of them is refused."""
        if self.stream is None:
            self.stream = subprocess.Popen([self.path, "stream"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                           stderr=subprocess.DEVNULL, encoding="utf-8")
        writer = threading.Thread(target=self.write, args=(lines,))
        writer.start()
        answers = [json.loads(self.stream.stdout.readline() or '{"error": {"message": "stream has ended"}}', parse_int=float)
                   for _ in lines]
        writer.join()
        for answer in answers:
            if "error" in answer:
                raise Missing(": ".join(answer["error"].values()))
        return answers

    def write(self, lines):
        with contextlib.suppress(BrokenPipeError):  # ask() finds that the stream has ended
            self.stream.stdin.write("".join(f"{line}\n" for line in lines))
            self.stream.stdin.flush()
