"""The steady heading error of a transfer alignment that does not know how old its master's data is.

The master's data is old by tau > 0 and the filter believes that it is not.  All over a swinging hull the attitude
residual then carries the turn of the last tau seconds, and the filter has one constant with which to explain it: a
misalignment about the vertical, which mixes roll and pitch.  What is derived here is where its estimate goes.

Conventions of the model velocity-attitude: NED, error = computed - true, C_hat_b2n = (I - [phi x]) C_b2n,
C_hat_b2m = (I - [dmu x]) C_b2m with dmu in master axes.  Heading errors are yaw_hat - yaw = -phi_d.
Roll, pitch and yaw here are their parts about the mean.
"""

from functools import cache

from sympy import Function, ImmutableMatrix, Integer, Symbol

from boresight.derive.ledger.equation import Equation, Quantity, letter
from boresight.derive.ledger.free import of, rotation
from boresight.derive.ledger.lines import (
    DEFINITION,
    EXACT_LINE,
    IDENTITY,
    build,
    derived,
    first_order,
    line,
    of_order,
)
from boresight.derive.ledger.numbers import Matrix, exact, eye, sqrt, zeros
from boresight.derive.ledger.passages import (
    add,
    differentiate,
    elsewhere,
    expand,
    find_minimum,
    multiply,
    multiply_out,
    put_in,
    solve_for,
    substitute,
    take_rows,
    take_vector,
)
from boresight.derive.ledger.witness import finite_rotation, uniform, vector
from boresight.derive.papers.delay_error.witness import MOVING
from boresight.derive.papers.kang_2025.results import attitude_matrix

NAME = "delay-error"


