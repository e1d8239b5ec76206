"""The numbered equations, each with its derivation: lines in the paper's letters and passages between them."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache

from sympy import ImmutableMatrix, Matrix, S, Symbol, symbols

from boresight.derive.ledger.equation import Equation, Reading
from boresight.derive.ledger.lines import (
    DEFINITION,
    EXACT_LINE,
    IDENTITY,
    Derived,
    approximately,
    build,
    derived,
    first_order,
    limit,
    line,
    of_order,
)
from boresight.derive.ledger.passages import (
    add,
    add_line,
    chain,
    differentiate,
    expand,
    find_minimum,
    identify,
    multiply,
    multiply_out,
    rearrange,
    solve_for,
    stack,
    substitute,
    subtract_line,
    take_entry,
    take_root,
    take_rows,
    take_vector,
)
from boresight.derive.papers.kim_2018 import results
from boresight.derive.papers.kim_2018.decided import DECIDED
from boresight.derive.papers.kim_2018.letters import letters
from boresight.derive.papers.kim_2018.printed import PRINTED, letters_of, quantities

NAME = "kim-2018"


@cache
def equations() -> tuple[Equation, ...]:
    """The 32 numbered equations and one without a number, in the paper's order."""
    quaternion, units = symbols("q_:4", real=True), symbols("e n u")
    by_phi = results.quaternion_error(quaternion, units).jacobian(Matrix(units)) * -2
    flown: Mapping[str, object] = {
        "quaternion_error": ImmutableMatrix(by_phi),
        "zero_velocity_matrix": ImmutableMatrix(results.zero_velocity_matrix()),
        "hold_measurement_matrix": ImmutableMatrix(results.hold_measurement_matrix()),
    }
    named = {quantity.symbol.name: quantity.symbol for quantity in quantities()}
    written = {**transfer(named), **hold(named), **azimuth(), **update(), **detector()}
    written = {n: replace(one, more={**one.more, **DECIDED.get(n, {})}) for n, one in written.items()}
    return build(NAME, PRINTED, written, quantities(), letters(), flown, letters_of)


def column(*rows: str) -> str:
    """A matrix of these rows, whose cells are apart by &."""
    return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"


# fmt: off
# ---- 2.1 Transfer alignment ------------------------------------------------------------------------------------------


