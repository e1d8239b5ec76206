"""The figures of docs/noise.md, of a log and of a flight whose noises are known.

python tests/analysis/drawn.py FOLDER
"""

import sys
from pathlib import Path

from at_rest import log
from flights import matching

from boresight.analysis import noise

FOUR_HOURS = 288_000  # samples
BELIEVED = (0.4, 1.0)  # of the gyro noise and of R, as the filter of the flight has them

if __name__ == "__main__":
    folder = Path(sys.argv[1])
    rest, flight = folder / "noise.svg", folder / "noise_flight.svg"
    noise.identify(log(3, FOUR_HOURS, "fibre")).draw(rest, "a simulated log, tests/analysis/drawn.py")
    noise.likeliest(matching(1, BELIEVED, steps=1000)).draw(flight, "tests/analysis/drawn.py")
    print(rest, flight, sep="\n")
