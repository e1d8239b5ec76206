"""From units to the text of C files.  Text only: what is written where is decided in generate."""

import hashlib
import json
import math
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
import mpmath as mp
import numpy as np
from jinja2 import Environment, FileSystemLoader, StrictUndefined

from boresight import BoresightError
from boresight.codegen.kernels.covariance import covariance_view, filter_view, has_filter, nonzeros, test_view
from boresight.codegen.kernels.covariance_vectors import vectors_view
from boresight.codegen.samples import answered, edges, ends, generator, norm_ends
from boresight.codegen.tape import Tape, evaluate
from boresight.codegen.units import DIGITS, Result, Unit, state_variable
from boresight.derive.model import Model, Variable

LIBM_ULPS = 4  # what the self-test grants the sine, cosine and arctangent of a target's library
VECTORS, CORNERS = 64, 24
BEYOND = 5e-4  # how far outside its box the self-test puts a number, as a part of the bound
DIFFERENTIATED = 1e-45  # what is left of 80 digits where the reference was differentiated numerically and is zero
MATRICES = {"F", "Phi", "Q", "H"}  # two axes in NumPy, even for a model with one state


@cache
def templates() -> Environment:
    environment = Environment(
        loader=FileSystemLoader([Path(__file__).parent / "templates", Path(__file__).parent / "kernels"]),
        undefined=StrictUndefined,
        keep_trailing_newline=True,
    )
    environment.filters["capitalize_first"] = lambda text: text[:1].upper() + text[1:]
    return environment


def snake(name: str) -> str:
    return name.replace("-", "_")


def file_stem(model: Model, unit: str) -> str:
    """H and h are two functions; their files must not be one where a file system ignores case."""
    return f"{model.c_prefix}_{unit}x" if unit.endswith("_h") else f"{model.c_prefix}_{unit}"


def number(value: float) -> str:
    """A literal that reads back as the same double."""
    if not math.isfinite(value):
        raise BoresightError(f"the constant {value} cannot be printed; a printed unit holds finite numbers only")
    return f"BS_REAL({float(value)!r})"


# ---------------------------------------------------------------- kernels


BINARY = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
CALLS = {"sqrt": "BS_SQRT", "sin": "BS_SIN", "cos": "BS_COS", "atan2": "BS_ATAN2", "fabs": "BS_FABS"}
COMPARE = {"lt": "<", "le": "<=", "eq": "==", "ne": "!="}


def statements(unit: Unit, columns: tuple[str, ...]) -> list[str]:
    """One statement an operation, in the order of the tape; then the outputs, each with the element that it is."""
    tape = unit.tape
    names = temporaries(unit, tape)
    lines = []
    for position, step in enumerate(tape.steps):
        a = [names[i] for i in step.args]
        if step.op in ("const", "input"):
            continue
        if step.op in BINARY:
            text = f"{a[0]} {BINARY[step.op]} {a[1]}"
        elif step.op in CALLS:
            text = f"{CALLS[step.op]}({', '.join(a)})"
        elif step.op in COMPARE:
            text = f"BS_TRUTH({a[0]} {COMPARE[step.op]} {a[1]})"
        else:
            text = {
                "neg": lambda a: f"-{a[0]}",
                "sq": lambda a: f"{a[0]} * {a[0]}",
                "twice": lambda a: f"BS_REAL(2.0) * {a[0]}",
                "inv": lambda a: f"BS_REAL(1.0) / {a[0]}",
                "not": lambda a: f"BS_REAL(1.0) - {a[0]}",
                "and": lambda a: f"{a[0]} * {a[1]}",
                "or": lambda a: f"BS_TRUTH(({a[0]} + {a[1]}) > BS_REAL(0.0))",
                "if_else_zero": lambda a: f"BS_SELECT({a[0]}, {a[1]})",
            }[step.op](a)
        lines.append(f"const bs_real {names[position]} = {text};")
    for output, k, position in sorted(tape.results):
        result = unit.results[output]
        row, column = result.nonzeros[k]
        where = (
            f"{row}"
            if result.shape[1] == 1
            else f"{row}, {columns[column] if result.shape[1] == len(columns) else column}"
        )
        lines.append(f"{nz_name(result)}[{k}] = {names[position]}; /* {where} */")
    return lines


