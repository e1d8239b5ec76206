"""The same formulas printed as C or C++ by each tool: `void NAME(const double *v, const double *P, const double *Q,
double *out)`.

A printer takes the problem, the kind and the name, and gives the text and the suffix of its file.  P and Q are packed,
and out is what the kind writes; where a tool has another layout, NAME_before(P, Q) and NAME_after(out) change to it and
back, outside of what is timed.
"""

import contextlib
import re
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks.peers.formulas import FUNCTIONS, Plain, Problem, Rows, outputs, statements

HEAD = "void {name}(const double *v, const double *P, const double *Q, double *out)"
UNUSED = "(void)v; (void)P; (void)Q;"


def named_c(kind: str) -> str:
    return re.sub(r"\W+", "_", kind).lower()


def sizes(p: Problem) -> dict[str, int]:
    return {"v": p.width, "P": len(p.upper), "Q": len(p.upper)}


def casadi(p: Problem, kind: str, name: str) -> tuple[str, str]:
    import casadi as ca

    symbols = {key: ca.SX.sym(key, size) for key, size in sizes(p).items()}
    parts = {key: [whole[k] for k in range(whole.numel())] for key, whole in symbols.items()}
    values = outputs(p, kind, [*parts.values()], {f: getattr(ca, f) for f in FUNCTIONS})
    value = ca.cse(ca.densify(ca.vertcat(*values)))
    function = ca.Function(f"{name}_casadi", list(symbols.values()), [value])
    generator = ca.CodeGenerator(name, {"casadi_int": "int", "with_header": False, "static_aux": True})
    generator.add(function)
    text = generator.dump()
    call = f"const double *arg[3] = {{ v, P, Q }}; double *res[1] = {{ out }}; (void){name}_casadi(arg, res, 0, 0, 0);"
    return f"{text}\n{HEAD.format(name=name)};\n{HEAD.format(name=name)} {{ {call} }}\n", "c"


def sympy_symbols(p: Problem) -> tuple[list[Any], ...]:
    import sympy as sp

    return tuple([sp.Symbol(f"{key}_{k}") for k in range(size)] for key, size in sizes(p).items())


def in_c(name: str, lines: list[str], includes: str = "#include <math.h>") -> str:
    read = sorted(set(re.findall(r"\b([vPQ])_(\d+)\b", "\n".join(lines))), key=lambda at: (at[0], int(at[1])))
    taken = [f"const double {key}_{k} = {key}[{k}];" for key, k in read]
    head = f"{includes}\n{HEAD.format(name=name)};\n{HEAD.format(name=name)}\n{{"
    return "\n    ".join([head, UNUSED, *taken, *lines]) + "\n}\n"


def cse_lines(values: list[Any], prefix: str, target: Callable[[int], str]) -> list[str]:
    import sympy as sp

    text = Plain().doprint
    terms, reduced = sp.cse(values, sp.numbered_symbols(prefix))
    lines = [f"const double {symbol} = {text(value)};" for symbol, value in terms]
    return lines + [f"{target(k)} = {text(sp.sympify(value))};" for k, value in enumerate(reduced)]


def sympy_cse(p: Problem, kind: str, name: str) -> tuple[str, str]:
    """All outputs through one cse."""
    import sympy as sp

    values = outputs(p, kind, sympy_symbols(p), {f: getattr(sp, f) for f in FUNCTIONS})
    return in_c(name, cse_lines(values, "t", "out[{}]".format)), "c"


def sympy_staged(p: Problem, kind: str, name: str) -> tuple[str, str]:
    """F, Phi, Phi P and so on one after another, each entry of each with a name."""
    import sympy as sp

    lines: list[str] = []

    def named(rows: Rows) -> Rows:
        at = [(i, j) for i, row in enumerate(rows) for j, value in row.items() if getattr(value, "args", ())]
        first = len(lines)
        symbols = {key: sp.Symbol(f"s{first}_{k}") for k, key in enumerate(at)}
        lines.extend(cse_lines([rows[i][j] for i, j in at], f"c{first}_", lambda k: f"const double {symbols[at[k]]}"))
        return [{j: symbols.get((i, j), value) for j, value in row.items()} for i, row in enumerate(rows)]

    values = outputs(p, kind, sympy_symbols(p), {f: getattr(sp, f) for f in FUNCTIONS}, named=named)
    return in_c(name, lines + cse_lines(values, "t", "out[{}]".format)), "c"


