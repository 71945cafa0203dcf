# SPDX-License-Identifier: Apache-2.0
"""The sentences that the prose of the report's page must have, made from report.json; page_tables.py does this for its tables.

A pair ("not", words) has words that the page must not have.
"""
from page_tables import CHOICES, SURFACES, against, below, commit, computed, ends, many, percent, sig, signed, whole


def of_surfaces(texts):
    return ", ".join(f"{text} ({name})" for text, name in zip(texts, SURFACES))


def measured(one):
    return f"Measured on {one['date']} at commit {commit(one['commit'])}"


def provenance(one):
    took = f", in {one['seconds']:.0f} s" if "seconds" in one else ""
    return f"{measured(one)}{took}; {one['environment']['cpu']}; {one['environment']['compiler']}."


def paper(report):
    scenes, flow, ledger = report["paper"]["scenes"], report["paper"]["two_slopes"], report["ledger"]
    own, smooth, gw = [scenes[name] for name in SURFACES], scenes["smooth"], scenes["smooth_gw"]
    items = {one["item"]: one for one in ledger["items"]}

    def number(id):
        return computed(items[id], items[id]["readings"]["corrected"])

    def judged(id):
        got = items[id]["readings"]["corrected"]
        return (f"({id}: {got['verdict']}" + (f", {against(items[id], got)}" if items[id]["is_over_speeds"] else "") +
                ("" if got["decided"] else ", the margin is below the numerical error") +
                (", resting on points beyond the film's collapse" if "beyond_collapse" in got else "") + ")")

    def told(key, digits, mark):
        return of_surfaces(sig(one[mark][key], digits) if one[mark] and one[mark][key] is not None else "undefined" for one in own)
    reported = {id: whole(one["reported"]) for id, one in items.items()}
    slow, fast = whole(smooth["slowest"]["speed"]), whole(smooth["fastest"]["speed"])
    slopes = flow["curves"]
    yield f"the slope is {number('C16.flooded')} {judged('C16.flooded')}; at {slow} m/s it is {sig(slopes['flooded']['first_slope'], 3)}, because"
    yield (f"no u−1 range {judged('C16.starved')}: its slope falls from {sig(slopes['paper']['first_slope'], 3)} through 0 at "
           f"{sig(smooth['onset']['speed'], 4)} m/s to −∞ at {sig(smooth['collapse']['speed'], 4)} m/s, where")
    yield (f"with q = {sig(flow['inlet_flow'], 3)} m²/s, so that hoil meets the flooded film at {sig(flow['knee'], 3)} m/s, the middle of the axis, the slope at {fast} m/s is "
           f"{sig(slopes['starved_inlet']['last_slope'], 3)} for starvedinlet and {sig(slopes['damiens']['last_slope'], 3)} for damiens.")
    yield f"At {slow} m/s the area ratios with GT are {told('real_area_ratio', 3, 'slowest')} {judged('C8')}."
    yield f"the rough surface has {number('C9')} times the area of the smooth one {judged('C9')}."
    yield f"GW gives {number('C7')} times the area of GT {judged('C7')}, and its area falls at {number('C10')} times the speed"
    yield f"the paper sees no difference {judged('C10')}."
    yield f"At {slow} m/s {told('summit_count', 4, 'slowest')} summits are in contact with GT."
    yield f"{number('C12')} times the summits of the next rougher one {judged('C12')}."
    yield f"GT has {number('C11.boundary')} times the summits of GW at that speed, where the paper has fewer with GW {judged('C11.boundary')};"
    yield f"GW has {number('C11.mixed')} times those of GT, and the paper has more with GW {judged('C11.mixed')}."
    yield (f"the asperities carry {told('asperity_load_share', 4, 'slowest')}; the paper reports {reported['C4.rough']} on the rough surface "
           f"{judged('C4.rough')} and {reported['C4.smooth']} on the smooth one {judged('C4.smooth')}.")
    yield ("carry half each at " + of_surfaces(sig(one["equal_share_speed"], 3) + " m/s" for one in own) +
           f": later on a rougher surface {judged('C5')}.")
    yield (f"carry least at the onset, {told('asperity_load_share', 3, 'onset')}, and more again at {fast} m/s, "
           f"{told('asperity_load_share', 3, 'fastest')} (undefined where the film has collapsed) {judged('C6')}.")
    yield "A(0), is " + of_surfaces(sig(one["contact_share"], 3) for one in own) + "."
    yield "at the onset (●): " + of_surfaces(f"{sig(1e9 * one['onset']['film'], 3)} nm at {sig(one['onset']['speed'], 4)} m/s" for one in own) + "."
    yield (f"{reported['C1.rough']}, {reported['C1.medium']} and {reported['C1.smooth']} m/s (C1: "
           f"{next(one for one in ledger['claims'] if one['claim'] == 'C1')['verdicts']['corrected']}).")
    yield f"the rough one last {judged('C3')}. The film collapses (○, hff ≥ hoil) " + of_surfaces(
        f"at {sig(one['collapse']['speed'], 4)} m/s" if one["collapse"] else f"at no speed up to {whole(one['fastest']['speed'])} m/s" for one in own) + "."
    yield f"with GW is {number('C13')} times that with GT; the paper sees no significant difference, which is taken as 10 % {judged('C13')}."
    yield (f"lies at {number('C15')} times the speed of GT {judged('C15')}. The film collapses at {sig(smooth['collapse']['speed'], 5)} m/s with GT "
           f"and at {sig(gw['collapse']['speed'], 5)} m/s with GW;")
    yield (f"Friction at {slow} m/s is {told('friction', 3, 'slowest')}, and at its least " +
           of_surfaces(sig(one["least_friction"], 3) for one in own) + ".")
    yield f"GT gives {number('C14')} times the friction of GW, where the paper has more with GT {judged('C14')}."
    yield f"λ at the onset (●) is {number('C2.smooth')}; the paper reports {reported['C2.smooth']} on all three surfaces (dashed line) {judged('C2.smooth')}."
    bound = next(one for one in report["paper"]["inputs"] if one["field"] == "friction.boundary_coefficient")["values"]["smooth"]
    yield f"At low speed friction stays below μb = {whole(bound)}, because the summits carry no more than A(0)"
    yield f"falls {percent(report['paper']['departure'], 1)} below the flooded film."
    for found in report["paper"]["comparisons"].values():
        models = "GT or GW" if found["rows"][0]["criterion"] else "GT"
        said = ends(found["factors"], 3) if found["factors"] else ""
        yield (": the paper gives no number." if found["counted"] == 0 else
               f": {found['agreeing']} of {found['counted']} values (a surface with {models}) round to what the paper prints; " +
               (f"computed over printed: {said}." if " to " in said else f"each is {said} times that."))
    for one in report["paper"]["comparisons"]["onset_speed"]["rows"]:
        if "none" in one:
            yield f"{one['surface']}, {one['model']}, {one['criterion']}: no onset: {one['none']}."