def temporaries(unit: Unit, tape: Tape) -> list[str]:
    """What each value of the tape is called: inputs and constants as they are, sines by their angle, others counted."""
    taken: set[str] = set()
    names: list[str] = []
    for position, step in enumerate(tape.steps):
        if step.op == "const":
            name = number(step.constant)
        elif step.op == "input":
            name = f"{unit.args[step.source[0]].name}[{step.source[1]}]"
        else:
            name = f"t{position}"
            if step.op in ("sin", "cos") and tape.steps[step.args[0]].op == "input":
                index, component = tape.steps[step.args[0]].source
                name = f"{step.op}_{unit.args[index].symbols[component].name}"
            if name in taken:
                name = f"t{position}"
            taken.add(name)
        names.append(name)
    return names


def nz_name(result: Result) -> str:
    return f"{result.name}_nz"


# ---------------------------------------------------------------- what templates see


def span(low: tuple[float, ...], high: tuple[float, ...]) -> str:
    def one(a: float, b: float) -> str:
        return f"{a:.6g} to {b:.6g}"

    if len(set(low)) == 1 and len(set(high)) == 1:
        return one(low[0], high[0])
    return ", ".join(one(a, b) for a, b in zip(low, high, strict=True))


def where_read(model: Model) -> dict[str, tuple[str, str]]:
    """Field name -> (struct, how C reaches it)."""
    return {
        field.name: (struct.name, f"{struct.name}->{field.name}") for struct in model.structs for field in struct.fields
    }