def transfer(named: Mapping[str, Symbol]) -> dict[str, Derived]:
    both = first_order("velocity_error", "phi")
    psi = first_order("phi")
    errors = first_order()
    phi_x, spun, turn = r"[\phi^n \times]", r"[\hat{\omega}_{in}^c \times]", r"\hat{C}_b^c C_n^b"
    coriolis = r"(2 \omega_{ie}^n + \hat{\omega}_{en}^c)"
    rates = column(r"\dot{\delta v}^n", r"\dot{\psi}^n", r"\dot{\theta}", r"\dot{\Delta t}")
    F = column(
        r"-(2 [\omega_{ie}^n \times] + [\omega_{en}^n \times]) & [f^n \times] & 0_{3 \times 4}",
        r"0_{3 \times 3} & -([\omega_{ie}^n \times] + [\omega_{en}^n \times]) & 0_{3 \times 4}",
        r"0_{4 \times 3} & 0_{4 \times 3} & 0_{4 \times 4}",
    )
    H = column(
        r"I_{3 \times 3} & 0_{3 \times 3} & 0_{3 \times 3} & \dot{v}^n",
        r"0_{3 \times 3} & I_{3 \times 3} & -C_r^n & d",
    )
    measured, noise = column("Z_v(k)", "Z_{dcm}(k)"), column(r"\nu_v(k)", r"\nu_{dcm}(k)")
    late, I_late = r"C_r^n(k - \delta t)", r"(I - \Delta t [\omega_{nr}^n \times])"
    sum_late, sum_now = (
        column(r"\delta v^n + \dot{v}^n \Delta t + \nu_v(k)", rf"\phi^n - {C} \theta + d \Delta t + \nu_{{dcm}}(k)")
        for C in (late, "C_r^n")
    )
    late_theta = rf"[({late} \theta) \times]"
    three = r"\vee(\hat{C}_r^n \hat{C}_b^r \hat{C}_n^b)"
    return {
        "1": derived(
            line("X = " + column(r"\delta v^n", r"\phi^n", r"\theta", r"\Delta t"), IDENTITY,
                 "velocity and attitude error of the slave, error of the mounting, delay: F and H have this order"),
            defines=("X",), leads_to=("3", "6"),
            note="Section 2.1 says that φ is the attitude error of the psi model; "
            "(8) has the letter for the phi model.",
        ),
        # the psi model: both errors against the axes c at the computed position
        "2": derived(
            line(r"\hat{f}^b = f^b", approximately(r"\delta f^b", "the filter has noise for errors of the sensors"),
                 "the sensors are taken as perfect, the accelerometers and the gyros"),
            line(r"\hat{g}^n = g^n", approximately(r"\delta g^n",
                 "the position is known; the filter has no state for its error"),
                 "gravity is taken at the right place"),
            line(rf"\dot{{\hat{{v}}}}^c = \hat{{C}}_b^c f^b + g^n - {coriolis} \times \hat{{v}}^n", EXACT_LINE,
                 "the computer integrates Newton's law with its own attitude and velocity"),
            line(r"\dot{v}^n = C_b^n f^b + g^n - (2 \omega_{ie}^n + \omega_{en}^n) \times v^n", EXACT_LINE,
                 "Newton's law holds in the true axes"),
            line(r"\delta v^n = \hat{v}^n - C_n^c v^n", EXACT_LINE,
                 "the velocity error is against the true velocity carried into the computer's axes c"),
            line(r"\dot{\delta v}^n = \dot{\hat{v}}^c - \dot{C}_n^c v^n - C_n^c \dot{v}^n", EXACT_LINE,
                 "each side changes with time; so no error of a rate remains",
                 differentiate({r"\delta v^n": r"\dot{\delta v}^n", r"\hat{v}^n": r"\dot{\hat{v}}^c",
                 "C_n^c": r"\dot{C}_n^c", "v^n": r"\dot{v}^n"})),
            line("C_n^c = I", EXACT_LINE, "the axes c lie where the computer believes to be, which is right now"),
            line(r"\dot{C}_n^c = C_n^c [\omega_{en}^n \times] - [\hat{\omega}_{en}^c \times] C_n^c", EXACT_LINE,
                 "both turn against the Earth, each by its own transport rate"),
            line(r"\dot{\delta v}^n = \hat{C}_b^c f^b - C_b^n f^b"
                 rf" - {coriolis} \times \hat{{v}}^n + (2 \omega_{{ie}}^n + \omega_{{en}}^n) \times v^n"
                 r" - (\omega_{en}^n - \hat{\omega}_{en}^c) \times v^n", EXACT_LINE, "gravity cancels",
                 substitute("7", "3", "4", "8", of="6")),
            line(rf"\dot{{\delta v}}^n = (\hat{{C}}_b^c - C_b^n) f^b - {coriolis} \times \delta v^n", EXACT_LINE,
                 "the velocities together are the error", substitute("7", "5")),
            line(rf"\hat{{C}}_b^c = \exp(-{phi_x}) C_n^c C_b^n", EXACT_LINE,
                 "the attitude errs by ψ, which the paper writes φ, against c"),
            line(rf"\dot{{\delta v}}^n = (\exp(-{phi_x}) - I) C_b^n f^b - {coriolis} \times \delta v^n", EXACT_LINE,
                 "this attitude is put in", substitute("7", "11", of="10")),
            line(rf"\dot{{\delta v}}^n = -{phi_x} C_b^n f^b - {coriolis} \times \delta v^n", psi,
                 "the rotation is small", expand(r"\phi^n")),
            line("f^n = C_b^n f^b", EXACT_LINE, "the specific force is carried into n"),
            line(rf"-{phi_x} f^n = [f^n \times] \phi^n", IDENTITY, "-ψ x f = f x ψ: the sign of the print is right"),
            line(r"\hat{\omega}_{en}^c = \omega_{en}^n", limit("velocity_error"),
                 "the computed rate errs by the velocity error alone, and stands before an error"),
            line(rf"\dot{{\delta v}}^n = -{phi_x} f^n - (2 \omega_{{ie}}^n + \omega_{{en}}^n) \times \delta v^n",
                 both, "products of errors are dropped", substitute("14", "16", of="13")),
            line(r"\dot{\delta v}^n = -(2 [\omega_{ie}^n \times] + [\omega_{en}^n \times]) \delta v^n"
                 r" + [f^n \times] \phi^n", both, "the print says so", multiply_out("15"), result=True),
            line(rf"{turn} C_c^n = \exp(-{phi_x})", EXACT_LINE, "the rotation stands alone",
                 multiply(right="C_n^b C_c^n", of="11")),
            line(rf"{turn} C_c^n = I - {phi_x}", psi, "the rotation is small", expand(r"\phi^n")),
            line(rf"\dot{{\hat{{C}}}}_b^c C_n^b C_c^n + \hat{{C}}_b^c \dot{{C}}_n^b C_c^n + {turn} \dot{{C}}_c^n"
                 r" = -[\dot{\psi}^n \times]", both, "each side changes with time",
                 differentiate({r"\hat{C}_b^c": r"\dot{\hat{C}}_b^c", "C_b^n": r"\dot{C}_b^n",
                 "C_n^c": r"\dot{C}_n^c", r"\phi^n": r"\dot{\psi}^n"})),
            line(r"\dot{C}_b^n = C_b^n [\omega_{ib}^b \times] - [\omega_{in}^n \times] C_b^n", EXACT_LINE,
                 "the body turns by its rate, and n by its own"),
            line(rf"\dot{{\hat{{C}}}}_b^c = \hat{{C}}_b^c [\omega_{{ib}}^b \times] - {spun} \hat{{C}}_b^c",
                 EXACT_LINE, "the computer turns its attitude by what it measures, and c by the rate that it knows"),
            line(r"\hat{\omega}_{in}^c = \omega_{in}^n - \omega_{en}^n + \hat{\omega}_{en}^c", EXACT_LINE,
                 "the Earth's rate is known with the position"),
            line(rf"{turn} {spun} - {spun} {turn} = -[\dot{{\psi}}^n \times]", both,
                 "the rate of the body cancels; c is n now", substitute("7", "24", "22", "23", "8", of="21")),
            line(rf"(I - {phi_x}) {spun} - {spun} (I - {phi_x}) = -[\dot{{\psi}}^n \times]", EXACT_LINE,
                 "the small rotation is put in", substitute("7", "20", letters=("", r"\hat{C}_b^c"))),
            line(rf"{spun} {phi_x} - {phi_x} {spun} = [(\hat{{\omega}}_{{in}}^c \times \phi^n) \times]", IDENTITY,
                 "two skew-symmetric matrices make a third"),
            line(r"[(\hat{\omega}_{in}^c \times \phi^n) \times] = -[\dot{\psi}^n \times]", EXACT_LINE,
                 "the rates alone cancel", multiply_out("27", of="26")),
            line(r"\hat{\omega}_{in}^c \times \phi^n = -\dot{\psi}^n", EXACT_LINE, "equal matrices have equal vectors",
                 take_vector()),
            line(r"\hat{\omega}_{in}^c = \omega_{ie}^n + \omega_{en}^n", limit("velocity_error"),
                 "it stands before an error too"),
            line(r"([\omega_{ie}^n \times] + [\omega_{en}^n \times]) \phi^n = -\dot{\psi}^n", both,
                 "products of errors are dropped", substitute("30", of="29")),
            line(r"\dot{\psi}^n = -([\omega_{ie}^n \times] + [\omega_{en}^n \times]) \phi^n", both,
                 "so the attitude error stands still in inertial space", solve_for(r"\dot{\psi}^n"), result=True),
            line(r"\dot{\theta} = 0", EXACT_LINE, "the mounting is rigid", result=True),
            line(r"\dot{\Delta t} = 0", EXACT_LINE, "the delay is constant", result=True),
            unit="m/s^2", readings=(Reading(named["φ̇"], named["ψ̇"],
            "the text over (1) names the psi model; as the phi model the row lacks δω_in_n"),), leads_to=("3",),
        ),
        "3": derived(
            line(rf"\dot{{X}} = {rates}", EXACT_LINE, "the order is that of (1)"),
            line(r"\dot{X} = "
                 + column(r"-(2 [\omega_{ie}^n \times] + [\omega_{en}^n \times]) \delta v^n + [f^n \times] \phi^n",
                 r"-([\omega_{ie}^n \times] + [\omega_{en}^n \times]) \phi^n", r"0_{4 \times 3} \theta"), both,
                 "(2) gives the four rows", substitute("(2)", "(2).2", "(2).3", "(2).4")),
            line(rf"\dot{{X}} = {F} X", both, "X is taken out to the right", multiply_out()),
            line(rf"F X = {F} X", EXACT_LINE, "F is what makes the rates of the states, to first order"),
            line(rf"F = {F}", EXACT_LINE, "whatever the states are", identify("X"), result=True),
            line(r"\dot{X} = F X", both, "so they are called", substitute("5", of="3"), result=True),
            note="A vector of rates beside a vector is its cross product: the index 3x3 of (3) says so.",
        ),
        # the measurement of the transfer alignment
        "4": derived(
            line(r"Z_v(k) = \hat{v}_{SINS}^n - \hat{v}_{MINS}^n", EXACT_LINE,
                 "the measurement is computed less reported"),
            line(r"\hat{v}_{SINS}^n = v^n + \delta v^n", EXACT_LINE, "the slave's velocity errs"),
            line(r"Z_v(k) = \delta v^n - (\hat{v}_{MINS}^n - v^n)", EXACT_LINE,
                 "what the velocities differ by; ν_v is minus all by which the master's errs",
                 substitute("2", of="1")),
            unit="m/s", leads_to=("6",),
            note="(6) has a column for the delay: there ν_v is the master's own error, and (4) would leave out v̇ Δt.",
        ),
        "5": derived(
            line(rf"Z_{{dcm}}(k) = {three}", EXACT_LINE,
                 "components pass from n to b by the slave, from b to r by the mounting, from r to n by the master"),
            line(r"\hat{C}_b^r = \exp(-[\theta \times]) C_b^r", EXACT_LINE, "the mounting errs by θ"),
            line(rf"\hat{{C}}_n^b = C_n^b \exp({phi_x})", EXACT_LINE, "the slave errs by φ"),
            line(rf"\hat{{C}}_r^n = \exp([\nu_{{dcm}}(k) \times]) {late}", EXACT_LINE,
                 "the master's attitude is old, and its own error is the noise"),
            line(rf"Z_{{dcm}}(k) = \vee(\exp([\nu_{{dcm}}(k) \times]) {late} \exp(-[\theta \times]) C_b^r C_n^b"
                 rf" \exp({phi_x}))", EXACT_LINE, "all three matrices err", substitute("2", "3", "4", of="1")),
            line(rf"Z_{{dcm}}(k) = \vee({late} C_b^r C_n^b + [\nu_{{dcm}}(k) \times] {late} C_b^r C_n^b"
                 rf" - {late} [\theta \times] C_b^r C_n^b + {late} C_b^r C_n^b {phi_x})",
                 first_order("phi", "theta", "master_attitude_error"), "one error stays in each term",
                 expand(r"\nu_{dcm}(k)", r"\theta", r"\phi^n")),
            line("C_r^n C_b^r = C_b^n", EXACT_LINE, "the slave stands on the master"),
            line("C_b^r C_n^b = C_n^r", EXACT_LINE, "so b leads to r and to n", multiply(left="C_n^r", right="C_n^b")),
            line(rf"Z_{{dcm}}(k) = \vee({late} C_n^r + [\nu_{{dcm}}(k) \times] {late} C_n^r"
                 rf" - {late} [\theta \times] C_n^r + {late} C_n^r {phi_x})",
                 first_order("phi", "theta", "master_attitude_error"),
                 "the master's attitude then stands against that of now", substitute("8", of="6", letters=("C_b^r",))),
            line(rf"{late} [\theta \times] C_n^r = {late_theta} {late} C_n^r", IDENTITY,
                 "a rotation turns the axis of a skew-symmetric matrix"),
            line(rf"Z_{{dcm}}(k) = \vee({late} C_n^r + [\nu_{{dcm}}(k) \times] {late} C_n^r"
                 rf" - {late_theta} {late} C_n^r + {late} C_n^r {phi_x})",
                 first_order("phi", "theta", "master_attitude_error"), "so θ is turned into n",
                 multiply_out("10", of="9")),
            line(rf"{late} = {I_late} C_r^n", of_order(1, "delay"), "during the delay the master turns against n"),
            line(rf"{late} C_n^r = I - \Delta t [\omega_{{nr}}^n \times]", of_order(1, "delay"),
                 "the turn stands alone", multiply(right="C_n^r")),
            line(rf"Z_{{dcm}}(k) = \vee({I_late} + [\nu_{{dcm}}(k) \times] {I_late}"
                 rf" - {late_theta} {I_late} + {I_late} {phi_x})", errors, "the turn of the delay is put in",
                 substitute("13", of="11", letters=("C_n^r",))),
            line(r"Z_{dcm}(k) = \vee(I - \Delta t [\omega_{nr}^n \times] + [\nu_{dcm}(k) \times]"
                 rf" - {late_theta} + {phi_x})", errors,
                 "products of errors and delay are dropped, and the product is I + [Z x]",
                 expand(r"\Delta t", r"\nu_{dcm}(k)", r"\theta", r"\phi^n")),
            line(rf"Z_{{dcm}}(k) = -\Delta t \omega_{{nr}}^n + \nu_{{dcm}}(k) - {late} \theta + \phi^n", errors,
                 "each matrix has its vector; I has none", multiply_out()),
            line(r"d = -\omega_{nr}^n", EXACT_LINE, "d, which the paper nowhere defines, is the rate of n against r"),
            line(rf"Z_{{dcm}}(k) = {three} = \phi^n - {late} \theta + d \Delta t + \nu_{{dcm}}(k)", errors,
                 "this d is put in", substitute("17", "16", of="1"), result=True),
            as_vector=True, unit="rad", leads_to=("6",),
            note="The product of three matrices is set equal to a vector: read as the vector of its skew-symmetric "
            "part. δt is the Δt of (1).",
        ),
        "6": derived(
            line(r"Z_v(k) = \hat{v}_{SINS}^n - \hat{v}_{MINS}^n", EXACT_LINE, "(4) begins so"),
            line(r"\hat{v}_{SINS}^n = v^n + \delta v^n", EXACT_LINE, "the slave's velocity errs"),
            line(r"\hat{v}_{MINS}^n = v_{old}^n + \Delta v_{MINS}", EXACT_LINE,
                 "the master's velocity is as old as its attitude in (5), and errs"),
            line(r"v_{old}^n = v^n - \dot{v}^n \Delta t", of_order(1, "delay"),
                 "a short delay changes it in proportion"),
            line(r"\nu_v(k) = -\Delta v_{MINS}", EXACT_LINE, "the noise is minus the master's own error"),
            line(r"Z_v(k) = (v^n + \delta v^n) - (v^n - \dot{v}^n \Delta t + \Delta v_{MINS})", first_order("delay"),
                 "both velocities are put in", substitute("2", "4", "3", of="1")),
            line(r"Z_v(k) = \delta v^n + \dot{v}^n \Delta t + \nu_v(k)", first_order("delay"),
                 "the true velocity cancels", substitute("5", letters=(r"\Delta v_{MINS}",))),
            line(f"{measured} = {sum_late}", errors, "this and (5), as derived, stand over one another",
                 stack("7", "(5)")),
            line(rf"{late} = C_r^n", limit("delay"), "it stands before an error"),
            line(f"{measured} = {sum_now}", errors, "the product of delay and error is dropped",
                 substitute("9", of="8")),
            line(f"{measured} = {H} X + {noise}", errors, "the order is that of (1)", multiply_out()),
            line(f"H X + {noise} = {H} X + {noise}", EXACT_LINE, "H is what the measurements see of the states"),
            line(f"H = {H}", EXACT_LINE, "whatever the states are", identify("X"), result=True),
            line(f"{measured} = H X + {noise}", errors, "so they are called", substitute("13", of="11"), result=True),
            note="Four slips: a column is lost between I and C_r2n, so that the blocks do not fit; f stands where the "
            "acceleration over the ground belongs, which is without gravity and Coriolis; its sign, and that of d, "
            "which (5) adds. If Δt is the error of an estimated delay, computed - true, the sign of f is right and "
            "d = ω_nr_n; f for v̇ and the minus at d remain wrong, for (5) adds d all the same.",
        ),
    }


