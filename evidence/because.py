"""Why no call covers a line, a branch or a condition of the C, where the model's own text shows that none can.

A reason is tied to a function and to words of a line, and stands only where what it rests on is found in the folder.
"""

import itertools
import re
from collections.abc import Callable
from dataclasses import dataclass

from boresight.codegen.folder import Folder

OPEN = re.compile(
    r"(?P<function>[\w.]+), (?:condition (?P<condition>\d+) (?P<how>is never \w+|never decides alone): |`)"
)


@dataclass(frozen=True)
class Reason:
    """function, words: patterns of where it stands and of the line.  why: in words.  shown: a pattern that the C must
    have, where FUNCTION is that function.  holds: what else must hold, of the line and all C.  certain: whether no call
    can cover it, or only hardly one does."""

    function: str
    words: str
    why: str
    shown: str = ""
    certain: bool = True
    holds: Callable[[str, str], bool] = lambda line, text: True


def numbers(text: str, name: str) -> list[int]:
    """Of a table of whole numbers in the C, row by row."""
    found = re.search(rf"\b{name}(?:\[[^\]]*\])+ = (\{{.*?\}});", text, re.DOTALL)
    return [int(word) for word in re.findall(r"-?\d+", found[1])] if found else []


def last_state(line: str, text: str) -> bool:
    """Whether the number that an index is compared with is that of the last state."""
    index, states = re.search(r"\(i > (\d+)\)", line), re.search(r"#define \w+_N_STATES (\d+)", text)
    return bool(index and states and int(index[1]) + 1 == int(states[1]))


def all_angles(line: str, text: str) -> bool:
    """Whether a measurement has angles in each of its rows or in none."""
    found = re.findall(r"measurement layout = \{ \w+, \w+, (\d+), \w+, (\d+)U \};", text)
    return bool(found) and all(int(angles) in (0, 2 ** int(rows) - 1) for rows, angles in found)


def every_angle(line: str, text: str) -> bool:
    """Whether each row of each measurement is an angle."""
    found = re.findall(r"measurement layout = \{ \w+, \w+, (\d+), \w+, (\d+)U \};", text)
    return bool(found) and all(int(angles) == 2 ** int(rows) - 1 for rows, angles in found)


def states_alone(line: str, text: str) -> bool:
    """Whether no error of a sensor is varied, but of states alone."""
    varied, states = numbers(text, "varied"), re.search(r"#define \w+_N_STATES (\d+)", text)
    return bool(varied and states) and max(varied) < int(states[1] if states else 0)


def one_piece(line: str, text: str) -> bool:
    """Whether the errors that are varied of any kind of message go into one piece of its measurement, and more would
    where the line asks for that."""
    first, most = numbers(text, "varied_from"), re.search(r"#define AT_ONCE (\d+)", text)
    longest = max((b - a for a, b in itertools.pairwise(first)), default=0)
    return bool(first and most) and longest + ("k < AT_ONCE" in line) <= int(most[1] if most else 0)


def by_navigation(line: str, text: str) -> bool:
    """Whether each H is of nothing but the navigation, or constant."""
    body = re.search(r"\nstatic bs_status H_of\([^{;]*\{(.*?)\n\}", text, re.DOTALL)
    return bool(body) and not re.search(r"\bin->|\blive->", body[1] if body else "")


def all_before_end(line: str, text: str) -> bool:
    """Whether no state stands behind END."""
    end, states = re.search(r"#define END (\d+)", text), re.search(r"#define \w+_N_STATES (\d+)", text)
    return bool(end and states and end[1] == states[1])


def varied_once(line: str, text: str) -> bool:
    """Whether no error of a sensor that is varied at two instants is itself a part of what is expected."""
    sizes = [re.search(rf"#define \w+_N_{name} (\d+)", text) for name in ("STATES", "SENSED")]
    varied, first, shown = (numbers(text, name) for name in ("varied", "varied_from", "shown"))
    if not (all(sizes) and varied and first and shown):
        return False
    n, sensed = (int(size[1]) for size in sizes if size)
    return all(
        shown[kind * sensed + (what - n) % sensed] < 0
        for kind, begin in enumerate(first[:-1])
        for what in varied[begin : first[kind + 1]]
        if what >= n + sensed
    )


