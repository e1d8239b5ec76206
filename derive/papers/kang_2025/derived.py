"""The six numbered equations, each with its derivation: lines in the paper's letters and passages between them."""

from functools import cache

from sympy import Function, S, sin

from boresight.derive.ledger.equation import Equation, Meaning, Reading, letter, product
from boresight.derive.ledger.free import of, rotation, skew_symmetric
from boresight.derive.ledger.lines import (
    DEFINITION,
    EXACT_LINE,
    IDENTITY,
    approximately,
    build,
    derived,
    first_order,
    limit,
    line,
    of_order,
)
from boresight.derive.ledger.numbers import eye, pi
from boresight.derive.ledger.passages import (
    add,
    differentiate,
    elsewhere,
    expand,
    leave_out,
    multiply,
    multiply_out,
    solve_for,
    substitute,
    take_skew_part,
    take_vector,
)
from boresight.derive.ledger.witness import skew
from boresight.derive.papers.kang_2025.printed import PRINTED, quantities

NAME = "kang-2025"


@cache
def letters():
    """What the derivations need and the paper does not print; e: Earth's axes."""
    vectors = (
        ("r_m", "r_m^e", "place", "place of the master, from Earth's centre, m"),
        ("r_s", "r_s^e", "place", "place of the slave, from Earth's centre, m"),
        ("ṙ_m", r"\dot{r}_m^e", "velocity", "its rate of change, m/s"),
        ("ṙ_s", r"\dot{r}_s^e", "velocity", "its rate of change, m/s"),
        ("v̇_s", r"\dot{v}_s", "acceleration", "rate of change of the slave's velocity, m/s^2"),
        ("ω_in_n", "w_{in}^n", "rate", "rate of n against inertial space, in n, rad/s"),
        ("ω_ib_b", "w_{ib}^b", "rate", "gyro output, rad/s"),
        ("v_m(k+α)", r"v_{m,k+\alpha}", "velocity", "velocity at the master δt_d before, m/s"),
        ("u(k+α)", r"u_{k+\alpha}", "velocity", "lever-arm velocity δt_d before, m/s"),
        ("e", "e", "rotation vector", "turn of the expected attitude now from the reported, rad"),
        ("p", "p", "place on a wheel", "point of a wheel, from its hub: along its axis, ahead, up, m"),
    )
    matrices = (
        ("C_S2e", "C_S^e", "attitude", "attitude of the slave against the Earth"),
        ("Ċ_S2e", r"\dot{C}_S^e", "rate of attitude", "its rate of change, 1/s"),
        ("C_e2n", "C_e^n", "attitude", "Earth's axes to n, which is at the slave"),
        ("Ċ_e2n", r"\dot{C}_e^n", "rate of attitude", "its rate of change, 1/s"),
        ("ΔC_e2n", r"\Delta C_e^n", "change of attitude", "Earth's axes to n at the master, less C_e2n"),
        ("Ċ_S2n", r"\dot{C}_S^n", "rate of attitude", "rate of change of the slave's attitude, 1/s"),
        ("C_S2n(k+α)", r"C_{S,k+\alpha}^n", "attitude", "attitude of the slave δt_d before"),
        ("X", "X", "turn", "turn of the expected attitude now from the reported"),
    )  # fmt: skip
    flown = (
        ("place", r"\Lambda", "position", "latitude, longitude in rad and height in m of the slave", (3,)),
        ("u̇", r"\dot{u}", "acceleration", "rate of change of the lever-arm velocity, m/s^2", (3,)),
        ("Q_S2n", "q_S^n", "quaternion", "attitude of the slave", (4,)),
        ("Q_S2M", "q_S^M", "quaternion", "estimated mounting: slave to master", (4,)),
        ("Q_M2n", "q_M^n", "quaternion", "attitude that the master reports", (4,)),
        ("f_b", "f^b", "acceleration", "specific force, m/s^2", (3,)),
        ("F", "F", "16x16", "how the states change one another", (16, 16)),
        ("H_v", "H_v", "3x16", "what the states do to z_v", (3, 16)),
        ("H_DCM", "H_{DCM}", "3x16", "what the states do to z_DCM", (3, 16)),
        ("H_vL", "H_{v,L}", "3x19", "the same with the error of the lever arm", (3, 19)),
        ("H_DCML", "H_{DCM,L}", "3x19", "the same with the error of the lever arm", (3, 19)),
        ("φ", r"\phi", "rotation vector", "attitude error: computed are (I - [φ x]) C_S2n, rad", (3,)),
        ("δv", r"\delta v", "velocity", "velocity error, computed - true, m/s", (3,)),
        ("b_g", "b_g", "rate", "gyro bias, measured - true, rad/s", (3,)),
        ("b_a", "b_a", "acceleration", "accelerometer bias, measured - true, m/s^2", (3,)),
        ("δμ", r"\delta\mu", "rotation vector", "misalignment error, in master axes, rad", (3,)),
        ("δL", r"\delta L", "lever arm", "error of the lever arm, computed - true, m", (3,)),
    )
    return (
        *(letter(*one, (3,)) for one in vectors),
        *(letter(*one, (3, 3)) for one in matrices),
        *(letter(*one) for one in flown),
        letter("I", "I", "identity", "identity, which the print calls eye(3)", (3, 3)),
        letter("ϑ", r"\vartheta", "angle", "how far the wheel has turned, rad"),
    )