@cache
def quantities() -> tuple[Quantity, ...]:
    """Every letter, with LaTeX, kind and meaning."""
    vectors = (
        ("z", "z_{DCM}", "rotation vector", "turn of the expected attitude from the reported, rad"),
        ("φ", r"\phi", "rotation vector", "error of the slave's attitude, rad"),
        ("δμ", r"\delta\mu", "rotation vector", "error of the misalignment, in master axes, rad"),
        ("φ̂", r"\hat{\phi}", "rotation vector", "φ of least squares, rad"),
        ("μ̂", r"\hat{\mu}", "rotation vector", "δμ of least squares, rad"),
        ("φ̂_0", r"\hat{\phi}_0", "rotation vector", "φ of least squares, the yaw at rest, rad"),
        ("μ̂_0", r"\hat{\mu}_0", "rotation vector", "δμ of least squares, the yaw at rest, rad"),
        ("e", "e", "swing", "roll, pitch and yaw about their means, rad"),
        ("ė", r"\dot{e}", "rate", "its rate of change, rad/s"),
        ("e_0", "e_0", "swing", "the swing where the yaw is at rest, rad"),
        ("ė_0", r"\dot{e}_0", "rate", "its rate of change, rad/s"),
        ("ω", r"\omega", "rate", "rate of the hull against the level, rad/s"),
        ("ω_e", r"\omega_e", "rate", "the same in level axes along the heading, rad/s"),
        ("v", "v", "velocity", "horizontal velocity of the hull, m/s"),
        ("v_old", r"v_{-\tau}", "velocity", "the same τ before, m/s"),
        ("δv", r"\delta v", "velocity", "error of the slave's velocity, m/s"),
        ("a", "a", "acceleration", "rate of change of the velocity, m/s^2"),
        ("δv̇", r"\delta \dot{v}", "acceleration", "rate of change of δv, m/s^2"),
        ("z_v", "z_v", "velocity", "computed velocity less the reported, m/s"),
        ("d", "d", "direction", "any direction"),
        ("c", "c", "direction", "any constant"),
    )
    matrices = (
        ("C", "C", "attitude", "attitude of the master, master to level"),
        ("C_ψ", r"C_\psi", "attitude", "turn about the vertical by the heading"),
        ("C_e", "C_e", "attitude", "attitude of the master about the heading"),
        ("Ċ_e", r"\dot{C}_e", "rate of attitude", "its rate of change, 1/s"),
        ("I", "I", "identity", "identity"),
    )
    scalars = (
        ("τ", r"\tau", "time", "by how much the master's data is old, s"),
        ("r", "r", "angle", "roll, rad"),
        ("p", "p", "angle", "pitch, rad"),
        ("s", "s", "angle", "yaw, rad"),
        ("r_0", "r_0", "angle", "roll, the yaw at rest, rad"),
        ("p_0", "p_0", "angle", "pitch, the yaw at rest, rad"),
        ("ṙ_0", r"\dot{r}_0", "rate", "rate of roll, rad/s"),
        ("ṗ_0", r"\dot{p}_0", "rate", "rate of pitch, rad/s"),
        ("μ̂_x", r"\hat{\mu}_x", "angle", "first component of μ̂_0, rad"),
        ("μ̂_y", r"\hat{\mu}_y", "angle", "second component of μ̂_0, rad"),
        ("μ̂_z", r"\hat{\mu}_z", "angle", "third component of μ̂_0, rad"),
        ("μ̂_v", r"\hat{\mu}_v", "angle", "the same where the velocity is matched too, rad"),
        ("φ̂_d", r"\hat{\phi}_d", "angle", "third component of φ̂_0, rad"),
        ("φ_d", r"\phi_d", "angle", "third component of φ, rad"),
        ("δψ", r"\delta\psi", "angle", "error of the heading, rad"),
        ("ψ", r"\psi", "angle", "heading, rad"),
        ("ε", r"\epsilon", "angle", "by how much pitch leads roll, rad"),
        ("R", "R", "amplitude", "amplitude of roll, rad"),
        ("P", "P", "amplitude", "amplitude of pitch, rad"),
        ("ρ", r"\rho", "number", "ratio of the amplitudes"),
        ("Ω", r"\Omega", "frequency", "frequency of the swing, rad/s"),
        ("q_s", "q_s", "number", "sine of the phase, Ω t"),
        ("q_c", "q_c", "number", "cosine of the phase"),
        ("q̇_s", r"\dot{q}_s", "rate of a number", "rate of the sine, 1/s"),
        ("q̇_c", r"\dot{q}_c", "rate of a number", "rate of the cosine, 1/s"),
        ("v_n", "v_n", "speed", "velocity north, m/s"),
        ("v_e", "v_e", "speed", "velocity east, m/s"),
        ("a_n", "a_n", "acceleration north", "acceleration north, m/s^2"),
        ("a_e", "a_e", "acceleration north", "acceleration east, m/s^2"),
        ("σ_a", r"\sigma_a", "noise", "noise of an angle, rad"),
        ("σ_v", r"\sigma_v", "noise", "noise of a velocity, m/s"),
        ("J", "J", "cost", "mean square of the residual"),
        ("J_m", "J_m", "cost", "the share of its mean"),
        ("J_φ", r"J_\phi", "cost", "rate of the cost as φ̂ goes along d"),
        ("J_μ", r"J_\mu", "cost", "rate of the cost as μ̂ goes along d"),
    )
    return (
        *(letter(*one, (3,)) for one in vectors),
        *(letter(*one, (3, 3)) for one in matrices),
        *(letter(*one) for one in scalars),
        letter("x", "x", "states", "errors of the sixteen states", (16,)),
        letter("0", r"0_{9 \times 1}", "zero", "zeros", (9,)),
    )


def _level(*two) -> Matrix:
    return vector(*two, 0)


def _random(generator) -> dict:
    """Second moments of any size: three columns each."""
    share = 1 / sqrt(exact(2))

    def columns(count: int, sized) -> list[tuple]:
        return [tuple(sized() for _ in range(count)) for _ in range(3)]

    return {
        ("e", "ė"): columns(2, lambda: vector(*uniform(generator, 1))),
        MOVING: columns(len(MOVING), lambda: uniform(generator, 1)[0]),
        ("q_s", "q_c"): [(share, exact(0)), (exact(0), share)],
    }


