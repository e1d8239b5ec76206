"""Sizes of what is dropped, what the errata do, and what was computed about the text beside the equations."""

import math
from collections.abc import Callable

from boresight.derive.ledger import ellipsoid
from boresight.derive.ledger.ellipsoid import WORKING
from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.numbers import Matrix, cos, digits, exact, eye, norm, sin
from boresight.derive.ledger.witness import attitude, draw, skew, vector
from boresight.derive.papers.kang_2025.witness import (
    CONDITIONS,
    DEGREE,
    DELAY,
    MIL,
    POINTS,
    ROLL,
    STATED,
    SURGE,
    WAVE_RATE,
    Base,
    after,
    motion,
    values,
)

# The text beside the equations: line, and what it says.
RATE_OF_N = (78, "지구 자전 각속도와 transport rate의 합")  # w_in: the Earth's rate and the transport rate together
WHEN = (88, r"그 이전인 $k - \delta t_d$ 시점에 측정된 값")  # the master's data is that of k - dt_d
BETWEEN = (88, "이전 측정치 정합인 $k-1$ 사이")  # k and k-1 are updates of the filter
RESIDUALS = (104, r"z_v, z_{DCM} 은 각각 필터의 측정치로 사용되는 속도 오차, 자세 오차이다")
HEIGHT = (115, "a, f 는 각각 파도의 파고와 주기를 의미하며, 주기는 0.1 Hz로")  # a: wave height; f: "period", 0.1 Hz
GRADES_RUN = (115, "해상상태 1등급부터 6등급까지")  # simulated: 1 to 6
GRADES_READ = (162, "등급 0~2에서는")  # read off Fig. 3: 0 to 2
AT_REST, ROLLING = (173, "1.90°"), (173, "0.15°")  # heading error left on the bench, of 2 deg

TABLE_1_LINES = (120, 125)
TABLE_1 = (
    ("1", "0.01", "0.1", "Calm(rippled)"),
    ("2", "0.1", "0.1", "Smooth(wavelets)"),
    ("3", "0.5", "0.1", "Slight"),
    ("4", "1.25", "0.1", "Moderate"),
    ("5", "2.5", "0.1", "Rough"),
    ("6", "4", "0.1", "Very rough"),
)
TABLE_2_LINES = (130, 135)
TABLE_2 = (
    ("Monte #", "times", "20"),
    ("Misalignment error", "deg", "2"),
    ("Navigation update rate", "Hz", "100"),
    ("Filter update rate", "Hz", "1"),
    ("Time delay", "ms", "5-10 (random)"),
    ("Simulation time", "min", "1"),
)


def evidence(number: str) -> str:
    """What the ledger says beyond the status: sizes, and what the print does."""
    with digits(DIGITS):
        return _EVIDENCE[number]()


def lever_sizes() -> dict[str, float]:
    """Largest over the stated conditions, m/s: the lever-arm velocity, and what (1) and its variants leave.

    own, one: the master's velocity in its own north, east and down, or in those of the slave.
    """
    sizes = dict.fromkeys(("lever arm", "print, own", "print, one", "earth rate, own", "earth rate, one"), 0.0)
    for seed in range(POINTS):
        with digits(WORKING):
            slave, zero = motion(draw(Base, seed, CONDITIONS), False), exact(0)
            level = slave.level(slave.slave(zero))
            masters = {
                "own": slave.velocity(slave.master, zero),
                "one": level.T * after(slave.master, zero),
            }
            spin = level.T * vector(0, 0, ellipsoid.SPIN)
            by_rate = {"print": slave.omega_in_n(zero), "earth rate": spin}
            C, L, v = slave.attitude(zero), slave.lever, slave.velocity(slave.slave, zero)
            for rate, omega in by_rate.items():
                arm = skew(omega) * C * L - C * skew(slave.omega_ib_b(zero)) * L
                sizes["lever arm"] = max(sizes["lever arm"], float(norm(arm)))
                for axes, v_m in masters.items():
                    key = f"{rate}, {axes}"
                    sizes[key] = max(sizes[key], float(norm(v + arm - v_m)))
    return sizes


