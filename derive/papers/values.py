"""Values of letters, written by the names of a scenario: `-theta_local`, `rate(v_n - v_hat)`, `K*H`, `P[0, 1]`.

Python's signs for arithmetic, and functions of numbers and matrices; * of two quaternions is Hamilton's product.
"""

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property, reduce
from typing import Any

from boresight import BoresightError
from boresight.derive.ledger import ellipsoid, numbers
from boresight.derive.ledger import witness as kinds
from boresight.derive.ledger.evaluate import assembled, multiplied
from boresight.derive.ledger.numbers import Matrix, digits, exact, eye, zeros
from boresight.derive.papers.scenarios.scenario import Scenario
from boresight.errors import did_you_mean


class ValueOfLetterError(BoresightError):
    """What is wrong with a value, and at which of its columns, counted from 0."""

    def __init__(self, text: str, column: int):
        super().__init__(text)
        self.column = column


def _matrix(*rows: Any) -> Matrix:
    return assembled([list(row) if isinstance(row, list) else [row] for row in rows])


def _diag(*entries: Any) -> Matrix:
    entries = tuple(entries[0]) if len(entries) == 1 and isinstance(entries[0], Matrix) else entries
    return Matrix([[entry if i == j else 0 for j in range(len(entries))] for i, entry in enumerate(entries)])


def _vee(M: Matrix) -> Matrix:
    return kinds.vector(M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]) / 2


def _conjugate(q: Matrix) -> Matrix:
    return kinds.vector(q[0], -q[1], -q[2], -q[3])


def _exp(A: Any) -> Any:
    return A.exp() if isinstance(A, Matrix) else numbers.exp(A)


def _root(x: Any) -> Any:
    if x < 0:
        raise ValueError("the root of a negative number")
    return numbers.sqrt(x)


FUNCTIONS: dict[str, Callable] = {
    "T": lambda M: M.T,
    "inv": lambda M: M.inv() if isinstance(M, Matrix) else 1 / M,
    "skew": kinds.skew,
    "vee": _vee,
    "exp": _exp,
    "cross": lambda a, b: kinds.skew(a) * b,
    "dot": lambda a, b: (a.T * b)[0],
    "norm": numbers.norm,
    "rotation": kinds.finite_rotation,
    "rotation_vector": kinds.rotation_vector,
    "quaternion": kinds.quaternion,
    "conjugate": _conjugate,
    "angles": kinds.angles,
    "stack": lambda *parts: assembled([[part] for part in parts]),
    "matrix": _matrix,
    "diag": _diag,
    "eye": lambda n: eye(int(n)),
    "zeros": lambda rows, columns=1: zeros(int(rows), int(columns)),
    "sqrt": _root,
    **{name: getattr(numbers, name) for name in ("sin", "cos", "tan", "asin", "atan", "atan2")},
}
TIMES = {
    "rate": "the rate of change",
    "old": "the value before the delay",
    "after": "a step later",
    "before": "earlier",
}


@dataclass(eq=False)
class Values:
    """Values at one time, of letters and of what the scenario has.

    scenario: by time (s).  letters: by name the value's expression.
    """

    scenario: Callable[[Any], Mapping[str, Any]]
    letters: Mapping[str, ast.expr]
    time: Any = 0
    known: dict[str, Any] = field(default_factory=dict)

    @cached_property
    def here(self) -> Mapping[str, Any]:
        return self.scenario(self.time)

    def at(self, time: Any) -> "Values":
        return Values(self.scenario, self.letters, time)

    def letter(self, name: str) -> Any:
        if name not in self.known:
            with digits(ellipsoid.WORKING):
                self.known[name] = self.of(self.letters[name], name)
        return self.known[name]

    def of(self, node: ast.expr, own: str) -> Any:
        """The value of an expression of the letter `own`, which is there the scenario's, if the scenario has it."""
        if isinstance(node, ast.Constant):
            return exact(str(node.value))
        if isinstance(node, ast.Name):
            if node.id in self.letters and node.id != own:
                return self.letter(node.id)
            return self.here[node.id]
        if isinstance(node, ast.UnaryOp):
            value = self.of(node.operand, own)
            return -value if isinstance(node.op, ast.USub) else value
        if isinstance(node, ast.BinOp):
            return self.combined(node, own)
        if isinstance(node, ast.Subscript):
            return self.part(node, own)
        if isinstance(node, ast.List):
            return [self.of(entry, own) for entry in node.elts]
        assert isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        if node.func.id in TIMES:
            return self.shifted(node.func.id, node.args[0], own)
        return FUNCTIONS[node.func.id](*(self.of(argument, own) for argument in node.args))

    def combined(self, node: ast.BinOp, own: str) -> Any:
        a, b = self.of(node.left, own), self.of(node.right, own)
        if isinstance(node.op, ast.Mult):
            return multiplied(a, b)
        if isinstance(node.op, ast.Div):
            return a / b
        if isinstance(node.op, ast.Pow):
            return reduce(multiplied, [a] * int(b))
        if isinstance(a, Matrix) != isinstance(b, Matrix) or (
            isinstance(a, Matrix) and (a.rows, a.cols) != (b.rows, b.cols)
        ):
            raise ValueError("terms of two shapes are added")
        return a + b if isinstance(node.op, ast.Add) else a - b

    def part(self, node: ast.Subscript, own: str) -> Any:
        def index(one: ast.expr) -> Any:
            if isinstance(one, ast.Slice):
                ends = (None if end is None else int(self.of(end, own)) for end in (one.lower, one.upper))
                return slice(*ends)
            return int(self.of(one, own))

        value, at = self.of(node.value, own), node.slice
        indices = tuple(map(index, at.elts)) if isinstance(at, ast.Tuple) else index(at)
        if isinstance(indices, slice):
            indices = (indices, 0)
        return value[indices]

    def shifted(self, how: str, node: ast.expr, own: str) -> Any:
        if how == "rate":
            return ellipsoid.rate(lambda t: self.at(self.time + t).of(node, own))
        size = self.here["delay" if how == "old" else "step"]
        return self.at(self.time + (size if how == "after" else -size)).of(node, own)


