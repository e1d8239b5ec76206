"""A paper of one's own whose letters have their values by its own witness.py: read as the papers that come with
Boresight are."""

import re
import traceback
from collections import ChainMap
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any, NoReturn

from flint import arb, fmpq

from boresight.derive.ledger.dimensions import misfits
from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.judge import names
from boresight.derive.ledger.lines import sound
from boresight.derive.ledger.numbers import Matrix, digits, entries, eye, zeros
from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.ledger.witness import draw
from boresight.derive.papers.built_in import BuiltIn
from boresight.derive.papers.files import FILES, PYTHON
from boresight.derive.papers.own import BLOCK, block_letter, shaped
from boresight.derive.papers.toml import Toml, text_of
from boresight.derive.user_file import explain, run
from boresight.derive.where import line_of
from boresight.errors import BoresightError, did_you_mean

GIVES = {"WITNESS": Witness, "SIZES": Stated, "POINT": Stated}
UNDEFINED = (KeyError, ValueError, ZeroDivisionError)  # what a definition may make that does not define


def has_witness(folder: Path) -> bool:
    """Whether paper.toml names witness.py: only then is it run."""
    return Toml(folder / FILES[0]).data.get("witness") == PYTHON


def with_witness(folder: Path) -> Paper:
    """The paper of a folder.  Raises BoresightError with file and line of what is wrong in it."""
    return OwnWitness(folder).paper()


class OwnWitness(BuiltIn):
    def __init__(self, folder: Path):
        self.file = folder / PYTHON
        super().__init__(folder.resolve().name, folder, lambda name: self.module())
        self.check_module()

    def module(self) -> Any:
        if not self.file.is_file():
            self.refuse(f"{self.file} is not there; it gives {', '.join(GIVES)}", "witness")
        return run(self.file.resolve())

    def wrong(self, name: str, what: str) -> NoReturn:
        """At the line that gives a name."""
        text = text_of(self.file)
        found = re.search(rf"^{name}\b", text, re.MULTILINE)
        line = 1 + text.count("\n", 0, found.start() if found else 0)
        raise BoresightError(f"{line_of(str(self.file), line)}: {what}")

    def check_module(self) -> None:
        """That it gives what is asked for."""
        for name, kind in GIVES.items():
            if not hasattr(self.computed, name):
                near = did_you_mean(name, filter(str.isupper, vars(self.computed)))
                self.wrong(name, f"{name} is missing{near}; it is a {kind.__name__} of boresight.derive.ledger.paper")
            if not isinstance(value := getattr(self.computed, name), kind):
                self.wrong(name, f"{name} is a {type(value).__name__}, not a {kind.__name__}")
        witness, sizes, point = (getattr(self.computed, name) for name in GIVES)
        for name, given in (("WITNESS", witness.wide), ("SIZES", sizes.at)):
            try:
                draw(witness.base, 1, given)
            except (AttributeError, TypeError, ValueError) as error:
                self.wrong(name, f"no point can be drawn by the sizes of {name}: {error}")
        if not isinstance(point.at, witness.base):
            self.wrong("POINT", f"POINT is at a {type(point.at).__name__}, not at a {witness.base.__name__}")
        for part in witness.errors:
            if not hasattr(point.at, part):
                where = f"{witness.base.__name__}{did_you_mean(part, vars(point.at))}"
                self.wrong("WITNESS", f"WITNESS has the error {part!r}, which is no part of {where}")

    def beside(self, name: str) -> None:
        """flown.py and consequences.py are of the papers that come with Boresight."""

    # ---- letters

    @cached_property
    def quantities(self) -> tuple[Quantity, ...]:
        """Those of paper.toml, and the blocks that stand in the print."""
        known = {one.symbol.name for one in self.declared}
        found = (self.read(one, one.latex, self.declared) for one in self.displays)
        blocks = {name: BLOCK.fullmatch(name) for relations in found for name in names(relations)}
        more = (block_letter(*one.groups()) for name, one in blocks.items() if one and name not in known)
        return (*self.declared, *more)

    @cached_property
    def blocks(self) -> dict[str, Matrix]:
        found = (BLOCK.fullmatch(one.symbol.name) for one in self.quantities)
        return {
            one[0]: eye(int(one["rows"])) if one["what"] == "I" else zeros(int(one["rows"]), int(one["columns"]))
            for one in found
            if one
        }

    def values(self, base: Any, definitions: Mapping[str, tuple[Relation, ...]]) -> Mapping[str, Any]:
        try:
            found = self.computed.WITNESS.values(base, definitions)
        except (BoresightError, *UNDEFINED):
            raise
        except (Exception, SystemExit) as error:
            explain(error, self.file.resolve())
        if not isinstance(found, Mapping):
            self.wrong("WITNESS", f"the values of WITNESS are a {type(found).__name__}, not a dict by letter")
        if isinstance(found, dict):
            found = {name: arb(value) if isinstance(value, float) else value for name, value in found.items()}
        return ChainMap(found, self.blocks)  # type: ignore[arg-type]

    def check_values(self, made: Paper) -> None:
        """That each letter of the print has a value, of its shape."""
        with digits(DIGITS):
            base = draw(made.witness.base, 1, made.witness.wide)
            found, again = (self.asked(lambda: made.witness.values(base, made.definitions), made) for _ in range(2))
            used = {name: one.number for one in reversed(made.equations) for name in names(one.printed)}
            for quantity in made.quantities() if found is not None and again is not None else ():
                name = quantity.symbol.name
                if name in used and name not in set(found):
                    self.wrong("WITNESS", f"{name} of ({used[name]}) has no value{did_you_mean(name, set(found))}")
                if name in used and not quantity.function:
                    value, other = (self.asked(partial(one.__getitem__, name), made) for one in (found, again))
                    self.check_value(quantity, value)
                    if value is not None and [*map(str, entries(value))] != [*map(str, entries(other))]:
                        self.wrong("WITNESS", f"{name} is another one when it is asked for again; draw it in Base")

    def check_value(self, quantity: Quantity, value: Any) -> None:
        name = quantity.symbol.name
        if not isinstance(value, int | float | arb | fmpq | Matrix | None):
            self.wrong("WITNESS", f"{name} is a {type(value).__name__}, neither a number nor a Matrix")
        shape = shaped([value.rows, value.cols]) if isinstance(value, Matrix) else ()
        if value is not None and shape != shaped(list(quantity.shape) or 1):
            self.wrong("WITNESS", f"{name} has the shape {list(shape)}, in {FILES[0]} {list(quantity.shape)}")

    def asked(self, make: Callable[[], Any], made: Paper) -> Any:
        """What is made; None where the paper's own definitions may be why it cannot be made."""
        try:
            return make()
        except BoresightError:
            raise
        except Exception as error:
            last = Path(traceback.extract_tb(error.__traceback__)[-1].filename)
            if isinstance(error, UNDEFINED) and made.definitions and last != self.file.resolve():
                return None
            explain(error, self.file.resolve())

    # ---- all of it

    def paper(self) -> Paper:
        def odd_units() -> tuple[str, ...]:
            return tuple(f"The units of ({number}) do not fit: {why}." for number, _, why in misfits(made)[1])

        plain = super().paper()
        made = replace(
            plain,
            witness=replace(plain.witness, values=self.values),
            findings=odd_units,
            folder=str(self.folder),
        )
        self.check_values(made)
        return sound(made)
