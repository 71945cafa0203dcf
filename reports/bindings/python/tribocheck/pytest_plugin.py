# SPDX-License-Identifier: Apache-2.0
"""pytest --tribocheck: a table of all that tribocheck.check() judged, at the end."""
from . import _check


def pytest_addoption(parser):
    parser.getgroup("tribocheck").addoption("--tribocheck", action="store_true", help="tell the verdict of each tribocheck.check() at the end")


def pytest_terminal_summary(terminalreporter, config):
    if not config.getoption("--tribocheck"):
        return
    terminalreporter.section("tribocheck")
    for one in _check.verdicts:
        terminalreporter.write_line(f"{', '.join(one.names):<32}{one.text.rstrip().splitlines()[-1]}",
                                    **{"green" if one.holds else "red": True})