def asked_of_changes(line: str, text: str) -> bool:
    """Whether only kinds of messages are asked what is expected that `expect` knows: those that show a change."""
    sizes = [re.search(rf"#define \w+_N_{name} (\d+)", text) for name in ("STATES", "SENSED")]
    varied, first, changes = (numbers(text, name) for name in ("varied", "varied_from", "changes"))
    body = re.search(r"\nstatic bs_status expect\([^{;]*\{(.*?)\n\}", text, re.DOTALL)
    if not (all(sizes) and first and changes and body):
        return False
    twice = sum(int(size[1]) for size in sizes if size)
    sensors = [any(what >= twice for what in varied[a:b]) for a, b in itertools.pairwise(first)]
    asked = [bool(change) or by_sensor for change, by_sensor in zip(changes, sensors, strict=True)]
    return asked == [bool(change) for change in changes] and body[1].count("case ") == sum(asked)


SHORTEST = r"#define SHORTEST BS_REAL\(1e-06\)"
MICROSECONDS = "stamps are whole microseconds, the shortest step is one"
ALL_DELAYED = r"delayed\[\w+\] = \{ 1U(, 1U)* \};"
COPY = "units give no null pointer; the self-test's own call is another copy"
NO_KIND = "a message of no kind that there is was not admitted"
BECAUSE = (
    Reason(r"carry", r"least|return BS_OK", MICROSECONDS, SHORTEST),
    Reason(r"advance", r"span >= SHORTEST", MICROSECONDS, SHORTEST),
    Reason(
        r"admit|prepare|judge|measure",
        r"delayed\[|one->delay = BS_REAL\(0\.0\)",
        "every measurement of this model is delayed",
        ALL_DELAYED,
    ),
    Reason(
        r"expect",
        r"status == BS_OK",
        "nothing is before it",
        r"\{\n +bs_status status = BS_OK;\n +if \(status == BS_OK\)",
    ),
    Reason(
        r"\w+_H",
        r"status == BS_OK",
        "it has no argument that could be refused",
        r"status = FUNCTION_checked\(\w+_nz\);",
    ),
    Reason(
        r"\w+_live_(output|snapshot)",
        r"sequence == live->sequence",
        "sample has to interrupt it, and one context is here",
    ),
    Reason(r"step_end", r"when - live->behind", "pass() has come by all that lie behind", r"when - live->behind\) > 0"),
    Reason(r"bs_digest_\w+", r"== NULL|return BS_NULL_POINTER", COPY),
    Reason(
        r"\w+_ud_predict",
        r"for \(int k = M; k < DOWN; \+\+k\)|[XV]\[\(k \* ROW\) \+ j\] = BS_REAL\(0\.0\)",
        "the rows that move are whole blocks: none is filled",
        r"#define DOWN (\d+) [\s\S]*_N_MOVING \1 |_N_MOVING (\d+) [\s\S]*#define DOWN \2 ",
    ),
    Reason(
        r"check_sum",
        r"int i = eights|sum \+= value\[i\]",
        "the states and the numbers of P are whole eights",
        r"_N_PACKED (136|1176) ",
    ),
    Reason(
        r"assess",
        r"more > BS_REAL\(0\.0\)",
        "beyond its gate the R of a row has to rise; only rounding could say otherwise",
        r"\(nu \* nu\) > \(\(row->gate \* row->gate\) \* S\)",
        certain=False,
    ),
    Reason(
        r"bs_atan2",
        r"\(large - large\) > BS_REAL\(0\.0\)",
        "a number less itself is never above zero; it is for what a compiler may make of infinity",
    ),
    Reason(
        r"start", r"status == BS_OK", "bs_probe() passes wherever a self-test does", r"bs_status status = bs_probe\(\);"
    ),
    Reason(
        r"\w+_filter_restore",
        r"status == BS_OK",
        "what is not BS_OK has returned above",
        r"if \(status != BS_OK\) \{\n +return status;",
    ),
    Reason(
        r"H_of|judge|update",
        r"default:|return BS_OUT_OF_RANGE",
        NO_KIND,
        r"\n\w[^\n]* FUNCTION\([^{;]*\{(?:[^\n]|\n(?!\}))*default:\n +return BS_OUT_OF_RANGE;",
    ),
    Reason(
        r"expect", r"default:|return BS_OK", "it is asked of messages that show a change alone", holds=asked_of_changes
    ),
    Reason(
        r"bs_power_of_two",
        r"power < 0",
        "it scales what is left of a turn, by a negative power: no function of this model is an exponential",
        r"\A(?![\s\S]*\b(?!bs_)[a-z]\w*_(exp|sinh|cosh|tanh)\()",
    ),
    Reason(
        r"bs_reduce_large",
        r"zeros < \(32 \* \(count - 3\)\)",
        "no number lies so near to whole quarter turns: the nearest of all is bounded by continued fractions",
    ),
    Reason(r"forget", r"\(i > \d+\)", "no state stands behind the delay", holds=last_state),
    Reason(r"unwrap|linearize", r"layout->angles >>", "of a measurement with angles each row is one", holds=all_angles),
    Reason(
        r"inform",
        r"own >= 0|change\[own\] \+=",
        "no sensor that is varied at two instants shows in what is expected",
        holds=varied_once,
    ),
    Reason(
        r"inform",
        r"what < N|\(what - N\)|mean\[j\] \+= density",
        "no H of this model is made of rates: states alone are varied",
        holds=states_alone,
    ),
    Reason(
        r"measure",
        r"\? INFORM : WIDEN|k < AT_ONCE",
        "all errors that are varied go into one piece",
        holds=one_piece,
    ),
    Reason(
        r"prepare",
        r"H_of\(.*\? INFORM : WIDEN",
        "H reads the navigation alone, which the filter has taken",
        holds=by_navigation,
    ),
    Reason(
        r"spread_P|\w+_ud_predict",
        r"int j = END; j < N|times_Phi\(Phi, &(P|UD)\[column\(j\)\]",
        "no state stands behind END",
        holds=all_before_end,
    ),
    Reason(
        r"end_trial",
        r"end = BS_NOT_POSITIVE|bs_is_finite\(found->nis\)",
        "each row is an angle, which is off by half a turn at most, and its S is about R or more",
        certain=False,
        holds=every_angle,
    ),
    Reason(
        r"limit_step",
        r"bs_is_finite\(value\[i\]\)|sound\(x, P\) != BS_OK|status = BS_NOT_FINITE",
        "P is finite here: Joseph's variances are its own, and only factors near the largest numbers make another",
        r"bs_status status = sound\(x, P\);",
        certain=False,
    ),
    Reason(
        r"bs_wrap",
        r"turned >= half_turn",
        "as rounding may end: of few floats beside half turns, of no double that was tried",
        r"turned < -half_turn",
        certain=False,
    ),
)