def _lever() -> str:
    sizes = lever_sizes()
    exact = "nothing" if sizes["earth rate, one"] < 1e-28 else f"{sizes['earth rate, one']:.1g} m/s"
    return (
        f"there the lever-arm velocity is up to {sizes['lever arm']:.2g} m/s, v L / R is {5 * 3 / 6.37e6:.1g} m/s, and "
        f"the print leaves {sizes['print, own']:.2g} m/s; with the Earth's rate alone for ω_in it would leave "
        f"{sizes['earth rate, own']:.2g} m/s, and {exact} if both velocities were resolved in the slave's north, where "
        f"the print leaves {sizes['print, one']:.2g} m/s"
    )


def interpolation(height: float, step: float, delay: float = DELAY) -> tuple[float, float]:
    """Heave by (6) as printed, m/s: the largest error of (2), and the largest change during the delay."""

    def speed(t: float) -> float:
        return height * SURGE * math.cos(SURGE * t)

    error = change = 0.0
    for k in range(200):
        t = k / 20
        line = speed(t) + (speed(t - step) - speed(t)) * delay / step
        error = max(error, abs(speed(t - delay) - line))
        change = max(change, abs(speed(t - delay) - speed(t)))
    return error, change


def _interpolation() -> str:
    (slow, change), (bench, _), (fast, _) = (interpolation(4, *both) for both in ((1.0,), (0.1,), (0.01, 0.005)))
    return (
        f"k and k-1 are updates, by the text, so dt is 1 s in Table 2: at grade 6 the line errs by {slow * 1e3:.2g} "
        f"mm/s, {100 * slow / change:.2g} % of the {change * 1e3:.3g} mm/s which it is to take out at 10 ms, for it "
        f"takes the mean acceleration of the second before, by {bench * 1e3:.2g} mm/s with the 0.1 s of the bench, and "
        f"by {fast * 1e3:.2g} mm/s between steps of 10 ms of the navigator, at 5 ms"
    )


def dropped_by_3(roll: float, rate_hz: float, lever: float) -> float:
    """Largest change of the lever-arm velocity during 10 ms, m/s: a roll (rad) about an axis `lever` (m) away."""

    def speed(t: float) -> float:
        return lever * roll * 2 * math.pi * rate_hz * math.cos(2 * math.pi * rate_hz * t)

    return max(abs(speed(k / 20) - speed(k / 20 - DELAY)) for k in range(200))


def _dropped() -> str:
    kept = {grade: interpolation(float(height), 0.01)[1] for grade, height, *_ in TABLE_1}
    lost = dropped_by_3(ROLL, WAVE_RATE, 3.0)
    shares = ", ".join(f"{100 * lost / kept[grade]:.3g} % at grade {grade}" for grade in "3456")
    bench = dropped_by_3(1.18 * DEGREE, 1.0, 0.5)
    return (
        f"a hull that rolls by 5 deg at 0.1 Hz, 3 m from the axis: {lost * 1e3:.2g} mm/s are left out in 10 ms; of the "
        f"change that is kept, heave as (6) prints it, that is {shares}; on a bench that only rolls, the slave on the "
        f"axis, all is left out: {bench * 1e3:.2g} mm/s at 1.18 deg, if at 1 Hz and 0.5 m"
    )


def half_of_4() -> dict[str, float]:
    """The turn at the stated point, rad: the largest component, by (4) as derived and as printed, and what of the
    symmetric part is in the latter."""
    found = values(STATED, {})
    M = found["C_S2n"] * found["C_M2S"] * found["C_n2M"]
    X = M - eye(3)
    printed = X - X.T / 2

    def taken(B) -> Matrix:
        return vector(-B[1, 2], B[0, 2], -B[0, 1])

    derived, literal = taken((X - X.T) / 2), taken(printed)
    return {
        "derived": float(max(map(abs, derived))),
        "printed": float(max(map(abs, literal))),
        "symmetric": float(max(map(abs, literal - derived * exact("1.5")))),
    }


def _half() -> str:
    sizes = half_of_4()
    minutes = {name: size / DEGREE * 60 for name, size in sizes.items()}
    return (
        f"there a turn of {minutes['derived']:.4g} arcmin is read off the print as {minutes['printed']:.4g}: 1.5 times "
        f"it, and half of the symmetric part, {minutes['symmetric']:.2g} arcmin; H says 1, so a filter that trusts it "
        f"fully overshoots by half, and the NIS of the attitude is {1.5**2:.3g} times as large"
    )


