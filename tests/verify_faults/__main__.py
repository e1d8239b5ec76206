"""Sixty faults of models, twelve kinds of five models, drawn by a seed: what `boresight verify` says of each.

    python tests/verify_faults draw          draw them anew from the tree, into faults.json
    python tests/verify_faults list
    python tests/verify_faults run N ...     each in turn in a copy: generated, verified; what was said
    python tests/verify_faults right         the same of ten right models, of which none may fail

A fault is one edit: of the syntax tree of the files in which the formulas of a model stand, or of its expressions
(spoil.py).  It is drawn without a look at what verify does; one that Python cannot run, or that leaves the model as it
was, is drawn again.  Refused: by `generate`, with a reason.  Caught: status 1.  Not held: status 3.  Listed or stated:
status 0, with what is listed beside it.
"""

import argparse
import ast
import json
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE.parent))
SEED, TRIES = 60, 30
MODELS = {  # by what it is verified, and the files in which its formulas stand
    "velocity-attitude": ("derive/models/velocity_attitude.py", "derive/papers/kang_2025/results.py"),
    "euler-matching": ("derive/models/euler_matching.py", "derive/papers/song_lee_2001/results.py"),
    "examples/autopilot.py:AUTOPILOT": ("examples/autopilot.py",),
    "examples/gnss_ins_21.py:GNSS_INS_21": ("examples/gnss_ins_21.py",),
    "examples/ahrs.py:SIX": ("examples/ahrs.py",),
}
OTHERS = {  # drawn from with --model
    "azimuth-hold": ("derive/models/azimuth_hold.py", "derive/papers/kim_2018/results.py"),
    "velocity-dcm": ("derive/models/velocity_dcm.py", "derive/papers/kim_2018/results.py"),
    "phi-error": ("derive/models/phi_error.py",),
    "psi-error": ("derive/models/psi_error.py",),
    "strapdown": ("derive/models/strapdown.py",),
    "examples/ahrs.py:SEVEN": ("examples/ahrs.py",),
    "examples/pendulum.py:PENDULUM": ("examples/pendulum.py",),
    "examples/radar.py:RADAR": ("examples/radar.py",),
    "examples/vertical.py:VERTICAL": ("examples/vertical.py",),
    "examples/gnss_ins.py:GNSS_INS": ("examples/gnss_ins.py",),
}
RIGHT = (
    "azimuth-hold",
    "phi-error",
    "psi-error",
    "velocity-attitude-lever",
    "velocity-dcm",
    "examples/ahrs.py:SEVEN",
    "examples/gnss_ins.py:GNSS_INS",
    "examples/pendulum.py:PENDULUM",
    "examples/radar.py:RADAR",
    "examples/vertical.py:VERTICAL",
)
DECLARED = {"variable", "Variable", "constant", "vector", "body", "level", "quaternion", "noise_density", "Struct"}
UNITS = ("1", "m", "m/s", "m/s^2", "rad", "rad/s", "s", "T", "1/s", "rad/sqrt(s)", "m/s/sqrt(s)")
TURN = r"(named_)?C_\w+|\w*C|skew|dcm_from_\w+|rotation_[xyz]"
TREES = ("stale input", "H row", "undefined point", "noise")


# ---------------------------------------------------------------- faults of the syntax tree


def name_of(node):
    """The last word of what is named or called."""
    node = node.func if isinstance(node, ast.Call) else node
    return node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""


def nodes(tree, declared):
    """Those within declarations of variables, or those without; nothing of an index or a note of a type."""
    stack = [(tree, False)]
    while stack:
        node, within = stack.pop()
        within = within or (isinstance(node, ast.Call) and name_of(node) in DECLARED)
        if within == declared:
            yield node
        for name, child in ast.iter_fields(node):
            if name in ("slice", "annotation", "returns", "ctx", "op", "keywords" if declared else ""):
                continue
            stack += [(c, within) for c in (child if isinstance(child, list) else [child]) if isinstance(c, ast.AST)]


def turns(node):
    """Whether it is a rotation or a skew matrix, by its name, perhaps transposed."""
    node = node.value if isinstance(node, ast.Attribute) and node.attr == "T" else node
    return bool(re.fullmatch(TURN, name_of(node)))


def is_read(node):
    return not isinstance(getattr(node, "ctx", None), ast.Store)


def is_number(node):
    """A number, or a name of one in capitals."""
    named = isinstance(node, ast.Name) and node.id.isupper()
    return named or (isinstance(node, ast.Constant) and type(node.value) in (int, float))