STRUCTURE = {
    **dict.fromkeys(("C_e",), rotation),
    "C_ψ": of("ψ", lambda psi: finite_rotation([0, 0, psi])),
    "I": lambda generator: eye(3),
    "0": lambda generator: zeros(9, 1),
    "e_0": of("r_0|p_0", _level),
    "ė_0": of("ṙ_0|ṗ_0", _level),
    "v": of("v_n|v_e", _level),
    "a": of("a_n|a_e", _level),
    "μ̂_0": of("μ̂_x|μ̂_y|μ̂_z", vector),
    "φ̂_0": of("μ̂_x|μ̂_y|φ̂_d", vector),
    "random": _random,
    "mean": lambda generator: {
        **dict.fromkeys(("e", "ė"), zeros(3, 1)),
        **dict.fromkeys((*MOVING, "q_s", "q_c"), exact(0)),
    },
}
SEA = ("swing", "surge", "delay")


def entries(name: str, rows: int, columns: int = 1) -> ImmutableMatrix:
    """The matrix of a letter's entries, for a function that takes them one by one."""
    entry, symbol = Function("entry"), Symbol(name, commutative=False)
    return ImmutableMatrix(rows, columns, lambda i, j: entry(symbol, Integer(i + 1), Integer(j + 1)))


def residual():
    return derived(
        line(r"x = [\phi; 0_{9 \times 1}; \delta\mu; -\tau]", DEFINITION,
             "without compensation the estimate of the delay is zero, and its error minus the delay"),
        line(r"z_{DCM} = \flown{H} x", first_order("phi", "dmu", "delay"),
             "the measurement matrix of the model, at the true attitude and rate"),
        line(r"z_{DCM} = -\phi + C \delta\mu + \tau \omega", first_order("phi", "dmu", "delay"),
             "the columns of the model", substitute("1")),
        line(r"C = C_\psi C_e", EXACT_LINE, "roll, pitch and yaw about the heading"),
        line(r"\omega = C_\psi \omega_e", EXACT_LINE, "the rate turns with its axes"),
        line(r"z_{DCM} = -\phi + C_\psi (C_e \delta\mu + \tau \omega_e)", first_order("phi", "dmu", "delay"),
             "in level axes along the heading, which is in φ alone", substitute("4", "5", of="3"), result=True),
        line(r"C_e = \exp([[0; 0; s] \times]) \exp([[0; p; 0] \times]) \exp([[r; 0; 0] \times])", EXACT_LINE,
             "three rotations"),
        line(r"C_e = I + [[r; p; s] \times]", first_order("swing"), "to first order in the swing",
             expand("r", "p", "s")),
        line(r"e = [r; p; s]", EXACT_LINE, "the swing"),
        line(r"C_e = I + [e \times]", first_order("swing"), "one skew matrix", substitute("9", of="8")),
        line(r"\dot{C}_e = [\dot{e} \times]", first_order("swing"), "its rate of change",
             differentiate({"C_e": r"\dot{C}_e", "e": r"\dot{e}"})),
        line(r"\dot{C}_e (C_e)^T = [\omega_e \times]", EXACT_LINE, "the rate of the hull"),
        line(r"[\dot{e} \times] (I + [e \times])^T = [\omega_e \times]", first_order("swing"),
             "both to first order", substitute("11", "10")),
        line(r"[\dot{e} \times] = [\omega_e \times]", first_order("swing"), "rates are of the order of the swing",
             expand("e", r"\dot{e}")),
        line(r"\dot{e} = \omega_e", first_order("swing"), "the vectors", take_vector()),
        line(r"C_e \delta\mu = (I + [e \times]) \delta\mu", first_order("swing"), "of the misalignment",
             multiply(right=r"\delta\mu", of="10")),
        line(r"C_e \delta\mu + \tau \omega_e = (I + [e \times]) \delta\mu + \tau \omega_e", first_order("swing"),
             "and of the delay", add(r"\tau \omega_e")),
        line(r"C_e \delta\mu + \tau \omega_e = \delta\mu + e \times \delta\mu + \tau \dot{e}", first_order("swing"),
             "φ and δμ are constants; what varies is e x δμ + ė τ, of the swing e of roll, pitch and yaw",
             substitute("15"), result=True),
        unit="rad",
        small=("swing", "phi", "dmu", "delay"),
    )  # fmt: skip