# ---- 2.2 The fifteen states ------------------------------------------------------------------------------------------


def hold(named: Mapping[str, Symbol]) -> dict[str, Derived]:
    errors = first_order()
    phi = first_order("phi")
    phi_x, in_x, gyro_x = r"[\phi^n \times]", r"[\omega_{in}^n \times]", r"[\delta \omega_{ib}^b \times]"
    coordinates = column(r"\delta \dot{l}", r"\delta \dot{L}", r"\delta \dot{h}")
    coriolis = r"2 [\omega_{ie}^n \times] + [\omega_{en}^n \times]"
    F = column(
        "A_p & A_v & 0 & 0 & 0",
        r"A_{vp} & A_{vv} & [f^n \times] & 0 & C_b^n",
        r"A_{\phi p} & W_{ev} & A_{\phi\phi} & -C_b^n & 0",
        r"0_{3 \times 3} & 0 & 0 & 0 & 0",
        r"0_{3 \times 3} & 0 & 0 & 0 & 0",
    )
    by_position = column(
        r"0 & \frac{\rho_n \tan L}{\cos L} - \frac{\rho_n}{(R_E + h) \cos L} R_{EE} & -\frac{\rho_n}{(R_E + h) \cos L}",
        r"0 & \frac{\rho_e}{(R_N + h)} R_{NN} & \frac{\rho_e}{(R_N + h)}",
        "0 & 0 & 0",
    )
    by_velocity = column(r"\frac{1}{(R_E + h) \cos L} & 0 & 0", r"0 & \frac{1}{(R_N + h)} & 0", "0 & 0 & 1")
    noise = column(r"0_{3 \times 3} w_f", "C_b^n w_f", r"-C_b^n w_\omega", r"0_{3 \times 3} w_f", r"0_{3 \times 3} w_f")
    slow = ("velocity_error", "position_error")
    return {
        "7": derived(
            line(r"\delta \omega_{ie}^n = W_{ie} x_p", errors, "the Earth's axis leans with the latitude"),
            line(r"\delta \omega_{en}^n = W_{ep} x_p + W_{ev} x_v", errors,
                 "the transport rate depends on place and velocity"),
            line(r"\delta g^n = W_g x_p", errors, "gravity depends on the place"),
            line(r"\delta f^b = x_{Ab} + w_f", EXACT_LINE, "an accelerometer errs by its bias and by noise"),
            line(r"\delta \omega_{ib}^b = x_{Cb} + w_\omega", EXACT_LINE, "a gyro errs so too"),
            line(f"{coordinates} = {by_position} x_p + {by_velocity} x_v", errors,
                 "(9) gives the rows, (8) the order", stack("(9)", "(9).2", "(9).3")),
            line(f"A_p = {by_position}", DEFINITION, "it gets a name"),
            line(f"A_v = {by_velocity}", DEFINITION, "it gets a name"),
            line(f"{coordinates} = A_p x_p + A_v x_v", errors, "the names are put in", substitute("7", "8", of="6")),
            line(r"A_{vp} = W_g + [v^n \times] (2 W_{ie} + W_{ep})", DEFINITION, "(10) has this of the position"),
            line(rf"A_{{vv}} = [v^n \times] W_{{ev}} - ({coriolis})", DEFINITION, "it has this of the velocity"),
            line(r"\delta \dot{v}^n = A_{vp} x_p + A_{vv} x_v + [f^n \times] x_\phi + C_b^n (x_{Ab} + w_f)", errors,
                 "the states are put into (10), and -δω x v = v x δω",
                 substitute("1", "2", "3", "4", "10", "11", of="(10)")),
            line(r"A_{\phi p} = W_{ie} + W_{ep}", DEFINITION, "(11) has this of the position"),
            line(r"A_{\phi\phi} = -([\omega_{ie}^n \times] + [\omega_{en}^n \times])", DEFINITION,
                 "it has this of the attitude"),
            line(r"\dot{\phi}^n = A_{\phi p} x_p + W_{ev} x_v + A_{\phi\phi} x_\phi - C_b^n (x_{Cb} + w_\omega)",
                 errors, "the states are put into (11)", substitute("1", "2", "5", "13", "14", of="(11)")),
            line(r"\dot{x}_k = " + column(r"\delta \dot{l}", r"\delta \dot{L}", r"\delta \dot{h}",
                 r"\delta \dot{v}^n", r"\dot{\phi}^n", r"0_{3 \times 3} x_{Cb}", r"0_{3 \times 3} x_{Ab}"),
                 EXACT_LINE, "the biases are random constants"),
            line(rf"\dot{{x}}_k = {F} x_k + {noise}", errors, "the states are taken out to the right",
                 substitute("9", "12", "15")),
            line(r"\dot{x}_k = F_k x_k + w_k", errors,
                 "F_k is the derivative of the exact rates (9) to (11) by the states, w_k what the sensors' noise adds",
                 result=True),
            line(rf"F_k x_k + w_k = {F} x_k + {noise}", EXACT_LINE, "both are the rates", chain("17", "18")),
            line(rf"F_k = {F}", EXACT_LINE, "whatever the states are", identify("x_k")),
            line(rf"F_k x_k = {F} x_k", EXACT_LINE, "these are the states", multiply(right="x_k")),
            line(rf"w_k = {noise}", EXACT_LINE, "this is left", subtract_line("21", of="19")),
            leads_to=("12",), note="The rate of a continuous system with the index of a step: a label.",
        ),
        "8": derived(
            line("x = " + column("x_p", "x_v", r"x_\phi", "x_{Cb}", "x_{Ab}"), IDENTITY,
                 "the states stand in this order, which F_k and H_k share"),
            line(r"x_p = [\delta l \ \delta L \ \delta h]^T", IDENTITY, "longitude, latitude and height err"),
            line(r"x_v = [\delta v_e \ \delta v_n \ \delta v_u]^T", IDENTITY, "the velocity errs"),
            line(r"x_\phi = [\phi_e \ \phi_n \ \phi_u]^T", IDENTITY, "the attitude errs"),
            defines=("x",), leads_to=("7",),
        ),
        "9": derived(
            line(r"\dot{l} = \frac{v_e}{(R_E + h) \cos L}", EXACT_LINE,
                 "an angle changes by a velocity over the radius of its circle; R_E is the transverse radius"),
            line(r"\dot{L} = \frac{v_n}{R_N + h}", EXACT_LINE, "R_N is the radius of the meridian"),
            line(r"\dot{h} = v_u", EXACT_LINE, "the height is along the vertical"),
            line(r"\partial_L \dot{l} = \frac{v_e \tan L}{(R_E + h) \cos L} - \frac{v_e}{(R_E + h)^2 \cos L} R_{EE}",
                 EXACT_LINE, "the latitude changes it, also through the radius, whose slope is R_EE = dR_E/dL",
                 differentiate({r"\dot{l}": r"\partial_L \dot{l}", "L": "1", "R_E": "R_{EE}"}, of="1")),
            line(r"\partial_h \dot{l} = -\frac{v_e}{(R_E + h)^2 \cos L}", EXACT_LINE, "the height changes it",
                 differentiate({r"\dot{l}": r"\partial_h \dot{l}", "h": "1"}, of="1")),
            line(r"\partial_v \dot{l} = \frac{1}{(R_E + h) \cos L}", EXACT_LINE, "the velocity changes it",
                 differentiate({r"\dot{l}": r"\partial_v \dot{l}", "v_e": "1"}, of="1")),
            line(r"\partial_L \dot{L} = -\frac{v_n}{(R_N + h)^2} R_{NN}", EXACT_LINE,
                 "the latitude changes it through the radius alone, whose slope is R_NN = dR_N/dL",
                 differentiate({r"\dot{L}": r"\partial_L \dot{L}", "R_N": "R_{NN}"}, of="2")),
            line(r"\partial_h \dot{L} = -\frac{v_n}{(R_N + h)^2}", EXACT_LINE, "the height changes it",
                 differentiate({r"\dot{L}": r"\partial_h \dot{L}", "h": "1"}, of="2")),
            line(r"\partial_v \dot{L} = \frac{1}{R_N + h}", EXACT_LINE, "the velocity changes it",
                 differentiate({r"\dot{L}": r"\partial_v \dot{L}", "v_n": "1"}, of="2")),
            line(r"\delta \dot{l} = \partial_L \dot{l} \delta L + \partial_h \dot{l} \delta h"
                 r" + \partial_v \dot{l} \delta v_e", first_order(*slow),
                 "the computed rate differs from the true one by this, to first order"),
            line(r"\delta \dot{L} = \partial_L \dot{L} \delta L + \partial_h \dot{L} \delta h"
                 r" + \partial_v \dot{L} \delta v_n", first_order(*slow), "and so does that of the latitude"),
            line(r"\rho_n = \frac{v_e}{R_E + h}", EXACT_LINE, "this is the component north of ω_en_n"),
            line(r"\rho_e = -\frac{v_n}{R_N + h}", EXACT_LINE, "this is the component east of ω_en_n"),
            line(r"\delta \dot{l} = (\frac{\rho_n \tan L}{\cos L} - \frac{\rho_n}{(R_E + h) \cos L} R_{EE}) \delta L"
                 r" - \frac{\rho_n}{(R_E + h) \cos L} \delta h + \frac{1}{(R_E + h) \cos L} \delta v_e",
                 first_order(*slow), "ρ_n stands for the velocity east", substitute("12", "4", "5", "6", of="10"),
                 result=True),
            line(r"\delta \dot{L} = \frac{\rho_e}{(R_N + h)} R_{NN} \delta L + \frac{\rho_e}{(R_N + h)} \delta h"
                 r" + \frac{1}{(R_N + h)} \delta v_n", first_order(*slow), "ρ_e stands for the velocity north",
                 substitute("13", "7", "8", "9", of="11"), result=True),
            line(r"\delta \dot{h} = \delta v_u", EXACT_LINE, "the height's rate depends on nothing else",
                 differentiate({r"\dot{h}": r"\delta \dot{h}", "v_u": r"\delta v_u"}, of="3"), result=True),
            unit="rad/s", leads_to=("7",),
            note="It has three slips: ρ_e for ρ_n in the first term, R_E for R_N and the sign of δh in the row of the "
            "latitude. ρ is not defined in the text; no choice of ρ_e and ρ_n among +-v_n/(R_N+h) and +-v_e/(R_E+h) "
            "saves them.",
        ),
        # the phi model
        "10": derived(
            line(r"\dot{v}^n = C_b^n f^b + g^n - (2 \omega_{ie}^n + \omega_{en}^n) \times v^n", EXACT_LINE,
                 "the rate of the velocity is exact for the true state"),
            line(r"\dot{\hat{v}}^n = \hat{C}_b^n \hat{f}^b + \hat{g}^n"
                 r" - (2 \hat{\omega}_{ie}^n + \hat{\omega}_{en}^n) \times \hat{v}^n", EXACT_LINE,
                 "the computer does the same with the computed state"),
            line(r"\delta \dot{v}^n = \dot{\hat{v}}^n - \dot{v}^n", EXACT_LINE, "the error is computed less true"),
            line(rf"\hat{{C}}_b^n = \exp(-{phi_x}) C_b^n", EXACT_LINE, "the attitude errs by φ"),
            line(r"\hat{f}^b = f^b + \delta f^b", EXACT_LINE, "the accelerometers err by δf_b"),
            line(r"\hat{g}^n = g^n + \delta g^n", EXACT_LINE, "gravity is where one believes to be"),
            line(r"\hat{\omega}_{ie}^n = \omega_{ie}^n + \delta \omega_{ie}^n", EXACT_LINE, "so is the Earth's rate"),
            line(r"\hat{\omega}_{en}^n = \omega_{en}^n + \delta \omega_{en}^n", EXACT_LINE,
                 "the transport rate is of the computed state"),
            line(r"\hat{v}^n = v^n + \delta v^n", EXACT_LINE, "and so is the velocity"),
            line(rf"\delta \dot{{v}}^n = \exp(-{phi_x}) C_b^n (f^b + \delta f^b) - C_b^n f^b + \delta g^n"
                 r" - (2 (\omega_{ie}^n + \delta \omega_{ie}^n) + \omega_{en}^n + \delta \omega_{en}^n)"
                 r" \times (v^n + \delta v^n) + (2 \omega_{ie}^n + \omega_{en}^n) \times v^n", EXACT_LINE,
                 "one is taken from the other; gravity cancels",
                 substitute("4", "5", "6", "7", "8", "9", "1", "2", of="3")),
            line(rf"\delta \dot{{v}}^n = -{phi_x} C_b^n f^b + C_b^n \delta f^b + \delta g^n"
                 r" - (2 \delta \omega_{ie}^n + \delta \omega_{en}^n) \times v^n"
                 r" - (2 \omega_{ie}^n + \omega_{en}^n) \times \delta v^n", errors, "products of errors are dropped",
                 expand(r"\phi^n", r"\delta f^b", r"\delta \omega_{ie}^n", r"\delta \omega_{en}^n", r"\delta v^n")),
            line("f^n = C_b^n f^b", EXACT_LINE, "the specific force is carried into n"),
            line(rf"-{phi_x} f^n = [f^n \times] \phi^n", IDENTITY, "-φ x f = f x φ: all signs of the print are right"),
            line(rf"\delta \dot{{v}}^n = -{phi_x} f^n + C_b^n \delta f^b + \delta g^n"
                 r" - (2 \delta \omega_{ie}^n + \delta \omega_{en}^n) \times v^n"
                 r" - (2 \omega_{ie}^n + \omega_{en}^n) \times \delta v^n", errors, "the specific force is put in",
                 substitute("12", of="11")),
            line(rf"\delta \dot{{v}}^n = [f^n \times] \phi^n - ({coriolis}) \delta v^n"
                 r" - (2 [\delta \omega_{ie}^n \times] + [\delta \omega_{en}^n \times]) v^n + \delta g^n"
                 r" + C_b^n \delta f^b", errors, "the terms stand as in the print", multiply_out("13"), result=True),
            unit="m/s^2", leads_to=("7",),
        ),
        "11": derived(
            line(rf"\dot{{C}}_b^n = C_b^n [\omega_{{ib}}^b \times] - {in_x} C_b^n", EXACT_LINE,
                 "the kinematics are exact for the true attitude"),
            line(r"\dot{\hat{C}}_b^n = \hat{C}_b^n [\hat{\omega}_{ib}^b \times]"
                 r" - [\hat{\omega}_{in}^n \times] \hat{C}_b^n", EXACT_LINE,
                 "the computer does the same with the computed one"),
            line(r"\delta \omega_{in}^n = \delta \omega_{ie}^n + \delta \omega_{en}^n", EXACT_LINE,
                 "the Earth's rate errs, and the transport rate"),
            line(r"\hat{\omega}_{in}^n = \omega_{in}^n + \delta \omega_{in}^n", EXACT_LINE,
                 "the computer turns its axes by the rate of where it believes to be and how it believes to move"),
            line(r"\hat{\omega}_{ib}^b = \omega_{ib}^b + \delta \omega_{ib}^b", EXACT_LINE, "the gyros err"),
            line(rf"\hat{{C}}_b^n = \exp(-{phi_x}) C_b^n", EXACT_LINE, "the attitude errs by φ"),
            line(rf"\hat{{C}}_b^n = (I - {phi_x}) C_b^n", phi, "the rotation is small", expand(r"\phi^n")),
            line(rf"\dot{{\hat{{C}}}}_b^n = -[\dot{{\phi}}^n \times] C_b^n + (I - {phi_x}) \dot{{C}}_b^n", errors,
                 "each side changes with time", differentiate({r"\hat{C}_b^n": r"\dot{\hat{C}}_b^n",
                 r"\phi^n": r"\dot{\phi}^n", "C_b^n": r"\dot{C}_b^n"})),
            line(rf"(I - {phi_x}) C_b^n [(\omega_{{ib}}^b + \delta \omega_{{ib}}^b) \times]"
                 rf" - [(\omega_{{in}}^n + \delta \omega_{{in}}^n) \times] (I - {phi_x}) C_b^n"
                 rf" = -[\dot{{\phi}}^n \times] C_b^n + (I - {phi_x}) (C_b^n [\omega_{{ib}}^b \times] - {in_x} C_b^n)",
                 errors, "both kinematics are put in", substitute("4", "5", "7", "1", "2")),
            line(rf"C_b^n [\omega_{{ib}}^b \times] - {in_x} C_b^n + C_b^n {gyro_x}"
                 rf" - [\delta \omega_{{in}}^n \times] C_b^n - {phi_x} C_b^n [\omega_{{ib}}^b \times]"
                 rf" + {in_x} {phi_x} C_b^n"
                 rf" = -[\dot{{\phi}}^n \times] C_b^n + C_b^n [\omega_{{ib}}^b \times] - {in_x} C_b^n"
                 rf" - {phi_x} C_b^n [\omega_{{ib}}^b \times] + {phi_x} {in_x} C_b^n", errors,
                 "products of errors are dropped",
                 expand(r"\phi^n", r"\dot{\phi}^n", r"\delta \omega_{ib}^b", r"\delta \omega_{in}^n")),
            line(rf"-[\dot{{\phi}}^n \times] C_b^n = {in_x} {phi_x} C_b^n - {phi_x} {in_x} C_b^n"
                 rf" - [\delta \omega_{{in}}^n \times] C_b^n + C_b^n {gyro_x}", errors,
                 "what stands on both sides is left out", rearrange()),
            line(rf"-[\dot{{\phi}}^n \times] = {in_x} {phi_x} - {phi_x} {in_x}"
                 rf" - [\delta \omega_{{in}}^n \times] + C_b^n {gyro_x} C_n^b", errors,
                 "the inverse of C_b2n stands on the right", multiply(right="C_n^b")),
            line(rf"{in_x} {phi_x} - {phi_x} {in_x} = [(\omega_{{in}}^n \times \phi^n) \times]", IDENTITY,
                 "two skew-symmetric matrices make a third"),
            line(rf"C_b^n {gyro_x} C_n^b = [(C_b^n \delta \omega_{{ib}}^b) \times]", IDENTITY,
                 "a rotation turns the axis of a skew-symmetric matrix"),
            line(r"-[\dot{\phi}^n \times] = [(\omega_{in}^n \times \phi^n - \delta \omega_{in}^n"
                 r" + C_b^n \delta \omega_{ib}^b) \times]", errors, "each side is one matrix",
                 multiply_out("13", "14", of="12")),
            line(r"-\dot{\phi}^n = \omega_{in}^n \times \phi^n - \delta \omega_{in}^n + C_b^n \delta \omega_{ib}^b",
                 errors,
                 "δω_in_n turns the computed axes away just as the gyro's error turns the body, with the opposite sign",
                 take_vector()),
            line(r"\omega_{in}^n = \omega_{ie}^n + \omega_{en}^n", EXACT_LINE, "the Earth turns, and n on it"),
            line(r"-\dot{\phi}^n = ([\omega_{ie}^n \times] + [\omega_{en}^n \times]) \phi^n"
                 r" - (\delta \omega_{ie}^n + \delta \omega_{en}^n) + C_b^n \delta \omega_{ib}^b", errors,
                 "each rate has two parts", substitute("3", "17", of="16")),
            line(r"\dot{\phi}^n = -([\omega_{ie}^n \times] + [\omega_{en}^n \times]) \phi^n"
                 r" + (\delta \omega_{ie}^n + \delta \omega_{en}^n) - C_b^n \delta \omega_{ib}^b", errors,
                 "the sign is turned", multiply(left="-1"), result=True),
            unit="rad/s", leads_to=("7",),
            note="With the printed sign a computed velocity turns the level the wrong way, "
            "and Schuler's loop diverges.",
        ),
    }


