# SPDX-License-Identifier: Apache-2.0
"""verify --subject: hostile and broken subjects."""

import concurrent.futures
import json
import re
import time
import unittest

from conformance import BUILT, SUBJECTS, listed, subject, verify


class Hostile(unittest.TestCase):
    """Whatever a subject does, each case gets one result, in time, and the rest still runs."""

    def test_each_is_survived(self):
        def asked(behaviour):
            start = time.monotonic()
            result = verify("--subject", subject("hostile/hostile.py", behaviour, "--after", "5"),
                            "--sample", "12", "--case-timeout", "0.7", "--timeout", "15")
            return result, time.monotonic() - start
        behaviours = listed("hostile/hostile.py")
        self.assertGreater(len(behaviours), 30)
        with concurrent.futures.ThreadPoolExecutor(8) as pool:  # most of them sleep
            results = dict(zip(behaviours, pool.map(asked, behaviours)))
        for behaviour, (result, seconds) in results.items():
            with self.subTest(behaviour):
                self.assertLess(seconds, 60)
                self.assertIn(result.code, (0, 1), result.err)
                verdict = result.json()
                for one in verdict["quantities"]:
                    self.assertEqual(one["asked"], one["held"] + one["failed"] + one["skipped"], one)
                if result.code == 0:  # only what does no harm to the protocol
                    self.assertIn(verdict["overall"], ("complete", "partial"), behaviour)
                    self.assertTrue(re.search("stderr|slow|SIGTERM|sigterm", behaviour), behaviour)

    def test_one_that_no_one_may_run_or_that_is_not_there(self):
        for command, words in ((str(SUBJECTS / "hostile/not_executable"), "ermission denied"),
                               ("/no/such/program", "not found")):
            result = verify("--subject", command)
            self.assertEqual(result.code, 1)
            self.assertEqual(result.json()["overall"], "failed")
            self.assertIn(words, result.json()["last_errors"])

    def test_a_plugin_that_crashes_does_not_take_the_run_with_it(self):
        crashing = sorted(BUILT.glob("*crash*.so"))
        self.assertTrue(crashing)
        result = verify("--plugin", str(crashing[0]), "--sample", "20")
        self.assertEqual(result.code, 1)
        self.assertIn("signal", json.dumps(result.json()["quantities"]))


if __name__ == "__main__":
    unittest.main()
