"""python tests/live/table.py [-l] [-r RUNS] [WORDS ...]: conditions whose name holds one of the words, by Transfer.

-l: by Live.  One line a condition: what is asked, whether it is so, NEES, NIS, refused, and the commonest note.
"""

import argparse
import re
from collections import Counter

import numpy as np
from conditions import CONDITIONS, Condition
from judge import BAND, TAU, Flown, Judged, information, judged
from loops import live, transferred
from simulator import Flight


def met(one: Condition, flight: Flight, flown: Flown, found: Judged) -> bool:
    """Whether a flown condition is as it is asked to be."""
    if flown.raised or np.isnan(found.nees_end):
        return False
    most = len({run for _, run, _ in flown.notes}) >= 0.9 * flight.setting.runs
    if one.asked == "recovers":
        return most and BAND[0] < found.nees_end < BAND[1]
    if one.asked == "named":
        return most or found.consistent
    well = found.consistent and found.refused <= one.refused
    return well and (one.asked == "consistent" or informed(flight, flown)[1].all())


def informed(flight: Flight, flown: Flown):
    """(L,) s of the messages of the second half, (L, runs) bool: sigma of the delay within -5 and +20 % of the truth's;
    and the two sigmas, ms."""
    time, sigma = information(flight, runs=1)
    of = np.interp(flown.time, time, sigma[:, 0, TAU])[:, None]
    claimed = np.sqrt(np.array(flown.P)[..., TAU, TAU])
    half = np.array(flown.time) > flight.setting.seconds / 2
    within = (claimed > 0.95 * of) & (claimed < 1.2 * of)
    return np.array(flown.time)[half], within[half], 1e3 * claimed[half].mean(axis=1), 1e3 * of[half, 0]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("words", nargs="*")
    parser.add_argument("-l", "--live", action="store_true")
    parser.add_argument("-r", "--runs", type=int, default=30)
    given = parser.parse_args()
    for one in CONDITIONS:
        if given.words and not any(word in one.name for word in given.words):
            continue
        flight = one.flight(runs=given.runs)
        flown = live(flight) if given.live else transferred(flight, empty_batches=one.empty_batches)
        found = judged(flown, flight.setting.seconds)
        texts = Counter(re.sub(r"-?\d[\d.e+-]*", "#", str(text)).split(" (run")[0] for _, _, text in flown.notes)
        runs = len({run for _, run, _ in flown.notes})
        verdict = "ok " if met(one, flight, flown, found) else "BAD"
        print(f"{verdict} {one.asked:10} {one.name:52} {found}; {runs} runs", flush=True)
        if one.asked == "informed" and flown.time:
            _, _, claimed, of = informed(flight, flown)
            print(
                f"        sigma of the delay {claimed[0]:.2f} to {claimed[-1]:.2f} ms, by the true rates "
                f"{of[0]:.2f} to {of[-1]:.2f}"
            )
        for text, count in texts.most_common(2):
            print(f"        {count} x {text[:200]}", flush=True)


if __name__ == "__main__":
    main()