def view(model: Model, unit: Unit) -> dict[str, Any]:
    """One unit as the templates see it."""
    prefix = model.c_prefix
    c_name = f"{prefix}_{unit.name}"
    reach = where_read(model)
    columns = tuple(symbol.name for symbol in model.x)
    structs = [s.name for s in model.structs if any(reach.get(a.name, ("",))[0] == s.name for a in unit.args)]
    reads_x = any(a.name == "x" for a in unit.args)
    reads = (["x"] if reads_x else []) + structs

    args: list[dict[str, Any]] = []
    for a in unit.args:
        _, path = reach.get(a.name, ("", "x"))
        pointer = path if a.size > 1 else f"&{path}"
        local = path.replace("->", ".")
        args.append(
            {
                "name": a.name,
                "size": a.size,
                "access": pointer,
                "element": f"{local}[i]" if a.size > 1 or path == "x" else local,
                "low": ", ".join(number(v) for v in a.low),
                "high": ", ".join(number(v) for v in a.high),
                "given": f"{path}[i]" if a.size > 1 or path == "x" else path,
                "beyond_low": beyond(a)[0],
                "beyond_high": beyond(a)[1],
                "beyond_norm": norms_beyond(a),
                "norm_ends": ", ".join(map(number, norm_ends(a))),
                "norm": tuple(number(v * v) for v in a.norm) if a.norm else None,
                "text": f"{path}: {a.meaning} ({a.unit}{', ' + a.frame if a.frame else ''}); {ranges(a)}",
            }
        )
    results: list[dict[str, Any]] = []
    for r in unit.results:
        positions = [row * r.shape[1] + column for row, column in r.nonzeros]
        total = r.shape[0] * r.shape[1]
        dense = positions == list(range(total))
        size = str(total)
        if r.shape[1] == model.n:
            size = f"{prefix.upper()}_N_STATES" if r.shape[0] == 1 else f"{r.shape[0]} * {prefix.upper()}_N_STATES"
        shape = f"{r.shape[0]} x {r.shape[1]}" if r.shape[1] > 1 else f"{r.shape[0]}"
        kind = "dense" if dense else f"dense, row-major; {len(positions)} of {total} are not zero"
        results.append(
            {
                "name": r.name,
                "nz_name": nz_name(r),
                "nnz": len(positions),
                "total": total,
                "index": "" if dense else ", ".join(map(str, positions)),
                "positions": ", ".join(map(str, positions)),
                "low": ", ".join(number(v) for v in r.low),
                "high": ", ".join(number(v) for v in r.high),
                "parameter": f"bs_real {r.name}[{size}]",
                "nz_parameter": f"bs_real {nz_name(r)}[{len(positions)}]",
                "text": f"{r.name}: {r.meaning} ({r.unit}); {shape}, {kind}"
                + (", wrapped to [-pi, pi]" if r.angle else "")
                + (f"; {span(r.low, r.high)}" if r.low else ""),
                "angle": r.angle,
            }
        )
    inputs = ([f"const bs_real x[{prefix.upper()}_N_STATES]"] if reads_x else []) + [
        f"const {prefix}_{s} *{s}" for s in structs
    ]
    pointers = reads + [r["name"] for r in results]
    call = ([*(["x"] if reads_x else []), *(f"&{s}" for s in structs)], [r["name"] for r in results])
    return {
        "c_name": c_name,
        "file": file_stem(model, unit.name),
        "meaning": unit.meaning,
        "equations": unit.equations,
        "operations": unit.tape.operations,
        "hash": unit_hash(unit),
        "args": args,
        "results": results,
        "prototype": f"bs_status {c_name}({', '.join(inputs + [r['parameter'] for r in results])})",
        "null_test": null_test(pointers),
        "sparse": any(r["index"] for r in results),
        "nz_prototype": f"bs_status {c_name}_nz({', '.join(inputs + [r['nz_parameter'] for r in results])})",
        "checked_prototype": f"static bs_status {c_name}_checked("
        + f"{', '.join(inputs + [r['nz_parameter'] for r in results])})",
        "checked_call": f"{c_name}_checked({', '.join(reads + [r['nz_name'] for r in results])})",
        "nz_null_test": null_test(reads + [r["nz_name"] for r in results]),
        "result_null_test": null_test([r["name"] for r in results]),
        "nz_call": f"{c_name}_nz({', '.join(reads + [r['nz_name'] for r in results])})",
        "kernel_parameters": ", ".join(
            [f"const bs_real {a.name}[{a.size}]" for a in unit.args]
            + [f"bs_real {r['nz_name']}[{r['nnz']}]" for r in results]
        ),
        "kernel_inputs": "".join(f"{a['access']}, " for a in args),
        "statements": statements(unit, columns),
        "casadi": {
            "arg": max(1, unit.function.sz_arg()),
            "res": max(1, unit.function.sz_res()),
            "iw": max(1, unit.function.sz_iw()),
            "w": max(1, unit.function.sz_w()),
        },
        "set_parameters": ", ".join(
            ([f"bs_real x[{prefix.upper()}_N_STATES]"] if reads_x else []) + [f"{prefix}_{s} *{s}" for s in structs]
        ),
        "structs": ([{"declaration": f"bs_real x[{prefix.upper()}_N_STATES] = {{0}}"}] if reads_x else [])
        + [{"declaration": f"{prefix}_{s} {s} = {{0}}"} for s in structs],
        "reads": reads,
        "inputs": ", ".join(call[0]),
        "call": f"{c_name}({', '.join(call[0] + call[1])})",
        "null_calls": with_nulls(c_name, call[0] + call[1])
        + (with_nulls(f"{c_name}_nz", call[0] + call[1]) if any(r["index"] for r in results) else []),
        "bound_arguments": ", ".join(
            f"({kind} *)at[{i}]"
            for i, kind in enumerate(
                (["const bs_real"] if reads_x else [])
                + [f"const {prefix}_{s}" for s in structs]
                + ["bs_real"] * len(results)
            )
        ),
        "batch_parameters": ", ".join(
            (["const bs_real *x, size_t x_stride"] if reads_x else [])
            + [f"const {prefix}_{s} *{s}, size_t {s}_stride" for s in structs]
            + [f"bs_real *{r['name']}" for r in results]
        ),
        "batch_arguments": ", ".join(
            (["&x[i * x_stride]"] if reads_x else [])
            + [f"&{s}[i * {s}_stride]" for s in structs]
            + [f"&{r['name']}[i * {r['total']}U]" for r in results]
        ),
    }  # fmt: skip


