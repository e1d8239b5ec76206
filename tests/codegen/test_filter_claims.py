"""Sentences of the filter's header, held against the C: how an adopter found them wrong."""

import re

import pytest
from building import c_files, run

from boresight.runtime.arguments import MOST_ITERATIONS
from boresight.runtime.compiler import PRECISIONS, compile_sources
from boresight.runtime.manifest import folder_of

MODEL = "azimuth-hold"
BEGIN = """
#include <stdio.h>
#include <string.h>
#include "azimuth_hold_filter.h"
static ah_filter f, g;
static unsigned char bytes[AH_SNAPSHOT_SIZE];
static void seal(void)
{
    unsigned int crc = 0xFFFFFFFFU;
    for (int i = 0; i < 8 * (AH_SNAPSHOT_SIZE - 4); ++i) {
        crc = (crc >> 1) ^ (0xEDB88320U & (0U - ((crc ^ (bytes[i / 8] >> (i % 8))) & 1U)));
    }
    for (int i = 0; i < 4; ++i) bytes[AH_SNAPSHOT_SIZE - 4 + i] = (unsigned char)(~crc >> (8 * i));
}
int main(void)
{
    const ah_nav nav = { { 0, BS_REAL(0.7), 100 }, { 0, 0, 0 }, { 1, 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
    bs_real sigma[AH_N_STATES] = { 0 };
"""
CEILINGS = """
    const unsigned char considered[AH_N_STATES] = { 0, 0, 0, 1, 1 };
    unsigned long long seed = 1;
    unsigned int met = 0;
    ah_innovation innovation;
    ah_health health;
    for (int i = 3; i < 6; ++i) sigma[i] = BS_REAL(1e5);
    for (int k = 0; (k < 20000) && (met == 0); ++k) {
        bs_real R[3];
        seed = (seed * 6364136223846793005ULL) + 1;
        for (int i = 0; i < 3; ++i) R[i] = BS_REAL(1e9) * (bs_real)(1 + ((seed >> (20 + 5 * i)) & 0xffff));
        if (ah_filter_init_sigmas(&f, &nav, sigma) != BS_OK) return 1;
        if (ah_filter_consider(&f, considered) != BS_OK) return 2;
        if (ah_filter_measure_zupt(&f, R, NULL, &innovation) == BS_AT_CEILING) ++met;
    }
    (void)ah_filter_health(&f, &health);
    printf("%u %u", met, health.ceilings);
    return 0;
}
"""
ITERATIONS = """
    const int asked[4] = { 0, BS_MOST_ITERATIONS, BS_MOST_ITERATIONS + 1, 2147483647 };
    const bs_real R[3] = { 1, 1, 1 };
    ah_innovation innovation;
    for (int i = 0; i < AH_N_STATES; ++i) sigma[i] = BS_REAL(1e-3);
    if (ah_filter_init_sigmas(&f, &nav, sigma) != BS_OK) return 1;
    for (int k = 0; k < 4; ++k) {
        const bs_gates gates = { BS_ALL_ROWS, 0, 0, asked[k], 0U };
        printf("%d ", (int)ah_filter_measure_zupt(&f, R, &gates, &innovation));
    }
    return 0;
}
"""
RESTORE = """
    const bs_real covariance = 1;
    const size_t at = BS_SNAPSHOT_HEAD + sizeof(ah_nav) + sizeof(f.x) + (13 * sizeof(bs_real));
    bs_real dense[AH_N_STATES * AH_N_STATES];
    for (int i = 0; i < AH_N_STATES; ++i) sigma[i] = BS_REAL(1e-3);
    (void)ah_filter_init_sigmas(&f, &nav, sigma);
    (void)ah_filter_snapshot(&f, bytes);
    memcpy(&bytes[at], &covariance, sizeof(covariance));
    seal();
    printf("%d ", (int)ah_filter_restore(&g, bytes));
    (void)ah_filter_covariance(&g, dense);
    printf("%d", (int)ah_filter_init(&f, &nav, dense));
    return 0;
}
"""

