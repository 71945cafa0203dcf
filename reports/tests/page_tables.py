# SPDX-License-Identifier: Apache-2.0
"""The cells that each table of the report's page has to show, from report.json and by formatters of our own.

It uses no template and nothing of reports/page/render: the heading of each column, the field of the data below it
and the number of its digits are written here a second time.
"""
import decimal
import html
import itertools
import math
import re

DASH = "–"
DIGITS = dict(zip("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
SURFACES = ("rough", "medium", "smooth")
CHOICES = {
    "asperity_prefactor=8": "the factor 8√2/15 in place of 16√2/15 in the asperities' load",
    "nominal_area=a2": "a² in place of πa² for the nominal area", "shear=limiting": "the limiting shear stress in place of Eyring's law",
    "offset_planes=2": "the offset 2Dd of the summits in place of Dd (m = 2)",
    "offset_planes=equal_faces": "the offset √2 Dd: Dd/σs of one of two equal faces and σs of their sum (m = √2)",
    "inlet=as_printed": "the inlet's equations as they are printed", "summit_radius=0.1um": "summits of 0.1 µm in place of 10 µm",
    "viscosity=ambient": "the viscosity at ambient pressure", "speed_modulus=E*": "E* in place of 2E* in the speed number U",
    "speed=sum": "the sum of the two surface speeds in place of their mean"}
EXACT = decimal.Context(prec=1200)


def sig(value, digits):
    """The number with `digits` significant digits that is nearest to the double; a half is rounded to even."""
    if value is None or not math.isfinite(value):
        return DASH
    number = abs(decimal.Decimal(value))
    if not number:
        return "0"
    number = EXACT.quantize(number, EXACT.scaleb(decimal.Decimal(1), number.adjusted() - digits + 1))
    power = number.adjusted()
    number = EXACT.quantize(number, EXACT.scaleb(decimal.Decimal(1), power - digits + 1))  # 9.996 was rounded to 10.00: now to 10.0
    if -4 <= power < 6:
        text = f"{number:f}" if power < digits else many(int(number))
    else:
        text = f"{number.scaleb(-power):f} × 10" + "".join(map(DIGITS.get, str(power)))
    return ("−" if value < 0 else "") + text


def whole(value):
    """The number with the fewest digits that read back to it."""
    if value is None:
        return DASH
    return sig(value, len(decimal.Decimal(repr(float(value))).normalize().as_tuple().digits))


def many(count):
    return re.sub(r"(?<=\d)(?=(\d{3})+$)", "\u202f", str(count)) if count >= 10000 else str(count)


def percent(part, digits=3):
    """A part in per cent. Only 0 and 1 are shown as 0 % and 100 %; parts near them become < 0.1 %, or > 99.9 % and the like."""
    if part is None:
        return DASH
    if part in (0, 1):
        return "100 %" if part else "0 %"
    if 0 < part < 0.001:
        return "< 0.1 %"
    text = sig(100 * part, digits)
    if text == sig(100, digits):
        text = "> 100" if part > 1 else {1: "> 90", 2: "> 99", 3: "> 99.9"}[digits]
    return text + " %"


def ends(values, digits):
    low, high = sig(min(values), digits), sig(max(values), digits)
    return low if low == high else f"{low} to {high}"


def yes(one):
    return "yes" if one else "no"


def listed(texts):
    return ", ".join(texts) or DASH


def commit(text):
    return text[:12] + text[40:]


def plain(text):
    """A text of the data without its marks of Markdown. read() gives the same text for a cell of HTML."""
    return re.sub(r"[`~^_*\\]", "", str(text)).strip()


def read(markup):
    return plain(html.unescape(re.sub(r"<[^>]*>", "", markup)))


def shown(page):
    """Caption, headings and rows of each table of index.html. Tables in scripts are left out: the live part makes them when it runs."""
    page = re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)
    for body in re.findall(r"<table>(.*?)</table>", page, re.DOTALL):
        caption = re.search(r"<caption>(.*?)</caption>", body, re.DOTALL)[1]
        head, *rows = [[read(cell) for cell in re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL)]
                       for row in re.findall(r"<tr>(.*?)</tr>", body, re.DOTALL)]
        yield re.sub(r" \(\d+ rows\)$", "", read(caption)), head, rows


# --- The ledger's items, which several tables show.

NUMBER = re.compile(r"−?(\d[\d\u202f]*(?:\.\d+)?)(?:e(-?\d+)| × 10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?")


def alike(one, other):
    """Whether two texts have the same words, and the same numbers to the last digit of the coarser one."""
    def split(text):
        found = []
        for match in NUMBER.finditer(text):
            power = int(match[2] or (match[3] or "⁰").translate({ord(sign): digit for digit, sign in DIGITS.items()}))
            digits = match[1].replace("\u202f", "")
            found.append(((-1 if match[0][0] == "−" else 1) * float(digits) * 10.0**power, 10.0**(power - len(digits.partition(".")[2]))))
        return NUMBER.sub("#", text), found
    (words, mine), (others, theirs) = split(one), split(other)
    return words == others and all(abs(a - b) <= 0.5001 * max(unit, last) for (a, unit), (b, last) in zip(mine, theirs, strict=True))