def of_ledger(report):
    ledger = report["ledger"]
    ranking, counted = ledger["ranking"], len(ledger["claims"])
    items = {one["item"]: one for one in ledger["items"]}
    factors = [items["C1." + name]["readings"]["corrected"]["factor"] for name in SURFACES]
    best = next(one for one in ledger["readings"] if one["name"] == "best 1")
    film = [one for one in ("speed=sum", "speed_modulus=E*") if one in best["departures"].split(" ")]
    met_by = ledger["claims"][0]["met_by"]
    one, two, equal = ([one["surfaces"][name]["slow_asperity_share"] for name in SURFACES] for one in report["paper"]["offsets"])
    shares = [f"{sig(a, 3)}, {sig(b, 3)} and {sig(c, 3)}" for a, b, c in (one, two, equal)]
    offset = next(one for one in report["paper"]["inputs"] if one["field"] == "surface.summit_plane_offset")["values"]["rough"]
    scores = [next(one for one in ledger["readings"] if one["name"] == name)["score"] for name in ("corrected", "m = 2", "equal faces")]
    yield (f"At the lowest speed the summits carry {shares[0]} of the load (rough, medium and smooth surface) with m = 1, {shares[1]} with m = 2, and "
           f"{shares[2]} with two equal faces, of which Dd/σs = {whole(offset)} belongs to one and σs to their sum (offset "
           f"{sig(report['paper']['offsets'][2]['offset'], 4)} σs).")
    own = [report["paper"]["scenes"][name] for name in SURFACES]
    yield (f"With GT and Table 1 the summits carry at most {sig(max(one['contact_share'] for one in own), 2)} of the load even where the faces touch "
           f"(λ = 0): with m = 1 no surface is ever in boundary lubrication, and “reproduced” is true of the lowest speed only. The film there is {sig(1e9 * own[2]['slowest']['film'], 2)} nm on "
           f"the smooth surface")
    yield f"Without a film the smooth surface has A = {sig(own[2]['contact_share'], 2)} and A² = {sig(own[2]['contact_share'] ** 2, 2)}."
    gap = ledger["circular_gap"]
    speeds = [sig(gap["onset_speed"][name], 3) for name in SURFACES]
    yield (f"λ at the onset is {sig(gap['film_parameter'], 4)} ({gap['verdict']}), the onsets are {speeds[0]}, {speeds[1]} and {speeds[2]} m/s (rough, medium and "
           f"smooth surface), and {gap['score']} of {counted} claims are reproduced. The printed gap is a choice, made in knowledge of its effect: with it λ is "
           f"{sig(items['C2.smooth']['readings']['corrected']['computed'], 4)} ({items['C2.smooth']['readings']['corrected']['verdict']}; more on E13: The paper's misprints).")
    inlet = ledger["arguments"][1]
    agree = [f"{one['name']} ({sig(one['low'], 3)} to {sig(one['high'], 3)})" for one in inlet["candidates"] if one["agrees"]]
    yield f"and {inlet['agreeing']} of the candidates agree with {inlet['reported']} within that, {', '.join(agree)}"
    notes = {"C2": "rests on the printed gap (E13) and on hoil/σs = 4, of one digit.", "C6": "rests on points beyond the film's collapse, and on a threshold",
             "C8": "speaks of boundary lubrication, which no surface reaches"}
    for claim in ledger["claims"]:
        if claim["claim"] in notes:
            said = f"{claim['claim']} {notes[claim['claim']]}"
            yield said if claim["verdicts"]["corrected"] == "reproduced" else ("not", said)

    def varied(key, name, which):
        one = ledger["uncertainty"][which][key]
        one = one[name] if name else one
        at = next(item["reported"] for item in ledger["items"] if item["quantity"] == key and item["surface"] == (name or "smooth"))
        return f"{ends([one['low'], one['high']], 3)} ({name + ': ' if name else ''}{whole(at)} lies {'within' if one['low'] <= at <= one['high'] else 'outside'})"
    yield f"what is plausible, 95 % lie at {', '.join(varied('onset_speed', name, 1) for name in SURFACES)} m/s."
    yield f"within that λ lies at {varied('onset_film_parameter', None, 0)} in 95 %."
    yield f"with the assumed β (E17) taken as printed to one digit, 95 % lie at {', '.join(varied('slow_asperity_share', name, 0) for name in ('rough', 'smooth'))}."
    yield (f"C2 is then {gap['verdict']} (λ = {sig(gap['film_parameter'], 4)} on all three surfaces), C1 stays {gap['onset_verdict']} (factors "
           f"{ends(gap['onset_factors'], 3)}), and {gap['score']} claims are reproduced.")
    yield "mended in it too: " + ", ".join(one["erratum"] for one in ledger["errata"] if one["kind"] == "mended") + "."
    shared = set.intersection(*(set(one["in_common"].split(" ")) for one in ranking["best"]))
    yield "They share " + " and ".join(CHOICES[one] for one in ranking["best"][0]["in_common"].split(" ") if one in shared) + ". “Best 1” is"
    took = [CHOICES[one] for one in film + [one for one in best["departures"].split(" ") if one not in film]]
    yield f"one example, which takes {', '.join(took[:-1])} and {took[-1]}. The sum of the speeds"
    yield (f"{many(ranking['best_ties'])} of {many(ranking['readings'])} readings tie at {ranking['best_score']} of {counted} claims; no reading reproduces more. They share")
    yield "each doubles U. “Best 1” is a fit, not a proof."
    at = [f"{sig(items['C1.' + name]['readings']['best 1']['computed'], 3)} (paper: {whole(items['C1.' + name]['reported'])})" for name in SURFACES[::-1]]
    yield f"With best 1 starvation sets in at {at[0]}, {at[1]} and {at[2]} m/s."
    yield (f"Results: the paper {min(scores)} to {max(scores)} of the paper's {counted} claims are reproduced, depending on E9: {scores[0]} with m = 1, {scores[1]} "
           f"with m = 2, {scores[2]} with two equal faces. With m = 1: {ledger['summary']}. A number is")
    by = {word: ", ".join(one["claim"] for one in ledger["claims"] if (one["verdicts"]["corrected"] in word) or
                          word == "partly" and one["verdicts"]["corrected"] not in ("reproduced", "not reproduced"))
          for word in (("reproduced",), "partly", ("not reproduced",))}
    yield "The paper's claims: reproduced: {}; partly: {}; not: {}. ".format(*(one or "none of them" for one in by.values())) + (
        f"{percent(met_by)} of all combinations of interpretations give all three speeds." if met_by else
        "No combination of interpretations gives all three speeds.")
    yield f"how many of the {many(ranking['readings'])} reproduce the claim."
    yield f"lies at {ends(factors, 3)} times the speeds that the paper reports"
    yield f"of {many(ledger['uncertainty'][0]['draws'])} draws {ledger['uncertainty'][0]['all_onsets_as_reported']} have all three speeds as reported."
    shares = [f"{sig(one['readings']['corrected']['factor'], 3)} on the {one['surface']} surface" for one in ledger["items"] if one["claim"] == "C4"]
    yield f"computed/reported is {' and '.join(shares)}."
    for item in ledger["items"]:
        for reading in ledger["readings"]:
            if "beyond_collapse" in item["readings"][reading["name"]]:
                yield (f"{item['item']} rests on points beyond the film's collapse "
                       f"({', '.join(item['readings'][reading['name']]['beyond_collapse'])}): there")
    yield (f"the best of {many(ranking['readings'])} combinations reproduce {ranking['best_score']} claims; the mean of all is "
           f"{sig(ranking['mean_score'], 3)}.")
    alone = [f"{one['reported']} ({next(way['name'] for way in one['candidates'] if way['agrees'])})" for one in ledger["arguments"]
             if one["agreeing"] == 1 and any(way["agrees"] for way in one["candidates"])]
    yield f"Each of these printed numbers follows from only one of the candidates tried: {'; '.join(alone)}." if alone else "claims; the mean of all is"
    yield f"reproduces {sig(ranking['mean_score'], 3)} claims (standard deviation {sig(ranking['score_standard_deviation'], 2)})."
    yield f"{many(ranking['above_corrected'])} readings reproduce more than the corrected one, and {many(ranking['equal_to_corrected'] - 1)} others as many"
    for one in ledger["arguments"]:
        words = {0: "No candidate agrees.", 1: "One agrees."}.get(one["agreeing"], f"{one['agreeing']} agree.")
        yield f"Reported: {one['reported']}, by print precision {ends([one['low'], one['high']], 5)}. {words}"
    for item in ledger["items"]:
        got, wanted = item["readings"]["corrected"], [one for one in ledger["requirements"] if one["item"] == item["item"]]
        if got["verdict"] == "reproduced":
            continue
        found, without = [[one for one in wanted if (one["factor"] is None) == absent] for absent in (False, True)]
        yield (f"Computed: {computed(item, got)}; the paper has: " if found else
               f"{item['item']}: {item['statement']}. No change of a single input makes it hold. Computed: {computed(item, got)}; the paper has:")
        if found and without:
            yield (f"Values are those of the {found[0]['surface']} surface. No factor from 1/30 to 30 on "
                   f"{', '.join(one['input'] for one in without)} makes it hold.")
    speeds = [[items["C1." + name]["readings"]["corrected"]["computed"], items["C1." + name]["reported"]] for name in SURFACES]
    yield f"The best common ε is {sig(ledger['common_departure']['common'], 4)}: it makes"
    (a, b), (c, d), (e, f) = speeds
    yield f"by {sig(c / e, 3)} from smooth to medium and by {sig(a / c, 3)} from medium to rough"
    yield f"The reported ones rise by {sig(d / f, 3)} and by {sig(b / d, 3)}, the one less"
    held = sum(one["reproduced"] for one in ledger["independent"])
    yield f"Independent numbers: {held} of {len(ledger['independent'])} film and Hertz values"
    yield " ".join(f"{words}: {many(one['draws'])} draws, of which {one['all_onsets_as_reported']} have all three onset speeds as reported."
                   for words, one in zip(("Print precision", "Plausible ranges"), ledger["uncertainty"]))