def symforce(p: Problem, kind: str, name: str) -> tuple[str, str]:
    import symforce

    with contextlib.suppress(symforce.AlreadyUsedEpsilon):
        symforce.set_epsilon_to_number()
    import symforce.symbolic as sf
    from symforce.codegen import Codegen, CppConfig
    from symforce.values import Values

    symbols = {key: sf.Matrix(size, 1).symbolic(key) for key, size in sizes(p).items()}
    parts = [[whole[k] for k in range(whole.shape[0])] for whole in symbols.values()]
    values = outputs(p, kind, parts, {f: getattr(sf, f) for f in FUNCTIONS})
    code = Codegen(
        inputs=Values(**symbols),
        outputs=Values(out=sf.Matrix(len(values), 1, values)),
        config=CppConfig(zero_initialization_sparsity_threshold=2.0),
        name=f"{name}_sf",
    )
    with tempfile.TemporaryDirectory() as folder:
        made = code.generate_function(output_dir=Path(folder), skip_directory_nesting=True)
        text = next(path for path in made.generated_files if path.suffix == ".h").read_text()
    arguments = [f"*reinterpret_cast<const Eigen::Matrix<double, {n}, 1> *>({key})" for key, n in sizes(p).items()]
    arguments.append(f"reinterpret_cast<Eigen::Matrix<double, {len(values)}, 1> *>(out)")
    camel = "".join(part.capitalize() for part in f"{name}_sf".split("_"))
    call = f"sym::{camel}<double>({', '.join(arguments)});"
    return f'{text.replace("#pragma once", "")}\nextern "C" {HEAD.format(name=name)} {{ {call} }}\n', "cc"


def wrenfold(p: Problem, kind: str, name: str) -> tuple[str, str]:
    from typing import Annotated

    from wrenfold import code_generation, sym
    from wrenfold.type_annotations import Shape

    def described(v: Any, P: Any, Q: Any) -> list[Any]:
        parts = [[whole[k] for k in range(whole.shape[0])] for whole in (v, P, Q)]
        values = outputs(p, kind, parts, {f: getattr(sym, f) for f in FUNCTIONS})
        return [code_generation.OutputArg(sym.matrix(values), name="out")]

    described.__annotations__ = {key: Annotated[sym.MatrixExpr, Shape(size, 1)] for key, size in sizes(p).items()}
    text = code_generation.generate_function(described, code_generation.CppGenerator(), name=f"{name}_wf")
    spans = ", ".join(span(key, size) for key, size in (*sizes(p).items(), ("out", p.writes(kind))))
    call = f'extern "C" {HEAD.format(name=name)} {{ {UNUSED} {name}_wf<double>({spans}); }}'
    return f"#include <cmath>\n#include <wrenfold/span.h>\n{text}\n{call}\n", "cc"


def span(key: str, size: int) -> str:
    return f"wf::make_span({key}, wf::make_constant_value_pack<{size}, 1>(), wf::make_constant_value_pack<1, {size}>())"