def parsed(text: str) -> ast.expr:
    """The expression of a value.  Raises ValueOfLetterError on what is none."""
    try:
        tree = ast.parse(text, mode="eval").body
    except SyntaxError as error:
        raise ValueOfLetterError(f"{text!r} cannot be read: {error.msg}", 0) from None
    for node in ast.walk(tree):
        column = getattr(node, "col_offset", 0)
        if isinstance(node, ast.Constant) and not isinstance(node.value, int | float):
            raise ValueOfLetterError(f"{node.value!r} is no number", column)
        if isinstance(node, ast.Call):
            name = node.func.id if isinstance(node.func, ast.Name) else ""
            if name not in FUNCTIONS and name not in TIMES:
                near = did_you_mean(name, (*FUNCTIONS, *TIMES))
                raise ValueOfLetterError(
                    f"no function is called {name!r}{near}; see docs/reference/witnesses.md", column
                )
            if name in TIMES and len(node.args) != 1:
                raise ValueOfLetterError(f"{name} takes one value", column)
        if not isinstance(node, PARTS):
            raise ValueOfLetterError("only names, numbers, functions, [parts] and + - * / ** make a value", column)
    return tree


PARTS = (
    *(ast.Constant, ast.Name, ast.Call, ast.BinOp, ast.UnaryOp, ast.USub, ast.UAdd, ast.Add, ast.Sub, ast.Mult),
    *(ast.Div, ast.Pow, ast.Subscript, ast.List, ast.Tuple, ast.Slice, ast.expr_context),
)


def check(name: str, letters: Mapping[str, ast.expr], scenario: Scenario) -> None:
    """Raises ValueOfLetterError at a name that is no value, a letter that is defined by itself, a rate of a rate, and a
    value at another time that the scenario has to first order in time only."""
    _check(letters[name], name, letters, scenario, (name,), "")


def _check(
    node: ast.AST, own: str, letters: Mapping[str, ast.expr], scenario: Scenario, path: tuple[str, ...], time: str
) -> None:
    def refuse(text: str) -> ValueOfLetterError:
        through = f" (through {' and '.join(path[1:])})" if len(path) > 1 else ""
        return ValueOfLetterError(text + through, getattr(node, "col_offset", 0) if len(path) == 1 else 0)

    if isinstance(node, ast.Name):
        if node.id in letters and node.id != own:
            if node.id in path:
                raise refuse(f"{node.id} is defined by itself")
            _check(letters[node.id], node.id, letters, scenario, (*path, node.id), time)
        elif node.id not in scenario.names:
            near = did_you_mean(node.id, {*scenario.names, *letters} - {own})
            raise refuse(f"{scenario.name} has no {node.id!r}{near}; docs/reference/witnesses.md lists its names")
        elif time not in ("", "rate") and node.id not in scenario.exact:
            raise refuse(f"{node.id} is exact at its own time only, and not in {time}()")
        return
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        name = node.func.id
        if name in TIMES and not scenario.moves:
            raise refuse(f"{scenario.name} has no time, so that there is no {name}()")
        if name in TIMES and time:
            raise refuse(f"{name}() within {time}() is not to be had; bind the letter to a value of {scenario.name}")
        for argument in node.args:
            _check(argument, own, letters, scenario, path, name if name in TIMES else time)
        return
    for child in ast.iter_child_nodes(node):
        _check(child, own, letters, scenario, path, time)
