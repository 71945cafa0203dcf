# SPDX-License-Identifier: Apache-2.0
"""tribocheck sweep show of forged results with the right checksum at the end. Each is refused in one line, or
gives the numbers that h5py reads, and no other file is read. TRIBOCHECK_FORGED is the number of forged results in
place of forty, TRIBOCHECK_FORGED_FIRST the number of the first one in place of 0."""

import json
import multiprocessing
import os
import random
import re
import struct
import subprocess
import time
import unittest

from program import ENVIRONMENT, PROGRAM
from sweeps import UNIFORM, SweepTest, sealed, sweep

FORGED = int(os.environ.get("TRIBOCHECK_FORGED", 40))
FIRST = int(os.environ.get("TRIBOCHECK_FORGED_FIRST", 0))
SPEEDS = {"speed": "[0.1, 0.5, 1.0]", "lubricant.viscosity": UNIFORM}
GOOD = {
    "points": sweep({**SPEEDS, "outputs": '["film", "friction", "regime"]'}, onset='["film_maximum"]', draws=64),
    "words": sweep({"friction.fluid": '["eyring", "limiting"]', "load": "[40, 50]"}, onset='["film_maximum"]'),
    "summaries": sweep(SPEEDS, keep='"summaries"', draws=64),
    "sensitivity": sweep({**SPEEDS, "load": '{ printed = "50" }'}, sensitivity="true", draws=64),
}


# --- Forging with h5py: a function for datasets, and one for attributes.

def shapes(shape, draw):
    longer = tuple(n + 1 for n in shape)
    return draw.choice([longer, (*shape, 1), (1, *shape), (), (0,), (2**40,), shape[::-1] + (2,), (max(shape, default=1) * 3,)])


def forge_dataset(file, path, draw, folder):
    import h5py
    import numpy
    old = file[path]
    attributes = {name: value for name, value in old.attrs.items() if name not in ("DIMENSION_LIST", "REFERENCE_LIST", "CLASS", "NAME")}
    data, shape = old[()], old.shape
    del file[path]
    kind = draw.choice(["type", "shape", "missing", "group", "soft", "external", "virtual", "stored outside", "filter",
                        "not in chunks", "values", "same link"])
    new = None
    if kind == "type":
        dtype = draw.choice(["f4", ">f8", "i8", "i2", "u1", "S7", h5py.string_dtype(), numpy.dtype([("a", "f8"), ("b", "i4")])])
        new = file.create_dataset(path, shape=shape, dtype=dtype, chunks=shape if all(shape) and shape else None)
    elif kind == "shape":
        other = shapes(shape, draw)
        chunks = tuple(min(max(n, 1), 1000) for n in other) if other else None
        new = file.create_dataset(path, shape=other, dtype=data.dtype, chunks=chunks, maxshape=tuple(None for _ in other) if other else None)
    elif kind == "group":
        file.create_group(path)
    elif kind == "soft":
        file[path] = h5py.SoftLink(draw.choice(["/nowhere", path, "/" + next(iter(file))]))
    elif kind == "external":
        file[path] = h5py.ExternalLink(os.path.join(folder, "other.h5"), "/numbers")
    elif kind == "virtual":
        layout = h5py.VirtualLayout(shape=shape or (1,), dtype="f8")
        layout[...] = h5py.VirtualSource(os.path.join(folder, "other.h5"), "numbers", shape=shape or (1,))
        new = file.create_virtual_dataset(path, layout)
    elif kind == "stored outside" and all(shape) and shape:
        size = max(int(numpy.prod(shape)) * data.dtype.itemsize, 1)
        new = file.create_dataset(path, shape=shape, dtype=data.dtype, external=[(os.path.join(folder, "other.h5"), 0, size)])
    elif kind == "filter" and all(shape) and shape:
        new = file.create_dataset(path, data=data, chunks=shape, **draw.choice([{"compression": "lzf"}, {"scaleoffset": 3}]))
    elif kind == "not in chunks":
        new = file.create_dataset(path, data=data)
    elif kind == "values" and all(shape) and shape:
        values = numpy.frombuffer(draw.randbytes(data.nbytes), data.dtype).reshape(shape)
        new = file.create_dataset(path, data=values, chunks=shape)
    elif kind == "same link":
        others = []
        file.visititems(lambda name, item: others.append(name) if isinstance(item, h5py.Dataset) else None)
        file[path] = file[draw.choice(others)]
    if new is not None:
        for name, value in attributes.items():
            new.attrs[name] = value
    return kind


