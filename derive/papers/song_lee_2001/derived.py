"""The numbered equations as they are printed, each beside its derivation."""

from functools import cache

from sympy import Function, ImmutableMatrix, Matrix, S, Symbol, cos, eye, sin, sqrt
from sympy.simplify.fu import TR2i

from boresight.derive.ledger.equation import (
    Derivation,
    Equation,
    Reading,
    Relation,
    Step,
    column,
    negative,
    product,
    total,
)
from boresight.derive.ledger.reader import read
from boresight.derive.mechanics.rotation import dcm_from_euler, rotation_x, rotation_z, vee
from boresight.derive.papers.song_lee_2001.printed import PRINTED, quantities
from boresight.derive.papers.song_lee_2001.results import (
    attitude_error_matrix,
    attitude_noise_matrix,
    axes_after_yaw,
    axes_before_roll,
    beta_D_euler,
    corrected_misalignment,
    eps_D_euler,
    euler_D_beta,
    euler_D_eps,
    measurement_matrix,
    relative_euler,
)

NAME = "song-lee-2001"


def _layout(M) -> ImmutableMatrix:
    """An explicit matrix with tangents where the paper has them."""
    return ImmutableMatrix(Matrix(M).applyfunc(TR2i))


@cache
def equations() -> tuple[Equation, ...]:
    """The 28 numbered equations, in the paper's order."""
    letters = {quantity.symbol.name: quantity.symbol for quantity in quantities() if not quantity.function}

    def s(names: str) -> tuple[Symbol, ...]:
        return tuple(letters[name] for name in names.split())

    def col(names: str) -> ImmutableMatrix:
        return column(*s(names))

    C_hat = Function("Ĉ", commutative=False)
    dC = Function("ΔC", commutative=False)
    phi, theta, psi = s("φ θ ψ")
    euler_b, euler_r = s("φ_b θ_b ψ_b"), s("φ_r θ_r ψ_r")
    true, error, computed = "φ θ ψ", "δφ δθ δψ", "φ̂ θ̂ ψ̂"
    C_b2n, C_n2b, C_hat_b2n = s("C_b2n C_n2b Ĉ_b2n")
    C_n2n1, C_b2n1, C_b12n, C_b12b = s("C_n2n' C_b2n' C_b'2n C_b'2b")
    I, E, B, Omega = s("I E B Ω_in_n")
    eps, beta, eps_rate, gyro_error = s("ε β ε̇ δω_b")
    eps_parts, mu_parts, dmu_parts = col("ε_n ε_e ε_d"), col("μ_x μ_y μ_z"), col("δμ_x δμ_y δμ_z")
    difference, computed_difference = col("Δφ Δθ Δψ"), col("Δφ̂ Δθ̂ Δψ̂")
    M_r = _layout(relative_euler(euler_r, mu_parts).jacobian(mu_parts))
    H = measurement_matrix(euler_b, euler_r)
    (Z,) = s("Z")
    I_minus_E, I_plus_B = total(I, negative(E)), total(I, B)
    exp = Function("exp", commutative=False)
    small = "the errors are small, and their products are dropped"

    result: list[Equation] = []

    def add(number, derived, steps=(), unit="rad", **more):
        lines, latex = PRINTED[str(number)]
        printed = read(latex, quantities())
        result.append(
            Equation(
                paper=NAME,
                number=str(number),
                latex=latex,
                lines=lines,
                printed=printed,
                derived=printed if derived is None else tuple(derived),
                derivation=Derivation(tuple(Step(*step) for step in steps)),
                unit=unit,
                quantities=quantities(),
                **more,
            )
        )

    # (1) to (3)  the errors of the angles, for the slave and, with the index r, for the master.
    for number, letter in enumerate("φθψ", 1):
        add(
            number,
            None,
            [
                (
                    "define",
                    (),
                    "the error of an angle is computed - true; nothing to prove, all that follows rests on it",
                )
            ],
            defines=s(letter + "\u0302"),
            leads_to=("5", "17"),
        )

    # (4)  the computed angles describe the body in axes n' that are turned from n by eps.
    C_hat_angles = C_hat(*s(computed))
    dC_angles = dC(*s(true), *s(error))
    add(
        4,
        [Relation((C_hat_angles, product(C_n2n1, C_b2n)))],
        [
            (
                "perturb",
                (Relation((C_hat_angles, C_b2n1)),),
                "the computer takes the axes n', turned from n by ε, for n",
            ),
            ("chain", (Relation((C_b2n1, product(C_n2n1, C_b2n))),), "components pass from b to n and from n to n'"),
        ],
        unit="1",
        leads_to=("5", "6"),
    )

    # (5)  the left side to first order in the errors of the angles.
    gradient = [
        Relation((Symbol(f"∂C/∂{angle.name}"), ImmutableMatrix(dcm_from_euler(phi, theta, psi).diff(angle))))
        for angle in (phi, theta, psi)
    ]
    add(
        5,
        [Relation((C_hat_angles, total(C_b2n, dC_angles)))],
        [
            (
                "substitute",
                tuple(Relation((letters[f"{a}\u0302"], letters[a] + letters[f"δ{a}"])) for a in "φθψ"),
                "(1) to (3)",
            ),
            ("keep first order", tuple(gradient), "ΔC is the sum of these three, each times the error of its angle"),
        ],
        unit="1",
        leads_to=("7",),
        small=("euler_error",),
    )

    # (6)  the right side to first order in eps.
    add(
        6,
        [Relation((product(C_n2n1, C_b2n), product(I_minus_E, C_b2n)))],
        [
            ("rotate", (Relation((C_n2n1, exp(-E))),), "n' is n turned by ε: components of a fixed vector turn by -ε"),
            ("keep first order", (Relation((C_n2n1, I_minus_E)),), small),
        ],
        unit="1",
        leads_to=("7",),
        small=("euler_error",),
    )

    # (7)  both sides of (4): C + dC = (I - E) C.  What undoes C_b^n is C_n^b, not C_b^n once more.
    add(
        7,
        [Relation((E, product(S.NegativeOne, dC_angles, C_n2b)))],
        [
            (
                "equate",
                (Relation((total(C_b2n, dC_angles), product(I_minus_E, C_b2n))),),
                "(5) and (6) are the sides of (4)",
            ),
            ("cancel", (Relation((dC_angles, product(S.NegativeOne, E, C_b2n))),), "C_b2n stands on both sides"),
            (
                "invert",
                (Relation((E, product(S.NegativeOne, dC_angles, C_n2b))),),
                "C_b2n C_n2b = I: the product from the right is with the inverse, C_n2b, which the print has as C_b2n",
            ),
        ],
        unit="1",
        leads_to=("8",),
        small=("euler_error",),
    )

    # (8)  the vector of (7), one column for each angle.
    add(
        8,
        [Relation((eps_parts, product(_layout(eps_D_euler(theta, psi)), col(error))))],
        [
            (
                "resolve",
                (
                    Relation(
                        (
                            eps_parts,
                            product(
                                S.NegativeOne, _layout(rotation_z(psi)), _layout(axes_after_yaw(theta)), col(error)
                            ),
                        )
                    ),
                ),
                "each angle turns about its own axis; the columns are the axes of roll, pitch and yaw after the yaw, "
                "and Rz(ψ) takes them to n; the sign is that of (7)",
            ),
            ("multiply", (), "only θ and ψ are left: the axes do not know the roll"),
        ],
        leads_to=("9", "12"),
        small=("euler_error",),
    )

    # (9)  the inverse of (8).
    add(
        9,
        [Relation((col(error), product(_layout(euler_D_eps(theta, psi)), eps_parts)))],
        [
            (
                "invert",
                (
                    Relation(
                        (
                            col(error),
                            product(
                                S.NegativeOne,
                                _layout(axes_after_yaw(theta).lower_triangular_solve(eye(3))),
                                _layout(rotation_z(psi).T),
                                eps_parts,
                            ),
                        )
                    ),
                ),
                "the inverse of a product: a triangular matrix by substitution, a rotation by its transpose",
            ),
            ("multiply", (), "singular at a pitch of +-90 deg, where roll and yaw turn about one axis"),
        ],
        leads_to=("19",),
        small=("euler_error",),
    )

    # (10)  the same error seen as a turn of the body axes by beta.
    add(
        10,
        [
            Relation(
                (
                    C_hat_b2n,
                    C_b12n,
                    product(C_b2n, C_b12b),
                    product(C_b2n, I_plus_B),
                    C_b2n1,
                    product(C_n2n1, C_b2n),
                    product(I_minus_E, C_b2n),
                )
            )
        ],
        [
            (
                "perturb",
                (Relation((C_hat_b2n, C_b12n, product(C_b2n, C_b12b))),),
                "the computed matrix may as well belong to a body b', turned from b by β, in the true n",
            ),
            ("keep first order", (Relation((C_b12b, I_plus_B)),), small),
            (
                "equate",
                (Relation((C_hat_b2n, product(C_b2n, I_plus_B), product(I_minus_E, C_b2n))),),
                "with (4) and (6)",
            ),
        ],
        unit="1",
        leads_to=("11",),
        small=("euler_error",),
    )

    # (11)  B = -C_n^b E C_b^n, and C_n^b [eps x] C_b^n = [(C_n^b eps) x].
    add(
        11,
        [Relation((beta, product(S.NegativeOne, C_n2b, eps)))],
        [
            ("equate", (Relation((product(C_b2n, I_plus_B), product(I_minus_E, C_b2n))),), "the two sides of (10)"),
            ("invert", (Relation((B, product(S.NegativeOne, C_n2b, E, C_b2n))),), "from the left with C_n2b"),
            (
                "take the vector",
                (Relation((beta, product(S.NegativeOne, C_n2b, eps))),),
                "a turned skew matrix is the skew matrix of the turned vector; with finite rotations this is exact, "
                "since C exp(B) = exp(-E) C",
            ),
        ],
        leads_to=("12",),
    )

    # (12)  (8) in (11).
    add(
        12,
        [Relation((col("β_x β_y β_z"), product(_layout(beta_D_euler(phi, theta)), col(error))))],
        [
            (
                "substitute",
                (
                    Relation(
                        (
                            col("β_x β_y β_z"),
                            product(_layout(rotation_x(phi).T), _layout(axes_before_roll(theta)), col(error)),
                        )
                    ),
                ),
                "(8) in (11): the yaw cancels; the columns are the axes before the roll, and Rx(-φ) takes them to b",
            ),
            ("multiply", (), "only φ and θ are left: in the body nobody knows the heading"),
        ],
        leads_to=("13",),
        small=("euler_error",),
    )

    # (13)  the inverse of (12).
    add(
        13,
        [Relation((col(error), product(_layout(euler_D_beta(phi, theta)), col("β_x β_y β_z"))))],
        [
            (
                "invert",
                (
                    Relation(
                        (
                            col(error),
                            product(
                                _layout(axes_before_roll(theta).upper_triangular_solve(eye(3))),
                                _layout(rotation_x(phi)),
                                col("β_x β_y β_z"),
                            ),
                        )
                    ),
                ),
                "a triangular matrix by substitution, a rotation by its transpose",
            ),
        ],
        leads_to=("15",),
        small=("euler_error",),
    )

    # (14)  the difference of the attitudes of slave and master.
    add(
        14,
        None,
        [("define", (), "the angles of the slave minus those of the master; nothing to prove")],
        defines=s("Δφ Δθ Δψ"),
        leads_to=("15", "17"),
    )

    # (15)  the misalignment mu takes the place of beta in (13), the master's angles that of phi and theta.
    exact_mount = Relation(
        (
            Symbol("C_b2n", commutative=False),
            product(Symbol("C_r2n", commutative=False), exp(Symbol("[μ x]", commutative=False))),
        )
    )
    first_mount = Relation(
        (
            exact_mount.sides[0],
            product(Symbol("C_r2n", commutative=False), total(I, Symbol("[μ x]", commutative=False))),
        )
    )
    add(
        15,
        [Relation((difference, product(M_r, mu_parts)))],
        [
            ("rotate", (exact_mount,), "the axes b are the axes r turned by the finite vector μ"),
            ("keep first order", (first_mount,), "the misalignment is small; what this drops is in the evidence"),
            ("substitute", (), "it is (10) with β = μ, and (13) gives the angles"),
        ],
        leads_to=("18", "19"),
        small=("mu",),
    )

    # (16)  the measurement.
    add(
        16,
        None,
        [("define", (), "what of the difference of the angles the estimated misalignment leaves unexplained")],
        defines=(Z,),
        leads_to=("17",),
    )

    # (17)  (1) to (3), once for the slave and once for the master, in (16).
    add(
        17,
        [
            Relation(
                (
                    Z,
                    total(
                        col("δφ_b δθ_b δψ_b"),
                        col("φ_b θ_b ψ_b"),
                        negative(col("φ_r θ_r ψ_r")),
                        negative(computed_difference),
                        negative(col("δφ_r δθ_r δψ_r")),
                    ),
                )
            )
        ],
        [("substitute", (), "(1) to (3) for the slave and for the master in (16)")],
        leads_to=("19",),
    )

    # (18)  (15) for the estimated misalignment: how the filter computes the difference.
    add(
        18,
        [Relation((computed_difference, product(M_r, col("μ̂_x μ̂_y μ̂_z"))))],
        [("substitute", (), "(15) with the estimate in place of the true misalignment")],
        leads_to=("19",),
        note="The filter has measured master angles, not the true ones which are printed: a second-order difference.",
        small=("mu", "mu_error"),
    )

    # (19)  (9), (15) and (18) in (17).
    add(
        19,
        [
            Relation(
                (
                    Z,
                    total(
                        product(_layout(H[:, :3]), eps_parts),
                        negative(product(_layout(-H[:, 3:]), dmu_parts)),
                        negative(col("δφ_r δθ_r δψ_r")),
                    ),
                )
            ),
            Relation(
                (
                    product(_layout(H), col("X_1 X_2 X_3 X_4 X_5 X_6")),
                    total(product(_layout(H[:, :3]), eps_parts), negative(product(_layout(-H[:, 3:]), dmu_parts))),
                )
            ),
        ],
        [
            (
                "substitute",
                (Relation((col("δφ_b δθ_b δψ_b"), product(_layout(euler_D_eps(*euler_b[1:])), eps_parts))),),
                "(9) for the slave, in the first term of (17)",
            ),
            (
                "substitute",
                (
                    Relation(
                        (
                            total(col("φ_b θ_b ψ_b"), negative(col("φ_r θ_r ψ_r")), negative(computed_difference)),
                            negative(product(M_r, dmu_parts)),
                        )
                    ),
                ),
                "(14), (15) and (18), with δμ = μ̂ - μ",
            ),
            ("collect", (), "H is the 3x6 matrix of the states; the master's angle error is the measurement noise"),
        ],
        leads_to=("26", "27", "28"),
    )

    # (20)  the exact kinematics of the true and of the computed attitude, subtracted.
    Om_b, dOm_b, rate_C, rate_E = (Symbol(name, commutative=False) for name in ("[ω_ib_b x]", "[δω_b x]", "Ċ_b2n", "Ė"))
    omega = tuple(Symbol(f"ω_{axis}", real=True) for axis in "ned")
    # The model's matrix is this multiple of Omega = [omega x]: -1, unless somebody edits it.
    factor = vee(attitude_error_matrix(omega))[0] / omega[0]
    turn = () if factor == 1 else (factor,)
    add(
        20,
        [Relation((eps_rate, total(product(*turn, Omega, eps), product(attitude_noise_matrix(C_b2n), gyro_error))))],
        [
            (
                "perturb",
                (Relation((rate_C, total(product(C_b2n, Om_b), negative(product(Omega, C_b2n))))),),
                "the exact kinematics hold for C_b2n, and for (I - E) C_b2n with the gyro's error added",
            ),
            (
                "subtract",
                (
                    Relation(
                        (
                            product(S.NegativeOne, rate_E, C_b2n),
                            total(
                                product(I_minus_E, C_b2n, dOm_b),
                                product(I_minus_E, Omega, C_b2n),
                                negative(product(Omega, I_minus_E, C_b2n)),
                            ),
                        )
                    ),
                ),
                "the error of ω_in_n, which comes from position and velocity, is dropped here",
            ),
            (
                "keep first order",
                (
                    Relation(
                        (
                            rate_E,
                            total(
                                product(E, Omega), negative(product(Omega, E)), negative(product(C_b2n, dOm_b, C_n2b))
                            ),
                        )
                    ),
                ),
                "the product of E with the gyro's error is dropped",
            ),
            (
                "take the vector",
                (Relation((ImmutableMatrix(attitude_error_matrix(omega)), negative(Omega))),),
                "E Ω - Ω E = -[(ω x ε) x]",
            ),
        ],
        unit="rad/s",
        note="",
        small=("euler_error", "gyro_error"),
    )

    # (21)  a rigid mounting.
    add(
        21,
        [Relation((letters["δμ̇"], S.Zero))],
        [("differentiate", (), "on a rigid mounting μ is constant in r, and between corrections so is its estimate")],
        unit="rad/s",
    )

    # (22)  the states.
    add(
        22,
        None,
        [("define", (), "the order of the states, which the 3x6 matrix H of (19) and the model share")],
        defines=s("X"),
        leads_to=("19",),
    )

    # (23)  the quaternion of the finite rotation by eps.
    half = letters["ε_o"] / 2
    add(
        23,
        [
            Relation(
                (
                    letters["ΔQ"],
                    col("Δq_0 Δq_1 Δq_2 Δq_3"),
                    column(cos(half), *(e * sin(half) / letters["ε_o"] for e in eps_parts)),
                )
            ),
            Relation((letters["ε_o"], sqrt(sum(e**2 for e in eps_parts)))),
        ],
        [
            ("rotate", (), "what takes C_n2n' out again is the turn by +ε: half its angle, about its axis"),
            (
                "limit at zero",
                (Relation((Symbol("ΔQ(ε → 0)"), column(S.One, *(e / 2 for e in eps_parts)))),),
                "the print is 0/0 at ε = 0; sin(x/2)/x tends to 1/2, and the code adds 1e-30 under the root",
            ),
        ],
        unit="1",
        leads_to=("24",),
        note="The label ΔQ_b2n is that of a rotation from n' to n; it changes no number.",
    )

    # (24)  the correction of the attitude.
    add(
        24,
        [Relation((letters["Q̂(k+)"], product(letters["ΔQ(k)"], letters["Q̂(k-)"])))],
        [
            ("invert", (Relation((C_b2n, product(exp(E), C_hat_b2n))),), "Ĉ = exp(-E) C from (4), (6)"),
            (
                "take the quaternion",
                (),
                "a product of rotations is the product of the quaternions, the last rotation on the left",
            ),
        ],
        unit="1",
    )

    # (25)  the correction of the misalignment: dmu = mu_hat - mu says that the error is taken off.
    mu_after, mu_before, dmu_k = s("μ̂(k+) μ̂(k-) δμ(k)")
    add(
        25,
        # The function's own terms, in the order of the page.
        [
            Relation(
                (
                    mu_after,
                    total(*sorted(corrected_misalignment(mu_before, dmu_k).args, key=lambda term: term != mu_before)),
                )
            )
        ],
        [
            (
                "define",
                (Relation((col("δμ_x δμ_y δμ_z"), total(col("μ̂_x μ̂_y μ̂_z"), negative(mu_parts)))),),
                "the text under (19)",
            ),
            (
                "solve",
                (Relation((mu_after, corrected_misalignment(mu_before, dmu_k))),),
                "the true misalignment is the estimate less its error",
            ),
        ],
        readings=(
            Reading(letters["μ(k+)"], mu_after, "the text says that the estimate is renewed: a dropped hat"),
            Reading(letters["μ(k-)"], mu_before, "the text says that the estimate is renewed: a dropped hat"),
        ),
        note="The sign of δμ is wrong, for the true misalignment is the estimate less its error. Reading δμ as μ - μ̂ "
        "would save this sign and refute (19), with which the text's definition agrees.",
    )

    # (26) to (28)  the rows of (19).
    for i, (word, letter) in enumerate((("roll", "φ"), ("pitch", "θ"), ("yaw", "ψ"))):
        hat_b, hat_r = letters[f"{letter}\u0302_b"], letters[f"{letter}\u0302_r"]
        plain, hat = letters[f"Δ{letter}"], letters[f"Δ{letter}\u0302"]
        add(
            26 + i,
            [
                Relation(
                    (
                        letters[f"Z_{word}"],
                        total(hat_b, negative(hat_r), negative(hat)),
                        total(
                            product(_layout(H[i, :3]), eps_parts),
                            negative(product(_layout(-H[i, 3:]), dmu_parts)),
                            negative(letters[f"δ{letter}_r"]),
                        ),
                    )
                )
            ],
            [("select", (), f"row {i + 1} of (16) and of (19): a {word} matching")],
            readings=(
                Reading(
                    plain, hat, "(16) subtracts the computed difference, and the true one is not known: a dropped hat"
                ),
            ),
        )
    return tuple(result)