def unit(text, item):
    return text if DASH in (text, item["unit"]) else f"{text} {item['unit']}"


def asked(item):
    return {"number": lambda: unit(whole(item["reported"]), item), "order": lambda: "above 1",
            "equal": lambda: f"1 ± {100 * item['tolerance']:.4g} %"}.get(item["rule"], lambda: "from " + whole(item["tolerance"]))()


def computed(item, got):
    if got["computed"] is None:
        return DASH
    if item["is_over_speeds"]:
        return ends([got["computed"], got.get("other_end", got["computed"])], 3)
    return unit(sig(got["computed"], 4), item)


def against(item, got):
    if got["computed"] is None or item["rule"] != "number" and not item["is_over_speeds"]:
        return DASH
    if item["rule"] == "number":
        return sig(got["factor"], 3) + " times"
    part = got["holds_at"]
    if part < 0.5 and percent(part) == "50.0 %":
        return "just under half of speeds"
    return {0: "at no speed", 1: "at all speeds"}.get(part, f"at {percent(part)} of speeds")


def verdict(got):
    return (got["verdict"] + (f": {got['none']}" if "none" in got else "") +
            ("" if got["decided"] else "; the margin is below the numerical error"))


def margin(got):
    if "margin" not in got:
        return DASH
    told = got["margin"]
    return f"{sig(told['distance'], 3)}{' of speeds' if told['of'] == 'part' else ''} ± {sig(told['error'], 1)}"


def reading_table(ledger, name):
    return (f"The numbers and comparisons that decide, under the reading “{name}”",
            ["part of claim", "what is computed", "the paper", "computed", "against the paper", "verdict", "margin"],
            [[item["item"], item["label"] + (" (arithmetic)" if item["is_arithmetic"] else ""), asked(item), computed(item, got), against(item, got), verdict(got), margin(got)]
             for item in ledger["items"] for got in [item["readings"][name]]])


# --- The tables, with a function for each section of the page.

def first(report):
    labels = {"C1.smooth": "onset of starvation, m/s: smooth", "C1.medium": "onset, m/s: medium", "C1.rough": "onset, m/s: rough",
              "C2.smooth": "film/roughness λ at the onset", "C4.rough": "load on summits at low speed: rough",
              "C4.smooth": "load on summits at low speed: smooth"}
    items = {one["item"]: one for one in report["ledger"]["items"]}

    def word(got):
        if got["computed"] is None:
            return "no value: " + got["none"]
        times = "" if got["verdict"] == "reproduced" else f" ({sig(got['factor'], 3)} times)"
        return f"{sig(got['computed'], 3)}{times}: {got['verdict']}"
    yield ("The paper's numbers, and ours", ["", "paper", "offset Dd, m = 1", "offset 2Dd, m = 2"],
           [[labels[id], whole(items[id]["reported"]), *(word(items[id]["readings"][name]) for name in ("corrected", "m = 2"))]
            for id in report["ledger"]["headline"]])


def comparison(report):
    found = report["paper"]["comparisons"]
    for key, caption in (("onset_speed", "Onset of starvation: entrainment speed, m/s"),
                         ("onset_film_parameter", "Film parameter at the onset: λ = h/σs")):
        criteria = ["film_maximum", "film_departure", "friction_minimum", "asperity_minimum"]
        rows = {}
        for one in found[key]["rows"]:
            said = "" if one["factor"] is None else " (reproduced)" if one["verdict"] == "reproduced" else f" ({sig(one['factor'], 3)} times)"
            cells = rows.setdefault((one["surface"], one["model"]), {"reported": whole(one["reported"])})
            cells[one["criterion"]] = DASH if one["computed"] is None else sig(one["computed"], 4) + said
        yield (caption, ["surface", "model", "reported", *criteria],
               [[*place, *(cells[one] for one in ("reported", *criteria))] for place, cells in rows.items()])
    yield ("Load share of the asperities at the lowest speed",
           ["surface", "model", "reported", "computed", "computed/reported", "verdict"],
           [[one["surface"], one["model"], whole(one["reported"]), sig(one["computed"], 4), sig(one["factor"], 3),
             one["verdict"] or "the paper gives no number"] for one in found["slow_asperity_share"]["rows"]])


def offsets_table(report):
    offsets, printed = report["paper"]["offsets"], {item["item"]: item["reported"] for item in report["ledger"]["items"]}
    return ("The offset of the summits: what the paper's main numbers become by its choice (E9)", ["number", "paper", *(one["name"] for one in offsets)],
            [["offset of the summits' planes, over σs", DASH, *(sig(one["offset"], 4) for one in offsets)]] +
            [[f"share of the load on summits at the lowest speed, {name}", whole(printed.get("C4." + name)),
              *(sig(one["surfaces"][name]["slow_asperity_share"], 3) for one in offsets)] for name in SURFACES] +
            [[f"onset of starvation, {name}, m/s", whole(printed["C1." + name]),
              *(sig(one["surfaces"][name]["onset_speed"], 4) for one in offsets)] for name in SURFACES])


