"""A paper of one's own: a folder of paper.toml, letters and conventions, and printed.tex, its equations verbatim."""

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any, ClassVar
from unicodedata import normalize

from flint import arb
from sympy import Symbol

from boresight import BoresightError
from boresight.derive.ledger.dimensions import UNKNOWN, misfits
from boresight.derive.ledger.equation import Derivation, Equation, Line, Quantity, Relation, letter
from boresight.derive.ledger.evaluate import DIGITS, Point, evaluate
from boresight.derive.ledger.frames import NONE, SAME, TURN, UPPER
from boresight.derive.ledger.frames import plain as plain_frames
from boresight.derive.ledger.judge import differs, names
from boresight.derive.ledger.lines import sound
from boresight.derive.ledger.numbers import Matrix, digits, entries
from boresight.derive.ledger.paper import Paper, Stated, Witness
from boresight.derive.ledger.reader import UnreadError, plain, read
from boresight.derive.ledger.witness import draw, scaled
from boresight.derive.letters import dotted
from boresight.derive.papers.displays import ASIDE, Display, aside
from boresight.derive.papers.files import PYTHON
from boresight.derive.papers.scenarios import Scenario, scenario
from boresight.derive.papers.source import TABLE, TEXT, VALUE, Keys, Source, check_unit, several
from boresight.derive.papers.value_frames import frame_of_value
from boresight.derive.papers.values import TIMES, ValueOfLetterError, Values, check, parsed
from boresight.errors import did_you_mean

NAME = r"[A-Za-z]\w*'?"  # of a frame
UNIT_OF_FUNCTION = {
    **dict.fromkeys(("eye", "sin", "cos", "tan", "exp", "rotation", "quaternion"), "1"),
    **dict.fromkeys(("rotation_vector", "angles", "asin", "atan", "atan2"), "rad"),
}
LARGEST = 60  # rows of a letter
POINTS = 4  # of the stated sizes, from which a remainder's size is taken


def own(folder: Path) -> Paper:
    """The paper of a folder, by itself.  Raises BoresightError with file, line and column of what is wrong in it."""
    return Folder(folder).paper()


# ---- The paper -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Bound(Mapping):
    """Values of a paper's letters: those bound to the scenario, and those that its equations define."""

    given: Values
    defined: Mapping[str, Any]
    known: dict[str, Any] = field(default_factory=dict)
    begun: set[str] = field(default_factory=set)

    def __getitem__(self, name: str) -> Any:
        if name in self.given.letters:
            return self.given.letter(name)
        if name not in self.known:
            if name not in self.defined:
                raise KeyError(f"nothing gives {name} a value")
            if name in self.begun:
                raise KeyError(f"{name} is defined by itself")
            self.begun.add(name)
            with digits(2 * DIGITS):
                self.known[name] = evaluate(self.defined[name], Point(self))
        return self.known[name]

    def __iter__(self) -> Iterator[str]:
        return iter({**self.given.letters, **self.defined})

    def __len__(self) -> int:
        return len({**self.given.letters, **self.defined})


