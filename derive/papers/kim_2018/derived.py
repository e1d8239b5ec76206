"""The numbered equations as they are printed, each beside its derivation."""

from functools import cache
from unicodedata import normalize

from sympy import Function, ImmutableMatrix, Matrix, Rational, S, StrictLessThan, Symbol, cos, eye, sin, symbols, tan
from sympy.functions.elementary.complexes import transpose

from boresight.derive.ledger.equation import (
    Derivation,
    Equation,
    Reading,
    Relation,
    Step,
    column,
    matrix,
    negative,
    product,
    total,
)
from boresight.derive.ledger.reader import read
from boresight.derive.mechanics.rotation import skew
from boresight.derive.papers.kim_2018.decided import DECIDED
from boresight.derive.papers.kim_2018.printed import PRINTED, letters_of, quantities
from boresight.derive.papers.kim_2018.results import quaternion_error

NAME = "kim-2018"


@cache
def equations() -> tuple[Equation, ...]:
    """The 32 numbered equations, in the paper's order."""
    letters = {quantity.symbol.name: quantity.symbol for quantity in quantities() if not quantity.function}

    def s(names: str) -> tuple[Symbol, ...]:
        return tuple(letters[name] for name in names.split("|"))

    def one(name: str) -> Symbol:
        return letters[name]

    def nc(name: str) -> Symbol:
        return Symbol(name, commutative=False)

    vec, entry, norm, add_up, row = (Function(name) for name in ("vee", "entry", "norm", "Σ", "row"))
    samples, exp = Function("samples"), Function("exp")
    ie, en, f_x = s("[ω_ie_n x]|[ω_en_n x]|[f_n x]")
    v, dv, phi, theta, delay = s("v|δv|φ|θ|Δt")
    C, C_p, C_ref, I, turning = s("C_b2n|C_b2p|C̄_n2b|I|Φ̌")
    C_r = one("C_r2n")
    coriolis, spin = total(product(S(2), ie), en), total(ie, en)
    zero = {name: symbol for name, symbol in letters.items() if name.startswith("0_")}
    I_3 = one("I_3x3")
    result: list[Equation] = []

    def add(number, derived=None, steps=(), unit="1", as_vector=False, readings=(), **more):
        lines, latex = PRINTED[str(number)]
        printed = read(latex, letters_of(str(number)))
        if as_vector:  # a matrix set equal to a vector is read as the vector of its skew-symmetric part
            printed = tuple(Relation((r.sides[0], vec(r.sides[1]), *r.sides[2:])) for r in printed)
        more = {"unit": unit, **more, **DECIDED.get(str(number), {})}
        more["introduces"] = tuple(letters[name] for name in more.get("introduces", ()))
        meant = {reading.printed: reading.meant for reading in readings}
        result.append(
            Equation(
                paper=NAME,
                number=str(number),
                latex=latex,
                lines=lines,
                printed=printed,
                derived=tuple(r.replaced(meant) for r in printed) if derived is None else tuple(derived),
                derivation=Derivation(tuple(Step(*step) for step in steps)),
                readings=readings,
                quantities=quantities(),
                **more,
            )
        )

    # (1)  the states of the transfer alignment.
    add(
        1,
        None,
        [
            (
                "define",
                (),
                "velocity and attitude error of the slave, error of the mounting, delay; the order of F and H",
            )
        ],
        defines=s("X"),
        leads_to=("3", "6"),
        note="Section 2.1 says that φ is the attitude error of the psi model; (8) has the letter for the phi model.",
    )

    # (2), (3)  the psi model: both errors against the axes at the computed position.
    C_c, v_rate = nc("C_n2c"), one("v̇")
    add(
        2,
        [
            Relation((one("δv̇_c"), total(negative(product(coriolis, dv)), product(f_x, phi)))),
            Relation((one("ψ̇"), negative(product(spin, phi)))),
            Relation((one("θ̇"), S.Zero)),
            Relation((one("Δṫ"), S.Zero)),
        ],
        [
            (
                "perturb",
                (Relation((nc("Ĉ_b2n"), product(exp(-nc("[ψ x]")), C_c, C))),),
                "the computer's axes c lie where it believes to be, and it knows their rate; the attitude errs by ψ",
            ),
            (
                "subtract",
                (Relation((one("δv̇_c"), total(nc("v̂̇"), negative(nc("v̇_c"))))),),
                "the velocity error is against the true velocity carried into c, so no error of a rate remains",
            ),
            (
                "keep first order",
                (
                    Relation(
                        (product(total(I, negative(nc("[ψ x]"))), one("f_n")), total(one("f_n"), product(f_x, nc("ψ"))))
                    ),
                ),
                "-ψ x f = f x ψ: the sign of the print is right",
            ),
            (
                "drop",
                (),
                "errors of the sensors, for which the filter has noise, and gravity at the wrong place, for which it "
                "would need the position; their sizes are in the evidence",
            ),
        ],
        unit="m/s^2",
        readings=(
            Reading(
                one("φ̇"), one("ψ̇"), "the text over (1) names the psi model; as the phi model the row lacks δω_in_n"
            ),
        ),
        leads_to=("3",),
    )
    F_rows = [
        [negative(coriolis), f_x, zero["0_3x4"]],
        [zero["0_3x3"], negative(spin), zero["0_3x4"]],
        [zero["0_4x3"], zero["0_4x3"], zero["0_4x4"]],
    ]
    add(
        3,
        [Relation((one("F_X"), matrix(F_rows))), Relation((one("Ẋ"), product(*s("F_X|X"))))],
        [("collect", (Relation((one("Ẋ"), product(*s("F_X|X")))),), "(2) in the order of (1)")],
        note="A vector of rates beside a vector is its cross product: the index 3x3 of (3) says so.",
    )

    # (4) to (6)  the measurement of the transfer alignment.
    master, master_error = s("v̂_MINS|Δv_MINS")
    late = product(v_rate, delay)
    add(
        4,
        None,
        [("define", (), "what the velocities differ by; ν_v is minus all by which the master's errs")],
        unit="m/s",
        leads_to=("6",),
        note="(6) has a column for the delay: there ν_v is the master's own error, and (4) would leave out v̇ Δt.",
    )
    turned = one("C_r2n(k-δt)")
    hats = s("Ĉ_r2n|Ĉ_b2r|Ĉ_n2b")
    add(
        5,
        [
            Relation(
                (
                    one("Z_dcm"),
                    vec(product(*hats)),
                    total(phi, negative(product(turned, theta)), product(one("d"), delay), one("ν_dcm")),
                )
            )
        ],
        [
            (
                "chain",
                (),
                "components pass from n to b by the slave, from b to r by the mounting, from r to n by the master",
            ),
            (
                "perturb",
                (
                    Relation((hats[1], product(exp(-nc("[θ x]")), nc("C_b2r")))),
                    Relation((hats[2], product(nc("C_n2b"), exp(nc("[φ x]"))))),
                ),
                "the mounting errs by θ, the slave by φ",
            ),
            (
                "keep first order",
                (Relation((turned, product(total(I, negative(product(delay, nc("[ω_nr_n x]")))), C_r))),),
                "in the errors and in the delay, during which the master turns against n",
            ),
            (
                "take the vector",
                (Relation((one("d"), -nc("ω_nr_n"))),),
                "the product is I + [Z x]; d, which the paper nowhere defines, is the rate of n against r",
            ),
        ],
        unit="rad",
        as_vector=True,
        leads_to=("6",),
        note="The product of three matrices is set equal to a vector: read as the vector of its skew-symmetric part. "
        "δt is the Δt of (1).",
    )
    add(
        6,
        [
            Relation(
                (
                    one("H_X"),
                    matrix(
                        [
                            [I_3, zero["0_3x3"], zero["0_3x3"], v_rate],
                            [zero["0_3x3"], I_3, negative(C_r), one("d")],
                        ]
                    ),
                )
            ),
            Relation((column(*s("Z_v|Z_dcm")), total(product(*s("H_X|X")), column(*s("ν_v|ν_dcm"))))),
        ],
        [
            (
                "substitute",
                (Relation((master, total(nc("v_old"), master_error))),),
                "the master's velocity is as old as its attitude in (5)",
            ),
            (
                "keep first order",
                (Relation((one("Z_v"), total(dv, late, one("ν_v")))),),
                "in the delay, v_old = v - v̇ Δt; the noise is minus the master's own error",
            ),
            (
                "collect",
                (Relation((column(*s("Z_v|Z_dcm")), total(product(*s("H_X|X")), column(*s("ν_v|ν_dcm"))))),),
                "this and (5), as derived, in the order of (1)",
            ),
        ],
        note="Four slips: a column is lost between I and C_r2n, so that the blocks do not fit; f stands where the "
        "acceleration over the ground belongs, which is without gravity and Coriolis; its sign, and that of d, which "
        "(5) adds. If Δt is the error of an estimated delay, computed - true, the sign of f is right and d = ω_nr_n; "
        "f for v̇ and the minus at d remain wrong, for (5) adds d all the same.",
    )

    # (7), (8)  the fifteen states.
    add(
        7,
        None,
        [
            (
                "collect",
                (),
                "F_k is the derivative of the exact rates (9) to (11) by the states, w_k what the sensors' noise adds",
            )
        ],
        leads_to=("12",),
        note="The rate of a continuous system with the index of a step: a label.",
    )
    add(
        8,
        None,
        [("define", (), "the order of the states, which F_k and H_k share")],
        defines=s("x"),
        leads_to=("7",),
    )

    # (9)  the rates of longitude and latitude, differentiated.
    L, h, R_E, R_N = s("L|h|R_E|R_N")
    for_lon, for_lat = _position_rows(letters)
    ve, vn = s("v_e|v_n")
    add(
        9,
        [
            Relation((one("δl̇"), for_lon)),
            Relation((one("δL̇"), for_lat)),
            Relation((one("δḣ"), one("δv_u"))),
        ],
        [
            (
                "start",
                (
                    Relation((Symbol("l̇"), ve / ((R_E + h) * cos(L)))),
                    Relation((Symbol("L̇"), vn / (R_N + h))),
                ),
                "a velocity over the radius of its circle; R_E is the transverse radius, R_N that of the meridian",
            ),
            (
                "differentiate",
                (
                    Relation((one("R_EE"), Symbol("dR_E/dL"))),
                    Relation((one("R_NN"), Symbol("dR_N/dL"))),
                ),
                "by latitude, also through the radii, by height and by velocity",
            ),
            (
                "substitute",
                (
                    Relation((one("ρ_e"), -vn / (R_N + h))),
                    Relation((one("ρ_n"), ve / (R_E + h))),
                ),
                "the components of ω_en_n",
            ),
        ],
        unit="rad/s",
        leads_to=("7",),
        note="It has three slips: ρ_e for ρ_n in the first term, R_E for R_N and the sign of δh in the row of the "
        "latitude. ρ is not defined in the text; no choice of ρ_e and ρ_n among +-v_n/(R_N+h) and +-v_e/(R_E+h) saves "
        "them.",
    )

    # (10), (11)  the phi model.
    d_ie, d_en, gyro = s("δω_ie_n|δω_en_n|δω_ib_b")
    add(
        10,
        None,
        [
            (
                "start",
                (Relation((nc("v̇_n"), total(product(C, nc("f_b")), nc("g_n"), negative(product(coriolis, v))))),),
                "the exact rate of the velocity, for the true and for the computed state",
            ),
            (
                "perturb",
                (
                    Relation(
                        (
                            product(nc("Ĉ_b2n"), nc("f̂_b")),
                            product(total(I, negative(nc("[φ x]"))), C, total(nc("f_b"), one("δf_b"))),
                        )
                    ),
                ),
                "the attitude errs by φ, the accelerometers by δf_b",
            ),
            ("keep first order", (), "-φ x f = f x φ: all signs of the print are right"),
        ],
        unit="m/s^2",
        leads_to=("7",),
    )
    add(
        11,
        [
            Relation(
                (
                    one("φ̇"),
                    total(negative(product(spin, phi)), total(d_ie, d_en), negative(product(C, gyro))),
                )
            )
        ],
        [
            (
                "start",
                (Relation((nc("Ċ_b2n"), total(product(C, nc("[ω_ib_b x]")), negative(product(nc("[ω_in_n x]"), C))))),),
                "the exact kinematics, for the true and for the computed attitude",
            ),
            (
                "perturb",
                (Relation((nc("ω̂_in_n"), total(nc("ω_in_n"), d_ie, d_en))),),
                "the computer turns its axes by the rate of where it believes to be and how it believes to move",
            ),
            (
                "keep first order",
                (
                    Relation(
                        (
                            product(S.NegativeOne, nc("[φ̇ x]"), C),
                            total(
                                product(nc("[ω_in_n x]"), nc("[φ x]"), C),
                                negative(product(nc("[φ x]"), nc("[ω_in_n x]"), C)),
                                negative(product(nc("[δω_in_n x]"), C)),
                                product(C, nc("[δω_ib_b x]")),
                            ),
                        )
                    ),
                ),
                "products of errors are dropped",
            ),
            (
                "take the vector",
                (),
                "δω_in_n turns the computed axes away just as the gyro's error turns the body, with the opposite sign",
            ),
        ],
        unit="rad/s",
        leads_to=("7",),
        note="With the printed sign a computed velocity turns the level the wrong way, and Schuler's loop diverges.",
    )

    # (12) to (14)  prediction.
    P, P_after, F_k = s("P(k-)|P(k+)|F_k")
    add(
        12,
        [Relation((one("Φ_k"), total(one("I_15x15"), product(*s("F_k|ΔT")))))],
        [
            (
                "solve",
                (Relation((one("Φ_k"), Function("exp")(product(*s("F_k|ΔT"))))),),
                "F_k held constant over the step",
            ),
            ("keep first order", (), "in ΔT; what is dropped is in the evidence"),
        ],
        readings=(Reading(S.One, one("I_15x15"), "a number beside a matrix: the identity is meant"),),
        leads_to=("13", "14"),
        small=("step",),
    )
    add(
        13,
        None,
        [("solve", (), "the errors without noise over one step, with the exact Φ")],
        leads_to=("25",),
    )
    add(
        14,
        None,
        [
            (
                "take the expectation",
                (Relation((nc("Ṗ"), total(product(F_k, P), product(P, transpose(F_k)), nc("W")))),),
                "of the square of what (13) and the noise, of density W, leave; Q is what it gathers over a step",
            )
        ],
        leads_to=("24",),
    )

    # (15) to (17)  zero velocity.
    add(
        15,
        [
            Relation((one("z"), total(product(*s("H_k|x_k")), one("ν")))),
            Relation((one("z_v"), total(product(*s("H_v|x_k")), one("ν_z")))),
        ],
        [
            (
                "define",
                (),
                "what the true velocity really is, where it is called zero, is the noise; also for (16), (17)",
            )
        ],
        leads_to=("16", "22"),
    )
    add(
        16,
        None,
        [("define", (), "computed less true velocity, which is zero at rest")],
        defines=s("z_v"),
        leads_to=("17",),
    )
    twenty_four = "Columns for 24 states, here and in (17) and (23) alike: nine more than (8) has."
    add(
        17,
        [Relation((one("H_v"), matrix([[zero["0_3x3"], I_3, zero["0_3x9"]]])))],
        [("collect", (), "v̂ = v + δv; after position and velocity, nine states of (8) remain")],
        note=twenty_four,
    )

    # (18) to (23)  azimuth.
    phi_matrix = ImmutableMatrix(skew(s("φ_e|φ_n|φ_u")))
    in_b, in_p = column(*s("X_b|Y_b|Z_b")), column(*s("X_p|Y_p|Z_p"))
    rotate = ("rotate", (Relation((C_p, product(exp(-nc("[φ x]")), C))),), "p is n turned by φ: components turn by -φ")
    first = ("keep first order", (), "the error is small")
    add(
        18,
        [Relation((in_p, product(total(I, negative(phi_matrix)), C, in_b), product(C_p, in_b)))],
        [rotate, first],
        leads_to=("19",),
    )
    add(
        19,
        [
            Relation((C_p, product(total(I, negative(turning)), C))),
            Relation((turning, phi_matrix)),
        ],
        [rotate, first],
        leads_to=("20",),
    )
    add(
        20,
        [
            Relation(
                (
                    product(C_p, C_ref),
                    product(total(I, negative(turning)), C, C_ref),
                    ImmutableMatrix(eye(3) - Matrix(phi_matrix)),
                )
            )
        ],
        [
            ("multiply", (), "(19) from the right by the attitude of the transfer alignment"),
            (
                "cancel",
                (Relation((product(C, C_ref), I)),),
                "the reference is right; the bracket is all of I - Φ̌, and the factor before it is one too many",
            ),
        ],
        leads_to=("21",),
        note="The factor I - Φ̌ is one too many, for the matrix behind it is that factor. The tag (20) is at the end of "
        "a block whose last row the text calls (21).",
    )
    M = product(C_p, C_ref)
    add(
        21,
        [Relation((one("φ_u"), total(entry(M, 1, 2), negative(entry(M, 2, 1))) / 2))],
        [
            ("select", (), "the entries 1,2 and 2,1 of (20) are φ_u and -φ_u"),
            (
                "average",
                (),
                "the skew-symmetric part has no second order in φ",
            ),
        ],
        unit="rad",
        leads_to=("22",),
        note="The true C_b2n is not known to the filter; with it the second entry is 0 and the half of φ_u remains. "
        "An error of the reference enters with its full size, constant in time.",
    )
    add(
        22,
        None,
        [("define", (), "(16), and the azimuth error of (21)")],
        defines=s("z"),
        leads_to=("23",),
    )
    add(
        23,
        [
            Relation(
                (
                    one("H_k"),
                    matrix(
                        [
                            [zero["0_3x3"], I_3, zero["0_3x3"], zero["0_3x6"]],
                            [zero["0_1x3"], zero["0_1x3"], row(0, 0, 1), zero["0_1x6"]],
                        ]
                    ),
                )
            )
        ],
        [("collect", (), "the velocity and φ_u; after the attitude, six states of (8) remain")],
        note=twenty_four,
    )

    # (24) to (26)  update.
    H, R, K = s("H_k|R|K_k")
    information = Relation((P_after, total(P**-1, product(transpose(H), R**-1, H)) ** -1))
    add(
        24,
        None,
        [
            ("add", (information,), "information of prediction and of measurement"),
            ("invert", (Relation((K, product(P_after, transpose(H), R**-1))),), "by the lemma of matrix inversion"),
        ],
        leads_to=("25", "26"),
        note="H without its index k: a label.",
    )
    add(
        25,
        None,
        [("minimise", (), "the squares of x - x(k-) and of z - H x, each weighted by its covariance")],
        leads_to=("27", "28", "29"),
        note="The sign is right: the residual is measured less predicted.",
    )
    add(
        26,
        None,
        [("substitute", (information,), "(24); only with this gain, with any other Joseph's form holds")],
    )

    # (27) to (29)  feedback.
    taken = [("define", (), "error = computed - true, so it is taken off")]
    add(
        27,
        [
            Relation((one(name), total(letters[normalize("NFC", f"{name}\u0302")], negative(one(f"δ{name}")))))
            for name in "lLh"
        ],
        taken,
        defines=s("δl|δL|δh"),
        leads_to=("9",),
        note="A letter is lost after δ; its two neighbours show it, and the text under (8) has it.",
    )
    add(28, None, taken, defines=s("δv_e|δv_n|δv_u"), leads_to=("9", "10"))
    q = s("q_0|q_1|q_2|q_3")
    units = symbols("e n u")
    of_phi = quaternion_error(q, units).jacobian(Matrix(units)) * -2
    true, computed, change = s("Q_b2n|Q̂_b2n|ΔQ")
    add(
        29,
        [
            Relation((true, total(computed, negative(change)))),
            Relation(
                (
                    change,
                    product(Rational(-1, 2), ImmutableMatrix(of_phi), column(*s("φ_e|φ_n|φ_u"))),
                )
            ),
        ],
        [
            (
                "rotate",
                (Relation((nc("Q̂_b2n"), product(nc("V"), true))),),
                "(19) with quaternions: the computed attitude is the true one turned by -φ, which is V",
            ),
            (
                "keep first order",
                (Relation((change, product(Rational(-1, 2), nc("U"), computed))),),
                "U is 0 beside φ; ΔQ is an error to be taken off, as in (27), no rotation to be multiplied with",
            ),
            ("multiply", (), "the product with a quaternion from the right, whose first column meets the 0"),
        ],
        note="Three slips: the first column of the matrix, which only a fourth component 0 before φ could meet; the "
        "product where the sum belongs; and, if the product stays, the sign, for a rotation that takes the error "
        "out is [1, +φ/2]. An exact rotation is Song-Lee (23), (24).",
    )

    # (30) to (32)  the detector.
    add(
        30,
        None,
        [("define", (), "what the sensors show is what acts on them, and noise")],
        defines=s("y_k|s_k|ν_y"),
        leads_to=("31", "32"),
    )
    add(
        31,
        None,
        [("define", (), "the moving deviation of the accelerometers, from the trace of the covariance of the window")],
        unit="m/s^2",
        note="The text over (31) says twice that the angular rate is used, for its mean and for its deviation; its "
        "own argument, and the superscript a of (31), want the deviation of the acceleration.",
    )
    y_w, N, n = s("y_w|N|n")
    third = Relation((one("ȳ_a"), product(1 / N, add_up(one("y_a")))))
    add(
        32,
        [
            Relation((one("T_w"), StrictLessThan(norm(product(1 / N, add_up(y_w))), one("γ_w"), evaluate=False))),
            third,
        ],
        [
            ("take the length", (), "a vector is not less than a number, and its components may be negative"),
        ],
        unit="rad/s",
        note="w stands for ω: a label. At rest T_w is the Earth's rate and the bias, not zero.",
    )
    add(
        "Ω_n",
        [Relation((one("Ω_n"), samples(n, one("index"), total(n, N, S.NegativeOne))))],
        [("count", (), "N samples from the n-th on end at n + N - 1; the print has N - n, none from n = N on")],
        defines=s("Ω_n"),
        leads_to=("31", "32"),
        note="N samples are meant, for (31) and (32) divide by N. The index is k there and l here: a label.",
    )
    return tuple(result)


def _position_rows(letters) -> tuple:
    """(9)  the rows of longitude and latitude: the exact rates differentiated, with ρ for the velocities."""
    L, h, R_E, R_N, R_EE, R_NN = (letters[name] for name in ("L", "h", "R_E", "R_N", "R_EE", "R_NN"))
    ve, vn, rho_e, rho_n = (letters[name] for name in ("v_e", "v_n", "ρ_e", "ρ_n"))
    dL, dh, dve, dvn = (letters[name] for name in ("δL", "δh", "δv_e", "δv_n"))
    velocities = {ve: rho_n * (R_E + h), vn: -rho_e * (R_N + h)}

    def written(slope):
        return slope.subs(velocities).subs(sin(L), tan(L) * cos(L))

    lon_rate, lat_rate = ve / ((R_E + h) * cos(L)), vn / (R_N + h)
    by_lat = total(written(lon_rate.diff(L)), written(lon_rate.diff(R_E)) * R_EE)
    lon = total(product(by_lat, dL), written(lon_rate.diff(h)) * dh, lon_rate.diff(ve) * dve)
    lat = total(written(lat_rate.diff(R_N)) * R_NN * dL, written(lat_rate.diff(h)) * dh, lat_rate.diff(vn) * dvn)
    return lon, lat
