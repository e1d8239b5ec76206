"""Strapdown navigation and its errors, each row a statement of ours and its derivation from exact kinematics.

The first-order matrices are what SymPy's differentiation of exact rates gives, in kinematics.py; the functions that
make the C are held against them by the maps, in maps.py.
"""

from functools import cache

from boresight.derive.ledger.ellipsoid import LEVELS as BY_NAME
from boresight.derive.ledger.equation import Equation
from boresight.derive.ledger.lines import (
    EXACT_LINE,
    Derived,
    build,
    derived,
    first_order,
    line,
)
from boresight.derive.ledger.passages import (
    add,
    chain,
    differentiate,
    expand,
    multiply,
    multiply_out,
    rearrange,
    substitute,
    subtract_line,
    take_vector,
)
from boresight.derive.papers.mechanics import kinematics
from boresight.derive.papers.mechanics.letters import quantities

NAME = "mechanics"

PRINTED: dict[str, tuple[str, ...]] = {
    "strapdown-1": (
        r"\dot{p} = [\frac{v_N}{R_N + h}; \frac{v_E}{(R_E + h) \cos L}; v_U]",
        r"\dot{v}^n = C_b^n f^b + g^n - (2 \omega_{ie}^n + \omega_{en}^n) \times v^n",
        r"\dot{C}_b^n = C_b^n [\omega_{ib}^b \times] - [\omega_{in}^n \times] C_b^n",
    ),
    "phi-1": (
        r"\delta\dot{v}^n = f^n \times \phi - (2 \omega_{ie}^n + \omega_{en}^n) \times \delta v^n "
        r"- (2 \delta\omega_{ie}^n + \delta\omega_{en}^n) \times v^n + \delta g^n + C_b^n \delta f^b",
    ),
    "phi-2": (
        r"\dot{\phi} = -\omega_{in}^n \times \phi + \delta\omega_{ie}^n + \delta\omega_{en}^n "
        r"- C_b^n \delta\omega_{ib}^b",
    ),
    "phi-3": (
        r"F_{\phi}^{NED} = \begin{bmatrix} P_p & D & 0 \\ G_p + [v^n \times] (2 \Omega_p + W_p) & [v^n \times] W_v "
        r"- [(2 \omega_{ie}^n + \omega_{en}^n) \times] & [f^n \times] \\ \Omega_p + W_p & W_v & "
        r"-[\omega_{in}^n \times] \end{bmatrix}",
    ),
    "phi-4": (r"F_{\phi}^{ENU} = \Pi F_{\phi}^{NED} \Pi^T",),
    "phi-5": (r"G^{NED} = \begin{bmatrix} O_3 & 0 \\ 0 & C_b^n \\ -C_b^n & 0 \end{bmatrix}",),
    "psi-1": (
        r"\delta\dot{v}^c = f^n \times \psi - (2 \omega_{ie}^n + \omega_{en}^n) \times \delta v^c + \delta g^c "
        r"+ C_b^n \delta f^b",
    ),
    "psi-2": (r"\dot{\psi} = -\omega_{in}^n \times \psi - C_b^n \delta\omega_{ib}^b",),
    "psi-3": (
        r"F_{\psi}^{NED} = \begin{bmatrix} P_p + D [v^n \times] \Theta & D & 0 \\ G_p - [g^n \times] \Theta & "
        r"-[(2 \omega_{ie}^n + \omega_{en}^n) \times] & [f^n \times] \\ 0 & 0 & -[\omega_{in}^n \times] \end{bmatrix}",
    ),
    "psi-4": (r"F_{\psi}^{ENU} = \Pi F_{\psi}^{NED} \Pi^T",),
    "map-1": (
        r"\delta v^c = \delta v^n + \delta\theta \times v^n",
        r"\psi = \phi - \delta\theta",
    ),
    "map-2": (r"T^{NED} = \begin{bmatrix} I & 0 & 0 \\ -[v^n \times] \Theta & I & 0 \\ -\Theta & 0 & I \end{bmatrix}",),
    "map-3": (r"T^{ENU} = \Pi T^{NED} \Pi^T",),
    "map-4": (r"F_{\psi}^{NED} = T^{NED} F_{\phi}^{NED} (T^{NED})^{-1} + \dot{T}^{NED} (T^{NED})^{-1}",),
    "alignment-1": (
        r"F_{16} = \begin{bmatrix} -[\omega_{in}^n \times] & W_v & C_b^n & O_3 & O_3 & 0 \\ [f^n \times] & "
        r"[v^n \times] W_v - [(2 \omega_{ie}^n + \omega_{en}^n) \times] & 0 & -C_b^n & 0 & 0 \\ "
        r"O_3 & 0 & 0 & 0 & 0 & 0 \\ O_3 & 0 & 0 & 0 & 0 & 0 \\ O_3 & 0 & 0 & 0 & 0 & 0 \\ 0 & 0 & 0 & 0 & 0 & 0 "
        r"\end{bmatrix}",
    ),
    "alignment-2": (
        r"H_v = \begin{bmatrix} [\omega_{in}^n \times] [r \times] - [u \times] & I & -C_b^n [\ell^b \times] & O_3 & "
        r"O_3 & -a^n \end{bmatrix}",
    ),
    "alignment-3": (r"H_a = \begin{bmatrix} -I & O_3 & O_3 & O_3 & C_m^n & -\omega_{nb}^n \end{bmatrix}",),
    "euler-1": (
        r"H_e = -\begin{bmatrix} \frac{\cos\psi_m}{\cos\theta_m} & \frac{\sin\psi_m}{\cos\theta_m} & 0 \\ -\sin\psi_m "
        r"& \cos\psi_m & 0 \\ \tan\theta_m \cos\psi_m & \tan\theta_m \sin\psi_m & 1 \end{bmatrix} "
        r"\begin{bmatrix} I & C_b^n J_\mu \end{bmatrix}",
    ),
    "transition-1": (r"\Phi = I_9 + F \Delta t + \frac{1}{2} F F \Delta t \Delta t",),
    "transition-2": (
        r"Q = S \Delta t + \frac{1}{2} (F S + S F^T) \Delta t \Delta t "
        r"+ \frac{1}{6} (F F S + 2 F S F^T + S F^T F^T) \Delta t \Delta t \Delta t",
    ),
}


