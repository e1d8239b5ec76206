"""A model with some of its measurements, as a user chooses them for an export."""

from dataclasses import replace
from typing import TYPE_CHECKING

from boresight.errors import BoresightError, did_you_mean

if TYPE_CHECKING:
    from boresight.derive.model import Model


def with_only(model: "Model", names: tuple[str, ...]) -> "Model":
    """The model without its other measurements; states, inputs and their structs stay, so that no other text changes.

    Raises BoresightError on a name that is no measurement, and where the model's own checks refuse what is left.
    """
    known = [m.name for m in model.measurements]
    for name in names:
        if name not in known:
            there = f"there are {', '.join(known)}" if known else "it has none"
            raise BoresightError(
                f"--only: {model.name} has no measurement {name!r}{did_you_mean(name, known)}; {there}"
            )
    gone = {f"{name}_{part}" for name in known if name not in names for part in ("z", "h", "H")} - {*names}
    left = [m for m in model.measurements if m.name in names]
    held_by = {m.name: m.first_order and m.first_order.of for m in left}  # another one's h, which `verify` alone reads
    return replace(
        model,
        measurements=tuple(replace(m, first_order=None) if held_by[m.name] not in (None, *names) else m for m in left),
        unheld=tuple((name, reason) for name, reason in model.unheld if name not in gone),
    )
