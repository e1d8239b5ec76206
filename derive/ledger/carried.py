"""What a model makes, carried over by a paper's map, and held against the paper's at the witness, entry by entry."""

from collections.abc import Mapping
from functools import cache
from typing import Any

from sympy import ImmutableMatrix
from sympy import Matrix as Symbols

from boresight import BoresightError
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate
from boresight.derive.ledger.judge import EXACT, FULL, SEEDS, witness_point
from boresight.derive.ledger.map import Map, Match, Row
from boresight.derive.ledger.numbers import Matrix, digits, exact, eye, middle, zeros
from boresight.derive.ledger.paper import Paper
from boresight.derive.ledger.reader import read
from boresight.derive.model import Model


@cache
def held_beside(paper: Paper) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Of a paper of one's own the equations that its model makes, and in sentences what it makes otherwise."""
    held, apart = dict[str, None](), []
    with digits(DIGITS):
        for one in paper.maps:
            for match in one.matches:
                try:
                    for seed in SEEDS[:2]:
                        _check(paper, one, match, seed)
                except ApartError as error:
                    text = str(error).removeprefix(f"{paper.name} ").removesuffix("; correct the function or the map")
                    apart.append(f"{text}.")
                else:
                    held[f"({match.equation})"] = None
    return tuple(held), tuple(apart)


class ApartError(BoresightError):
    """What the model makes is not what the paper has."""


def check_maps(paper: Paper, number: str) -> None:
    """Raises BoresightError at the first entry in which the paper's matrix is not the model's, carried over."""
    with digits(DIGITS):
        for one in paper.maps:
            for match in one.matches:
                if match.equation == number:
                    for seed in SEEDS[:2]:
                        _check(paper, one, match, seed)


def _check(paper: Paper, one: Map, match: Match, seed: int) -> None:
    model, point = model_of(one), witness_point(paper, seed, FULL)
    where = f"{paper.name} ({match.equation}), {match.paper} and {match.ours} of {model.name}"
    theirs, (ours, rows, columns) = _value(paper, match.paper, point), _carried(paper, model, one, match, point)
    if (theirs.rows, theirs.cols) != (ours.rows, ours.cols):
        raise ApartError(f"{where}: {theirs.rows}x{theirs.cols} beside {ours.rows}x{ours.cols}")
    for i in range(ours.rows):
        for j in range(ours.cols):
            if (apart := abs(middle(theirs[i, j] - ours[i, j]))) > EXACT:
                name = f"{rows[i]}, {columns[j]}" if columns else rows[i]
                sizes = " and ".join(f"{float(middle(value[i, j])):.6g}" for value in (theirs, ours))
                raise ApartError(
                    f"{where} differ in [{name}] by {float(apart):.3g}, {sizes}; correct the function or the map"
                )


