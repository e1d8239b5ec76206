"""A model: one description of a filter, from which everything else is made.

A model is a value.  It names states, inputs, noise, measurements and functions once; indices, Jacobians, C, headers,
documents and tests are derived from it.  Nothing here assumes navigation.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from sympy import ImmutableMatrix, Matrix, Symbol

from boresight import BoresightError
from boresight.derive.where import where_written

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
# Names that mean something in the generated C already: C's own (with what its headers define), and the generator's.
TAKEN = """
    auto break case char const continue default do double else enum extern float for goto if inline int long register
    restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    bool true false asm NULL NAN INFINITY HUGE_VAL size_t offsetof isnan isinf isfinite signbit errno assert
    sin cos atan2 sqrt fabs x z R P status filter innovation rows gate iterations covariance arg res iw w mem
"""
RESULTS = ("F", "Phi", "Q", "Qc")  # the functions of every model with states
NONE = ImmutableMatrix(0, 0, [])


@dataclass(frozen=True)
class Variable:
    """A scalar or a vector: its symbols, its meaning and where it is valid.

    symbols: one SymPy symbol a component; their names appear in enums and in comments.
    unit: SI, angles in rad.  frame: where the components are resolved, or what the variable maps between.
    low, high: the valid box, inclusive, the same for each component or one value each.
    norm: where the Euclidean norm must lie (for a quaternion), or None.
    wraps: as a state, an angle of which a whole turn means nothing: kept in [-pi, pi).
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
    where: str = where_written()

    def __post_init__(self) -> None:
        from boresight.derive.checks import check_part

        check_part(self)

    @property
    def vector(self) -> Matrix:
        """Column of the symbols."""
        return Matrix(self.symbols)

    @property
    def scalar(self) -> Symbol:
        """The symbol of a variable with one component."""
        (symbol,) = self.symbols
        return symbol

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
) -> Variable:
    """A Variable from its components' names, as in `variable("mu", "mu_x mu_y mu_z", "rad", "...", -0.5, 0.5)`."""
    symbols = tuple(Symbol(component, real=True) for component in components.split())

    def bound(value: float | Iterable[float]) -> tuple[float, ...]:
        return tuple(value) if isinstance(value, Iterable) else (float(value),) * len(symbols)

    return Variable(name, symbols, unit, meaning, bound(low), bound(high), frame, norm, wraps)


@dataclass(frozen=True)
class Struct:
    """Inputs that travel together: one C struct."""

    name: str
    meaning: str
    fields: tuple[Variable, ...]
    where: str = where_written()

    def __post_init__(self) -> None:
        from boresight.derive.checks import check_part

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
    h: (m) the z of an error state x without noise, from states and inputs; its Jacobian is printed as H.
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
        from boresight.derive.checks import check_part

        check_part(self)


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
        from boresight.derive.checks import check_part

        check_part(self)


@dataclass(frozen=True)
class Function:
    """Any other function of the inputs and the error state: strapdown, feedback, a change of coordinates."""

    name: str
    meaning: str
    outputs: tuple[Output, ...]
    equations: tuple[str, ...] = ()
    where: str = where_written()

    def __post_init__(self) -> None:
        from boresight.derive.checks import check_part

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


