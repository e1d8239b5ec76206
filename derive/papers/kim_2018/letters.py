"""The letters of the derivations that the paper does not print, and how lines spell those that it spells alike."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from typing import Any
from unicodedata import normalize

from sympy import Symbol

from boresight.derive.ledger.equation import Quantity
from boresight.derive.papers.kim_2018.printed import quantities

# On the page a vector and its skew matrix, or a matrix of both filters, are one letter; in a line each has its own.
SPELLED = {
    "f_n": "f^n",
    "[f_n x]": r"[f^n \times]",
    "δω_ie_n": r"\delta \omega_{ie}^n",
    "δω_en_n": r"\delta \omega_{en}^n",
    "[ω_ie_n x]": r"[\omega_{ie}^n \times]",
    "[ω_en_n x]": r"[\omega_{en}^n \times]",
    "F_X": "F",
    "H_X": "H",
    "H_v": "H_v",
    "I": "I",
}

# name: LaTeX, kind, meaning, shape
ADDED: dict[str, tuple[str, str, str, tuple[int, ...]]] = {
    "f_b": ("f^b", "force in body axes", "specific force, m/s^2", (3,)),
    "ω_nr_n": (r"\omega_{nr}^n", "rate against the level", "rate of the master against n, rad/s", (3,)),
    "q_r2n": ("q_r^n", "master's quaternion", "true attitude of the master", (4,)),
    "q̂_r2n": (r"\hat{q}_r^n", "master's quaternion", "attitude of the master as it arrives", (4,)),
    "μ̂": (r"\hat{\mu}", "mounting vector", "rotation vector of the estimated mounting, rad", (3,)),
    "Γ_k": (r"\Gamma_k", "15x6", "how errors of gyros and accelerometers enter the rates", (15, 6)),
}


@cache
def letters() -> tuple[Quantity, ...]:
    return tuple(_letters())


def _letters() -> Iterator[Quantity]:
    by_name = {quantity.symbol.name: quantity for quantity in quantities()}
    for name, latex in SPELLED.items():
        yield replace(by_name[name], latex=latex)
    for name, (latex, kind, meaning, shape) in ADDED.items():
        name = normalize("NFC", name)
        symbol = Symbol(name, commutative=shape == (), real=True if shape == () else None)
        yield Quantity(symbol, latex, kind, meaning, shape)


STRUCTURE: Mapping[str, Any] = {}
