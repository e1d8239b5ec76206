"""A model: one description of a filter, from which everything else is made.

A model is a value.  It names states, inputs, noise, measurements and functions once; indices, Jacobians, C, headers,
documents and tests are derived from it.  Nothing here assumes navigation.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction

from sympy import ImmutableMatrix, Matrix, Symbol

from boresight import BoresightError
from boresight.derive.checks import ERRORS, check_model, check_part, check_variable
from boresight.derive.constant import constant as constant
from boresight.derive.where import where_written, written_at

NONE = ImmutableMatrix(0, 0, [])


@dataclass(frozen=True)
class Variable:
    """A scalar or a vector: its symbols, its meaning and where it is valid; `variable` makes one.

    Parameters
    ----------
    name : str
        By which C and `Filter` call it.
    symbols : tuple of sympy.Symbol
        One for each component; their names appear in enums and in comments.
    unit : str
        SI, angles in rad: one for all components, or one for each with commas between.
    meaning : str
        A few words for headers and pages.
    low, high : tuple of float
        The valid box, inclusive: what lies beyond is refused by the C.
    frame : str, optional
        Where the components are resolved, or what the variable maps between.
    norm : (float, float), optional
        Where the Euclidean norm must lie, as of a quaternion; of an input, since no filter keeps
        that of a state.
    wraps : bool, optional
        As a state, an angle of which a whole turn means nothing: kept in [-pi, pi).
    wide : bool, optional
        An angle whose box goes beyond two turns, which without this word is taken for one in
        degrees.

    Raises
    ------
    BoresightError
        A box that is empty or not finite, a norm that no point of the box has.  Names that C has
        taken are refused by `Model`; units that are not SI, and degrees, by `generate` and `verify`.

    Notes
    -----
    When not to use it: `variable` is shorter, unless the symbols exist already.

    Examples
    --------
    >>> from sympy import Symbol
    >>> from boresight import Variable
    >>> x = Symbol("x", real=True)
    >>> Variable("place", (x,), "m", "place on the line", (-1.0,), (1.0,)).scalar
    x
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

    @property
    def unit_norm(self) -> bool:
        """Whether its norm is that of a unit vector or a quaternion: of a number without unit, and 1 in its range."""
        return self.norm is not None and self.unit == "1" and self.norm[0] <= 1 <= self.norm[1]


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
    """A quantity of a model, with symbols made from the names of its components.

    Parameters
    ----------
    name : str
        By which C and `Filter` call it.
    components : str
        Names of its components, with blanks between: "x y z" makes three symbols.
    unit : str
        SI, angles in rad: one for all components, or one for each with commas between.
    meaning : str
        A few words for headers and pages.
    low, high : float or iterable of float
        The valid box, inclusive: a number for all components, or one for each.
    frame : str, optional
        Where the components are resolved, or what the variable maps between.
    norm : (float, float), optional
        Where the Euclidean norm must lie, as of a quaternion.
    wraps : bool, optional
        As a state, an angle of which a whole turn means nothing: kept in [-pi, pi).  Its box must
        hold [-pi, pi].
    wide : bool, optional
        An angle whose box goes beyond two turns, which without this word is taken for one in
        degrees.

    Returns
    -------
    Variable
        `.symbols` for expressions, `.vector` a column of them, `.scalar` the one of a single
        component.

    Raises
    ------
    BoresightError
        Components that are no text, a bound that is no number, and what `Variable` refuses.

    Notes
    -----
    When not to use it: for a number that never changes; that is a `constant`.  The usual inputs and
    states of navigation are in `boresight.variables`.

    Examples
    --------
    >>> from boresight import variable
    >>> mu = variable("mu", "mu_x mu_y mu_z", "rad", "misalignment", -0.5, 0.5, frame="body")
    >>> mu.symbols
    (mu_x, mu_y, mu_z)
    >>> angle = variable("angle", "theta", "rad", "from north", -4.0, 4.0, wraps=True)
    >>> angle.scalar
    theta
    """
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
    """Inputs that belong together: one struct of C, passed by one pointer.

    Parameters
    ----------
    name : str
        Of the struct: `PREFIX_NAME` in C.
    meaning : str
        A few words for the header.
    fields : tuple of Variable
        Its members, in this order.

    Raises
    ------
    BoresightError
        No fields, or one that is no Variable.  Names that C has taken or that are there twice are
        refused by `Model`.

    Notes
    -----
    When not to use it: for the state, which is `Model.states`, and for z of a measurement without
    its own z, which `Filter.update` takes.  What the filter carries and corrects (`nav`) is one
    struct of its own; what changes at another rate, as a step and a fix, is better in two.

    Examples
    --------
    >>> from boresight import Struct, variable
    >>> dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
    >>> Struct("step", "one step", (dt,)).fields[0].name
    'dt'
    """

    name: str
    meaning: str
    fields: tuple[Variable, ...]
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)