def drawn(report):
    drawn, agreement = report["onset_uncertainty"], report["onset_uncertainty"]["agreement"]
    scenes, greatest = drawn["sweep"]["scenes"], []
    for scene in scenes:
        column = next(one for one in scene["columns"] if one["name"] == agreement["column"])["values"][0]
        totals = {name: one["total"]["value"] for name, one in column["sensitivity"]["variables"].items()}
        most = max(totals, key=totals.get)
        greatest.append(f"{most} on the {scene['id']} surface ({percent(totals[most], 2)})")
        for one in scene["columns"]:
            groups = one["values"][0]["sensitivity"]["groups"]
            if groups >= scene["draws"]:
                yield "not", f"{one['name']}, {scene['id']}: over the"
            else:
                yield f"{one['name']}, {scene['id']}: over the {many(groups)} of {many(scene['draws'])} groups of cases that all have an onset."
    yield f"Most of the variance comes from {', '.join(greatest)}."
    yield (f"differ by at most {percent(agreement['farthest'], 2)} from those of the ledger's {many(agreement['ledger_draws'])} draws by another "
           f"generator. That is {sig(agreement['in_deviations'], 2)} standard deviations of sampling; up to {sig(agreement['most_deviations'], 2)} are allowed.")
    yield f"Onset speeds drawn twice: two generators {'agree' if agreement['agree'] else 'do not agree'}."
    lies = [(one["surface"], one["reported"], one["speeds"][0], next(column for column in scene["columns"] if column["name"] == one["speeds"][0]["column"]))
            for one, scene in zip(drawn["surfaces"], scenes)]
    yield "so many lie below the paper's speed: " + ", ".join(f"{name} {whole(at['value'])} m/s: {below(one, column['values'][0])}"
                                                             for name, at, one, column in lies) + "."
    yield f"Here each of the {drawn['inputs_drawn']} inputs is drawn ({', '.join(one['path'] for one in scenes[0]['inputs'])}; the last one"
    yield f"the onsets of {many(scenes[0]['cases'])} cases of each surface"