def rates() -> Derived:
    """strapdown-1: from the velocity in Earth's axes, which turn with the Earth."""
    return derived(
        line(r"\dot{p} = D v^n", EXACT_LINE, "the coordinates' rates by how far each moves the place"),
        line(r"D v^n = [\frac{v_N}{R_N + h}; \frac{v_E}{(R_E + h) \cos L}; v_U]", EXACT_LINE,
             "the point of the ellipse moves by its radii of curvature"),
        line(r"\dot{p} = [\frac{v_N}{R_N + h}; \frac{v_E}{(R_E + h) \cos L}; v_U]", EXACT_LINE, "both",
             chain("1", "2"), result=True),
        line(r"\dot{r}^e = C_n^e v^n", EXACT_LINE, "the velocity is over the ground, resolved in n"),
        line(r"\ddot{r}^e = \dot{C}_n^e v^n + C_n^e \dot{v}^n", EXACT_LINE, "n turns as one moves",
             differentiate({r"\dot{r}^e": r"\ddot{r}^e", "C_n^e": r"\dot{C}_n^e", "v^n": r"\dot{v}^n"})),
        line(r"\dot{C}_n^e = C_n^e [\omega_{en}^n \times]", EXACT_LINE, "the transport rate"),
        line(r"\ddot{r}^e = f^e + g^e - 2 \omega_{ie}^e \times \dot{r}^e", EXACT_LINE,
             "Newton's law in axes that turn with the Earth; gravity has the centrifugal part"),
        line(r"f^e = C_n^e C_b^n f^b", EXACT_LINE, "the accelerometers stand in the body"),
        line(r"g^e = C_n^e g^n", EXACT_LINE, "gravity in n"),
        line(r"\omega_{ie}^e = C_n^e \omega_{ie}^n", EXACT_LINE, "the Earth's rate in n"),
        line(r"\ddot{r}^e = C_n^e C_b^n f^b + C_n^e g^n - 2 (C_n^e \omega_{ie}^n) \times (C_n^e v^n)", EXACT_LINE,
             "all in n", substitute("8", "9", "10", "4", of="7")),
        line(r"C_n^e [\omega_{en}^n \times] v^n + C_n^e \dot{v}^n = \ddot{r}^e", EXACT_LINE, "the left side in n",
             substitute("6", of="5")),
        line(r"(C_n^e)^T \ddot{r}^e = C_b^n f^b + g^n - 2 \omega_{ie}^n \times v^n", EXACT_LINE,
             "a rotation turns a cross product with its factors", multiply(left="(C_n^e)^T", of="11")),
        line(r"\omega_{en}^n \times v^n + \dot{v}^n = (C_n^e)^T \ddot{r}^e", EXACT_LINE, "likewise",
             multiply(left="(C_n^e)^T", of="12")),
        line(r"\omega_{en}^n \times v^n + \dot{v}^n = C_b^n f^b + g^n - 2 \omega_{ie}^n \times v^n", EXACT_LINE,
             "both are the acceleration over the ground", chain("13", "14")),
        line(r"\dot{v}^n = C_b^n f^b + g^n - (2 \omega_{ie}^n + \omega_{en}^n) \times v^n", EXACT_LINE,
             "the transport rate changes sides", add(r"-\omega_{en}^n \times v^n"), result=True),
        line(r"\dot{C}_b^n = C_b^n [\omega_{ib}^b \times] - [\omega_{in}^n \times] C_b^n", EXACT_LINE,
             "the body turns on its side, the level on the other", result=True),
        unit="m/s^2",
    )  # fmt: skip


