"""The exported C from Python, without Boresight.

cc -shared -fPIC -ffp-contract=off -Iinclude src/*.c -lm -o rest.so; python rest.py ./rest.so
"""

import ctypes
import sys

Three, Four = ctypes.c_float * 3, ctypes.c_float * 4


class Nav(ctypes.Structure):
    _fields_ = [("lon_lat_height", Three), ("v_n", Three), ("q_b2n_wxyz", Four)]


class Imu(ctypes.Structure):
    names = ("dtheta_ib_b", "dv_b", "dtheta_before", "dv_before")
    _fields_ = [*((name, Three) for name in names), ("dt", ctypes.c_float)]


def rest(library: str) -> int:
    step = ctypes.CDLL(library).sd_step_f32
    up = Three(0.0, 0.0, 0.0981)
    nav = Nav(Three(0.0, 0.8, 0.0), Three(), Four(1.0, 0.0, 0.0, 0.0))
    imu = Imu(Three(), up, Three(), up, 0.01)
    for _ in range(100):
        out = Three(), Three(), Four()
        if step(ctypes.byref(nav), ctypes.byref(imu), *out) != 0:
            return 1
        nav = Nav(*out)
    return int(abs(nav.v_n[2]) > 1.0)


if __name__ == "__main__":
    sys.exit(rest(sys.argv[1]))