@dataclass(frozen=True)
class Model:
    """A state of one of two kinds, driven by white noise w of densities `noise` over steps of `dt`.

    error-state: F (n, n), x' = F x + G w.  x is what navigation errs by, is zero once `feedback` has taken it out, and
    is flown by Phi.  total-state: f (n), x' = f(x) + G w, flown by f itself over each step with the inputs held; or, in
    discrete time, next (n), the state one step later, with Q (n, n), the covariance that the noise adds.
    G: (n, m).  noise: (m) noise densities, roots of power spectral densities.  dt: symbol of the step.  order: of an
    error state, the power of F dt to which Phi is taken; Q is taken to one more of dt.  structs: the inputs.
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
    where: str = where_written()

    def __post_init__(self) -> None:
        from boresight.derive.checks import check_model, check_part

        check_part(self)
        check_model(self)
        check(self)

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

    def _repr_latex_(self) -> str:
        """Its F block by block, for a notebook that shows no HTML."""
        from boresight.derive.pages.booklet import latex_cell
        from boresight.derive.pages.model import formulas

        shown = formulas(self)
        return latex_cell([form.relation for form in shown], shown[0].quantities)

    def _repr_html_(self) -> str:
        """Its page, as `boresight show` has it, for a notebook."""
        from boresight.derive.pages.html import html_cell
        from boresight.derive.pages.model import model_page

        return html_cell(model_page(self))

    def extend(
        self,
        *,
        name: str,
        c_prefix: str,
        title: str | None = None,
        states: tuple[Variable, ...] = (),
        structs: tuple[Struct, ...] = (),
        F: Matrix | None = None,
        G: Matrix | None = None,
        noise: Matrix | None = None,
        measurements: tuple[Measurement, ...] = (),
        functions: tuple[Function, ...] = (),
        equations: tuple[str, ...] = (),
    ) -> "Model":
        """A larger model: new states behind the old ones; what carries a known name replaces it.

        F: (n + k, n + k) to be added to the old F, whose new rows and columns are zero.  G: (n + k, m + j), whose new
        columns belong to `noise`.  A measurement with an H that is not replaced sees none of the new states.
        """
        grown = sum(block.size for block in states)
        if self.F is None:
            raise BoresightError(f"{self.name}: extend works on a model that states F")

        def pad(matrix: Matrix, rows: int, columns: int) -> Matrix:
            out = Matrix.zeros(matrix.rows + rows, matrix.cols + columns)
            out[: matrix.rows, : matrix.cols] = matrix
            return out

        extra = 0 if noise is None else noise.rows
        wide_F, wide_G = pad(self.F, grown, grown), pad(self.G, grown, extra)
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
            F=wide_F if F is None else wide_F + F,
            G=wide_G if G is None else wide_G + G,
            noise=self.noise if noise is None else Matrix.vstack(self.noise, noise),
            dt=self.dt,
            measurements=kept + measurements,
            functions=tuple(f for f in self.functions if f.name not in {new.name for new in functions}) + functions,
            equations=self.equations + equations,
            card=self.card,
            mechanics=self.mechanics,
        )


def parts_of(*matrices: Matrix) -> set[Any]:
    """Every expression within the matrices.  What is held many times is looked at once: SymPy's own free_symbols takes
    seconds where residuals are nested rotations."""
    seen: set[Any] = set()
    stack = [entry for matrix in matrices for entry in matrix]
    while stack:
        part = stack.pop()
        if part not in seen:
            seen.add(part)
            stack += part.args
    return seen


def symbols_in(*matrices: Matrix) -> set[Symbol]:
    """All symbols that the matrices read."""
    return {part for part in parts_of(*matrices) if part.is_Symbol}


def substituted(matrix: Matrix, mapping: Mapping[Symbol, Any]) -> Matrix:
    """The matrix with expressions in the place of symbols; as in symbols_in, what is held many times is done once."""
    known: dict[Any, Any] = dict(mapping)

    def visit(part: Any) -> Any:
        if part not in known:
            known[part] = part.func(*map(visit, part.args)) if part.args else part
        return known[part]

    return Matrix(*matrix.shape, [visit(entry) for entry in matrix])


def check(model: Model) -> None:
    """Raise BoresightError on a model whose parts do not fit: shapes, names, symbols that nothing declares."""

    def fail(text: str) -> None:
        raise BoresightError(f"model {model.name}: {text}")

    if not re.fullmatch(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", model.name):
        fail("a name is lower-case words joined by '-'")
    if not re.fullmatch(r"[a-z][a-z0-9]*", model.c_prefix) or model.c_prefix == "bs":
        fail(f"c_prefix {model.c_prefix!r} must be lower-case letters and digits, and not 'bs'")
    names = [item.name for item in (*model.states, *model.inputs)]
    units = [m.name for m in model.measurements] + [f.name for f in model.functions] + [s.name for s in model.structs]
    units += [f"{m.name}_{part}" for m in model.measurements for part in "zhH"] + list(RESULTS) * (model.n > 0)
    symbols = [symbol for item in (*model.states, *model.inputs) for symbol in item.symbols]
    for kind, listed in (
        ("field", names),
        ("measurement, function or struct", units),
        ("symbol", [s.name for s in symbols]),
    ):
        for item in listed:
            if listed.count(item) > 1:
                fail(f"the {kind} name {item!r} is used twice")
            if not NAME.match(item):
                fail(f"{item!r} cannot be a name in C")
            # a component's name stands in C only within longer ones
            if kind != "symbol" and (item in TAKEN.split() or re.fullmatch(r"t\d+|(bs|BS)_.*", item)):
                fail(f"the {kind} name {item!r} has a meaning in C or in the generated code; choose another")

    n = model.n
    if n == 0 and (model.F is not None or model.f is not None or model.dt is not None or model.measurements):
        fail("without states there is no F, f, dt and no measurement")
    if n > 0 and (model.F is None) == (model.f is None):
        fail("give either F or f")
    shapes = [("F", model.F, (n, n)), ("f", model.f, (n, 1)), ("G", model.G, (n, model.noise.rows))]
    for m in model.measurements:
        own = m.first_order is not None and m.first_order.of is None
        if (m.H is None) == (m.h is None) and not (own and m.H is not None):
            fail(f"measurement {m.name}: give either h or H, or both with a first_order of its own")
        if m.H.is_zero_matrix if m.H is not None else not symbols_in(m.h) & set(model.x):
            fail(f"measurement {m.name} depends on no state")
        rows = len(m.rows)
        shapes += [(f"{m.name}: z", m.z, (rows, 1)), (f"{m.name}: h", m.h, (rows, 1)), (f"{m.name}: H", m.H, (rows, n))]
        if m.first_order is not None:
            exact = {other.name for other in model.measurements if other.h is not None}
            if (m.first_order.of or m.name) not in exact:
                named = m.first_order.of or m.name
                fail(f"measurement {m.name}: first_order names {named!r}, which is no measurement with an h")
            for item in (m.first_order.small, *(name for name, _ in m.first_order.tied)):
                if item is not None and item not in {v.name for v in model.inputs}:
                    fail(f"measurement {m.name}: first_order names {item!r}, which is no input")
    for label, matrix, shape in shapes:
        if matrix is not None and matrix.shape != shape:
            fail(f"{label} has shape {matrix.shape}, not {shape}")

    if n > 0 and not model.noise.rows:
        fail("give at least one noise")
    for i in range(model.noise.rows):
        if model.noise[i].is_zero or model.G[:, i].is_zero_matrix:
            fail(f"noise {model.noise[i]} has no effect: it or column {i} of G is zero")

    states, inputs = set(model.x), {s for item in model.inputs for s in item.symbols}
    linear = [("G", model.G), ("noise", model.noise)] + ([("F", model.F)] if model.F is not None else [])
    linear += [(f"{m.name}: z", m.z) for m in model.measurements if m.z is not None]
    linear += [(f"{m.name}: H", m.H) for m in model.measurements if m.H is not None]
    general = [("f", model.f)] if model.f is not None else []
    general += [(f"{m.name}: h", m.h) for m in model.measurements if m.h is not None]
    general += [(f.name, output.value) for f in model.functions for output in f.outputs]
    for parts, known in ((linear, inputs), (general, inputs | states)):
        for label, matrix in parts:
            unknown = sorted(symbol.name for symbol in symbols_in(matrix) - known)
            if unknown:
                fail(f"{label} uses {', '.join(unknown)}, which is no input" + ("" if known is inputs else " or state"))
    if n > 0 and model.dt not in inputs:
        fail(f"dt is {model.dt}, which is no input")