def _carried(paper: Paper, model: Model, one: Map, match: Match, point: Point) -> tuple[Matrix, list, list]:
    """What the model has, in the paper's states and rows, and our names of its rows and columns."""
    values = _inputs(paper, model, {**one.inputs, **match.inputs}, point)

    def at_witness(symbolic) -> Matrix:
        try:
            return evaluate(ImmutableMatrix(symbolic), values)
        except KeyError as error:
            what = f"{model.name} reads {error}, which its map does not give"
            raise BoresightError(
                f"{paper.name}: {what}" + "; write its value under [model.inputs]" * bool(paper.folder)
            ) from None

    def blocks(rows: tuple[Row, ...], sizes: Mapping[str, int], rates: bool = False) -> Matrix:
        parts = [(row.rate if rates else row.factor, sizes[row.ours]) for row in rows]
        result, at = zeros(sum(size for _, size in parts)), 0
        for latex, size in parts:
            factor = _value(paper, latex, point)
            block = factor if factor.rows > 1 else eye(size) * factor[0, 0]
            result[at : at + size, at : at + size] = block
            at += size
        return result

    function, _, output = match.ours.partition(".")
    if output:
        found_outputs = [o for f in model.functions if f.name == function for o in f.outputs if o.name == output]
        if not found_outputs:
            raise BoresightError(f"{paper.name}: {model.name} has no {match.ours}")
        value = at_witness(found_outputs[0].value)
        return value, [f"{output}[{i}]" for i in range(value.rows)], []
    at, names = 0, {}  # of each state, noise and measurement: where it stands, and what it is called
    for block in model.states:
        names[block.name] = list(zip(range(at, at + block.size), [s.name for s in block.symbols], strict=True))
        at += block.size
    for noise in one.noises:
        (item,) = (item for item in model.inputs if item.name == noise.ours)
        listed = list(model.noise)
        names[noise.ours] = [(listed.index(symbol), symbol.name) for symbol in item.symbols]
    found = {m.name: m for m in model.measurements}
    sizes = {name: len(places) for name, places in names.items()} | {name: len(m.rows) for name, m in found.items()}

    def order(rows: tuple[Row, ...]) -> tuple[list[int], list[str]]:
        if missing := {row.ours for row in rows} - set(names):
            raise BoresightError(f"{paper.name}: {model.name} has no {', '.join(sorted(missing))}")
        places = [place for row in rows for place in names[row.ours]]
        return [i for i, _ in places], [name for _, name in places]

    states, state_names = order(one.states)
    if len(states) != model.n:
        raise BoresightError(f"{paper.name}: {len(states)} of the {model.n} states of {model.name} are in its map")
    T = blocks(one.states, sizes)
    if match.ours == "F":
        F = at_witness(Symbols(model.F).extract(states, states))
        return T * F * T.inv() + blocks(one.states, sizes, rates=True) * T.inv(), state_names, state_names
    if match.ours == "G":
        noises, noise_names = order(one.noises)
        G = at_witness(model.G.extract(states, noises))
        return T * G * blocks(one.noises, sizes).inv(), state_names, noise_names
    rows = tuple(next(row for row in one.measurements if row.ours == name) for name in match.of)
    S, row_names = blocks(rows, sizes), [f"{name}.{row}" for name in match.of for row in found[name].rows]
    if match.ours == "z":
        return S * at_witness(Symbols.vstack(*(found[name].z for name in match.of))), row_names, []
    if any(found[name].H is None for name in match.of):
        whole = [s for block in model.states for s in block.symbols]
        columns = [_slope([found[name].h for name in match.of], values, whole, whole[i]) for i in states]
        return S * Matrix([list(row) for row in zip(*columns, strict=True)]) * T.inv(), row_names, state_names
    H = Symbols.vstack(*(found[name].H for name in match.of)).extract(list(range(len(row_names))), states)
    return S * at_witness(H) * T.inv(), row_names, state_names


def _slope(parts: list, values: Point, states: list, state) -> list:
    """How the exact h changes with one state where there is no error."""
    step = exact("1e-20")

    def at(size) -> Matrix:
        errors = {s.name: size if s == state else exact(0) for s in states}
        return evaluate(ImmutableMatrix(Symbols.vstack(*parts)), Point({**values.values, **errors}))

    return list((at(step) - at(-step)) / (2 * step))


def beside(paper: Paper) -> tuple[str, ...]:
    """The same as sentences."""
    held, apart = held_beside(paper)
    names = " and ".join(model_of(one).name for one in paper.maps)
    make = "makes" if len(paper.maps) == 1 else "make"
    return ((f"{names} {make} what {', '.join(held)} say{'s' * (len(held) == 1)}.",) if held else ()) + apart


def unmatched(one: Map) -> list[str]:
    """What the model makes and no equation is held against."""
    model, held = model_of(one), {(match.ours, of) for match in one.matches for of in match.of or ("",)}
    made = [("F", ""), ("G", "")] if model.F is not None else []
    made += [(kind, m.name) for m in model.measurements for kind in "Hz"]
    outputs = {match.ours.partition(".")[0] for match in one.matches if "." in match.ours}
    left = [f"{kind} of {of}" if of else kind for kind, of in made if (kind, of) not in held]
    return left + [f.name for f in model.functions if f.name not in outputs]


@cache
def model_of(one: Map) -> Model:
    return one.model()


def _inputs(paper: Paper, model: Model, given: Mapping[str, str], point: Point) -> Point:
    """The values of the symbols of the model's inputs and, for a function, its states."""
    known = {item.name: item for item in (*model.inputs, *model.states)}
    values: dict[str, Any] = {}
    for name, latex in given.items():
        if name not in known:
            raise BoresightError(f"{paper.name}: {model.name} has no input {name}")
        symbols, numbers = known[name].symbols, list(_value(paper, latex, point))
        if len(numbers) != len(symbols):
            raise BoresightError(f"{paper.name}: {latex} has {len(numbers)} components, {name} has {len(symbols)}")
        values |= {symbol.name: number for symbol, number in zip(symbols, numbers, strict=True)}
    return Point(values)


def _value(paper: Paper, latex: str, point: Point) -> Matrix:
    (relation,) = read((latex,), (*paper.quantities(), *paper.letters()))
    value = evaluate(relation.sides[0], point)
    return value if isinstance(value, Matrix) else Matrix([value])