# ---- Prediction, and what is measured --------------------------------------------------------------------------------


def azimuth() -> dict[str, Derived]:
    phi = first_order("phi")
    phi_x = r"[\phi^n \times]"
    P_after = "P_{k-1}^+"
    step = r"\Phi_{k-1}"
    left = rf"({step} \xi_{{k-1}} + \eta_{{k-1}} - x_k^-)"
    grown = rf"({step} (\xi_{{k-1}} - x_{{k-1}}^+) + \eta_{{k-1}})"
    phi_matrix = column(r"0 & -\phi_u & \phi_n", r"\phi_u & 0 & -\phi_e", r"-\phi_n & \phi_e & 0")
    entries = column(r"1 & \phi_u & -\phi_n", r"-\phi_u & 1 & \phi_e", r"\phi_n & -\phi_e & 1")
    in_p, in_b = column("X^p", "Y^p", "Z^p"), column("X^b", "Y^b", "Z^b")
    H_v = column(r"0_{3 \times 3} & I_{3 \times 3} & 0_{3 \times 9}")
    H = column(
        r"0_{3 \times 3} & I_{3 \times 3} & 0_{3 \times 3} & 0_{3 \times 6}",
        r"0_{1 \times 3} & 0_{1 \times 3} & 0 \ 0 \ 1 & 0_{1 \times 6}",
    )
    reference = r"C_b^p \overline{C}_n^b"
    twenty_four = "Columns for 24 states, here and in (17) and (23) alike: nine more than (8) has."
    return {
        "12": derived(
            line(r"\Phi_k = \exp(F_k \Delta T)", EXACT_LINE, "F_k is held constant over the step"),
            line(r"\Phi_k = I_{15 \times 15} + F_k \Delta T", first_order("step"),
                 "ΔT is short; what is dropped is in the evidence", expand(r"\Delta T"), result=True),
            readings=(Reading(S.One, _letter("I_15x15"), "a number beside a matrix: the identity is meant"),),
            leads_to=("13", "14"), small=("step",),
        ),
        "13": derived(
            line(rf"x_k^- = \mathrm{{E}}[{step} \xi_{{k-1}} + \eta_{{k-1}}]", EXACT_LINE,
                 "the prediction is the mean of the errors after one step, with the exact Φ"),
            line(rf"x_k^- = {step} \mathrm{{E}}[\xi_{{k-1}}] + \mathrm{{E}}[\eta_{{k-1}}]", EXACT_LINE,
                 "the expectation is linear", multiply_out()),
            line(r"\mathrm{E}[\xi_{k-1}] = x_{k-1}^+", EXACT_LINE, "the estimate before is their mean"),
            line(r"\mathrm{E}[\eta_{k-1}] = 0", EXACT_LINE, "the noise has none"),
            line(rf"x_k^- = {step} x_{{k-1}}^+", EXACT_LINE, "the errors pass over one step without noise",
                 substitute("3", "4", of="2", letters=(r"\xi_{k-1}", r"\eta_{k-1}")), result=True),
            leads_to=("25",),
        ),
        "14": derived(
            line(rf"P_k^- = \mathrm{{E}}[{left} {left}^T]", EXACT_LINE,
                 "it is the square of what (13) and the noise leave"),
            line(r"\mathrm{E}[\eta_{k-1}] = 0", EXACT_LINE, "the noise has no mean"),
            line(rf"P_k^- = \mathrm{{E}}[{grown} {grown}^T]", EXACT_LINE, "the prediction is that of (13)",
                 substitute("(13)", of="1")),
            line(rf"P_k^- = {step} \mathrm{{E}}[(\xi_{{k-1}} - x_{{k-1}}^+) (\xi_{{k-1}} - x_{{k-1}}^+)^T] {step}^T"
                 r" + \mathrm{E}[\eta_{k-1} \eta_{k-1}^T]", EXACT_LINE,
                 "the noise knows nothing of the errors before", substitute("2", of="3", letters=(r"\eta_{k-1}",))),
            line(rf"{P_after} = \mathrm{{E}}[(\xi_{{k-1}} - x_{{k-1}}^+) (\xi_{{k-1}} - x_{{k-1}}^+)^T]", EXACT_LINE,
                 "this is the covariance before"),
            line(r"Q_k = \mathrm{E}[\eta_{k-1} \eta_{k-1}^T]", EXACT_LINE, "Q is what the noise gathers over a step"),
            line(rf"P_k^- = {step} {P_after} {step}^T + Q_k", EXACT_LINE, "both covariances are put in",
                 substitute("5", "6", of="4"), result=True),
            line(rf"\dot{{P}}_{{k-1}} = F_k {P_after} + {P_after} F_k^T + W", EXACT_LINE,
                 "in a short step it grows so, for noise of density W"),
            leads_to=("24",),
        ),
        "15": derived(
            line(r"z_k = [v_e + \delta v_e \ v_n + \delta v_n \ v_u + \delta v_u \ \phi_u]^T", EXACT_LINE,
                 "the errors of the velocity are put into (22)", substitute("(28)", "(28).2", "(28).3", of="(22)",
                 letters=(r"\hat{v}_e", r"\hat{v}_n", r"\hat{v}_u"))),
            line(r"H_k x_k = [\delta v_e \ \delta v_n \ \delta v_u \ \phi_u]^T", EXACT_LINE,
                 "H_k is what the measurement sees of the states"),
            line(r"\nu_k = [v_e \ v_n \ v_u \ 0]^T", EXACT_LINE,
                 "what the true velocity really is, where it is called zero, is the noise; also for (16), (17)"),
            line(r"H_k x_k + \nu_k = [v_e + \delta v_e \ v_n + \delta v_n \ v_u + \delta v_u \ \phi_u]^T",
                 EXACT_LINE, "both are added row by row", add_line("3", of="2")),
            line(r"z_k = H_k x_k + \nu_k", EXACT_LINE, "all sides stand in one line", chain("1", "4"), result=True),
            line(r"z_v = H_v x_k + \nu_z", EXACT_LINE, "the rows of the velocity are taken alone",
                 take_rows(1, 2, 3), result=True),
            leads_to=("16", "22"),
        ),
        "16": derived(
            line(r"z_v = v^n + \delta v^n", EXACT_LINE,
                 "it is the computed velocity, less the true one, which is zero at rest"),
            defines=("z_v",), leads_to=("17",),
        ),
        "17": derived(
            line(r"z_v = v^n + \delta v^n", EXACT_LINE, "v̂ is v + δv"),
            line(rf"z_v = v^n + {H_v} x_k", EXACT_LINE, "after position and velocity, nine states of (8) remain",
                 multiply_out()),
            line(r"H_v x_k + \nu_z = v^n + " + rf"{H_v} x_k", EXACT_LINE, "(15) says the same", chain("(15).2", "2")),
            line(f"H_v = {H_v}", EXACT_LINE, "whatever the states are", identify("x_k"), result=True),
            line(r"H_v = \flown{zero_velocity_matrix}", EXACT_LINE, "the function that flies is the same",
                 multiply_out()),
            note=twenty_four,
        ),
        "18": derived(
            line(rf"C_b^p = \exp(-{phi_x}) C_b^n", EXACT_LINE, "p is n turned by φ: components turn by -φ"),
            line(rf"C_b^p = (I - {phi_x}) C_b^n", phi, "the error is small", expand(r"\phi^n")),
            line(f"{in_p} = C_b^p {in_b}", EXACT_LINE, "components pass from b to p"),
            line(f"{in_p} = (I - {phi_x}) (C_b^n {in_b})", phi, "the small rotation is put in", substitute("2")),
            line(f"{phi_x} = {phi_matrix}", IDENTITY, "a vector has this matrix"),
            line(f"{in_p} = (I - {phi_matrix}) (C_b^n {in_b})", phi, "each entry is written out",
                 multiply_out("5", of="4")),
            line(f"{in_p} = (I - {phi_matrix}) (C_b^n {in_b}) = C_b^p {in_b}", phi, "all sides stand in one line",
                 chain("3", "6"), result=True),
            leads_to=("19",),
        ),
        "19": derived(
            line(rf"C_b^p = \exp(-{phi_x}) C_b^n", EXACT_LINE, "p is n turned by φ: components turn by -φ"),
            line(rf"C_b^p = (I - {phi_x}) C_b^n", phi, "the error is small", expand(r"\phi^n")),
            line(rf"\check{{\Phi}} = {phi_x}", EXACT_LINE, "it is the name"),
            line(r"C_b^p = (I - \check{\Phi}) C_b^n", phi, "so they are called", substitute("3", of="2"), result=True),
            line(rf"\check{{\Phi}} = {phi_matrix}", EXACT_LINE, "a vector has this matrix", multiply_out(of="3"),
                 result=True),
            leads_to=("20",),
        ),
        "20": derived(
            line(rf"{reference} = (I - \check{{\Phi}}) C_b^n \overline{{C}}_n^b", phi,
                 "(19) is taken to the axes of the transfer alignment",
                 multiply(right=r"\overline{C}_n^b", of="(19)")),
            line(r"C_b^n \overline{C}_n^b = I", EXACT_LINE, "the reference is right"),
            line(rf"{reference} = I - \check{{\Phi}}", phi,
                 "the bracket is all of I - Φ̌, and the factor before it is one too many",
                 substitute("2", of="1", letters=(r"\overline{C}_n^b",))),
            line(f"{reference} = {entries}", phi, "each entry is written out", substitute("(19).2")),
            line(rf"{reference} = (I - \check{{\Phi}}) C_b^n \overline{{C}}_n^b = {entries}", phi,
                 "all sides stand in one line", chain("1", "4"), result=True),
            leads_to=("21",),
            note="The factor I - Φ̌ is one too many, for the matrix behind it is that factor. The tag (20) is at the "
            "end of a block whose last row the text calls (21).",
        ),
        "21": derived(
            line(f"{reference}(1,2) = \\phi_u", phi, "(20) has it", take_entry(1, 2, of="(20)")),
            line(f"{reference}(2,1) = -\\phi_u", phi, "(20) has it", take_entry(2, 1, of="(20)")),
            line(rf"{reference}(1,2) - {reference}(2,1) = 2 \phi_u", of_order(2, "phi"),
                 "the skew-symmetric part has no second order in φ", subtract_line("2", of="1")),
            line(rf"\phi_u = ({reference}(1,2) - {reference}(2,1))/2", of_order(2, "phi"),
                 "the mean of both is taken", multiply(left=r"\frac{1}{2}"), result=True),
            unit="rad", leads_to=("22",),
            note="The true C_b2n is not known to the filter; with it the second entry is 0 and the half of φ_u "
            "remains. An error of the reference enters with its full size, constant in time.",
        ),
        "22": derived(
            line("z_k = " + column("z_v", r"\phi_u"), EXACT_LINE, "(16) stands over the azimuth error of (21)"),
            defines=("z",), leads_to=("23",),
        ),
        "23": derived(
            line("z_k = " + column(r"v^n + \delta v^n", r"\phi_u"), EXACT_LINE, "the velocity stands over φ_u"),
            line(rf"z_k = {column('v^n', '0')} + {H} x_k", EXACT_LINE,
                 "after the attitude, six states of (8) remain", multiply_out()),
            line(rf"H_k x_k + \nu_k = {column('v^n', '0')} + {H} x_k", EXACT_LINE, "(15) says the same",
                 chain("(15)", "2")),
            line(f"H_k = {H}", EXACT_LINE, "whatever the states are", identify("x_k"), result=True),
            line(r"H_k = \flown{hold_measurement_matrix}", EXACT_LINE, "the function that flies is the same",
                 multiply_out()),
            note=twenty_four,
        ),
    }