def others_table(report):
    scenes = [report["paper"]["scenes"][name] for name in SURFACES]
    areas = ", ".join(sig(one["onset"]["real_area_ratio"] if one["onset"] else None, 3) for one in scenes)
    films = ", ".join(sig(1e9 * one["slowest"]["film"], 3) for one in scenes)
    collapses = ", ".join(f"at {sig(one['collapse']['speed'], 3)} m/s ({name})" if one["collapse"] else f"at no speed up to {whole(one['fastest']['speed'])} m/s ({name})"
                          for one, name in zip(scenes[::-1], SURFACES[::-1]))
    return ("Other statements of the paper, which are not counted", ["the paper says", "place", "what we get with GT, m = 1"], [
        ["once the film carries the load the real area is constant again", "Figure 7",
         f"no: it falls up to the onset, to {areas} of the nominal area (rough, medium, smooth), and rises beyond it"],
        ["the film collapses later on a rougher surface", "Figure 10", f"yes: {collapses}"],
        ["roughness hardly changes the film", "Figure 11", f"yes at the lowest speed: {films} nm (rough, medium, smooth); no at the onset, where the film is proportional to σs"]])


def claims(report):
    ledger = report["ledger"]
    names = [one["name"] for one in ledger["readings"]]
    short = {"reproduced": "yes", "not reproduced": "no"}
    yield ("What the paper claims, and whether it is reproduced under each reading",
           ["claim", "the paper says", *names, "of all readings"],
           [[one["claim"], one["statement"] + (" (arithmetic)" if all(
               item["is_arithmetic"] for item in ledger["items"] if item["claim"] == one["claim"]) else ""),
             *(short.get(one["verdicts"][name], "partly") + (" (?)" if name in one["undecided"] else "") for name in names),
             "none" if one["met_by"] == 0 else percent(one["met_by"])] for one in ledger["claims"]])
    if "paper" in report:  # `tribocheck reproduce` has no such tables
        yield others_table(report)
        yield offsets_table(report)
    yield ("Claims reproduced, by how wide the tolerances are", ["tolerances times", *names],
           [[whole(one["factor"]), *(str(one["scores"][name]) for name in names)] for one in ledger["tolerances"]])
    rows = []
    for one in ledger["readings"]:
        more = "".join(f". {group['readings_with_the_same_claims'] - 1} more reproduce the same claims: they differ in {group['differ_in']}"
                       for group in ledger["ranking"]["best"]
                       if group["departures"] == one["departures"] and group["readings_with_the_same_claims"] > 1)
        words = "; ".join(CHOICES[choice] for choice in one["departures"].split(" ") if choice != "corrected")
        rows.append([one["name"], f"{one['score']} of {len(ledger['claims'])}", (words or "nowhere: all misprints mended but for E13 and E26") + more])
    yield ("The readings: what each puts in the place of a misprint",
           ["reading", "claims reproduced", "where it departs from the corrected reading"], rows)
    yield reading_table(ledger, "corrected")
    yield ("The parts of the claims, and how each is computed", ["part of claim", "the paper says", "printed", "place", "computed as"],
           [[one["item"], one["statement"], one["printed"], one["place"], one["computed_as"]] for one in ledger["items"]])


def readings(report):
    ledger = report["ledger"]
    counts, all_readings = ledger["ranking"]["readings_by_score"], ledger["ranking"]["readings"]
    yield ("How many readings reproduce how many claims", ["claims reproduced", "readings", "part of all", "among them"],
           [[str(score), many(count), percent(count / all_readings),
             listed([one["name"] for one in ledger["readings"] if one["score"] == score])]
            for score, count in reversed(list(enumerate(counts))) if count])
    yield ("The switches of a reading", ["switch", "misprint", "choices, the corrected one first", "literal", "what it changes"],
           [[one["name"], one["errata"], ", ".join(one["choices"]), one["literal"], one["meaning"]] for one in ledger["switches"]])

    def identifies(item):
        if item["met_by"] == 0:
            return "no reading meets it"
        if item["met_by"] > 0.9:
            return "nothing: nearly all meet it"
        return ", ".join(f"{one['switch']}={one['choice']} ({percent(one['share'])})" for one in item["identifies"]) or "no single choice"
    yield ("What each item tells apart", ["item", "readings that meet it", "part of all", "bits", "identifies"],
           [[item["item"], many(item["met_by_readings"]), "none" if item["met_by"] == 0 else percent(item["met_by"]),
             sig(item["bits"], 2), identifies(item)] for item in ledger["items"]])
    for one in ledger["arguments"]:
        yield (one["question"], ["candidate", "gives", "by print precision", "agrees"],
               [[way["name"], sig(way["value"], 5), DASH if way["value"] is None else f"{sig(way['low'], 4)} to {sig(way['high'], 4)}", yes(way["agrees"])]
                for way in one["candidates"]])
    for one in ledger["readings"][1:]:
        yield reading_table(ledger, one["name"])


