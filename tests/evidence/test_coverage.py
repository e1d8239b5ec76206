"""Coverage of the self-test, and stack by the graph of calls: against cases whose answer is known."""

import json
import shutil
import subprocess
from math import pi

import pytest
from committed import LIVE, folder_of, spoilt
from mpmath import mp
from tools import needs, tool

from boresight import BoresightError
from boresight.evidence.because import argued, beyond_reach
from boresight.evidence.coverage import Decision, coverage, decisions_of, shown_alone, was
from boresight.evidence.golden import run_with_costs
from boresight.evidence.stack import FLAGS, Calls
from boresight.evidence.targets import M4F, build

T, F, NOT = 1, 0, None


def decision(*ways):
    """Of conditions that were true, false or not evaluated, and an outcome."""
    made = Decision("file.c", "function", "text", len(ways[0][0]))
    for conditions, outcome in ways:
        evaluated = sum(1 << k for k, value in enumerate(conditions) if value is not NOT)
        values = sum(1 << k for k, value in enumerate(conditions) if value)
        made.evaluations.add((evaluated, values, outcome))
    return made


@pytest.mark.parametrize(
    ("ways", "alone"),
    [
        # a && b
        ([((T, T), 1), ((T, F), 0), ((F, NOT), 0)], [True, True]),
        ([((T, T), 1), ((F, NOT), 0)], [True, False]),
        ([((T, F), 0), ((F, NOT), 0)], [False, False]),
        # a || b
        ([((T, NOT), 1), ((F, T), 1), ((F, F), 0)], [True, True]),
        ([((T, NOT), 1), ((F, T), 1)], [False, False]),
        # (a || b) && c: four ways do, the usual table; without b true, b is not shown
        ([((F, F, NOT), 0), ((T, NOT, T), 1), ((F, T, T), 1), ((F, T, F), 0)], [True, True, True]),
        ([((F, F, NOT), 0), ((T, NOT, T), 1), ((T, NOT, F), 0)], [True, False, True]),
    ],
)
def test_a_condition_is_covered_where_it_alone_decides(ways, alone):
    made = decision(*ways)
    assert [shown_alone(made, k) for k in range(made.conditions)] == alone


def test_a_branch_is_taken_where_its_condition_was_evaluated():
    made = decision(((T, T), 1), ((F, NOT), 0))
    assert [was(made, k, value) for k in (0, 1) for value in (1, 0)] == [True, True, True, False]


TABLES = """#define XX_N_STATES 3
#define XX_N_SENSED 2
static const unsigned short varied[] = { 0U, 3U, 5U, 1U };
static const unsigned short varied_from[XX_N_MEASUREMENTS + 1] = { 0U, 3U, 4U };
static const signed char shown[XX_N_MEASUREMENTS][XX_N_SENSED] = { { -1, 0 }, { 0, 0 } };
static const uint8_t delayed[XX_N_MEASUREMENTS] = { 1U, 1U };
const measurement layout = { row_start, columns, 3, XX_MEASUREMENT_EULER, 7U };
#define AT_ONCE 4
#define END 3
static bs_status H_of(int kind)
{
    switch (kind) {
    case 1:
        return xx_H(&at->nav, H);
    default:
        return BS_OUT_OF_RANGE;
    }
}
"""


@pytest.mark.parametrize(
    ("line", "before", "after"),
    [
        ("forget, condition 1 is never true: x = (i > 2) ? a : b;", "N_STATES 3", "N_STATES 4"),
        ("inform, condition 1 is never true: if (own >= 0) {", "{ -1, 0 }, {", "{ 1, 0 }, {"),
        ("unwrap, condition 1 is never false: if (((layout->angles >> i) & 1U) != 0U) {", ", 7U", ", 5U"),
        ("admit, `one->delay = BS_REAL(0.0);` is not run", "{ 1U, 1U }", "{ 1U, 0U }"),
        ("H_of, `return BS_OUT_OF_RANGE;` is not run", "default:", "case 2:"),
        ("measure, condition 1 is never true: s = (a < b) ? INFORM : WIDEN;", "0U, 3U, 4U", "0U, 5U, 6U"),
        ("measure, condition 1 is never false: for (int k = 0; (k < AT_ONCE) && a; ++k) {", "AT_ONCE 4", "AT_ONCE 3"),
        ("prepare, condition 1 is never false: s = (H_of(live) == BS_OK) ? INFORM : WIDEN;", "&at->nav", "&in->imu"),
        ("spread_P, condition 1 is never true: for (int j = END; j < N; ++j) {", "END 3", "END 2"),
        ("end_trial, condition 2 is never false: if (ok && (!bs_is_finite(found->nis))) {", ", 7U", ", 3U"),
    ],
)
def test_a_reason_stands_where_the_c_shows_it_and_is_of_that_function_alone(line, before, after):
    reason = argued(line, TABLES)
    assert reason.startswith(f"{line} (") and reason.endswith(")")
    assert argued(line, TABLES.replace(before, after)) == line != TABLES.replace(before, after)
    assert argued(f"other_{line}", TABLES) == f"other_{line}"


