"""Letters of the derivations that the paper does not print, and what every letter is by its nature."""

from functools import cache
from typing import Any
from unicodedata import normalize

from boresight.derive.ledger.equation import Quantity, letter
from boresight.derive.ledger.free import of, rotation
from boresight.derive.ledger.numbers import eye, norm
from boresight.derive.ledger.witness import attitude, finite_rotation, quaternion, rate, skew, vector


@cache
def letters() -> tuple[Quantity, ...]:
    """Every letter of the steps, as in printed.quantities."""
    table: list[Quantity] = []

    def add(*row) -> None:
        table.append(letter(*row))

    for i, axis in enumerate(("first", "second", "third"), 1):
        add(f"R_{i}", f"R_{i}", "function", f"rotation by an angle about the {axis} axis", (3, 3), True)
    turned = "the axes of roll, pitch and yaw as columns, of the pitch, in the axes"
    add("A_3", "A_3", "function", f"{turned} that the yaw has turned", (3, 3), True)
    add("A_1", "A_1", "function", f"{turned} before the roll", (3, 3), True)
    for angle, tex, word in (("φ", r"\phi", "roll"), ("θ", r"\theta", "pitch"), ("ψ", r"\psi", "yaw")):
        add(f"∂C/∂{angle}", rf"\frac{{\partial C_b^n}}{{\partial{tex}}}", "3x3", f"change with the {word}", (3, 3))
        add(f"u_{angle}", f"u_{tex}", "vector", f"axis about which the {word} turns, in n", (3,))
    for name, latex, meaning in (
        ("C_r2n", "C_r^n", "true attitude of the master"),
        ("C_n2r", "C_n^r", "true attitude of the master: n to r"),
        ("C_n'2n", "C_{n'}^n", "computed navigation axes to true ones"),
        ("C\u0307_b2n", r"\dot{C}_b^n", "rate of C_b2n, 1/s"),
        ("C\u0302\u0307_b2n", r"\dot{\hat{C}}_b^n", "rate of Ĉ_b2n, 1/s"),
        ("E\u0307", r"\dot{E}", "[ε̇ x], 1/s"),
    ):
        add(name, latex, "3x3", meaning, (3, 3))
    for name, latex, meaning in (
        ("ω_ib_b", r"\omega_{ib}^b", "rate of b against inertial axes, in b, rad/s"),
        ("ω_in_n", r"\omega_{in}^n", "rate of n against inertial axes, in n, rad/s"),
        ("μ", r"\mu^r", "true misalignment from r to b, in r, rad"),
        ("μ\u0302", r"\hat{\mu}^r", "estimated misalignment, rad"),
        ("δμ", r"\delta\mu^r", "error of the estimated misalignment, rad"),
        ("μ\u0307", r"\dot{\mu}^r", "rate of μ, rad/s"),
        ("μ\u0302\u0307", r"\dot{\hat{\mu}}^r", "rate of the estimate, rad/s"),
        ("δμ(k-)", r"\delta\mu^r(k^-)", "error of the estimate before the correction, rad"),
        ("δμ(k+)", r"\delta\mu^r(k^+)", "error of the estimate after the correction, rad"),
    ):
        add(name, latex, "vector", meaning, (3,))
    for axis in "ned":
        add(f"ω_{axis}", rf"\omega_{axis}", "rate", "component of ω_in_n, rad/s")
    for i in range(4):
        add(f"q\u0302_{i}", rf"\hat{{q}}_{i}", "quaternion part", "component of Q̂(k-)")
    return tuple(table)


def turns(first: int):
    """The rotation by an angle about an axis, counted from 1."""
    return lambda angle: finite_rotation([angle if axis == first else 0 for axis in (1, 2, 3)])


def change(which: int):
    """The derivative of C_b2n by one of its angles: roll 0, pitch 1, yaw 2."""
    return lambda *euler: rate(lambda t: attitude([a + (i == which) * t for i, a in enumerate(euler)]))


def axes_after_yaw(pitch):
    axes = eye(3)
    axes[:, 0] = turns(2)(pitch)[:, 0]
    return axes


def axes_before_roll(pitch):
    axes = eye(3)
    axes[:, 2] = turns(2)(pitch).T[:, 2]
    return axes


def axis(which: int):
    """The axis about which an angle turns, in n: where the turns before it have taken the axis of the body."""

    def of_angles(pitch, yaw):
        before = (turns(3)(yaw) * turns(2)(pitch), turns(3)(yaw), eye(3))[which]
        return before[:, which]

    return of_angles


def _transpose(C):
    return C.T


def _component(i: int):
    return lambda v: v[i]


def _structure() -> dict[str, Any]:
    rotations = ("C_b2n", "Ĉ_b2n", "C_n2n'", "C_b2n'", "C_b'2n", "C_b'2b", "C_r2n")
    rules: dict[str, Any] = dict.fromkeys(rotations, rotation)
    rules |= {"I": lambda generator: eye(3), "C_b2b": lambda generator: eye(3)}
    for name, inverse in (("C_n2b", "C_b2n"), ("C_n'2n", "C_n2n'"), ("C_n2r", "C_r2n"), ("C_b2b'", "C_b'2b")):
        rules[name] = of(inverse, _transpose)
    for name, parts in (("ε", "ε_n|ε_e|ε_d"), ("β", "β_x|β_y|β_z"), ("ω_in_n", "ω_n|ω_e|ω_d")):
        rules[name] = of(parts, vector)
    for name in ("μ", "μ\u0302", "δμ"):
        rules[name] = of("|".join(f"{name}_{axis}" for axis in "xyz"), vector)
    for name, of_vector in (("E", "ε"), ("B", "β"), ("Ω_in_n", "ω_in_n"), ("E\u0307", "ε\u0307")):
        rules[name] = of(of_vector, skew)
    for i, (angle, word) in enumerate((("φ", "roll"), ("θ", "pitch"), ("ψ", "yaw"))):
        rules[f"∂C/∂{angle}"] = of("φ|θ|ψ", change(i))
        rules[f"u_{angle}"] = of("θ|ψ", axis(i))
        rules[f"Z_{word}"] = of("Z", _component(i))
    rules["ε_o"] = of("ε", norm)
    rules |= {"ΔQ": of("C_n'2n", quaternion), "ΔQ(k)": of("E", lambda E: quaternion(E.exp()))}
    rules |= {"Q̂(k+)": of("C_b2n", quaternion), "Q̂(k-)": of("Ĉ_b2n", quaternion)}
    rules |= {f"Δq_{i}": of("ΔQ", _component(i)) for i in range(4)}
    rules |= {f"q\u0302_{i}": of("Q̂(k-)", _component(i)) for i in range(4)}
    rules |= {f"X_{i + 1}": of("X", _component(i)) for i in range(6)}
    return {normalize("NFC", name): rule for name, rule in rules.items()}


STRUCTURE = _structure()
