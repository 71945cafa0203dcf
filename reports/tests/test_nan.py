# SPDX-License-Identifier: Apache-2.0
"""A NaN instead of a number fails in every language; a case that the solver says it does not offer is skipped."""
import json
import pathlib
import shutil
import subprocess
import unittest

from program import ENVIRONMENT, TIMEOUT, Folder, run
from test_init import LANGUAGES

# A text of hertz_point in each language's template, and the text that replaces it. {beyond} is the code for
# the cases where `small` is false.
RADIUS = "(0.75 * load * reduced_radius / effective_modulus)"
FILLED = {
    "python": ("a²/R, of the two bodies, in m\n    return None",
               "a²/R, of the two bodies, in m\n    return {{'radius': %s ** (1 / 3)}} if {small} else {beyond}" % RADIUS),
    "octave": ("  answer = [];", "  if ({small}) answer = struct ('radius', cbrt (0.75 * q.load * q.reduced_radius"
               " / q.effective_modulus)); else answer = {beyond}; end"),
    "c": ("  return TRIBOCHECK_NOT_OFFERED;",
          "  extern double cbrt(double);\n  if ({small}) {{ *radius = cbrt(%s); return TRIBOCHECK_DONE; }}\n"
          "  {beyond}" % RADIUS),
    "cpp": ("  return not_offered;", "  if ({small}) return hertz_point_result{{.radius = __builtin_cbrt(%s)}};\n"
            "  {beyond}" % RADIUS),
    "fortran": ("    status = not_offered", "    if ({small}) then\n      radius = %s ** (1 / 3d0)\n"
                "      status = done\n    else\n      {beyond}\n    end if" % RADIUS),
    "javascript": ("    return undefined;", "    return {small} ? {{ radius: Math.cbrt%s }} : {beyond};" % RADIUS),
    "rust": ("    None", "    let found = |radius| Some(hertz_point_result {{\n        radius, mean_pressure: None, peak_pressure: None,"
             " approach: None }});\n    if {small} {{ found(Some(%s.cbrt())) }} else {{ {beyond} }}" % RADIUS),
}
NAN = {"python": "{'radius': float('nan')}", "octave": "struct ('radius', NaN)",
       "c": "*radius = __builtin_nan(\"\"); return TRIBOCHECK_DONE;",
       "cpp": "return hertz_point_result{.radius = __builtin_nan(\"\")};",
       "fortran": "radius = sqrt(-abs(load)); status = done",
       "javascript": "{ radius: NaN }", "rust": "found(Some(f64::NAN))"}
SKIP = {"python": "None", "octave": "[]", "c": "return TRIBOCHECK_NOT_OFFERED;", "cpp": "return not_offered;",
        "fortran": "status = not_offered", "javascript": "undefined", "rust": "None"}
# Status done, but no result is set.
NOTHING = {"c": "return TRIBOCHECK_DONE;", "cpp": "return hertz_point_result{};", "fortran": "status = done",
           "python": "{'x': 1}", "octave": "struct ('x', 1)", "javascript": "{ x: 1 }", "rust": "found(None)"}
LIMITS = {"some": "load < 1e1", "no": "load < 0e0", "all": "load > 0e0"}  # all languages read these as real numbers


class EveryLanguage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.languages = [row for row in LANGUAGES if shutil.which(row[2])]
        assert {row[0] for row in cls.languages} >= {"python", "c", "cpp"}

    def radius(self, row, small, beyond):
        """Returns the exit code and the verdict on the radius."""
        language, name = row[:2]
        with Folder() as folder:
            path = pathlib.Path(folder) / name
            line = run("init", "subject", "--language", language, "--out", path).out.splitlines()[2].strip()
            text = path.read_text()
            start = text.index({"python": "def hertz_point", "octave": "function answer = hertz_point",
                                "c": "int hertz_point(", "cpp": "> hertz_point(",
                                "fortran": "subroutine solve_hertz_point", "javascript": "  hertz_point({",
                                "rust": "fn hertz_point("}[language])
            mark, filled = FILLED[language]
            place = text.index(mark, start)
            condition = LIMITS[small].replace("load", "q.load") if language == "octave" else LIMITS[small]
            path.write_text(text[:place] + filled.format(small=condition, beyond=beyond[language])
                            + text[place + len(mark):])
            done = subprocess.run(["sh", "-c", line + " --format json"], capture_output=True, text=True,
                                  timeout=TIMEOUT, env=ENVIRONMENT)
            self.assertEqual(done.stderr, "", language)
            return done.returncode, {one["quantity"]: one for one in json.loads(done.stdout)["quantities"]}[
                "hertz_point.radius"]

    def test_a_right_one_holds(self):
        for row in self.languages:
            code, radius = self.radius(row, "all", NAN)
            self.assertEqual((code, radius["status"]), (0, "held"), row[0])

    def test_nan_beyond_a_load_and_nan_everywhere_fail(self):
        for row in self.languages:
            for small in ("some", "no"):
                code, radius = self.radius(row, small, NAN)
                self.assertEqual((code, radius["status"]), (1, "FAILED"), (row[0], small))
                self.assertEqual(radius["skipped"], 0)
                self.assertGreater(radius["failed"], 10)

    def test_done_without_a_result_beyond_a_load_fails(self):
        for row in self.languages:
            code, radius = self.radius(row, "some", NOTHING)
            self.assertEqual((code, radius["status"]), (1, "FAILED"), row[0])

    def test_what_is_said_not_to_be_offered_is_skipped(self):
        for row in self.languages:
            code, radius = self.radius(row, "some", SKIP)
            self.assertEqual((code, radius["status"], radius["failed"]), (0, "held in part", 0), row[0])


if __name__ == "__main__":
    unittest.main()
