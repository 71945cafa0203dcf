# SPDX-License-Identifier: Apache-2.0
"""The sections of the page in their order, and the groups of report.json that each needs."""
import typing


class Section(typing.NamedTuple):
    title: str  # Markdown
    groups: tuple  # of report.json, which its templates read
    is_folded: bool = False  # closed until a reader opens it
    further: tuple = ()  # more templates; each is left out alone where its data is missing


# The paper first, then this software. templates/<id>.md is the text of each.
SECTIONS = {
    "figures": Section("The paper's figures, redrawn", ("paper", "ledger")),
    "comparison": Section("The paper's numbers by each criterion and model", ("paper",), True),
    "claims": Section("The paper's 17 claims, one by one", ("ledger", "paper")),
    "live": Section("Your own contact", ("paper", "contacts")),
    "readings": Section("Interpretations of what the paper leaves open", ("ledger",), True),
    "requirements": Section("What would make the other claims hold", ("ledger",), True),
    "uncertainty": Section("How sure the computed numbers are", ("ledger", "onset_uncertainty"), further=("uncertainty-sweep",)),
    "misprints": Section("The paper's misprints", ("ledger",), True),
    "model": Section("The model: its equations, inputs and limits", ("paper", "ledger"), True),
    "contacts": Section("Contacts as machines have them: circle, ellipse and line", ("contacts",), True),
    "film-solved": Section("The film of line contacts solved, and what formulas are worth", ("line_films",), True),
    "film-points": Section("The film of circles solved, and what formulas are worth", ("point_films",), True),
    "film-starved": Section("Starved films solved: what the paper's surfaces would do", ("starved_films", "paper"), True),
    "verification": Section("Accuracy, quantity by quantity", ("certified",), True),
    "worst-inputs": Section("Accuracy at random inputs", ("stress",), True),
    "mutants": Section("Random changes: how many do the tests notice?", ("mutants",), True),
    "planted-faults": Section("Planted faults: do the checks find errors?", ("planted_faults",), True),
    "diagnosis": Section("Wrong solvers: are their mistakes named?", ("diagnosis",), True),
    "work-precision": Section("Run time against error", ("work_precision", "ellipse_fits"), True, further=("ellipse-fits",)),
    "skipped-work": Section("Work that is skipped", ("skipped_work",), True),
    "gates": Section("Checks of run time", ("gates",), True),
    "sweep-speed": Section("Run time of sweeps over many inputs", ("sweep_speed",), True),
    "references": Section("References", (), True),
    "environment": Section("Where and when this page was made, and what measured what", ("environment",), True),
}