def requirements(report):
    ledger = report["ledger"]
    for item in ledger["items"]:
        found = [one for one in ledger["requirements"] if one["item"] == item["item"] and one["factor"] is not None]
        if item["readings"]["corrected"]["verdict"] == "reproduced" or not found:
            continue
        yield (f"What would make {item['item']} hold: {item['statement']}",
               ["input", "unit", "effect of +1 %, %", "value of the paper", "value needed", "times the paper's", "plausible?",
                "claims mended", "claims broken"],
               [[one["input"], one["unit"], sig(one["sensitivity"], 2), whole(one["paper_value"]), sig(one["value"], 3),
                 sig(one["factor"], 4), f"{'at the limit' if one['at_limit'] and not one['plausible'] else yes(one['plausible'])}: {whole(one['low'])} to {whole(one['high'])}",
                 listed(one["mends"]), listed(one["breaks"])] for one in sorted(found, key=lambda one: one["distance"])])
    departure = ledger["common_departure"]
    yield ("C1 as a departure h = (1 − ε) hff",
           ["surface", "ε that gives its reported speed", "computed/reported at the common ε"],
           [[name, sig(own, 4), sig(factor, 3)] for name, own, factor in zip(SURFACES, departure["own"], departure["factor"], strict=True)])


def below(one, value):
    """How many cases lie below the reported speed, of those that have an onset."""
    count = many(value["count"])
    return {"among them": percent(one["cases_below_reported"], 2), "below all": f"0 of {count}", "above all": f"{count} of {count}"}.get(
        one["reported_lies"], one["reported_lies"])


def quantile(value, level):
    return next(one["value"] for one in value["quantiles"] if one["level"] == level)


def of_ledger(report):
    ledger = report["ledger"]
    printed = {item["item"]: item["reported"] for item in ledger["items"]}
    rows = []
    for one in ledger["uncertainty"]:
        varied = {"print": "print precision"}.get(one["inputs_varied"], "plausible ranges")
        told = [(f"onset speed, {name}, m/s", one["onset_speed"][name], whole(printed["C1." + name])) for name in SURFACES]
        told += [(f"onset speeds, {a}/{b}", one[f"onset_speed_{a}_over_{b}"], sig(printed["C1." + a] / printed["C1." + b], 3))
                 for a, b in (("medium", "smooth"), ("rough", "medium"))]
        told += [("λ at the onset", one["onset_film_parameter"], whole(printed["C2.rough"]))]
        told += [(f"asperity share at the lowest speed, {name}", one["slow_asperity_share"][name], whole(printed.get("C4." + name)))
                 for name in SURFACES]
        rows += [[what, varied, *(sig(of[end], 3) for end in ("low", "median", "high")), reported] for what, of, reported in told]
    yield ("How sure: inputs varied, corrected reading, onset by filmmaximum",
           ["number", "inputs varied", "2.5 %", "median", "97.5 %", "reported"], rows)
    yield ("Film and Hertz contact beside another library", ["case", "number", "other library", "computed", "within its last digit"],
           [[one["case"], f"{one['quantity']}, {one['unit']}", sig(one["reported"], int(one["digits"])),
             sig(one["computed"], int(one["digits"])), yes(one["reproduced"])] for one in ledger["independent"]])


def uncertainty(report):
    yield from of_ledger(report)
    drawn = report["onset_uncertainty"]
    scenes = {one["id"]: {column["name"]: column["values"][0] for column in one["columns"]} for one in drawn["sweep"]["scenes"]}
    cases = {one["id"]: one["cases"] for one in drawn["sweep"]["scenes"]}
    rows = []
    for surface in drawn["surfaces"]:
        for one in surface["speeds"]:
            value = scenes[surface["surface"]][f"onset.{one['criterion']}.speed"]
            lies = below(one, value)
            rows.append([surface["surface"], one["criterion"], sig(one["as_printed"], 3),
                         *(sig(quantile(value, level), 3) for level in (0.025, 0.5, 0.975)),
                         percent(value["undefined"] / cases[surface["surface"]], 2), whole(surface["reported"]["value"]), lies])
    yield ("Onset speeds within the print precision of the inputs, m/s",
           ["surface", "criterion", "as printed", "2.5 %", "median", "97.5 %", "no onset in", "reported", "cases below the reported speed"], rows)
    rows = []
    for one in drawn["surfaces"][0]["speeds"]:
        totals = {name: {variable: of["total"] for variable, of in columns[f"onset.{one['criterion']}.speed"]["sensitivity"]["variables"].items()}
                  for name, columns in scenes.items()}
        greatest = {variable: max(of.get(variable, {"value": None})["value"] or 0 for of in totals.values())
                    for variable in dict.fromkeys(itertools.chain(*totals.values()))}
        for variable in sorted(greatest, key=lambda name: -greatest[name]):
            if greatest[variable] >= 0.005:
                rows.append([one["criterion"], variable, *(total_text(of.get(variable)) for of in totals.values())])
    yield ("What carries the uncertainty: total Sobol indices of the onset speed", ["criterion", "input", *scenes], rows)


