"""The letters of the derivations that the paper does not print, how lines spell those that it spells alike, and what
letters are by their nature."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cache
from random import Random
from typing import Any
from unicodedata import normalize

from boresight.derive.ledger.equation import Quantity, letter
from boresight.derive.ledger.evaluate import assembled
from boresight.derive.ledger.free import Kind, of, positive, positive_number, rotation
from boresight.derive.ledger.numbers import Matrix, exact, eye, norm, zeros
from boresight.derive.ledger.witness import skew, vector
from boresight.derive.papers.kim_2018.printed import quantities

# On the page a vector and its skew matrix, or a matrix of both filters, are one letter; in a line each has its own.
SPELLED = {
    "f_n": "f^n",
    "[f_n x]": r"[f^n \times]",
    "δω_ie_n": r"\delta \omega_{ie}^n",
    "δω_en_n": r"\delta \omega_{en}^n",
    "[ω_ie_n x]": r"[\omega_{ie}^n \times]",
    "[ω_en_n x]": r"[\omega_{en}^n \times]",
    "[δω_ie_n x]": r"[\delta \omega_{ie}^n \times]",
    "[δω_en_n x]": r"[\delta \omega_{en}^n \times]",
    "δv̇_c": r"\dot{\delta v}^n",
    "F_X": "F",
    "H_X": "H",
    "H_v": "H_v",
    "z_v": "z_v",
    "ν_z": r"\nu_z",
    "ν": r"\nu_k",
    "z": "z_k",
    "l": "l",
    "ν_y": r"\nu_y",
    "I_15x15": r"I_{15 \times 15}",
    "I": "I",
    "Q_k": "Q_k",
    "Q_b2n": "Q",
    "index": "i",
}

V3, M3, SCALAR = (3,), (3, 3), ()
# kind, shape, and its letters: name, LaTeX, meaning
ADDED: tuple[tuple[str, tuple[int, ...], tuple[tuple[str, str, str], ...]], ...] = (
    ("velocity", V3, (
        ("v̂", r"\hat{v}^n", "computed velocity, m/s"),
        ("v_old", "v_{old}^n", "true velocity when the master's data was taken, m/s"),
    )),
    ("acceleration", V3, (
        ("v̂̇", r"\dot{\hat{v}}^n", "rate of the computed velocity, m/s^2"),
        ("v̂̇_c", r"\dot{\hat{v}}^c", "rate of the computed velocity where the position is known, m/s^2"),
        ("g_n", "g^n", "gravity, m/s^2"),
        ("ĝ_n", r"\hat{g}^n", "gravity where one believes to be, m/s^2"),
    )),
    ("force in body axes", V3, (
        ("f_b", "f^b", "specific force, m/s^2"),
        ("f̂_b", r"\hat{f}^b", "what the accelerometers show, m/s^2"),
        ("w_f", "w_f", "noise of the accelerometers, m/s^2"),
    )),
    ("rate in body axes", V3, (
        ("ω_ib_b", r"\omega_{ib}^b", "angular rate, rad/s"),
        ("ω̂_ib_b", r"\hat{\omega}_{ib}^b", "what the gyros show, rad/s"),
        ("w_ω", r"w_\omega", "noise of the gyros, rad/s"),
    )),
    ("rate of n", V3, (
        ("ω_ie_n", r"\omega_{ie}^n", "the Earth's rate, rad/s"),
        ("ω_en_n", r"\omega_{en}^n", "the transport rate, rad/s"),
        ("ω_in_n", r"\omega_{in}^n", "rate of n against inertial space, rad/s"),
        ("ω̂_ie_n", r"\hat{\omega}_{ie}^n", "the Earth's rate where one believes to be, rad/s"),
        ("ω̂_en_n", r"\hat{\omega}_{en}^n", "the transport rate of the computed state, rad/s"),
        ("ω̂_in_n", r"\hat{\omega}_{in}^n", "their sum, rad/s"),
        ("δω_in_n", r"\delta \omega_{in}^n", "error of the rate of n, rad/s"),
        ("ω̂_en_c", r"\hat{\omega}_{en}^c", "the transport rate of the computed velocity at the known position, rad/s"),
        ("ω̂_in_c", r"\hat{\omega}_{in}^c", "rate of the computed axes there, rad/s"),
        ("ω_nr_n", r"\omega_{nr}^n", "rate of the master against n, rad/s"),
    )),
    ("attitude", M3, (
        ("C_n2b", "C_n^b", "true attitude, transposed"),
        ("Ĉ_b2n", r"\hat{C}_b^n", "computed attitude"),
        ("Ĉ_b2c", r"\hat{C}_b^c", "computed attitude where the position is known, to the computed axes"),
        ("C_n2c", "C_n^c", "true axes to computed ones"),
        ("C_c2n", "C_c^n", "computed axes to true ones"),
        ("C_b2r", "C_b^r", "true mounting: b to r"),
        ("C_n2r", "C_n^r", "true attitude of the master, transposed"),
    )),
    ("attitude rate", M3, (
        ("Ċ_b2n", r"\dot{C}_b^n", "rate of the true attitude, 1/s"),
        ("Ċ_n2b", r"\dot{C}_n^b", "the same, transposed, 1/s"),
        ("Ĉ̇_b2n", r"\dot{\hat{C}}_b^n", "rate of the computed attitude, 1/s"),
        ("Ĉ̇_b2c", r"\dot{\hat{C}}_b^c", "the same where the position is known, 1/s"),
        ("Ċ_n2c", r"\dot{C}_n^c", "rate of the computed axes against the true ones, 1/s"),
        ("Ċ_c2n", r"\dot{C}_c^n", "the same, transposed, 1/s"),
    )),
    ("slope of rates", M3, (
        ("W_ie", "W_{ie}", "the Earth's rate by position"),
        ("W_ep", "W_{ep}", "transport rate by position"),
        ("W_ev", "W_{ev}", "transport rate by velocity, 1/m"),
    )),
    ("slope of gravity", M3, (("W_g", "W_g", "gravity by position"),)),
    ("block of F", M3, (
        ("A_vp", "A_{vp}", "rate of the velocity error by position"),
        ("A_vv", "A_{vv}", "rate of the velocity error by velocity, 1/s"),
        ("A_φp", r"A_{\phi p}", "rate of the attitude error by position, 1/s"),
        ("A_φφ", r"A_{\phi\phi}", "rate of the attitude error by attitude, 1/s"),
    )),
    ("slope of coordinates", M3, (
        ("A_p", "A_p", "rates of the coordinates by position, 1/s"),
        ("A_v", "A_v", "rates of the coordinates by velocity"),
    )),
    ("coordinate rate", SCALAR, (
        ("l̇", r"\dot{l}", "rate of the longitude, rad/s"),
        ("L̇", r"\dot{L}", "rate of the latitude, rad/s"),
    )),
    ("height rate", SCALAR, (("ḣ", r"\dot{h}", "rate of the height, m/s"),)),
    ("rate by latitude", SCALAR, (
        ("∂l̇/∂L", r"\partial_L \dot{l}", "rate of the longitude by latitude, 1/s"),
        ("∂L̇/∂L", r"\partial_L \dot{L}", "rate of the latitude by latitude, 1/s"),
    )),
    ("rate by height", SCALAR, (
        ("∂l̇/∂h", r"\partial_h \dot{l}", "rate of the longitude by height, rad/s/m"),
        ("∂L̇/∂h", r"\partial_h \dot{L}", "rate of the latitude by height, rad/s/m"),
    )),
    ("rate by velocity", SCALAR, (
        ("∂l̇/∂v", r"\partial_v \dot{l}", "rate of the longitude by the velocity east, rad/m"),
        ("∂L̇/∂v", r"\partial_v \dot{L}", "rate of the latitude by the velocity north, rad/m"),
    )),
    ("master's quaternion", (4,), (
        ("q_r2n", "q_r^n", "true attitude of the master"),
        ("q̂_r2n", r"\hat{q}_r^n", "attitude of the master as it arrives"),
    )),
    ("mounting vector", V3, (("μ̂", r"\hat{\mu}", "rotation vector of the estimated mounting, rad"),)),
    ("15x6", (15, 6), (("Γ_k", r"\Gamma_k", "how errors of gyros and accelerometers enter the rates"),)),
    ("states", (15,), (
        ("ξ_k-1", r"\xi_{k-1}", "the errors at the step before, random: mean and covariance are the filter's"),
        ("ξ_k", r"\xi_k", "the errors before the update, random: mean and covariance are the filter's"),
        ("η", r"\eta_{k-1}", "what white noise adds over the step, random"),
    )),
    ("measurement", (4,), (("ζ", r"\zeta_k", "noise of the measurement, random"),)),
    ("15x15", (15, 15), (
        ("Ṗ", r"\dot{P}_{k-1}", "rate of the covariance at the step's start"),
        ("W", "W", "density of the process noise"),
    )),
    ("quaternion", (4,), (
        ("V", "V", "rotation by -φ"),
        ("V̄", r"\bar{V}", "its conjugate"),
    )),
    ("cost", (1,), (("J", "J", "weighted squares"), ("J̇", r"\dot{J}", "their rate of change along u"))),
    ("direction", (15,), (("u", "u", "any change of the states"),)),
    ("spread", M3, (("S_a", "S_a", "covariance of the window, m^2/s^4"),)),
    ("turn", V3, (("ȳ_w", r"\bar{y}_n^w", "mean of the gyros over the window, rad/s"),)),
    ("count", SCALAR, (("m", "m", "last sample of a window"),)),
)  # fmt: skip


@cache
def letters() -> tuple[Quantity, ...]:
    return tuple(_letters())


def _letters() -> Iterator[Quantity]:
    by_name = {quantity.symbol.name: quantity for quantity in quantities()}
    for kind, shape, listed in ADDED:
        for name, latex, meaning in listed:
            yield letter(name, latex, kind, meaning, shape)
    for name, latex in SPELLED.items():
        yield replace(by_name[normalize("NFC", name)], latex=latex)


# ---- What letters are by their nature --------------------------------------------------------------------------------


def transposed(C: Matrix) -> Matrix:
    return C.T


def over(*parts: Any) -> Matrix:
    return assembled([[part] for part in parts])


def conjugate(q: Matrix) -> Matrix:
    return vector(q[0], -q[1], -q[2], -q[3])


def drawn_quaternion(generator: Random) -> Matrix:
    q = Matrix([exact(generator.uniform(0.2, 1.2)) for _ in range(4)])
    return q / norm(q)


unit_quaternion = Kind(drawn_quaternion, lambda q: abs(norm(q) - 1) < 1e-28)
far_limit = Kind(lambda generator: exact(1000), lambda x: x > 0)


def moments(generator: Random) -> dict[str, list[Matrix]]:
    """Of each random letter the columns of a root of its covariance."""

    def root(size: int) -> list[Matrix]:
        return [Matrix([exact(generator.uniform(-1, 1)) for _ in range(size)]) for _ in range(size)]

    return {"ξ_k-1": root(15), "ξ_k": root(15), "η": root(15), "ζ": root(4)}


def constant(value: Any) -> Callable[[Random], Any]:
    return lambda generator: value


def _structure() -> Iterator[tuple[str, Any]]:
    for q in quantities():
        if q.kind == "block":
            yield q.symbol.name, constant(eye(q.shape[0]) if q.symbol.name[0] == "I" else zeros(*q.shape))
    yield from {"I": constant(eye(3)), "I_15x15": constant(eye(15))}.items()
    for name in ("C_b2n", "C̄_n2b", "C_r2n(k-δt)", "C_n2c", "C_b2r", "C_r2n", "Ĉ_r2n", "Ĉ_b2r", "Ĉ_n2b"):
        yield name, rotation
    for name, other in (
        ("C_n2b", "C_b2n"),
        ("C_c2n", "C_n2c"),
        ("C_n2r", "C_r2n"),
        ("Ċ_n2b", "Ċ_b2n"),
        ("Ċ_c2n", "Ċ_n2c"),
    ):
        yield name, of(other, transposed)
    for name in ("ω_ie_n", "ω_en_n", "δω_ie_n", "δω_en_n", "f_n"):
        yield f"[{name} x]", of(name, skew)
    yield from {
        "δv": of("δv_e|δv_n|δv_u", vector),
        "v": of("v_e|v_n|v_u", vector),
        "φ": of("φ_e|φ_n|φ_u", vector),
        "X": of("δv|φ|θ|Δt", over),
        "x_p": of("δl|δL|δh", vector),
        "x_v": of("δv_e|δv_n|δv_u", vector),
        "x_φ": of("φ_e|φ_n|φ_u", vector),
        "x": of("x_p|x_v|x_φ|x_Cb|x_Ab", over),
        "x_k": of("x_p|x_v|x_φ|x_Cb|x_Ab", over),
        "z_v": of("z", lambda z: z[0:3, 0]),
        "ν_z": of("ν", lambda noise: noise[0:3, 0]),
        "H_v": of("H_k", lambda H: H[0:3, :]),
        "P(k-)": positive(15),
        "R": positive(4),
        "Q̂_b2n": of("q_0|q_1|q_2|q_3", vector),
        "V": unit_quaternion,
        "V̄": of("V", conjugate),
        "random": moments,
        "T_a": positive_number,
        "N": constant(exact(3)),
        "n": constant(exact(2)),
        "γ_a": far_limit,
        "γ_w": far_limit,
    }.items()


STRUCTURE: Mapping[str, Any] = {
    normalize("NFC", name): replace(rule, letters=tuple(normalize("NFC", n) for n in rule.letters))
    if hasattr(rule, "letters")
    else rule
    for name, rule in _structure()
}

P, P_RATE = "2 rad, m", "2 rad/s, m/s"
X10, X10_RATE = "3 m/s, 3 rad, 3 rad, s", "3 m/s^2, 3 rad/s, 3 rad/s, 1"
X15, X15_RATE = f"{P}, 3 m/s, 3 rad, 3 rad/s, 3 m/s^2", f"{P_RATE}, 3 m/s^2, 3 rad/s, 3 rad/s^2, 3 m/s^3"
Z4 = "3 m/s, rad"
# Of letters, or kinds of them, with several units; of a matrix, the units of its rows by those of its columns.
UNITS = {
    "X": X10,
    "Ẋ": X10_RATE,
    "F_X": f"{X10_RATE} by {X10}",
    "H_X": f"3 m/s, 3 rad by {X10}",
    "x_p": P,
    "x_v": "3 m/s",
    "x_φ": "3 rad",
    "x_Cb": "3 rad/s",
    "x_Ab": "3 m/s^2",
    "states": X15,
    "ξ_k-1": X15,
    "state rates": X15_RATE,
    "W_ie": f"3 rad/s by {P}",
    "W_ep": f"3 rad/s by {P}",
    "W_g": f"3 m/s^2 by {P}",
    "A_vp": f"3 m/s^2 by {P}",
    "A_φp": f"3 rad/s by {P}",
    "A_v": f"{P_RATE} by 3 m/s",
    "A_p": f"{P_RATE} by {P}",
    "F_k": f"{X15_RATE} by {X15}",
    "Φ_k": f"{X15} by {X15}",
    "Φ_k-1": f"{X15} by {X15}",
    "H_v": f"3 m/s by {X15}",
    "H_k": f"{Z4} by {X15}",
    "measurement": Z4,
    "K_k": f"{X15} by {Z4}",
    "u": X15,
    "covariance": f"{X15} times {X15}",
    "Q_k": f"{X15} times {X15}",
    "Ṗ": f"{X15_RATE} times {X15}",
    "W": f"{X15_RATE} times {X15}",
    "R": f"{Z4} times {Z4}",
    "outputs": "3 m/s^2, 3 rad/s",
    "Ω_n": "3 m/s^2, 3 rad/s",
}
