"""What an update in double keeps of the sigmas, by the form and by how many states a row of H sees.

The C of a model with six states, from a coarse start through accurate measurements, against P - g g' / S in 60 digits:
`python tests/codegen/test_joseph_rows.py` prints the table of docs/covariance.md.
"""

import functools

import mpmath as mp
import numpy as np
from test_covariance import Loops

TRIALS, FEW, UPDATES, R = 20, 7, 24, 1e-4  # trials of the table, and of the tests
ROWS = {
    "one element": lambda rng, sigma: np.eye(len(sigma))[rng.integers(len(sigma))] * rng.standard_normal(),
    "all, of one size": lambda rng, sigma: rng.standard_normal(len(sigma)),
    "all, of one size per sigma": lambda rng, sigma: rng.standard_normal(len(sigma)) / sigma,
}


def plain(P, h):
    """P - K g', of which one triangle is kept."""
    g = P @ h
    upper = np.triu(P - np.outer(g / (h @ g + R), g))
    return upper + np.triu(upper, 1).T


def worst(loops, row, top, seed):
    """The largest relative error of a sigma in Joseph's two products, in P - K g' and in U D U'."""
    rng = np.random.default_rng(seed)
    sigma = 10 ** rng.uniform(-1, np.log10(top), loops.n)
    turn = np.linalg.qr(rng.standard_normal((loops.n, loops.n)))[0]
    P = (turn * rng.uniform(0.5, 2, loops.n)) @ turn.T * np.outer(sigma, sigma)
    P = np.triu(P) + np.triu(P, 1).T
    packed = {form: loops.init(form, P)[1] for form in ("joseph", "ud")}
    simple, x = P, np.zeros(loops.n)
    with mp.workdps(60):
        exact = mp.matrix(P.tolist())
        for _ in range(UPDATES):
            h = ROWS[row](rng, sigma)
            for form, numbers in packed.items():
                loops.update(form, numbers, x, h, 0.0, R)
            simple, H = plain(simple, h), mp.matrix(h.tolist())
            g = exact * H
            exact -= g * g.T / ((H.T * g)[0] + R)
        left = np.array([float(mp.sqrt(exact[i, i])) for i in range(loops.n)])
    found = [loops.dense("joseph", packed["joseph"]), simple, loops.dense("ud", packed["ud"])]
    return [np.abs(np.sqrt(np.maximum(np.diag(P), 0)) / left - 1).max() for P in found]


@functools.cache
def medians(row, top, trials):
    loops = Loops("euler-matching")
    return np.median([worst(loops, row, top, seed) for seed in range(trials)], axis=0)


def test_two_products_pay_where_a_row_sees_one_state_and_hardly_where_it_sees_all():
    for top in (1e2, 1e4):
        one, *dense = (medians(row, top, FEW) for row in ROWS)
        assert one[0] < one[1] / 30
        for joseph, simple, _ in dense:
            assert simple / 50 < joseph < 5 * simple


def test_the_factors_keep_sigmas_to_rounding_whatever_a_row_sees():
    """As far as the conditioning of the start lets them: that of its factors is part of it."""
    for row in ROWS:
        assert medians(row, 1e4, FEW)[2] < 1e-14


if __name__ == "__main__":
    print(f"{'a row of H sees':28} {'sigmas to':>9} {'two products':>13} {'P - K g':>10} {'U D U':>10}")
    for name in ROWS:
        for most in (1e2, 1e3, 1e4):
            print(f"{name:28} {most:9.0e} " + " ".join(f"{value:11.1e}" for value in medians(name, most, TRIALS)))