@dataclass(frozen=True)
class FirstOrder:
    """How a linear H is tied to an exact measurement, whose Jacobian it is where the error is zero.

    Parameters
    ----------
    of : str, optional
        The measurement with the exact h; None for this one's own, which then is not printed.
    small : str, optional
        The input that H neglects, if it does neglect one.
    tied : tuple of (str, Matrix), optional
        Inputs of H that follow from the others where the state is right, and their expressions.

    Raises
    ------
    BoresightError
        Names of no measurement with an h, and of no input, are refused by `Model`.

    Notes
    -----
    When not to use it: for an H that follows, of z alone or with `at_zero`.

    Examples
    --------
    >>> from boresight import FirstOrder
    >>> FirstOrder(small="lag").of is None
    True
    """

    of: str | None = None
    small: str | None = None
    tied: tuple[tuple[str, Matrix], ...] = ()


@dataclass(frozen=True)
class Measurement:
    """A named measurement of `len(rows)` scalars, any of which a filter may leave out.

    z = H x + noise, or h(x) + noise.  Of an error state z is computed - measured, and what it shows
    of x follows from `feedback` where neither h nor H is given; of a total state z is the measured
    value.

    Parameters
    ----------
    name : str
        By which `Filter.update` and C call it.
    rows : tuple of str
        Names of its rows, for masks and enums.
    unit : str
        Of z: one for all rows, or one for each with commas between.
    meaning : str
        What z is, as "velocity of the master: z = computed - measured".
    z : (m,) Matrix, optional
        z from the inputs; None if the caller brings it, and then it is the measured value.
    h : (m,) Matrix, optional
        The z of a state x without noise, from states and inputs; its Jacobian is printed as H.  Of
        an error state it may be what the sensor should show, from the estimates alone: what the
        errors do to it follows from `feedback`.
    H : (m, n) Matrix, optional
        A linear measurement matrix, instead of h.
    first_order : FirstOrder, optional
        What a given H approximates, of `boresight.derive.model`; `verify` holds it against that.
    angle : bool or tuple of str, optional
        The rows that are angles, True for all: z, h and z - h are wrapped to [-pi, pi).  Without it
        no row is one, and a row in rad that grows with a state that wraps is refused; False means
        it.
    equations : tuple of str, optional
        The source, as "song-lee-2001 (16)".
    correlated : bool, optional
        R is (m, m), and not the variances of independent rows.
    low, high : tuple of float, optional
        Where a z that the caller brings must lie, one bound for each row; () for any finite value.
    at_zero : bool, optional
        Of an error state with a z of its own: H is printed where the error is zero, which is less
        code than the Jacobian at any x, and right where each step ends with `feedback`.

    Raises
    ------
    BoresightError
        A matrix that is none.  Neither h nor H, both without a first order, a shape, row or bound
        that does not fit, and a symbol that no struct declares are refused by `Model`, a unit by
        `generate`.

    Notes
    -----
    When not to use it: for a quantity that is read without being compared, as a lever arm: that is
    an input.  Do not repeat a row to give it more weight; R does that.

    Examples
    --------
    >>> from sympy import Matrix
    >>> from boresight import Measurement, variable
    >>> theta = variable("angle", "theta", "rad", "from north", -4.0, 4.0, wraps=True).scalar
    >>> read = Measurement("encoder", ("angle",), "rad", "the angle", h=Matrix([theta]), angle=True)
    >>> read.angles
    (0,)
    """

    name: str
    rows: tuple[str, ...]
    unit: str
    meaning: str
    z: Matrix | None = None
    h: Matrix | None = None
    H: Matrix | None = None
    first_order: FirstOrder | None = None
    angle: bool | tuple[str, ...] | None = None
    equations: tuple[str, ...] = ()
    correlated: bool = False
    low: tuple[float, ...] = ()
    high: tuple[float, ...] = ()
    at_zero: bool = False
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
    """One result of a `Function`.

    Parameters
    ----------
    name : str
        In C and in the dict that Python returns.  One that has the name of an input replaces it, in
        `strapdown` and `feedback`.
    value : Matrix
        (rows, columns) or (rows, 1) expression of states and inputs; Matrix([e]) of a scalar.
    unit : str
        One for all components, one for each with commas between, or "mixed".
    meaning : str
        A few words for the header.
    frame : str, optional
        Where the components are resolved.
    low, high : tuple of float, optional
        Where every component must lie for the function to answer, one bound for each; () for
        anywhere.

    Raises
    ------
    BoresightError
        A value that is no Matrix.  Bounds of another number and what has no form in C are refused
        by `Model`, a unit that is not that of the value by `generate` and `verify`.

    Notes
    -----
    When not to use it: for what only Python needs; compute that from the others in NumPy.

    Examples
    --------
    >>> from sympy import Matrix, Symbol
    >>> from boresight import Output
    >>> Output("rise", Matrix([2 * Symbol("l")]), "m", "height over the pivot").value.shape
    (1, 1)
    """

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
    """Any other function of inputs and state that is printed as C.

    A function called `strapdown` carries inputs over a step, one called `feedback` takes the errors
    x out of them; `Filter` and the C filter call these two by their names.

    Parameters
    ----------
    name : str
        `PREFIX_NAME` in C, an attribute of the `Library` in Python.
    meaning : str
        A few words for the header.
    outputs : tuple of Output
        What it returns.
    equations : tuple of str, optional
        The source, as "song-lee-2001 (16)".

    Raises
    ------
    BoresightError
        No outputs.  A name that the filter or C has taken, and two outputs of one name, are refused
        by `Model`.

    Notes
    -----
    When not to use it: for z, h and H, which belong to a `Measurement`, or for f, F and Q of the
    Model.

    Examples
    --------
    >>> from sympy import Matrix, sin
    >>> from boresight import Function, Output, variable
    >>> theta = variable("angle", "theta", "rad", "from hanging down", -4.0, 4.0).scalar
    >>> Function("tip", "where the tip is", (Output("x", Matrix([sin(theta)]), "1", "to the right"),)).name
    'tip'
    """

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
    """What F and G are the first order of: `verify` holds them against it; it is not printed.

    Parameters
    ----------
    strapdown : Function, optional
        Carries inputs, by their names, over dt; None for the model's own function of this name.
    feedback : Function, optional
        The same inputs once the errors x are taken out; None for the model's own.
    step : tuple of (Variable, Matrix), optional
        What strapdown reads over a short dt, and its expression, such as increments from rates;
        what is not given is zero, or the value of its box nearest to zero.
    driven : tuple of (Variable, Variable), optional
        A noise, and what of strapdown's inputs it adds to, an integral over the step or a rate; or
        the block of states that it drives by itself.  A noise that is not named is held where it
        drives one state by itself, with 1.
    level : Level, optional
        Of `boresight.derive.model`: where the errors stand against the computed axes, as in a psi
        model.

    Notes
    -----
    When not to use it: for a total state, whose f is the mechanics itself.

    Examples
    --------
    >>> from boresight import Mechanics, variable
    >>> dv = variable("dv", "dv", "m/s", "integral of the specific force", -50.0, 50.0)
    >>> noise = variable("accel_noise", "accel_noise", "m/s/sqrt(s)", "of the accelerometer", 0.0, 1.0)
    >>> Mechanics(driven=((noise, dv),)).strapdown is None
    True
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
    """One description of a filter, from which C, tests and pages are made.

    A state of one of two kinds, driven by white noise w of densities `noise` over steps of `dt`.

    - Error state: F, x' = F x + G w, or in discrete time Phi and Q.  x is what navigation errs by,
      is zero once `feedback` has taken it out, and is carried by Phi.  Given neither, they follow
      from the functions `strapdown` and `feedback`, and from what `mechanics` says of noise.
    - Total state: f, x' = f(x) + G w, carried by f itself over each step with the inputs held; or,
      in discrete time, next and Q.

    A model without states has functions alone, such as a strapdown integrator: no F, G, noise, dt
    or measurements.

    Parameters
    ----------
    name : str
        Lower-case words joined by "-": of the folder, the header and the pages.
    c_prefix : str
        Of every name in C; no other model in the same program may have it.
    title : str
        One line for pages and headers.
    frame : str
        In words, as "NED with body axes front-right-down".
    states : tuple of Variable
        Blocks of the state, in the order of P.
    structs : tuple of Struct
        The inputs.
    G : (n, m) Matrix, optional
        What the noises do to the state.
    noise : (m,) Matrix, optional
        Noise densities, roots of power spectral densities.  Of a total state both may depend on it.
    dt : sympy.Symbol, optional
        The step, which a model in discrete time need not have: of a variable, its `.scalar`.
    F : (n, n) Matrix, optional
        Of an error state, from the inputs.
    f : (n,) Matrix, optional
        Of a total state, from states and inputs.
    measurements : tuple of Measurement, optional
        What the filter is updated by.
    functions : tuple of Function, optional
        Others, among them `strapdown` and `feedback`.
    equations : tuple of str, optional
        The source of F, as "song-lee-2001 (20)".
    card : tuple of str, optional
        Its conventions, a line each, printed at the head of what is generated.
    mechanics : Mechanics, optional
        What `verify` holds F and G against.
    next : (n,) Matrix, optional
        Of a total state in discrete time, the state one step later.
    Q : (n, n) Matrix, optional
        With next or Phi, the covariance that the noise adds in a step.
    order : {2, 1, 3}, optional
        Of an error state, the power of F dt to which Phi is taken; Q is right to one more of dt.
    loops : bool, optional
        Of a state carried by f, the filter in C takes its step by loops over printed f, F and Qc,
        which is less code and slower.
    Phi : (n, n) Matrix, optional
        Of an error state in discrete time, from the inputs.
    exact : bool, optional
        Of an error state that gives neither F nor Phi: not F and a series, but Phi as the derivative
        of the strapdown's step, and Q as the noises of that step.
    error : {"computed - true", "true - computed"}, optional
        The sign of an error state's errors; z stays computed - measured.
    unheld : tuple of (str, str), optional
        What nothing exact can be held against, and why: name of a function, as "F" or "fix_H", and
        the reason.  `verify` prints it and counts it as held; `verify --strict` does not.

    Raises
    ------
    BoresightError
        What does not fit together, with file and line: two kinds at once, a symbol that no struct
        declares, a shape, a name that is taken, `order` or `loops` of a kind that would ignore it.
        Units are held by `generate`, `verify` and `boresight show`.

    Notes
    -----
    When not to use it: where the model changes in flight, as another number of states; generate one
    for each.  A larger one from a known one is made by `extend`.

    Examples
    --------
    >>> from sympy import Matrix
    >>> from boresight import Measurement, Model, Struct, variable
    >>> place = variable("place", "x", "m", "place on the line", -100.0, 100.0)
    >>> dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
    >>> walk = variable("walk", "q", "m/sqrt(s)", "noise density of the place", 0.0, 1.0)
    >>> model = Model(
    ...     name="walker", c_prefix="wk", title="a walk on a line, 1 state", frame="none",
    ...     states=(place,), structs=(Struct("step", "one step", (dt, walk)),),
    ...     f=Matrix([0]), G=Matrix([1]), noise=walk.vector, dt=dt.scalar,
    ...     measurements=(Measurement("fix", ("x",), "m", "the place that is read", h=place.vector),),
    ... )
    >>> model.kind, model.n
    ('total-state', 1)
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
    Phi: Matrix | None = None
    exact: bool = False
    error: str = ERRORS[0]
    unheld: tuple[tuple[str, str], ...] = ()
    where: str = where_written()

    def __post_init__(self) -> None:
        check_part(self)
        check_model(self)

    @property
    def kind(self) -> str:
        """`total-state`, `error-state`, or `functions` of a model without states."""
        total = self.f is not None or self.next is not None
        return "functions" if not self.states else "total-state" if total else "error-state"

    @property
    def conventions(self) -> tuple[str, ...]:
        """Its card, with the sign of an error state's errors in front where the card does not say it."""
        stands = self.kind != "error-state" or any(line.startswith("Error =") for line in self.card)
        return self.card if stands else (f"Error = {self.error}.", *self.card)

    @property
    def discrete(self) -> bool:
        """Whether its steps are given, and not the rates that they follow from."""
        return self.next is not None or self.Phi is not None

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
        unheld: tuple[tuple[str, str], ...] = (),
    ) -> "Model":
        """A larger model: new states behind the old ones; what carries a known name replaces it.

        Parameters
        ----------
        name, c_prefix : str
            Of the new model.
        title : str, optional
            The old one if left out.
        states : tuple of Variable, optional
            k further components.
        structs : tuple of Struct, optional
            Added; one with a known name stands in the place of the old one.
        F : (n + k, n + k) Matrix, optional
            Added to the old F, whose new rows and columns are zero.
        f : (n + k,) Matrix, optional
            Added to the old f, whose new rows are zero.
        G : (n + k, m + j) Matrix, optional
            Added to the old G; its new columns belong to `noise`.
        noise : (j,) Matrix, optional
            Densities of the new noises.
        measurements : tuple of Measurement, optional
            As `structs`.
        functions : tuple of Function, optional
            As `structs`.
        equations : tuple of str, optional
            Added to the source.
        unheld : tuple of (str, str), optional
            Added to the list.

        Returns
        -------
        Model

        Raises
        ------
        BoresightError
            A model that is given by next; F for an f, or f for an F; and what `Model` refuses.

        Notes
        -----
        A measurement with an H that is not replaced has no part in the new states.  When not to use
        it: to take states away; write that model anew.
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
            unheld=self.unheld + unheld,
        )