ARM = Meaning(
    (
        ("L runs from the master to the slave", ()),
        ("L runs from the slave to the master", (("L", "-L"),)),
    )
)
HEIGHT = Meaning(
    (
        ("a is the height of the wave, crest to trough", ()),
        ("a is its amplitude, as the heights of Table 1 need it", (("a", r"\frac{a}{2}"),)),
    ),
    stated_in="the text under (6)",
)
STRUCTURE = {
    **dict.fromkeys(("C_S2n", "C_M2S", "C_M2n", "C_S2e", "C_e2n"), rotation),
    "C_n2M": of("C_M2n", lambda C: C.T),
    "[ω_in_n x]": of("ω_in_n", skew),
    "[ω_ib_b x]": of("ω_ib_b", skew),
    "A": skew_symmetric,
    "v_s": of("v_s(k)", lambda v: v),  # the indices s and S are one label, and k is now
    "v_S": of("v_s(k)", lambda v: v),
    "I": lambda generator: eye(3),
    "π": lambda generator: pi(),
}


def lever_arm():
    """(1): two ends of a rigid lever arm."""
    dropped = r"\dot{C}_e^n C_S^e L + \Delta C_e^n \dot{r}_m^e"
    small = "where speed times lever arm over the Earth's radius is small"
    return derived(
        line(r"r_m^e = r_s^e - C_S^e L", DEFINITION,
             "the lever arm runs from master to slave; the text leaves it open, the sign of (1) decides"),
        line(r"\dot{r}_m^e = \dot{r}_s^e - \dot{C}_S^e L", EXACT_LINE,
             "the arm is constant in the body: what changes is the attitude",
             differentiate({"r_m^e": r"\dot{r}_m^e", "r_s^e": r"\dot{r}_s^e", "C_S^e": r"\dot{C}_S^e"})),
        line(r"v_s^n = C_e^n \dot{r}_s^e", EXACT_LINE, "velocity is over the ground, in n, which is at the slave"),
        line(r"v_m^n = (C_e^n + \Delta C_e^n) \dot{r}_m^e", EXACT_LINE,
             "the master reports in north, east and down of its own place, a lever arm away"),
        line(r"v_m^n = v_s^n - C_e^n \dot{C}_S^e L + \Delta C_e^n \dot{r}_m^e", EXACT_LINE,
             "both ends move over the ground", substitute("2", "3")),
        line(r"C_S^n = C_e^n C_S^e", EXACT_LINE, "components pass from the slave to the Earth to n"),
        line(r"\dot{C}_S^n = \dot{C}_e^n C_S^e + C_e^n \dot{C}_S^e", EXACT_LINE,
             "n turns against the Earth as the slave moves",
             differentiate({"C_S^n": r"\dot{C}_S^n", "C_e^n": r"\dot{C}_e^n", "C_S^e": r"\dot{C}_S^e"})),
        line(r"\frac{dL}{dt} \Big|_n = \dot{C}_S^n L", EXACT_LINE,
             "the rate of change of the lever arm as seen from n"),
        line(r"v_m^n = v_s^n - \frac{dL}{dt} \Big|_n + \dot{C}_e^n C_S^e L + \Delta C_e^n \dot{r}_m^e", EXACT_LINE,
             "as seen from n, and what the turn of n from place to place adds", substitute("7", "8", of="5")),
        line(r"v_m^n = v_s^n - \frac{dL}{dt} \Big|_n", approximately(dropped, small),
             "n does not turn along the lever arm, nor on the way of the slave",
             leave_out(r"\dot{C}_e^n", r"\Delta C_e^n")),
        line(r"\dot{C}_S^n = C_S^n [w_{nb}^b \times]", EXACT_LINE, "the body turns against n"),
        line(r"w_{nb}^b = w_{ib}^b - (C_S^n)^T w_{in}^n", EXACT_LINE,
             "the gyros measure against inertial space: the rate of n is taken off, turned into body axes"),
        line(r"\dot{C}_S^n = C_S^n [w_{ib}^b \times] - C_S^n [(C_S^n)^T w_{in}^n \times]", EXACT_LINE,
             "the skew matrix is linear in its vector", substitute("12", of="11")),
        line(r"C_S^n [(C_S^n)^T w_{in}^n \times] = [w_{in}^n \times] C_S^n", IDENTITY,
             "a rotation turns a cross product with its factors: [Cω x] = C [ω x] C^T"),
        line(r"\dot{C}_S^n = C_S^n [w_{ib}^b \times] - [w_{in}^n \times] C_S^n", EXACT_LINE,
             "the rotation passes the skew matrix", multiply_out("14", of="13")),
        line(r"\frac{dL}{dt} \Big|_n = C_S^n [w_{ib}^b \times] L - [w_{in}^n \times] C_S^n L", EXACT_LINE,
             "what remains are the two terms of the print", substitute("15", of="8")),
        line(r"v_m^n = v_s^n - \frac{dL}{dt} \Big|_n = v_s^n + [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L",
             approximately(dropped, small), "both lines of the print", substitute("16", of="10"), result=True),
        unit="m/s",
        leads_to=("3",),
        small=("lever", "v_n", "velocity_error"),
        meanings=(ARM,),
        note="Both signs and both terms are right. Whether the transport rate belongs to ω_in, as the text says, is "
        "below what is dropped.",
    )  # fmt: skip


