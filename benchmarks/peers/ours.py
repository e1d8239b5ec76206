"""Boresight's C behind the signature that all tools have.  Every call of it that is timed stands in `calls`."""

from pathlib import Path

from benchmarks.peers.formulas import Problem
from benchmarks.peers.printers import HEAD, UNUSED
from boresight.codegen.text.files import folder_files
from boresight.codegen.text.names import snake
from boresight.derive.model import Model

FORMS = {"Boresight": "joseph", "Boresight, UD factors": "ud"}
NON_ZEROS = "Boresight, non-zeros alone"  # of F


def printed(model: Model, folder: Path) -> list[Path]:
    """The model's C without its self-tests, whose golden vectors are dear; its sources."""
    _, files = folder_files(model, lambda test, tested: "/* left out */\n")
    for path, text in files.items():
        if path.startswith(("include/", "src/")):
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text)
    return sorted((folder / "src").glob("*.c"))


def calls(p: Problem, model: Model, kind: str, name: str, tool: str) -> str | None:
    """C of one kind, or None where Boresight offers none.

    The structs hold doubles alone, in the order of v.  What works in place is given a copy, within the time.
    """
    x, X, form = model.c_prefix, model.c_prefix.upper(), FORMS.get(tool, "")
    at, place = {}, 0
    for struct in model.structs:
        at[struct.name], place = place, place + sum(item.size for item in struct.fields)
    read = {struct.name: f"(const {x}_{struct.name} *)&v[{at[struct.name]}]" for struct in model.structs}
    nav, step, noise = (read[struct.name] for struct in (model.structs[0], model.structs[1], model.structs[-1]))
    noise = read.get("noise", noise)
    copy = f"memcpy(out, P, sizeof(bs_real) * {X}_N_PACKED);"
    first, m = len(p.names), len(p.rows)
    after, before = "", ""
    if kind == "F" and form == "joseph":
        body = f"(void){x}_F({nav}, {step}, out);"
    elif kind == "F" and tool == NON_ZEROS:
        places = [i * p.n + j for i, j in p.entries[0]]
        body = f"(void){x}_F_nz({nav}, {step}, out);"
        after = f"""static const int at[] = {{ {", ".join(map(str, places))} }};
            double nz[{len(places)}];
            memcpy(nz, out, sizeof nz);
            memset(out, 0, sizeof(double) * {p.n**2});
            for (int k = 0; k < {len(places)}; ++k) out[at[k]] = nz[k];"""
    elif kind.startswith("predict") and form:
        body = f"""bs_real Phi[{X}_N_STATES * {X}_N_STATES], work[{X}_N_WORK];
            (void){x}_Phi({nav}, {step}, Phi);
#if {X}_ROW == {X}_N_STATES
            {x}_{form}_predict(P, Phi, Q, out, work);
#else
            bs_real rows[{X}_N_PHI] = {{ 0 }};
            for (int i = 0; i < {X}_N_MOVING; ++i) memcpy(&rows[i * {X}_ROW], &Phi[i * {p.n}], sizeof(bs_real) * {p.n});
            {x}_{form}_predict(P, rows, Q, out, work);
#endif"""
    elif kind == "updates, Joseph" and form:
        rows = [(f"h{r}", f"at{r}", h, r) for r, h in enumerate(p.rows)]
        tables = "".join(
            f"static const bs_real {h}[] = {{ {', '.join(map(repr, row.values()))} }};"
            f"static const unsigned short {where}[] = {{ {', '.join(map(str, row))} }};"
            for h, where, row, _ in rows
        )
        steps = "".join(
            f"{{ bs_row row = {{ {h}, {where}, {len(row)}, v[{first + r}], v[{first + m + r}], "
            "0.0, 0.0, 0.0, 1, NULL };"
            f"(void){x}_{form}_update(out, &out[{X}_N_PACKED], &row); }}"
            for h, where, row, r in rows
        )
        body = f"{tables}{copy} memcpy(&out[{X}_N_PACKED], &v[{first + 2 * m}], sizeof(bs_real) * {p.n});{steps}"
    elif kind == "propagate" and form == "joseph":
        body = f"""{x}_filter *const f = ({x}_filter *)out;
            memcpy(f->P, P, sizeof f->P);
            memcpy(f->x, &v[{first + 2 * m}], sizeof f->x);
            f->nav = *{nav};
            (void){x}_filter_propagate(f, {step}, {noise});"""
        after = f"""static {x}_filter f;
            memcpy(&f, out, sizeof f);
            memcpy(out, f.P, sizeof f.P);
            memcpy(&out[{X}_N_PACKED], f.x, sizeof f.x);"""
    else:
        return None
    if form == "ud":
        at_P = "P[j * (j + 1) / 2 + i]"
        before = f"""static bs_real dense[{p.n**2}], work[{X}_N_WORK], UD[{X}_N_PACKED];
            for (int j = 0; j < {p.n}; ++j)
                for (int i = 0; i <= j; ++i) dense[i * {p.n} + j] = dense[j * {p.n} + i] = {at_P};
            (void){x}_ud_init(dense, UD, work);
            memcpy(P, UD, sizeof UD);"""
        after = f"""static bs_real dense[{p.n**2}];
            {x}_ud_dense(out, dense);
            for (int j = 0; j < {p.n}; ++j)
                for (int i = 0; i <= j; ++i) out[j * (j + 1) / 2 + i] = dense[i * {p.n} + j];"""
    text = f'#include <string.h>\n#include "{snake(model.name)}_filter.h"\n'
    for head, lines in (
        (HEAD.format(name=name), f"{UNUSED} {body}"),
        (f"void {name}_before(double *P, double *Q)", f"(void)P; (void)Q; {before}"),
        (f"void {name}_after(double *out)", f"(void)out; {after}"),
    ):
        text += f"{head};\n{head}\n{{\n    {lines}\n}}\n"
    return text
