"""A model: one description of a filter, from which everything else is made.

A model is a value.  It names states, inputs, noise, measurements and functions once; indices, Jacobians, C, headers,
documents and tests are derived from it.  Nothing here assumes navigation.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction

from sympy import ImmutableMatrix, Matrix, Symbol

from boresight import BoresightError
from boresight.derive.checks import check_model, check_part, check_variable
from boresight.derive.constant import constant as constant
from boresight.derive.where import where_written, written_at

NONE = ImmutableMatrix(0, 0, [])


@dataclass(frozen=True)
class Variable:
    """A scalar or a vector: its symbols, its meaning and where it is valid.

    symbols: one SymPy symbol a component; their names appear in enums and in comments.
    unit: SI, angles in rad.  frame: where the components are resolved, or what the variable maps between.
    low, high: the valid box, inclusive, the same for each component or one value each.
    norm: where the Euclidean norm must lie (for a quaternion), or None.
    wraps: as a state, an angle of which a whole turn means nothing: kept in [-pi, pi).
    wide: an angle whose box goes beyond two turns, which without this word is taken for one in degrees.
    """

    name: str
    symbols: tuple[Symbol, ...]
    unit: str
    meaning: str
    low: tuple[float, ...]
    high: tuple[float, ...]
    frame: str = ""
    norm: tuple[float, float] | None = None
    wraps: bool = False
    wide: bool = False
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)
        check_variable(self)

    @property
    def vector(self) -> Matrix:
        """Column of the symbols."""
        return Matrix(self.symbols)

    @property
    def scalar(self) -> Symbol:
        """The symbol of a variable with one component."""
        if len(self.symbols) != 1:
            raise BoresightError(
                f"{written_at()}: variable {self.name} has the {len(self.symbols)} symbols "
                f"{', '.join(map(str, self.symbols))}; take them from its .symbols"
            )
        return self.symbols[0]

    @property
    def size(self) -> int:
        return len(self.symbols)


def variable(
    name: str,
    components: str,
    unit: str,
    meaning: str,
    low: float | Iterable[float],
    high: float | Iterable[float],
    *,
    frame: str = "",
    norm: tuple[float, float] | None = None,
    wraps: bool = False,
    wide: bool = False,
) -> Variable:
    """A Variable from its components' names, as in `variable("mu", "mu_x mu_y mu_z", "rad", "...", -0.5, 0.5)`."""
    if not isinstance(components, str):
        raise BoresightError(f"{written_at()}: variable {name}: its components are one text, as 'x y z'")
    symbols = tuple(Symbol(component, real=True) for component in components.split())

    def bound(value: float | Iterable[float]) -> tuple[float, ...]:
        try:
            return tuple(map(float, value)) if isinstance(value, Iterable) else (float(value),) * len(symbols)
        except (TypeError, ValueError):
            raise BoresightError(
                f"{written_at()}: variable {name}: {value!r} is no bound of a box; give a number, or one per component"
            ) from None

    return Variable(name, symbols, unit, meaning, bound(low), bound(high), frame, norm, wraps, wide)


@dataclass(frozen=True)
class Struct:
    """Inputs that travel together: one C struct."""

    name: str
    meaning: str
    fields: tuple[Variable, ...]
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)


@dataclass(frozen=True)
class FirstOrder:
    """How a linear H is tied to an exact measurement: it is that one's Jacobian at x = 0, once `small` is zero.

    of: name of the measurement with the exact h, or None for this one's own, which then is not printed.  small: the
    input that H neglects, if it does neglect one.  tied: inputs of H that follow from the others where the state is
    right, as (name, expression).
    """

    of: str | None = None
    small: str | None = None
    tied: tuple[tuple[str, Matrix], ...] = ()


