"""Processor seconds of each test, its children's included: `pytest -p tests.costs --costs FILE`, then this as a script.

`python tests/costs.py FILE [BEFORE]` prints the table by file, dearest first, and the dearest tests; with a second
file both columns.  Seconds of the clock hang on what else the machine does, and on waiting; these do not.
"""

import json
import resource
import sys
from collections import defaultdict
from pathlib import Path

import pytest


def pytest_addoption(parser):
    parser.addoption("--costs", metavar="FILE", help="write the processor seconds of each test there, as JSON")


def spent():
    """Seconds that this process and its ended children have used."""
    return sum(
        u.ru_utime + u.ru_stime for u in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    )


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    outcome = yield
    now = spent()
    outcome.get_result().user_properties.append(("cost", now - getattr(item.config, "_cost_before", now)))
    item.config._cost_before = now


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_protocol(item):
    item.config._cost_before = spent()
    yield


def pytest_terminal_summary(terminalreporter, config):
    if not (path := config.getoption("costs")):
        return
    costs = defaultdict(dict)
    for reports in terminalreporter.stats.values():
        for report in reports:
            properties = [value for name, value in getattr(report, "user_properties", ()) if name == "cost"]
            if properties:
                costs[report.nodeid][report.when] = round(properties[-1], 3)
    Path(path).write_text(json.dumps(costs, indent=0, sort_keys=True))


def by_file(costs):
    sums = defaultdict(float)
    for name, phases in costs.items():
        sums[name.split("::")[0]] += sum(phases.values())
    return sums


def main(paths):
    read = [json.loads(Path(path).read_text()) for path in paths]
    files = [by_file(costs) for costs in read]
    tests = [{name: sum(phases.values()) for name, phases in costs.items()} for costs in read]
    for path, sums, each in zip(paths, files, tests, strict=True):
        print(f"{path}: {sum(sums.values()):.0f} s, {len(each)} tests")
    for tables, most in ((files, 1000), (tests, 60)):
        for name in sorted(tables[0], key=tables[0].get, reverse=True)[:most]:
            print("  ".join(f"{table.get(name, 0):8.1f}" for table in tables), name)
        print()


if __name__ == "__main__":
    main(sys.argv[1:])