def of_point_films(report):
    found = report["point_films"]

    def best(quantity, i):
        return min((one for one in found["formulas"] if one["quantity"] == quantity), key=lambda one: one["liquids"][i]["median_size"])

    def within(quantity, i):
        return f"{best(quantity, i)['liquids'][i]['contacts_within']} of {found['liquids'][i]['contacts']}"
    part, worst = percent(found["within"], 2), 100 * best("minimum", 0)["liquids"][0]["worst"]["error"]
    yield (f"For the central film {best('central', 0)['name']} is the closest with Barus' incompressible liquid (within {part} at {within('central', 0)} contacts), "
           f"and {best('central', 1)['name']} with Roelands' compressible one ({within('central', 1)}). The closest formulas of the least film are within this at "
           f"{within('minimum', 0)} and {within('minimum', 1)}, and off by up to {'+' if worst > 0 else ''}{sig(worst, 2)} %.")
    yield f"U is that of steel with α = {whole(1e9 * found['pressure_viscosity'])}/GPa and E* = {whole(1e-9 * found['effective_modulus'])} GPa."
    barus, oil = (one["greatest_error"] for one in found["liquids"])
    yield (f"may be off by {percent(barus['central'], 1)} (Barus) and {percent(oil['central'], 1)} (Roelands), the least films by "
           f"{percent(barus['minimum'], 2)} and {percent(oil['minimum'], 1)} at most")