def forge_attribute(item, name, draw):
    import h5py
    import numpy
    old = item.attrs[name]
    kind = draw.choice(["missing", "number", "numbers", "fixed text", "long text", "texts", "empty", "other count", "nothing"])
    del item.attrs[name]
    if kind == "number":
        item.attrs[name] = draw.choice([1.5, numpy.float32(2), numpy.int8(3), numpy.uint64(2**63), numpy.int64(-1)])
    elif kind == "numbers":
        item.attrs[name] = numpy.arange(draw.choice([2, 1000, 7000]), dtype=draw.choice(["u8", "f8"]))
    elif kind == "fixed text":
        item.attrs[name] = numpy.bytes_(b"film" * draw.choice([1, 100]))
    elif kind == "long text":
        item.attrs[name] = "x" * draw.choice([60000, 10**7])
    elif kind == "texts":
        texts = draw.choice([["film"] * 3, ["../../x", "/", ""], ["onset.none.speed"], list(map(str, range(3000)))])
        item.attrs.create(name, numpy.array(texts, dtype=object), dtype=h5py.string_dtype())
    elif kind == "empty":
        item.attrs[name] = h5py.Empty("f8")
    elif kind == "other count" and isinstance(old, numpy.uint64):
        item.attrs[name] = numpy.uint64(draw.choice([0, int(old) + 1, int(old) * 2, 2**40, 2**63]))
    return kind


def forged_by_h5py(content, draw, folder):
    """Runs in a process of its own, because libhdf5 may crash on a file that was forged before."""
    import h5py
    path = os.path.join(folder, "forging.h5")
    with open(path, "wb") as file:
        file.write(content)
    with h5py.File(path, "r+", track_order=True) as file:
        kinds = []
        for _ in range(draw.choice([1, 1, 2])):
            datasets, attributes = [], [("/", name) for name in file.attrs]

            def note(name, item):
                if isinstance(item, h5py.Dataset):
                    datasets.append(name)
                attributes.extend((name, one) for one in item.attrs
                                  if one not in ("DIMENSION_LIST", "REFERENCE_LIST", "CLASS", "NAME"))
            file.visititems(note)
            if draw.random() < 0.5:
                of_cases = [name for name in datasets if "put" in name or name.endswith(("/count", "/speed"))]
                kinds.append(forge_dataset(file, draw.choice(draw.choice([datasets, of_cases])), draw, folder))
            else:
                of_scenes = [one for one in attributes if one[1] in ("seed", "draws", "cases", "points", "columns",
                                                                     "words", "variables", "arithmetic")]
                name, attribute = draw.choice(draw.choice([attributes, of_scenes, of_scenes]))
                kinds.append(forge_attribute(file[name], attribute, draw))
    with open(path, "rb") as file:
        return kinds, file.read()


def lookup3(content):
    """Jenkins' hash, HDF5's checksum of its object headers."""
    def rotated(x, k):
        return (x << k | x >> (32 - k)) & 0xFFFFFFFF
    a = b = c = (0xDEADBEEF + len(content)) & 0xFFFFFFFF
    if not content:
        return c
    last = (len(content) - 1) // 12 * 12
    for i in range(0, last + 1, 12):
        x, y, z = struct.unpack("<3I", content[i:i + 12].ljust(12, b"\0"))
        a, b, c = (a + x) & 0xFFFFFFFF, (b + y) & 0xFFFFFFFF, (c + z) & 0xFFFFFFFF
        if i < last:
            for k in (4, 6, 8, 16, 19, 4):
                a = (a - c) & 0xFFFFFFFF ^ rotated(c, k)
                c = (c + b) & 0xFFFFFFFF
                a, b, c = b, c, a
        else:
            for k in (14, 11, 25, 16, 4, 14, 24):
                c = ((c ^ b) - rotated(b, k)) & 0xFFFFFFFF
                a, b, c = b, c, a
            c = b
    return c