def interpolation():
    """(2): between two updates."""
    return derived(
        line(r"v_{s,k+\alpha} = v_{s,k} - \delta t_d \dot{v}_s", first_order("delay"),
             "to first order in the delay; the text says that the master's data is that of k - δt_d"),
        line(r"v_{s,k-1} = v_{s,k} - dt \dot{v}_s", first_order("step"), "to first order in the step",
             elsewhere({r"v_{s,k+\alpha}": "v_{s,k-1}", r"\delta t_d": "dt"})),
        line(r"\dot{v}_s = \frac{1}{dt} (v_{s,k} - v_{s,k-1})", limit("step"), "the mean rate of the step",
             solve_for(r"\dot{v}_s")),
        line(r"v_{s,k+\alpha} = v_{s,k} - \delta t_d \frac{1}{dt} (v_{s,k} - v_{s,k-1})", first_order(),
             "the rate is eliminated", substitute("3", of="1")),
        line(r"v_{s,k+\alpha} = v_{s,k} \frac{dt - \delta t_d}{dt} + v_{s,k-1} \frac{\delta t_d}{dt}", first_order(),
             "a straight line between the two velocities", multiply_out(), result=True),
        unit="m/s",
        leads_to=("3",),
        small=("delay", "step"),
        note="The index k+α is a label: the time is k - δt_d, so α is minus the delay as a share of the step, which "
        "the text does not say.",
    )  # fmt: skip


