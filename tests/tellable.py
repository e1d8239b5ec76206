"""python tests/tellable.py [-r RUNS] [WORDS ...]: how well any test of innovations at all could tell a condition.

Each run is flown twice with the same noise, with what is wrong and without.  Of the innovations, in parts of their
sigmas, the difference is d; in health they are white, so that the best test there is, which knows the fault and the
motion to the last digit, sees it with the distance |d| (Neyman and Pearson).  With a false alarm in 1e8 it finds half
of the runs at 5.6 and nine of ten at 6.9; the loop, which knows neither, needs several times that.
"""

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.stats import norm

from boresight import Live

sys.path.insert(0, str(Path(__file__).with_name("live")))
from conditions import CONDITIONS, unchanged
from loops import MODEL, sigmas, start

ALARM = 1e-8


def innovations(flight, run):
    """{(measurement, instant in us): (m,)} in parts of their sigmas, of all messages that were judged."""
    constants = flight.setting.constants()
    lever, loop, found = constants.pop("lever_b"), None, {}
    k = -1
    for kind, at_us, *given in flight.events(run):
        if kind == "sample":
            k += 1
            if loop is None:
                continue
            loop.sample(at_us, given[0], background=False, dtheta_ib_b=given[1], dv_b=given[2])
        elif loop is None:
            loop = Live(MODEL, **constants)
            loop.begin(int(flight.end_us[k]), start(given[0], flight, run), **sigmas(flight))
        else:
            R = given[0]["R"]
            loop.message("velocity", at_us, R[:3], v_m_n=given[0]["v_m_n"], lever_b=lever)
            loop.message("dcm", at_us, R[3:], q_m2n_wxyz=given[0]["q_m2n_wxyz"])
        while loop is not None and loop.background():
            last = loop.measured()
            if last:
                found[last["measurement"], last["order"]] = last["nu"] / np.sqrt(last["S"])
    return found


def distance(one, run, runs):
    """|d| of one run of a condition."""
    plain = {name: value for name, value in one.setting.items() if name in ("seconds", "rate_hz", "message_hz")}
    healthy = replace(one, change=unchanged, setting=plain)
    with_fault, without = (innovations(of.flight(runs=runs), run) for of in (one, healthy))
    return float(np.sqrt(sum(((with_fault[at] - without[at]) ** 2).sum() for at in with_fault.keys() & without.keys())))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*")
    parser.add_argument("-r", "--runs", type=int, default=5)
    given = parser.parse_args()
    for one in CONDITIONS:
        if one.asked == "named" and (not given.words or any(word in one.name for word in given.words)):
            apart = np.array([distance(one, run, given.runs) for run in range(given.runs)])
            best = norm.sf(norm.isf(ALARM) - apart).mean()
            print(f"{one.name:40} |d| {apart.min():7.1f} to {apart.max():7.1f}; the best test finds {100 * best:.0f} %",
                  flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
