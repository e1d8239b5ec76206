"""The numbered equations as they are printed, each beside its derivation."""

from functools import cache
from unicodedata import normalize

from sympy import ImmutableMatrix, Matrix, eye
from sympy.simplify.fu import TR2i

from boresight.derive.expressions import unnamed
from boresight.derive.ledger.equation import Equation, Meaning, Reading, total
from boresight.derive.ledger.lines import (
    EXACT_LINE,
    IDENTITY,
    Derived,
    build,
    derived,
    first_order,
    line,
    prose,
)
from boresight.derive.ledger.passages import (
    add,
    chain,
    differentiate,
    elsewhere,
    expand,
    multiply,
    multiply_out,
    rearrange,
    stack,
    substitute,
    subtract_line,
    take_quaternion,
    take_rotation_vector,
    take_rows,
    take_vector,
)
from boresight.derive.mechanics.rotation import TINY_SQUARE, dcm_from_euler
from boresight.derive.papers.song_lee_2001.letters import letters
from boresight.derive.papers.song_lee_2001.printed import PRINTED, quantities
from boresight.derive.papers.song_lee_2001.results import (
    attitude_error_matrix,
    attitude_noise_matrix,
    axes_after_yaw,
    axes_before_roll,
    beta_D_euler,
    corrected_misalignment,
    corrected_quaternion,
    eps_D_euler,
    error_quaternion,
    euler_D_beta,
    euler_D_eps,
    measurement_matrix,
    relative_euler,
)

NAME = "song-lee-2001"


@cache
def equations() -> tuple[Equation, ...]:
    """The 28 numbered equations, in the paper's order."""
    return build(NAME, PRINTED, WRITTEN, quantities(), letters(), flown())


def flown() -> dict[str, object]:
    r"""What \flown{name} stands for: the matrices of results.py in the paper's letters, with its tangents."""
    letter = {one.symbol.name: one.symbol for one in (*quantities(), *letters()) if not one.function}

    def s(names: str) -> tuple:
        return tuple(letter[name] for name in names.split())

    def layout(M) -> ImmutableMatrix:
        return ImmutableMatrix(Matrix(M).applyfunc(TR2i))

    euler = phi, theta, psi = s("φ θ ψ")
    euler_b, euler_r = s("φ_b θ_b ψ_b"), s("φ_r θ_r ψ_r")
    turn = s("Δq_0 Δq_1 Δq_2 Δq_3")
    mu, eps, omega = s("μ_x μ_y μ_z"), s("ε_n ε_e ε_d"), s("ω_n ω_e ω_d")
    C, H = dcm_from_euler(*euler), layout(measurement_matrix(euler_b, euler_r))
    before, missed = s("μ̂(k-) δμ(k)")
    quaternion = unnamed(error_quaternion(eps))
    corrected = unnamed(corrected_quaternion(s("q̂_0 q̂_1 q̂_2 q̂_3"), eps))
    corrected = corrected.subs(dict(zip(quaternion, turn, strict=True)))
    found = {
        "C_b2n": ImmutableMatrix(C),
        "noise": ImmutableMatrix(attitude_noise_matrix(C)),
        "axes_after_yaw": ImmutableMatrix(axes_after_yaw(theta)),
        "axes_before_roll": ImmutableMatrix(axes_before_roll(theta)),
        "inverse_after_yaw": layout(axes_after_yaw(theta).lower_triangular_solve(eye(3))),
        "inverse_before_roll": layout(axes_before_roll(theta).upper_triangular_solve(eye(3))),
        "eps_D_euler": ImmutableMatrix(eps_D_euler(theta, psi)),
        "euler_D_eps": layout(euler_D_eps(theta, psi)),
        "beta_D_euler": ImmutableMatrix(beta_D_euler(phi, theta)),
        "euler_D_beta": layout(euler_D_beta(phi, theta)),
        "euler_D_mu": layout(relative_euler(euler_r, mu).jacobian(Matrix(mu))),
        "H": H,
        "H_eps": H[:, :3],
        "H_mu": -H[:, 3:],
        "F": ImmutableMatrix(attitude_error_matrix(omega)),
        "quaternion": ImmutableMatrix(quaternion.subs(TINY_SQUARE, 0)),
        "corrected_quaternion": ImmutableMatrix(corrected),
        # The function's own terms, in the order of the page.
        "corrected_mu": total(*sorted(corrected_misalignment(before, missed).args, key=lambda term: term != before)),
    }
    found |= {f"change_{angle.name}": ImmutableMatrix(C.diff(angle)) for angle in euler}
    found |= {f"H_eps_{i}": H[i - 1, :3] for i in (1, 2, 3)}
    found |= {f"H_mu_{i}": -H[i - 1, 3:] for i in (1, 2, 3)}
    return found


# ---- The derivations -------------------------------------------------------------------------------------------------


def column(*entries: str) -> str:
    return r"\begin{bmatrix} " + r" \\ ".join(entries) + r" \end{bmatrix}"


def angles(mark: str, script: str = "") -> tuple[str, ...]:
    return tuple(mark.format(letter) + script for letter in (r"\phi", r"\theta", r"\psi"))


def change_of(true: tuple[str, ...], error: tuple[str, ...]) -> str:
    return rf"\Delta C[({', '.join(true)}), ({', '.join(error)})]"


