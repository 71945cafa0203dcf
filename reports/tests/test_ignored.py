# SPDX-License-Identifier: Apache-2.0
"""No option is ignored: in every form of every command each one does something, or is refused by one line."""
import os
import re
import shutil
import unittest

from conformance import BUILT, altered
from program import Folder, run, scene
from test_usage import COMMANDS

SWEEP = """
id = "s"
load = 50
speed = 0.1
outputs = ["film"]
[surface]
summit_density = 5e10
summit_radius = 1e-5
summit_height_sd = { distribution = "uniform", from = 1e-7, to = 2e-7 }
[bodies]
effective_modulus = 107.9e9
reduced_radius = 9.5e-3
[lubricant]
viscosity = 0.0202
pressure_viscosity = 2e-8
[sweep]
draws = 8192
"""

# Each form: the command, the arguments that make this form of it, and the options that belong to the form itself.
FORMS = [
    ("contact", ["SCENE"], ()), ("solve", ["SCENE"], ()), ("solve", ["SCENE", "--about"], {"--about"}), ("solve", ["SCENE", "--explain"], {"--explain"}), ("curve", ["SCENE"], ()), ("curve", ["SCENE", "--data", "DATA"], {"--data"}), ("film", ["LINE", "--tolerance", "1e-2"], {"--tolerance"}), ("film", ["LINE", "--estimate"], {"--estimate"}),
    ("onset", ["SCENE"], ()), ("onset", ["SCENE", "--criterion", "film_maximum"], {"--criterion"}),
    ("onset", ["SCENE", "--criterion", "film_departure"], {"--criterion"}),
    ("stream", [], ()), ("plugin-host", ["PLUGIN"], ()),
    ("functions", [], ()), ("functions", ["hertz_point"], ()),
    ("init", ["subject", "--language", "python", "--out", "DIR/new.py"], {"--language", "--out"}),
    ("init", ["ci", "--for", "github", "--out", "DIR/new.yml"], {"--for", "--out"}),
    ("sweep", ["SWEEP", "-o", "DIR/out.h5"], {"-o"}),
    ("sweep", ["SWEEP", "--estimate"], {"--estimate"}),
    ("sweep", ["SWEEP", "-o", "DIR/part.shard", "--shard", "1/2"], {"-o", "--shard"}),
    ("sweep show", ["DIR/done.h5"], ()),
    ("sweep diff", ["DIR/done.h5", "DIR/other.h5"], ()),
    ("sweep merge", ["DIR/1.shard", "DIR/2.shard", "-o", "DIR/merged.h5"], {"-o"}),
    ("verify", [], ()),
    ("verify", ["--subject", "SUBJECT", "--sample", "3"], {"--subject", "--plugin", "--sample"}),
    ("verify", ["--plugin", "PLUGIN", "--sample", "3"], {"--subject", "--plugin", "--sample"}),
    ("verify", ["--subject", "SUBJECT", "--show", "f0000"], {"--subject", "--plugin", "--show"}),
    ("verify", ["--show", "f0000"], {"--show"}),
    ("verify", ["--save-cases", "DIR/cases"], {"--save-cases", "--show"}),
    ("verify", ["--subject", "SUBJECT", "--sample", "3", "--baseline", "DIR/base.json"],
     {"--subject", "--plugin", "--sample", "--baseline"}),
    ("field", ["VERDICTS", "-o", "DIR/page.html"], {"-o"}), ("field", ["VERDICTS", "--format", "json"], {"--format"}),
    ("profile", ["--plugin", "PLUGIN", "--function", "hertz_point"], {"--plugin", "--subject", "--function"}),
    ("reproduce", ["--section", "claims", "--ledger", "none"], {"--section", "--ledger"}),
    ("reproduce", ["--section", "errata", "--ledger", "none"], {"--section", "--ledger"}),
    ("reproduce", ["--section", "requirements", "--ledger", "none"], {"--section", "--ledger"}),
    ("reproduce", ["--format", "csv", "--ledger", "none"], {"--format", "--ledger"}),
]