def of_starved_films(report):
    surfaces, supplies = report["starved_films"]["surfaces"], report["starved_films"]["supplies"]
    reported = {row["surface"]: row["reported"] for row in report["paper"]["comparisons"]["onset_speed"]["rows"]
                if (row["model"], row["criterion"]) == ("GT", "film_maximum")}
    if all(one["film_maximum"] is None for one in surfaces):
        yield f"has no maximum and does not collapse up to {whole(surfaces[0]['fastest'])} m/s."
    yield ("It is 5 % thinner than the flooded film from " + ", ".join(f"{sig(one['film_departure']['speed'], 3)} ({one['surface']})" for one in surfaces) +
           " m/s on; the paper reports the onset of starvation at " + ", ".join(whole(reported[one["surface"]]) for one in surfaces) + " m/s.")
    yield (f"At {whole(surfaces[0]['fastest'])} m/s it is {percent(surfaces[0]['greatest_of_layer'], 2)} of the layer on the smooth surface, and "
           f"{percent(surfaces[-1]['greatest_of_layer'], 2)} on the rough one")
    exponents = [one["exponent"][end] for one in supplies for end in ("least", "greatest")]
    yield f"single exponent of Damiens' closure is right for all layers: it takes {sig(min(exponents), 2)} to {sig(max(exponents), 2)}."
    yield (f"The contacts have M = {', '.join(map(whole, report['starved_films']['loads']))} and "
           f"L = {', '.join(map(whole, report['starved_films']['materials']))} (reference/ehl/point_films.csv).")


