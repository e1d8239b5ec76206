"""The noise of a model, as far as its own words go: each density once, by itself, and of the axes that it drives."""

from collections import Counter
from collections.abc import Iterator

import sympy as sp

from boresight.codegen.mechanics import MechanicsCheck
from boresight.codegen.residuals import OF_BODY, OF_LEVEL, letters
from boresight.derive.model import Model, Variable


def check_noise(model: Model) -> list[MechanicsCheck]:
    """A row of what is not as its words say; none where all is."""
    if model.noise is None or not len(model.noise):
        return []
    why = "; ".join((*multiples(model), *repeated(model), *exchanged(model)))
    return [MechanicsCheck(model.name, "noise", "", why=why)] if why else []


def multiples(model: Model) -> Iterator[str]:
    for w in model.noise:
        times, rest = w.as_coeff_Mul()
        if rest.is_Symbol and times not in (1, -1):
            yield f"{rest} is taken {float(times):.6g} times"


def repeated(model: Model) -> Iterator[str]:
    """A density that stands for two noises, and one that stands for none though others of its vector do."""
    read = [w.as_coeff_Mul()[1] for w in model.noise]
    count = Counter(w for w in read if w.is_Symbol)
    yield from (f"{w} stands {n} times" for w, n in count.items() if n > 1)
    free = set[sp.Symbol]().union(*(w.free_symbols for w in read))
    for v in model.inputs:
        if free & {*v.symbols} and (lost := [s.name for s in v.symbols if s not in free]):
            yield f"{', '.join(lost)} drives nothing, {v.name} else does"


def exchanged(model: Model) -> Iterator[str]:
    """A noise of other axes than what it drives, or called as another thing that is driven too."""
    driven = model.mechanics.driven if model.mechanics is not None else ()
    names = {stem(what): noise for noise, what in driven}
    for noise, what in driven:
        mine, theirs = letters(noise), letters(what)
        axes = [kind for kind in (OF_BODY, OF_LEVEL) if mine in kind]
        if axes and theirs not in axes[0] and theirs in (*OF_BODY, *OF_LEVEL):
            yield f"{noise.name} is along {', '.join(mine)}, and drives {what.name} along {', '.join(theirs)}"
        elif names.get(stem(noise), noise) is not noise:
            yield f"{noise.name} drives {what.name}, and {names[stem(noise)].name} what it is called by"


def stem(v: Variable) -> str:
    return v.name.removeprefix("d_").removesuffix("_noise")
