"""Fly a recording from Python, by the same C: the digest is that of the program, here and on the target.

python replay.py FILE
"""

import sys
from pathlib import Path

import numpy as np
from make_recording import SLAVE, Setup, read

from boresight import Live, load


def replay(setup: Setup, records: np.ndarray, precision: str = "double") -> Live:
    """As main.c does it."""
    noise = {"gyro_noise": setup.gyro_noise, "accel_noise": setup.accel_noise}
    loop, now = Live(load("velocity-attitude", precision=precision), {"latency": 8}, **noise), 0
    for kind, at, *numbers in records:
        of = np.array(numbers)
        if kind == SLAVE:
            now = int(at)
            loop.sample(now, setup.dt, dtheta_ib_b=of[:3], dv_b=of[3:6])
        elif loop.output(now):
            master = {"lever_b": setup.lever_b, "v_m_n": of[3:6], "q_m2n_wxyz": of[6:]}
            loop.message("velocity", int(at), setup.velocity_variance, **master)
            loop.message("dcm", int(at), setup.attitude_variance, **master)
        else:
            nav = {"lat_lon_height": of[:3], "v_n": of[3:6], "q_b2n_wxyz": of[6:], "q_b2m_wxyz": [1, 0, 0, 0]}
            loop.begin(now, nav, setup.sigma)
    return loop


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python replay.py FILE")
    flown = replay(*read(Path(sys.argv[1])))
    print(*flown.events(), flown.digest(), sep="\n")