def spoilt(kind, tree, source):
    """(node, what to write in its place) for each place of the tree where a fault of this kind can be."""

    def text(node):
        return f"({ast.get_source_segment(source, node)})"

    plus = {ast.Add: "-", ast.Sub: "+"}
    for node in nodes(tree, declared=kind in ("box", "unit")):
        pair = isinstance(node, ast.BinOp)
        sums, product = pair and type(node.op) in plus, pair and isinstance(node.op, ast.Mult)
        if kind == "sign":
            if sums:
                yield node, f"({text(node.left)} {plus[type(node.op)]} {text(node.right)})"
            elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
                yield node, text(node.operand)
        elif kind == "factor" and pair:
            for part in (node.left, node.right):
                yield part, f"(2 * {text(part)})"
        elif kind == "transposition":
            if isinstance(node, ast.Attribute) and node.attr == "T":
                yield node, text(node.value)
            elif (
                isinstance(node, ast.Name | ast.Call)
                and turns(node)
                and not isinstance(node, ast.Name) | (isinstance(getattr(node, "ctx", None), ast.Store))
            ) or (isinstance(node, ast.Name) and turns(node) and isinstance(node.ctx, ast.Load)):
                yield node, f"{text(node)}.T"
        elif kind == "frame":
            if product and turns(node.left) and not turns(node.right):
                yield node, text(node.right)
            elif isinstance(node, ast.Attribute) and node.attr == "vector":
                yield node, f"{text(node)}.permute([1, 0, 2])"
        elif kind == "order of rotation":
            if name_of(node) == "quaternion_product" and isinstance(node, ast.Call):
                yield node, f"quaternion_product({text(node.args[1])}, {text(node.args[0])})"
            elif product and turns(node.left) and turns(node.right):
                yield node, f"({text(node.right)} * {text(node.left)})"
        elif kind == "missing term" and sums:
            yield node, text(node.left)
            yield node, text(node.right) if isinstance(node.op, ast.Add) else f"(-{text(node.right)})"
        elif kind == "unit" and isinstance(node, ast.Constant) and node.value in UNITS:
            for unit in UNITS:
                if unit != node.value:
                    yield node, repr(unit)
        elif kind == "box" and is_number(node):
            for factor in ("10", "0.1", "-1"):
                yield node, f"({factor} * {text(node)})"
    if kind == "unit":  # what lacks a step, and degrees
        for node in nodes(tree, declared=False):
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
                for one, other in ((node.left, node.right), (node.right, node.left)):
                    if ast.unparse(one).lower() in ("dt", "step", "dt.scalar"):
                        yield node, text(other)
            if isinstance(node, ast.Attribute) and node.attr == "vector":
                yield node, f"({text(node)} / 57.29577951308232)"


def edited(source, node, new):
    """(old lines, new lines) of the one edit."""
    lines = source.encode().splitlines(keepends=True)
    first, last = node.lineno - 1, node.end_lineno
    old = b"".join(lines[first:last])
    head = lines[first][: node.col_offset]
    tail = lines[last - 1][node.end_col_offset :]
    return old.decode(), (head + new.encode() + tail).decode()


def places(model, files, kind, rng):
    """Faults of this kind in an order drawn by rng, each with the file and the lines before and after."""
    if kind in TREES:
        file, target = files[0], model.partition(":")[2]
        wrapped = target or model.replace("-", "_")
        for _ in range(TRIES):
            call = f"spoil.{kind.replace(' ', '_')}({{}}, {rng.randrange(10**6)})"
            if target:
                new = f"\nfrom verify_faults import spoil\n\n{wrapped} = {call.format(wrapped)}\n"
            else:
                new = (
                    f"\n\nfrom verify_faults import spoil\n\nright = {wrapped}\n\n\n"
                    f"def {wrapped}():\n    return {call.format('right()')}\n"
                )
            yield {"file": file, "append": new}
        return
    found = []
    for file in files + (("derive/models/variables.py",) if kind in ("box", "unit") and ":" not in model else ()):
        source = (ROOT / file).read_text()
        for node, new in spoilt(kind, ast.parse(source), source):
            old, changed = edited(source, node, new)
            found.append({"file": file, "row": node.lineno, "old": old, "new": changed})
    rng.shuffle(found)
    yield from found


KINDS = (
    "sign", "factor", "transposition", "frame", "order of rotation", "missing term", "unit", "stale input", "box",
    "H row", "undefined point", "noise",
)  # fmt: skip


def draw(seed, models, kinds):
    """One fault of each kind of each model."""
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        tree = copy(Path(folder) / "tree")
        for model, files in models.items():
            right = looked_at(tree, model)
            for kind in kinds:
                for place in places(model, files, kind, random.Random(f"{seed} {kind} {model}")):
                    fault = {"model": model, "kind": kind} | place
                    apply(fault, tree)
                    seen = looked_at(tree, model)
                    restore(fault, tree)
                    if seen not in (right, "error"):
                        faults.append(fault)
                        break
                else:
                    print(f"no place for {kind} in {model}")
    return faults


def looked_at(tree, model):
    """A hash of all that the model says; "error" if Python stumbles, "refused" if the model is refused in words."""
    done = python(tree, "-m", "verify_faults.spoil", model)
    return done.stdout.strip() if done.returncode == 0 else "error"


# ---------------------------------------------------------------- the copy in which they are tried


