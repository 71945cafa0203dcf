# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep: the sweep files that it refuses, its result files, and its numbers compared with other commands."""

import json
import os
import re
import shutil
import signal
import subprocess
import time
import unittest

from program import PROGRAM, read_terminal, run, start, wait_for
from sweeps import NORMAL, SANITIZED, UNIFORM, SweepTest, opened, sweep

ROOT = os.environ["TRIBOCHECK_ROOT"]
SHIPPED = os.path.join(ROOT, "reference", "published", "sweeps")


class Results(SweepTest):
    def scene_of(self, values, **fields):
        """The scene of one case, for the program's other commands."""
        text = sweep({**{path: repr(float(value)) for path, value in values.items()}, **fields})
        return self.folder.write("case.toml", text.replace("[sweep]\n", ""))

    def test_cases_of_a_sweep_are_those_of_solve(self):
        self.swept(sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.01, 0.2, 2.0]",
                          "surface.summit_height_sd": "[2.5e-8, 1e-7]"}, draws=20))
        with opened(self.path("out.h5")) as file:
            group = file["smooth"]
            self.assertEqual(group["outputs/film"].shape, (40, 3))
            for case in (0, 7, 19, 20, 39):
                values = {path: data[case] for path, data in group["inputs"].items()}
                solved = run("solve", self.scene_of(values, speed="[0.01, 0.2, 2.0]"), "--format",
                             "json").json()["points"]
                for j, point in enumerate(solved):
                    for name, data in group["outputs"].items():
                        self.assert_same(data[case][j], point[name], name, data)

    def test_curves_of_many_speeds_are_those_of_solve_to_the_bit(self):
        speeds = "{ from = 1e-4, to = 3, count = 50 }"
        self.swept(sweep({"load": "[20, 50]", "speed": speeds}))
        with opened(self.path("out.h5")) as file:
            for case, load in enumerate((20.0, 50.0)):
                solved = run("solve", self.scene_of({"load": load}, speed=speeds), "--format",
                             "json").json()["points"]
                films = [point["film"] for point in solved]
                self.assertEqual(list(file["smooth/outputs/film"][case]), films)
                self.assertEqual(list(file["smooth/speed"]), [point["speed"] for point in solved])

    def test_onsets_are_those_of_onset(self):
        self.swept(sweep({"lubricant.viscosity": NORMAL},
                         onset='["film_maximum", "film_departure"]', draws=50, departure=0.1))
        with opened(self.path("out.h5")) as file:
            group = file["smooth"]
            for case in (0, 13, 49):
                values = {path: data[case] for path, data in group["inputs"].items()}
                rows = run("onset", self.scene_of(values), "--criterion", "film_maximum",
                           "--criterion", "film_departure", "--departure", "0.1", "--format",
                           "json").json()["onsets"]
                for row in rows:
                    for number in ("speed", "film", "film_parameter"):
                        got = group[f"outputs/onset/{row['criterion']}/{number}"][case]
                        self.assertEqual(got, row[number])

    def test_speed_can_be_drawn(self):
        self.swept(sweep({"speed": '{ distribution = "log_uniform", from = 0.01, to = 1 }',
                          "outputs": '["film"]'}, draws=100))
        with opened(self.path("out.h5")) as file:
            self.assertEqual(file["smooth/outputs/film"].shape, (100,))
            speed = file["smooth/inputs/speed"][42]
            solved = run("solve", self.scene_of({"speed": speed}), "--format", "json").json()["points"][0]
            film = file["smooth/outputs/film"][42]
            self.assertLessEqual(abs(film - solved["film"]), 1e-14 * film)

    def test_grids_of_words_and_numbers_are_crossed(self):
        self.swept(sweep({"closures.asperity": '["greenwood_tripp", "greenwood_williamson"]',
                          "load": "{ from = 10, to = 40, count = 4, spacing = \"lin\" }",
                          "surface.offset_planes": "[0, 1, 2]", "speed": "0.1"}))
        with opened(self.path("out.h5")) as file:
            inputs = {path: list(data[:]) for path, data in file["smooth/inputs"].items()}
            self.assertEqual(len(set(zip(*inputs.values()))), 24)
            self.assertEqual(sorted(set(inputs["load"])), [10, 20, 30, 40])
            self.assertEqual(set(inputs["surface.offset_planes"]), {0, 1, 2})

    def test_draws_keep_their_distributions(self):
        self.swept(sweep({"lubricant.viscosity": NORMAL, "load": '{ printed = "50" }',
                          "bodies.reduced_radius": '{ distribution = "log_normal", '
                                                   'median = 9.5e-3, log_sd = 0.1, to = 1e-2 }'},
                         onset='["film_maximum"]', draws=4096))
        with opened(self.path("out.h5")) as file:
            inputs = file["smooth/inputs"]
            viscosity = inputs["lubricant.viscosity"][:]
            self.assertAlmostEqual(viscosity.mean(), 0.0202, delta=2e-6)
            self.assertAlmostEqual(viscosity.std(), 0.001, delta=2e-6)
            load = inputs["load"][:]
            self.assertTrue(49.5 <= load.min() and load.max() <= 50.5)
            self.assertAlmostEqual(load.mean(), 50, delta=1e-3)
            radius = inputs["bodies.reduced_radius"][:]
            self.assertLessEqual(radius.max(), 1e-2)
            self.assertGreater((radius < 9.5e-3).mean(), 0.7)  # most of the distribution lies below its median, as its upper part is cut off

    def test_correlated_draws(self):
        import numpy
        self.swept(sweep({"lubricant.viscosity": NORMAL,
                          "load": '{ distribution = "normal", mean = 50, sd = 2 }'},
                         onset='["film_maximum"]', draws=8192, design='"monte_carlo"',
                         correlated='["load", "lubricant.viscosity"]',
                         correlation="[[1, -0.6], [-0.6, 1]]"))
        with opened(self.path("out.h5")) as file:
            inputs = file["smooth/inputs"]
            got = numpy.corrcoef(inputs["load"][:], inputs["lubricant.viscosity"][:])[0, 1]
        self.assertAlmostEqual(got, -0.6, delta=0.03)

    def test_summaries_are_of_the_kept_points(self):
        import numpy
        result = self.swept(sweep({"lubricant.viscosity": NORMAL}, onset='["film_maximum"]',
                                  draws=3000, design='"latin_hypercube"'), "--format", "json")
        with opened(self.path("out.h5")) as file:
            values = file["smooth/outputs/onset/film_maximum/speed"][:]
            summary = file["smooth/summary/onset/film_maximum/speed"]
            self.assertAlmostEqual(summary["mean"][0], values.mean(), delta=1e-14)
            self.assertAlmostEqual(summary["sd"][0], values.std(ddof=1), delta=1e-13)
            self.assertEqual(summary["least"][0], values.min())
            error = summary["quantiles"].attrs["relative_error"]
            for level, got in zip(summary["quantile_levels"], summary["quantiles"][0]):
                true = numpy.quantile(values, level, method="inverted_cdf")
                self.assertLessEqual(abs(got - true), error * true + 1e-15, level)
            counts, edges = summary["histogram_counts"][0], summary["histogram_edges"][0]
            for i, count in enumerate(counts):
                if count:
                    inside = (values >= edges[i]) & (values < edges[i + 1])
                    self.assertEqual(count, inside.sum())
            self.assertEqual(counts.sum(), 3000)
        self.assertEqual(json.loads(result.out)["scenes"][0]["id"], "smooth")

    def test_sensitivities_of_a_power_law_are_those_of_its_exponents(self):
        # The onset speed of a flooded inlet is proportional to 1/viscosity, and hardly depends on
        # load: nearly all variance comes from viscosity.
        self.swept(sweep({"lubricant.viscosity": UNIFORM, "load": '{ printed = "50" }'},
                         onset='["film_maximum"]', draws=2048, sensitivity="true"))
        with opened(self.path("out.h5")) as file:
            group = file["smooth/sensitivity"]
            names = [n if isinstance(n, str) else n.decode() for n in group.attrs["variables"]]
            speed = group["onset/film_maximum/speed"]
            at = names.index("lubricant.viscosity")
            self.assertGreater(speed["first_order_high"][0][at], 0.999)
            self.assertGreater(speed["total"][0][at], 0.999)
            self.assertLess(speed["total"][0][1 - at], 1e-3)
            self.assertLessEqual(speed["total_low"][0][at], speed["total"][0][at])