def attitude_of(euler: tuple[str, ...]) -> str:
    return rf"\hat{{C}}_b^n({', '.join(euler)})"


TRUE, TRUE_B, TRUE_R = angles("{}"), angles("{}", "_b"), angles("{}", "_r")
HAT, HAT_B, HAT_R = angles(r"\hat{{{}}}"), angles(r"\hat{{{}}}", "_b"), angles(r"\hat{{{}}}", "_r")
ERROR, ERROR_B, ERROR_R = angles(r"\delta{}"), angles(r"\delta{}", "_b"), angles(r"\delta{}", "_r")
GAP, GAP_HAT = angles(r"\Delta{}"), angles(r"\hat{{\Delta{}}}")
D, D_B, D_R = column(*ERROR), column(*ERROR_B), column(*ERROR_R)
EPS = column(r"\epsilon_n", r"\epsilon_e", r"\epsilon_d")
BETA, MU, MU_HAT, D_MU = (
    column(*(rf"{letter}_{axis}" for axis in "xyz")) for letter in (r"\beta", r"\mu", r"\hat{\mu}", r"\delta\mu")
)
STATES = column(r"\epsilon_n", r"\epsilon_e", r"\epsilon_d", r"\delta\mu_x", r"\delta\mu_y", r"\delta\mu_z")
X = column(*(f"X_{i}" for i in range(1, 7)))
# The matrices of the six states, as they are derived and as the model has them.
STATE_MATRIX = r"\begin{bmatrix} -\Omega_{in}^n & 0 \\ 0 & 0 I \end{bmatrix}"
STATE_NOISE = r"\begin{bmatrix} -C_b^n \\ 0 I \end{bmatrix}"
STATES_MEASURED = r"\begin{bmatrix} -A_3(\theta_b)^{-1} R_3(\psi_b)^T & -A_1(\theta_r)^{-1} R_1(\phi_r) \end{bmatrix}"
PARTS = column(r"\epsilon^n", r"\delta\mu^r")
RATES = column(r"\dot{\epsilon}^n", r"\delta\dot{\mu}^r")
RATE_OF_EPS, RATE_OF_D_MU = r"-\Omega_{in}^n \epsilon^n - C_b^n \delta\omega^b", r"\dot{\hat{\mu}}^r - \dot{\mu}^r"
COMPUTED, CHANGE = attitude_of(HAT), change_of(TRUE, ERROR)
BY_ESTIMATE = tuple(f"{angle} + {gap}" for angle, gap in zip(TRUE_R, GAP_HAT, strict=True))
CHANGE_R = change_of(TRUE_R, GAP)
TURNS, TURNS_BACK = r"R_3(\psi) R_2(\theta) R_1(\phi)", r"R_1(\phi)^T R_2(\theta)^T R_3(\psi)^T"
TURNS_BACK_R = r"R_1(\phi_r)^T R_2(\theta_r)^T R_3(\psi_r)^T"
FIRST = first_order("euler_error")
SMALL = "the errors are small, and their products are dropped"


def _error_of(letter: str, name: str) -> Derived:
    why = "the error of an angle is computed less true; nothing to prove, all that follows rests on it"
    return derived(prose(why), unit="rad", defines=(name,), leads_to=("5", "17"))


def _dropped_hat(name: str, why: str) -> Reading:
    known = {quantity.symbol.name: quantity.symbol for quantity in quantities()}
    hat = name + "\u0302" if name[0] == "Δ" else name.replace("μ", "μ\u0302")
    return Reading(known[name], known[normalize("NFC", hat)], f"{why}: a dropped hat")


ERROR_OF_MU = Meaning(
    (
        ("δμ is μ̂ - μ", ()),
        (
            "δμ is μ - μ̂",
            (("δμ(k)", r"-\delta\mu^r(k)"), *((f"δμ_{axis}", rf"-\delta\mu_{axis}") for axis in "xyz")),
        ),
    ),
    stated_in="line 126",
)


def _row(i: int, word: str) -> Derived:
    letter, name = TRUE[i - 1], "φθψ"[i - 1]
    measured = rf"{HAT_B[i - 1]} - {HAT_R[i - 1]} - {GAP_HAT[i - 1]}"
    modelled = rf"\flown{{H_eps_{i}}} {EPS} - \flown{{H_mu_{i}}} {D_MU} - \delta{letter}_r"
    Z = rf"Z_{{{word}}}"
    return derived(
        line(f"{Z} = {measured}", EXACT_LINE, f"row {i} of (16)", take_rows(i, of="(16)")),
        line(f"{Z} = {modelled}", first_order(), f"row {i} of (19): a {word} matching", take_rows(i, of="(19)")),
        line(f"{Z} = {measured} = {modelled}", first_order(), "both say what it is", chain("1", "2"), result=True),
        unit="rad",
        readings=(_dropped_hat(f"Δ{name}", "(16) subtracts the computed difference, and the true one is not known"),),
    )  # fmt: skip


