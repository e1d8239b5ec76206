"""In which frames a letter stands by its value: `skew(omega_ib_b)` in b, `T(C_b2n)` from n to b, `angles(C_b2n)` in
none."""

import ast
import re

from boresight.derive.ledger.frames import NONE, SAME
from boresight.derive.ledger.numbers import Matrix
from boresight.derive.papers.scenarios.scenario import Scenario
from boresight.derive.papers.values import TIMES, Values

Pair = tuple[str, str]  # the frames of the rows and of the columns; "" of a number or a column
NUMBER, FREE = ("", ""), (NONE, NONE)
TURN = re.compile(r"[Cq]_(\w)2(\w)(?:_hat)?")
BY_NAME = re.compile(r"\w+_([ben])(?:_hat)?")
BY_MEANING = re.compile(r"\bin ([ben])\b(?:[:,]|$)")
IN_BODY = re.compile(r"(?:gyro|accel|omega_hat|f_hat)(?:_\w+)?")


def frame_of_value(name: str, at: Values, scenario: Scenario, shape: tuple[int, ...]) -> str:
    """As Paper.frames has it: `n`, `b to n`, NONE, SAME, or nothing where the value does not show it."""
    value = at.letters[name]
    if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id == "eye":
        return SAME
    found = Reader(at, scenario).of(value, name)
    if found is None or found == NUMBER:
        return ""
    rows, columns = found
    if rows == NONE or shape == (3,):
        return rows
    if columns == NONE:
        return NONE
    return f"{columns} to {rows}" if columns and rows != columns else rows


class Reader:
    """The frames of the parts of a value.  A pair is None where they are not known."""

    def __init__(self, at: Values, scenario: Scenario):
        self.at, self.scenario = at, scenario

    def of(self, node: ast.expr, own: str) -> Pair | None:
        if isinstance(node, ast.Constant):
            return NUMBER
        if isinstance(node, ast.Name):
            if node.id in self.at.letters and node.id != own:
                return self.of(self.at.letters[node.id], node.id)
            return self.named(node.id)
        if isinstance(node, ast.UnaryOp):
            return self.of(node.operand, own)
        if isinstance(node, ast.BinOp):
            return combined(node.op, self.of(node.left, own), self.of(node.right, own))
        if isinstance(node, ast.List):
            return NUMBER if all(self.of(entry, own) == NUMBER for entry in node.elts) else None
        if isinstance(node, ast.Subscript):
            return self.part(node, own)
        assert isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        return called(node.func.id, [self.of(argument, own) for argument in node.args])

    def named(self, name: str) -> Pair | None:
        """A name of the witness."""
        value = self.at.here[name]
        if not isinstance(value, Matrix):
            return NUMBER
        if turn := TURN.fullmatch(name):
            return turn[2], turn[1]
        if name in ("C_hat", "q_hat"):  # of `motion`
            return "n", "b"
        if IN_BODY.fullmatch(name):
            return "b", ""
        meaning = self.scenario.names[name.removesuffix("_noise")].meaning
        shown = BY_NAME.fullmatch(name) or BY_MEANING.search(meaning)
        return (shown[1], shown[1] if value.cols > 1 else "") if shown else None

    def part(self, node: ast.Subscript, own: str) -> Pair | None:
        """A number; of a turn's quaternion the vector part, which is its axis."""
        if not any(isinstance(one, ast.Slice) for one in ast.walk(node.slice)):
            return NUMBER
        of = self.of(node.value, own)
        return FREE if of and of[1] and of[0] != of[1] else None


def combined(sign: ast.operator, a: Pair | None, b: Pair | None) -> Pair | None:
    if a is None or b is None:
        return None
    if isinstance(sign, ast.Add | ast.Sub):
        return alike(a, b)
    if NUMBER in (a, b):
        return a if b == NUMBER else b
    return (a[0], b[1]) if isinstance(sign, ast.Mult) and (a[1] == b[0] or NONE in (a[1], b[0])) else None


def alike(a: Pair, b: Pair) -> Pair | None:
    """Of what is added."""
    if a == b or NONE in b:
        return a
    return b if NONE in a else None


def called(name: str, parts: list[Pair | None]) -> Pair | None:
    if name in ("eye", "zeros", "angles"):
        return FREE
    if name in ("stack", "matrix", "diag"):
        if name == "stack" and len(parts) == 2 and parts[0] == NUMBER and parts[1] and not parts[1][1]:
            return parts[1][0], parts[1][0]  # a vector as a quaternion
        return FREE if all(part == NUMBER for part in parts) else None
    if name in ("dot", "norm", "sin", "cos", "tan", "asin", "atan", "atan2", "sqrt"):
        return NUMBER
    one = parts[0]
    if one is None or name in TIMES or one == NUMBER:
        return one
    rows, columns = one
    if name in ("T", "inv", "conjugate"):
        return (columns, rows) if columns else None
    if name == "cross":
        return alike(one, parts[1]) if parts[1] else None
    if name in ("skew", "rotation"):
        return rows, rows
    if name in ("vee", "rotation_vector"):  # the axis of a turn has the same components in both of its frames
        return (rows, "") if rows == columns else FREE
    return one if name == "quaternion" or rows == columns else None  # or exp