def total_text(total):
    if total is None or total["value"] is None:
        return DASH
    beside = 0 if total["high"] is None else total["high"] - total["value"]
    return f"{total['value']:.3f}".replace("-", "−") + (f" ± {beside:.3f}" if beside >= 0.0005 else "")


def misprints(report):
    yield ("The misprints, and how each is settled", ["erratum", "place", "printed", "right", "settled by", "kind"],
           [[one["erratum"], one["place"], one["printed"], one["right"], one["settled_by"],
             one["kind"] + (f": {one['switch_or_reason']}" if one["kind"] == "reading" else "")] for one in report["ledger"]["errata"]])
    yield ("The misprints, and what each would do", ["erratum", "what is computed", "first form", "second form", "against"],
           [[one["erratum"], one["computed"], sig(one["as_printed"], 4), sig(one["as_corrected"], 4), one["against"] or DASH]
            for one in report["ledger"]["errata"] if one["computed"]])


def quantity(value, unit, digits):
    if value is None:
        return DASH
    scale, usual = {"Pa": (1e-9, " GPa"), "m": (1e9, " nm"), "": (1, "")}.get(unit, (1, f" {unit}"))
    return sig(scale * value, digits) + usual


def bounds(one):
    least, greatest, unit = one["least"], one["greatest"], one["unit"]
    if least is not None and greatest is not None:
        return f"{quantity(least, unit, 3)} to {quantity(greatest, unit, 3)}"
    return f"at most {quantity(greatest, unit, 2)}" if least is None else f"at least {quantity(least, unit, 2)}"


def beside_limit(one, value):
    keeps = value is not None and (one["least"] is None or value >= one["least"]) and (one["greatest"] is None or value <= one["greatest"])
    return f"({quantity(value, one['unit'], 3)})" if keeps else quantity(value, one["unit"], 3)


def limits_passed(title, names, heads, limits):
    return (title, ["the model assumes", "limit", *heads, "the limit is from"],
            [[one["assumption"], bounds(one), *(beside_limit(one, one["values"].get(name)) for name in names), one["source"]] for one in limits])


def model(report):
    yield "The model's equations", ["what", "equation", "source"], None  # not from report.json
    errata = {one["erratum"]: one["printed"] for one in report["ledger"]["errata"]}

    def value(one, name):
        found = one["values"].get(name, DASH)
        return found if isinstance(found, str) else whole(found)

    yield limits_passed("Outside of the model: limits that these scenes go beyond", SURFACES, SURFACES, report["paper"]["limits_passed"])
    yield ("The inputs of the scenes", ["input", "meaning", "unit", *SURFACES, "differs from the print"],
           [[one["field"], one["meaning"], one["unit"] or DASH, *(value(one, name) for name in SURFACES),
             f"{one['erratum']}, printed: {errata[one['erratum']]}" if one["erratum"] else ""] for one in report["paper"]["inputs"]])


def contacts(report):
    scenes = list(report["contacts"]["scenes"].values())
    told = whole(report["contacts"]["told_speed"])
    fields = [("modulus E, GPa", 4, 1e-9, "effective_modulus"), ("radius Rx along the entrainment, mm", 4, 1e3, "radius_x"),
              ("radius Ry across it, mm", 4, 1e3, "radius_y"), ("length L, mm", 3, 1e3, "length"),
              ("semi-axis ax, or half-width b of a line, µm", 4, 1e6, "semi_axis_x"), ("semi-axis ay, µm", 4, 1e6, "semi_axis_y"),
              ("ellipticity k = ay/ax", 3, 1, "ellipticity"), ("mean pressure, GPa", 3, 1e-9, "mean_pressure"),
              ("peak pressure, GPa", 3, 1e-9, "peak_pressure"), ("approach of the bodies, µm", 3, 1e6, "approach"),
              ("standard deviation of summit heights σs, nm", 3, 1e9, "summit_height_sd"),
              ("slide-roll ratio S", None, 1, "slide_roll_ratio"), ("film law", None, 1, "film_law"),
              ("viscosity η0, mPa·s", 3, 1e3, "viscosity"), ("pressure–viscosity coefficient α, 1/GPa", 3, 1e9, "pressure_viscosity"),
              ("boundary friction coefficient μb", 3, 1, "boundary_coefficient"), ("density of summits n, 1/µm²", 3, 1e-12, "summit_density"),
              ("radius of summits β, µm", 3, 1e6, "summit_radius"), ("offset of the summits' plane δ, over σs", 3, 1, "plane_offset"),
              (f"film h at {told} m/s, nm", 3, 1e9, "at_told_speed", "film"),
              (f"λ = h/σs at {told} m/s", 3, 1, "at_told_speed", "film_parameter"),
              ("speed of the least friction, m/s", 3, 1, "least_friction", "speed"),
              ("friction coefficient μ there", 3, 1, "least_friction", "friction"), ("λ there", 3, 1, "least_friction", "film_parameter"),
              ("heating of the oil in the inlet there, K (the model: at most 10)", 3, 1, "heating_at_least_friction", "inlet_heating"),
              ("heating of the oil in the film there, K (the model: at most 10)", 3, 1, "heating_at_least_friction", "film_heating")]

    def cell(value, digits, factor, keys):
        for key in keys:
            value = value and value[key]
        if isinstance(value, str) or value is None:
            return value or DASH
        return whole(value) if digits is None else sig(factor * value, digits)
    titles = ["ball on a flat", "bearing's outer ring", "gear's flank"]
    yield limits_passed("Outside of the model: limits that the machines' scenes go beyond", report["contacts"]["scenes"], titles,
                        report["contacts"]["limits_passed"])
    yield ("Hertz' contact of each scene", ["", *titles],
           [[what, *(cell(one, digits, factor, keys) for one in scenes)] for what, digits, factor, *keys in
            [("shape", None, 1, "shape"), ("load F, N", None, 1, "load"), *fields]])


