"""python tests/live/table.py [-l] [-r RUNS] [WORDS ...]: conditions whose name holds one of the words, by Transfer.

-l: by Live.  One line a condition: what is asked, whether it is so, NEES, NIS, refused, and the commonest note.
"""

import argparse
import re
from collections import Counter

import numpy as np
from conditions import CONDITIONS
from judge import BAND, Flown, Judged, judged
from loops import live, transferred


def met(asked: str, flown: Flown, found: Judged) -> bool:
    if flown.raised or np.isnan(found.nees_end):
        return False
    named, ends_well = bool(flown.notes), BAND[0] < found.nees_end < BAND[1]
    if asked == "consistent":
        return found.consistent
    return named and ends_well if asked == "recovers" else named or found.consistent


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
        print(
            f"{'ok ' if met(one.asked, flown, found) else 'BAD'} {one.asked:10} {one.name:52} {found}; {runs} runs",
            flush=True,
        )
        for text, count in texts.most_common(2):
            print(f"        {count} x {text[:200]}", flush=True)


if __name__ == "__main__":
    main()