def _letter(name: str) -> Symbol:
    (found,) = {quantity.symbol for quantity in quantities() if quantity.symbol.name == name}
    return found


# ---- 2.2.3 Update and feedback ---------------------------------------------------------------------------------------


def update() -> dict[str, Derived]:
    phi = first_order("phi")
    seen = "H_k^T R^{-1}"
    information = rf"((P_k^-)^{{-1}} + {seen} H_k)"
    innovation = r"(H_k P_k^- H_k^T + R)"
    residual = r"(z_k - H_k x_k^-)"
    move = r"(x_k^+ - x_k^-)"
    rest = r"(z_k - H_k x_k^+)"
    kept = r"(I_{15 \times 15} - K_k H_k)"
    wrong = r"(x_k^- + K_k (H_k \xi_k + \zeta_k - H_k x_k^-) - \xi_k)"
    split = rf"({kept} (x_k^- - \xi_k) + K_k \zeta_k)"
    beside = column("0", r"\phi^n")
    angle = column(r"\phi_e", r"\phi_n", r"\phi_u")
    return {
        "24": derived(
            line(rf"P_k^+ = {information}^{{-1}}", EXACT_LINE, "information of prediction and of measurement add"),
            line(rf"K_k = P_k^+ {seen}", EXACT_LINE, "least squares, (25), ask for this gain"),
            line(rf"{information} P_k^- H_k^T = {seen} {innovation}", IDENTITY, "both are H' + H' R^-1 H P H'"),
            line(rf"P_k^- H_k^T {innovation}^{{-1}} = {information}^{{-1}} {seen}", IDENTITY,
                 "this is the lemma of matrix inversion",
                 multiply(left=rf"{information}^{{-1}}", right=rf"{innovation}^{{-1}}")),
            line(rf"K_k = {information}^{{-1}} {seen}", EXACT_LINE, "this covariance is put in",
                 substitute("1", of="2")),
            line(rf"K_k = P_k^- H_k^T {innovation}^{{-1}}", EXACT_LINE, "the lemma says so", multiply_out("4"),
                 result=True),
            leads_to=("25", "26"), note="H without its index k: a label.",
        ),
        "25": derived(
            line(rf"J = {move}^T (P_k^-)^{{-1}} {move} + {rest}^T R^{{-1}} {rest}", DEFINITION,
                 "the squares of x - x(k-) and of z - H x add, each weighted by its covariance"),
            line(rf"\dot{{J}} = 2 u^T ((P_k^-)^{{-1}} {move} - {seen} {rest})", DEFINITION,
                 "the estimate changes by u", differentiate({"J": r"\dot{J}", "x_k^+": "u"})),
            line(rf"(P_k^-)^{{-1}} {move} - {seen} {rest} = 0", EXACT_LINE, "the estimate is where they are least",
                 find_minimum("u")),
            line(rf"{information} {move} = {seen} {residual}", EXACT_LINE,
                 "z - H x(k+) is the innovation less H of the correction", rearrange()),
            line(rf"x_k^+ - x_k^- = {information}^{{-1}} {seen} {residual}", EXACT_LINE,
                 "the correction is solved for", multiply(left=rf"{information}^{{-1}}")),
            line(rf"x_k^+ - x_k^- = K_k {residual}", EXACT_LINE, "this is the gain of (24)", substitute("(24)")),
            line(r"x_k^+ = x_k^- + K_k (z_k - H_k x_k^-)", EXACT_LINE,
                 "measured less predicted is added: the sign is right", add("x_k^-"), result=True),
            leads_to=("27", "28", "29"), note="The sign is right: the residual is measured less predicted.",
        ),
        "26": derived(
            line(rf"P_k^+ = \mathrm{{E}}[{wrong} {wrong}^T]", EXACT_LINE,
                 "it is the square of what (25) leaves of an error of which H x and noise are measured"),
            line(rf"P_k^+ = \mathrm{{E}}[{split} {split}^T]", EXACT_LINE, "one part is left, and one is added",
                 multiply_out()),
            line(r"\mathrm{E}[\zeta_k] = 0", EXACT_LINE, "the noise has no mean"),
            line(r"P_k^- = \mathrm{E}[(\xi_k - x_k^-) (\xi_k - x_k^-)^T]", EXACT_LINE,
                 "this is the predicted covariance"),
            line(r"R = \mathrm{E}[\zeta_k \zeta_k^T]", EXACT_LINE, "this is the covariance of the noise"),
            line(rf"P_k^+ = {kept} P_k^- {kept}^T + K_k R K_k^T", EXACT_LINE,
                 "this is Joseph's form, right with any gain: the noise knows nothing of the error",
                 substitute("3", "4", "5", of="2", letters=(r"\zeta_k", "", ""))),
            line(r"P_k^+ = [I_{15 \times 15} - K_k H_k] P_k^-", EXACT_LINE,
                 "it holds with the gain of (24) alone, for which K (H P H' + R) = P H'", substitute("(24)"),
                 result=True),
            line(rf"P_k^+ = {information}^{{-1}}", EXACT_LINE, "it is the information of (24)",
                 substitute("(24)", of="6")),
        ),
        "27": derived(
            line(r"\delta l = \hat{l} - l", EXACT_LINE, "an error is computed less true"),
            line(r"l = \hat{l} - \delta l", EXACT_LINE, "so it is taken off", rearrange(), result=True),
            line(r"\delta L = \hat{L} - L", EXACT_LINE, "and so does that of the latitude"),
            line(r"L = \hat{L} - \delta L", EXACT_LINE, "so it is taken off", rearrange(), result=True),
            line(r"\delta h = \hat{h} - h", EXACT_LINE, "so does the height"),
            line(r"h = \hat{h} - \delta h", EXACT_LINE, "so it is taken off", rearrange(), result=True),
            defines=("δl", "δL", "δh"), leads_to=("9",),
            note="A letter is lost after δ; its two neighbours show it, and the text under (8) has it.",
        ),
        "28": derived(
            *(step for axis in "enu" for step in (
                line(rf"\delta v_{axis} = \hat{{v}}_{axis} - v_{axis}", EXACT_LINE, "an error is computed less true"),
                line(rf"v_{axis} = \hat{{v}}_{axis} - \delta v_{axis}", EXACT_LINE, "so it is taken off", rearrange(),
                     result=True),
            )),
            defines=("δv_e", "δv_n", "δv_u"), leads_to=("9", "10"),
        ),
        "29": derived(
            line(r"\Delta Q = \hat{Q} - Q", EXACT_LINE,
                 "ΔQ is an error to be taken off, as in (27), no rotation to be multiplied with"),
            line(r"Q = \hat{Q} - \Delta Q", EXACT_LINE, "so it is taken off", rearrange(), result=True),
            line(r"\hat{Q} = V Q", EXACT_LINE,
                 "(19) with quaternions: the computed attitude is the true one turned by -φ, which is V"),
            line(r"\bar{V} \hat{Q} = Q", EXACT_LINE, "it is turned back", multiply(left=r"\bar{V}")),
            line(r"\Delta Q = \hat{Q} - \bar{V} \hat{Q}", EXACT_LINE, "the computed attitude is put in",
                 substitute("4", of="1")),
            line(r"\bar{V} = " + column("1", r"\frac{1}{2} \phi^n"), phi,
                 "it has half the angle, of which the cosine is 1 to first order"),
            line(rf"\Delta Q = -\frac{{1}}{{2}} {beside} \hat{{Q}}", phi, "a quaternion with 0 beside φ is left",
                 substitute("6", of="5")),
            line(rf"\Delta Q = -\frac{{1}}{{2}} \flown{{quaternion_error}} {angle}", phi,
                 "a quaternion multiplies from the right, and its first column meets the 0", multiply_out(),
                 result=True),
            note="Three slips: the first column of the matrix, which only a fourth component 0 before φ could meet; "
            "the product where the sum belongs; and, if the product stays, the sign, for a rotation that takes the "
            "error out is [1, +φ/2]. An exact rotation is Song-Lee (23), (24).",
        ),
    }