def least_squares():
    varying = r"(e \times \hat{\mu} + \tau \dot{e})"
    mean = r"(\hat{\mu} - (C_\psi)^T \hat{\phi})"
    return derived(
        line(rf"\mathrm{{E}}[(c + e \times \hat{{\mu}} + \tau \dot{{e}})^T (c + e \times \hat{{\mu}} "
             rf"+ \tau \dot{{e}})] = c^T c + \mathrm{{E}}[{varying}^T {varying}]", IDENTITY,
             "over a period the swing has no mean: the square of (1) falls into the shares of its mean and of what "
             "varies"),
        line(rf"J_m = {mean}^T {mean}", DEFINITION, "the first share: the constants of (1)"),
        line(rf"J_\phi = -2 {mean}^T (C_\psi)^T d", DEFINITION, "φ stands in no other term",
             differentiate({"J_m": r"J_\phi", r"\hat{\phi}": "d"})),
        line(r"\hat{\phi} = C_\psi \hat{\mu}", first_order(*SEA),
             "φ takes up the mean, whatever the misalignment is; the vertical one holds φ_d to the vertical δμ",
             find_minimum("d"), result=True),
        line(rf"J = \mathrm{{E}}[{varying}^T {varying}]", DEFINITION,
             "the other share: the limit of a filter whose prior is used up and whose three rows have equal weight, at "
             "each frequency: white noise, or the gyros' random walk between"),
        line(rf"J_\mu = 2 \mathrm{{E}}[(e \times d)^T {varying}]", DEFINITION,
             "as the misalignment goes along d", differentiate({"J": r"J_\mu", r"\hat{\mu}": "d"})),
        line(r"J_\mu = 2 d^T (\mathrm{E}[\|e\|^2 I - e e^T] \hat{\mu} - \tau \mathrm{E}[e \times \dot{e}])",
             EXACT_LINE, "products of cross products", multiply_out()),
        line(r"\mathrm{E}[\|e\|^2 I - e e^T] \hat{\mu} = \tau \mathrm{E}[e \times \dot{e}]", of_order(3, *SEA),
             "the left is a moment of inertia, the right an angular momentum: the misalignment errs by what the swing "
             "turns on in τ, as if it were a rigid body", find_minimum("d"), result=True),
        unit="rad",
        small=SEA,
    )  # fmt: skip


def yaw_at_rest():
    means = r"(\mathrm{E}[r_0 \dot{p}_0] - \mathrm{E}[p_0 \dot{r}_0])"
    inertia = (
        r"\begin{bmatrix} \mathrm{E}[p_0^2] & -\mathrm{E}[r_0 p_0] & 0 \\ "
        r"-\mathrm{E}[r_0 p_0] & \mathrm{E}[r_0^2] & 0 \\ 0 & 0 & \mathrm{E}[r_0^2] + \mathrm{E}[p_0^2] \end{bmatrix}"
    )
    turned = r"\begin{bmatrix} 0 \\ 0 \\ \mathrm{E}[r_0 \dot{p}_0] - \mathrm{E}[p_0 \dot{r}_0] \end{bmatrix}"
    spread = r"(\mathrm{E}[r_0^2] + \mathrm{E}[p_0^2])"
    return derived(
        line(r"\mathrm{E}[\|e_0\|^2 I - e_0 e_0^T] \hat{\mu}_0 = \tau \mathrm{E}[e_0 \times \dot{e}_0]",
             of_order(3, *SEA), "(2) where the yaw is at rest, e_0 = (r, p, 0)",
             elsewhere({"e": "e_0", r"\dot{e}": r"\dot{e}_0", r"\hat{\mu}": r"\hat{\mu}_0"}, of="(2).2")),
        line(rf"{inertia} \hat{{\mu}}_0 = \tau {turned}",
             of_order(3, *SEA), "the first two stay right, and the vertical row plays no part", multiply_out()),
        line(rf"{spread} \hat{{\mu}}_z = \tau {means}", of_order(3, *SEA), "the third row", take_rows(3)),
        line(rf"\hat{{\mu}}_z = \frac{{\tau {means}}}{{\mathrm{{E}}[r_0^2] + \mathrm{{E}}[p_0^2]}}", first_order(*SEA),
             "for any swing, regular or not, that is long against its own period", solve_for(r"\hat{\mu}_z"),
             result=True),
        unit="rad",
        small=SEA,
    )  # fmt: skip