class Folder(Source):
    """What a folder says, read once."""

    KEYS: ClassVar[Keys] = {
        "": {**Source.KEYS[""], "sizes": TABLE},
        "letters": {**Source.KEYS["letters"], "value": VALUE, "frame": TEXT},
        "equations": {**Source.KEYS["equations"], "planted": TEXT, "neglects": TEXT},
    }

    def __init__(self, folder: Path):
        super().__init__(folder)
        self.units: dict[str, str] = {}  # by letter
        self.frames: dict[str, str] = {}
        self.shown: dict[str, set[str]] = {}  # frames as the paper writes them -> those of the values
        computed = self.data.get("computed", {})
        for name, frame in computed.items():
            self.typed(frame, str, "the frame that it stands for", "computed", name)
            if not re.fullmatch(NAME, frame) or frame in computed:
                self.refuse(f"{name} stands for {frame!r}, which is no frame" + " of its own" * (frame in computed),
                            "computed", name)  # fmt: skip

    @cached_property
    def scenario(self) -> Scenario:
        try:
            return scenario(self.data["witness"])
        except BoresightError as error:
            self.refuse(f"{error}, and {PYTHON}, a file of your own", "witness")

    @cached_property
    def sizes(self) -> Any:
        """The usual sizes of the scenario, those of the file in their place."""
        known = {part.name for part in fields(self.scenario.usual)}
        given = {}
        for name, value in self.data.get("sizes", {}).items():
            if name not in known:
                self.refuse(f"{self.scenario.name} has no part {name!r}{did_you_mean(name, known)}", "sizes", name)
            numbers = value if isinstance(value, list) else [value]
            if len(numbers) not in (1, 3) or not all(isinstance(one, int | float) and one >= 0 for one in numbers):
                self.refuse(f"{name} must be a size, or three: numbers that are not negative", "sizes", name)
            given[name] = tuple(map(float, value)) if isinstance(value, list) else float(value)
        return replace(self.scenario.usual, **given)

    # ---- letters

    @cached_property
    def bound(self) -> dict[str, ast.expr]:
        """By name the expressions of the letters that have a value, with those of their rates."""
        found: dict[str, ast.expr] = {}
        for name, entry in self.data["letters"].items():
            if "value" in entry:
                found[normalize("NFC", name)] = self.expression(str(entry["value"]), "letters", name, "value")
        for name in self.data["letters"]:
            if normalize("NFC", name) in found:
                self.check(normalize("NFC", name), found, "letters", name, "value")
        if self.scenario.moves:
            still = [n for n, tree in found.items() if not timed(tree, found)]
            found |= {dotted(n): parsed_rate(n) for n in still if dotted(n) not in found}
        return found

    def expression(self, text: str, *place: str) -> ast.expr:
        """A value, as it is written there."""
        try:
            return parsed(text)
        except ValueOfLetterError as error:
            self.refuse(str(error), *place, column=error.column)

    def check(self, name: str, letters: Mapping[str, ast.expr], *place: str) -> None:
        """That a letter has a value by the scenario."""
        try:
            check(name, letters, self.scenario)
        except ValueOfLetterError as error:
            self.refuse(str(error), *place, column=error.column)

    def quantity(self, name: str, entry: Mapping[str, Any], at: Values) -> Quantity:
        """Raises BoresightError."""
        symbol = normalize("NFC", name)
        if not isinstance(entry.get("latex"), str) or not entry["latex"].strip():
            self.refuse(f"{name} has no latex: write latex = '...', as the paper prints it", "letters", name)
        named = self.scenario.names.get(str(entry.get("value", "")))
        unit = str(entry.get("unit", named.unit if named else self.unit_of_value(symbol)))
        words = str(entry.get("meaning", named.meaning if named else entry.get("value", "")))
        if "value" in entry:
            shape = self.shape_of(symbol, name, at)
            if "shape" in entry and shape != shaped(entry["shape"]):
                self.refuse(f"{name} has the shape {list(shape)} by its value, not {entry['shape']}", "letters", name)
        elif "shape" in entry:
            shape = shaped(entry["shape"])
            if not all(isinstance(size, int) and 0 < size <= LARGEST for size in shape):
                self.refuse(
                    f"{name} has the shape {entry['shape']}; a size is 1 to {LARGEST}", "letters", name, "shape"
                )
        else:
            self.refuse(f"{name} has neither a value nor a shape: write value = \"...\" by the names of "
                        f"{self.scenario.name}, or shape = 3 of what an equation defines", "letters", name)  # fmt: skip
        meaning = words + f", in {entry.get('frame')}" * ("frame" in entry)
        self.units[symbol] = unit
        if frame := self.frame_of(symbol, name, entry, shape, at):
            self.frames[symbol] = frame
        ends = f", {unit}" * (not several(unit) and unit != UNKNOWN)
        made = letter(name, self.expanded(entry["latex"]), f"{unit} {shape}", meaning + ends, shape)
        if unit != UNKNOWN:
            check_unit(self.toml, name, made, unit)
        return made

    def unit_of_value(self, symbol: str) -> str:
        """Of a letter without a unit of its own: that of its value, where it is plain."""
        return self.unit_of_node(self.bound.get(symbol), symbol)

    def unit_of_node(self, node: Any, own: str) -> str:
        def of(one: Any) -> str:
            return self.unit_of_node(one, own)

        if isinstance(node, ast.Constant):
            return "1"
        if isinstance(node, ast.Name):
            if node.id in self.data["letters"] and node.id != own:
                return str(self.data["letters"][node.id].get("unit", self.unit_of_value(node.id)))
            named = self.scenario.names.get(node.id)
            return named.unit if named else UNKNOWN
        if isinstance(node, ast.UnaryOp):
            return of(node.operand)
        if isinstance(node, ast.BinOp):
            if isinstance(node.op, ast.Add | ast.Sub):
                return of(node.left)
            bare = [not any(isinstance(one, ast.Name) for one in ast.walk(part)) for part in (node.left, node.right)]
            if isinstance(node.op, ast.Mult) and bare[0]:
                return of(node.right)
            return of(node.left) if isinstance(node.op, ast.Mult | ast.Div) and bare[1] else UNKNOWN
        if isinstance(node, ast.Subscript):
            units, at = of(node.value), node.slice
            if not several(units):
                return units
            each = units.split(", ")
            if isinstance(at, ast.Constant) and not (" by " in units or any(one[0].isdigit() for one in each)):
                return {str(i): one for i, one in enumerate(each)}.get(str(at.value), UNKNOWN)
            return UNKNOWN
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            if node.func.id in UNIT_OF_FUNCTION:
                return UNIT_OF_FUNCTION[node.func.id]
            units = of(node.args[0]) if node.args else UNKNOWN
            if node.func.id == "rate":
                return per_second(units)
            if node.func.id in ("old", "after", "before"):
                return units
            if node.func.id in ("T", "skew", "vee", "norm", "conjugate"):
                return UNKNOWN if several(units) else units
        return UNKNOWN

    def frame_of(self, symbol: str, name: str, entry: Mapping[str, Any], shape: tuple[int, ...], at: Values) -> str:
        """As Paper.frames has it: as it is declared, or as the value shows it.  Raises BoresightError."""
        if "frame" in entry:
            frame = str(entry["frame"])
            if not shape:
                self.refuse(f"{name} is a number, which stands in no frame", "letters", name, "frame")
            wanted = rf"{NAME}( to {NAME})?" if shape in ((3, 3), (4,)) else NAME
            if not re.fullmatch(wanted, frame):
                self.refuse(f"{frame!r} is no frame of a {'turn' if len(wanted) > 20 else 'vector'}",
                            "letters", name, "frame")  # fmt: skip
            return frame
        if shape not in ((3,), (3, 3), (4,)) or "value" not in entry:
            return ""
        frame = frame_of_value(symbol, at, self.scenario, shape)
        latex = plain_frames(self.expanded(entry["latex"]))
        shown = turn.groups()[:2] if (turn := TURN.search(latex)) else (up[1],) if (up := UPPER.search(latex)) else ()
        if frame == NONE and shown:  # a turn of numbers, as C_s^b
            return ""
        of = frame.split(" to ")
        of *= 2 if len(of) < len(shown) else 1  # of a turn from n to n' the value shows n
        if not frame or frame == SAME or len(shown) != len(of):
            return frame
        pairs = [*zip(shown, of, strict=True)]
        for one, other in pairs:
            self.shown.setdefault(one, set()).add(other)
        return " to ".join(one if self.stands_for(one) == other else other for one, other in pairs)

    def stands_for(self, name: str) -> str:
        return str(self.data.get("computed", {}).get(name, name.rstrip("'")))

    def drawn(self, letters: Mapping[str, ast.expr]) -> Values:
        """Values of letters at a point."""
        return Values(lambda t: self.scenario.values(draw(self.scenario.base, 1, self.scenario.sizes), t), letters)

    def shape_of(self, symbol: str, name: str, at: Values) -> tuple[int, ...]:
        try:
            value = at.letter(symbol)
        except (ValueError, TypeError, IndexError, ZeroDivisionError, KeyError) as error:
            why = "one of its functions is of another shape" if "exceeds matrix" in str(error) else error
            self.refuse(f"the value of {name} has no meaning: {why}", "letters", name, "value")
        if not all(arb(entry).is_finite() for entry in entries(value)):
            self.refuse(f"the value of {name} is not finite", "letters", name, "value")
        if not isinstance(value, Matrix):
            return ()
        return (value.rows, value.cols) if value.cols > 1 else (value.rows,)

    @cached_property
    def quantities(self) -> tuple[Quantity, ...]:
        """The declared letters, and of those with a value their rates, in each spelling."""
        with digits(DIGITS):
            at = self.drawn(self.bound)
            declared = [self.quantity(name, entry, at) for name, entry in self.data["letters"].items()]
        frames = {frame for text in self.frames.values() for frame in text.split(" to ")}
        for name, frame in self.data.get("computed", {}).items():
            if frame not in frames | self.shown.keys():
                self.refuse(f"{name} stands for {frame}, in which no letter is", "computed", name)
        for name, of in self.shown.items():
            if len(of) == 1 and name not in frames and self.stands_for(name) == name:
                self.frames[f"frame {name}"] = min(of)
        alike: dict[str, str] = {}
        for quantity in declared:
            other = alike.setdefault(plain(quantity.latex), quantity.symbol.name)
            if other != quantity.symbol.name:
                self.refuse(f"{other} and {quantity.symbol.name} are both written {quantity.latex}; which is meant?",
                            "letters", quantity.symbol.name)  # fmt: skip
        rates = []
        for quantity in declared:
            name = dotted(quantity.symbol.name)
            if name in self.bound and name not in {one.symbol.name for one in declared}:
                unit = self.units[name] = per_second(self.units[quantity.symbol.name])
                if quantity.symbol.name in self.frames:
                    self.frames[name] = self.frames[quantity.symbol.name]
                for latex in dotted_latex(quantity.latex):
                    if plain(latex) not in alike:
                        ends = f", {unit}" * (not several(unit) and unit != UNKNOWN)
                        meaning = f"rate of {quantity.symbol.name}{ends}"
                        rates.append(letter(name, latex, f"{unit} {quantity.shape}", meaning, quantity.shape))
        return (*declared, *rates)

    # ---- equations

    @cached_property
    def prints(self) -> dict[str, tuple[Display, tuple[Relation, ...]]]:
        found, letters = {}, self.quantities
        for one in self.displays:
            found[one.number] = one, self.read(one, [ASIDE.sub("", latex) for latex in one.latex], letters)
        for name in {name for _, relations in found.values() for name in names(relations)}:
            if block := BLOCK.fullmatch(name):
                rows, columns = int(block["rows"]), int(block["columns"])
                self.bound[name] = parsed(f"eye({rows})" if block["what"] == "I" else f"zeros({rows}, {columns})")
        self.check_numbers(found)
        return found

    @cached_property
    def defined(self) -> dict[str, str]:
        """By name the number of the equation that defines a letter: the first in which it stands alone on the left."""
        found: dict[str, str] = {}
        for number, (_, relations) in self.prints.items():
            for relation in relations:
                name = letter_of(relation.sides[0])
                if name and name not in self.bound:
                    found.setdefault(name, number)
        by = {name: self.made_of(name, number) & found.keys() for name, number in found.items()}
        for name, number in found.items():
            reached, left = set[str](), [name]
            while left:
                new = by[left.pop()] - reached
                reached |= new
                left += new
            if name in reached:
                through = "" if name in by[name] else f", through {', '.join(sorted(reached - {name}))}"
                what = f"({number}) would define {name} by itself{through}"
                self.refuse(f'{what}: write value = "...", or give what it becomes a letter of its own, as P^+',
                            "letters", name)  # fmt: skip
        for number, (_, relations) in self.prints.items():
            for name in sorted(names(relations)):
                if name not in self.bound and name not in found:
                    self.refuse(f"{name} of ({number}) has no value: write value = \"...\", or print the equation that "
                                f"defines it", "letters", name)  # fmt: skip
        return found

    def made_of(self, name: str, number: str) -> set[str]:
        """The letters that the equation of this number makes the letter of."""
        _, relations = self.prints[number]
        of = next(one for one in relations if letter_of(one.sides[0]) == name)
        return names([replace(of, sides=of.sides[1:])])

    def equations(self, name: str) -> tuple[Equation, ...]:
        found = []
        for number, (display, relations) in self.prints.items():
            more = self.equation_rows.get(number, {})
            lines, refused = self.lines[number]
            results = tuple(line.relation for line in lines if line.result and line.relation is not None)
            if results and len(lines) == len(results) and results == relations:
                lines, results = (), ()
                refused = "its only step is what is printed; give the steps that lead there"
            used = names([relation for line in lines for relation in line.formulas])
            for part in more.get("small", ()):
                if part not in self.scenario.errors:
                    near = did_you_mean(part, self.scenario.errors)
                    self.refuse(f"{self.scenario.name} has no error {part!r}{near}", "equations", number, "small")
            spelled = " ".join(map(plain, display.latex))
            here = [one for one in self.used if plain(one.latex) in spelled]
            planted = f"Planted: {more['planted']}." if "planted" in more else ""
            if "neglects" in more and len(relations) > 1:
                what = "it has several relations; give each a number of its own"
                self.refuse(f"({number}): {what}", "equations", number, "neglects")
            found.append(
                Equation(
                    paper=name,
                    number=number,
                    latex=display.latex,
                    lines=display.lines,
                    printed=relations,
                    derived=results or relations,
                    derivation=Derivation(lines),
                    defines=tuple(
                        symbol
                        for relation in relations
                        if self.defined.get(letter_of(symbol := relation.sides[0])) == number
                    ),
                    small=tuple(more.get("small", ())),
                    neglected=self.term(more["neglects"], number) if "neglects" in more else None,
                    refused=refused,
                    note=" ".join(filter(None, (planted, more.get("note", "")))),
                    quantities=(*self.used, *here),
                    step_letters=tuple(one for one in self.quantities if one.symbol.name in used),
                )
            )
        return tuple(found)

    def term(self, latex: str, number: str) -> Any:
        """What an equation neglects, in the letters of the paper."""
        try:
            (relation,) = read((latex,), self.quantities)
            (side,) = relation.sides
        except (UnreadError, ValueError) as error:
            at = f" at {error.text[error.at : error.at + 20]!r}" if isinstance(error, UnreadError) else ""
            self.refuse(f"({number}): cannot read {latex!r}{at} as a term", "equations", number, "neglects")
        return side

    @cached_property
    def lines(self) -> dict[str, tuple[tuple[Line, ...], str]]:
        """By number the steps of an equation; none, and why, where one cannot be read."""

        def of(number: str) -> tuple[tuple[Line, ...], str]:
            try:
                return self.steps.of(number, self.quantities, self.scenario.errors), ""
            except BoresightError as error:
                return (), str(error)

        return {number: of(number) for number in self.prints}

    @cached_property
    def step_letters(self) -> tuple[Quantity, ...]:
        """The rates that stand in derivations alone."""
        text = " ".join(plain(self.steps.expanded(latex)) for latex in self.steps.latex)
        print_has = {one.symbol.name for one in self.used}
        rates = [one for one in self.quantities if one.symbol.name not in print_has]
        named = {one.symbol.name for one in rates if plain(one.latex) in text}
        named |= names([one for lines, _ in self.lines.values() for line in lines for one in line.formulas])
        return tuple(one for one in rates if one.symbol.name in named)

    @cached_property
    def used(self) -> tuple[Quantity, ...]:
        """The declared letters, and the rates that stand in the print."""
        every = {name for _, relations in self.prints.values() for name in names(relations)}
        declared = len(self.data["letters"])
        blocks = [block for name in sorted(every) if (block := BLOCK.fullmatch(name))]
        return (
            *self.quantities[:declared],
            *(one for one in self.quantities[declared:] if one.symbol.name in every),
            *(block_letter(*block.groups()) for block in blocks if block[0] not in self.data["letters"]),
        )

    @cached_property
    def felt(self) -> tuple[str, ...]:
        """The errors of the scenario with which a letter of the print, or of a step, changes."""
        every = {name for _, relations in self.prints.values() for name in names(relations)}
        every |= names([one for lines, _ in self.lines.values() for line in lines for one in line.formulas])
        every &= self.bound.keys()

        def at(sizes: Any) -> Values:
            base = draw(self.scenario.base, 1, sizes)
            return Values(lambda t: self.scenario.values(base, t), self.bound)

        with digits(DIGITS):
            whole = at(self.scenario.sizes)

            def changes(part: str) -> bool:
                half = at(scaled(self.scenario.sizes, 0.5, (part,)))
                return any(differs(whole.letter(name), half.letter(name)) for name in every)

            return tuple(part for part in self.scenario.errors if changes(part))

    # ---- all of it

    def paper(
        self, inputs: Mapping[str, ast.expr] = MappingProxyType({}), beside: tuple[Quantity, ...] = (), **more: Any
    ) -> Paper:
        """inputs: values beside those of the letters.  beside: letters of them.  more: parts of a Paper."""
        name = self.folder.resolve().name
        owned = self.scenario
        self.defined  # noqa: B018  refuses here what has no value

        def values(base: Any, definitions: Mapping[str, tuple[Relation, ...]]) -> Bound:
            sides = {
                relation.sides[0].name: relation.sides[1]
                for relations in definitions.values()
                for relation in relations
                if letter_of(relation.sides[0]) in self.defined
            }
            return Bound(Values(lambda t: owned.values(base, t), {**self.bound, **inputs}), sides)

        def odd_units() -> tuple[str, ...]:
            return tuple(f"The units of ({number}) do not fit: {why}." for number, _, why in misfits(made)[1])

        left_out = {
            number: text for number, (display, _) in self.prints.items() if (text := aside(r" \\ ".join(display.latex)))
        }
        errors = self.felt
        sizes = (f"{owned.parts[one]} {size_text(getattr(self.sizes, one), owned.units[one])}" for one in errors)
        text = ", ".join(sizes) or owned.words
        made = Paper(
            name=name,
            reference=self.reference,
            make_equations=lambda: self.equations(name),
            quantities=lambda: self.used,
            letters=lambda: (*self.step_letters, *beside),
            witness=Witness(owned.base, values, owned.sizes, errors, owned.words, owned.parts, left_out),
            conditions=Stated(self.sizes, text, POINTS),
            point=Stated(draw(owned.base, POINTS, self.sizes), f"a point with {text}" if errors else text),
            evidence=lambda number: "",
            findings=odd_units,
            frames=self.frames,
            computed=self.data.get("computed", {}),
            units={name: unit for name, unit in self.units.items() if several(unit) or unit == UNKNOWN},
            conventions=tuple(self.data.get("conventions", ())),
            folder=str(self.folder),
            labels=self.labels,
            **more,
        )
        self.check_shapes(made)
        return sound(made)

    def check_shapes(self, made: Paper) -> None:
        """That a letter which an equation defines has the shape that it is declared with."""
        shapes = {one.symbol.name: one.shape for one in self.quantities}
        with digits(DIGITS):
            values = made.witness.values(made.point.at, made.definitions)
            for name, number in self.defined.items():
                try:
                    value = values[name]
                except (KeyError, ValueError, ZeroDivisionError):  # which the equation's row says
                    continue
                found = shaped([value.rows, value.cols]) if isinstance(value, Matrix) else ()
                if found != shapes[name]:
                    self.refuse(f"({number}) gives {name} the shape {list(found)}, not {list(shapes[name])}",
                                "letters", name, "shape")  # fmt: skip


