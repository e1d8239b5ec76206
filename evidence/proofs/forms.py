"""Forms of quaternions in an instruction list, and what their norms say of their range; intervals of the components
would say less: four products of two components each lie in [-1, 1], and so does their sum where it is a rotation.

Which steps are forms follows from the operations alone.  A form is kept as its coefficients, by what it is a form of:

- ("q", a): of the argument a, a vector (linear) or a symmetric matrix (quadratic);
- ("ab", a, b): of two arguments, a matrix (linear in both) or four indices (quadratic in both);
- ("p", a, b, which): of a product of both, whose norm is the product of their norms.
"""

from functools import cache
from itertools import combinations_with_replacement

import numpy as np

from boresight.codegen.functions.tape import Step, Tape
from boresight.derive.model import Variable

Range = tuple[float, float]
Key = tuple[object, ...]
NORM_SLACK = 1e-6  # by how much the guard's own sum of squares may err
SMALL = 1e-9  # what coefficients and eigenvalues may err by
LARGEST = 64.0  # coefficients beyond are not of a rotation, and SMALL would not hold for them


def hamilton() -> np.ndarray:
    """(component, i, j): the coefficient of a_i b_j in each component of the product of a and b."""
    made = np.zeros((4, 4, 4))
    for m, terms in enumerate(("00-11-22-33", "01+10+23-32", "02-13+20+31", "03+12-21+30")):
        terms = "+" + terms
        for at in range(0, len(terms), 3):
            made[m, int(terms[at + 1]), int(terms[at + 2])] = 1.0 if terms[at] == "+" else -1.0
    return made


TURNED = np.array([1.0, -1.0, -1.0, -1.0])  # the conjugate
PRODUCTS = {
    "a b": hamilton(),
    "b a": hamilton().transpose(0, 2, 1),
    "a* b": hamilton() * TURNED[:, None],
    "a b*": hamilton() * TURNED,
}
PAIRS = list(combinations_with_replacement(range(4), 2))


def symmetric(form: np.ndarray) -> np.ndarray:
    """Of four indices, the first two of a and the others of b."""
    form = (form + form.transpose(1, 0, 2, 3)) / 2
    return (form + form.transpose(0, 1, 3, 2)) / 2


@cache
def squares(which: str) -> tuple[np.ndarray, np.ndarray]:
    """What each product of two components of p is as a form of a and b, (256, 10), and its pseudo-inverse."""
    of = PRODUCTS[which]
    columns = [symmetric(np.einsum("ik,jl->ijkl", of[m], of[n])).ravel() for m, n in PAIRS]
    return np.array(columns).T, np.linalg.pinv(np.array(columns).T)


def as_product(form: np.ndarray, which: str) -> np.ndarray | None:
    """The same form of the product, if it is one."""
    if form.ndim == 2:
        of = PRODUCTS[which]
        linear: np.ndarray = np.einsum("mij,ij->m", of, form) / 4
        return linear if np.allclose(np.einsum("m,mij->ij", linear, of), form, rtol=0, atol=SMALL / 100) else None
    columns, inverse = squares(which)
    found = inverse @ form.ravel()
    if not np.allclose(columns @ found, form.ravel(), rtol=0, atol=SMALL / 100):
        return None
    quadratic = np.zeros((4, 4))
    for (m, n), value in zip(PAIRS, found, strict=True):
        quadratic[m, n] += value / 2
        quadratic[n, m] += value / 2
    return quadratic


def product(one: tuple[Key, np.ndarray], other: tuple[Key, np.ndarray]) -> tuple[Key, np.ndarray] | None:
    (key, m), (its, n) = one, other
    if key == its and key[0] != "ab" and m.ndim == n.ndim == 1:
        return key, (np.outer(m, n) + np.outer(n, m)) / 2
    if key[0] == its[0] == "q" and key != its and m.ndim == n.ndim and len(m) == len(n) == 4:
        (a, m), (b, n) = sorted([(key[1], m), (its[1], n)], key=lambda pair: int(str(pair[0])))
        return ("ab", a, b), np.multiply.outer(m, n)
    return None


def formed(step: Step, of: list[dict[Key, np.ndarray]], constants: list[float | None]) -> dict[Key, np.ndarray]:
    """What a step is a form of, from its operands' forms."""
    made: dict[Key, np.ndarray] = {}
    if step.op in ("add", "sub"):
        sign = 1 if step.op == "add" else -1
        made = {
            key: m + sign * of[1][key]
            for key, m in of[0].items()
            if key in of[1] and m.shape == of[1][key].shape
        }  # fmt: skip
    elif step.op in ("neg", "twice"):
        made = {key: m * (-1 if step.op == "neg" else 2) for key, m in of[0].items()}
    elif step.op in ("mul", "sq"):
        for one in of[0].items():
            for other in of[-1].items():
                found = product(one, other)
                if found:
                    made[found[0]] = found[1]
        for i, constant in enumerate(constants):
            if constant is not None and len(of) == 2:
                made = {key: m * constant for key, m in of[1 - i].items()}
    for key, form in list(made.items()):
        if key[0] == "ab":
            for which in PRODUCTS:
                same = as_product(form, which)
                if same is not None:
                    made[("p", *key[1:], which)] = same
    return {key: m for key, m in made.items() if np.abs(m).max() < LARGEST}


@cache
def ranges(tape: Tape, args: tuple[Variable, ...]) -> dict[int, Range]:
    """Steps whose exact value is a form of quaternions: what it lies in."""
    found: dict[int, dict[Key, np.ndarray]] = {}
    for k, step in enumerate(tape.steps):
        if step.op == "input":
            arg, i = step.source
            if args[arg].norm is not None:
                found[k] = {("q", arg): np.eye(args[arg].size)[i]}
            continue
        operands = [tape.steps[a] for a in step.args]
        constants = [o.constant if o.op == "const" else None for o in operands]
        made = formed(step, [found.get(a, {}) for a in step.args], constants)
        if made:
            found[k] = made
    norms = {i: arg.norm for i, arg in enumerate(args) if arg.norm is not None}
    within = {}
    for k, forms in found.items():
        if tape.steps[k].op != "input":
            lows, highs = zip(*(of_form(key, form, norms) for key, form in forms.items()), strict=True)
            within[k] = max(lows), min(highs)
    return within


def of_form(key: Key, form: np.ndarray, norms: dict[int, tuple[float, float]]) -> Range:
    """The range of one form: of a quadratic one between its eigenvalues times the squared norm."""
    low = high = 1.0
    for i in key[1:3]:
        least, most = norms[int(str(i))]
        low, high = low * least * (1 - NORM_SLACK), high * most * (1 + NORM_SLACK)
    if key[0] == "ab":
        if form.ndim == 4:
            form, high = form.reshape(16, 16), high**2
        most = float(np.linalg.norm(form, 2)) * high + SMALL
        return -most, most
    if form.ndim == 1:
        most = float(np.linalg.norm(form)) * high + SMALL
        return -most, most
    least, most = (float(v) for v in np.linalg.eigvalsh(form)[[0, -1]])
    return least * (low if least > 0 else high) ** 2 - SMALL, most * (high if most > 0 else low) ** 2 + SMALL