def signed(part):
    return f"{'+' if part > 0 else ''}{sig(100 * part, 2)} %"


def film_solved(report):
    def at(place):
        return f"M = {whole(place['load_number'])}, L = {whole(place['material_number'])}"
    words = {"central": "central, x = 0", "minimum": "minimum", "at_greatest_pressure": "where the pressure is greatest"}
    liquids = {"unknown": "unknown", "barus, incompressible": "Barus", "roelands, compressible": "Roelands"}
    yield ("Errors of the formulas over the table of solved films",
           ["formula", "its film", "liquid of its fit", "lowest error", "median", "highest error", "in its regime"],
           [[one["name"], words[one["quantity"]], liquids[one["liquid"]], f"{signed(one['least']['error'])} at {at(one['least'])}",
             signed(one["median"]), f"{signed(one['greatest']['error'])} at {at(one['greatest'])}",
             f"{signed(one['elastic_viscous']['least']['error'])} to {signed(one['elastic_viscous']['greatest']['error'])}"] for one in report["line_films"]["formulas"]])


def film_points(report):
    found = report["point_films"]

    def span(of, name):
        least, greatest = (whole(of[f"{end}_{name}"]) for end in ("least", "greatest"))
        return least if least == greatest else f"{least} to {greatest}"

    def block(of, contacts):
        if of["within"] is None:
            return "none"
        return f"M = {span(of['within'], 'load')}, L = {span(of['within'], 'material')}; {of['contacts_within']} of {contacts}"
    yield ("Errors of the formulas over the solved circles",
           ["formula", "liquid", "median error", "greatest error", f"within {percent(found['within'], 2)}"],
           [[one["name"], {"barus, incompressible": "Barus", "roelands, compressible": "Roelands"}[of["liquid"]], signed(of["median"]),
             f"{signed(of['worst']['error'])} at M = {whole(of['worst']['load_number'])}, L = {whole(of['worst']['material_number'])}",
             block(of, liquid["contacts"])] for one in found["formulas"] for of, liquid in zip(one["liquids"], found["liquids"], strict=True)])
    shapes = [{of["name"]: of for of in shape["formulas"]} for shape in found["ellipses"]]
    yield ("Errors of the formulas over the solved ellipses",
           ["formula", *(f"Ry/Rx = {whole(shape['radius_ratio'])}" for shape in found["ellipses"])],
           [[one["name"], *(f"{signed(of[one['name']]['least']).removesuffix(' %')} to {signed(of[one['name']]['greatest'])}" for of in shapes)]
            for one in found["formulas"]])