def of_films(report):
    found, profile = report["line_films"], report["line_films"]["profile"]
    best = min(found["formulas"], key=lambda one: one["median_size"])

    def place(one):
        return f"(M = {whole(one['load_number'])}, L = {whole(one['material_number'])})"
    home = [one["elastic_viscous"] for one in found["formulas"]]
    yield (f"{best['authors']}' is the closest ({signed(best['least']['error'])} to {signed(best['greatest']['error'])}) over all contacts; in the regime that all six are "
           f"made for, their errors are {signed(min(one['least']['error'] for one in home))} to {signed(max(one['greatest']['error'] for one in home))}.")
    yield f"In its regime: at the {found['formulas'][0]['elastic_viscous']['points']} contacts where, of Moes' four asymptotes"
    for one in found["scenes"]:
        if one["is_on_map"]:
            yield f"The track {one['name']} is {one['file']} over its speeds, {whole(one['slowest'])} to {whole(one['fastest'])} m/s"
    yield f"The table has {found['formulas'][0]['points']} solved contacts with L > 0"
    one, two = found["solved"], found["solved_compressible"]
    yield (f"may be off by {sig(one['median'], 2)} of themselves in the median and by {sig(one['greatest']['error'], 2)} at most "
           f"{place(one['greatest'])}; {one['within_1e_4']} of {one['films']} (three of each contact, those at L = 0 too) are within 10−4.")
    yield f"may be off by {sig(two['median'], 2)} in the median and {sig(two['greatest']['error'], 2)} at most {place(two['greatest'])}."
    between = found["interpolation"]
    most, light = ([f"{sig(100 * between[key][film], 2)} %" for film in ("at_greatest_pressure", "minimum", "central")]
                   for key in ("greatest", "greatest_light"))
    yield (f"at {between['points']} contacts between them the maps are off by at most {most[0]} in the film at the greatest pressure, {most[1]} in the "
           f"minimum and {most[2]} in the central film; below M = {whole(between['heavy_from'])} by {light[0]}, {light[1]} and {light[2]}.")
    law = {"barus": "Barus'", "roelands": "Roelands'"}[profile["viscosity"]]
    off = max(profile[name]["error"] / profile[name]["value"] for name in ("central", "minimum"))
    yield (f"{profile['file']} at {whole(profile['speed'])} m/s, its viscosity by {law} law: M = {sig(profile['load_number'], 3)}, "
           f"L = {sig(profile['material_number'], 3)}, half-width b = {sig(1e6 * profile['half_width'], 3)} µm, p0 = {sig(1e-9 * profile['peak_pressure'], 3)} GPa. "
           f"The central film is {sig(1e9 * profile['central']['value'], 5)} nm, the least {sig(1e9 * profile['minimum']['value'], 5)} nm, "
           f"each to {sig(off, 1)} of itself.")
    unsure = "; grids of double numbers do not resolve its height, so that the drawn height means nothing." if profile["spike_pressure"]["value"] is None else "."
    yield f"a spike at x/b = {sig(profile['spike_place']['value'], 3)} ± {sig(profile['spike_place']['error'], 1)}, just before the film's constriction{unsure}"
    titles = ("ball on a flat", "bearing's outer ring", "gear's flank")
    yield "friction is least (●) at λ = " + ", ".join(f"{sig(one['least_friction']['film_parameter'], 3)} ({title})" for one, title in
                                                     zip(report["contacts"]["scenes"].values(), titles)) + "."