BLOCK = re.compile(r"(?P<what>[0I])_(?P<rows>\d+)x(?P<columns>\d+)")


def block_letter(what: str, rows: str, columns: str) -> Quantity:
    """A block of zeros, or an identity, as the reader calls it."""
    meaning = "zeros" if what == "0" else "identity"
    latex = rf"{what}_{{{rows} \times {columns}}}"
    return letter(f"{what}_{rows}x{columns}", latex, "block", meaning, (int(rows), int(columns)))


def letter_of(side: Any) -> str:
    """The letter that stands alone on a side; a × b has a name too, which is that of the product."""
    return str(side.name) if isinstance(side, Symbol) else ""


def shaped(shape: Any) -> tuple[int, ...]:
    sizes = tuple(shape) if isinstance(shape, list) else (shape,)
    return () if sizes in ((1,), (1, 1)) else sizes[:1] if sizes[1:] == (1,) else sizes


def size_text(size: Any, unit: str) -> str:
    """1e-06 rad, 1e-06 rad, 5 m."""
    if not isinstance(size, tuple):
        return f"{size:g} {unit}"
    units = unit.split(", ") if "," in unit else [unit] * 3
    return ", ".join(f"{one:g} {own}" for one, own in zip(size, units, strict=True))


def timed(tree: ast.expr, letters: Mapping[str, ast.expr]) -> bool:
    """Whether an expression, or one that it names, is of another time."""
    named = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    return bool(named & set(TIMES)) or any(
        timed(letters[name], {k: v for k, v in letters.items() if k != name}) for name in named & letters.keys()
    )