def beyond(a: Variable) -> tuple[str, str]:
    """Numbers of the self-test just below and just above the box."""
    bounds = list(zip(a.low, a.high, strict=True))
    return (
        ", ".join(repr(lo - BEYOND * (abs(lo) or hi - lo)) for lo, hi in bounds),
        ", ".join(repr(hi + BEYOND * (abs(hi) or hi - lo)) for lo, hi in bounds),
    )


def norms_beyond(a: Variable) -> str:
    """What all components are so that the norm lies just below its range, and just above."""
    ends = zip(a.norm or (), (-1, 1), strict=False)
    return ", ".join(repr(norm * (1 + sign * BEYOND / 2) / math.sqrt(a.size)) for norm, sign in ends)


def with_nulls(name: str, arguments: list[str]) -> list[str]:
    """Calls with one pointer null, each in turn."""
    places = range(len(arguments))
    return [f"{name}({', '.join('0' if j == i else arguments[j] for j in places)})" for i in places]


def null_test(pointers: list[str]) -> str:
    return " || ".join(f"({p} == NULL)" for p in pointers) if len(pointers) > 1 else f"{pointers[0]} == NULL"


def ranges(variable: Variable) -> str:
    norm = f", norm {variable.norm[0]:.6g} to {variable.norm[1]:.6g}" if variable.norm else ""
    return span(variable.low, variable.high) + norm


def model_view(model: Model, unit_views: list[dict[str, Any]]) -> dict[str, Any]:
    states, index = [], 0
    for block in model.states:
        components = []
        for symbol in block.symbols:
            components.append({"name": symbol.name, "index": index})
            index += 1
        states.append(
            {
                "name": block.name,
                "meaning": block.meaning,
                "unit": block.unit,
                "frame": block.frame,
                "components": components,
            }
        )
    return {
        "name": model.name,
        "snake": snake(model.name),
        "prefix": model.c_prefix,
        "title": model.title,
        "frame": model.frame,
        "card": list(model.card),
        "n": model.n,
        "states": states,
        "structs": [
            {
                "name": s.name,
                "meaning": s.meaning,
                "fields": [
                    {
                        "name": f.name,
                        "size": f.size,
                        "unit": f.unit,
                        "frame": f.frame,
                        "meaning": f.meaning,
                        "range": ranges(f),
                    }
                    for f in s.fields
                ],
            }
            for s in model.structs
        ],
        "units": unit_views,
        "parts": [],  # sources beside the units, each with a test of its own
    }


def unit_hash(unit: Unit) -> str:
    """Of the operations and of every name and number that the C of the unit takes from elsewhere."""
    words = [unit.tape.hash(), unit.name]
    for a in unit.args:
        words += [a.name, *(s.name for s in a.symbols), repr((a.low, a.high, a.norm))]
    for r in unit.results:
        words += [r.name, repr((r.shape, r.nonzeros, r.angle, r.low, r.high))]
    return hashlib.sha256("\n".join(words).encode()).hexdigest()


# ---------------------------------------------------------------- files of one unit, and of the model


