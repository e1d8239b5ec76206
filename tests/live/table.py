"""python tests/live/table.py [-l] [-r RUNS] [WORDS ...]: conditions whose name holds one of the words, by Transfer.

-l: by Live.  One line a condition: what is asked, whether it is so, NEES, NIS, refused, and the commonest note.
"""

import argparse
import re
from collections import Counter

from conditions import CONDITIONS
from judge import informed, judged, met
from loops import fly_live, fly_transfer


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
        record = fly_live(flight) if given.live else fly_transfer(flight, empty_batches=one.empty_batches)
        found = judged(record, flight.setting.seconds)
        texts = Counter(re.sub(r"-?\d[\d.e+-]*", "#", str(text)).split(" (run")[0] for _, _, text in record.notes)
        runs = len({run for _, run, _ in record.notes})
        verdict = "ok " if met(one.asked, one.refused, flight, record) else "BAD"
        print(f"{verdict} {one.asked:10} {one.name:52} {found}; {runs} runs", flush=True)
        if one.asked == "informed" and record.time:
            _, claimed, of = informed(flight, record)
            print(
                f"        sigma of the delay {claimed[0]:.2f} to {claimed[-1]:.2f} ms, by the true rates "
                f"{of[0]:.2f} to {of[-1]:.2f}"
            )
        for text, count in texts.most_common(2):
            print(f"        {count} x {text[:200]}", flush=True)


if __name__ == "__main__":
    main()