@dataclass(frozen=True)
class Measurement:
    """A named measurement of `len(rows)` scalars, any of which a filter may leave out.

    z = H x + noise, or h(x) + noise, of the error x = computed - true: so z is computed - measured, or of a turn
    whatever H makes of it.  meaning: says which, as `velocity of the master: z = computed - measured`.
    z: (m) from the inputs; None if the caller brings it, and then it is the measured value.
    h: (m) the z of a state x without noise, from states and inputs; its Jacobian is printed as H.
    H: (m, n) a linear measurement matrix, printed instead of h.  first_order: what this H approximates.
    angle: the rows that are angles, True for all of them: z, h and z - h are wrapped to [-pi, pi).
    correlated: R is (m, m), not the variances of independent rows.
    """

    name: str
    rows: tuple[str, ...]
    unit: str
    meaning: str
    z: Matrix | None = None
    h: Matrix | None = None
    H: Matrix | None = None
    first_order: FirstOrder | None = None
    angle: bool | tuple[str, ...] = False
    equations: tuple[str, ...] = ()
    correlated: bool = False
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)

    @property
    def angles(self) -> tuple[int, ...]:
        """The places of the rows that are angles."""
        named = self.rows if self.angle is True else self.angle or ()
        return tuple(i for i, row in enumerate(self.rows) if row in named)


@dataclass(frozen=True)
class Output:
    """low, high: where every component must lie for the function to answer, or () for anywhere."""

    name: str
    value: Matrix
    unit: str
    meaning: str
    frame: str = ""
    low: tuple[float, ...] = ()
    high: tuple[float, ...] = ()
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)


@dataclass(frozen=True)
class Function:
    """Any other function of the inputs and the state: strapdown and feedback of an error state, other coordinates."""

    name: str
    meaning: str
    outputs: tuple[Output, ...]
    equations: tuple[str, ...] = ()
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)


@dataclass(frozen=True)
class Level:
    """The axes against which errors stand, where they are not the true ones: those of the computed place.

    axes: (3, 3) C_n2e at the inputs.  vector, quaternion: inputs that are resolved in n, and turn with it.
    """

    axes: Matrix
    vector: Variable
    quaternion: Variable


@dataclass(frozen=True)
class Mechanics:
    """What F and G are the first order of: `verify` holds them against it, and nothing of it is printed.

    strapdown: carries inputs, by their names, over dt; feedback: the same inputs once the errors x are taken out; None
    for the model's own functions of these names.  step: what strapdown reads over a short dt, and its expression, such
    as increments from rates; what is not given is zero.  driven: a noise, and what of these it adds to each second.
    level: where the errors stand against the computed axes, as in a psi model.
    """

    strapdown: Function | None = None
    feedback: Function | None = None
    step: tuple[tuple[Variable, Matrix], ...] = ()
    driven: tuple[tuple[Variable, Variable], ...] = ()
    level: Level | None = None


# Q of an error state is a sum of squares, weight B S S' B' with S S' = Qc dt: for each order of Phi the weights, and of
# each B what stands with the powers of A = F dt.  Order 2 has the two nodes of Radau; order 1 the middle of the step;
# order 3 the mean of Phi over the step and its slope, by Legendre's polynomials.
Node = tuple[Fraction, tuple[Fraction, ...]]
SPREAD: dict[int, tuple[Node, ...]] = {
    1: ((Fraction(1), (Fraction(1), Fraction(1, 2))),),
    2: ((Fraction(1, 4), (Fraction(1),)), (Fraction(3, 4), (Fraction(1), Fraction(2, 3), Fraction(2, 9)))),
    3: (
        (Fraction(1), (Fraction(1), Fraction(1, 2), Fraction(1, 6), Fraction(1, 24))),
        (Fraction(1, 3), (Fraction(0), Fraction(1, 2), Fraction(1, 4))),
    ),
}


