"""The map from a paper's states, inputs and rows to those of a model that makes C: a table.

A paper's states are T times ours, its noises N times ours, its rows S times ours; T, N and S have a block for each row
of the table.  So of the model's own F, G, H and z the paper's are T F T^-1 + T' T^-1, T G N^-1, S H T^-1 and S z;
ledger/carried.py holds them against the paper's at the witness.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from boresight.derive.model import Model


@dataclass(frozen=True)
class Row:
    """The paper's letter is `factor` times ours.

    ours: a state, a noise or a measurement of the model.  factor: LaTeX in the paper's letters of a number, or of a
    matrix, and `rate` of how it changes.  why: of a factor that is not 1.
    """

    paper: str
    ours: str
    factor: str = "1"
    why: str = ""
    rate: str = "0"


@dataclass(frozen=True)
class Match:
    """What the paper has, LaTeX, of what the model has.

    ours: F, G, or H or z of `of`, its measurements from top to bottom; or an output of a function, as `feedback.mu`.

    inputs: where they are others than the map's.
    """

    equation: str
    paper: str
    ours: str
    of: tuple[str, ...] = ()
    inputs: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Map:
    """states: in the paper's order.  inputs: of the model's inputs what the paper calls them, LaTeX."""

    model: Callable[[], Model]
    states: tuple[Row, ...]
    inputs: Mapping[str, str]
    matches: tuple[Match, ...]
    noises: tuple[Row, ...] = ()
    measurements: tuple[Row, ...] = ()