def velocity() -> Derived:
    """phi-1"""
    turn = r"\exp([-\phi \times])"
    computed = (
        rf"\dot{{v}}^n + \delta\dot{{v}}^n = {turn} (f^n + C_b^n \delta f^b) + g^n + \delta g^n "
        r"- (2 \omega_{ie}^n + 2 \delta\omega_{ie}^n + \omega_{en}^n + \delta\omega_{en}^n) \times (v^n + \delta v^n)"
    )
    return derived(
        line(r"\dot{v}^n = f^n + g^n - (2 \omega_{ie}^n + \omega_{en}^n) \times v^n", EXACT_LINE,
             "Newton's law on the turning ellipsoid"),
        line(r"\dot{\hat{v}}^n = \hat{f}^n + \hat{g}^n - (2 \hat{\omega}_{ie}^n + \hat{\omega}_{en}^n) "
             r"\times \hat{v}^n", EXACT_LINE, "the navigator computes the same of what it has"),
        line(rf"\hat{{f}}^n = {turn} (f^n + C_b^n \delta f^b)", EXACT_LINE,
             "the error of the attitude turns what the accelerometers show"),
        line(r"\hat{v}^n = v^n + \delta v^n", EXACT_LINE, "error = computed - true"),
        line(r"\dot{\hat{v}}^n = \dot{v}^n + \delta\dot{v}^n", EXACT_LINE, "and of its rate",
             differentiate({r"\hat{v}^n": r"\dot{\hat{v}}^n", "v^n": r"\dot{v}^n",
                            r"\delta v^n": r"\delta\dot{v}^n"})),
        line(r"\hat{g}^n = g^n + \delta g^n", EXACT_LINE, "gravity at the computed position"),
        line(r"\hat{\omega}_{ie}^n = \omega_{ie}^n + \delta\omega_{ie}^n", EXACT_LINE, "the Earth's rate there"),
        line(r"\hat{\omega}_{en}^n = \omega_{en}^n + \delta\omega_{en}^n", EXACT_LINE, "the transport rate there"),
        line(computed, EXACT_LINE, "what is computed, by truth and errors",
             substitute("3", "4", "5", "6", "7", "8", of="2")),
        line(r"\delta\dot{v}^n = " + computed.partition("=")[2].replace("g^n + ", "", 1)
             + r" - f^n + (2 \omega_{ie}^n + \omega_{en}^n) \times v^n", EXACT_LINE, "less what is true",
             subtract_line("1")),
        line(r"\delta\dot{v}^n = f^n \times \phi - (2 \omega_{ie}^n + \omega_{en}^n) \times \delta v^n "
             r"- (2 \delta\omega_{ie}^n + \delta\omega_{en}^n) \times v^n + \delta g^n + C_b^n \delta f^b",
             first_order(), "products of errors are left out",
             expand(r"\phi", r"\delta f^b", r"\delta g^n", r"\delta v^n", r"\delta\omega_{ie}^n",
                    r"\delta\omega_{en}^n", r"\delta\dot{v}^n"), result=True),
        unit="m/s^2",
    )  # fmt: skip


