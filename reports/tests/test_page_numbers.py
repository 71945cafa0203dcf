# SPDX-License-Identifier: Apache-2.0
"""Numbers of each part of the page, computed a second time with SciPy from the paper's Table 1 and equations alone."""
import functools
import itertools
import math
import re
import unittest

from report_files import WrittenReport
from scipy import integrate, optimize, special

# Table 1, with the misprints mended.
LOAD, MODULUS, RADIUS, VISCOSITY, ALPHA, OFFSET, RATIO, SUMMIT = 50.0, 107.9e9, 9.5e-3, 0.0202, 2e-8, 1.146, 4.0, 1e-5
SURFACES = {"rough": (5e10, 1e-7), "medium": (1e11, 5e-8), "smooth": (2e11, 2.5e-8)}
SLOW, FAST = 1e-4, 3.0
MEAN_PRESSURE = LOAD / (math.pi * (3 * LOAD * RADIUS / (4 * MODULUS)) ** (2 / 3))


def moment(order, d):
    return integrate.quad(lambda s: (s - d) ** order * math.exp(-s * s / 2), d, max(d, 0) + 12, epsabs=0, epsrel=1e-11, limit=200)[0] / math.sqrt(2 * math.pi)


class Contact:
    """One surface with Greenwood and Tripp's contact, m faces with the offset."""

    def __init__(self, surface, m=1.0):
        density, self.sd = SURFACES[surface]
        self.roughness, self.offset = density * SUMMIT * self.sd, m * OFFSET
        self.stiffness = 16 * math.sqrt(2) * math.pi / 15 * self.roughness ** 2 * math.sqrt(self.sd / SUMMIT) * MODULUS / MEAN_PRESSURE

    def share(self, film):
        return min(1.0, math.sqrt(self.stiffness * moment(2.5, film - self.offset)))

    def smooth_film(self, speed):
        plain = 2 * MODULUS
        return 2.69 * (1 - 0.61 * math.exp(-0.73)) * (VISCOSITY * speed / (plain * RADIUS)) ** 0.67 * (ALPHA * plain) ** 0.53 * (
            LOAD / (plain * RADIUS ** 2)) ** -0.067 * RADIUS / self.sd

    @functools.cache
    def flooded(self, speed):
        """λ of the flooded film: as large as the fluid's part of the load makes it."""
        smooth = self.smooth_film(speed)
        least = 0.0
        if self.stiffness * moment(2.5, -self.offset) >= 1:  # there is a floor, at which summits carry all
            least = optimize.brentq(lambda film: self.stiffness * moment(2.5, film - self.offset) - 1, 0, 20, xtol=1e-15, rtol=1e-14)

        def excess(film):
            share = self.share(film)
            return math.log(film / smooth) + 0.14 * math.log1p(-share) if share < 1 else -1e3
        low = max(least * (1 + 1e-12), smooth / 10)
        return low if excess(low) > 0 else optimize.brentq(excess, low, max(20 * smooth, 2 * least), xtol=1e-16, rtol=1e-13)

    def film(self, speed):
        flooded = self.flooded(speed)
        if flooded >= RATIO:
            return 0.0
        length = ((RATIO / flooded - 1) * 3 / (4 * math.sqrt(2))) ** (2 / 3)
        return flooded * 2 / math.pi * math.atan(2.7 * length)

    @functools.cached_property
    def onset(self):
        found = optimize.minimize_scalar(lambda log: -self.film(math.exp(log)), bounds=(math.log(1e-2), math.log(20)), method="bounded",
                                         options={"xatol": 1e-10})
        return math.exp(found.x)

    @property
    def collapse(self):
        return math.exp(optimize.brentq(lambda log: self.flooded(math.exp(log)) - RATIO, math.log(1e-2), math.log(50)))

    @property
    def equal_shares(self):
        return math.exp(optimize.brentq(lambda log: self.share(self.film(math.exp(log))) - 0.5, math.log(SLOW), math.log(self.onset)))

    def slow_share(self):
        return self.share(self.film(SLOW))

    def summit_pressure(self):
        separation = self.film(SLOW) - self.offset
        return self.share(self.film(SLOW)) ** 2 * MEAN_PRESSURE / (math.pi ** 2 * self.roughness ** 2 * moment(2, separation))


