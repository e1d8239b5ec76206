"""Forty one-line faults, drawn by a seed over all rooms: what the tests see of them shows whether a law was given up.

    python tests/faults draw         draw them anew from the tree, into faults.json
    python tests/faults list
    python tests/faults apply N      put fault N into the tree; git checkout takes it out
    python tests/faults run N ...    each in turn in a copy; which were seen, by which test, and processor seconds

A fault names its line by its text and the line above, so that it is found where the file has moved, and under "tests"
those that see it.  They alone are run, for all forty 132 processor seconds; with --quick, what `make quick` runs.
What no test can see says why under "same", and is passed over.
"""

import argparse
import ast
import json
import os
import random
import re
import resource
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SEED = 28
QUICK = ".venv/bin/python tests/quick.py"  # as `make quick` runs it
PYTEST = ".venv/bin/python -m pytest -q -x -p no:cacheprovider"
ROOMS = {  # files of each room, and how many faults are drawn in it
    "flight C": (("generated/*/src/*.c", "generated/*/include/*.h"), 7),
    "derive": (("derive/**/*.py",), 7),
    "codegen": (("codegen/**/*.py", "codegen/**/*.j2"), 7),
    "runtime": (("runtime/*.py", "runtime/filter/*.py", "runtime/transfer/*.py", "runtime/simulation/*.py"), 7),
    "recording": (("runtime/recording/*.py",), 6),
    "studies": (("studies/**/*.py",), 6),
}
SWAPPED = {
    **{ast.Add: "-", ast.Sub: "+", ast.Mult: "/", ast.Div: "*", ast.Mod: "//", ast.FloorDiv: "%", ast.Pow: "*"},
    **{ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "=="},
    **{ast.In: "not in", ast.NotIn: "in", ast.Is: "is not", ast.IsNot: "is", ast.And: "or", ast.Or: "and"},
}
SIGN = r"\*\*|//|<=|>=|==|!=|not in|is not|\bin\b|\bis\b|\band\b|\bor\b|[-+*/%<>]"
IN_C = {" + ": " - ", " - ": " + ", " * ": " / ", " < ": " <= ", " > ": " >= ", " == ": " != ", " && ": " || "}


def python_faults(text):
    """(line number from 0, the line spoilt) for each place of the syntax tree that can be spoilt in one line."""
    lines = text.splitlines()

    def between(left, right, sign):
        """The sign between two operands that stand on one line."""
        if left.end_lineno != right.lineno:
            return
        row = left.end_lineno - 1
        head, tail = lines[row].encode()[: left.end_col_offset], lines[row].encode()[right.col_offset :]
        middle = lines[row].encode()[left.end_col_offset : right.col_offset].decode()
        spoilt = re.sub(SIGN, sign, middle, count=1)
        if spoilt != middle:
            yield row, head.decode() + spoilt + tail.decode()

    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.BinOp) and type(node.op) in SWAPPED:
            yield from between(node.left, node.right, SWAPPED[type(node.op)])
        elif isinstance(node, ast.Compare):
            yield from between(node.left, node.comparators[0], SWAPPED[type(node.ops[0])])
        elif isinstance(node, ast.BoolOp):
            yield from between(node.values[0], node.values[1], SWAPPED[type(node.op)])
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
            row, start = node.lineno - 1, node.col_offset
            line = lines[row].encode()
            width = 4 if isinstance(node.op, ast.Not) else 1
            yield row, (line[:start] + line[start + width :]).decode()
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float, bool):
            row, start, end = node.lineno - 1, node.col_offset, node.end_col_offset
            line = lines[row].encode()
            new = repr(not node.value if isinstance(node.value, bool) else node.value + 1)
            yield row, (line[:start] + new.encode() + line[end:]).decode()


def c_faults(text):
    """The same of C and of its templates: an operation or a number of a line that is no comment."""
    for row, line in enumerate(text.splitlines()):
        if re.match(r"\s*(/?\*|//|#|\{#)", line):
            continue
        for old, new in IN_C.items():
            for found in re.finditer(re.escape(old), line):
                yield row, line[: found.start()] + new + line[found.end() :]
        for found in re.finditer(r"(?<![\w.])\d+(?![\w.])", line):
            yield row, line[: found.start()] + str(int(found[0]) + 1) + line[found.end() :]