def attitude() -> Derived:
    """phi-2"""
    return derived(
        line(r"E = \hat{C}_b^n (C_b^n)^T", EXACT_LINE, "from the true attitude to the computed one"),
        line(r"\dot{E} = \dot{\hat{C}}_b^n (C_b^n)^T + \hat{C}_b^n (\dot{C}_b^n)^T", EXACT_LINE, "as both turn",
             differentiate({"E": r"\dot{E}", r"\hat{C}_b^n": r"\dot{\hat{C}}_b^n", "C_b^n": r"\dot{C}_b^n"})),
        line(r"\dot{C}_b^n = C_b^n [\omega_{ib}^b \times] - [\omega_{in}^n \times] C_b^n", EXACT_LINE,
             "the body turns on its side, the level on the other"),
        line(r"\dot{\hat{C}}_b^n = \hat{C}_b^n [\hat{\omega}_{ib}^b \times] - [\hat{\omega}_{in}^n \times] \hat{C}_b^n",
             EXACT_LINE, "the navigator computes the same of what it has"),
        line(r"\hat{\omega}_{ib}^b = \omega_{ib}^b + \delta\omega_{ib}^b", EXACT_LINE, "the gyros err"),
        line(r"\hat{\omega}_{in}^n = \omega_{in}^n + \delta\omega_{in}^n", EXACT_LINE, "the computed level errs"),
        line(r"\hat{C}_b^n = E C_b^n", EXACT_LINE, "the computed attitude is the true one, turned"),
        line(r"\dot{E} = E C_b^n [(\omega_{ib}^b + \delta\omega_{ib}^b) \times] (C_b^n)^T - [(\omega_{in}^n + "
             r"\delta\omega_{in}^n) \times] E C_b^n (C_b^n)^T + E C_b^n (C_b^n [\omega_{ib}^b \times] - "
             r"[\omega_{in}^n \times] C_b^n)^T", EXACT_LINE, "both rates",
             substitute("5", "6", "7", "4", "3", of="2")),
        line(r"\dot{E} = E [(C_b^n \delta\omega_{ib}^b) \times] - [(\omega_{in}^n + \delta\omega_{in}^n) \times] E "
             r"+ E [\omega_{in}^n \times]", EXACT_LINE, "the body's own rate cancels", multiply_out()),
        line(r"E = \exp([-\phi \times])", EXACT_LINE, "the attitude error"),
        line(r"\dot{E} = \exp([-\phi \times]) [(C_b^n \delta\omega_{ib}^b) \times] - [(\omega_{in}^n + "
             r"\delta\omega_{in}^n) \times] \exp([-\phi \times]) + \exp([-\phi \times]) [\omega_{in}^n \times]",
             EXACT_LINE, "put in", substitute("10", of="9")),
        line(r"\dot{E} = [(C_b^n \delta\omega_{ib}^b) \times] - [\delta\omega_{in}^n \times] + [\omega_{in}^n \times] "
             r"[\phi \times] - [\phi \times] [\omega_{in}^n \times]", first_order(), "a small error",
             expand(r"\phi", r"\delta\omega_{ib}^b", r"\delta\omega_{in}^n", r"\dot{E}")),
        line(r"\dot{E} = -[\dot{\phi} \times]", first_order(), "to first order E is I - [φ x]"),
        line(r"-[\dot{\phi} \times] = [(C_b^n \delta\omega_{ib}^b) \times] - [\delta\omega_{in}^n \times] + "
             r"[\omega_{in}^n \times] [\phi \times] - [\phi \times] [\omega_{in}^n \times]", first_order(),
             "both", substitute("13", of="12")),
        line(r"-\dot{\phi} = C_b^n \delta\omega_{ib}^b - \delta\omega_{in}^n + \omega_{in}^n \times \phi",
             first_order(), "of the skew matrices their vectors: [a x][b x] - [b x][a x] = [(a x b) x]",
             take_vector()),
        line(r"\dot{\phi} = -\omega_{in}^n \times \phi + \delta\omega_{ie}^n + \delta\omega_{en}^n "
             r"- C_b^n \delta\omega_{ib}^b", first_order(), "with the other sign; the level's rate is the sum of both",
             multiply(left="-1"), result=True),
        unit="rad/s",
    )  # fmt: skip