# Values with a visible effect: where an option is used, something changes.
VALUES = {
    "--format": ["json"], "--about": [], "--threads": ["1000000"], "--criterion": ["asperity_minimum"], "--departure": ["0.2"],
    "--strict": [], "--explain": [], "--viscosity": ["roelands"], "--density": ["dowson_higginson"], "--tolerance": ["5e-3"], "--speed": ["1.25"],
    "--profile": [], "--data": ["DIR/no_such.csv"], "--most": ["1"], "--picture": ["DIR/no_such_folder/a.png"], "--fields": ["DIR/fields.csv"], "--keep": ["DIR/kept"], "--language": ["c"], "--for": ["gitlab"],
    "--out": ["DIR/other"],
    "--estimate": [], "--flooded": [], "--resume": [], "--join": [], "--force": [], "--shard": ["2/2"], "--without-fma": [], "--mixed-fma": [],
    "--pictures": ["DIR/pictures"], "--cases": [], "--case": ["1"], "--diff": ["2026-01-01", "2026-01-02"], "--reference": ["/nowhere"], "--junit": ["DIR/junit.xml"],
    "--seconds": ["0.3"], "--function": ["hertz_line"], "--subject": ["SUBJECT"], "--plugin": ["PLUGIN"], "--sample": ["2"], "--modulus": ["E'"], "--ellipticity": ["radii"], "--tool": ["perf"], "--case-timeout": ["0.01", "--start-timeout", "0.01"],
    "--start-timeout": ["0.01", "--case-timeout", "0.01"], "--timeout": ["0.01"], "--require": ["operating_point"],
    "--show": ["h0001"], "--save-cases": ["DIR/saved"], "--baseline": ["DIR/no_such.json"],
    "--update-baseline": [], "--claim": ["C3"], "--reading": ["literal"], "--section": ["errata"],
    "--published": ["/nowhere"], "--ledger": ["/nowhere.csv"], "--scenes": ["/nowhere"], "--commit": ["abc"],
    "--quick": [], "--jobs": ["2"], "--filter": ["no such contender"], "--alone": [], "--time": [], "--places": [],
}
# Options without an effect in these tests, and the reason why they are nevertheless not ignored.
UNSEEN = {
    ("profile", "--seconds"): "counts and shares are left out here; test_profile compares the answers of two times",
    ("plugin-host", "--time"): "it is asked nothing; test_bench_solver has questions",
    ("plugin-host", "--places"): "it is asked nothing; test_unsteady has questions",
    ("solve", "--threads"): "the results are the same bits for any number",
    ("film", "--threads"): "the films are the same; test_film compares them and the estimate",
    ("verify", "--jobs"): "the verdict is the same; test_jobs counts the processes, and has the refusals",
    ("sweep", "--out"): "with --estimate nothing is written: the line of the run itself is estimated as it stands",
    ("sweep", "--without-fma"): "it changes last digits, and estimated times; test_sweep holds the bits",
    ("sweep merge", "--mixed-fma"): "the shards are of one processor; test_sweep_faults has others",
    ("sweep merge", "--force"): "there is no result yet; test_sweep has one",
    ("init", "--force"): "there is no file yet; test_init has one",
    ("sweep", "--force"): "there is no result yet; test_sweep has one",
    ("sweep", "--resume"): "there are no parts yet; test_sweep_faults has some",
    ("sweep", "--join"): "no other process computes it; test_sweep_join has some",
}


def options_of(command):
    """The long names, or else the short ones, that --help lists."""
    text = run(*command.split(), "--help").out.partition("\nExample:\n")[0]
    return [(re.search("--[a-z-]+", line) or re.search("-[a-z]", line))[0]
            for line in text.splitlines() if re.match(r" {2}-", line)]