def velocity_residual():
    """(3)"""
    moving = ("lever", "v_n", "velocity_error", "acceleration", "jerk")
    return derived(
        line(r"u_k = [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L", EXACT_LINE,
             "u is the lever arm's part of (1), the second and third term of (3)"),
        line("v_m^n = v_s^n + u_k", first_order(*moving), "(1), by its two parts", substitute("1", of="(1)")),
        line(r"v_{m,k+\alpha} = v_{s,k+\alpha} + u_{k+\alpha}", first_order(*moving),
             "the same at the time of the master's data",
             elsewhere({"v_m^n": r"v_{m,k+\alpha}", "v_s^n": r"v_{s,k+\alpha}", "u_k": r"u_{k+\alpha}"})),
        line(r"z_v = v_{m,k+\alpha} - v_M^n", first_order(*moving),
             "the expected velocity less the reported one: error = computed - true"),
        line(r"z_v = v_{s,k+\alpha} + u_{k+\alpha} - v_M^n", EXACT_LINE,
             "what the filter expects of the master is what it knows of the slave", substitute("3")),
        line(r"u_{k+\alpha} = u_k \frac{dt - \delta t_d}{dt} + u_{k-1} \frac{\delta t_d}{dt}", first_order(),
             "(2), which holds of any velocity: the arm turns on during the delay as the slave flies on",
             elsewhere({r"v_{s,k+\alpha}": r"u_{k+\alpha}", "v_{s,k}": "u_k", "v_{s,k-1}": "u_{k-1}"}, of="(2)")),
        line(r"z_v = v_S^n + u_k + \frac{v_{s,k-1} - v_{s,k}}{dt} \delta t_d + \frac{u_{k-1} - u_k}{dt} \delta t_d "
             "- v_M^n", first_order(), "both parts are moved back by the delay", substitute("(2)", "6", of="5")),
        line(r"z_v = v_S^n + [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L "
             r"+ \frac{v_{s,k-1} - v_{s,k}}{dt} \delta t_d + \frac{u_{k-1} - u_k}{dt} \delta t_d - v_M^n",
             first_order(), "the lever arm's part now is as (1) has it", substitute("1"), result=True),
        unit="m/s",
        small=("delay", "step"),
        meanings=(ARM,),
        note="The print moves the slave's velocity back by the delay, but not the lever-arm velocity, which is of the "
        "same order in the delay. Its sign is right: (3) subtracts the change during the delay, where (5) adds it. "
        "Capital and small letters of the indices are labels.",
    )  # fmt: skip


def attitude_matrix():
    """(4): half of a difference."""
    return derived(
        line(r"X = C_S^n C_M^S C_M^{nT}", DEFINITION,
             "components pass from n to M by the master, to S by the misalignment, to n by the slave"),
        line(r"X = \exp([e \times])", EXACT_LINE, "were all right and of one time it would be I, and it is the turn e"),
        line(r"X = eye(3) + [e \times] + \frac{1}{2} [e \times] [e \times]", of_order(2), "through the second order",
             expand("e", order=2)),
        line(r"\frac{1}{2} (X - X^T) = [e \times]", of_order(2),
             "half of the whole difference: the second order is symmetric and goes, and the identity with it",
             take_skew_part()),
        line(r"A = [e \times]", EXACT_LINE, "A stands for the turn: its entries are those of (5)"),
        line(r"A = \frac{1}{2} \left(\left(C_S^n C_M^S C_M^{nT} - eye(3) \right) "
             r"- \left(C_S^n C_M^S C_M^{nT} - eye(3) \right)^T \right)", of_order(2),
             "the brackets hold the whole difference", substitute("5", "1", of="4"), result=True),
        unit="1",
        leads_to=("5",),
        note="As printed the 2 divides the transposed matrix alone. If (4) is taken as it stands, (5) lacks a factor "
        "2/3.",
    )  # fmt: skip


