# SPDX-License-Identifier: Apache-2.0
"""verify --subject: what a subject writes does not fill the memory."""

import json
import shlex
import subprocess
import unittest

from conformance import PYTHON, subject
from program import Folder, start, wait_for

LONG_ANSWERS = """
import json, sys
rest = ", ".join(sys.argv[1:2] * int(sys.argv[2]))
for line in sys.stdin:
    print('{"id": %s, %s: [%s]}' % (json.dumps(json.loads(line)["id"]), sys.argv[3], rest), flush=True)
"""


class Memory(unittest.TestCase):
    """Lines of nearly 1 MiB, a line that never ends, and endlessly many lines: none of them is kept in memory."""
    MOST = 150  # MB. The program takes about 30. All lines of answers would take 200, and all values in them thousands.

    def test_is_bounded(self):
        folder = Folder()
        self.addCleanup(folder.cleanup)
        long = shlex.join([PYTHON, folder.write("long.py", LONG_ANSWERS)])
        commands = [f"{long} 0 340000 {shlex.quote(json.dumps(name))}" for name in ("value", "other", "skip", "error")]
        commands += [subject("hostile/hostile.py", name, "--after", "5")
                     for name in ("endless_line", "unasked_answers", "floods_stderr", "line_over_1_mib")]
        for command in commands:
            with self.subTest(command):
                process = start("verify", "--subject", command, "--sample", "2", "--case-timeout", "2", "--timeout", "60",
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                code, megabytes = wait_for(process)
                self.assertIn(code, (0, 1))
                self.assertLess(megabytes, self.MOST)


if __name__ == "__main__":
    unittest.main()