def draw():
    rng, faults = random.Random(SEED), []
    for room, (patterns, count) in ROOMS.items():
        places = []
        for path in sorted({path for pattern in patterns for path in ROOT.glob(pattern)}):
            text = path.read_text()
            found = python_faults(text) if path.suffix == ".py" else c_faults(text)
            places += [(path, text, row, spoilt) for row, spoilt in found]
        for path, text, row, spoilt in rng.sample(places, count):
            lines = text.splitlines()
            above = lines[row - 1] if row else ""
            where = path.relative_to(ROOT).as_posix()
            faults.append({"room": room, "file": where, "above": above, "line": lines[row], "fault": spoilt})
    (HERE / "faults.json").write_text(json.dumps(faults, indent=1, ensure_ascii=False) + "\n")


def faults():
    return json.loads((HERE / "faults.json").read_text())


def place(fault, root):
    """The file of the tree at `root`, and the row, from 0, at which the line stands now."""
    patterns, _ = ROOMS[fault["room"]]
    named = root / fault["file"]
    for path in [named] * named.is_file() + sorted({p for pattern in patterns for p in root.glob(pattern)} - {named}):
        lines = path.read_text().split("\n")
        rows = [i for i, line in enumerate(lines) if line == fault["line"] and lines[max(i - 1, 0)] == fault["above"]]
        rows = rows or [0][: fault["above"] == "" and lines[0] == fault["line"]]
        if rows:
            return path, rows[0]
    raise SystemExit(f"faults: the line is not found any more: {fault['file']}: {fault['line'].strip()}")


def apply(fault, root):
    """Spoil the line in the tree at `root`; the file's path there."""
    path, row = place(fault, root)
    lines = path.read_text().split("\n")
    lines[row] = fault["fault"]
    path.write_text("\n".join(lines))
    return path.relative_to(root)


def copy(out):
    """A clone of the last commit, flown by this checkout's environment."""
    subprocess.run(["git", "clone", "-q", "--shared", ROOT, out], check=True)
    (out / ".venv").symlink_to(ROOT / ".venv")
    with (out / ".git" / "info" / "exclude").open("a") as excluded:
        excluded.write(".venv\n")


def spent():
    """Processor seconds of the children that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(numbers, by):
    """by: a shell's line that sees a fault by its status; None: the tests that stand with the fault."""
    seen_ones, begun = [], spent()
    with tempfile.TemporaryDirectory() as folder:
        copy(Path(folder))
        env = {**os.environ, "PYTHONPATH": folder}  # before the installation, which is of this checkout
        for number in numbers:
            fault, before = faults()[number], spent()
            if by is None and "same" in fault:
                print(f"{number:3} nothing to see {fault['file']}: {fault['same']}", flush=True)
                continue
            where = apply(fault, Path(folder))
            line = by or f"{PYTEST} {shlex.join(fault['tests'])}"
            done = subprocess.run(line, shell=True, cwd=folder, env=env, capture_output=True, text=True, check=False)
            subprocess.run(["git", "checkout", "-q", "."], cwd=folder, check=True)
            # 1: a test failed; pytest ends with another status where it found none
            seen = done.returncode == 1 if by is None else done.returncode != 0
            seen_ones += [number] * seen
            red = next((row for row in done.stdout.splitlines() if re.match(r"FAILED|ERROR|error", row)), "")
            by_what = red.partition(" - ")[0].partition(" ")[2]
            print(f"{number:3} {'seen' if seen else 'NOT SEEN'} {spent() - before:.1f} s {where} {by_what}", flush=True)
    same = sum("same" in faults()[number] for number in numbers) if by is None else 0
    rest = f", {same} change nothing that a test could see" if same else ""
    print(f"{len(seen_ones)} of {len(numbers)} are seen{rest}; {spent() - begun:.0f} processor seconds")
    return len(seen_ones) + same < len(numbers)


def show(number, fault):
    print(f"{number:3} {fault['room']}: {fault['file']}")
    print(f"    - {fault['line'].strip()}\n    + {fault['fault'].strip()}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("do", choices=("draw", "list", "apply", "run"))
    parser.add_argument("numbers", type=int, nargs="*")
    parser.add_argument("--by", help="a shell command, whose status says that it saw the fault")
    parser.add_argument("--quick", action="store_const", dest="by", const=QUICK, help="by what `make quick` runs")
    options = parser.parse_args()
    if options.do == "draw":
        draw()
    elif options.do == "list":
        for number, fault in enumerate(faults()):
            show(number, fault)
    elif options.do == "apply":
        for number in options.numbers:
            print(apply(faults()[number], ROOT))
    else:
        return run(options.numbers or range(len(faults())), options.by)
    return 0


if __name__ == "__main__":
    sys.exit(main())