WRITTEN: dict[str, Derived] = {
    # The errors of the angles, for the slave and, with the index r, for the master.
    "1": _error_of("φ", "φ\u0302"),
    "2": _error_of("θ", "θ\u0302"),
    "3": _error_of("ψ", "ψ\u0302"),
    # The computed angles describe the body in axes n' that are turned from n by eps.
    "4": derived(
        line(rf"{COMPUTED} = C_b^{{n'}}", EXACT_LINE,
             "the computer takes the axes n', turned from n by ε, for n: this says what n' is"),
        line(r"C_b^{n'} = C_n^{n'} C_b^n", EXACT_LINE, "components pass from b to n and from n to n'"),
        line(rf"{COMPUTED} = C_n^{{n'}} C_b^n", EXACT_LINE, "C_b2n' stands in both", chain("1", "2"), result=True),
        unit="1", leads_to=("5", "6"), introduces=("C_n2n'",),
    ),
    # The left side to first order in the errors of the angles.
    "5": derived(
        line(rf"{COMPUTED} = R_3(\hat{{\psi}}) R_2(\hat{{\theta}}) R_1(\hat{{\phi}})", IDENTITY,
             "an attitude is made of three turns: yaw, then pitch, then roll"),
        line(rf"{COMPUTED} = R_3(\psi + \delta\psi) R_2(\theta + \delta\theta) R_1(\phi + \delta\phi)", EXACT_LINE,
             "(1) to (3) give the computed angles", substitute("(1)", "(2)", "(3)")),
        line(rf"{TURNS} = \flown{{C_b2n}}", IDENTITY, "the turns by the true angles, multiplied out"),
        *(
            line(rf"\frac{{\partial C_b^n}}{{\partial{angle}}} = \flown{{change_{name}}}", IDENTITY,
                 f"by the {word} alone", differentiate({angle: "1"}, of="3"))
            for angle, name, word in zip(TRUE, "φθψ", ("roll", "pitch", "yaw"), strict=True)
        ),
        line(CHANGE + " = " + " + ".join(
            rf"\frac{{\partial C_b^n}}{{\partial{angle}}} {error}" for angle, error in zip(TRUE, ERROR, strict=True)),
            IDENTITY, "ΔC is the sum of these three, each times the error of its angle"),
        line(rf"{COMPUTED} = {TURNS} + {CHANGE}", FIRST, SMALL, expand(*ERROR, of="2")),
        line(rf"C_b^n = {TURNS}", EXACT_LINE, "the true attitude is made of the true angles"),
        line(rf"{COMPUTED} - C_b^n = {CHANGE}", FIRST, "the true attitude is taken off", subtract_line("9", of="8")),
        line(rf"{COMPUTED} = C_b^n + {CHANGE}", FIRST, "it goes to the other side", add("C_b^n"), result=True),
        unit="1", leads_to=("7",), small=("euler_error",),
    ),
    # The right side to first order in eps.
    "6": derived(
        line(r"C_n^{n'} = \exp(-E)", EXACT_LINE, "n' is n turned by ε: components of a fixed vector turn by -ε"),
        line(r"C_n^{n'} = I - E", FIRST, SMALL, expand("E")),
        line(r"C_n^{n'} C_b^n = (I - E) C_b^n", FIRST, "the body comes in from the right",
             multiply(right="C_b^n"), result=True),
        unit="1", leads_to=("7",), small=("euler_error",),
    ),
    # Both sides of (4).  What undoes C_b^n is C_n^b, not C_b^n once more.
    "7": derived(
        line(rf"C_b^n + {CHANGE} = (I - E) C_b^n", FIRST, "(5) and (6) are the sides of (4)",
             chain("(4)", "(5)", "(6)")),
        line(rf"{CHANGE} = -E C_b^n", FIRST, "C_b2n stands on both sides", add("-C_b^n")),
        line(rf"{CHANGE} C_n^b = -E", FIRST,
             "C_b2n C_n2b = I: the product from the right is with the inverse, C_n2b, which the print has as C_b2n",
             multiply(right="C_n^b")),
        line(rf"E = -{CHANGE} C_n^b", FIRST, "the sides change places", rearrange(), result=True),
        unit="1", leads_to=("8",), small=("euler_error",),
    ),
    # The vector of (7), one column for each angle.
    "8": derived(
        line(rf"u_\psi = {column('0', '0', '1')}", IDENTITY, "yaw turns about the third axis of n"),
        line(rf"u_\theta = R_3(\psi) {column('0', '1', '0')}", IDENTITY,
             "pitch turns about the second axis, where the yaw has taken it"),
        line(rf"u_\phi = R_3(\psi) R_2(\theta) {column('1', '0', '0')}", IDENTITY,
             "roll turns about the first axis, where yaw and pitch have taken it"),
        *(
            line(rf"\frac{{\partial C_b^n}}{{\partial{angle}}} = [u_{angle} \times] C_b^n", EXACT_LINE,
                 f"each angle turns about its own axis: {word}")
            for angle, word in zip(TRUE, ("roll", "pitch", "yaw"), strict=True)
        ),
        line(CHANGE + " = " + " + ".join(
            rf"\frac{{\partial C_b^n}}{{\partial{angle}}} {error}" for angle, error in zip(TRUE, ERROR, strict=True)),
            IDENTITY, "ΔC is the change with each angle"),
        line(rf"{CHANGE} = ([u_\phi \times] \delta\phi + [u_\theta \times] \delta\theta + [u_\psi \times] \delta\psi)"
             r" C_b^n", EXACT_LINE, "the three turns", substitute("4", "5", "6")),
        line(r"E = -([u_\phi \times] \delta\phi + [u_\theta \times] \delta\theta + [u_\psi \times] \delta\psi)", FIRST,
             "ΔC in (7): C_b2n C_n2b = I, and the sign is that of (7)", substitute("8", of="(7)")),
        line(r"\epsilon^n = -(u_\phi \delta\phi + u_\theta \delta\theta + u_\psi \delta\psi)", FIRST,
             "of skew matrices their vectors", take_vector()),
        line(r"\begin{bmatrix} u_\phi & u_\theta & u_\psi \end{bmatrix} = R_3(\psi) A_3(\theta)", IDENTITY,
             "the columns are the axes of roll, pitch and yaw after the yaw, and R3(ψ) takes them to n"),
        line(r"A_3(\theta) = \flown{axes_after_yaw}", IDENTITY, "of these the pitch has moved the first alone"),
        line(rf"{EPS} = -R_3(\psi) \flown{{axes_after_yaw}} {D}", FIRST, "the axes as columns",
             multiply_out("11", "12", of="10")),
        line(rf"{EPS} = \flown{{eps_D_euler}} {D}", FIRST,
             "only θ and ψ are left: the axes do not know the roll", multiply_out(), result=True),
        unit="rad", leads_to=("9", "12"), small=("euler_error",),
    ),
    # The inverse of (8).
    "9": derived(
        line(rf"{EPS} = -R_3(\psi) A_3(\theta) {D}", FIRST, "(8), its matrix as a product", multiply_out(of="(8)")),
        line(rf"{D} = -A_3(\theta)^{{-1}} R_3(\psi)^T {EPS}", FIRST,
             "the inverse of a product; of a rotation it is the transpose",
             multiply(left=r"-A_3(\theta)^{-1} R_3(\psi)^T")),
        line(r"A_3(\theta)^{-1} = \flown{inverse_after_yaw}", IDENTITY, "a triangular matrix by substitution"),
        line(rf"{D} = -\flown{{inverse_after_yaw}} R_3(\psi)^T {EPS}", FIRST, "the inverse is a product of the two",
             multiply_out("3", of="2")),
        line(rf"{D} = \flown{{euler_D_eps}} {EPS}", FIRST,
             "it is singular at a pitch of +-90 deg, where roll and yaw turn about one axis",
             multiply_out(), result=True),
        unit="rad", leads_to=("19",), small=("euler_error",),
    ),
    # The same error seen as a turn of the body axes by beta.
    "10": derived(
        line(r"\hat{C}_b^n = C_{b'}^n = C_b^n C_{b'}^b", EXACT_LINE,
             "the computed matrix may as well belong to a body b', turned from b by β, in the true n"),
        line(r"C_{b'}^b = \exp(B)", EXACT_LINE, "components in b of a vector fixed in b'"),
        line(r"C_{b'}^b = I + B", FIRST, SMALL, expand("B")),
        line(r"\hat{C}_b^n = C_{b'}^n = C_b^n (I + B)", FIRST, "it stands in the first line", substitute("3", of="1")),
        line(rf"\hat{{C}}_b^n = {COMPUTED}", EXACT_LINE, "the computed attitude is that of the computed angles"),
        line(r"C_b^{n'} = C_n^{n'} C_b^n", EXACT_LINE, "components pass from b to n and from n to n'"),
        line(r"\hat{C}_b^n = C_b^{n'} = C_n^{n'} C_b^n", EXACT_LINE, "(4) has the last side", chain("5", "(4)", "6")),
        line(r"\hat{C}_b^n = C_{b'}^n = C_b^n C_{b'}^b = C_b^n (I + B) = C_b^{n'} = C_n^{n'} C_b^n = (I - E) C_b^n",
             FIRST, "(6) has the last side", chain("1", "4", "7", "(6)"), result=True),
        unit="1", leads_to=("11",), small=("euler_error",),
    ),
    # (10) with skew matrices; the text has it between (10) and (11).
    "B": derived(
        line(r"C_b^n (I + B) = (I - E) C_b^n", EXACT_LINE, "two sides of (10)", chain("(10)")),
        line(r"C_b^n B = -E C_b^n", EXACT_LINE, "C_b2n stands on both sides", add("-C_b^n")),
        line(r"B = -C_n^b E C_b^n", EXACT_LINE, "from the left with C_n2b; it is exact with finite rotations, see (11)",
             multiply(left="C_n^b"), result=True),
        unit="1", leads_to=("11",),
    ),
    # C_n^b [eps x] C_b^n = [(C_n^b eps) x].
    "11": derived(
        line(r"C_n^b E C_b^n = [(C_n^b \epsilon^n) \times]", IDENTITY,
             "a turned skew matrix is the skew matrix of the turned vector"),
        line(r"[\beta^b \times] = -[(C_n^b \epsilon^n) \times]", EXACT_LINE, "so the sides are skew",
             multiply_out("1", of="(B)")),
        line(r"C_b^n \exp(B) = \exp(-E) C_b^n", EXACT_LINE,
             "with finite rotations it is exact: (10) before it was cut"),
        line(r"\exp(B) = C_n^b \exp(-E) C_b^n", EXACT_LINE, "from the left with C_n2b", multiply(left="C_n^b")),
        line(r"\exp(B) = \exp(-C_n^b E C_b^n)", EXACT_LINE, "a turned rotation is the rotation by the turned vector",
             multiply_out("1")),
        line(r"\beta^b = -C_n^b \epsilon^n", EXACT_LINE, "of rotations their vectors", take_rotation_vector(),
             result=True),
        unit="rad", leads_to=("12",),
    ),
    # (8) in (11).
    "12": derived(
        line(rf"\beta^b = C_n^b R_3(\psi) A_3(\theta) {D}", FIRST, "(8) in (11)", substitute("(8)", of="(11)")),
        line(rf"C_n^b = {TURNS_BACK}", EXACT_LINE, "the turns back, the last one first"),
        line(rf"\beta^b = {TURNS_BACK} R_3(\psi) A_3(\theta) {D}", FIRST, "it stands in the first line",
             substitute("2", of="1")),
        line(rf"{BETA} = R_1(\phi)^T R_2(\theta)^T A_3(\theta) {D}", FIRST, "the yaw cancels", multiply_out()),
        line(r"R_2(\theta)^T A_3(\theta) = \flown{axes_before_roll}", IDENTITY,
             "the columns are the axes of roll, pitch and yaw before the roll"),
        line(rf"{BETA} = R_1(\phi)^T \flown{{axes_before_roll}} {D}", FIRST, "and R1(φ) transposed takes them to b",
             multiply_out("5", of="4")),
        line(rf"{BETA} = \flown{{beta_D_euler}} {D}", FIRST,
             "only φ and θ are left: in the body nobody knows the heading", multiply_out(),
             result=True),
        unit="rad", leads_to=("13",), small=("euler_error",),
    ),
    "13": derived(
        line(rf"{BETA} = R_1(\phi)^T A_1(\theta) {D}", FIRST, "(12), its matrix as a product",
             multiply_out(of="(12)")),
        line(rf"{D} = A_1(\theta)^{{-1}} R_1(\phi) {BETA}", FIRST, "the inverse of a product",
             multiply(left=r"A_1(\theta)^{-1} R_1(\phi)")),
        line(r"A_1(\theta)^{-1} = \flown{inverse_before_roll}", IDENTITY, "a triangular matrix by substitution"),
        line(rf"{D} = \flown{{inverse_before_roll}} R_1(\phi) {BETA}", FIRST, "the inverse is a product of the two",
             multiply_out("3", of="2")),
        line(rf"{D} = \flown{{euler_D_beta}} {BETA}", FIRST, "nothing but roll and pitch is needed",
             multiply_out(), result=True),
        unit="rad", leads_to=("15",), small=("euler_error",),
    ),
    "14": derived(
        prose("the angles of the slave less those of the master; nothing to prove"),
        unit="rad", defines=("Δφ", "Δθ", "Δψ"), leads_to=("15", "17"),
    ),
    # The slave stands where the master does, turned by mu.
    "15": derived(
        line(r"C_b^n = C_r^n \exp([\mu^r \times])", EXACT_LINE,
             "the axes b are the axes r turned by the finite vector μ"),
        line(r"C_b^n = C_r^n (I + [\mu^r \times])", first_order("mu"),
             "the misalignment is small; what this drops is in the evidence", expand(r"\mu^r")),
        line(rf"C_b^n = {attitude_of(TRUE_B)}", EXACT_LINE, "the slave's angles are those of its attitude"),
        line(rf"{attitude_of(TRUE_B)} = C_r^n + {CHANGE_R}", first_order("mu"),
             "(5) from the master's attitude to the slave's: the differences take the place of the errors",
             elsewhere(dict(zip((*HAT, "C_b^n", *TRUE, *ERROR), (*TRUE_B, "C_r^n", *TRUE_R, *GAP), strict=True)),
                       of="(5)")),
        line(rf"C_r^n (I + [\mu^r \times]) = C_r^n + {CHANGE_R}", first_order("mu"), "both are C_b2n",
             chain("2", "3", "4")),
        line(rf"C_r^n [\mu^r \times] = {CHANGE_R}", first_order("mu"), "C_r2n stands on both sides", add("-C_r^n")),
        line(rf"[\mu^r \times] = C_n^r {CHANGE_R}", first_order("mu"), "from the left with C_n2r",
             multiply(left="C_n^r")),
        line(rf"C_n^r = {TURNS_BACK_R}", EXACT_LINE, "the turns back, the last one first"),
        line(rf"[\mu^r \times] = {TURNS_BACK_R} {CHANGE_R}", first_order("mu"), "in the line before it",
             substitute("8", of="7")),
        line(rf"{TURNS_BACK_R} {CHANGE_R} = [(R_1(\phi_r)^T A_1(\theta_r) {column(*GAP)}) \times]", IDENTITY,
             "it is (10) with β = μ: each difference turns about its axis, seen in r, as in (12)"),
        line(rf"[\mu^r \times] = [(R_1(\phi_r)^T A_1(\theta_r) {column(*GAP)}) \times]", first_order("mu"),
             "both are skew", multiply_out("10", of="9")),
        line(rf"{MU} = R_1(\phi_r)^T A_1(\theta_r) {column(*GAP)}", first_order("mu"), "of skew matrices their vectors",
             take_vector()),
        line(rf"{column(*GAP)} = A_1(\theta_r)^{{-1}} R_1(\phi_r) {MU}", first_order("mu"), "the inverse, as in (13)",
             multiply(left=r"A_1(\theta_r)^{-1} R_1(\phi_r)")),
        line(rf"{column(*GAP)} = \flown{{euler_D_mu}} {MU}", first_order("mu"),
             "the matrix is that of (13), at the master", multiply_out(), result=True),
        unit="rad", leads_to=("18", "19"), small=("mu",),
    ),
    "16": derived(
        prose("what of the difference of the angles the estimated misalignment leaves unexplained"),
        unit="rad", defines=("Z",), leads_to=("17",),
    ),
    # (1) to (3), once for the slave and once for the master, in (16).
    "17": derived(
        line(rf"{column(*HAT_B)} = {column(*TRUE_B)} + {D_B}", EXACT_LINE, "(1) to (3) for the slave"),
        line(rf"{column(*HAT_R)} = {column(*TRUE_R)} + {D_R}", EXACT_LINE, "(1) to (3) for the master"),
        line(rf"Z = {D_B} + {column(*TRUE_B)} - {column(*TRUE_R)} - {column(*GAP_HAT)} - {D_R}", EXACT_LINE,
             "both are put in (16)", substitute("1", "2", of="(16)"), result=True),
        unit="rad", leads_to=("19",),
    ),
    # (15) for the estimated misalignment: how the filter computes the difference.
    "18": derived(
        line(rf"{attitude_of(BY_ESTIMATE)} = "
             r"C_r^n \exp([\hat{\mu}^r \times])", EXACT_LINE,
             "the computed differences lead to the axes r turned by the estimate: this says what they are"),
        line(rf"{column(*GAP_HAT)} = \flown{{euler_D_mu}} {MU_HAT}", first_order(),
             "(15) with the estimate in place of the true misalignment",
             elsewhere(dict(zip((*GAP, r"\mu_x", r"\mu_y", r"\mu_z"),
                          (*GAP_HAT, r"\hat{\mu}_x", r"\hat{\mu}_y", r"\hat{\mu}_z"), strict=True)), of="(15)"),
             result=True),
        unit="rad", leads_to=("19",), small=("mu", "mu_error"),
        note="The filter has measured master angles, not the true ones which are printed: a second-order difference.",
    ),
    # (9), (15) and (18) in (17).
    "19": derived(
        line(rf"{D_B} = \flown{{H_eps}} {EPS}", first_order(), "(9) for the slave",
             elsewhere(dict(zip((*TRUE, *ERROR), (*TRUE_B, *ERROR_B), strict=True)), of="(9)")),
        line(rf"Z = \flown{{H_eps}} {EPS} + {column(*TRUE_B)} - {column(*TRUE_R)} - {column(*GAP_HAT)} - {D_R}",
             first_order(), "it is the first term of (17)", substitute("1", of="(17)")),
        line(rf"{column(*TRUE_B)} = {column(*TRUE_R)} + {column(*GAP)}", EXACT_LINE, "what (14) says of the slave",
             rearrange(of="(14)")),
        line(rf"Z = \flown{{H_eps}} {EPS} + {column(*GAP)} - {column(*GAP_HAT)} - {D_R}", first_order(),
             "the true difference less the computed one", substitute("3", of="2")),
        line(rf"Z = \flown{{H_eps}} {EPS} + \flown{{euler_D_mu}} {MU} - \flown{{euler_D_mu}} {MU_HAT} - {D_R}",
             first_order(), "(15) and (18)", substitute("(15)", "(18)")),
        line(rf"{MU_HAT} = {MU} + {D_MU}", EXACT_LINE, "δμ = μ̂ - μ, as the text under (19) has it"),
        line(rf"Z = \flown{{H_eps}} {EPS} - \flown{{H_mu}} {D_MU} - {D_R}", first_order(),
             "what is left of the misalignment is its error; the master's angle error is the measurement noise",
             substitute("6", of="5"), result=True),
        line(rf"\flown{{H}} {STATES}"
             rf" = \flown{{H_eps}} {EPS} - \flown{{H_mu}} {D_MU}", IDENTITY,
             "H, the 3x6 matrix that flies, beside these two"),
        line(rf"{STATES} = "
             rf"{X}", EXACT_LINE, "the states", chain("(22)")),
        line(rf"\flown{{H}} {X} = "
             rf"\flown{{H_eps}} {EPS} - \flown{{H_mu}} {D_MU}", EXACT_LINE, "H is that of the states",
             substitute("9", of="8"), result=True),
        line(rf"\flown{{H}} = {STATES_MEASURED}", IDENTITY, "and these are its blocks, by the turns and their axes"),
        unit="rad", leads_to=("26", "27", "28"),
    ),
    "δμ": derived(
        prose("the estimate less the true misalignment: error = computed - true"),
        defines=("δμ_x", "δμ_y", "δμ_z"), leads_to=("19", "25"),
    ),
    # The exact kinematics of the true and of the computed attitude, subtracted.
    "20": derived(
        line(r"\dot{C}_b^n = C_b^n [\omega_{ib}^b \times] - \Omega_{in}^n C_b^n", EXACT_LINE,
             "exact kinematics of the true attitude"),
        line(r"\dot{\hat{C}}_b^n = (\hat{C}_b^n) [(\omega_{ib}^b + \delta\omega^b) \times] - \Omega_{in}^n \hat{C}_b^n",
             EXACT_LINE, "and of the computed one, with the gyro's error added; the error of ω_in_n, which comes from "
             "position and velocity, is dropped here"),
        line(r"\hat{C}_b^n = (I - E) C_b^n", FIRST, "the computed attitude belongs to n', as (10) has it",
             chain("(10)")),
        line(r"\dot{\hat{C}}_b^n = -\dot{E} C_b^n + (I - E) \dot{C}_b^n", first_order(), "both sides change with time",
             differentiate({r"\hat{C}_b^n": r"\dot{\hat{C}}_b^n", "E": r"\dot{E}", "C_b^n": r"\dot{C}_b^n"})),
        line(r"-\dot{E} C_b^n + (I - E) \dot{C}_b^n = "
             r"(\hat{C}_b^n) [(\omega_{ib}^b + \delta\omega^b) \times] - \Omega_{in}^n \hat{C}_b^n", first_order(),
             "both are the rate of the computed attitude", chain("2", "4")),
        line(r"-\dot{E} C_b^n + (I - E) (C_b^n [\omega_{ib}^b \times] - \Omega_{in}^n C_b^n) = "
             r"(I - E) C_b^n [(\omega_{ib}^b + \delta\omega^b) \times] - \Omega_{in}^n (I - E) C_b^n", first_order(),
             "the true rate and the computed attitude are put in", substitute("1", "3")),
        line(r"-\dot{E} C_b^n = "
             r"(I - E) C_b^n [\delta\omega^b \times] + (I - E) \Omega_{in}^n C_b^n - \Omega_{in}^n (I - E) C_b^n",
             first_order(), "the turning of the body cancels", rearrange()),
        line(r"-\dot{E} C_b^n = C_b^n [\delta\omega^b \times] - E \Omega_{in}^n C_b^n + \Omega_{in}^n E C_b^n",
             first_order(), "the product of E with the gyro's error is dropped", expand("E", r"\delta\omega^b")),
        line(r"\dot{E} = E \Omega_{in}^n - \Omega_{in}^n E - C_b^n [\delta\omega^b \times] C_n^b", first_order(),
             "from the right with the inverse", multiply(left="-1", right="C_n^b")),
        line(r"E \Omega_{in}^n - \Omega_{in}^n E = -[(\Omega_{in}^n \epsilon^n) \times]", IDENTITY,
             "the commutator of skew matrices is the skew matrix of the cross product"),
        line(r"C_b^n [\delta\omega^b \times] C_n^b = [(C_b^n \delta\omega^b) \times]", IDENTITY,
             "a turned skew matrix is the skew matrix of the turned vector"),
        line(r"\dot{E} = -[(\Omega_{in}^n \epsilon^n) \times] - [(C_b^n \delta\omega^b) \times]", first_order(),
             "all is skew", multiply_out("10", "11", of="9")),
        line(rf"\dot{{\epsilon}}^n = {RATE_OF_EPS}", first_order(),
             "of skew matrices their vectors", take_vector(), result=True),
        line(r"\flown{F} = -\Omega_{in}^n", IDENTITY, "the matrix of ε that flies"),
        line(rf"\flown{{noise}} = -{TURNS}", IDENTITY, "and that of the gyro's error, -C_b2n of the true angles"),
        unit="rad/s", small=("euler_error", "gyro_error"),
    ),
    # A rigid mounting.
    "21": derived(
        line(r"\dot{\mu}^r = 0", EXACT_LINE, "on a rigid mounting μ is constant in r"),
        line(r"\dot{\hat{\mu}}^r = 0", EXACT_LINE, "between corrections so is its estimate, by the filter's own rule"),
        line(r"\delta\mu^r = \hat{\mu}^r - \mu^r", EXACT_LINE, "the text under (19)"),
        line(rf"\delta\dot{{\mu}}^r = {RATE_OF_D_MU}", EXACT_LINE, "both sides change with time",
             differentiate({r"\delta\mu^r": r"\delta\dot{\mu}^r", r"\hat{\mu}^r": r"\dot{\hat{\mu}}^r",
                            r"\mu^r": r"\dot{\mu}^r"})),
        line(r"\delta\dot{\mu}^r = 0", EXACT_LINE, "both are constant", substitute("1", "2"), result=True),
        line(rf"{RATES} = {column(RATE_OF_EPS, RATE_OF_D_MU)}", first_order("euler_error", "gyro_error"),
             "(20) stands over the rate of δμ", stack("(20)", "4")),
        line(rf"{RATES} = {STATE_MATRIX} {PARTS} + {STATE_NOISE} \delta\omega^b",
             first_order("euler_error", "gyro_error"), "these are F and G of the six states", substitute("1", "2")),
        unit="rad/s",
    ),
    "22": derived(
        prose("the order of the states, which the 3x6 matrix H of (19) and the model share"),
        unit="rad", defines=("X",), leads_to=("19",),
    ),
    # The quaternion of the finite rotation by eps.
    "23": derived(
        line(r"C_{n'}^n = \exp(E)", EXACT_LINE, "what takes C_n2n' out again is the turn by +ε"),
        line(r"\Delta Q_b^n = \begin{bmatrix} \Delta q_0 \\ \Delta q_1 \\ \Delta q_2 \\ \Delta q_3 \end{bmatrix} = "
             r"\begin{bmatrix} \cos \frac{\epsilon_o}{2} \\ \frac{\epsilon_n}{\epsilon_o} \sin \frac{\epsilon_o}{2} \\"
             r" \frac{\epsilon_e}{\epsilon_o} \sin \frac{\epsilon_o}{2} \\"
             r" \frac{\epsilon_d}{\epsilon_o} \sin \frac{\epsilon_o}{2} \end{bmatrix}", EXACT_LINE,
             "half its angle, about its axis", take_quaternion(), result=True),
        line(r"\epsilon_o = \sqrt{\epsilon_n^2 + \epsilon_e^2 + \epsilon_d^2}", IDENTITY,
             "its angle is the length of the vector", result=True),
        line(r"\frac{\sin \frac{\epsilon_o}{2}}{\epsilon_o} = \frac{1}{2}", FIRST,
             "the print is 0/0 at ε = 0, and sin(x/2)/x tends to 1/2"),
        line(r"\Delta Q_b^n = \begin{bmatrix} 1 \\ \frac{\epsilon_n}{2} \\ \frac{\epsilon_e}{2} \\ "
             r"\frac{\epsilon_d}{2} \end{bmatrix}", FIRST, "its limit",
             expand(r"\epsilon_n", r"\epsilon_e", r"\epsilon_d", of="2")),
        line(r"\Delta Q_b^n = \flown{quaternion}", EXACT_LINE,
             "the function that flies, which adds 1e-30 under the root"),
        unit="1", leads_to=("24",),
        note="The label ΔQ_b2n is that of a rotation from n' to n; it changes no number.",
    ),
    # The correction of the attitude.
    "24": derived(
        line(r"\hat{C}_b^n = C_n^{n'} C_b^n", EXACT_LINE, "the computed attitude belongs to n', as (10) has it",
             chain("(10)")),
        line(r"C_n^{n'} = \exp(-E)", EXACT_LINE, "n' is n turned by ε, as in (6)"),
        line(r"\hat{C}_b^n = \exp(-E) C_b^n", EXACT_LINE, "it stands in the first line", substitute("2", of="1")),
        line(r"C_b^n = \exp(E) \hat{C}_b^n", EXACT_LINE, "from the left with the turn back",
             multiply(left=r"\exp(E)")),
        line(r"\hat{Q}_b^n(k^+) = \Delta Q_b^n(k) \hat{Q}_b^n(k^-)", EXACT_LINE,
             "a product of rotations is the product of the quaternions, the last rotation on the left",
             take_quaternion(), result=True),
        line(r"\Delta Q_b^n(k) \hat{Q}_b^n(k^-) = \flown{corrected_quaternion}", EXACT_LINE,
             "the function that flies, with its quaternion of ε by (23)"),
        unit="1",
    ),
    # The correction of the misalignment: dmu = mu_hat - mu says that the error is taken off.
    "25": derived(
        line(rf"{D_MU} = {MU_HAT} - {MU}", EXACT_LINE, "the text under (19)"),
        line(r"\delta\mu^r(k^-) = \hat{\mu}^r(k^-) - \mu^r(k^-)", EXACT_LINE, "before the correction"),
        line(r"\delta\mu^r(k^+) = \hat{\mu}^r(k^+) - \mu^r(k^+)", EXACT_LINE, "and after it"),
        line(r"\delta\mu^r(k^+) = \delta\mu^r(k^-) - \delta\mu^r(k)", EXACT_LINE,
             "the error that is left is the one before less what was estimated of it"),
        line(r"\hat{\mu}^r(k^+) - \mu^r(k^+) = \hat{\mu}^r(k^-) - \mu^r(k^-) - \delta\mu^r(k)", EXACT_LINE,
             "both errors are put in", substitute("2", "3")),
        line(r"\mu^r(k^+) = \mu^r(k^-)", EXACT_LINE, "the mounting does not move"),
        line(r"\hat{\mu}^r(k^+) - \mu^r(k^-) = \hat{\mu}^r(k^-) - \mu^r(k^-) - \delta\mu^r(k)", EXACT_LINE,
             "it has one value", substitute("6", of="5")),
        line(r"\hat{\mu}^r(k^+) = \flown{corrected_mu}", EXACT_LINE,
             "the true misalignment is the estimate less its error", add(r"\mu^r(k^-)"), result=True),
        unit="rad",
        meanings=(ERROR_OF_MU,),
        readings=tuple(_dropped_hat(name, "the text says that the estimate is renewed") for name in ("μ(k+)", "μ(k-)")),
        note="The sign of δμ is wrong, for the true misalignment is the estimate less its error.",
    ),
    "26": _row(1, "roll"),
    "27": _row(2, "pitch"),
    "28": _row(3, "yaw"),
}  # fmt: skip
