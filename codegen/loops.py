"""How often each loop of a folder's C goes round at most, as far as its text says it by constants alone."""

import ast
import operator
import re
from bisect import bisect
from collections.abc import Callable
from dataclasses import dataclass

from boresight.codegen.requirements import FUNCTION, blank, end_of_statement

LOOP = re.compile(r"^ +(?:\} )?(for|while) \(", re.MULTILINE)
FIRST = re.compile(r"(?:.* )?\*?(\w+) = (.+)")
LIMIT = re.compile(r"\(*(\w+) (<|<=|>|>=) ([^&|]+)")
STEP = re.compile(r"(\+\+|--)(\w+)|(\w+) (\+|-)= (.+)")
DEFINED = re.compile(r"^ *(?:#define )?(\w+)(?: =)? (\(.*\)|[\w]+),? *$", re.MULTILINE)  # a macro, or one of an enum
CAST = re.compile(r"\((?:int|unsigned int|uint32_t|size_t)\)|(?<=\d)U\b")
OPERATIONS: dict[type, Callable[[int, int], int]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.floordiv,
    ast.Mod: operator.mod,
}


@dataclass(frozen=True)
class Loop:
    """most: how often it goes round at most; None where it depends on what it is given.  words: its condition."""

    path: str
    line: int
    function: str
    words: str
    most: int | None

    def __str__(self) -> str:
        return f"{self.function} {self.path}:{self.line}: {self.words}"


def loops(files: dict[str, str]) -> list[Loop]:
    """All of src/ and include/, in order; files: path below the folder -> text."""
    found = []
    ours = {path: blank(text) for path, text in sorted(files.items()) if path.startswith(("src/", "include/"))}
    shared = "\n".join(text for path, text in ours.items() if path.endswith(".h"))
    for path, text in ours.items():
        known = dict(DEFINED.findall(shared)) | dict(DEFINED.findall(text))
        lines, breaks = text.split("\n"), [one.start() for one in re.finditer("\n", text)]
        functions = {bisect(breaks, one.start()): one[1] for one in FUNCTION.finditer(text)}
        ends = {begin: end_of_statement(lines, begin) for begin in functions}
        most: dict[str, dict[str, int]] = {}  # by function, of the variables of its loops the largest value
        for one in LOOP.finditer(text):
            line = bisect(breaks, one.start())
            inside = [name for begin, name in functions.items() if begin <= line <= ends[begin]]
            function = inside[-1] if inside else ""
            words = " ".join(bracket(text, one.end() - 1).split())
            times = bound(one[1], words, known, most.setdefault(function, {}))
            found.append(Loop(path, line + 1, function, f"{one[1]} ({words})", times))
    return found


def bracket(text: str, begin: int) -> str:
    """What stands between the bracket that opens here and the one that closes it."""
    depth = 0
    for i in range(begin, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if not depth:
            return text[begin + 1 : i]
    return ""


def bound(kind: str, words: str, known: dict[str, str], most: dict[str, int]) -> int | None:
    """How often it goes round at most; of its variable the largest value is noted."""
    parts = [part.strip() for part in words.split(";")]
    if kind == "while" or len(parts) != 3 or "||" in parts[1]:
        return None
    first, limit, step = FIRST.fullmatch(parts[0]), LIMIT.match(parts[1]), STEP.fullmatch(parts[2])
    if not (first and limit and step) or limit[1] != first[1]:
        return None
    ends = [value(text, known, most) for text in (first[2], limit[3], step[5] or "1")]
    up = limit[2].startswith("<")
    most.pop(first[1], None)
    if ends[2] is None or ends[2] < 1 or up != ("+" in step[0]):
        return None
    begin, end = (ends[0], ends[1]) if up else (ends[1], ends[0])
    if up and begin is None and re.fullmatch(r"\w+|\w+ \+ \d+", first[2]):
        begin = 0  # an index, which is never negative
    if begin is None or end is None:
        return None
    most[first[1]] = end if limit[2] in ("<=", ">", ">=") else end - 1
    return max(0, -(-(end - begin + ("=" in limit[2])) // ends[2]))


def value(text: str, known: dict[str, str], most: dict[str, int]) -> int | None:
    """Of an expression of constants, or of variables whose largest value is known."""
    plain = CAST.sub("", text.strip())
    while plain.count("(") > plain.count(")") and plain.startswith("("):
        plain = plain[1:]
    while plain.count(")") > plain.count("(") and plain.endswith(")"):
        plain = plain[:-1]
    try:
        return evaluated(ast.parse(plain, mode="eval").body, known, most)
    except SyntaxError:
        return None


def evaluated(node: ast.expr, known: dict[str, str], most: dict[str, int]) -> int | None:
    if isinstance(node, ast.Constant) and isinstance(node.value, int):
        return node.value
    if isinstance(node, ast.Name):
        if node.id in most:
            return most[node.id]
        return value(known[node.id], {k: v for k, v in known.items() if k != node.id}, {}) if node.id in known else None
    if isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
        left, right = (evaluated(side, known, most) for side in (node.left, node.right))
        if left is None or right is None or (isinstance(node.op, ast.Div | ast.Mod) and not right):
            return None
        return OPERATIONS[type(node.op)](left, right)
    return None