def delay_by_attitude(form: str, heading_deg: int) -> float:
    """The delay (s) which least squares find from (5), printed or derived, the true one 10 ms: a ship that rolls."""
    above = below = 0
    roll, surge, heading = exact(ROLL), exact(SURGE), exact(heading_deg * DEGREE)

    def C(t) -> Matrix:
        return attitude((roll * sin(surge * t), 0, heading))

    with digits(DIGITS):
        for k in range(10):
            t = exact(k)
            turned = C(t) * C(t - exact(DELAY)).T
            turn = vector(*(turned[i, j] - turned[j, i] for i, j in ((2, 1), (0, 2), (1, 0)))) / 2
            rate_b = vector(roll * surge * cos(surge * t), 0, 0)
            column = -C(t) * rate_b if form == "derived" else C(t) * C(t) * rate_b
            above -= (column.T * turn)[0]
            below += (column.T * column)[0]
    return float(above / below)


def _delay() -> str:
    printed, derived = (
        [f"{round(delay_by_attitude(form, h) * 1e3, 2) + 0:g} ms at {h} deg" for h in (0, 90, 180)]
        for form in ("printed", "derived")
    )
    turn = ROLL * SURGE * DELAY
    return (
        f"a ship that rolls by 5 deg at 0.1 Hz, delay 10 ms: the term is up to {turn / MIL:.2g} mil; from the printed "
        f"form alone least squares find {', '.join(printed)} of heading, for C_S2n turns the rate once more; from the "
        f"derived one {', '.join(derived)}, and (3) finds it with its sign"
    )


BOUNDS = (0.0, 0.1, 0.5, 1.25, 2.5, 4.0, 6.0, 9.0, 14.0)  # m, of WMO-No. 306, code table 3700


def grade(height: float) -> int:
    """Sea state of a height (m) by code table 3700; a bounding height has the lower figure, 4 m is 5."""
    return sum(height > bound for bound in BOUNDS)


def _wave() -> str:
    heights = [float(height) for _, height, *_ in TABLE_1]
    twice = ", ".join(f"{2 * height:g} m (grade {grade(2 * height)})" for height in heights)
    return f"as printed the waves of grades 1 to 6 are, crest to trough and by code table 3700, {twice}"


_EVIDENCE: dict[str, Callable[[], str]] = {
    "1": _lever, "2": _interpolation, "3": _dropped, "4": _half, "5": _delay, "6": _wave,
}  # fmt: skip


def findings() -> tuple[str, ...]:
    """What was computed about the text and the tables beside the equations."""
    table = [(int(number), float(height)) for number, height, *_ in TABLE_1]
    lower = [number for number, height in table if height == BOUNDS[number - 1]]
    coded = ", ".join(str(grade(height)) for _, height in table)
    simulated = [number for number, _ in table]
    left = [float(text.rstrip("°")) * DEGREE / MIL for _, text in (AT_REST, ROLLING)]
    start = float(TABLE_2[1][2]) * DEGREE / MIL
    return (
        f"Table 1 has the lower edge of each grade of code table 3700 for grades {lower[0]} to {lower[-1]}, and "
        f"{table[0][1]:g} m for grade 1, whose lower edge is 0; a bounding height has the lower figure there, so the "
        f"six heights are of grades {coded}.",
        f"Grades {simulated[0]} to {simulated[-1]} are simulated, by the text over Table 1 and by the table; Fig. 3 is "
        "read from grade 0 on, which was not. Yaw and heading, misalignment (Table 2) and heading error (text), each "
        "2 deg, are one quantity by two names.",
        "The delay of Table 2, 5 to 10 ms, lies between k-1 and k whether these are updates, 1 s apart, or steps "
        "of the navigator, 10 ms apart; which of the two (2) and (3) mean makes a difference: see (2).",
        f"On the bench {left[0]:.3g} mil are left of {start:.3g} at rest and {left[1]:.2g} mil when it rolls; the "
        "simulation claims less than 2 mil from grade 3 on.",
        "How waves become motion of the ship, where the lever arm lies and how long it is, noise, Q, R and the start "
        "of P are nowhere given; nor are F and H, which follow from (3) and (5).",
    )
