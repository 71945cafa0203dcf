# SPDX-License-Identifier: Apache-2.0
"""The page of `tribocheck report` in a browser: headless Chromium, by Selenium, from a file.

On a phone and on a screen, in light and in dark, on paper, and with the keyboard.
"""

import base64
import pathlib
import re
import tempfile
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.keys import Keys

from page_pictures import COLOURS
from report_files import WrittenReport

WIDTHS = (390, 800, 1400)
SCHEMES = ("light", "dark")
SWITCHES = ("--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync",
            "--disable-dev-shm-usage", "--hide-scrollbars")

# Texts that stick out of the window, or out of a box that clips them and does not scroll.
CLIPPED = """
const found = [], walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
const scrolls = (style) => /auto|scroll/.test(style.overflowX);
const clips = (style) => /hidden|clip/.test(style.overflowX + style.overflowY);
for (let node; (node = walker.nextNode()); ) {
  if (!node.data.trim() || node.parentElement.closest('svg, style, .skip')) continue;
  const range = document.createRange();
  range.selectNodeContents(node);
  for (const box of range.getClientRects()) {
    let left = 0, right = innerWidth, inside = false;
    for (let one = node.parentElement; one && !inside; one = one.parentElement) {
      const style = getComputedStyle(one), edge = one.getBoundingClientRect();
      inside = scrolls(style);
      if (inside || clips(style)) { left = Math.max(left, edge.left); right = Math.min(right, edge.right); }
    }
    if (!inside && box.width > 0 && (box.left < left - 1 || box.right > right + 1)) found.push(node.data.trim());
  }
}
return found;
"""

# The least contrast of a text against the colour behind it, by WCAG 2: [ratio, text].
CONTRAST = """
const canvas = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
const channels = (colour) => {
  canvas.clearRect(0, 0, 1, 1);
  canvas.fillStyle = colour;
  canvas.fillRect(0, 0, 1, 1);
  return canvas.getImageData(0, 0, 1, 1).data;
};
const luminance = (colour) => {
  const [r, g, b] = [...channels(colour)].map((c) => c / 255)
    .map((c) => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const behind = (element) => {
  for (let one = element; one; one = one.parentElement) {
    const colour = getComputedStyle(one).backgroundColor;
    if (channels(colour)[3] === 255) return colour;
  }
  return 'white';
};
let least = [100, ''];
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
for (let node; (node = walker.nextNode()); ) {
  const element = node.parentElement;
  if (!node.data.trim() || element.closest('svg, style')) continue;
  const [a, b] = [luminance(getComputedStyle(element).color), luminance(behind(element))];
  const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  if (ratio < least[0]) least = [ratio, node.data.trim()];
}
return least;
"""

# The texts of each figure, the texts that stick out of it, and the pairs of texts that overlap.
FIGURE_TEXTS = """
return [...document.querySelectorAll('figure svg')].map((svg) => {
  const paper = svg.getBoundingClientRect();
  const texts = [...svg.querySelectorAll('text')].map((one) => [one.textContent.trim(), one.getBoundingClientRect()])
    .filter(([text, box]) => text && box.width > 0);
  const cut = texts.filter(([, box]) => box.left < paper.left - 1 || box.right > paper.right + 1 ||
    box.top < paper.top - 1 || box.bottom > paper.bottom + 1).map(([text]) => text);
  const over = [];
  texts.forEach(([first, a], i) => texts.slice(i + 1).forEach(([second, b]) => {
    const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
    const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    if (wide > 1 && high > 3) over.push(first + ' | ' + second);
  }));
  return {id: svg.closest('figure').id, texts: texts.map(([text]) => text), cut, over};
});
"""

UNNAMED_REGIONS = """
return [...document.querySelectorAll('*')].filter((one) => {
  const style = getComputedStyle(one);
  return /auto|scroll/.test(style.overflowX) && one.scrollWidth > one.clientWidth &&
    !one.closest('svg') && !(one.tabIndex === 0 && one.getAttribute('aria-label'));
}).map((one) => one.outerHTML.slice(0, 80));
"""