@dataclass(frozen=True)
class Model:
    """A state of one of two kinds, driven by white noise w of densities `noise` over steps of `dt`.

    error-state: F (n, n), x' = F x + G w.  x is what navigation errs by, is zero once `feedback` has taken it out, and
    is flown by Phi.  total-state: f (n), x' = f(x) + G w, flown by f itself over each step with the inputs held; or, in
    discrete time, next (n), the state one step later, with Q (n, n), the covariance that the noise adds.
    G: (n, m).  noise: (m) noise densities, roots of power spectral densities.  Of a total state both may depend on it.
    dt: symbol of the step, which a model in discrete time need not have.  order: of an
    error state, the power of F dt to which Phi is taken; Q is right to one more of dt (SPREAD).  structs: the inputs.
    loops: of a state flown by f, the filter in C takes its step by loops over printed f, F and Qc, which is less code.
    equations: the source of F, as `song-lee-2001 (20)`.
    A model without states has functions alone, such as a strapdown integrator: no F, G, noise, dt or measurements.
    """

    name: str
    c_prefix: str
    title: str
    frame: str
    states: tuple[Variable, ...]
    structs: tuple[Struct, ...]
    G: Matrix = NONE
    noise: Matrix = NONE
    dt: Symbol | None = None
    F: Matrix | None = None
    f: Matrix | None = None
    measurements: tuple[Measurement, ...] = ()
    functions: tuple[Function, ...] = ()
    equations: tuple[str, ...] = ()
    card: tuple[str, ...] = ()  # its conventions, a line each, printed at the head of what is generated
    mechanics: Mechanics | None = None
    next: Matrix | None = None
    Q: Matrix | None = None
    order: int = 2
    loops: bool = False
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)
        check_model(self)

    @property
    def kind(self) -> str:
        """`total-state`, `error-state`, or `functions` of a model without states."""
        return "functions" if not self.states else "error-state" if self.F is not None else "total-state"

    @property
    def x(self) -> Matrix:
        """Column of all state symbols."""
        return Matrix([symbol for block in self.states for symbol in block.symbols])

    @property
    def n(self) -> int:
        return sum(block.size for block in self.states)

    @property
    def inputs(self) -> tuple[Variable, ...]:
        """Every input, struct after struct."""
        return tuple(item for struct in self.structs for item in struct.fields)

    def extend(
        self,
        *,
        name: str,
        c_prefix: str,
        title: str | None = None,
        states: tuple[Variable, ...] = (),
        structs: tuple[Struct, ...] = (),
        F: Matrix | None = None,
        f: Matrix | None = None,
        G: Matrix | None = None,
        noise: Matrix | None = None,
        measurements: tuple[Measurement, ...] = (),
        functions: tuple[Function, ...] = (),
        equations: tuple[str, ...] = (),
    ) -> "Model":
        """A larger model: new states behind the old ones; what carries a known name replaces it.

        F: (n + k, n + k) to be added to the old F, whose new rows and columns are zero; f: (n + k) to be added to the
        old f, whose new rows are zero.  G: (n + k, m + j), whose new columns belong to `noise`.  A measurement with an
        H that is not replaced sees none of the new states.  Raises BoresightError on a model that is given by next.
        """
        grown = sum(block.size for block in states)
        if self.next is not None or (F if self.F is None else f) is not None:
            own = "next" if self.next is not None else "f" if self.F is None else "F"
            raise BoresightError(
                f"{self.name}: extend adds F to an F and f to an f; this model is given by {own}"
                + ("; write the larger one as a Model of its own" if own == "next" else "")
            )

        def pad(matrix: Matrix, rows: int, columns: int) -> Matrix:
            out = Matrix.zeros(matrix.rows + rows, matrix.cols + columns)
            out[: matrix.rows, : matrix.cols] = matrix
            return out

        extra = 0 if noise is None else noise.rows
        wide_G = pad(self.G, grown, extra)

        def wide(old: Matrix | None, columns: int, added: Matrix | None) -> Matrix | None:
            if old is None:
                return None
            return pad(old, grown, columns) if added is None else pad(old, grown, columns) + added

        kept = tuple(
            replace(m, H=pad(m.H, 0, grown)) if m.H is not None else m
            for m in self.measurements
            if m.name not in {new.name for new in measurements}
        )
        return Model(
            name=name,
            c_prefix=c_prefix,
            title=title or self.title,
            frame=self.frame,
            states=self.states + states,
            structs=tuple(s for s in self.structs if s.name not in {new.name for new in structs}) + structs,
            F=wide(self.F, grown, F),
            f=wide(self.f, 0, f),
            G=wide_G if G is None else wide_G + G,
            noise=self.noise if noise is None else Matrix.vstack(self.noise, noise),
            dt=self.dt,
            measurements=kept + measurements,
            functions=tuple(f for f in self.functions if f.name not in {new.name for new in functions}) + functions,
            equations=self.equations + equations,
            card=self.card,
            mechanics=self.mechanics,
            order=self.order,
            loops=self.loops,
        )