# ---- 2.2.4 Detector --------------------------------------------------------------------------------------------------


def detector() -> dict[str, Derived]:
    total = r"\frac{1}{N} \sum_{k \in \Omega_n}"
    apart = r"(y_k^a - \bar{y}_n^a)"
    return {
        "30": derived(
            line(r"y_k^a = s_k^a(\theta) + \nu_k^a", EXACT_LINE,
                 "what the accelerometers show is what acts on them, and noise"),
            line(r"y_k^w = s_k^\omega(\theta) + \nu_k^\omega", EXACT_LINE, "the gyros show so too"),
            defines=("y_k", "s_k", "ν_y"), leads_to=("31", "32"),
        ),
        "31": derived(
            line(rf"S_a = {total} ({apart} {apart}^T)", DEFINITION,
                 "this is the covariance of the accelerometers over the window"),
            line("T_a^2 = S_a(1,1) + S_a(2,2) + S_a(3,3)", EXACT_LINE,
                 "the moving deviation comes from the trace of that covariance"),
            line(rf"T_a^2 = {total} \|y_k^a - \bar{{y}}_n^a\|^2", EXACT_LINE, "the trace of v v' is the square of v",
                 substitute("1")),
            line(rf"T_a = \sqrt{{{total} \|y_k^a - \bar{{y}}_n^a\|^2}} < \gamma_a", EXACT_LINE,
                 "at rest it is small", take_root(), result=True),
            unit="m/s^2",
            note="The text over (31) says twice that the angular rate is used, for its mean and for its deviation; its "
            "own argument, and the superscript a of (31), want the deviation of the acceleration.",
        ),
        "32": derived(
            line(rf"\bar{{y}}_n^w = {total} y_k^w", EXACT_LINE, "this is the mean of the gyros over the window"),
            line(r"T_w = \|\bar{y}_n^w\|", EXACT_LINE,
                 "its length is taken: a vector is not less than a number, and its components may be negative"),
            line(rf"T_w = \|{total} y_k^w\| < \gamma_w", EXACT_LINE, "at rest it is small", substitute("1"),
                 result=True),
            line(rf"\bar{{y}}_n^a = {total} y_k^a", EXACT_LINE, "this is the mean of the accelerometers", result=True),
            unit="rad/s", note="w stands for ω: a label. At rest T_w is the Earth's rate and the bias, not zero.",
        ),
        "Ω_n": derived(
            line("N = m - n + 1", EXACT_LINE, "samples from the n-th to the m-th are counted"),
            line("m = n + N - 1", EXACT_LINE, "the last of them follows", solve_for("m")),
            line(r"\Omega_n = \{n \leq i \leq m\}", EXACT_LINE, "the window holds them"),
            line(r"\Omega_n = \{n \leq i \leq n + N - 1\}", EXACT_LINE,
                 "N samples stand from the n-th on; the print has N - n of them, none from n = N on",
                 substitute("2"), result=True),
            defines=("Ω_n",), leads_to=("31", "32"),
            note="N samples are meant, for (31) and (32) divide by N. The index is k there and l here: a label.",
        ),
    }