class Ignored(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Folder()
        cls.addClassCleanup(cls.folder.cleanup)
        line = scene(bodies={"effective_modulus": 107.9e9, "radius_x": 9.5e-3, "length": 1e-2}, load=2000,
                           speed=1.0, closures={"film": "dowson_toyoda_central"})
        cls.words = {"SCENE": cls.folder.write("scene.toml", scene()), "LINE": cls.folder.write("line.toml", line),
                     "SWEEP": cls.folder.write("sweep.toml", SWEEP), "PLUGIN": str(BUILT / "c_plugin.so"), "VERDICTS": cls.folder.path("verdicts"), "DATA": cls.folder.write("measured.csv", "speed [m/s],film [nm]\n0.1,30\n"),
                     # Its first answer takes longer than the limits that are tried.
                     "SUBJECT": altered(cls.folder, """answer = answer if name else {"id": case, "skip": "no points"}
    if "first" not in globals():
        import time
        first = time.sleep(0.3)""")}
        cls.folder.write("other.toml", SWEEP.replace("load = 50", "load = 51"))
        os.mkdir(cls.folder.path("verdicts"))
        cls.folder.write("verdicts/x.toml", 'name = "x"\nlanguage = "C"\ndate = "2026-11-28"\n')
        cls.folder.write("verdicts/x.json", run("verify", "--plugin", str(BUILT / "c_plugin.so"), "--sample", "3", "--format", "json").out)
        less = Folder()
        cls.addClassCleanup(less.cleanup)
        nearly = altered(less, 'answer = answer if name == "hertz_point" else {"id": case, "skip": "no"}')
        for words in (["verify", "--subject", nearly, "--sample", "3", "--baseline", "base.json", "--update-baseline"],
                      ["sweep", "sweep.toml", "-o", "done.h5"], ["sweep", "other.toml", "-o", "other.h5"], ["sweep", "sweep.toml", "-o", "1.shard", "--shard", "1/2"],
                      ["sweep", "sweep.toml", "-o", "2.shard", "--shard", "2/2"]):
            done = run(*words, cwd=cls.folder.name)
            assert done.code == 0, done.err

    def outcome(self, command, arguments):
        """All visible effects of a run: exit code, stdout, stderr, files."""
        path = self.folder.path("run")
        shutil.rmtree(path, ignore_errors=True)
        os.mkdir(path)
        for word in arguments:
            if word.startswith("DIR/") and os.path.isfile(self.folder.path(word[4:])):
                shutil.copy(self.folder.path(word[4:]), path)
        words = [self.words.get(word, word).replace("DIR", path) for word in arguments]
        done = run(*command.split(), *words, stdin="")
        files = {}
        for folder, _, names in os.walk(path):
            for name in names:
                with open(os.path.join(folder, name), "rb") as file:
                    files[os.path.relpath(os.path.join(folder, name), path)] = file.read()
        out = re.sub(r"\d+(\.\d+)? (s|µs)", "some s", done.out)
        if command == "profile":  # its counts and shares differ from run to run, and with them the widths of its table
            out = re.sub(r"[-\s]+", " ", re.sub(r"\d[\d.,\u202f\u00a0]*", "some", out))
        return done.code, out, done.err, files

    def is_refused(self, outcome, option):
        code, out, err, _ = outcome
        return code == 2 and out == "" and len(err.splitlines()) == 1 and option in err

    def test_every_option_of_every_form_does_something_or_is_refused(self):
        refused = set()
        for command, base, of_form in FORMS:
            plain = self.outcome(command, base)
            self.assertFalse(self.is_refused(plain, "-"), (command, base, plain[2]))
            for option in options_of(command):
                if option in ("--help", "--version") or option in of_form or (option == "--out" and "-o" in of_form):
                    continue
                if (command, option) in UNSEEN and ({"--estimate", "--about"}.isdisjoint(of_form) or option in ("--without-fma", "--out")):
                    continue
                if "--plugin" in base and option.endswith("-timeout"):
                    continue  # the plug-in is too quick for an effect
                with self.subTest(command=command, form=base, option=option):
                    outcome = self.outcome(command, [*base, option, *VALUES[option]])
                    if self.is_refused(outcome, option):
                        refused.add((command, option))
                    else:
                        self.assertNotEqual(outcome, plain, "it is ignored")
        for one in (("verify", "--baseline"), ("verify", "--require"), ("verify", "--sample"), ("verify", "--tolerance"),
                    ("solve", "--threads"), ("onset", "--departure"), ("sweep", "--pictures"), ("sweep", "--mixed-fma"), ("reproduce", "--claim")):
            self.assertIn(one, refused)

    def test_every_command_and_each_of_its_options_is_in_the_table(self):
        elsewhere = {"bench", "report"}  # other tests use their options; --alone is in test_bench_solver
        commands = {form[0].split()[0] for form in FORMS} | elsewhere
        self.assertEqual(commands, {*COMMANDS, "plugin-host"})
        for command in [*sorted({form[0] for form in FORMS} | elsewhere)]:
            unknown = set(options_of(command)) - {"--help", "--version", *VALUES}
            self.assertEqual(unknown, set(), command)
        for command, option in UNSEEN:
            self.assertIn(option, options_of(command), command)

    def test_an_option_without_a_value_as_of_an_unset_variable_is_refused(self):
        for command, base in {form[0]: form[1] for form in FORMS}.items():
            for option in options_of(command):
                if VALUES.get(option) in (None, []):
                    continue
                for words in ([option, ""], [f"{option}="]):
                    code, out, err, _ = self.outcome(command, [*base, *words])
                    self.assertEqual((code, out, len(err.splitlines())), (2, "", 1), (command, base, words, err))
        for option in ("--baseline", "--filter", "--plugin", "--subject", "--junit"):
            done = run("bench", option, "")
            self.assertEqual((done.code, done.err),
                             (2, f"tribocheck: {option}: nothing is given; leave it out, or give a value (see --help)\n"))

    def test_options_in_front_of_a_subcommand_are_refused(self):
        for words in (["--estimate"], ["--threads", "2"], ["--format", "csv"], ["-o", "x"]):
            code, out, err, _ = self.outcome("sweep", [*words, "show", "DIR/done.h5"])
            self.assertEqual((code, out, len(err.splitlines())), (2, "", 1), words)
            self.assertIn("would be ignored in front of `sweep show`", err)


if __name__ == "__main__":
    unittest.main()
