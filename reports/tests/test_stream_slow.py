# SPDX-License-Identifier: Apache-2.0
"""The memory of stream stays flat over a million lines, or as many as TRIBOCHECK_LINES asks for. The number of lines
that it answers in a second is printed."""

import os
import resource
import subprocess
import threading
import unittest

from program import json_value, scene, start, wait_for

LINES = int(os.environ.get("TRIBOCHECK_LINES", 1_000_000))


class LongStream(unittest.TestCase):
    def test_memory_is_flat(self):
        short, long = self.memory_for(1000), self.memory_for(LINES)
        self.assertLess(long, short + 4, "MB")

    def memory_for(self, count):
        block = "".join(json_value(scene(id=f"p{i}", speed=1e-3 * (1 + i))) + "\n"
                        for i in range(1000)).encode()
        before = self.processor_seconds()
        process = start("stream", stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        received = []
        reader = threading.Thread(target=lambda: received.append(self.count_lines(process.stdout)))
        reader.start()
        for _ in range(count // 1000):
            process.stdin.write(block)
        process.stdin.close()
        reader.join()
        process.stdout.close()
        code, memory = wait_for(process)
        self.assertEqual((code, received), (0, [count // 1000 * 1000]))
        seconds = self.processor_seconds() - before
        print(f"{count} lines: {count / seconds:.0f} a second of processor time", flush=True)
        return memory

    @staticmethod
    def processor_seconds():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    @staticmethod
    def count_lines(file):
        lines = 0
        while part := file.read1(1 << 16):
            lines += part.count(b"\n")
        return lines


if __name__ == "__main__":
    unittest.main()