def c_of(folder: Folder) -> str:
    """All that ships and flies."""
    return "\n".join(path.read_text() for path in folder.sources if path.parent.name != "selftest")


def argued(line: str, text: str) -> str:
    """What is open, with the reason why it cannot be covered, if one is known and the C, as one text, shows it."""
    place = OPEN.match(line)
    if place is None:
        return line
    function, rest = place["function"], line[place.end() :]
    for one in BECAUSE:
        shown = one.shown.replace("FUNCTION", function)
        meant = re.fullmatch(one.function, function) and re.search(one.words, rest)
        if meant and re.search(shown, text) and one.holds(line, text):
            return f"{line} ({one.why})"
    return line


def beyond_reach(lines: list[str]) -> dict[str, int]:
    """How many lines, branches and conditions no call can cover, of those that are open in both precisions."""
    found: dict[str, set[str]] = {"lines": set(), "branches": set(), "conditions": set()}
    for number, line in enumerate(lines):
        place = OPEN.match(line)
        if not place or not line.endswith(tuple(f" ({one.why})" for one in BECAUSE if one.certain)):
            continue
        rest = line[place.end() :]
        if place["condition"] is None:
            found["lines"].add(str(number))
            continue
        found["conditions"].add(f"{place['function']}, {place['condition']}: {rest}")
        if place["how"] != "never decides alone":
            found["branches"].add(str(number))
    return {what: len(of) for what, of in found.items()}