def eigen(p: Problem, kind: str, name: str) -> tuple[str, str]:
    """By hand, with dense matrices of fixed size, as one writes it without a generator; P and out are dense."""
    names = {key: f"v[{k}]" for k, key in enumerate(p.names)}
    n, m, first = p.n, len(p.rows), len(p.names)
    lines = [f"using M = Eigen::Matrix<double, {n}, {n}, Eigen::RowMajor>; using V = Eigen::Matrix<double, {n}, 1>;"]
    if not kind.startswith("updates"):
        terms = statements(p.statements, kind == "propagate")
        read = {word for _, line in terms for word in re.findall(r"[A-Za-z_]\w*", line)}
        lines += [f"const double {key} = {place};" for key, place in names.items() if key in read | {"dt"}]
        lines += [f"const double {key} = {line};" for key, line in terms]
        for matrix, entries in zip(("F", "Qc")[: 1 + (kind == "propagate")], p.entries, strict=False):
            lines.append(f"M {matrix} = M::Zero();")
            lines += [f"{matrix}({i}, {j}) = {matrix}_{i}_{j};" for i, j in entries]
    if kind == "F":
        lines.append("(void)dt; Eigen::Map<M> o(out); o = F;")
    elif kind.startswith("updates"):
        lines.append(f"M C = Eigen::Map<const M>(P); V x = Eigen::Map<const V>(&v[{first + 2 * m}]);")
        for row, h in enumerate(p.rows):
            lines.append("{ V h = V::Zero(); " + " ".join(f"h({k}) = {value};" for k, value in h.items()))
            lines.append(f"const V g = C * h; const double R = v[{first + m + row}]; const V K = g / (h.dot(g) + R);")
            lines.append(f"x += K * (v[{first + row}] - h.dot(x));")
            if kind.endswith("plain"):
                lines.append("C -= K * g.transpose(); }")
            else:
                lines.append("const M A = C - K * g.transpose(); const V c = A * h - R * K;")
                lines.append("C = A - c * K.transpose(); }")
        lines.append(f"Eigen::Map<M> o(out); o = C; Eigen::Map<V> ox(&out[{n * n}]); ox = x;")
    else:
        lines.append("const M A = F * dt; M Phi = A; Phi.diagonal().array() += 1.0;")
        if kind != "predict 1":
            lines.append("const M AA = A * A; Phi += 0.5 * AA;")
        lines.append("Eigen::Map<M> o(out);")
        if kind == "propagate":
            lines.append("M B = A * (2.0 / 3.0) + AA * (2.0 / 9.0); B.diagonal().array() += 1.0;")
            lines.append("const M W = Qc * dt; const M BW = B * W; M N = BW * B.transpose(); N = 0.75 * N + 0.25 * W;")
            lines.append(f"Eigen::Map<const V> x(&v[{first + 2 * m}]); Eigen::Map<V> ox(&out[{n * n}]); ox = Phi * x;")
        else:
            lines.append("Eigen::Map<const M> N(Q);")
        lines.append("const M Y = Phi * Eigen::Map<const M>(P); o.noalias() = Y * Phi.transpose(); o += N;")
    body = "\n    ".join([UNUSED, *lines])
    head = "#include <cmath>\n#include <Eigen/Dense>\nusing std::sin; using std::cos; using std::tan; using std::sqrt;"
    text = f'{head}\nextern "C" {HEAD.format(name=name)}\n{{\n    {body}\n}}\n'
    return text + ("" if kind == "F" else DENSE.format(name=name, n=n, packed=len(p.upper))), "cc"


DENSE = """
static void spread(double *M)
{{
    for (int j = {n} - 1; j >= 0; --j)
        for (int i = j; i >= 0; --i) M[j * {n} + i] = M[j * (j + 1) / 2 + i];
    for (int j = 0; j < {n}; ++j)
        for (int i = 0; i < j; ++i) M[i * {n} + j] = M[j * {n} + i];
}}
extern "C" void {name}_before(double *P, double *Q) {{ spread(P); spread(Q); }}
extern "C" void {name}_after(double *out)
{{
    for (int j = 0; j < {n}; ++j)
        for (int i = 0; i <= j; ++i) out[j * (j + 1) / 2 + i] = out[j * {n} + i];
    for (int i = 0; i < {n}; ++i) out[{packed} + i] = out[{n} * {n} + i];
}}
"""


PRINTERS: dict[str, Callable[[Problem, str, str], tuple[str, str]]] = {
    "CasADi": casadi,
    "SymForce": symforce,
    "wrenfold": wrenfold,
    "SymPy cse": sympy_cse,
    "SymPy staged": sympy_staged,
    "Eigen, dense by hand": eigen,
}
