# SPDX-License-Identifier: Apache-2.0
"""A generated copy of the tree in which each mutant of C++ stands behind a switch, and its build."""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys

SWITCH = pathlib.Path(__file__).with_name("switch.hpp")
NUMBER = re.compile(r"tribocheck_mutants::\w+(?:<[^()]*?>)?\((\d+)")
PLACE = re.compile(r"^(?:In file included from |\s+from )?([/.][^:\s]+):(\d+)[:,]", re.MULTILINE)
LEFT_OUT = "HWY_SSSE3|HWY_AVX3|HWY_AVX3_DL"


def switched(text, mutants, numbers):
    """The text with the mutants behind switches. An edit that several mutants share is made once."""
    edits = {(begin, end, new.replace("{n}", str(numbers[one["id"]]))) for one in mutants for begin, end, new in one["edits"]}
    whole = text.encode()
    for begin, end, new in sorted(edits, reverse=True):
        # An inserted text stands before a statement, which stays where it is.
        whole = whole[:begin] + new.encode() + whole[end:]
    return f'#include "{SWITCH}"\n' + whole.decode()


class Copy:
    def __init__(self, root, tree, build):
        self.root, self.tree, self.build = root, tree, build

    def write(self, mutants, numbers):
        """Writes the copy. Only files whose text differs are written, so that a build after a new draw is short."""
        by_file = collections.defaultdict(list)
        for one in mutants:
            if one.get("edits"):
                by_file[one["file"]].append(one)
        for path in [*self.tree.glob("model/**/*.?pp"), *self.tree.glob("reports/**/*.?pp"),
                     *self.tree.glob("verification/**/*.?pp"), *self.tree.glob("benchmarks/**/*.?pp")]:
            file = path.relative_to(self.tree).as_posix()
            if not (self.root / file).is_file():
                continue
            text = (self.root / file).read_text()
            new = switched(text, by_file[file], numbers) if file in by_file else text
            if path.read_text() != new:
                path.write_text(new)

    def configure(self):
        """Without a compiler cache the copy is built as quickly as possible. With one it is built like the tree's release, so that the
        cache has all files that no mutant changes."""
        quick = ["-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -w", f"-DTRIBOCHECK_TARGETS_LEFT_OUT={LEFT_OUT}", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=6"]
        like_release = ["-DCMAKE_CXX_COMPILER=g++", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=12"]
        done = subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DTRIBOCHECK_BUILD_TESTS=ON",
                               "-DTRIBOCHECK_BUILD_BENCHMARKS=ON", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                               *(like_release if "CMAKE_CXX_COMPILER_LAUNCHER" in os.environ else quick)], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stdout + done.stderr)

    def targets(self, left_out):
        """The targets of the build, without the test programs whose names match `left_out`."""
        def parts(target):
            said = subprocess.run(["ninja", "-C", self.build, "-t", "query", target], capture_output=True, text=True, check=True).stdout
            return re.findall(r"^    (\S+)$", said.split("  outputs:")[0], re.MULTILINE)

        listed = subprocess.run(["ctest", "--test-dir", self.build, "--show-only=json-v1"], capture_output=True, text=True, check=True).stdout
        names = [one["name"] for one in json.loads(listed)["tests"]]
        programs = {f"verification/tests/{name.split('.')[1]}" for name in names if name.endswith("_test") and re.search(left_out, name)}
        return [one for part in parts("all") for one in (parts(part) if part == "verification/tests/all" else [part]) if one not in programs]

    def failing(self, *targets):
        """Numbers of the mutants that do not compile; empty: the copy is built."""
        done = subprocess.run(["ninja", "-C", self.build, "-k", "6", *targets], capture_output=True, text=True)
        if done.returncode == 0:
            return set()
        found = set()
        for output in re.split(r"^FAILED: ", done.stdout, flags=re.MULTILINE)[1:]:
            mine = self.blamed(re.findall(r"^([/.][^:\s]+):(\d+):(?:\d+:)? (?:fatal )?error", output, re.MULTILINE), 0)
            found |= mine or self.blamed(PLACE.findall(output), 3) or self.no_constants(PLACE.findall(output))
        if not found:
            sys.exit("the copy does not build, and no mutant is to blame:\n" + done.stdout[-3000:])
        return found

    def path_of(self, file):
        """The absolute path of a file that the compiler names. With a compiler cache the name is relative to the build folder."""
        return (self.build / file).resolve()

    def no_constants(self, lines):
        """Mutants that made a constexpr variable of these files a const one, although other code needs it at compile time."""
        texts = [path.read_text() for path in {self.path_of(file) for file, _ in lines} if self.tree in path.parents]
        return {int(number) for text in texts for number in re.findall(r"::late_\w+(?:<[^()]*?>)?\((\d+)", text)}

    def blamed(self, lines, around):
        """Mutants that stand on the lines that the compiler names, or near them."""
        found = set()
        for file, line in lines:
            path = self.path_of(file)
            if self.tree in path.parents:
                text = path.read_text().splitlines()
                for reach in range(around + 3):
                    near = text[max(0, int(line) - 1 - reach):int(line) + reach]
                    if here := {int(number) for one in near for number in NUMBER.findall(one)}:
                        found |= here
                        break
        return found


def with_history(root, tree):
    """Gives a copy the commits of the tree, because some tests compare the commit that the program prints."""
    subprocess.run(["git", "clone", "--quiet", "--shared", "--no-checkout", root, tree / "history"], check=True)
    (tree / "history/.git").rename(tree / ".git")
    (tree / "history").rmdir()
    subprocess.run(["git", "reset", "--quiet"], cwd=tree, check=True)