def sinusoids():
    return derived(
        line("r_0 = R q_s", EXACT_LINE, "roll is a sinusoid, q_s and q_c its sine and cosine"),
        line(r"\dot{r}_0 = R \dot{q}_s", EXACT_LINE, "its rate",
             differentiate({"r_0": r"\dot{r}_0", "q_s": r"\dot{q}_s"})),
        line(r"\dot{q}_s = \Omega q_c", EXACT_LINE, "of a sine"),
        line(r"\dot{r}_0 = R \Omega q_c", EXACT_LINE, "the rate of roll", substitute("3", of="2")),
        line(r"p_0 = P (q_s \cos\epsilon + q_c \sin\epsilon)", EXACT_LINE, "pitch leads roll by ε"),
        line(r"\dot{p}_0 = P (\dot{q}_s \cos\epsilon + \dot{q}_c \sin\epsilon)", EXACT_LINE, "its rate",
             differentiate({"p_0": r"\dot{p}_0", "q_s": r"\dot{q}_s", "q_c": r"\dot{q}_c"})),
        line(r"\dot{q}_c = -\Omega q_s", EXACT_LINE, "of a cosine"),
        line(r"\dot{p}_0 = P \Omega (q_c \cos\epsilon - q_s \sin\epsilon)", EXACT_LINE, "the rate of pitch",
             substitute("3", "7", of="6")),
        line(r"\hat{\mu}_z = -\frac{2 \tau \Omega R P \sin\epsilon}{R^2 + P^2}", first_order(*SEA),
             "means over a period, of the squares 1/2",
             put_in("1", "4", "5", "8", of="(3)"), result=True),
        line(r"\rho = \frac{P}{R}", DEFINITION, "the ratio of the amplitudes"),
        line(r"\hat{\mu}_z = -\frac{2 \tau \Omega \rho \sin\epsilon}{1 + \rho^2}", first_order(*SEA),
             "the size of the sea cancels, only the ratio remains, and the heading is not in it",
             substitute("10", of="9")),
        line(r"\hat{\mu}_z = -\tau \Omega \sin\epsilon (1 - \frac{(1 - \rho)^2}{1 + \rho^2})", first_order(*SEA),
             "largest, τ Ω, for equal amplitudes a quarter of a period apart, where misalignment and delay are one and "
             "the same signal, and zero for roll and pitch in phase", multiply_out()),
        line(r"\hat{\phi}_0 = C_\psi \hat{\mu}_0", first_order(*SEA), "(2) where the yaw is at rest",
             elsewhere({r"\hat{\phi}": r"\hat{\phi}_0", r"\hat{\mu}": r"\hat{\mu}_0"}, of="(2).1")),
        line(r"\hat{\phi}_d = \hat{\mu}_z", first_order(*SEA), "about the vertical", take_rows(3)),
        line(r"\delta\psi = -\hat{\phi}_d", EXACT_LINE, "computed less true yaw"),
        line(r"\delta\psi = -\hat{\mu}_z", first_order(*SEA), "the heading errs by minus the misalignment",
             substitute("14")),
        line(r"\delta\psi = \frac{2 \tau \Omega R P \sin\epsilon}{R^2 + P^2}", first_order(*SEA),
             "the steady heading error of an unknown delay", substitute("9"), result=True),
        unit="rad",
        small=SEA,
    )  # fmt: skip