def film_starved(report):
    closures = ("flooded_inlet", "starved_inlet", "printed_exponents", "damiens")

    def span(of, digits):
        return f"{sig(of['least'], digits)} to {sig(of['greatest'], digits)}"
    reported = {row["surface"]: row["reported"] for row in report["paper"]["comparisons"]["onset_speed"]["rows"]
                if (row["model"], row["criterion"]) == ("GT", "film_maximum")}
    surfaces = report["starved_films"]["surfaces"]

    def row(words, cell_of):
        return [words, *map(cell_of, surfaces)]

    def departure(name):
        return lambda one: f"< {sig(one['slowest'], 3)}" if one["closures"][name]["departs_before"] else sig(one["closures"][name]["film_departure"], 3)
    yield ("The paper's surfaces: speeds of each criterion, in m/s", ["", *(one["surface"] for one in surfaces)], [
        row("layer of oil hoil, nm", lambda one: sig(1e9 * one["layer"], 3)),
        row("onset as the paper reports it", lambda one: whole(reported[one["surface"]])),
        row("solved: film 5 % below the flooded one", lambda one: sig(one["film_departure"]["speed"], 3)),
        row("within the films' errors", lambda one: f"{sig(one['film_departure']['low'], 3)} to {sig(one['film_departure']['high'], 3)}"),
        *(row(f"the same by {name}", departure(name)) for name in closures),
        row("solved: greatest film", lambda one: "none" if one["film_maximum"] is None else sig(one["film_maximum"], 3)),
        row("steps of speed in which the film rises by more than its errors", lambda one: f"{one['rises']} of {one['speeds'] - 1}"),
        row("greatest film by flooded_inlet", lambda one: sig(one["closures"]["flooded_inlet"]["film_maximum"], 3)),
        row("no film by flooded_inlet from", lambda one: sig(one["closures"]["flooded_inlet"]["collapse"], 3)),
        row("solved: least friction", lambda one: sig(one["friction_minimum"], 3))])
    yield ("Deviations of the closures from the solved ratio of films", ["ρ", "ℛ, solved", "its error, up to", "γ of Damiens", *closures],
           [[whole(one["supply"]), span(one["ratio"], 4), sig(one["error"], 1), f"{span(one['exponent'], 2)}, ± {sig(one['exponent']['error'], 1)}",
             *(f"{signed(one['closures'][name]['least'])[:-2]} to {signed(one['closures'][name]['greatest'])}" for name in closures)]
            for one in report["starved_films"]["supplies"]])


def verification(report):
    before = report["certified"]["before"].get("worst_ulp_per_condition", {})
    yield ("The model in double against the certified tables of reference/exact",
           ["quantity", "cases", "worst error, ulp", "worst error/condition, ulp", "of an earlier version, ulp", "allowed, ulp", "of the bound",
            "worst row", "verdict"],
           [[one["quantity"], many(one["cases"]), sig(one["worst_ulp"], 3), sig(one["worst_ulp_per_condition"], 3),
             sig(before.get(one["quantity"]), 3), whole(one["allowed_ulp"]) +
             (f" or {whole(one['allowed_ulp_per_condition'])} × condition" if one["allowed_ulp_per_condition"] else ""),
             percent(one["worst_part_of_bound"]), one["worst_row"], "held" if one["held"] else "FAILED"]
            for one in report["certified"]["quantities"]])


def worst_inputs(report):
    def ulp(value):
        return "∞" if value is None else sig(value, 3)

    def given(value):
        return str(int(value)) if value == int(value) and abs(value) < 1e6 else sig(value, 5)
    outputs = report["stress"]["outputs"]
    yield ("Random points through the whole model, double against long double",
           ["output", "cases", "worst error, ulp", "worst error/condition, ulp", "of the bound", "points in balls", "in balls, ulp", "beyond", "verdict"],
           [[one["output"], many(one["cases"]), ulp(one["worst_ulp"]), ulp(one["worst_ulp_per_condition"]), percent(one["worst_part_of_bound"]),
             str(one["cases_in_balls"]), ulp(one["worst_ulp_per_condition_in_balls"]), many(one["beyond_contract"]), "held" if one["held"] else "BROKEN"]
            for one in outputs])
    yield ("The worst input of each output", ["output", "worst error/condition, ulp", "point", "its inputs"],
           [[one["output"], ulp(one["worst_ulp_per_condition"]), str(one["worst_point"]["index"]),
             ", ".join(f"{name} {given(value)}" for name, value in one["worst_point"]["inputs"].items())]
            for one in outputs if one["worst_point"] is not None])


def mutants(report):
    found = report["mutants"]
    yield ("Random changes in each part of the project",
           ["part", "drawn", "caught", "hung", "survived", "not reached", "change nothing", "wait", "score", "95 % interval",
            "score, if those that change nothing survive", "goal"],
           [[one["room"], *(str(one[name]) for name in ("drawn", "caught", "hung", "survived", "not_reached", "equivalent")),
             str(one["drawn"] - one["ran"]), DASH if one["score"] is None else percent(one["score"]),
             DASH if one["score"] is None else f"{percent(one['low'])} to {percent(one['high'])}",
             DASH if one["with_equivalents"] is None else percent(one["with_equivalents"]), percent(one["goal"])] for one in found["rooms"]])
    yield ("Random changes that no test noticed",
           ["part", "place", "kind of change", "text", "in its place", "verdict", "reason, or check since"],
           [[*(one[name] for name in ("room", "place", "operator", "original", "replacement", "verdict")), one["since"] or one["reason"]]
            for one in found["unnoticed"]])


def planted_faults(report):
    yield ("Faults planted in the tree, and the check that caught each", ["id", "fault", "verdict", "check", "in"],
           [[one["id"], one["fault"], "caught" if one["caught"] else f"SURVIVED: {one['said']}", one["check"], one["file"]]
            for one in sorted(report["planted_faults"]["faults"], key=lambda one: one["caught"])])


def diagnosis(report):
    yield ("Wrong solvers, and the first that is said of each", ["mistakes", "of", "all named", "said"],
           [[", ".join(one["fakes"]), one["function"], "yes" if one["named"] else "NO", one["said"]]
            for one in sorted(report["diagnosis"]["wrong_solvers"], key=lambda one: one["named"])])