def unit_files(model: Model, unit: Unit, with_vectors: bool = True) -> dict[str, str]:
    """Path below the model's folder -> text, for what belongs to this unit alone."""
    u, m = view(model, unit), model_view(model, [])
    c = u["file"]
    render = templates().get_template
    files = {
        f"src/{c}.c": render("unit.c.j2").render(u=u, m=m),
        f"src/{c}_kernel.h": render("kernel.h.j2").render(u=u, m=m),
        f"casadi/{c}_casadi.c": casadi_c(unit),
        f"casadi/{c}_kernel.h": render("casadi_kernel.h.j2").render(u=u, m=m),
    }
    if with_vectors:
        files[f"selftest/test_{c}.c"] = render("test_unit.c.j2").render(
            u=u, m=m, vectors=vectors(model, unit), digits=DIGITS, libm_ulps=LIBM_ULPS
        )
    return files


def model_files(model: Model, made: list[Unit]) -> dict[str, str]:
    """Path -> text of what all units share."""
    views = [view(model, unit) for unit in made]
    m = model_view(model, views)
    names = {
        "include/boresight.h": "boresight.h.j2",
        f"include/{m['snake']}.h": "model.h.j2",
        f"batch/{m['prefix']}_batch.c": "batch.c.j2",
        "selftest/selftest.h": "selftest.h.j2",
        "selftest/selftest.c": "selftest.c.j2",
        "CMakeLists.txt": "CMakeLists.txt.j2",
    }
    extra: dict[str, Any] = {"f": None}
    if has_filter(model):
        extra = {"c": covariance_view(model, made), "f": filter_view(model, made, views)}
        m["parts"] = [f"{m['prefix']}_covariance", f"{m['prefix']}_filter"]
        for part in ("covariance", "filter"):
            names[f"include/{m['snake']}_{part}.h"] = f"{part}.h.j2"
            names[f"src/{m['prefix']}_{part}.c"] = f"{part}.c.j2"
        names["include/boresight_filter.h"] = "boresight_filter.h.j2"
        extra["t"] = test_view(model, made, extra["f"])
        names[f"selftest/test_{m['prefix']}_filter.c"] = "test_filter.c.j2"
    return {path: templates().get_template(name).render(m=m, **extra) for path, name in names.items()}


def covariance_test(model: Model, made: list[Unit]) -> str:
    """The self-test of the covariance kernels, whose golden vectors depend on nothing but sizes and places."""
    v = vectors_view(model.n, nonzeros(made, "F"), nonzeros(made, "Qc"))
    return (
        templates()
        .get_template("test_covariance.c.j2")
        .render(m=model_view(model, []), c=covariance_view(model, made), v=v)
    )


def casadi_c(unit: Unit) -> str:
    """CasADi's own C of the unit."""
    generator = ca.CodeGenerator(
        unit.function.name(),
        {"casadi_int": "int", "with_header": False, "static_aux": True, "prefix": unit.function.name() + "_"},
    )
    generator.add(unit.function)
    return generator.dump()


def exact(unit: Unit, points: list[np.ndarray], k: int) -> list[list[Any]]:
    """The non-zeros of each result at point k, from the reference, as mpf."""
    values = {a.name: [mp.mpf(float(v)) for v in points[i][k]] for i, a in enumerate(unit.args)}
    matrices = unit.reference(values)
    return [[matrix[place] for place in result.nonzeros] for matrix, result in zip(matrices, unit.results, strict=True)]