def with_velocity():
    seen = r"(e_0 \times [0; 0; \hat{\mu}_v] + \tau \dot{e}_0)"
    flown = r"(v \times [0; 0; \hat{\mu}_v] + \tau a)"
    swing = r"\mathrm{E}[r_0^2] + \mathrm{E}[p_0^2]"
    surge = r"\mathrm{E}[v_n^2] + \mathrm{E}[v_e^2]"
    turn = r"\mathrm{E}[r_0 \dot{p}_0] - \mathrm{E}[p_0 \dot{r}_0]"
    sway = r"\mathrm{E}[v_n a_e] - \mathrm{E}[v_e a_n]"
    return derived(
        line(r"\delta v = v \times [0; 0; \phi_d]", first_order("phi"),
             "a slave whose heading errs takes each change of velocity along turned axes"),
        line(r"\delta \dot{v} = a \times [0; 0; \phi_d]", first_order("phi"),
             "f x φ of the model, where f is a: the part of φ that does not take up the mean",
             differentiate({r"\delta v": r"\delta \dot{v}", "v": "a"})),
        line(r"v_{-\tau} = v - \tau a", first_order("delay"), "the master's velocity is old by τ"),
        line(r"z_v = v + \delta v - v_{-\tau}", EXACT_LINE, "computed less reported; the lever arm is in neither, for "
             "its velocity cancels where it is expected"),
        line(r"z_v = v \times [0; 0; \phi_d] + \tau a", first_order("phi", "delay"), "of the same form as (1)",
             substitute("1", "3")),
        line(rf"J = \frac{{1}}{{\sigma_a^2}} \mathrm{{E}}[{seen}^T {seen}] "
             rf"+ \frac{{1}}{{\sigma_v^2}} \mathrm{{E}}[{flown}^T {flown}]", DEFINITION,
             "white noises, equal on all axes; φ_d is held to the misalignment as in (2)"),
        line(rf"J_\mu = \frac{{2}}{{\sigma_a^2}} (({swing}) \hat{{\mu}}_v - \tau ({turn})) "
             rf"+ \frac{{2}}{{\sigma_v^2}} (({surge}) \hat{{\mu}}_v - \tau ({sway}))", DEFINITION,
             "as the misalignment grows", differentiate({"J": r"J_\mu", r"\hat{\mu}_v": "1"})),
        line(rf"(\frac{{{swing}}}{{\sigma_a^2}} + \frac{{{surge}}}{{\sigma_v^2}}) \hat{{\mu}}_v "
             rf"= \tau (\frac{{{turn}}}{{\sigma_a^2}} + \frac{{{sway}}}{{\sigma_v^2}})", of_order(3, *SEA),
             "the rate of the cost is zero at its minimum", find_minimum()),
        line(rf"\hat{{\mu}}_v = \frac{{\tau (\frac{{{turn}}}{{\sigma_a^2}} + \frac{{{sway}}}{{\sigma_v^2}})}}"
             rf"{{\frac{{{swing}}}{{\sigma_a^2}} + \frac{{{surge}}}{{\sigma_v^2}}}}", first_order(*SEA),
             "where the hull surges and sways the velocity has a say of the same form, by its own noise; where it only "
             "heaves, none", solve_for(r"\hat{\mu}_v"), result=True),
        unit="rad",
        small=SEA,
    )  # fmt: skip


@cache
def equations() -> tuple[Equation, ...]:
    written = {"1": residual(), "2": least_squares(), "3": yaw_at_rest(), "4": sinusoids(), "5": with_velocity()}
    flown = {"H": attitude_matrix(entries("C", 3, 3), entries("ω", 3)).as_immutable()}
    return build(NAME, dict.fromkeys(written, ((0, 0), ())), written, quantities(), flown=flown)