def attitude_residual():
    """(5)"""
    turned = r"(eye(3) + \delta t_d [w_{nb}^n \times])"
    return derived(
        line(r"\dot{C}_S^n = [w_{nb}^n \times] C_S^n", EXACT_LINE, "the slave turns against n, its rate in n"),
        line(r"C_{S,k+\alpha}^n = C_S^n - \delta t_d \dot{C}_S^n", first_order("delay"),
             "to first order, from where it was at k - δt_d"),
        line(r"C_{S,k+\alpha}^n = (eye(3) - \delta t_d [w_{nb}^n \times]) C_S^n", first_order("delay"),
             "during the delay the slave turns on", substitute("1")),
        line(rf"{turned} C_{{S,k+\alpha}}^n = {turned} (eye(3) - \delta t_d [w_{{nb}}^n \times]) C_S^n",
             first_order("delay"), "the turn goes back to the other side", multiply(left=turned)),
        line(rf"{turned} C_{{S,k+\alpha}}^n = C_S^n", first_order("delay"), "the square of the delay is left out",
             expand(r"\delta t_d")),
        line(r"\exp([z_{DCM} \times]) = C_{S,k+\alpha}^n C_M^S C_M^{nT}", EXACT_LINE,
             "z_DCM is the error at one time, k - δt_d"),
        line(r"X = C_S^n C_M^S C_M^{nT}", DEFINITION, "(4) compares the slave of k with the master of k - δt_d"),
        line(rf"X = {turned} \exp([z_{{DCM}} \times])", first_order("delay"), "the two are a turn of the slave apart",
             substitute("6", "5", letters=(r"C_{S,k+\alpha}^n",))),
        line(rf"X = {turned} (eye(3) + [z_{{DCM}} \times])", first_order(), "a small error", expand("z_{DCM}")),
        line(r"X = eye(3) + [z_{DCM} \times] + \delta t_d [w_{nb}^n \times] "
             r"+ \delta t_d [w_{nb}^n \times] [z_{DCM} \times]", first_order(), "the product, term by term",
             multiply_out()),
        line(r"X = eye(3) + [z_{DCM} \times] + \delta t_d [w_{nb}^n \times]", first_order(),
             "the product of error and delay is left out", expand("z_{DCM}", r"\delta t_d")),
        line(r"\frac{1}{2} (X - X^T) = [z_{DCM} \times] + \delta t_d [w_{nb}^n \times]", first_order(),
             "as in (4)", take_skew_part()),
        line(r"A = [z_{DCM} \times] + \delta t_d [w_{nb}^n \times]", first_order(), "(4) takes it",
             substitute("7", "(4)")),
        line(r"\vee(A) = z_{DCM} + \delta t_d w_{nb}^n", first_order(), "A is skew-symmetric", take_vector()),
        line(r"\vee(A) = [-A(2,3); A(1,3); -A(1,2)]", IDENTITY,
             "by its entries; the signs of the print are right"),
        line(r"[-A(2,3); A(1,3); -A(1,2)] = z_{DCM} + \delta t_d w_{nb}^n", first_order(), "both are the vector of A",
             multiply_out("15", of="14")),
        line(r"z_{DCM} = [-A(2,3); A(1,3); -A(1,2)] - \delta t_d w_{nb}^n", first_order(),
             "what the slave turned on is taken off", add(r"-\delta t_d w_{nb}^n")),
        line(r"w_{nb}^n = C_S^n w_{nb}^b", EXACT_LINE,
             "the rate is measured in the body, ω_nb_b, and C_S2n takes it to n, once"),
        line(r"z_{DCM} = [-A(2,3); A(1,3); -A(1,2)] - C_S^n w_{nb}^b \delta t_d", first_order(),
             "the print has the other sign, and turns the rate of n once more", substitute("18", of="17"),
             result=True),
        unit="rad",
        note="The last term has two slips, its sign and its frame. The sign: with the master at k - δt_d, as the text "
        "over (2) has it, the turn during the delay is taken off; (3) does so, (5) adds it, so the two contradict each "
        "other on the sign of one state. The frame: a rate in n needs no C_S2n before it. ω_nb is the rate of b "
        "against n, as ω_in and ω_ib are read.",
    )  # fmt: skip


def wave():
    """(6): a point on a wheel."""
    height, frequency, time, pi_ = (
        next(q.symbol for q in quantities() if q.symbol.name == name) for name in ("a", "f", "t", "π")
    )
    phase = product(S(2), pi_, frequency, time)
    return derived(
        line(r"\vartheta = 2 \pi f t", DEFINITION, "a wheel turns f times a second"),
        line(r"p = \exp([[\vartheta; 0; 0] \times]) [0; \frac{a}{2}; 0]", DEFINITION,
             "its diameter is the height of the wave, crest to trough, and a point on it begins ahead of the hub"),
        line(r"p = [0; \frac{a}{2} \cos\vartheta; \frac{a}{2} \sin\vartheta]", EXACT_LINE,
             "a turn about the first axis", multiply_out()),
        line("Seawave = [0 \\ 0 \\ 1] p", EXACT_LINE,
             "the point goes up and down as the surface does, from zero upwards"),
        line(r"Seawave = \frac{a}{2} \sin(2 \pi f t)", EXACT_LINE, "the vertical component", substitute("1", "3"),
             result=True),
        unit="1",
        readings=(
            Reading(
                Function("asin", commutative=False)(phase),
                height * sin(phase),
                "a is a letter of its own, as the text under (6) says; the arcsine has no real value after "
                "0.16 of a period",
            ),
        ),
        meanings=(HEIGHT,),
        note="The text calls a the height of the wave, and Table 1 gives the heights of the code; in (6) it is the "
        "amplitude, half of that. If a is an amplitude (6) stands, and the column of Table 1 is half of the heights: "
        "which of the two is wrong cannot be decided. f is called a period, and is 0.1 Hz: a label.",
    )  # fmt: skip


@cache
def equations() -> tuple[Equation, ...]:
    """The six numbered equations, in the paper's order."""
    written = {
        "1": lever_arm(),
        "2": interpolation(),
        "3": velocity_residual(),
        "4": attitude_matrix(),
        "5": attitude_residual(),
        "6": wave(),
    }
    return build(NAME, PRINTED, written, quantities(), letters())
