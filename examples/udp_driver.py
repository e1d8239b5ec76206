"""A transfer alignment from a socket: python udp_driver.py [PORT].

A datagram begins with a letter and a time, s, by the slave's clock; all numbers are little-endian doubles.  "S" goes on
with rates and specific forces, 3 + 3, rad/s and m/s^2, front, right, down; "M" with the master's velocity (3, NED),
quaternion (4, scalar first) and latitude, longitude, height (3, rad and m).  An empty one ends it.  From a serial port
`read` is `lambda: serial.Serial(NAME, 921600).read(SIZE)`, with messages of one size.
"""

import socket
import struct
import sys
from collections.abc import Callable

import numpy as np

from boresight import Driver


def main(read: Callable[[], bytes]) -> None:
    driver = Driver(
        "velocity-attitude", rates=True, velocity_sigma=0.02, attitude_sigma=3e-4, full_scale=(8.0, 160.0),
        sigmas={"q_b2m_wxyz": 0.02, "gyro_bias": 5e-5, "accel_bias": 1e-2, "tau": 0.05},
        gyro_noise=np.full(3, 6e-5), accel_noise=np.full(3, 1e-3), lever_b=np.array([-2.4, 1.2, 1.75]),
    )  # fmt: skip
    while data := read():
        time, *x = struct.unpack(f"<{(len(data) - 1) // 8}d", data[1:])
        if data[:1] == b"S":
            driver.sample(time, x[:3], x[3:])
        else:
            driver.message(time, v_m_n=x[:3], q_m2n_wxyz=x[3:7], position=x[7:])
        for line in driver.live.events() if driver.flying else ():
            print(line)
    sigma = driver.output(time)["sigma"]
    print(
        driver.live.counts()["TAKEN"], "messages taken; one sigma of the attitude, mrad:", np.round(1e3 * sigma[:3], 2)
    )


if __name__ == "__main__":
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as link:
        link.bind(("127.0.0.1", int(sys.argv[1]) if len(sys.argv) > 1 else 5005))
        main(lambda: link.recv(256))