TRAPPED = """
    bs_real R[3] = { 1, 1, 1 };
    bs_gates gates = { BS_ALL_ROWS, 0, 0, 0, 0U };
    ah_nav other = nav;
    ah_innovation innovation;
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    for (int i = 0; i < AH_N_STATES; ++i) sigma[i] = BS_REAL(1e-3);
    printf("%d ", (int)ah_filter_init_sigmas(&f, &nav, sigma));
    for (int i = 0; i < 2; ++i) {
        const bs_real bad = (bs_real)((i == 0) ? NAN : INFINITY);
        other.v_n[0] = bad;
        printf("%d %d ", (int)ah_filter_set_nav(&f, &other, BS_REFUSE), (int)ah_filter_set_nav(&f, &other, BS_CLAMP));
        R[0] = bad;
        printf("%d ", (int)ah_filter_measure_zupt(&f, R, &gates, &innovation));
        R[0] = BS_REAL(1.0);
        gates.joint = bad;
        printf("%d ", (int)ah_filter_measure_zupt(&f, R, &gates, &innovation));
        gates.joint = BS_REAL(0.0);
        sigma[0] = bad;
        printf("%d ", (int)ah_filter_init_sigmas(&f, &nav, sigma));
    }
    return 0;
}
"""


@pytest.fixture(scope="module")
def objects(tmp_path_factory):
    """precision -> the compiler as a command, and what it has made of the model."""
    made = {}
    for precision, flags in PRECISIONS.items():
        command = ["cc", "-std=c99", "-O0", "-ffp-contract=off", *flags, "-I", folder_of(MODEL) / "include"]
        sources = dict.fromkeys(c_files(folder_of(MODEL), "src"), ())
        made[precision] = command, compile_sources(command, sources, tmp_path_factory.mktemp(precision)).values()
    return made


def answer(body, objects, tmp_path, precision="double", before=""):
    (tmp_path / "main.c").write_text(before + BEGIN + body)
    command, library = objects[precision]
    done = run(*command, tmp_path / "main.c", *library, "-lm", "-o", tmp_path / "main")
    assert done.returncode == 0, done.stderr
    return run(tmp_path / "main").stdout.split()


@pytest.mark.parametrize("precision", PRECISIONS)
def test_a_measurement_that_ends_at_the_ceiling_is_counted(precision, objects, tmp_path):
    assert answer(CEILINGS, objects, tmp_path, precision) == ["1", "1"]


@pytest.mark.parametrize("precision", PRECISIONS)
def test_a_measurement_of_more_linearisations_than_the_header_allows_is_refused(precision, objects, tmp_path):
    assert answer(ITERATIONS, objects, tmp_path, precision) == ["0", "0", "3", "3"]
    header = (folder_of(MODEL) / "include/boresight_filter.h").read_text()
    assert f"#define BS_MOST_ITERATIONS {MOST_ITERATIONS} " in header


def test_restore_judges_the_diagonal_alone_and_its_header_says_so(objects, tmp_path):
    assert answer(RESTORE, objects, tmp_path) == ["0", "5"]
    header = (folder_of(MODEL) / "include/azimuth_hold_filter.h").read_text()
    words = re.sub(r"[\s*]+", " ", header)
    assert "judges the numbers as a step does" in words
    assert "as init does" not in words


@pytest.mark.parametrize("precision", PRECISIONS)
def test_nothing_traps_where_invalid_operations_do(precision, objects, tmp_path):
    traps = "#define _GNU_SOURCE\n#include <fenv.h>\n"
    assert answer(TRAPPED, objects, tmp_path, precision, traps) == ["0", *["2"] * 10]


def test_no_function_of_a_file_is_defined_twice():
    """As a merge of two branches once left it: no filter compiled."""
    for path in sorted(folder_of(MODEL).parent.glob("*/src/*.c")):
        defined = re.findall(r"^static [a-z_ ]+?\**(\w+)\([^;{]*\)\n\{", path.read_text(), re.M)
        assert len(defined) == len(set(defined)), path