def browser(profile):
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    for switch in (*SWITCHES, f"--user-data-dir={profile}"):
        options.add_argument(switch)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


class Browsed(WrittenReport):
    """A report in a headless Chromium of its own."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        cls.addClassCleanup(cls.profile.cleanup)
        cls.driver = browser(cls.profile.name)
        cls.addClassCleanup(cls.driver.quit)

    def look_at(self, width, scheme, media):
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "media": media, "features": [{"name": "prefers-color-scheme", "value": scheme}]})
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 800, "deviceScaleFactor": 1, "mobile": False})


class Page(Browsed):
    def show(self, width=1400, scheme="light", media="", is_open=True):
        """Loads the page, and opens its closed sections if `is_open`."""
        self.look_at(width, scheme, media)
        self.driver.get((self.out / "index.html").as_uri())
        if is_open:
            self.run_script("document.querySelectorAll('details').forEach((one) => { one.open = true; })")

    def figures(self):
        found = {one["id"]: one for one in self.run_script(FIGURE_TEXTS)}
        self.assertGreater(len(found), 20)
        return found

    def test_no_label_of_a_figure_is_cut_or_printed_over_another(self):
        for width in WIDTHS:
            self.show(width=width)
            for name, figure in self.figures().items():
                with self.subTest(figure=name, width=width):
                    self.assertEqual((figure["cut"], figure["over"]), ([], []))

    def run_script(self, script):
        return self.driver.execute_script(script)

    def add_style(self, text):
        self.driver.execute_script(
            "document.head.appendChild(document.createElement('style')).textContent = arguments[0]", text)

    def test_console_is_silent(self):
        self.show()
        self.assertEqual(self.driver.get_log("browser"), [])

    def test_nothing_is_fetched(self):
        """Self-contained: the pictures are part of the page."""
        self.show()
        self.assertEqual(self.run_script(
            "return performance.getEntriesByType('resource').map((one) => one.name)"
            ".filter((name) => !name.startsWith('data:'))"), [])

    def test_links_lead_somewhere(self):
        self.show()
        links = self.run_script("return [...document.links].map((one) => one.getAttribute('href'))")
        self.assertGreater(len(links), 100)
        for link in set(links):
            with self.subTest(link):
                if link.startswith("#"):
                    self.assertTrue(self.run_script(
                        f"return document.getElementById({link[1:]!r}) !== null"))
                else:
                    self.assertTrue((self.out / link).is_file())

    def test_pictures_are_drawn(self):
        self.show()
        boxes = self.run_script(
            "return [...document.querySelectorAll('figure svg')].map((one) => "
            "[one.getBoundingClientRect().width, one.getBBox().height, one.querySelectorAll(':is(path, polygon, use, text):not(defs *)').length])")
        self.assertGreaterEqual(len(boxes), 7)
        for width, height, shapes in boxes:
            self.assertGreater(width, 500)
            self.assertGreater(height, 300)
            self.assertGreater(shapes, 20)

    def test_fits_the_window(self):
        for width in WIDTHS:
            with self.subTest(width):
                self.show(width)
                self.assertLessEqual(
                    self.run_script("return document.documentElement.scrollWidth - innerWidth"), 0)
                self.assertEqual(self.run_script(CLIPPED), [])

    def test_what_scrolls_can_be_reached_and_has_a_name(self):
        for width in WIDTHS:
            with self.subTest(width):
                self.show(width)
                self.assertEqual(self.run_script(UNNAMED_REGIONS), [])

    def test_contrast(self):
        for scheme in SCHEMES:
            with self.subTest(scheme):
                self.show(scheme=scheme)
                ratio, text = self.run_script(CONTRAST)
                self.assertGreaterEqual(ratio, 4.5, text)

    def test_these_checks_bite(self):
        for style, script in (("p { white-space: nowrap; }", CLIPPED),
                              (".badge { overflow: hidden; width: 1rem; min-width: 0; }", CLIPPED),
                              (".scroll { overflow: hidden; }", CLIPPED),
                              ("figcaption { overflow-x: auto; width: 20rem; white-space: nowrap; }",
                               UNNAMED_REGIONS)):
            with self.subTest(style):
                self.show(360)
                self.add_style(style)
                self.assertNotEqual(self.run_script(script), [])
        self.add_style("p { color: #888; }")
        self.assertLess(self.run_script(CONTRAST)[0], 4.5)

    def test_dark_is_dark_and_so_are_the_pictures(self):
        self.show(scheme="dark")
        for one in ("body", ".picture"):
            colour = self.run_script(f"return getComputedStyle(document.querySelector('{one}')).backgroundColor")
            self.assertLess(max(map(int, colour[4:-1].split(","))), 64, one)
        self.assertIn("invert", self.run_script("return getComputedStyle(document.querySelector('.picture svg')).filter"))

    def test_what_is_drawn_stands_out_from_its_ground(self):
        """Lines and points of the data have a contrast of at least 3 : 1 on white, and in dark mode after its colour filter."""
        def luminance(colour):
            parts = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour]
            return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]

        def contrast(a, b):
            low, high = sorted((luminance(a), luminance(b)))
            return (high + 0.05) / (low + 0.05)

        def darkened(colour):
            """invert(.89) hue-rotate(180deg), as style.css has it, by the matrix of the CSS specification."""
            r, g, b = (0.89 - 0.78 * c for c in colour)
            rows = ((-0.574, 1.430, 0.144), (0.426, 0.430, 0.144), (0.426, 1.430, -0.856))
            return [min(1, max(0, x * r + y * g + z * b)) for x, y, z in rows]

        seen = set()
        for path in sorted((self.out / "figures").glob("*.svg")):
            if "film_map" in path.name or path.name == "line_film_errors.svg":  # maps have fields of colour
                continue
            for found in re.findall(r"(?:<path stroke|color)='rgb\(([^)]+)\)'", path.read_text()):
                numbers = re.findall(r"\d+", found)
                colour = tuple(int(number) / 255 for number in numbers)
                if colour in seen or luminance(colour) > 0.5 and max(colour) - min(colour) < 0.1:
                    continue  # the ground, and the grey lines of the grid
                seen.add(colour)
                with self.subTest(path.name, colour=found):
                    self.assertGreaterEqual(contrast(colour, (1, 1, 1)), 3)
                    self.assertGreaterEqual(contrast(darkened(colour), darkened((1, 1, 1))), 3)
        self.assertGreaterEqual(len(seen), 5)
        # The surfaces differ in luminance, too, for readers who see no colours.
        surfaces = [tuple((COLOURS[name] >> shift & 0xFF) / 255 for shift in (16, 8, 0)) for name in ("rough", "medium", "smooth")]
        self.assertLessEqual(set(surfaces), seen)
        for lighter, darker in zip(surfaces, surfaces[1:]):
            self.assertGreaterEqual((luminance(lighter) + 0.05) / (luminance(darker) + 0.05), 1.5)

    def test_the_first_screen_has_the_table_of_the_papers_numbers(self):
        """On a phone, too, and without scrolling sideways."""
        for width, height in ((390, 844), (1400, 900)):
            self.show(width=width, is_open=False)
            box = self.run_script(
                "const box = document.querySelector('header table').getBoundingClientRect();"
                "const around = document.querySelector('header .scroll');"
                "return [box.bottom + scrollY, around.scrollWidth - around.clientWidth]")
            with self.subTest(width=width):
                self.assertLessEqual(box[0], height)
                self.assertLessEqual(box[1], 1)

    def test_at_most_six_thousand_words_are_open(self):
        self.show(is_open=False)
        self.assertLess(len(self.run_script("return document.querySelector('main').innerText").split()), 6000)
        self.assertLess((self.out / "index.html").stat().st_size, 3.2e6)

    def test_a_link_opens_the_closed_section_that_it_leads_to(self):
        self.show(is_open=False)
        self.assertFalse(self.run_script("return document.querySelector('#planted-faults details').open"))
        self.run_script("location.hash = '#planted-faults'")
        self.assertTrue(self.driver.execute_async_script(
            "const done = arguments[0];"
            "setTimeout(() => done(document.querySelector('#planted-faults details').open), 50)"))

    def test_a_picture_tells_the_values_under_the_pointer_and_can_be_enlarged(self):
        self.show()
        told = self.run_script("""
            const svg = document.querySelector('#figure_10 svg'), box = svg.getBoundingClientRect();
            const axes = Object.fromEntries(svg.dataset.axes.split(' ').map((one) => one.split('=')));
            const shown = document.querySelector('.values');
            const at = (x, y) => {
              const place = {clientX: box.left + x / 960 * box.width, clientY: box.top + y / 640 * box.height};
              svg.dispatchEvent(new PointerEvent('pointermove', place));
              const {left, top} = shown.getBoundingClientRect();
              return [left > place.clientX, top > place.clientY];
            };
            const beside = at(Number(axes.xmin) + 0.01, Number(axes.ytop) + 0.01), inside = shown.textContent;
            at(5, 5);
            return [inside, ...beside, shown.hidden];""")
        self.assertEqual(told, ["x = 0.000100, y = 1.00e+3", True, True, True])
        told = self.run_script("""
            const svg = document.querySelector('#stribeck_of_machines svg'), box = svg.getBoundingClientRect();
            const axes = Object.fromEntries(svg.dataset.axes.split(' ').map((one) => one.split('=')));
            svg.dispatchEvent(new PointerEvent('pointermove', {
              clientX: box.left + (Number(axes.xmin) + 0.01) / 960 * box.width,
              clientY: box.top + (Number(axes.ytop) + 0.01) / 1100 * box.height}));
            return document.querySelector('.values').textContent;""")
        self.assertEqual(told, "x = 0.00100, y = 1.00", "the lowest panel: speed and load share")
        wide = "return document.querySelector('#figure_10 svg').getBoundingClientRect().width"
        before = self.run_script(wide)
        self.run_script("document.querySelector('#figure_10 .enlarge').click()")
        self.assertGreater(self.run_script(wide), 1.8 * before)
        self.driver.switch_to.active_element.send_keys(Keys.ESCAPE)
        self.assertEqual(self.run_script(wide), before)

    def test_on_a_phone_a_picture_fits_the_width_and_can_be_enlarged(self):
        self.show(width=390)
        boxes = self.run_script("return [...document.querySelectorAll('figure svg')].map((one) => one.getBoundingClientRect().right)")
        self.assertGreater(len(boxes), 20)
        self.assertLessEqual(max(boxes), 390)
        self.run_script("document.querySelector('#figure_10 .enlarge').click()")
        self.assertGreater(self.run_script("return document.querySelector('#figure_10 svg').getBoundingClientRect().width"), 800)

    def test_on_a_desktop_no_table_hides_a_column_but_lists_of_faults(self):
        self.show(width=1280)
        wide = self.run_script("return [...document.querySelectorAll('.scroll.table')].filter((one) => one.scrollWidth > one.clientWidth + 1)"
                               ".map((one) => one.closest('section').id)")
        self.assertLessEqual(set(wide), {"mutants", "planted-faults", "environment"})

    def test_sections_tables_and_pictures_are_numbered_on_paper_and_links_tell_the_section(self):
        self.show(media="print")
        shown = "return getComputedStyle(document.querySelector(arguments[0]), arguments[1]).content"
        for what, part, text in (("#claims h2", "::before", '"3. "'), ("#claims caption span", "::before", '"Table 3.1. "'),
                                 ("#figures figure h3", "::before", '"Picture 1.1. "'), ("header a[href='#misprints']", "::after", '" [section 8]"'),
                                 ("#data a", "::after", "none")):
            with self.subTest(what):
                self.assertEqual(self.driver.execute_script(shown, what, part), text)
        numbers = self.run_script("return [...document.querySelectorAll('[data-number]')].map((one) => one.dataset.number)")
        self.assertGreater(len(numbers), 100)
        told = [one for one in numbers if not one.isdigit()]
        self.assertEqual(len(told), len(set(told)))
        self.assertEqual(self.run_script("return document.querySelectorAll('main .sections table, figure').length"), len(told))
        self.show()
        self.assertEqual(self.driver.execute_script(shown, "header a[href='#misprints']", "::after"), "none")

    def test_on_a_phone_the_verdicts_are_in_sight(self):
        self.show(width=390)
        places = self.run_script("return [...document.querySelectorAll('.sections .verdict')].map((one) => one.getBoundingClientRect().right)")
        self.assertGreater(len(places), 100)
        self.assertLessEqual(max(places), 390)

    def test_closed_sections_are_printed_open_and_closed_again(self):
        self.show(is_open=False)
        closed = "return document.querySelectorAll('details:not([open])').length"
        before = self.run_script(closed)
        self.assertGreater(before, 10)
        self.run_script("dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(self.run_script(closed), 0)
        self.run_script("dispatchEvent(new Event('afterprint'))")
        self.assertEqual(self.run_script(closed), before)

    def test_first_tab_reaches_the_skip_link(self):
        self.show()
        self.driver.switch_to.active_element.send_keys(Keys.TAB)
        skip = self.driver.switch_to.active_element
        self.assertEqual(skip.get_attribute("href").split("#")[1], "main")
        self.assertGreaterEqual(skip.rect["y"], 0)
        skip.send_keys(Keys.ENTER)
        self.assertEqual(self.run_script("return document.activeElement.id"), "main")
        self.driver.switch_to.active_element.send_keys(Keys.TAB)
        self.assertEqual(self.driver.switch_to.active_element.find_element(
            "xpath", "ancestor::header").tag_name, "header")

    def test_landmarks_headings_and_tables(self):
        self.show()
        self.assertEqual(self.run_script(
            "return ['main', 'nav', 'header', 'h1'].map((one) => document.querySelectorAll(one).length)"),
            [1, 1, 1, 1])
        self.assertEqual(self.run_script(
            "return [...document.querySelectorAll('table')].filter((one) => !one.caption.innerText.trim() "
            "|| [...one.querySelectorAll('th')].some((head) => !head.scope)).length"), 0)
        self.assertEqual(self.run_script(
            "return [...document.querySelectorAll('svg')].filter((one) => one.getAttribute('aria-labelledby')"
            ".split(' ').some((id) => !document.getElementById(id).textContent)).length"), 0)

    def test_on_paper(self):
        """In dark mode, too: paper is white, all columns are there, and controls of a screen are not."""
        self.show(width=700, scheme="dark", media="print")
        self.assertEqual(self.run_script("return getComputedStyle(document.body).backgroundColor"),
                         "rgb(255, 255, 255)")
        self.assertGreaterEqual(self.run_script(CONTRAST)[0], 4.5)
        for hidden in ("nav", ".skip", ".enlarge"):
            self.assertEqual(self.run_script(
                f"return getComputedStyle(document.querySelector('{hidden}')).display"), "none")
        self.assertEqual(self.run_script(
            "return [...document.querySelectorAll('.scroll')].filter((one) => "
            "one.scrollWidth > one.clientWidth + 1).map((one) => one.ariaLabel)"), [])
        self.assertEqual(self.run_script(CLIPPED), [])
        pdf = base64.b64decode(self.driver.execute_cdp_cmd("Page.printToPDF", {})["data"])
        self.assertTrue(pdf.startswith(b"%PDF"))
        pathlib.Path(self.folder.name, "page.pdf").write_bytes(pdf)
        self.assertGreater(pdf.count(b"/Type /Page\n"), 5)


if __name__ == "__main__":
    unittest.main()
