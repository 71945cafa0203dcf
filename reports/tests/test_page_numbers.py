# SPDX-License-Identifier: Apache-2.0
"""Numbers of each part of the page, computed a second time with SciPy from the paper's Table 1 and equations alone."""
import itertools
import math
import re
import unittest

from page_contacts import ALPHA, FAST, MEAN_PRESSURE, OFFSET, SLOW, SURFACES, Contact, Told, elliptic_contact


class Numbers(Told):
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
        for name, words, printed in (("smooth", "onset of starvation, m/s: smooth", 0.09), ("medium", "onset, m/s: medium", 0.15),
                                     ("rough", "onset, m/s: rough", 0.5)):
            speed = self.contacts[name].onset
            self.tells("first", rf"\| {words} \| {printed} \| NUMBER \(NUMBER times\)", speed, speed / printed)
        self.tells("first", r"λ at the onset \| 1.4 \| NUMBER:", self.contacts["smooth"].film(self.contacts["smooth"].onset))
        self.tells("first", r"offset NUMBER σs", math.sqrt(2) * OFFSET)
        self.tells("first", r"of NUMBER readings tie", 2 * 2 * 3 * 4 * 2 * 2 * 2 * 3 * 2 * 2 * 2 * 2 * 2 * 2 * 8)

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
        self.tells("contacts", r"semi-axis ay, µm \| [\d.]+ \| NUMBER", 1e6 * across)
        half_width = math.sqrt(4 * 11000 / 0.02 * 0.008381199885452462 / (math.pi * steel))
        self.tells("contacts", r"mean pressure, GPa \| [\d.]+ \| NUMBER \| NUMBER", 1e-9 * pressure, 1e-9 * 11000 / 0.02 / (2 * half_width))

    def test_what_the_checks_of_this_software_count(self):
        bands = [(float(least), float(median)) for least, median in re.findall(
            r"(?m)^\| `[^|]*` \| [\d\u202f–]+ \| ([\d.]+) \| ([\d.]+) \|", self.parts["gates"])]
        self.assertGreater(len(bands), 5)
        widest = max(median / least - 1 for least, median in bands)
        self.assertLess(abs(widest - float(re.search(r"the widest is ([\d.]+) %", self.parts["gates"])[1]) / 100), 2e-3)


if __name__ == "__main__":
    unittest.main()
