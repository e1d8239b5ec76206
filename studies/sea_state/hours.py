"""python -m boresight.studies.sea_state.hours [--hours N] [--jobs N]: the live loop in health at sea, hour after hour.

Each run is an hour of `hours.c`: the C of the loop as it ships, with its rules by default, in a sea of state 4 that 49
others share, with biases, noise and a delay of its own.  Printed is how often each event comes, with 95 % limits.
"""

import argparse
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.stats import chi2

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.gpu import text
from boresight.runtime.live import Event
from boresight.runtime.manifest import folder_of
from boresight.studies.sea_state import many as sea

SOURCE, FOLDER, TOGETHER, SEED, GRADE = Path(__file__).with_name("hours.c"), folder_of(sea.MODEL), 50, 31, 4
TAKEN, COLUMNS = 20, 22  # behind the events by code: messages that were taken, and those that were not


def given(number: int, seconds: int = 3600) -> Array:
    """What hours.c reads: the scenario and a sea."""
    plain = sea.Sea("sea", GRADE)
    kind = replace(plain, scenario=replace(plain.scenario, seconds=seconds))
    return np.concatenate([sea.common(kind), sea.shared(kind, SEED, number).numbers])


def flown(given: Array, runs: range) -> Array:
    """(len(runs), COLUMNS)."""
    sources = *(FOLDER / "src" / f"va_{name}.c" for name in ("live", "digest")), text.RUNS, SOURCE
    rows, status = text.fly(text.library(FOLDER, *sources), given, SEED, runs, COLUMNS)
    if status.any():
        raise BoresightError(f"run {runs[int(np.flatnonzero(status)[0])]}: the loop refused a sample or a start")
    return rows


def in_a_sea(number: int, runs: int) -> Array:
    first = number * TOGETHER
    return flown(given(number), range(first, first + runs))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hours", type=int, default=100)
    parser.add_argument("--jobs", type=int, default=1)
    asked = parser.parse_args()
    parts = [min(TOGETHER, asked.hours - first) for first in range(0, asked.hours, TOGETHER)]
    total, eventful, hours = np.zeros(COLUMNS), 0, 0
    with ProcessPoolExecutor(asked.jobs) as pool:
        for rows in pool.map(in_a_sea, range(len(parts)), parts):
            total, hours = total + rows.sum(0), hours + len(rows)
            eventful += int((rows[:, Event.MESSAGE : TAKEN].sum(1) > 0).sum())
            print(f"{hours} h, {eventful} of them with an event", end="\r", flush=True)
    print(f"{hours} hours, {eventful} of them with an event")
    print(f"{total[TAKEN]:.0f} messages were taken, {total[TAKEN + 1]:.0f} in part or not")
    for event in Event:
        low, high = chi2.ppf([0.025, 0.975], [2 * total[event], 2 * total[event] + 2]) / 2 / hours
        print(
            f"  {event.name:20} {total[event]:8.0f}   {100 * np.nan_to_num(low):.3f} to {100 * high:.3f} in 100 hours"
        )


if __name__ == "__main__":
    main()