def forged_header(content, draw):
    """The header of an object with changed bytes and the right checksum."""
    changed = bytearray(content)
    start = draw.choice([found.start() for found in re.finditer(rb"OHDR\x02", content)])
    flags = content[start + 5]
    first = start + 6 + (16 if flags & 0x20 else 0) + (4 if flags & 0x10 else 0)
    width = 1 << (flags & 3)
    end = first + width + int.from_bytes(content[first:first + width], "little")
    assert lookup3(content[start:end]) == int.from_bytes(content[end:end + 4], "little")
    for _ in range(draw.choice([1, 1, 2, 5])):
        at = draw.randrange(first + width, end)
        changed[at] = draw.choice([changed[at] ^ 1 << draw.randrange(8), 0, 0xFF, draw.randrange(256)])
    changed[end:end + 4] = struct.pack("<I", lookup3(bytes(changed[start:end])))
    return ["header"], bytes(changed)


def forged_bytes(content, draw):
    """Flipped, zeroed and copied bytes, most of them where HDF5's own structures lie."""
    if draw.random() < 0.5:
        return forged_header(content, draw)
    changed = bytearray(content)
    marks = [found.start() for found in re.finditer(rb"OHDR|OCHK|FRHP|FHDB|BTHD|BTLF|GCOL|TREE|FSHD|\x89HDF", content)]
    for _ in range(draw.choice([1, 1, 3, 10])):
        at = min(draw.choice(marks) + draw.randrange(4, 200), len(content) - 9) if draw.random() < 0.7 else draw.randrange(len(content) - 8)
        step = draw.randrange(3)
        if step == 0:
            changed[at] ^= 1 << draw.randrange(8)
        elif step == 1:
            changed[at:at + 8] = draw.choice([b"\xff" * 8, b"\0" * 8, draw.randbytes(8)])
        else:
            start = draw.randrange(len(content) - 8)
            changed[at:at + 8] = changed[start:start + 8]
    return ["bytes"], bytes(changed)


# --- Comparison with h5py, which reads the same file.

def close(a, b):
    if b is None:  # JSON has no NaN and no infinity
        return a != a or a in (float("inf"), float("-inf"))
    return b in ("inf", "-inf") and str(a) == b or float(a) == float(b)


def text(value):
    return value.decode() if isinstance(value, bytes) else value


def compare(path, said, cases):
    """Raises AssertionError where a number of the program is not the one that h5py reads."""
    import h5py
    with h5py.File(path) as file:
        for scene in said["scenes"]:
            group = file[scene["id"]]
            for name in ("seed", "draws", "cases", "points"):
                assert scene[name] == int(group.attrs[name]), name
            for column in scene["columns"]:
                summary = group["summary/" + column["name"].replace(".", "/")]
                assert column["unit"] == text(summary.attrs["unit"])
                for i, value in enumerate(column["values"]):
                    for name in ("count", "undefined", "mean", "sd", "least", "greatest"):
                        assert name not in value or close(summary[name][i], value[name]), (column["name"], name)
                    for q, quantile in enumerate(value.get("quantiles", [])):
                        assert close(summary["quantiles"][i, q], quantile["value"]), column["name"]
        for point in cases:
            group = file[point["scene"]]
            for name, value in point.items():
                place = "outputs/" + name.replace(".", "/")
                place = "inputs/" + name if name in group["inputs"] else place
                if name in ("scene", "case", "speed") or place not in group:
                    continue
                read = group[place][point["case"]]
                if getattr(read, "shape", ()):
                    speed = list(group["speed"][()]).index(point["speed"])
                    read = read[speed]
                # The words of an output stand in an attribute of its summary.
                listed = group[place if "inputs" in place else place.replace("outputs", "summary", 1)]
                if "words" in listed.attrs:
                    words = [text(word) for word in listed.attrs["words"]]
                    assert value == (words[int(read)] if read < len(words) else ""), name
                else:
                    assert close(read, value), name


