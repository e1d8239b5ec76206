"""Units: read by pint, and how they multiply.

Length, mass, time, temperature, current, amount and luminous intensity are strict.  Angle is weak: rad is a name for 1,
which is kept for messages and for functions of plain numbers.
"""

import re
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING

from boresight.errors import BoresightError, did_you_mean

if TYPE_CHECKING:
    from pint import UnitRegistry

BASE = {"kilogram": "kg", "meter": "m", "second": "s", "kelvin": "K", "ampere": "A", "mole": "mol", "candela": "cd"}
# What these are to a navigator; pint takes them for grams and thousandths of an inch.
OURS = {"g": "standard_gravity", "mg": "millistandard_gravity", "ug": "microstandard_gravity", "mil": "artillery_mil"}
PLURAL = re.compile(r"\b(rad|mrad|deg|kg)s\b")  # rads are a dose of radiation
ROOT = re.compile(r"sqrt\(([^()]*)\)")


@dataclass(frozen=True)
class Unit:
    """A product of powers of SI base units, without those of zero, in the order of BASE.

    rad: the power of rad; None where terms of different ones were added.
    """

    powers: tuple[tuple[str, Fraction], ...] = ()
    rad: Fraction | None = Fraction(0)

    def __mul__(self, other: "Unit") -> "Unit":
        if self is ONE or other is ONE:
            return other if self is ONE else self
        both = dict(self.powers)
        for base, power in other.powers:
            both[base] = both.get(base, Fraction(0)) + power
        rad = None if self.rad is None or other.rad is None else self.rad + other.rad
        return Unit(tuple((base, both[base]) for base in BASE.values() if both.get(base)), rad)

    def __pow__(self, exponent: Fraction) -> "Unit":
        if not exponent:
            return ONE
        powers = tuple((base, power * exponent) for base, power in self.powers)
        return Unit(powers, None if self.rad is None else self.rad * exponent)

    def __truediv__(self, other: "Unit") -> "Unit":
        return self * other ** Fraction(-1)

    def like(self, other: "Unit") -> bool:
        """Whether both can stand in one sum: all but angle agrees."""
        return self.powers == other.powers

    @property
    def plain(self) -> bool:
        """Whether it is that of a number which is no angle."""
        return not self.powers and not self.rad

    def __str__(self) -> str:
        every = [("rad", self.rad or Fraction(0)), *self.powers]
        over = [factor for base, power in every if power > 0 for factor in factors(base, power)]
        under = [factor for base, power in every if power < 0 for factor in factors(base, -power)]
        return "/".join(["*".join(over) or "1", *under])


def factors(base: str, power: Fraction) -> list[str]:
    """s^(3/2) as s and sqrt(s)."""
    whole, rest = divmod(power, 1)
    found = [base if whole == 1 else f"{base}^{whole}"] if whole else []
    half = f"sqrt({base})" if rest == Fraction(1, 2) else f"{base}^({rest})"
    return found + [half] * bool(rest)


ONE, SECOND, RADIAN = Unit(), Unit((("s", Fraction(1)),)), Unit((), Fraction(1))


@cache
def registry() -> "UnitRegistry":
    """pint's own units, and the mil of 6400 to a turn.  Imported and read, in 0.6 s, when a unit is first asked for."""
    from pint import UnitRegistry

    made: UnitRegistry = UnitRegistry()
    made.define("artillery_mil = 360 / 6400 * degree")
    return made


FACTOR = re.compile(rf"(sqrt\()?(1|rad|Hz|{'|'.join(BASE.values())})(?(1)\))(?:\^(\d))?")


PLAIN = {"1": ONE, "rad": RADIAN, "Hz": ONE / SECOND}


def of_base_units(text: str) -> Unit | None:
    """The unit of a text that multiplies and divides SI base units, rad and Hz alone; else None."""
    parts = ["*", *re.split(r"([*/])", text)]
    found = ONE
    for sign, part in zip(parts[::2], parts[1::2], strict=True):
        if not (read := FACTOR.fullmatch(part)):
            return None
        root, symbol, power = read.groups()
        one = PLAIN.get(symbol) or Unit(((symbol, Fraction(1)),))
        exponent = Fraction(int(power or 1), 2 if root else 1)
        found *= one ** (exponent if sign == "*" else -exponent)
    return found


@cache
def unit(text: str) -> Unit:
    """The unit of a text such as `rad/s/sqrt(s)`.

    Raises BoresightError on a unit that is unknown, and on one that is not coherent SI, with its factor.
    """
    return of_base_units(text) or by_pint(text)


def by_pint(text: str) -> Unit:
    """Of any text.  Raises BoresightError as `unit` does."""
    known = registry()
    read = re.sub(r"\b(g|mg|ug|mil)\b", lambda found: OURS[found[0]], ROOT.sub(r"(\1)**0.5", text))
    try:
        if not text.strip():
            raise ValueError("no unit")
        given = known.parse_units(read)
        multiplies = known.Quantity(0, given).to_base_units().magnitude == 0
        factor, base = known.get_base_units(given)
    except Exception as error:  # whatever pint's tokenizer raises on what is no unit
        word = next((w for w in re.findall(r"[^\W\d_]+", text) if w not in known and w not in OURS), "")
        near = did_you_mean(word, dict.fromkeys([*BASE.values(), "rad", *map(str, known)])) if word else ""
        what = f"{word!r}{near} in {text!r}" if word and word != text else f"{text!r}{near}"
        raise BoresightError(f"the unit {what} is not known; write SI units as m/s^2 or rad/sqrt(s)") from error
    exponents = {name: Fraction(str(power)).limit_denominator(24) for name, power in base._units.items()}
    rad = exponents.pop("radian", Fraction(0))
    foreign = exponents.keys() - BASE.keys()
    if foreign:
        raise BoresightError(f"the unit {text!r} counts {', '.join(sorted(foreign))}, which is no SI unit; write 1")
    found = Unit(tuple((symbol, exponents[name]) for name, symbol in BASE.items() if name in exponents), rad)
    if not multiplies:
        raise BoresightError(f"the unit {text!r} has a zero of its own; declare {found} and convert at the border")
    if abs(float(str(factor)) - 1) > 1e-12:
        number = f"{factor:.6g} {found}".removesuffix(" 1")
        meant = PLURAL.sub(r"\1", text)
        if meant != text:
            raise BoresightError(f"{text} is {number} to pint (did you mean {meant!r}?)")
        raise BoresightError(f"{text} is {number}; declare {found} and convert at the border")
    return found


def units(text: str, count: int) -> list[Unit]:
    """The unit of each of `count` components: one for all, or one for each, with commas between.

    Raises BoresightError as unit() does, and on another number of units.
    """
    listed = [part.strip() for part in text.split(",")]
    if len(listed) not in (1, count):
        numbers = f"{len(listed)} units ({text}) for {count} component{'s' * (count > 1)}"
        raise BoresightError(f"{numbers}; give one for all, or one for each")
    found = [unit(part) for part in listed]
    return found * count if len(found) == 1 else found