def software(report):
    certified, stress, faults, wrong = (report[name] for name in ("certified", "stress", "planted_faults", "diagnosis"))
    yield (f"{certified['held']} of {len(certified['quantities'])} quantities keep their declared accuracy on {many(certified['cases'])} certified values; "
           f"the worst error " + ("meets its bound exactly." if certified['worst_part_of_bound'] == 1 else f"takes {percent(certified['worst_part_of_bound'])} of its bound."))
    yield "The earlier version, worst error/condition: " + provenance(certified["before"])
    yield (f"{stress['held']} of {len(stress['outputs'])} outputs keep their declared accuracy at {many(stress['points'])} random points; the worst error "
           f"takes {percent(stress['worst_part_of_bound'])} of its bound. {measured(stress)}.")
    yield f"{many(stress['points'])} random points, seed {stress['seed']}: scenes as they are built, and scenes far beyond. {provenance(stress)}"
    random, waiting = report["mutants"], sum(one["drawn"] - one["ran"] for one in report["mutants"]["rooms"])
    end = f"{many(waiting)} more wait for slow tests." if waiting else "All goals are reached." if random["goals_reached"] else f"{random['goals_missed']} of the {len(random['rooms'])} parts miss their goal."
    share = (f"the tests notice {many(random['noticed'])} of {many(random['of'])} wrong changes that were drawn at random: with 95 % confidence between "
             f"{percent(random['low'])} and {percent(random['high'])} of such changes, each part counted by its number drawn.")
    yield f"Random changes: {share if random['of'] else 'no part of the project has a score yet.'} {end} {measured(random)}"
    yield f"The tests should turn red at each change. {provenance(random)}"
    left = faults["catalogue"] - len(faults["faults"])
    yield (f"Planted faults: {faults['caught']} of {len(faults['faults'])} faults that were planted in the formulas and in the checks themselves turned a check red" +
           (f"; {left} of the {faults['catalogue']} in the catalogue were not planted" if left > 0 else "") + f". The oldest of these verdicts: {faults['date']}, commit "
           f"{commit(faults['commit'])}.")
    more = f"The catalogue has {faults['catalogue']} faults; the others"
    yield more if faults["catalogue"] > len(faults["faults"]) else ("not", more)
    right = wrong["right_solvers"]
    yield (f"in {wrong['named']} of {len(wrong['wrong_solvers'])} solvers with one, two or three known mistakes tribocheck verify --subject names each "
           f"mistake, in {wrong['with_alternatives']} of them beside others that the numbers do not tell apart; it accuses {'some' if right['accused'] else 'none'} of {many(right['tries'])} right solvers. {measured(wrong)}.")
    work, least = report["work_precision"], report["skipped_work"]
    beside = work["alternatives"]
    yield (f"as long as tribocheck, over {beside['jobs']} jobs; it is less exact in "
           f"{'each of them' if beside['less_exact'] == beside['jobs'] else str(beside['less_exact']) + ' of them'}. ")
    same = beside["as_exact"]
    yield ((f"In {same['jobs']} jobs others have no greater error than our fastest way: the fastest of these takes "
            f"{ends([same['least_times_ours'], same['greatest_times_ours']], 3)} times as long. " if same["jobs"] else "") +
           f"A way fails at a case where it gives no number, or its error is above 10−6 times the condition number. {measured(work)}.")
    yield f"without failures takes {ends([beside['least_times_ours'], beside['greatest_times_ours']], 3)} times as long as tribocheck"
    for job in work["jobs"]:
        ours, other = job["ours"], job["fastest_alternative"]
        if ours:
            yield f"The fastest way of tribocheck, {ours['name']}, takes {sig(ours['ns'], 3)} ns a point; its greatest error is {sig(ours['max_ulp'], 3)} ulp."
        if other:
            times = f", {sig(other['times_ours'], 3)} times as long" if ours else ""
            yield (f"{other['family']} {other['name']}, takes {sig(other['ns'], 3)} ns a point{times}; its greatest error is {sig(other['max_ulp'], 3)} ulp.")
        same = job["as_exact"]
        if same:
            yield (f"The fastest alternative whose greatest error is no greater than ours, {same['family']} {same['name']}, takes {sig(same['times_ours'], 3)} times as long; its "
                   f"greatest error is {sig(same['max_ulp'], 3)} ulp.")
        counted = [f"{way['family']} {way['name']} {sig(way['evaluations'], 3)}" for way in job["ways"] if way["evaluations"] is not None]
        if job["is_counted"] and counted:
            yield f"of the fastest way of each family without failures, which the diagram of time may not show: {', '.join(counted)}."
    films, ways = work["line_film"], {one["name"]: one for one in work["line_film"]["ways"]}
    asked = [f"{sig(1e-9 * ways[name]['ns'], 2)} s with errors up to {sig(ways[name]['max_relative'], 2)}" for name in
             ("to 1e-04", "dense LU, our grid 1024", "dense LU, uniform grid 1024")]
    yield "ours takes {}, on one core. A dense matrix of 1024 cells on our grid takes {};".format(*asked)
    yield f"before the contact, {asked[2]}, because it begins too near for the inlet of light loads. {measured(films)}."
    circles, ways = work["point_film"], {one["name"]: one for one in work["point_film"]["ways"]}
    asked = [f"{sig(1e-9 * ways[name]['ns'], 2)} s with errors up to {sig(ways[name]['max_relative'], 2)}" for name in
             ("to 1e-03, M = 20", "to 1e-03, M = 200")]
    beside = ", ".join(f"{one['threads']}: {sig(1e-9 * one['ns'], 2)} s" for one in circles["threads"])
    yield ("ours takes {} at M = 20, and {} at M = 200, on one core. Several threads solve several circles at a time. Seconds for each at M = 20, by the number of threads: "
           "{}.".format(*asked, beside))
    yield measured(circles)
    for films in (films, circles):
        yield f"fitted from {films['exponents'][0]['from_cells']} cells on" + "".join(
            f"{';' if i else ', with their standard errors.'} {one['solver']}, {whole(one['cells'])} cells: {sig(1e-9 * one['step_ns'], 2)} s a step, "
            f"{sig(1e-6 * one['bytes'], 3)} MB" for i, one in enumerate(films["largest"])) + "."
    yield (f"depending on its outputs, a scene saves {percent(least['least_saved'], 2)} to {percent(least['greatest_saved'], 2)} of the evaluations of Fn.")
    yield f"at {many(least['speeds'])} speeds over the range"
    gates, speed = report["gates"], report["sweep_speed"]
    proofs = len(gates["proofs"])
    yield ("the gates passed the unchanged program and failed every slowed one." if proofs and gates["proved"] == proofs else
           f"{proofs - gates['proved']} of {proofs} gates did not say what they had to")
    yield f"took at most {sig(gates['greatest_time_of_the_same_program'], 4)} times its own time. {measured(gates)}."
    yield f"the widest is {percent(gates['baseline']['widest_band'], 2)}."
    targets, missed = speed["targets"], speed["targets_missed"]

    def target(name, bound, unit=""):
        one = targets[name]
        return f"(target: {bound} {whole(next(one[key] for key in ('at_most', 'at_least', 'below') if key in one))}{unit}{'' if one['reached'] else ', missed'})"
    yield {0: f"all {len(targets)} speed targets are reached.", 1: f"one of {len(targets)} speed targets is missed."}.get(
        missed, f"{missed} of {len(targets)} speed targets are missed.")
    yield (f"A point whose summaries are kept takes at most {sig(targets['times_alone']['is'], 3)} times as long as its scene and root alone {target('times_alone', 'at most')}; "
           f"two threads are {sig(targets['two_threads']['is'], 3)} times as fast as one {target('two_threads', 'at least')}; a rank needs at most "
           f"{sig(targets['mb_of_rank']['is'], 3)} MB {target('mb_of_rank', 'below', ' MB')}. {measured(speed)}.")
    ranks = speed["two_ranks"]
    yield (f"Two ranks are {sig(ranks['speedup'], 3)} times as fast as one by the clock, and {sig(ranks['cpu_speedup'], 3)} times by their CPU time. With twice "
           f"the points two ranks keep {percent(ranks['weak_efficiency'])} of their speed by the clock, and {percent(ranks['weak_cpu_efficiency'])} by their CPU "
           f"time. Other processes disturb the clock: they used up to {sig(speed['others'], 2)} of {speed['processors']} processors meanwhile.")
    for one in (faults, work, wrong, gates, gates["baseline"], speed):
        yield provenance(one)
    since = {one["file"]: "How much its code has changed since is not known" if one["commits_since"] is None else
             f"Its code has changed in {one['commits_since']} commits since." for one in report["environment"]["baselines"]
             if "missing" not in one and one["commits_since"] != 0}
    for name, one in (("stress", stress), ("mutants", random), ("diagnosis", wrong), ("gates", gates), ("sweep", speed)):
        yield f"{measured(one)}. {since.get(name + '.json', '')}".strip()
    yield f"commit {commit(faults['commit'])}. {since.get('planted_faults.json', '')}".strip()
    standings = [one["standing"] for one in report["findings"] if one["about"] == "software"]
    targets = {"mutants": random["goals_missed"], "sweep_speed": speed["targets_missed"]}
    fails, late = standings.count("fails"), sum(targets.get(one["id"], 1) for one in report["findings"] if one["about"] == "software" and one["standing"] == "missed")
    yield ({0: "Software checks pass", 1: "A software check fails"}.get(fails, f"{fails} software checks fail") +
           {0: "", 1: "; one target is missed"}.get(late, f"; {late} targets are missed") + ".")


def promised(report):
    for section in (paper, of_ledger, drawn, of_films, of_point_films, of_starved_films, software):
        yield from section(report)
