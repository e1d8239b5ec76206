"""The numbered equations as they are printed, each beside its derivation."""

from functools import cache

from sympy import Function, Rational, S, Symbol, sin
from sympy.functions.elementary.complexes import transpose

from boresight.derive.ledger.equation import (
    Derivation,
    Equation,
    Reading,
    Relation,
    Step,
    negative,
    product,
    replaced,
    total,
)
from boresight.derive.ledger.reader import read
from boresight.derive.papers.kang_2025.printed import PRINTED, quantities

NAME = "kang-2025"


@cache
def equations() -> tuple[Equation, ...]:
    """The six numbered equations, in the paper's order."""
    letters = {quantity.symbol.name: quantity.symbol for quantity in quantities() if not quantity.function}

    def s(names: str) -> tuple[Symbol, ...]:
        return tuple(letters[name] for name in names.split("|"))

    def nc(name: str) -> Symbol:
        return Symbol(name, commutative=False)

    C, L, w_in, w_ib, w_n, w_b = s("C_S2n|L|[ω_in_n x]|[ω_ib_b x]|ω_nb_n|ω_nb_b")
    v_now, v_before, v_old, u_now, u_before = s("v_s(k)|v_s(k-1)|v_s(k+α)|u(k)|u(k-1)")
    step, delay, A, I, z_v, z_dcm, v_M = s("dt|δt_d|A|I|z_v|z_DCM|v_M")
    result: list[Equation] = []

    def add(number, derived=None, steps=(), unit="1", readings=(), **more):
        lines, latex = PRINTED[number]
        printed = read(latex, quantities())
        result.append(
            Equation(
                paper=NAME,
                number=number,
                latex=latex,
                lines=lines,
                printed=printed,
                derived=printed if derived is None else tuple(derived),
                derivation=Derivation(tuple(Step(*one) for one in steps)),
                readings=readings,
                unit=unit,
                quantities=quantities(),
                **more,
            )
        )

    def printed_side(number: str):
        (relation,) = read(PRINTED[number][1], quantities())
        return relation.sides[-1]

    # (1)  two ends of a rigid lever arm.
    w_nb, transposed = nc("[ω_nb_b x]"), transpose(C)
    add(
        "1",
        None,
        [
            (
                "place",
                (Relation((nc("r_s"), total(nc("r_m"), product(C, L)))),),
                "the lever arm runs from master to slave; the text leaves it open, the sign of the first line decides",
            ),
            (
                "differentiate",
                (Relation((letters["v_m"], total(letters["v_s"], negative(letters["dL/dt"])))),),
                "as seen from n; v_m is the velocity over the ground in the axes of the master's own place, so that "
                "products of speed and lever arm over the Earth's radius are dropped",
            ),
            (
                "turn",
                (Relation((letters["dL/dt"], product(nc("Ċ_S2n"), L), product(C, w_nb, L))),),
                "the arm is constant in the body: what changes is the attitude",
            ),
            (
                "substitute",
                (Relation((w_nb, total(w_ib, negative(product(transposed, w_in, C))))),),
                "the gyros measure against inertial space: the rate of n is taken off, turned into body axes",
            ),
            ("multiply", (Relation((product(C, transposed), I)),), "what remains are the two terms of the print"),
        ],
        unit="m/s",
        leads_to=("3",),
        small=("lever", "v_n", "velocity_error"),
        note="Both signs and both terms are right. Whether the transport rate belongs to ω_in, as the text says, is "
        "below what is dropped.",
    )

    # (2)  between two updates.
    rate = nc("v̇_s")
    add(
        "2",
        None,
        [
            (
                "expand",
                (
                    Relation((v_old, total(v_now, negative(product(delay, rate))))),
                    Relation((v_before, total(v_now, negative(product(step, rate))))),
                ),
                "to first order in delay and step; the text says that the master's data is that of k - δt_d",
            ),
            ("eliminate", (), "the rate: a straight line between the two velocities"),
        ],
        unit="m/s",
        leads_to=("3",),
        small=("delay", "step"),
        note="The index k+α is a label: the time is k - δt_d, so α is minus the delay as a share of the step, which "
        "the text does not say.",
    )

    # (3)  the velocity residual.
    terms = printed_side("3").args
    moved_arm = replaced(terms[3], {v_now: u_now, v_before: u_before})
    add(
        "3",
        [Relation((z_v, total(*terms[:4], moved_arm, terms[4])))],
        [
            (
                "expect",
                (Relation((nc("v_m_old"), total(v_old, nc("u_old")))),),
                "(1) at the time of the master's data; u is its lever-arm part, the second and third term of (3)",
            ),
            (
                "interpolate",
                (
                    Relation((v_old, total(v_now, product(1 / step, total(v_before, negative(v_now)), delay)))),
                    Relation((nc("u_old"), total(u_now, product(1 / step, total(u_before, negative(u_now)), delay)))),
                ),
                "(2), for both parts: the arm turns on during the delay as the slave flies on",
            ),
            (
                "subtract",
                (Relation((z_v, total(nc("v_m_old"), negative(v_M)))),),
                "the reported velocity: error = computed - true",
            ),
        ],
        unit="m/s",
        small=("delay", "step"),
        note="The print moves the slave's velocity back by the delay, but not the lever-arm velocity, which is of the "
        "same order in the delay. Its sign is right: (3) subtracts the change during the delay, where (5) adds it. "
        "Capital and small letters of the indices are labels.",
    )

    # (4), (5)  the attitude residual.
    X = product(*s("C_S2n|C_M2S|C_n2M"))
    less = total(X, negative(I))
    e = nc("[e x]")
    add(
        "4",
        [Relation((A, product(Rational(1, 2), total(less, negative(transpose(less, evaluate=False))))))],
        [
            (
                "chain",
                (Relation((X, Function("exp")(e))),),
                "components pass from n to M by the master, to S by the misalignment, to n by the slave; were all "
                "right and of one time it would be I, and it is the turn e",
            ),
            (
                "keep first order",
                (Relation((X, total(I, e, product(Rational(1, 2), e**2)))),),
                "the next order is symmetric",
            ),
            (
                "take the skew-symmetric part",
                (Relation((e, product(Rational(1, 2), total(X, negative(transpose(X, evaluate=False)))))),),
                "half of the whole difference: the symmetric order goes, and eye(3) with it",
            ),
        ],
        leads_to=("5",),
        note="As printed the 2 divides the transposed matrix alone. Brackets, or a long bar, may have been lost in "
        "the scan: the rule of the origin knows of letters only. If (4) is taken as it stands, (5) lacks a factor 2/3.",
    )
    seen, late = printed_side("5").args
    entry = Function("entry")
    add(
        "5",
        [Relation((z_dcm, total(seen, negative(replaced(late, {w_n: w_b})))))],
        [
            (
                "turn",
                (
                    Relation(
                        (
                            C,
                            product(total(I, product(delay, nc("[ω_nb_n x]"))), nc("C_old")),
                        )
                    ),
                ),
                "during the delay the slave turns on, to first order, from where it was at k - δt_d",
            ),
            (
                "chain",
                (
                    Relation(
                        (
                            X,
                            product(
                                total(I, product(delay, nc("[ω_nb_n x]"))),
                                total(I, nc("[z_DCM x]")),
                            ),
                        )
                    ),
                ),
                "z_DCM is the error at one time; (4) compares the slave of k with the master of k - δt_d",
            ),
            (
                "take the vector",
                (
                    Relation((nc("e_1"), -entry(A, 2, 3))),
                    Relation((nc("e_2"), entry(A, 1, 3))),
                    Relation((nc("e_3"), -entry(A, 1, 2))),
                ),
                "of A = [e x], by its entries; the signs of the print are right",
            ),
            (
                "subtract",
                (),
                "what the slave turned on; its rate is measured in the body, ω_nb_b, and C_S2n takes it to n, once",
            ),
        ],
        unit="rad",
        note="The last term has two slips, its sign and its frame. The sign: with the master at k - δt_d, as the text "
        "over (2) has it, the turn during the delay is taken off; (3) does so, (5) adds it, so the two contradict each "
        "other on the sign of one state. The frame: a rate in n needs no C_S2n before it. ω_nb is the rate of b "
        "against n, as ω_in and ω_ib are read.",
    )

    # (6)  the wave.
    height, frequency, time, pi_, wave = s("a|f|t|π|Seawave")
    phase = product(S(2), pi_, frequency, time)
    add(
        "6",
        [Relation((wave, height / 2 * sin(phase)))],
        [
            (
                "turn a wheel",
                (),
                "a point on a wheel whose diameter is the height of the wave, crest to trough, and which turns f times "
                "a second, goes up and down as the surface does",
            ),
            ("project", (Relation((wave, height / 2 * sin(phase))),), "the vertical component, from zero upwards"),
        ],
        readings=(
            Reading(
                Function("asin", commutative=False)(phase),
                height * sin(phase),
                "a is a letter of its own, as the text under (6) says; the arcsine has no real value after "
                "0.16 of a period",
            ),
        ),
        note="The text calls a the height of the wave, and Table 1 gives the heights of the code; in (6) it is the "
        "amplitude, half of that. If a is an amplitude (6) stands, and the column of Table 1 is half of the heights. "
        "f is called a period, and is 0.1 Hz: a label.",
    )
    return tuple(result)