def copy(out):
    """A clone of the last commit, flown by this checkout's environment."""
    subprocess.run(["git", "clone", "-q", "--shared", ROOT, out], check=True)
    changed = subprocess.run(["git", "diff", "HEAD", "--binary"], cwd=ROOT, check=True, capture_output=True).stdout
    if changed:
        subprocess.run(["git", "apply"], cwd=out, input=changed, check=True)
    return out


def python(tree, *words):
    # before the installation, which is of this checkout; what SymPy prints of a sum hangs on the seed of hashes
    env = {**os.environ, "PYTHONPATH": f"{tree}:{HERE.parent}", "PYTHONHASHSEED": "0"}
    return subprocess.run(
        [ROOT / ".venv/bin/python", *words], cwd=tree, env=env, capture_output=True, text=True, check=False
    )


def apply(fault, tree):
    path = tree / fault["file"]
    text = path.read_text()
    if "append" in fault:
        path.write_text(text + fault["append"])
        return
    # where it stands several times, the nearest to the row at which it was drawn
    starts = [found.start() for found in re.finditer(re.escape(fault["old"]), text)]
    if not starts:
        raise SystemExit(f"verify_faults: the line is not found any more: {fault['file']}: {fault['old'].strip()}")
    start = min(starts, key=lambda at: abs(text.count("\n", 0, at) + 1 - fault["row"]))
    path.write_text(text[:start] + fault["new"] + text[start + len(fault["old"]) :])


def restore(fault, tree):
    path = tree / fault["file"]
    path.write_text((ROOT / fault["file"]).read_text())


def verified(tree, model, whole):
    """(what became of it, why): the laws of its expressions; whole: generated and verified, with its C."""
    if not whole:
        done = python(tree, "-m", "verify_faults.laws", model)
        if done.returncode:
            return "ERROR", done.stderr.strip().splitlines()[-1]
        document = json.loads(done.stdout)
        return ("refused", document["refused"]) if "refused" in document else judged(document)
    with tempfile.TemporaryDirectory() as out:
        made = python(tree, "-m", "boresight.cli", "generate", model, "--out", f"{out}/c")
        if made.returncode:
            return "refused", " ".join(made.stderr.split())
        done = python(tree, "-m", "boresight.cli", "verify", model, "--generated", f"{out}/c", "--json")
    return judged(json.loads(done.stdout)) if done.returncode in (0, 1, 3) else ("ERROR", " ".join(done.stderr.split()))


def judged(rows):
    """Caught: something is wrong.  Not held: nothing is, but not all is held.  Else what is listed and stated."""
    wrong = [f"{row['unit']}: {row['reason']}" for row in rows if row["ok"] is False]
    if wrong:
        return "caught", wrong[0]
    unheld = [f"{row['unit']}: {row['reason']}" for row in rows if row["ok"] is None]
    if unheld:
        return "not held", "; ".join(unheld)
    listed = [row["unit"] for row in rows if row.get("unheld")]
    stated = [row["reason"] for row in rows if row.get("stated") and row["unit"] == "equations"]
    return "PASSES", f"listed: {', '.join(listed) or '-'}; stated: {', '.join(stated) or '-'}"


def run(faults, numbers, whole):
    with tempfile.TemporaryDirectory() as folder:
        tree = copy(Path(folder) / "tree")
        for number in numbers or range(len(faults)):
            fault = faults[number]
            apply(fault, tree)
            became, why = verified(tree, fault["model"], whole)
            restore(fault, tree)
            print(f"{number:3} {became:8} {fault['kind']}, {fault['model']} | {why[:300]}", flush=True)


def right(whole):
    with tempfile.TemporaryDirectory() as folder:
        tree = copy(Path(folder) / "tree")
        for model in RIGHT:
            became, why = verified(tree, model, whole)
            print(f"{became:8} {model} | {why[:300]}", flush=True)


def show(number, fault):
    print(f"{number:3} {fault['kind']}, {fault['model']}: {fault['file']}:{fault.get('row', '')}")
    for sign, lines in (("-", fault.get("old", "")), ("+", fault.get("new", fault.get("append", "")))):
        for line in lines.splitlines():
            print(f"    {sign} {line.strip()}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("do", choices=("draw", "list", "run", "right"))
    parser.add_argument("numbers", type=int, nargs="*")
    parser.add_argument("--whole", action="store_true", help="with the C, as the commands generate and verify do it")
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--model", action="append", help="of these models instead")
    parser.add_argument("--kind", action="append", choices=KINDS, help="of these kinds alone")
    parser.add_argument("--file", type=Path, default=HERE / "faults.json")
    options = parser.parse_args()
    if options.do == "draw":
        models = {name: (MODELS | OTHERS)[name] for name in options.model or MODELS}
        drawn = draw(options.seed, models, options.kind or KINDS)
        options.file.write_text(json.dumps(drawn, indent=1, ensure_ascii=False) + "\n")
        return
    if options.do == "right":
        right(options.whole)
        return
    faults = json.loads(options.file.read_text())
    if options.do == "list":
        for number, fault in enumerate(faults):
            show(number, fault)
    else:
        run(faults, options.numbers, options.whole)


if __name__ == "__main__":
    sys.exit(main())