def elliptic_contact(load, modulus, radius_x, radius_y):
    """Ellipticity, semi-axis across the entrainment and mean pressure, by the complete elliptic integrals."""
    def ratio(k):
        e2 = 1 - 1 / k ** 2
        return (k ** 2 * special.ellipe(e2) - special.ellipk(e2)) / (special.ellipk(e2) - special.ellipe(e2))
    k = optimize.brentq(lambda k: ratio(k) - radius_y / radius_x, 1.001, 100, xtol=1e-14)
    curvature = 1 / radius_x + 1 / radius_y
    across = (3 * k ** 2 * special.ellipe(1 - 1 / k ** 2) * load / (math.pi * modulus * curvature)) ** (1 / 3)
    return k, across, load / (math.pi * across * across / k)


class Numbers(WrittenReport):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        ids = re.split(r'<a id="([a-z-]+)"></a>', cls.text)
        cls.parts = {"first": ids[0], **dict(zip(ids[1::2], ids[2::2]))}
        cls.contacts = {name: Contact(name) for name in SURFACES}

    def tells(self, section, pattern, *values):
        """Asserts that the groups of the pattern, where it stands first in the section, are the values to their last digits."""
        text = re.sub(r"<[^>]*>|\\|`|\*\*", "", re.sub("[ \n]+", " ", self.parts[section]))
        found = re.search(pattern.replace("NUMBER", r"(−?[\d.\u202f]+)"), text)
        self.assertIsNotNone(found, (section, pattern))
        self.assertEqual(len(found.groups()), len(values), pattern)
        for shown, value in zip(found.groups(), values):
            shown = shown.rstrip(".").replace("−", "-").replace("\u202f", "")
            unit = 10.0 ** -len(shown.partition(".")[2]) if "." in shown else 10.0 ** max(0, len(shown) - max(3, len(shown.rstrip("0"))))
            with self.subTest(section, shown=shown, value=value):
                self.assertLessEqual(abs(float(shown) - value), 0.501 * unit, found[0])

    def test_shares_and_onsets_of_all_three_choices_of_the_offset(self):
        choices = [[Contact(name, m) for name in SURFACES] for m in (1, 2, math.sqrt(2))]
        shares = [[one.slow_share() for one in choice] for choice in choices]
        for choice, (least, most) in zip(shares, ((0.53, 0.77), (0.96, 1), (0.70, 1))):
            self.assertTrue(all(least < share <= most for share in choice), choice)
        first = r"At the lowest speed the summits carry NUMBER, NUMBER and NUMBER of .* m = 1, NUMBER, NUMBER and NUMBER with m = 2, and " \
                r"NUMBER, NUMBER and NUMBER with two equal faces"
        self.tells("first", first, *itertools.chain(*shares))
        for i, name in enumerate(SURFACES):
            self.tells("claims", rf"lowest speed, {name} \| [\d.–]+ \| NUMBER \| NUMBER \| NUMBER \|", *(choice[i] for choice in shares))
            self.tells("claims", rf"onset of starvation, {name}, m/s \| [\d.]+ \| NUMBER \| NUMBER \| NUMBER \|", *(choice[i].onset for choice in choices))

    def test_the_first_screen(self):
        for name, words, printed in (("smooth", "onset of starvation, m/s: smooth", 0.09), ("medium", "medium", 0.15), ("rough", "rough surface", 0.5)):
            speed = self.contacts[name].onset
            self.tells("first", rf"\| {words} \| {printed} \| NUMBER \(NUMBER times\)", speed, speed / printed)
        self.tells("first", r"λ at the onset \| 1.4 \| NUMBER:", self.contacts["smooth"].film(self.contacts["smooth"].onset))
        self.tells("first", r"offset NUMBER σs", math.sqrt(2) * OFFSET)
        self.tells("first", r"Of all NUMBER combinations", 2 * 2 * 3 * 4 * 2 * 2 * 2 * 3 * 2 * 2 * 2 * 2 * 2 * 2 * 8)

    def test_the_figures(self):
        rough, medium, smooth = (self.contacts[name] for name in ("rough", "medium", "smooth"))
        self.tells("figures", r"half each at NUMBER m/s \(rough\), NUMBER m/s \(medium\), NUMBER m/s \(smooth\)",
                   *(one.equal_shares for one in (rough, medium, smooth)))
        self.tells("figures", r"carry least at the onset, NUMBER \(rough\), NUMBER \(medium\), NUMBER \(smooth\)",
                   *(one.share(one.film(one.onset)) for one in (rough, medium, smooth)))
        self.tells("figures", r"onset \(●\): NUMBER nm at .*? NUMBER nm at .*? NUMBER nm", *(1e9 * one.sd * one.film(one.onset) for one in (rough, medium, smooth)))
        self.tells("figures", r"at NUMBER m/s \(medium\), at NUMBER m/s \(smooth\)\. There", medium.collapse, smooth.collapse)
        log = math.log(FAST)
        slope = (math.log(smooth.flooded(math.exp(log + 1e-4))) - math.log(smooth.flooded(math.exp(log - 1e-4)))) / 2e-4
        self.tells("figures", r"With a flooded inlet the slope is NUMBER ", slope)

    def test_the_model_and_what_is_outside_of_it(self):
        smooth = self.contacts["smooth"]
        own = smooth.share(0)
        self.tells("model", r"the smooth surface has A = NUMBER and A² = NUMBER", own, own ** 2)
        self.tells("model", r"αp at the mean pressure is NUMBER", ALPHA * MEAN_PRESSURE)
        self.tells("model", r"summits stay elastic .*? \| at most 2.8 GPa \| NUMBER GPa \| NUMBER GPa \| NUMBER GPa", *(1e-9 * one.summit_pressure() for one in self.contacts.values()))
        self.tells("model", r"to be a liquid.*? \| at least 1.0 nm \| NUMBER nm \| NUMBER nm \| NUMBER nm",
                   *(1e9 * one.sd * one.film(SLOW) for one in self.contacts.values()))
        self.tells("claims", r"carry at most NUMBER of the load", self.contacts["rough"].share(0))
        self.tells("misprints", r"E14 .* \| NUMBER \| NUMBER \| 1.22", 2.69 * (1 - 0.6 * math.exp(-0.73)), 2.69 * (1 - 0.61 * math.exp(-0.73)))
        self.tells("requirements", r"by NUMBER from smooth to medium and by NUMBER from medium", self.contacts["medium"].onset / smooth.onset,
                   self.contacts["rough"].onset / self.contacts["medium"].onset)

    def test_the_contacts_of_machines(self):
        steel = 206e9 / (2 * (1 - 0.3 ** 2))
        k, across, pressure = elliptic_contact(1111.0, steel, 0.005748648097826087, 0.08413750000000013)
        self.tells("contacts", r"ellipticity k = ay/ax \| 1.00 \| NUMBER", k)
        self.tells("contacts", r"semi-axis ay, µm \| \d+ \| NUMBER", 1e6 * across)
        half_width = math.sqrt(4 * 11000 / 0.02 * 0.008381199885452462 / (math.pi * steel))
        self.tells("contacts", r"mean pressure, GPa \| [\d.]+ \| NUMBER \| NUMBER", 1e-9 * pressure, 1e-9 * 11000 / 0.02 / (2 * half_width))

    def test_what_the_checks_of_this_software_count(self):
        """Parts and intervals, from the counts that stand beside them."""
        text = " ".join(self.parts["first"].split())
        noticed, drawn, low, high = (float(one) for one in re.search(
            r"notice ([\d]+) of ([\d]+) wrong .* between ([\d.]+) % and ([\d.]+) %", text).groups())
        part, z = noticed / drawn, 1.959964
        middle, side = part + z * z / (2 * drawn), z * math.sqrt(part * (1 - part) / drawn + z * z / (4 * drawn * drawn))
        for shown, value in ((low, (middle - side) / (1 + z * z / drawn)), (high, (middle + side) / (1 + z * z / drawn))):
            self.assertLess(abs(shown - 100 * value), 0.5)
        bands = [(float(least), float(median)) for least, median in re.findall(
            r"(?m)^\| `[^|]*` \| [\d\u202f–]+ \| ([\d.]+) \| ([\d.]+) \|", self.parts["gates"])]
        self.assertGreater(len(bands), 5)
        widest = max(median / least - 1 for least, median in bands)
        self.assertLess(abs(widest - float(re.search(r"the widest is ([\d.]+) %", self.parts["gates"])[1]) / 100), 2e-3)


if __name__ == "__main__":
    unittest.main()