def vectors(model: Model, unit: Unit) -> dict[str, Any]:
    """Golden vectors as hexadecimal text: inputs that a float holds, expected outputs, tolerances of each precision.

    The expected value is rounded to double, which comes on top of what the C may err by.
    """
    points = answered(unit, CORNERS, VECTORS, generator(model.name, unit.name), in_float=True)
    count = len(points[0]) if points else 1
    references = [exact(unit, points, k) for k in range(count)]
    places = {(output, nz): i for i, (output, nz, _) in enumerate(unit.tape.results)}

    def table(rows: np.ndarray) -> str:
        return ",\n".join("    { " + ", ".join(v.hex() for v in row) + " }" for row in rows.tolist())

    expected = [
        np.array([[float(v) for v in references[k][o]] for k in range(count)]) for o in range(len(unit.results))
    ]

    def tolerances(real: type[np.floating]) -> list[str]:
        _, bounds = evaluate(unit.tape, points, LIBM_ULPS, real)
        return [
            table(
                np.array([bounds[places[o, nz]] for nz in range(len(result.nonzeros))]).T
                + abs(expected[o]) * 2.0**-53
                + DIFFERENTIATED
            )
            for o, result in enumerate(unit.results)
        ]

    boxed = any(result.low for result in unit.results)
    edge, outside = edges(unit, BEYOND, generator(model.name, unit.name, "edges")) if boxed else ([], [])
    return {
        "count": count,
        "outside": outside,
        # where there is neither a norm nor a box of the result, any point will do
        "ends": ends(unit, points) if boxed or any(a.norm for a in unit.args) else [],
        "inputs": [table(np.vstack([p, edge[i]]) if outside else p) for i, p in enumerate(points)],
        "outputs": [table(values) for values in expected],
        "tolerances": tolerances(np.float64),
        "float_tolerances": tolerances(np.float32),
    }


def filter_manifest(model: Model, made: list[Unit]) -> dict[str, Any]:
    """What a caller of the whole filter in C must know: its sources, its structs and what each function is given."""
    f = filter_view(model, made, [view(model, unit) for unit in made])
    return {
        "sources": [f"{model.c_prefix}_covariance", f"{model.c_prefix}_filter"],
        "carried": f["carried"],
        "propagate": {key: f["propagate"][key] for key in ("structs", "fields")},
        "correct": f["correct"] and {key: f["correct"][key] for key in ("structs", "fields", "written")},
        "measurements": {
            m["name"]: {key: m[key] for key in ("m", "structs", "fields", "nonlinear")} | {"brings_z": m["z"] is None}
            for m in f["measurements"]
        },
    }


def manifest(model: Model, made: list[Unit], files: dict[str, str], versions: dict[str, str]) -> str:
    """What a reader without SymPy needs to bind and to check the generated C, as JSON."""

    def field(v: Variable) -> dict[str, Any]:
        return {
            "name": v.name, "size": v.size, "components": [s.name for s in v.symbols], "unit": v.unit, "frame": v.frame,
            "meaning": v.meaning, "low": v.low, "high": v.high, "norm": v.norm,
        }  # fmt: skip

    described = {}
    for unit in made:
        u = view(model, unit)
        described[unit.name] = {
            "c_name": u["c_name"],
            "file": u["file"],
            "meaning": unit.meaning,
            "equations": unit.equations,
            "hash": u["hash"],
            "operations": u["operations"],
            "structs": u["reads"],
            "fields": [a.name for a in unit.args],
            "results": [
                {
                    "name": r.name, "shape": r.shape, "nonzeros": len(r.nonzeros), "unit": r.unit, "angle": r.angle,
                    "vector": r.shape[1] == 1 and r.name not in MATRICES,
                }
                for r in unit.results
            ],
        }  # fmt: skip
    document = {
        "model": model.name,
        "title": model.title,
        "frame": model.frame,
        "c_prefix": model.c_prefix,
        "states": [s.name for s in model.x],
        "blocks": [field(v) for v in model.states],
        "structs": ({"x": [field(state_variable(model))]} if model.n else {})
        | {s.name: [field(v) for v in s.fields] for s in model.structs},
        "measurements": {
            m.name: {"rows": m.rows, "unit": m.unit, "meaning": m.meaning, "angle": m.angle, "equations": m.equations}
            for m in model.measurements
        },
        "units": described,
        "filter": filter_manifest(model, made) if has_filter(model) else None,
        "files": {path: hashlib.sha256(text.encode()).hexdigest() for path, text in files.items()},
        "versions": versions,
    }  # fmt: skip
    return json.dumps(document, indent=1, sort_keys=True) + "\n"