def against_computed_velocity() -> Derived:
    """psi-1: from phi-1 by the map."""
    return derived(
        line(r"\delta v^c = \delta v^n + \delta\theta \times v^n", first_order(), "by the map"),
        line(r"\delta\dot{v}^c = \delta\dot{v}^n + \delta\dot{\theta} \times v^n + \delta\theta \times \dot{v}^n",
             first_order(), "as they change",
             differentiate({r"\delta v^c": r"\delta\dot{v}^c", r"\delta v^n": r"\delta\dot{v}^n",
                            r"\delta\theta": r"\delta\dot{\theta}", "v^n": r"\dot{v}^n"})),
        line(r"\delta\dot{\theta} = \delta\omega_{en}^n - \omega_{en}^n \times \delta\theta", first_order(),
             "the computed level turns at the computed transport rate"),
        line(r"(C_b^n)^T \delta\omega_{ie}^n = (C_b^n)^T (\omega_{ie}^n \times \delta\theta)", first_order(),
             "the Earth's rate is one, here seen in the body: its components turn with the level"),
        line(r"(C_b^n)^T \delta g^n = (C_b^n)^T (\delta g^c - \delta\theta \times g^n)", first_order(),
             "gravity turns with the level, here seen in the body"),
        line(r"\dot{v}^n = f^n + g^n - (2 \omega_{ie}^n + \omega_{en}^n) \times v^n", EXACT_LINE, "Newton's law"),
        line(r"\delta v^n = \delta v^c - \delta\theta \times v^n", first_order(), "the map, turned round",
             add(r"-\delta\theta \times v^n", of="1")),
        line(r"\phi = \psi + \delta\theta", first_order(), "the map, turned round"),
        line(r"\delta\dot{v}^c = f^n \times (\psi + \delta\theta) - (2 \omega_{ie}^n + \omega_{en}^n) \times "
             r"(\delta v^c - \delta\theta \times v^n) - (2 \omega_{ie}^n \times \delta\theta + \delta\omega_{en}^n) "
             r"\times v^n + \delta g^c - \delta\theta \times g^n + C_b^n \delta f^b + "
             r"(\delta\omega_{en}^n - \omega_{en}^n \times \delta\theta) \times v^n + "
             r"\delta\theta \times (f^n + g^n - (2 \omega_{ie}^n + \omega_{en}^n) \times v^n)",
             first_order(), "all by the errors against c",
             substitute("4", "5", "8", "3", "7", "6", "(phi-1)", of="2",
                        letters=(r"\delta\omega_{ie}^n", r"\delta g^n"))),
        line(r"\delta\dot{v}^c = f^n \times \psi - (2 \omega_{ie}^n + \omega_{en}^n) \times \delta v^c + \delta g^c "
             r"+ C_b^n \delta f^b", first_order(), "by Jacobi's identity all else cancels", multiply_out(),
             result=True),
        unit="m/s^2",
    )  # fmt: skip


def against_computed_attitude() -> Derived:
    """psi-2: from phi-2 by the map."""
    return derived(
        line(r"\psi = \phi - \delta\theta", first_order(), "by the map"),
        line(r"\dot{\psi} = \dot{\phi} - \delta\dot{\theta}", first_order(), "as they change",
             differentiate({r"\psi": r"\dot{\psi}", r"\phi": r"\dot{\phi}", r"\delta\theta": r"\delta\dot{\theta}"})),
        line(r"\delta\dot{\theta} = \delta\omega_{en}^n - \omega_{en}^n \times \delta\theta", first_order(),
             "the computed level turns at the computed transport rate"),
        line(r"(C_b^n)^T \delta\omega_{ie}^n = (C_b^n)^T (\omega_{ie}^n \times \delta\theta)", first_order(),
             "the Earth's rate is one, here seen in the body: its components turn with the level"),
        line(r"\phi = \psi + \delta\theta", first_order(), "the map, turned round", add(r"\delta\theta", of="1")),
        line(r"\dot{\psi} = -\omega_{in}^n \times (\psi + \delta\theta) + \omega_{ie}^n \times \delta\theta "
             r"+ \omega_{en}^n \times \delta\theta - C_b^n \delta\omega_{ib}^b", first_order(), "put in",
             substitute("4", "3", "5", "(phi-2)", of="2", letters=(r"\delta\omega_{ie}^n",))),
        line(r"\dot{\psi} = -\omega_{in}^n \times \psi - C_b^n \delta\omega_{ib}^b", first_order(),
             "the computed level knows its own rate", multiply_out(), result=True),
        unit="rad/s",
    )  # fmt: skip


