"""What is decided by hand of some equations: meanings of letters that the paper leaves open, and units by row."""

from itertools import product

from boresight.derive.ledger.equation import Meaning

MASTER = Meaning(
    (
        (
            "Δv_MINS is all of v̂_MINS - v",
            (("Δv_MINS", r"\hat{v}_{MINS}^n - v^n"), ("ν_v", r"v^n - \hat{v}_{MINS}^n")),
        ),
        ("Δv_MINS is the master's own error, without what its age does", ()),
    )
)
FRAMES = Meaning(
    (
        ("x, y and z are no frames of the paper", ()),
        (
            "x, y and z are n, r and b",
            (("Ĉ_r2x", r"\hat{C}_r^n"), ("Ĉ_b2y", r"\hat{C}_b^r"), ("Ĉ_n2z", r"\hat{C}_n^b")),
        ),
    )
)
D = Meaning(
    (
        ("d is the rate of n against the master", ()),
        ("d is the rate of the master against n", (("d", "-d"),)),
    )
)
DELTA = Meaning((("δ alone is nothing", ()), ("δ is δl", (("δ", r"\delta l"),))))
RATES = (("v_n", "R_N"), ("v_e", "R_E"))


def _transport_rates() -> Meaning:
    """All that ρ_e and ρ_n could be: a speed over its radius, with either sign."""
    rates = [(f"{sign}{v}/({R} + h)", rf"{sign}\frac{{{v}}}{{{R} + h}}") for v, R in RATES for sign in ("-", "")]
    senses = [
        (f"ρ_e is {east} and ρ_n is {north}", (("ρ_e", latex_e), ("ρ_n", latex_n)))
        for (east, latex_e), (north, latex_n) in product(rates, repeat=2)
    ]
    taken = next(sense for sense in senses if sense[0] == "ρ_e is -v_n/(R_N + h) and ρ_n is v_e/(R_E + h)")
    return Meaning((taken, *(sense for sense in senses if sense is not taken)))


DECIDED: dict[str, dict] = {
    "2": {"unit": ("m/s^2",) * 3 + ("rad/s",) * 6 + ("1",)},
    "4": {"introduces": ("Z_v", "Δv_MINS", "ν_v"), "meanings": (MASTER,)},
    "5": {
        "meanings": (FRAMES, D),
        "conventions": ("A product of matrices set equal to a vector is the vector of its skew-symmetric part",),
    },
    "6": {"meanings": (D,)},
    "7": {"unit": ("rad/s", "rad/s", "m/s", *("m/s^2",) * 3, *("rad/s",) * 3, *("1",) * 6)},
    "9": {"unit": ("rad/s", "rad/s", "m/s"), "meanings": (_transport_rates(),)},
    "15": {"introduces": ("ν", "ν_z")},
    "27": {"meanings": (DELTA,)},
}
