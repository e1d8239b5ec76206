"""What \flown{F_phi:NED:1} stands for in the derivations: the columns of the matrices that SymPy differentiates."""

from collections.abc import Mapping

from sympy import Symbol

from boresight.derive.ledger.ellipsoid import LEVELS
from boresight.derive.papers.mechanics import kinematics


def flown(letters: Mapping[str, Symbol]) -> Mapping[str, object]:
    return Differentiated()


class Differentiated(dict):
    """The columns by name; made when asked for."""

    def __missing__(self, name: str):
        function, level, column = name.split(":")
        return getattr(kinematics, function)(LEVELS[level]).col(int(column) - 1)

    def __contains__(self, name: object) -> bool:
        return True