def parsed_rate(name: str) -> ast.expr:
    return ast.Call(ast.Name("rate"), [ast.Name(name)], [])


RATES = tuple(  # of a letter, beside a dot
    form.replace("d", d) for d in ("d", r"{\rm d}", r"\mathrm{d}")
    for form in (r"\frac{d %s}{d t}", r"\frac{d}{d t} %s", r"d %s / d t")
)  # fmt: skip


def dotted_latex(latex: str) -> tuple[str, ...]:
    """How a rate may be printed; the last is written where the print is not at hand."""
    scripts = re.search(r"(?<!\\)[_^]", latex)
    at = scripts.start() if scripts else len(latex)
    stem, rest = latex[:at].strip(), latex[at:]
    found = [form % latex for form in RATES]
    found += [rf"\dot{{{latex}}}", rf"\dot{{{stem}}}{rest}"]
    if error := re.fullmatch(r"(\\[Dd]elta)(?![A-Za-z])\s*(.+)", stem):
        found += [rf"\dot{{{error[1]}}} {error[2]}{rest}", rf"{error[1]} \dot{{{error[2]}}}{rest}"]
    return tuple(dict.fromkeys(found))


def per_second(unit: str) -> str:
    if unit == UNKNOWN:
        return unit
    if several(unit):
        rows, word, columns = re.split("( by | times |$)", unit, maxsplit=1)
        counted = (re.fullmatch(r"(\d+ )?(.*)", part) for part in rows.split(", "))
        return ", ".join((one[1] or "") + per_second(one[2]) for one in counted if one) + word + columns
    if power := re.fullmatch(r"(.*/s)(?:\^(\d))?", unit):
        return f"{power[1]}^{int(power[2] or 1) + 1}"
    return f"{unit}/s"