def work_precision(report):
    names = {"moment_5_2": "moments F5/2", "moment_2": "moments F2", "root_wide": "film parameter, all inputs wide",
             "root_one_surface": "film parameter, one surface", "curve_200": "a Stribeck curve", "hertz_ellipse": "Hertz' ellipse",
             "points_1e6": "many operating points of a scene"}
    yield ("The fastest way of each family that fails nowhere, and its true error",
           ["job", "family", "way", "time a point, ns", "times ours", "worst error, ulp", "evaluations"],
           [[names.get(job["job"], job["job"]), way["family"], way["name"], sig(way["ns"], 3), sig(way["times_ours"], 3),
             sig(way["max_ulp"], 3), sig(way["evaluations"], 3)] for job in report["work_precision"]["jobs"] for way in job["ways"]])
    fits = report["ellipse_fits"]
    errors = ("ellipticity", "semi_axis_x", "peak_pressure", "approach")
    yield ("The greatest errors of the fits",
           ["fit", "by", f"k, α to {whole(fits['moderate_ratio'])}", "ax", "p0", "approach", f"k, α to {whole(fits['greatest_ratio'])}", "ax", "p0", "approach"],
           [[one["name"], one["authors"] or DASH, *(percent(one[to][error], 2) for to in ("moderate", "greatest") for error in errors)] for one in fits["fits"]])


def skipped_work(report):
    yield ("Work skipped, by what is asked",
           ["scene", "asked", "root steps", "roots skipped: λ = λ0", "roots skipped: λ = λb", "load shares skipped", "starvation skipped",
            "evaluations saved"],
           [[one["scene"], ", ".join(one["asked"]) or "all outputs", *(many(one[key]) for key in (
               "root_steps", "roots_that_are_film", "roots_that_are_floor", "shares_skipped", "starvation_skipped")),
             percent(one["saved"], 2)] for one in report["skipped_work"]["rows"]])


def gates(report):
    found = report["gates"]
    yield ("What the gates found of a program with the same work, and of one with more",
           ["program", "gate", "workloads", "greatest ratio", "red findings", "has to be", "is", "verdict"],
           [[one.get("planted", {"id": "unchanged"})["id"], one["gate"], str(one["workloads"]), sig(one["greatest_ratio"], 4), str(one["red"]),
             one["expected"], one["verdict"], "proved" if one["proved"] else "NOT PROVED"] for one in found["proofs"]])
    yield ("The baseline that the gates compare with", ["workload", "instructions", "least time", "median time", "band"],
           [[one["workload"], DASH if one["instructions"] is None else many(one["instructions"]), sig(one["least_time"], 4),
             sig(one["median_time"], 4), percent(one["band"], 2)] for one in found["baseline"]["workloads"]])


def sweep_speed(report):
    found = report["sweep_speed"]
    keys = ("alone_ns", "summaries_ns", "summaries_times_alone", "points_ns", "points_times_alone", "drawing_ns")
    yield ("Time of a point of a sweep, beside that of its scene and root alone",
           ["sweep", "alone, ns", "summaries, ns", "summaries, times alone", "points, ns", "points, times alone", "drawing, ns"],
           [[one["sweep"], *(sig(one[key], 3) for key in keys)] for one in found["ratios"]])


def environment(report):
    found = report["environment"]
    yield ("This page", ["what", "value"],
           [["tribocheck", found["version"]], ["commit", found["commit"] or "not told"],
            *([name, found[name.replace(" ", "_")]] for name in ("compiler", "processor", "instruction set", "kernel", "date"))])
    yield ("What slow checks left in reference/baselines", ["file", "what", "made by", "commit", "date", "age, days",
                                                                "the code that it measures", "its commits since", "machine"],
           [[one["file"], one["what"], f"make {one['target']}", commit(one["commit"]), one["date"], str(one["age_in_days"]),
             ", ".join(one["measures"]), {None: "not known", 0: "none"}.get(one["commits_since"], f"{one['commits_since']}: older than its code"),
             f"{one['processor']}; {one['compiler']}"] if "missing" not in one else
            [one["file"], one["what"], f"make {one['target']}", *[DASH] * 5, f"not here: {one['missing']}"] for one in found["baselines"]])


def not_run(report):
    if report["not_run"]:
        yield ("Missing from this page", ["what", "why", "how to have it"],
               [[one["what"], one["why"], one["how_to"]] for one in report["not_run"]])


SECTIONS = (first, comparison, claims, readings, requirements, uncertainty, misprints, model, contacts, film_solved, film_points, film_starved, verification,
            worst_inputs, mutants, planted_faults, diagnosis, work_precision, skipped_work, gates, sweep_speed, environment, not_run)


def promised(report):
    """Caption, headings and rows of each table, in the order of the page."""
    for section in SECTIONS:
        for caption, head, rows in section(report):
            yield plain(caption), [plain(one) for one in head], rows and [[plain(one) for one in row] for row in rows]
