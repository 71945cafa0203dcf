# SPDX-License-Identifier: Apache-2.0
"""Computes the paper's contact with SciPy, from Table 1 and the equations alone, for the tests of the page's numbers."""
import functools
import math
import re

from report_files import WrittenReport
from scipy import integrate, optimize, special

# Table 1, with the misprints mended.
LOAD, MODULUS, RADIUS, VISCOSITY, ALPHA, OFFSET, RATIO, SUMMIT = 50.0, 107.9e9, 9.5e-3, 0.0202, 2e-8, 1.146, 4.0, 1e-5
SURFACES = {"rough": (5e10, 1e-7), "medium": (1e11, 5e-8), "smooth": (2e11, 2.5e-8)}
SLOW, FAST = 1e-4, 3.0
BOUNDARY, EYRING = 0.13, 2.5e6
MEAN_PRESSURE = LOAD / (math.pi * (3 * LOAD * RADIUS / (4 * MODULUS)) ** (2 / 3))


@functools.cache
def moment(order, d):
    return integrate.quad(lambda s: (s - d) ** order * math.exp(-s * s / 2), d, max(d, 0) + 12, epsabs=0, epsrel=1e-11, limit=200)[0] / math.sqrt(2 * math.pi)


class Contact:
    """One surface, with the contact of Greenwood and Tripp (GT) or of Greenwood and Williamson (GW). `m` multiplies the
    offset, `stiffer` the load of the asperities, and `faster` the speed in the film formula."""

    def __init__(self, surface, m=1.0, model="GT", stiffer=1.0, faster=1.0):
        density, self.sd = SURFACES[surface]
        self.roughness, self.offset = density * SUMMIT * self.sd, m * OFFSET
        self.density, self.model, self.faster = density, model, faster
        self.order, self.power = (2.5, 0.5) if model == "GT" else (1.5, 1.0)
        constant = 16 * math.sqrt(2) * math.pi / 15 * self.roughness ** 2 if model == "GT" else 4 / 3 * self.roughness
        self.stiffness = stiffer * constant * math.sqrt(self.sd / SUMMIT) * MODULUS / MEAN_PRESSURE

    def share(self, film):
        return min(1.0, (self.stiffness * moment(self.order, film - self.offset)) ** self.power)

    def smooth_film(self, speed):
        plain = 2 * MODULUS
        return 2.69 * (1 - 0.61 * math.exp(-0.73)) * (VISCOSITY * self.faster * speed / (plain * RADIUS)) ** 0.67 * (ALPHA * plain) ** 0.53 * (
            LOAD / (plain * RADIUS ** 2)) ** -0.067 * RADIUS / self.sd

    @functools.cache
    def flooded(self, speed):
        """λ of the flooded film, by ln(λ/λ of the smooth film) = −0.14 ln(1 − the asperities' share of the load)."""
        smooth = self.smooth_film(speed)
        least = 0.0
        if self.stiffness * moment(self.order, -self.offset) >= 1:  # at a floor the summits carry all the load
            least = optimize.brentq(lambda film: self.stiffness * moment(self.order, film - self.offset) - 1, 0, 20, xtol=1e-15, rtol=1e-14)

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

    def area(self, speed):
        """Real over nominal area of contact."""
        gap = self.film(speed) - self.offset
        return (math.pi * self.roughness) ** 2 * moment(2, gap) if self.model == "GT" else math.pi * self.roughness * moment(1, gap)

    def summits(self, speed):
        """Summits in contact."""
        gap, faced = self.film(speed) - self.offset, self.density * LOAD / MEAN_PRESSURE
        return faced * (4 * math.pi * self.roughness * moment(1, gap) if self.model == "GT" else moment(0, gap))

    def friction(self, speed):
        film, share = self.film(speed), self.share(self.film(speed))
        viscosity = VISCOSITY * math.exp(ALPHA * (1 - share) * MEAN_PRESSURE)
        shear = EYRING * math.asinh(viscosity * speed / (film * self.sd * EYRING))
        return BOUNDARY * share + shear * max(0.0, 1 - self.area(speed)) / MEAN_PRESSURE

    @functools.cached_property
    def onset(self):
        found = optimize.minimize_scalar(lambda log: -self.film(math.exp(log)), bounds=(math.log(self.collapse / 30), math.log(self.collapse)), method="bounded",
                                         options={"xatol": 1e-10})
        return math.exp(found.x)

    @property
    def collapse(self):
        return math.exp(optimize.brentq(lambda log: self.flooded(math.exp(log)) - RATIO, math.log(1e-3), math.log(50)))

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
    ends = (1.001, 100) if radius_y > radius_x else (0.01, 0.999)
    k = 1 if radius_y == radius_x else optimize.brentq(lambda k: ratio(k) - radius_y / radius_x, *ends, xtol=1e-14)
    curvature = 1 / radius_x + 1 / radius_y
    across = (3 * k ** 2 * special.ellipe(1 - 1 / k ** 2) * load / (math.pi * modulus * curvature)) ** (1 / 3)
    return k, across, load / (math.pi * across * across / k)


class Told(WrittenReport):
    """The sections of the page, and a check of the numbers in them."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        ids = re.split(r'<a id="([a-z-]+)"></a>', cls.text)
        cls.parts = {"first": ids[0], **dict(zip(ids[1::2], ids[2::2]))}
        cls.contacts = {name: Contact(name) for name in SURFACES}

    def tells(self, section, pattern, *values):
        """Asserts that the groups of the pattern's first match in the section are the values, each to its last digit."""
        text = re.sub(r"<[^>]*>|\\|`|\*\*", "", re.sub("[ \n]+", " ", self.parts[section]))
        found = re.search(pattern.replace("NUMBER", r"(−?[\d.\u202f]+)"), text)
        self.assertIsNotNone(found, (section, pattern))
        self.assertEqual(len(found.groups()), len(values), pattern)
        for shown, value in zip(found.groups(), values):
            shown = shown.rstrip(".").replace("−", "-").replace("\u202f", "")
            unit = 10.0 ** -len(shown.partition(".")[2]) if "." in shown else 10.0 ** max(0, len(shown) - max(3, len(shown.rstrip("0"))))
            with self.subTest(section, shown=shown, value=value):
                self.assertLessEqual(abs(float(shown) - value), 0.501 * unit, found[0])