def in_process(function, *arguments):
    """The function's result, or None where libhdf5 crashes or hangs in it."""
    ours, theirs = multiprocessing.Pipe(False)

    def work():
        try:
            theirs.send(function(*arguments))
        except AssertionError as failure:
            theirs.send(f"differs: {failure}")
        except BaseException as failure:  # pylint: disable=broad-except
            theirs.send(f"no: {failure!r}")
    process = multiprocessing.get_context("fork").Process(target=work)
    process.start()
    theirs.close()
    try:
        result = ours.recv() if ours.poll(20) else None
    except EOFError:
        result = None
    process.kill()
    process.join()
    return result


class Forged(SweepTest):
    def setUp(self):
        super().setUp()
        self.good = {}
        for name, content in GOOD.items():
            self.swept(content, out=f"{name}.h5")
            self.good[name] = self.bytes_of(f"{name}.h5")[:-24]

    def show(self, *options):
        environment = dict(ENVIRONMENT)
        environment["ASAN_OPTIONS"] += ":handle_segv=0:handle_abort=0:handle_sigfpe=0:allocator_may_return_null=1"
        start = time.monotonic()
        done = subprocess.run([PROGRAM, "sweep", "show", self.path("forged.h5"), "--format", "json", *options],
                              capture_output=True, text=True, timeout=60, env=environment)
        done.stderr = self.REFUSED_MEMORY.sub("", self.OF_HDF5.sub("", done.stderr))
        return done, time.monotonic() - start

    # Messages of AddressSanitizer about libhdf5's own mistakes, in the child process that reads: 1.10.8 copies a text with
    # the length that a forged heap tells. Messages about this program stay, and fail the test.
    OF_HDF5 = re.compile(r"=+\n==\d+==ERROR: AddressSanitizer(?:(?!#1 ).*\n)*.*#1 .* \(\S*libhdf5.*\n(?:(?!tribocheck: ).*\n)*")

    # AddressSanitizer prints a message on memory that it refuses.
    REFUSED_MEMORY = re.compile(r"(?m)^==\d+==WARNING: AddressSanitizer failed to allocate \w+ bytes\n")

    def check(self, kinds):
        """Whether the result was refused, and the seconds that this took."""
        told, seconds = self.show()
        points, more = self.show("--cases")
        for done in (told, points):
            self.assertIn(done.returncode, (0, 2), done.stderr)
            if done.returncode == 2:
                self.assertEqual((len(done.stderr.splitlines()), done.stdout), (1, ""), done.stderr[:2000])
                self.assertIn("forged.h5", done.stderr)
        if told.returncode == 0:
            cases = [json.loads(line) for line in points.stdout.splitlines()[:300]]
            answer = in_process(compare, self.path("forged.h5"), json.loads(told.stdout), cases)
            self.assertIsNone(answer, kinds)
        self.assertNotRegex(told.stdout + points.stdout, r"(?<![\d.])424242(?!\d)", "another file was read")
        return told.returncode == 2, max(seconds, more)

    def test_each_is_refused_or_gives_the_numbers_that_it_has(self):
        import h5py
        with h5py.File(self.path("other.h5"), "w") as file:
            file["numbers"] = [424242.0] * 10000
        refused, longest = 0, 0
        for number in range(FIRST, FIRST + FORGED):
            draw = random.Random(number)
            content = self.good[draw.choice(list(GOOD))]
            made = (in_process(forged_by_h5py, content, draw, self.folder.name) if number % 2
                    else forged_bytes(content, draw))
            if not isinstance(made, tuple):  # h5py cannot make it
                continue
            kinds, forged = made
            with self.subTest(number=number, kinds=kinds):
                self.put("forged.h5", sealed(forged))
                was_refused, seconds = self.check(kinds)
                refused, longest = refused + was_refused, max(longest, seconds)
        print(f"{FORGED} forged results, {refused} refused, {longest:.1f} s at most", flush=True)
        self.assertGreater(refused, FORGED // 4)

    def test_good_ones_are_read_after_they_were_sealed_again(self):
        for name, content in self.good.items():
            with self.subTest(name=name):
                self.assertEqual(sealed(content), self.bytes_of(f"{name}.h5"))
                self.put("forged.h5", sealed(content))
                self.assertEqual(self.check(["none"])[0], False)


if __name__ == "__main__":
    unittest.main()