class Files(SweepTest):
    TEXT = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 1.0]"}, draws=3000)

    def test_any_number_of_threads_gives_the_same_bytes(self):
        for threads in (1, 2, 5):
            self.swept(self.TEXT, "--threads", threads, out=f"{threads}.h5")
        self.assertEqual(self.bytes_of("1.h5"), self.bytes_of("2.h5"))
        self.assertEqual(self.bytes_of("1.h5"), self.bytes_of("5.h5"))
        self.assertEqual(self.names(), ["1.h5", "2.h5", "5.h5", "sweep.toml"])

    def test_shards_merge_to_the_same_bytes(self):
        self.swept(self.TEXT, out="whole.h5")
        shards = []
        for part in (2, 3, 1):
            self.swept(self.TEXT, "--shard", f"{part}/3", out=f"{part}.shard")
            shards.append(self.path(f"{part}.shard"))
        run("sweep", "merge", *shards, "-o", self.path("merged.h5")).ended(0)
        self.assertEqual(self.bytes_of("merged.h5"), self.bytes_of("whole.h5"))
        missing = run("sweep", "merge", *shards[:2], "-o", self.path("half.h5"))
        self.assert_refused(missing, "chunks are in none of these")

    def test_a_shard_without_chunks_merges(self):
        # One chunk in all, so that only one of three shards has it.
        text = self.TEXT.replace("3000", "16")
        self.swept(text, out="whole.h5")
        for part in (1, 2, 3):
            self.swept(text, "--shard", f"{part}/3", out=f"{part}.shard")
        for order in ((1, 2, 3), (3, 2, 1), (2, 1, 3)):
            run("sweep", "merge", *(self.path(f"{part}.shard") for part in order), "-o", self.path("merged.h5"),
                "--force").ended(0)
            self.assertEqual(self.bytes_of("merged.h5"), self.bytes_of("whole.h5"))

    def test_shards_of_different_sweeps_do_not_merge(self):
        self.swept(self.TEXT, "--shard", "1/2", out="1.shard")
        self.swept(self.TEXT.replace("3000", "3001"), "--shard", "2/2", out="2.shard")
        result = run("sweep", "merge", self.path("1.shard"), self.path("2.shard"), "-o",
                     self.path("x.h5"))
        self.assert_refused(result, "2.shard", "another sweep")

    def test_show_says_that_it_was_given_a_shard(self):
        for part in ("1/1", "1/3", "2/3", "3/3"):
            self.swept(self.TEXT, "--shard", part, "--force", out="a.shard")
            self.assert_refused(run("sweep", "show", self.path("a.shard")),
                                "a.shard: this is a shard or part of a sweep; make a result of it first",
                                "`tribocheck sweep merge`", "`tribocheck sweep --resume`")

    def test_several_scenes_share_one_file(self):
        names = [self.folder.write(f"{s}.toml", self.TEXT.replace('"smooth"', f'"{s}"'))
                 for s in ("a", "b")]
        run("sweep", *names, "-o", self.path("both.h5")).ended(0)
        with opened(self.path("both.h5")) as file:
            self.assertEqual(list(file), ["a", "b"])
            self.assertTrue((file["a/outputs/film"][:] == file["b/outputs/film"][:]).all())
        self.assert_refused(run("sweep", names[0], names[0], "-o", self.path("x.h5")), "both have")

    def test_the_result_tells_what_it_is(self):
        self.swept(self.TEXT)
        with opened(self.path("out.h5")) as file:
            self.assertEqual(file["smooth"].attrs["scene"], self.TEXT)
            self.assertEqual(file["smooth"].attrs["seed"], 1)
            self.assertEqual(file["smooth/outputs/film"].attrs["unit"], "m")
            version = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True).stdout
            self.assertIn(file.attrs["tribocheck_version"], version)
            self.assertEqual(file.attrs["title"], "Results of tribocheck sweep: sweep.toml")
            commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=os.environ["TRIBOCHECK_ROOT"],
                                    capture_output=True, text=True).stdout.strip()
            self.assertRegex(file.attrs["tribocheck_commit"], r"^([0-9a-f]{40}(-dirty)?)?$")
            self.assertEqual(bool(file.attrs["tribocheck_commit"]), bool(commit))

    def test_outputs_tell_their_meaning_and_have_the_speeds_as_their_scale(self):
        self.swept(self.TEXT)
        with opened(self.path("out.h5")) as file:
            for name, data in file["smooth/outputs"].items():
                self.assertGreaterEqual(len(data.attrs["meaning"]), 10, name)
                self.assertEqual(data.attrs["meaning"], file["smooth/summary"][name].attrs["meaning"])
                self.assertEqual(list(data.dims[1].keys()), ["speed"])
                self.assertEqual(data.dims[1][0], file["smooth/speed"])
                self.assertEqual(len(data.dims[0]), 0)
            self.assertIn("undefined where the film has collapsed", file["smooth/outputs/asperity_load_share"].attrs["meaning"])
        self.swept(self.TEXT + 'onset = ["film_maximum"]\n', "--force")
        with opened(self.path("out.h5")) as file:
            self.assertIn("undefined where the case has no such onset",
                          file["smooth/outputs/onset/film_maximum/speed"].attrs["meaning"])

    def test_show_says_what_sweep_said(self):
        for form in ("table", "csv", "json"):
            said = self.swept(self.TEXT, "--force", "--format", form)
            shown = run("sweep", "show", self.path("out.h5"), "--format", form)
            self.assertEqual((shown.code, shown.out), (0, said.out))

    @unittest.skipUnless(shutil.which("octave-cli"), "octave is not installed")
    def test_octave_reads_it(self):
        self.swept(self.TEXT)
        code = (f"s = load('{self.path('out.h5')}').smooth;"
                "printf('%d %d %.17g\\n', size(s.outputs.film), s.outputs.film(1));")
        said = subprocess.run(["octave-cli", "--quiet", "--eval", code], capture_output=True,
                              text=True, timeout=120)
        with opened(self.path("out.h5")) as file:
            first = float(file["smooth/outputs/film"][0][0])
        self.assertEqual(said.stdout.split()[:2], ["2", "3000"], said.stderr)  # Octave reverses the order of dimensions
        self.assertEqual(float(said.stdout.split()[2]), first)

    @unittest.skipUnless(shutil.which("h5dump"), "h5dump is not installed")
    def test_h5dump_reads_it_and_finds_no_dates(self):
        self.swept(self.TEXT)
        said = subprocess.run(["h5dump", "-p", "-d", "/smooth/outputs/film", "-s", "0,0", "-c",
                               "1,2", self.path("out.h5")], capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("COMPRESSION DEFLATE", said.stdout)
        self.assertIn("PREPROCESSING SHUFFLE", said.stdout)
        listed = subprocess.run(["h5ls", "-r", "-v", self.path("out.h5")], capture_output=True, text=True)
        self.assertEqual(listed.returncode, 0, listed.stderr)
        self.assertIn("/smooth/outputs/film", listed.stdout)
        self.assertNotIn("Modified:", listed.stdout)

    def test_the_shipped_sweeps_run(self):
        files = [os.path.join(SHIPPED, name) for name in sorted(os.listdir(SHIPPED))]
        self.assertGreaterEqual(len(files), 4)
        self.assertEqual(run("sweep", *files, "-o", self.path("shipped.h5")).ended(0).err, "")

    def test_the_shipped_onset_sweeps_are_the_papers_scenes(self):
        import tomllib
        for surface in ("smooth", "medium", "rough"):
            with open(os.path.join(SHIPPED, f"onset_{surface}.toml"), "rb") as file:
                varied = tomllib.load(file)
            with open(os.path.join(SHIPPED, "..", f"{surface}.toml"), "rb") as file:
                scene = tomllib.load(file)
            for section in ("surface", "bodies", "lubricant", "supply", "friction"):
                for key, value in scene[section].items():
                    own = varied[section][key]
                    self.assertEqual(float(own["printed"] if isinstance(own, dict) else own), value)
            self.assertEqual(float(varied["load"]["printed"]), scene["load"])


class Estimates(SweepTest):
    def test_estimate_says_points_time_memory_and_size_and_leaves_nothing(self):
        text = sweep({"lubricant.viscosity": UNIFORM, "speed": "0.1"}, draws=200000)
        path = self.folder.write("sweep.toml", text)
        said = run("sweep", path, "--estimate").ended(0)
        for word in ("points 2e+05", "time", "memory", "file"):
            self.assertIn(word, said.out)
        self.assertEqual(self.names(), ["sweep.toml"])
        line = next(line for line in said.out.splitlines() if line.startswith("file"))
        number, unit = line.split()[1:3]
        estimated = float(number) * {"kB": 1e3, "MB": 1e6}[unit.strip(",")]
        self.swept(text)
        size = os.path.getsize(self.path("out.h5"))
        self.assertLess(abs(estimated - size), 0.1 * size, said.out)

    SPEEDS = "{ from = 1e-3, to = 3, count = %d }"
    # Sweeps of different kinds: kept points, many speeds, summaries alone, indices, grids.
    SHAPES = [
        sweep({"lubricant.viscosity": UNIFORM, "speed": SPEEDS % 20}, draws=4000),
        sweep({"lubricant.viscosity": UNIFORM, "speed": SPEEDS % 2000, "outputs": '["film"]'}, draws=64),
        sweep({"lubricant.viscosity": UNIFORM, "speed": SPEEDS % 1000}, draws=64, keep='"summaries"'),
        sweep({"lubricant.viscosity": UNIFORM, "load": '{ printed = "50" }', "speed": SPEEDS % 100},
              draws=64, sensitivity="true"),
        sweep({"lubricant.viscosity": "{ from = 1e-3, to = 1, count = 100 }", "speed": "[0.1, 1.0]",
               "closures.asperity": '["greenwood_tripp", "greenwood_williamson"]'}),
    ]

    def estimate(self, text):
        """The estimated sizes of memory, file and parts, and the memory that the estimate itself took, all in bytes."""
        path = self.folder.write("sweep.toml", text)
        process = start("sweep", path, "--estimate", stdout=subprocess.PIPE)
        said = process.stdout.read().decode()
        process.stdout.close()
        code, own = wait_for(process)
        self.assertEqual(code, 0)
        found = re.findall(r"(memory|file +|parts of) ([0-9.e+]+) ([kMG])B", said)
        self.assertEqual(len(found), 3, said)
        units = {"k": 1e3, "M": 1e6, "G": 1e9}
        return [float(number) * units[unit] for _, number, unit in found], own * 2**20

    def test_memory_and_files_are_what_a_sweep_takes_within_a_factor_of_one_and_a_half(self):
        # Sanitizers take memory of their own. With them only the files of the first and the last shape are compared.
        for i, text in enumerate(self.SHAPES[::4] if SANITIZED else self.SHAPES):
            with self.subTest(shape=i):
                (memory, file, parts), _ = self.estimate(text)
                process = start("sweep", self.path("sweep.toml"), "-o", self.path("out.h5"), "--force",
                                stdout=subprocess.DEVNULL)
                code, taken = wait_for(process)
                self.assertEqual(code, 0)
                self.swept(text, "--shard", "1/1", "--force", out="all.shard")
                real = [taken * 2**20] + [os.path.getsize(self.path(name))
                                          for name in ("out.h5", "all.shard")]
                ratios = [said / taken for said, taken in zip((memory, file, parts), real)]
                print("estimated over real memory, file, parts: " +
                      ", ".join(f"{ratio:.2f}" for ratio in ratios), flush=True)
                for ratio in ratios if not SANITIZED else ratios[1:]:
                    self.assertLess(ratio, 1.5)
                    self.assertGreater(ratio, 1 / 1.5)

    def test_what_has_no_room_is_refused_at_once_and_estimated_in_little_memory(self):
        wide = sweep({"lubricant.viscosity": UNIFORM, "speed": self.SPEEDS % 1_000_000}, draws=1000)
        (memory, _, _), own = self.estimate(wide)
        self.assertGreater(memory, 50e9)
        self.assertLess(own, 150e6 if not SANITIZED else 1e9)
        wider = sweep({"lubricant.viscosity": UNIFORM, "speed": self.SPEEDS % 10_000_000}, draws=100)
        self.assert_refused(self.sweep(wider), "of memory", "this machine has", "allowed:")
        many = sweep({"lubricant.viscosity": UNIFORM, "speed": "[0.1, 1.0]"}, draws="100000000000")
        self.assert_refused(self.sweep(many), "on the disk", "allowed:")
        self.assertEqual(self.names(), ["sweep.toml"])


class Progress(SweepTest):
    # The sweep takes some seconds, as it searches for the friction minimum.
    TEXT = sweep({"load": '{ printed = "50" }', "speed": "{ from = 1e-3, to = 1 }",
                  "surface.summit_plane_offset": "0.919"},
                 onset='["friction_minimum"]', draws=4000 if SANITIZED else 25000)

    def said_to(self, stderr, stopped=0.0):
        path = self.folder.write("sweep.toml", self.TEXT)
        process = start("sweep", path, "-o", self.path("out.h5"), "--force",
                        stdout=subprocess.DEVNULL, stderr=stderr)
        if stopped:
            time.sleep(0.2)
            process.send_signal(signal.SIGSTOP)
            time.sleep(stopped)
            process.send_signal(signal.SIGCONT)
        self.assertEqual(process.wait(timeout=120), 0)

    def test_a_terminal_sees_rate_and_time_left_on_one_line(self):
        reader, writer = os.openpty()
        self.said_to(writer, stopped=1.0)  # so that a progress line comes before the first cases are computed
        os.close(writer)
        said = read_terminal(reader)
        self.assertRegex(said, rb"\rcomputed [0-9.]+ %, .* points, .* a second, .* left")
        for line in re.findall(rb"\r(computed [^\r\x1b]+)", said):  # the time left is told once the first points are done
            self.assertRegex(line, rb"^computed [0-9.]+ %, (0 of [^,]+, 0 a second|[1-9][^,]*, [^,]+, [0-9.]+ (s|min|h) left)$")
        self.assertNotIn(b"\n", said)
        self.assertTrue(said.endswith(b"\r\x1b[K"))

    def test_a_pipe_and_a_file_hear_nothing_of_a_short_run(self):
        with open(self.path("log"), "wb") as log:
            self.said_to(log)
        self.assertEqual(self.bytes_of("log"), b"")
        self.assertEqual(self.sweep(self.TEXT, "--force").err, "")


class BadSweeps(SweepTest):
    CASES = [
        ({}, {}, ["nothing varies"]),
        ({"surface.rms_roughness": '[{ distribution = "uniform", from = 1e-8, to = 2e-8 }, "10 nm"]'}, {},
         ["surface.rms_roughness", "a list of two faces takes no distribution"]),
        ({"surface.rms_roughness": '[["20 nm", "10 nm"], ["30 nm", "10 nm"], ["40 nm", "10 nm"]]'}, {},
         ["surface.rms_roughness: a list of two faces takes no lists; allowed: two numbers, or in a sweep { from = …, to = …, count = … } or"]),
        ({"surface.rms_roughness": '"30 ± 5 nm"'}, {}, ["surface.rms_roughness", "a number with its spread", '{ distribution = "normal"']),
        ({"load": '{ distribution = "normal", mean = "50 N", sd = "13 %" }'}, {},
         ['load.sd: "13 %" is not in a unit that fits; allowed: a number above 0 (a spread in % is log_sd of a log_normal distribution)']),
        ({"load": "[]"}, {}, ["load", "the list is empty"]),
        ({"load": "[50, 50]"}, {}, ["load", "twice"]),
        ({"load": '[50, "x"]'}, {}, ["load[1]", '"x" is a text']),
        ({"load": "[50, -1]"}, {}, ["load", "-1 is not allowed"]),
        ({"load": "{ from = 1, to = 2 }"}, {}, ["load.count", "missing"]),
        ({"load": "{ from = 2, to = 1, count = 3 }"}, {}, ["load.to", "not above from"]),
        ({"load": "{ from = 0, to = 1, count = 3 }"}, {}, ["load.from", "no logarithm"]),
        ({"load": "{ from = 1, to = 2, count = 3, spacing = \"lni\" }"}, {},
         ["load.spacing", "did you mean lin?"]),
        ({"load": "{ from = 1, to = 2, cuont = 3 }"}, {}, ["load.cuont", "did you mean count?"]),
        ({"load": '{ distribution = "gauss", mean = 1, sd = 1 }'}, {}, ["load.distribution"]),
        ({"load": '{ distribution = "normal", mean = 50 }'}, {}, ["load.sd", "missing"]),
        ({"load": '{ distribution = "normal", mean = 50, sd = -1 }'}, {}, ["load.sd", "-1"]),
        ({"load": '{ distribution = "normal", mean = 50, sd = 20 }'}, {},
         ["load: this normal distribution reaches −11", "; load must be a number above 0, in N: "
          "truncate it with `from`"]),
        ({"lubricant.viscosity": '{ distribution = "normal", mean = 0.0202, sd = 0.01 }'}, {},
         ["lubricant.viscosity: this normal distribution reaches −0.06",
          "; viscosity must be a number above 0, in Pa·s: truncate it with `from`, as from = 0.000202, which cuts off 0.0228 of it, "
          "or take a log_normal distribution; 0.0217 of it lies beyond that range"]),
        # Φ(−2.02), Φ(−6) and Φ(−4)
        ({"lubricant.viscosity": '{ distribution = "normal", mean = 0.06, sd = 0.01 }'}, {},
         [", as from = 0.0", ", which cuts off ", " of it; 9.87e-10 of it lies beyond that range"]),
        ({"bodies.effective_modulus": None, "bodies.first_modulus": "2e11", "bodies.second_modulus": "2e11", "bodies.second_poisson_ratio": "0.3",
          "bodies.first_poisson_ratio": '{ distribution = "normal", mean = 0.3, sd = 0.05 }'}, {},
         ["must be a number above -1 and at most 0.5: truncate it with `to`", "; 3.17e-05 of it lies beyond that range"]),
        ({"bodies.effective_modulus": None, "bodies.first_modulus": "2e11", "bodies.second_modulus": "2e11", "bodies.second_poisson_ratio": "0.3",
          "bodies.first_poisson_ratio": '{ distribution = "normal", mean = 0.3, sd = 0.4, to = 0.4 }'}, {},
         ["must be a number above -1 and at most 0.5: truncate it with `from`, as from = -0.989, which cuts off "]),
        ({"load": '{ distribution = "uniform", from = -3, to = 5 }'}, {},
         ["load: this uniform distribution reaches −3; load must be a number above 0, in N"]),
        ({"friction.viscosity": '"roelands"', "lubricant.viscosity":
          '{ distribution = "normal", mean = 1e-3, sd = 1e-3, from = 1e-5 }'}, {},
         ["this normal distribution reaches 1e-05", "must be a number above 6.315e-5, in Pa·s", "truncate it with `from`\n"]),
        ({"load": '{ distribution = "normal", mean = 50, sd = 20, median = 3 }'}, {},
         ["load.median", "not a field of this kind"]),
        ({"load": '{ distribution = "uniform", from = 50, to = inf }'}, {}, ["load.to", "finite"]),
        ({"surface.summit_plane_offset": '{ distribution = "uniform", from = -1e308, to = 1e308 }'}, {},
         ["surface.summit_plane_offset.to", "no finite number"]),
        ({"load": '{ printed = 50 }'}, {}, ["load.printed", "as a text"]),
        ({"load": '{ printed = "fifty" }'}, {}, ["load.printed", "is no number"]),
        ({"load": '{ printed = "0" }'}, {}, ["load", "not allowed"]),
        ({"friction.viscosity": '"roelands"', "lubricant.viscosity": '{ printed = "0.0001" }'}, {},
         ["this printed number reaches 5e-05; viscosity must be a number above 6.315e-5"]),
        ({"load": '{ value = 3 }'}, {}, ["load.value", "unknown field"]),
        ({"load": '{}'}, {}, ["load", "does not say how"]),
        ({"surface.offset_planes": '{ distribution = "uniform", from = 0, to = 2 }'}, {},
         ["surface.offset_planes", "is not drawn"]),
        ({"surface.offset_planes": '{ printed = "1" }'}, {}, ["surface.offset_planes", "is not drawn"]),
        ({"surface.offset_planes": "[0, 0.5]"}, {}, ["surface.offset_planes", "not whole"]),
        ({"closures.asperity": '["greenwood"]'}, {}, ["closures.asperity[0]"]),
        ({"load": UNIFORM.replace("0.0", "1")}, {"design": '"factorial"'}, ["sweep.design"]),
        ({"load": "[1, 2]"}, {"draws": 10}, ["sweep.draws", "nothing is drawn"]),
        ({"load": '{ printed = "50" }'}, {"draws": 0}, ["sweep.draws", "from 1"]),
        ({"load": '{ printed = "50" }'}, {"seed": -1}, ["sweep.seed"]),
        ({"load": '{ printed = "50" }'}, {"onset": '["film_maximun"]'},
         ["sweep.onset[0]", "did you mean film_maximum?"]),
        ({"load": '{ printed = "50" }'}, {"onset": "[]"},
         ["sweep.onset: the list is empty; allowed: a list of film_maximum"]),
        ({"load": '{ printed = "50" }'}, {"departure": 1}, ["sweep.departure"]),
        ({"load": '{ printed = "50" }'}, {"keep": '"all"'}, ["sweep.keep"]),
        ({"load": '{ printed = "50" }'}, {"sede": 1}, ["sweep.sede", "did you mean seed?"]),
        ({"load": "[1, 2]"}, {"sensitivity": "true"}, ["sweep.sensitivity"]),
        ({"load": '{ printed = "50" }'}, {"sensitivity": "true", "draws": 10}, ["sweep.draws"]),
        ({"load": '{ printed = "50" }'}, {"correlation": "[[1]]"}, ["sweep.correlated"]),
        ({"load": '{ printed = "50" }', "lubricant.viscosity": UNIFORM},
         {"correlated": '["load", "lubricant.viscosity"]', "correlation": "[[1, 2], [2, 1]]"},
         ["sweep.correlation", "from -1 to 1"]),
        ({"load": '{ printed = "50" }', "lubricant.viscosity": UNIFORM},
         {"correlated": '["load", "lubricant.viscosity"]', "correlation": "[[1, 1], [1, 1]]"},
         ["sweep.correlation", "positive definite"]),
        ({"load": '{ printed = "50" }', "id": '"a/b"'}, {}, ["id", "group"]),
        ({"load": '{ printed = "50" }', "speed": None}, {}, ["speed", "missing"]),
        ({"load": '{ printed = "50" }'}, {"draws": "1e12", "sensitivity": "true"}, ["points"]),
    ]

    def test_each_gets_one_line_that_names_the_field_and_what_is_allowed(self):
        for changes, settings, words in self.CASES:
            with self.subTest(changes=changes, settings=settings):
                text = sweep({"speed": "0.1", **changes}, **settings)
                self.assert_refused(self.sweep(text), "sweep.toml", *words)
                self.assertEqual(self.names(), ["sweep.toml"])

    def test_usage(self):
        path = self.folder.write("sweep.toml", sweep({"load": "[1, 2]", "speed": "1"}))
        self.assert_refused(run("sweep", path), "-o")
        self.assert_refused(run("sweep"), "SWEEP")
        self.assert_refused(run("sweep", path, "-o", self.path("x"), "--shard", "3/2"), "3/2")
        self.assert_refused(run("sweep", self.path("none.toml"), "-o", self.path("x")), "none.toml")
        self.assert_refused(run("sweep", "show", path), "sweep.toml")
        self.assert_refused(run("sweep", "merge", path, "-o", self.path("x")), "sweep.toml")

    def test_mistakes_in_fields_and_in_settings_are_told_together(self):
        result = self.sweep(sweep({"load": '{ printed = "fifty" }'}, seed=-1, sede=2))
        self.assertEqual((result.code, len(result.error_lines)), (2, 3), result.err)

    def test_a_name_that_is_no_text_is_refused_before_anything_is_computed(self):
        text = sweep({"lubricant.viscosity": UNIFORM, "speed": "1"}, draws=10**9)
        path = os.fsencode(self.folder.name) + b"/\xff.toml"
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        self.assert_refused(run("sweep", os.fsdecode(path), "-o", self.path("out.h5")), "not UTF-8")
        os.remove(path)
        self.assertEqual(self.names(), [])

    def test_more_threads_than_are_of_use_are_not_taken(self):
        result = self.sweep(sweep({"lubricant.viscosity": UNIFORM, "speed": "1"}, draws=100),
                            "--threads", 4096)
        self.assertEqual((result.code, len(result.error_lines)), (0, 1), result.err)
        self.assertIn("--threads 4096", result.err)

    def test_json_is_refused(self):
        self.assert_refused(self.sweep('{"load": 3}'), "JSON")

    def test_a_wild_table_is_no_sweep(self):
        for text in ("sweep = 3\n", "[sweep]\n", "load = [[[[[[[1]]]]]]]\n", "[[sweep]]\na = 1\n"):
            with self.subTest(text=text):
                result = self.sweep(text)
                self.assertEqual((result.code, result.out), (2, ""), result.err)
                self.assertGreater(len(result.error_lines), 0)


if __name__ == "__main__":
    unittest.main()