def test_where_states_alone_are_varied_no_sensor_is():
    line = "inform, condition 1 is never false: if (what < N) {"
    assert argued(line, TABLES) == line != argued(line, TABLES.replace("N_STATES 3", "N_STATES 6"))


def test_what_is_beyond_reach_is_counted_once_a_condition():
    """Not what has no reason, nor what only rounding reaches."""
    lines = [argued(f"forget, condition 1 is never {word}: x = (i > 2) ? a : b;", TABLES) for word in ("true", "false")]
    lines += [argued("admit, `one->delay = BS_REAL(0.0);` is not run", TABLES), "f, `g();` is not run"]
    gate = "(nu * nu) > ((row->gate * row->gate) * S)"
    lines += [argued("assess, condition 2 is never false: && (more > BS_REAL(0.0))) {", gate)]
    assert lines[-1].endswith("only rounding could say otherwise)")
    assert beyond_reach(lines) == {"lines": 1, "branches": 2, "conditions": 1}


def nearest_to_a_quarter_turn(bits, exponents):
    """The least distance of m 2^e rad from whole quarter turns, in quarter turns, over all m below 2^bits: that of the
    last convergent of 2^e times 2 / pi whose denominator is one of them."""
    least = 1
    with mp.workprec(max(exponents) + 400):
        for e in exponents:
            rest = part = mp.ldexp(2 / mp.pi, e) % 1
            q, before = 1, 0
            while (after := q * int(1 / rest) + before) < 2**bits:
                q, before, rest = after, q, 1 / rest % 1
            least = min(least, abs(part * q - mp.nint(part * q)))
    return least


def test_no_number_is_so_near_to_whole_quarter_turns_that_its_sine_runs_out_of_bits():
    """The bound of the loop of bs_reduce_large, 32 (count - 3) bits, is met by no number: a reason of coverage."""
    turns = [m * 2 / pi for m in range(1, 64)]
    assert abs(float(nearest_to_a_quarter_turn(6, [0])) - min(abs(one - round(one)) for one in turns)) < 1e-14
    assert nearest_to_a_quarter_turn(24, range(-23, 105)) > 2.0**-40 > 2.0 ** (-32 * (5 + 2 - 3))
    assert nearest_to_a_quarter_turn(53, range(-52, 972)) > 2.0**-70 > 2.0 ** (-32 * (8 + 2 - 3))


def test_what_the_self_test_leaves_out_is_seen(tmp_path):
    """Without one call with a null pointer, that condition is never true."""
    whole = coverage(folder_of(LIVE), fresh(tmp_path / "whole"))["sd_step"]
    copy = shutil.copytree(folder_of(LIVE).path, tmp_path / LIVE)
    left = "failures += (sd_step(&nav, 0, got_lon_lat_height, got_v_n, got_q_b2n_wxyz) != BS_NULL_POINTER);"
    less = coverage(spoilt(copy, "selftest/test_sd_step.c", left, ""), fresh(tmp_path / "less"))["sd_step"]
    for precision in ("double", "float"):
        (hit, of), (lines, all_lines) = whole[precision]["conditions"], whole[precision]["lines"]
        assert hit == of > 10 and lines == all_lines > 50
        assert less[precision] == whole[precision] | {"branches": [2 * of - 1, 2 * of], "conditions": [of - 1, of]}
    assert not whole["open"] and len(less["open"]) == 1
    assert less["open"][0].startswith("sd_step, condition 2 is never true: if ((nav == NULL)")