def map_of_errors() -> Derived:
    """map-1"""
    return derived(
        line(r"\exp([-\psi \times]) C_n^c = \exp([-\phi \times])", EXACT_LINE,
             "the computed attitude is one, whichever level it is held against"),
        line(r"C_n^c = \exp([-\delta\theta \times])", EXACT_LINE, "c is n, turned"),
        line(r"\exp([-\psi \times]) \exp([-\delta\theta \times]) = \exp([-\phi \times])", EXACT_LINE, "put in",
             substitute("2", of="1")),
        line(r"I - [\psi \times] - [\delta\theta \times] = I - [\phi \times]", first_order(), "small errors",
             expand(r"\psi", r"\delta\theta", r"\phi")),
        line(r"[\psi \times] = [\phi \times] - [\delta\theta \times]", first_order(), "terms change sides",
             rearrange()),
        line(r"\psi = \phi - \delta\theta", first_order(), "of the skew matrices their vectors", take_vector()),
        line(r"\delta v^c = \hat{v}^n - C_n^c v^n", EXACT_LINE, "against the true velocity carried into c"),
        line(r"\hat{v}^n = v^n + \delta v^n", EXACT_LINE, "against the true velocity, component by component"),
        line(r"\delta v^c = v^n + \delta v^n - \exp([-\delta\theta \times]) v^n", EXACT_LINE, "put in",
             substitute("8", "2", of="7")),
        line(r"\delta v^c = \delta v^n + \delta\theta \times v^n", first_order(), "small errors",
             expand(r"\delta\theta", r"\delta v^n", r"\delta v^c"), result=True),
        line(r"\psi = \phi - \delta\theta", first_order(), "as above", chain("6"), result=True),
        unit="rad",
    )  # fmt: skip


WHY = "the exact rates, errors put in by finite rotations, differentiated at no error"


def columns(letter: str, name: str) -> Derived:
    """Each column of a matrix, as SymPy's differentiation has it."""
    return derived(
        *(line(rf"{letter} e_{{{k}}} = \flown{{{name}:{k}}}", EXACT_LINE, WHY, result=True) for k in range(1, 10)),
        unit="1",
    )


class Differentiated(dict):
    """The columns of SymPy's matrices by name, as `F_phi:NED:1`; made when asked for."""

    def __missing__(self, name: str):
        function, level, column = name.split(":")
        return getattr(kinematics, function)(BY_NAME[level]).col(int(column) - 1)

    def __contains__(self, name: object) -> bool:
        return True


MATRICES = {
    "phi-3": (r"F_{\phi}^{NED}", "F_phi:NED"), "phi-4": (r"F_{\phi}^{ENU}", "F_phi:ENU"),
    "psi-3": (r"F_{\psi}^{NED}", "F_psi:NED"), "psi-4": (r"F_{\psi}^{ENU}", "F_psi:ENU"),
    "map-2": ("T^{NED}", "T_psi:NED"), "map-3": ("T^{ENU}", "T_psi:ENU"),
}  # fmt: skip


@cache
def equations() -> tuple[Equation, ...]:
    """All rows."""
    written = {
        **dict.fromkeys(PRINTED, derived(unit="1")),
        "strapdown-1": rates(),
        "phi-1": velocity(),
        "phi-2": attitude(),
        "psi-1": against_computed_velocity(),
        "psi-2": against_computed_attitude(),
        "map-1": map_of_errors(),
        **{number: columns(*matrix) for number, matrix in MATRICES.items()},
        "transition-1": derived(unit="1", small=("step",)),
        "transition-2": derived(unit="1", small=("step",)),
    }
    printed = {number: ((0, 0), latex) for number, latex in PRINTED.items()}
    return build(NAME, printed, written, quantities(), flown=Differentiated())
