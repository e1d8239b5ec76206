"""Rules of MISRA C:2012 that the C deviates from, each with its reason: everywhere, or in lines that have these words.

A finding in any other line is counted as broken.
"""

import re
from collections import Counter
from collections.abc import Iterable
from typing import Any, NamedTuple


class Deviation(NamedTuple):
    """words: a pattern of the line; none: everywhere."""

    rule: str
    reason: str
    words: str = ""


CHOICE = r"\? [A-Z0-9_]+U? : [A-Z0-9_]+U?;$"
INSIDE = r"(?:[^()]|\([^()]*\))+"
DEVIATIONS = (
    Deviation("15.5", "a guard returns at once: what follows may rely on it, no later line writes an output"),
    Deviation("20.10", "BS_REAL joins a literal and its suffix, BS_FORM a name and its ending: printed once each"),
    Deviation(
        "5.5", "a macro gives each function the ending of its precision and form, so that two never link by mistake"
    ),
    Deviation("2.5", "the headers offer the same macros to every model, and indices of all states; no folder uses all"),
    Deviation("5.9", "a kernel's header stands in its unit's file and in the filter's, so that the call costs nothing"),
    Deviation(
        "8.9",
        "the table stands beside those that it belongs to, before the functions",
        r"^static const unsigned short varied",
    ),
    Deviation(
        "9.3", "one zero is written, and C sets the others to zero too", r"= \{ (\{ )?(\.\w+ = \{ )?BS_REAL\(0\.0\) \}"
    ),
    Deviation(
        "9.3",
        "a whole struct is copied; the tool takes it for a list",
        r"^(const )?\w+ \w+ = (\*\w+|\w+->[\w.>-]+|\w+\(&live->filter\));$",
    ),
    Deviation("10.3", "a pointer is moved by a count; the tool takes the count for what it points to", r"^\w+ \+= 8;$"),
    Deviation("10.4", "both are codes of one list", r"\? BS_MSG_\w+ : BS_MSG_\w+\);$"),
    Deviation("10.6", "one of two constants is chosen, and the type holds both", CHOICE),
    Deviation(
        "10.8",
        "two counters that turn over are ordered by their difference, read with a sign",
        rf"\(int32_t\)\({INSIDE} - {INSIDE}\)+ [<>]=? 0",
    ),
    Deviation(
        "10.8", "the larger of two counts less the smaller, which is widened", r"\(int64_t\)\([\w>-]+ - [\w>-]+\)"
    ),
    Deviation("10.8", "seconds become whole microseconds; the box keeps them below 2^31", r"\(int64_t\)\(int32_t\)\(+"),
    Deviation("10.8", "a bit is shifted by a small index that is never negative", r"U << \(unsigned int\)\("),
    Deviation("10.8", "codes that follow each other in their list", r"\(bs_event_code\)\(\(int\)BS_EVENT_LARGE \+ k\)"),
    Deviation(
        "10.8", "the place in an array of a few, by two pointers into it", r"\(uint16_t\)\(one - live->waiting\)"
    ),
    Deviation(
        "11.3",
        "a struct of nothing but counters of 32 bits is read as an array of them",
        r"= \(const uint32_t \*\)&live->counts;",
    ),
    Deviation(
        "12.3",
        "members of one type are declared together; the tool takes this for an operator",
        r"^(volatile )?\w+ \w+(\[\w+\])?, [^()]*;",
    ),
    Deviation(
        "14.1",
        "two pointers are compared; the tool takes what they point to for the loop's counter",
        r"^while \(these < end\)",
    ),
)
EVERYWHERE = {one.rule: one for one in DEVIATIONS if not one.words}


def of_finding(rule: str, line: str) -> Deviation | None:
    """That by which this line may break this rule; line: without white space before and after."""
    words = re.sub(r"\s*/\*.*", "", line).strip()
    return next((one for one in DEVIATIONS if one.rule == rule and re.search(one.words, words)), None)


def broken(of: dict[str, Any]) -> list[str]:
    """Rules that a unit breaks without a reason, and how often; of: its result, as `evidence.misra` gives it."""
    found = Counter(rule for rule, lines in by_lines(of) for line in lines if of_finding(rule, line) is None)
    return [f"{rule} x{count}" for rule, count in sorted(found.items())]


def of_folder(units: Iterable[dict[str, Any]]) -> list[tuple[Deviation, int, str]]:
    """Each that these units make use of, in the order of DEVIATIONS, how often, and one of its lines."""
    used = Counter[Deviation]()
    example: dict[Deviation, str] = {}
    for of in units:
        used.update({EVERYWHERE[rule]: count for rule, count in of["rules"].items() if rule in EVERYWHERE})
        for rule, lines in by_lines(of):
            for line in lines:
                if one := of_finding(rule, line):
                    used[one] += 1
                    example.setdefault(one, line)
    return [(one, used[one], example.get(one, "")) for one in DEVIATIONS if used[one]]


def by_lines(of: dict[str, Any]) -> list[tuple[str, list[str]]]:
    return [(rule, lines) for rule, lines in of["rules"].items() if rule not in EVERYWHERE]
