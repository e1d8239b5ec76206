"""F, G, Phi, Q and H of an error state, from its strapdown, its feedback and what its sensors should show.

An error x is put in by the feedback: y = feedback(y_hat, x) is the truth, and J its derivative at zero.  Both are
carried by the strapdown s, and the error is read out again, J being inverted from the left.  To first order

    x' = F x + G w,  F = J^+ (dr/dy J - dJ/dt),  G = -J^+ dr/du,  r = ds/dt at dt = 0

and over a step  Phi = J(s)^+ ds/dy J.  H of z = computed - measured is what feedback changes of z.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from random import Random
from typing import Any

import mpmath
import sympy as sp
from sympy import Matrix, S, Symbol

from boresight.derive.checks import fail, mechanics_of
from boresight.derive.dimensions import ROOT_SECOND
from boresight.derive.expressions import constants_in, names_in, product, quantities_in, substituted, symbols_in
from boresight.derive.gradients import Gradients, Slopes, at_zero, opened, polynomial
from boresight.derive.mechanics.rotation import (
    dcm_from_quaternion,
    normalized,
    quaternion_from_rotation_vector,
    quaternion_product,
    skew,
    vee,
)
from boresight.derive.model import NONE, FirstOrder, Function, Measurement, Mechanics, Model, Output, Struct, Variable
from boresight.derive.named import Named, named, quantity
from boresight.derive.short import Shortener, Sphere, mirrored, replaced, squares
from boresight.derive.units import units

TURNED = 1.5  # rad: the box of the error of a quaternion that is a state


class Derivation:
    """What follows from the strapdown and the feedback of one model.

    y: what either of them carries.  J: the derivative of the feedback at zero.  Raises BoresightError where a state is
    taken out of nothing, or several together are.
    """

    def __init__(self, model: Model):
        self.model = model
        self.mechanics = model.mechanics or Mechanics()
        self.fields = {v.name: v for v in model.inputs}
        strapdown, feedback = mechanics_of(model)
        self.x = [s for block in model.states for s in block.symbols]
        self.moved, self.fed = self.values(strapdown), self.values(feedback)
        self.y = list(dict.fromkeys([*self.fed, *self.moved]))
        names = names_in(Matrix([*self.moved.values(), *self.fed.values()]))
        unit_norm = [v for v in model.inputs if v.unit_norm]
        self.short = Shortener([Sphere(v.symbols, self.known(v, names)) for v in unit_norm])
        self.following = self.followed()
        self.true = self.fed | self.following
        at = Matrix([self.fed.get(s, s) for s in self.y])
        self.J = self.short(at_zero(Gradients(self.x)(at, self.x), self.x))
        self.K = self.against_level()
        self.inverse = self.inverted()
        by_x = dict(zip(self.y, map(self.row, self.J.tolist()), strict=True))
        follows = self.short(at_zero(Gradients(self.x)(Matrix([*self.following.values()]), self.x), self.x))
        self.seeds = by_x | dict(zip(self.following, map(self.row, follows.tolist()), strict=True))

    def row(self, entries: list[Any]) -> Slopes:
        """A row by the states as slopes."""
        return {s: e for s, e in zip(self.x, entries, strict=True) if e != 0}

    def values(self, f: Function) -> dict[Symbol, Any]:
        """What the function gives, by the symbols of the inputs it replaces; a norm that is 1 is left out, since errors
        do not leave its sphere."""
        known: dict[Any, Any] = {}

        def visit(e: Any) -> Any:
            if e not in known:
                if isinstance(e, Named):
                    known[e] = e.within(e.quantity.mapped(visit))
                elif not e.args:
                    known[e] = e
                elif e.is_Pow and not e.exp.is_positive and squares(e.base) and self.is_one(e.base):
                    known[e] = S.One
                else:
                    args = tuple(map(visit, e.args))
                    known[e] = e if args == e.args else e.func(*args)
            return known[e]

        return {s: visit(e) for o in f.outputs for s, e in zip(self.fields[o.name].symbols, o.value, strict=True)}

    def is_one(self, e: Any) -> bool:
        """At random points, but for what TINY_SQUARE changes."""
        return all(abs(self.numbers([e], self.point(k))[0] - 1) < 1e-25 for k in range(2))

    def numbers(self, matrix: Any, here: Mapping[Symbol, Any]) -> Matrix:
        known = {c: sp.Float(c.exact, 60) for c in constants_in(matrix)}
        known |= {s: here[s] for s in symbols_in(matrix) if s in here}
        return substituted(Matrix(matrix), known, names=False).evalf(60)

    def known(self, v: Variable, names: Iterable[Named]) -> list[Any]:
        """What polynomials of a quaternion or a direction are called."""
        return [*(dcm_from_quaternion(v.symbols) if v.size == 4 else ()), *names]

    def followed(self) -> dict[Symbol, Any]:
        """What is no estimate and follows from them, as a rate whose estimated bias is removed: what the sensor shows
        stands still."""
        found = {}
        for _, column in self.mechanics.step:
            shown = Matrix(column)
            for e, true in zip(shown, substituted(shown, self.fed), strict=True):
                read = [s for s in symbols_in([e]) if s not in self.fed and s != self.model.dt]
                if e != true and len(read) == 1 and read[0] in {s for v in self.fields.values() for s in v.symbols}:
                    found[read[0]] = read[0] + sp.expand(sp.cancel((e - true) / e.diff(read[0])))
        return found

    def against_level(self) -> Matrix:
        """How an error of what is carried stands against the level of the computed place, K = I + W, with W W = 0: a
        wrong place turns what is resolved there."""
        K = Matrix.eye(len(self.y))
        level = self.mechanics.level
        if level is None:
            return K
        w, *xyz = level.quaternion.symbols
        q = Matrix(xyz)
        for s in symbols_in(level.axes):
            slope = Gradients([s])(Matrix(9, 1, list(level.axes)), [s]).reshape(3, 3)
            turn = self.short(vee(level.axes.T * slope))
            by = [*zip(level.vector.symbols, skew(turn) * level.vector.vector, strict=True), (w, -turn.dot(q) / 2)]
            for symbol, entry in [*by, *zip(xyz, (w * turn + skew(turn) * q) / 2, strict=True)]:
                K[self.y.index(symbol), self.y.index(s)] += entry
        return K

    def inverted(self) -> Matrix:
        """J^+, block by block: the rows and columns of J that belong together."""
        found = Matrix.zeros(len(self.x), len(self.y))
        for rows, columns in self.blocks():
            J = self.J.extract(rows, columns)
            left = self.short(J.T * J).inv(method="ADJ") * J.T if len(rows) > 1 else Matrix([[1 / J[0]]])
            for i, row in enumerate(columns):
                for k, column in enumerate(rows):
                    found[row, column] = left[i, k]
        return self.short(found)

    def blocks(self) -> list[tuple[list[int], list[int]]]:
        """Rows and columns of J that are joined by entries; raises BoresightError where columns hang together."""
        blocks: list[tuple[set[int], set[int]]] = []
        for j, symbol in enumerate(self.x):
            rows = {i for i in range(len(self.y)) if self.J[i, j] != 0}
            if not rows:
                fail(self.model, f"feedback does not take out {symbol}: {symbol} = 1 is in the null space of its slope")
            joined = [one for one in blocks if one[0] & rows]
            blocks = [one for one in blocks if one not in joined]
            blocks.append((rows.union(*(r for r, _ in joined)), {j}.union(*(c for _, c in joined))))
        for rows, columns in blocks:
            self.full_rank(sorted(rows), sorted(columns))
        return [(sorted(rows), sorted(columns)) for rows, columns in sorted(blocks, key=lambda one: min(one[1]))]

    def full_rank(self, rows: list[int], columns: list[int]) -> None:
        """Raise BoresightError with the null vector where the columns of J are dependent everywhere."""
        ends = [pair for v in self.model.states for pair in zip(v.low, v.high, strict=True)]
        scale = [max(map(abs, ends[j])) for j in columns]
        for k in range(2):
            numbers = self.numbers(self.J.extract(rows, columns), self.point(k)).evalf(15)
            grown = [[float(e) * s for e, s in zip(row, scale, strict=True)] for row in numbers.tolist()]
            missing = [[0.0] * len(columns)] * max(0, len(columns) - len(rows))  # so that a null space has its vector
            _, sizes, right = mpmath.svd_r(mpmath.matrix([*grown, *missing]))
            if sizes[len(columns) - 1] > 1e-9 * sizes[0]:
                return
        null = [float(right[len(columns) - 1, j]) for j in range(len(columns))]
        most = max(map(abs, null))
        moved = [
            (self.x[j], u / most * s) for j, u, s in zip(columns, null, scale, strict=True) if abs(u) > 1e-9 * most
        ]
        text = ", ".join(f"{x} = {value:.3g}" for x, value in moved)
        fail(self.model, f"feedback takes nothing out where {text}: its slope has no full rank; leave a state out")

    def point(self, k: int) -> dict[Symbol, Any]:
        """Values of all inputs in their boxes, of the norm that is declared."""
        rng = Random(k)
        here: dict[Symbol, Any] = {}
        for v in (*self.model.states, *self.model.inputs, *(v for v, _ in self.mechanics.step)):
            column = [sp.Float(rng.uniform(0.8 * lo + 0.2 * hi, 0.2 * lo + 0.8 * hi), 60)
                      for lo, hi in zip(v.low, v.high, strict=True)]  # fmt: skip
            if v.norm:
                length = sp.sqrt(sum(c * c for c in column))
                wanted = 1 if v.unit_norm else sum(v.norm) / 2
                column = [c / length * wanted for c in column]
            here |= dict(zip(v.symbols, column, strict=True))
        return here

    def settled(self, matrix: Matrix) -> Matrix:
        """As short as it goes, without entries that are zero at random points in many digits."""
        short = self.short(matrix)
        for place, entry in short.todok().items():
            if entry.is_Add and all(self.vanishes(entry, k) for k in range(2)):
                short[place] = 0
        return short

    def vanishes(self, entry: Any, k: int) -> bool:
        values = self.numbers(list(sp.Add.make_args(entry)), self.point(k))
        return bool(abs(sum(values)) < 1e-45 * max(map(abs, values)))

    # ------------------------------------------------------------ over an instant

    def rates(self, spread: Matrix | None = None) -> tuple[Matrix, Matrix]:
        """F and G; spread: what the noises do to y, where nothing says which sensors they are of."""
        dt, increments = self.model.dt, self.increments()
        rate = {s: Symbol(f"{s}_rate", real=True) for s in increments}
        after = substituted(Matrix([self.moved.get(s, s) for s in self.y]), {s: r * dt for s, r in rate.items()})
        self.stands_still(self.short(at_zero(after, [dt])))
        r = self.short(opened(at_zero(Gradients([dt])(after, [dt]), [dt])))
        slopes = Gradients([*self.y, *rate.values(), *self.sensed()])

        def moving(matrix: Matrix) -> Matrix:
            """The rate of a matrix as what it reads is carried."""
            found = Matrix.zeros(*matrix.shape)
            for place, entry in matrix.todok().items():
                found[place] = (slopes(Matrix([entry]), self.y) * r)[0]
            return found

        K, level = self.K, 2 * Matrix.eye(len(self.y)) - self.K  # its inverse
        by_y = product(K, slopes(r, self.y), level) + moving(K)
        shown = self.shown(rate)
        F = product(self.inverse, substituted(product(by_y, self.J) - moving(self.J), shown))
        if not self.mechanics.driven and spread is not None:
            return self.settled(F), self.settled(product(self.inverse, spread))
        G = self.noises(product(self.inverse, K), lambda s: slopes(r, [rate.get(s, s)]))
        return self.settled(F), self.settled(substituted(G, shown))

    def increments(self) -> list[Symbol]:
        """What the strapdown reads as integrals over the step."""
        sums = [what for noise, what in self.mechanics.driven if not is_rate(noise, what)]
        read = [v for v, _ in self.mechanics.step] + sums
        return [s for s in dict.fromkeys(s for v in read for s in v.symbols) if s not in self.x]

    def sensed(self) -> list[Symbol]:
        return [s for _, what in self.mechanics.driven for s in what.symbols]

    def shown(self, rate: dict[Symbol, Symbol]) -> dict[Symbol, Any]:
        """The rates of the increments: as the model says it, or the increments over the step."""
        dt = self.model.dt
        stated = {s: e for v, column in self.mechanics.step for s, e in zip(v.symbols, column, strict=True)}
        return {r: sp.expand(stated[s] / dt) if s in stated else s / dt for s, r in rate.items()}

    def stands_still(self, after: Matrix) -> None:
        for s, e in zip(self.y, after, strict=True):
            if e.has(sp.nan, sp.zoo, sp.oo):
                fail(
                    self.model,
                    f"strapdown has no value of {s} over a step of no time, where the rate is taken: write what is "
                    "divided by dt, or by what goes with it, as a series or a Piecewise",
                )
            if self.short.short(e - s) != 0:
                read = ", ".join(sorted(str(r) for r in symbols_in(Matrix([e])) - set(self.y))) or "nothing"
                fail(
                    self.model,
                    f"over a step of no time strapdown makes {s} into {e}, which reads {read}; what it reads "
                    "as an integral over the step is named in Mechanics(step=...) or Mechanics(driven=...)",
                )

    def noises(self, inverse: Matrix, slope: Callable[[Symbol], Matrix]) -> Matrix:
        """What each noise adds to the errors; slope: of what is carried, by what the strapdown reads."""
        target = {
            n: s for noise, what in self.mechanics.driven for n, s in zip(noise.symbols, what.symbols, strict=True)
        }
        columns = []
        for n in self.model.noise:
            if n not in target:
                fail(
                    self.model,
                    f"nothing says what the noise {n} adds to; name it in Mechanics(driven=((noise, input),)), "
                    "with an input of strapdown, or a state that it drives by itself",
                )
            s = target[n]
            columns.append(Matrix([int(s == own) for own in self.x]) if s in self.x else product(-inverse, slope(s)))
        return Matrix.hstack(*columns)

    # ------------------------------------------------------------ over a step

    def step(self, spread: Matrix | None = None) -> tuple[Matrix, Matrix]:
        """Phi and Q, as the derivative of the strapdown gives them; spread: the covariance that a step adds to y."""
        dt = self.model.dt
        after = self.lettered(Matrix([self.moved.get(s, s) for s in self.y]))
        short = Shortener([*self.short.spheres, *self.turns(after)])
        slopes = Gradients([*self.y, *self.sensed()])
        back = short(substituted(self.inverse, dict(zip(self.y, after, strict=True))))
        Phi = short(product(back, product(slopes(after, self.y), self.J)))
        if spread is not None:
            return Phi, mirrored(short(product(back, spread, back.T)))
        grown = short(self.noises(back, lambda s: slopes(after, [s])))
        rates = {n for noise, what in self.mechanics.driven if is_rate(noise, what) for n in noise.symbols}
        added = Matrix.diag(*(n**2 / dt if n in rates else n**2 * dt for n in self.model.noise))
        return Phi, mirrored(product(grown, added, grown.T))

    def lettered(self, column: Matrix) -> Matrix:
        """The column as polynomials, with a name for each factor that is none, such as the parts of a rotation."""
        own = {s for sphere in self.short.spheres for s in sphere.letters}
        parts: dict[Any, Any] = {}

        def visit(e: Any) -> Any:
            if polynomial(e):
                return e
            if e.is_Add:
                return e.func(*map(visit, e.args))
            if e.is_Mul:
                kept = [part for part in e.args if part.is_Number or (polynomial(part) and symbols_in([part]) & own)]
                sums = [part for part in e.args if part.is_Add and not polynomial(part) and symbols_in([part]) & own]
                rest = sp.Mul(*(part for part in e.args if part not in kept and part not in sums))
                return sp.Mul(*kept, *map(visit, sums), rest if polynomial(rest) else letter(rest))
            return letter(e)

        def letter(e: Any) -> Any:
            sign = -1 if e.could_extract_minus_sign() else 1
            return sign * parts.setdefault(sign * e, Symbol(f"part_{len(parts)}", real=True))

        found = Matrix([visit(e) for e in column])
        labels = tuple(str(k + 1) for k in range(len(parts)))
        values = quantity("part", sp.ImmutableMatrix(list(parts)), "of a step", labels) if parts else None
        written = dict(zip(parts.values(), values.entries, strict=True)) if values else {}
        return found.applyfunc(lambda e: replaced(e, written))

    def turns(self, after: Matrix) -> list[Sphere]:
        """Further quaternions of unit norm: what one that is carried is turned by."""
        quantities = [one for one in quantities_in(after) if one.value.shape == (4, 1)]
        wholes = [list(one.entries) for one in quantities if all(isinstance(e, Named) for e in one.entries)]
        found = [Sphere(four) for four in wholes if self.is_one(sp.Add(*(e**2 for e in four)))]
        for sphere in self.short.spheres:
            if set(sphere.letters) <= set(self.moved):
                square = self.short.short(sp.Add(*(after[self.y.index(s)] ** 2 for s in sphere.letters)))
                if squares(square) and self.is_one(square):
                    found.append(Sphere([part.base for part in square.args]))
        return found

    # ------------------------------------------------------------ measurements

    def measurement(self, m: Measurement) -> Measurement:
        """The same with h as a function of the errors, and with H where it is asked for at zero."""
        h = m.h
        if m.H is None and h is None and m.z is not None:
            h = m.z - substituted(m.z, self.true)
        elif m.H is None and h is not None and not symbols_in(h) & set(self.x):
            h = substituted(h, self.true)
        if not m.at_zero:
            return m if h is m.h else replace(m, h=h)
        if m.h is None:
            H = -Gradients(self.seeds, self.short.short)(m.z, self.x)
        else:
            H = at_zero(Gradients(self.x)(h, self.x), self.x)
        H = H.applyfunc(lambda e: self.short.short(e) if polynomial(e) else e)
        return replace(m, h=h, H=H, at_zero=False, first_order=FirstOrder())


def is_rate(noise: Variable, what: Variable) -> bool:
    """Whether a noise is that of a rate, which it adds to as a density, and not that of its integral."""
    return units(noise.unit, noise.size)[0].like(units(what.unit, what.size)[0] * ROOT_SECOND)


def completed(model: Model) -> Model:
    """The model with what it leaves to be derived: F and G, or Phi and Q, and h and H of its measurements.

    Parameters
    ----------
    model : Model
        As it is written.

    Returns
    -------
    Model
        Itself where nothing is left open.

    Raises
    ------
    BoresightError
        A feedback of which some states take nothing out, with the null vector; a noise that is not
        said to add to anything; an integral over the step that is taken for a rate.

    Notes
    -----
    When not to use it: before `generate`, `verify`, `show` or `export`, which call it.

    Examples
    --------
    >>> from sympy import Matrix
    >>> from boresight import Function, Mechanics, Model, Output, Struct, variable
    >>> v = variable("v", "v", "m/s", "speed", -10.0, 10.0)
    >>> b = variable("b", "b", "m/s^2", "bias, measured - true", -1.0, 1.0)
    >>> dv = variable("dv", "dv", "m/s", "error of the speed", -1.0, 1.0)
    >>> db = variable("db", "db", "m/s^2", "error of the bias", -1.0, 1.0)
    >>> gain = variable("gain", "gain", "m/s", "velocity gained over the step, measured", -1.0, 1.0)
    >>> dt = variable("dt", "dt", "s", "length of the step", 1e-3, 0.1)
    >>> n = variable("n", "n", "m/s/sqrt(s)", "noise density of the accelerometer", 0.0, 1.0)
    >>> climb = Model(
    ...     name="climb", c_prefix="cl", title="a speed and a bias", frame="none", states=(dv, db),
    ...     structs=(Struct("nav", "estimates", (v, b)), Struct("imu", "one step", (gain, dt, n))),
    ...     noise=n.vector, dt=dt.scalar,
    ...     functions=(
    ...         Function("strapdown", "one step", (
    ...             Output("v", v.vector + gain.vector - b.vector * dt.scalar, "m/s", "speed"),)),
    ...         Function("feedback", "errors out", (
    ...             Output("v", v.vector - dv.vector, "m/s", "speed"),
    ...             Output("b", b.vector - db.vector, "m/s^2", "bias"))),
    ...     ),
    ...     mechanics=Mechanics(driven=((n, gain),)),
    ... )
    >>> completed(climb).F
    Matrix([
    [0, -1],
    [0,  0]])
    """
    if model.kind == "total-state" and any(v.norm for v in model.states):
        model = on_sphere(model)
    follows = model.kind == "error-state" and model.F is None and model.Phi is None
    fed = {s for f in model.functions if f.name == "feedback" for o in f.outputs for s in symbols_in(o.value)}
    states = {s for block in model.states for s in block.symbols}
    open_ = [
        m
        for m in model.measurements
        if m.at_zero or (fed and m.H is None and (m.h is None or not symbols_in(m.h) & states))
    ]
    if not follows and not open_:
        return model
    derivation = Derivation(model)
    measurements = tuple(derivation.measurement(m) if m in open_ else m for m in model.measurements)
    model_with = replace(model, measurements=measurements)
    if not follows:
        return model_with
    if model.exact:
        Phi, Q = derivation.step()
        return replace(model_with, Phi=Phi, Q=Q, noise=NONE, exact=False)
    F, G = derivation.rates()
    return replace(model_with, F=F, G=G)


# ---------------------------------------------------------------- a quaternion as a state


def on_sphere(model: Model) -> Model:
    """A total state with unit quaternions as an error state: of each three numbers, a turn in the axes it leads to.

    The state itself becomes the struct `nav`, carried by f (a step of Runge and Kutta) or by next, and each quaternion
    is of unit norm after each step and each correction.
    """
    errors, corrected = [], []
    for v in model.states:
        if not v.norm:
            names, low = (
                tuple(f"d_{s}" for s in v.symbols),
                tuple(lo - hi for lo, hi in zip(v.low, v.high, strict=True)),
            )
            error = Variable(f"d_{v.name}", letters(names), v.unit, f"error of {v.name}, computed - true", low,
                             tuple(-value for value in low), v.frame)  # fmt: skip
            true = v.vector - error.vector
        else:
            names = tuple(f"d_{v.name}_{axis}" for axis in "xyz")
            error = Variable(f"d_{v.name}", letters(names), "rad", f"error of {v.name}, C_hat = (I - [d_{v.name} x]) C",
                             (-TURNED,) * 3, (TURNED,) * 3, v.frame)  # fmt: skip
            turn = named(f"q_d_{v.name}", quaternion_from_rotation_vector(error.vector), "of its error", "w x y z")
            true = normalized(quaternion_product(turn, v.vector))
        errors.append(error)
        corrected.append(Output(v.name, true, v.unit, v.meaning, v.frame))
    after = stepped(model)
    parts = {v.name: Matrix([after[s] for s in v.symbols]) for v in model.states}
    carried = tuple(
        Output(v.name, normalized(parts[v.name]) if v.norm else parts[v.name], v.unit, v.meaning, v.frame)
        for v in model.states
        if v.norm or parts[v.name] != v.vector
    )
    feedback = Function("feedback", "the state with the errors taken out", tuple(corrected))
    strapdown = Function("strapdown", "the state a step later", carried)
    quaternions = ", ".join(v.name for v in model.states if v.norm)
    n, from_f = sum(error.size for error in errors), model.f is not None
    whole = replace(
        model,
        states=tuple(errors),
        structs=(Struct("nav", "the state, carried and corrected", model.states), *model.structs),
        functions=(*model.functions, strapdown, feedback),
        card=(*model.card, f"Of {quaternions} the error is three numbers, a turn; its norm is 1 after each step."),
        mechanics=Mechanics(),
        measurements=(),
        unheld=(*model.unheld, *(OF_F if from_f else OF_NEXT)),
        **NOT_TOTAL | ({} if from_f else {"Phi": Matrix.ones(n, n), "Q": Matrix.zeros(n, n)}),
    )
    symbols = [s for v in model.states for s in v.symbols]
    if not from_f:
        assert model.Q is not None
        derivation = Derivation(whole)
        places = [symbols.index(s) for s in derivation.y]
        Phi, Q = derivation.step(model.Q.extract(places, places))
        return replace(whole, Phi=Phi, Q=Q, measurements=model.measurements)
    along = {s: s + model.dt * rate for s, rate in zip(symbols, list(model.f or ()), strict=True)}
    straight = {v.name: Matrix([along[s] for s in v.symbols]) for v in model.states}
    line = replace(strapdown, outputs=tuple(replace(o, value=straight[o.name]) for o in carried))
    derivation = Derivation(replace(whole, functions=(feedback, line)))
    places = [symbols.index(s) for s in derivation.y]
    F, G = derivation.rates(model.G.extract(places, list(range(model.G.cols))))
    return replace(whole, F=F, G=G, measurements=model.measurements)


# What of such a model is nothing but what it states, in other letters.
OF_F = (
    ("strapdown", "it is a step of Runge and Kutta along f, which the model states"),
    ("G", "it is what G of the state does to the errors, and f says nothing of the noise"),
)
OF_NEXT = (
    ("strapdown", "it is next, which the model states"),
    ("Q", "it is Q of the state, of its errors"),
)
NOT_TOTAL: dict[str, Any] = {"f": None, "next": None, "G": NONE, "Q": None}


def letters(names: Iterable[str]) -> tuple[Symbol, ...]:
    return tuple(Symbol(name, real=True) for name in names)


def stepped(model: Model) -> dict[Symbol, Any]:
    """A total state one step later: next, or f by the fourth-order method of Runge and Kutta."""
    x = list(model.x)
    if model.f is None:
        return dict(zip(x, list(model.next or ()), strict=True))
    h: Any = model.dt
    moving = [i for i, rate in enumerate(model.f) if rate != 0]
    rates = [model.f]
    for k, share in enumerate((1, 1, 2), 2):
        there = [x[i] + share * h * rates[-1][i] / 2 for i in moving]
        stage = named(f"stage_{k}", Matrix(there), "a stage of the step")
        rates.append(substituted(model.f, dict(zip((x[i] for i in moving), stage, strict=True))))
    mean = (rates[0] + 2 * rates[1] + 2 * rates[2] + rates[3]) / 6
    return {s: s + h * rate for s, rate in zip(x, mean, strict=True)}


def derived(model: Model, exact: bool) -> Model:
    """The model with what follows from its strapdown and its feedback in the place of what it gives by hand: F, G and H
    at zero, or, where it is exact, Phi and Q of a step.

    Raises BoresightError where it has no strapdown or no feedback, and as `completed`.
    """
    if model.kind != "error-state" or not all(mechanics_of(model)):
        fail(model, "it has no strapdown and feedback from which something follows")
    fed = any(f.name == "feedback" for f in model.functions)
    measurements = tuple(
        replace(m, H=None, first_order=None, at_zero=True) if fed and m.z is not None else m for m in model.measurements
    )
    order = type(model).order if exact else model.order
    given: dict[str, Any] = {"F": None, "G": NONE, "Phi": None, "Q": None}
    return completed(replace(model, **given, measurements=measurements, exact=exact, order=order))