def fresh(path):
    path.mkdir()
    return path


def graph(path, nodes, edges):
    lines = [
        f'node: {{ title: "{name}" label: "{name}\\nfile.c:1:1\\n{size} bytes ({how})" }}' for name, size, how in nodes
    ]
    lines += [f'edge: {{ sourcename: "{a}" targetname: "{b}" label: "file.c:2:3" }}' for a, b in edges]
    path.write_text("\n".join(lines))
    return Calls([path])


def test_the_stack_is_that_of_the_deepest_way(tmp_path):
    nodes = [("top", 16, "static"), ("file.c:left", 100, "static"), ("right", 40, "static"), ("below", 80, "static")]
    calls = graph(
        tmp_path / "a.ci", nodes, [("top", "file.c:left"), ("top", "right"), ("right", "below"), ("below", "sqrt")]
    )
    assert {name: calls.deepest(name) for name in calls.entries()} == {"top": 136, "right": 120, "below": 80}
    assert calls.library("top") == {"sqrt"}


@pytest.mark.parametrize(
    ("nodes", "edges", "words"),
    [
        ([("a", 8, "static"), ("b", 8, "static")], [("a", "b"), ("b", "a")], "no bound"),
        ([("a", 8, "static")], [("a", "__indirect_call")], "no bound"),
        ([("a", 8, "dynamic")], [], "is dynamic"),
        ([("a", 8, "static")], [("a", "/somewhere/file.c:twin")], "a calls twin, whose stack"),
    ],
)
def test_what_has_no_bound_is_refused(nodes, edges, words, tmp_path):
    with pytest.raises(BoresightError, match=words):
        graph(tmp_path / "a.ci", nodes, edges).deepest("a")


@needs("arm-none-eabi-gcc")
def test_what_is_painted_on_an_emulated_core_is_not_above_the_bound(tmp_path):
    made = build(folder_of(LIVE), M4F, "float", tmp_path, *FLAGS)
    calls = Calls(sorted(tmp_path.rglob("*.ci")))
    _, costs = run_with_costs(made, [unit.name for unit in folder_of(LIVE).units])
    painted = {name: cost.stack for of in costs.values() for name, cost in of.items()}
    assert len(painted) > 3 and max(painted.values()) > 100
    for name, most in painted.items():
        room = 64 if calls.library(name) else 0  # memset, sqrtf and their like, which the bound leaves out
        assert most <= calls.deepest(name) + room, name


@needs("clang-19", "llvm-cov-19", "llvm-profdata-19")
def test_clang_counts_the_same_conditions_covered(tmp_path):
    """Of decisions with several conditions, which alone clang counts, file by file."""
    folder = folder_of("strapdown")
    ours: dict[str, list[int]] = {}
    for one in decisions_of(folder, folder.units, "double", tmp_path):
        if one.conditions > 1 and one.file.endswith(".c"):
            counted = ours.setdefault(one.file, [0, 0])
            counted[0] += sum(shown_alone(one, k) for k in range(one.conditions))
            counted[1] += one.conditions
    sources = [*folder.files("src/*.c"), *folder.files("selftest/*.c")]
    flags = ("-std=c99", "-O1", "-w", "-ffp-contract=off", "-fprofile-instr-generate", "-fcoverage-mapping")
    program, counts = tmp_path / "program", tmp_path / "counts"
    command = [tool("clang-19"), *flags, "-fcoverage-mcdc", f"-I{folder.include}", *sources, "-lm", "-o", program]
    subprocess.run(command, check=True)
    subprocess.run([program], env={"LLVM_PROFILE_FILE": f"{counts}.raw"}, check=True, capture_output=True)
    subprocess.run([tool("llvm-profdata-19"), "merge", "-sparse", f"{counts}.raw", "-o", counts], check=True)
    command = [
        tool("llvm-cov-19"),
        "export",
        program,
        f"-instr-profile={counts}",
        "-summary-only",
        "--show-mcdc-summary",
    ]
    (found,) = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["data"]
    theirs = {}
    for file in found["files"]:
        of, path = file["summary"]["mcdc"], file["filename"]
        if "/src/" in path and of["count"]:
            theirs[path.rsplit("/", 1)[1]] = [of["covered"], of["count"]]
    assert len(ours) > 3 and theirs == ours
