"""python tests/live/table.py [-r RUNS] [-o FILE] [WORDS ...]: conditions whose name holds one of the words, flown.

One line a condition: what is asked, whether it is so, NEES, refused, and the commonest events.  -o writes them as JSON.
"""

import argparse
import json
import re
from collections import Counter
from pathlib import Path

import numpy as np
from conditions import CONDITIONS
from judge import TAU, N, informed, judged, met
from loops import fly_live
from scipy.stats import chi2


def flown(one, runs):
    """What came of a condition, and how it is said in a line."""
    flight = one.flight()
    runs = runs if flight.setting.seconds < 100 else -(-runs // 5)
    flight = one.flight(runs=runs)
    record = fly_live(flight, carrying=one.carrying)
    found = judged(record, flight.setting.seconds)
    texts = Counter(re.sub(r"-?\d[\d.e+-]*", "#", text.split(": ", 1)[-1]) for _, _, text in record.notes)
    ok, told = met(one.asked, one.refused, flight, record), len({run for _, run, _ in record.notes})
    lines = [f"{'ok ' if ok else 'BAD'} {one.asked:10} {one.name:52} {found}; {told} runs"]
    if one.asked == "informed" and record.time:
        _, claimed, of = informed(flight, record)
        lines.append(f"        sigma of the delay {claimed[0]:.2f} to {claimed[-1]:.2f} ms, by the true rates "
                     f"{of[0]:.2f} to {of[-1]:.2f}")  # fmt: skip
    lines += [f"        {count} x {text[:200]}" for text, count in texts.most_common(2)]
    low, high = chi2.ppf([0.0005, 0.9995], N * runs) / runs
    numbers = {"nees": found.nees, "end": found.nees_end, "low": low, "high": high, "refused": found.refused,
               "told": told / runs}  # fmt: skip
    for name, scale, part in (("attitude_mrad", 1e3, slice(3)), ("delay_ms", 1e3, slice(TAU, TAU + 1))):
        numbers |= {name: scale * np.sqrt(np.mean(found.rms[part] ** 2)),
                    f"{name}_claimed": scale * np.sqrt(np.mean(found.claimed[part] ** 2))}  # fmt: skip
    rounded = {name: float(f"{value:.4g}") for name, value in numbers.items()}
    events = [text for text, _ in texts.most_common(3)]
    return {"asked": one.asked, "ok": bool(ok), "raised": record.raised, "events": events} | rounded, lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("words", nargs="*")
    parser.add_argument("-r", "--runs", type=int, default=30)
    parser.add_argument("-o", "--out", type=Path)
    given, found = parser.parse_args(), {}
    for one in CONDITIONS:
        if not given.words or any(word in one.name for word in given.words):
            found[one.name], lines = flown(one, given.runs)
            print("\n".join(lines), flush=True)
    if given.out:
        given.out.write_text(json.dumps(found))


if __name__ == "__main__":
    main()
