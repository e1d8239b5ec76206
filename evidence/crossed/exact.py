"""The numbers of the cross-checks in 50 digits, from their definitions: nothing of ours and of no peer is in them."""

from collections.abc import Callable, Sequence
from typing import Any

from mpmath import mp

DIGITS = 50
Matrix = Any  # of mpmath

# WGS-84, and normal gravity on it, as NGA.STND.0036 prints them.
AXIS, FLATTENING, RATE = "6378137", "298.257223563", "7.292115e-5"
EQUATOR, POLE, GM = "9.7803253359", "9.8321849379", "3.986004418e14"


def skew(v: Any) -> Matrix:
    return mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def cross(a: Any, b: Any) -> Matrix:
    return skew(a) * b


def rotation(vector: Any) -> Matrix:
    """Rodrigues' formula."""
    angle = mp.norm(vector)
    S = skew(vector)
    return mp.eye(3) + S * (mp.sin(angle) / angle) + S * S * ((1 - mp.cos(angle)) / angle**2)


def of_euler(roll: Any, pitch: Any, yaw: Any) -> Matrix:
    """Yaw about z, then pitch about y, then roll about x."""
    x, y, z = ([angle if i == k else mp.mpf(0) for i in range(3)] for k, angle in enumerate((roll, pitch, yaw)))
    return rotation(mp.matrix(z)) * rotation(mp.matrix(y)) * rotation(mp.matrix(x))


def to_euler(C: Matrix) -> Matrix:
    return mp.matrix([mp.atan2(C[2, 1], C[2, 2]), -mp.asin(C[2, 0]), mp.atan2(C[1, 0], C[0, 0])])


def jacobian(function: Callable[[Matrix], Matrix], n: int) -> Matrix:
    """At zero, by differences of a step that leaves 30 digits right."""
    step, columns = mp.mpf(10) ** -16, []
    for k in range(n):
        at = mp.matrix([step if i == k else 0 for i in range(n)])
        columns.append((function(at) - function(-at)) / (2 * step))
    return mp.matrix([[column[i] for column in columns] for i in range(len(columns[0]))])


# ---------------------------------------------------------------- the Earth, and navigation on it


def radii(lat: Any) -> tuple[Any, Any]:
    """Along the meridian and across it."""
    a, f = mp.mpf(AXIS), 1 / mp.mpf(FLATTENING)
    e2 = f * (2 - f)
    w = 1 - e2 * mp.sin(lat) ** 2
    return a * (1 - e2) / w ** mp.mpf("1.5"), a / mp.sqrt(w)


def somigliana(lat: Any) -> Any:
    """Gravity on the ellipsoid, of its two printed values."""
    f = 1 / mp.mpf(FLATTENING)
    s2 = mp.sin(lat) ** 2
    sum_ = mp.mpf(EQUATOR) * (1 - s2) + (1 - f) * mp.mpf(POLE) * s2
    return sum_ / mp.sqrt(1 - f * (2 - f) * s2)


def gravity(lat: Any, height: Any) -> Any:
    """Size of normal gravity above the ellipsoid in closed form: the gradient of its potential in ellipsoidal
    coordinates u and beta, and the centrifugal part."""
    a, f, rate = mp.mpf(AXIS), 1 / mp.mpf(FLATTENING), mp.mpf(RATE)
    b = a * (1 - f)
    E = mp.sqrt(a**2 - b**2)
    _, N = radii(lat)
    r, z = (N + height) * mp.cos(lat), (N * (b / a) ** 2 + height) * mp.sin(lat)
    q0 = ((1 + 3 * (b / E) ** 2) * mp.atan2(E, b) - 3 * b / E) / 2

    def potential(r: Any, z: Any) -> Any:
        s = r**2 + z**2 - E**2
        u = mp.sqrt((s + mp.sqrt(s**2 + 4 * E**2 * z**2)) / 2)
        sin2 = (z / u) ** 2
        q = ((1 + 3 * (u / E) ** 2) * mp.atan2(E, u) - 3 * u / E) / 2
        part = rate**2 * a**2 * q / q0 * (sin2 - mp.mpf(1) / 3) / 2
        return mp.mpf(GM) / E * mp.atan2(E, u) + part + rate**2 * r**2 / 2

    step = mp.mpf(10) ** -9  # m: differences of 50 digits leave 18 right
    by_r = (potential(r + step, z) - potential(r - step, z)) / (2 * step)
    by_z = (potential(r, z + step) - potential(r, z - step)) / (2 * step)
    return mp.hypot(by_r, by_z)


def with_height(lat: Any, height: Any) -> Any:
    """Gravity to the second power of the height, as NGA.STND.0036 prints it."""
    a, f, rate = mp.mpf(AXIS), 1 / mp.mpf(FLATTENING), mp.mpf(RATE)
    m = rate**2 * a**3 * (1 - f) / mp.mpf(GM)
    factor = 1 - 2 * (1 + f + m - 2 * f * mp.sin(lat) ** 2) * height / a + 3 * height**2 / a**2
    return somigliana(lat) * factor


def earth_rate(lat: Any) -> Matrix:
    """East, north, up."""
    return mp.mpf(RATE) * mp.matrix([0, mp.cos(lat), mp.sin(lat)])


def transport_rate(lat: Any, height: Any, v_n: Any) -> Matrix:
    M, N = radii(lat)
    east = v_n[0] / (N + height)
    return mp.matrix([-v_n[1] / (M + height), east, east * mp.tan(lat)])


def rates(y: list[Any], omega: Matrix, f: Matrix) -> list[Any]:
    """Of lon, lat, height, the velocity and the rows of C_b2n, of a body with this rate and specific force, in ENU."""
    lat, height, v, C = y[1], y[2], mp.matrix(y[3:6]), mp.matrix([y[6:9], y[9:12], y[12:15]])
    M, N = radii(lat)
    earth, transport = earth_rate(lat), transport_rate(lat, height, v)
    dv = C * f - mp.matrix([0, 0, with_height(lat, height)]) - cross(2 * earth + transport, v)
    dC = C * skew(omega) - skew(earth + transport) * C
    return [v[0] / ((N + height) * mp.cos(lat)), v[1] / (M + height), v[2], *dv, *dC]


def navigated(y: list[Any], omega: Any, f: Any, seconds: int, columns: int = 9, steps: int = 10) -> list[Any]:
    """After so many seconds: midpoint rules of 2, 4, ... steps, extrapolated, in tenths of a second."""
    omega, f, y = mp.matrix(omega), mp.matrix(f), [mp.mpf(v) for v in y]
    H = mp.mpf(1) / steps

    def midpoint(y: list[Any], n: int) -> list[Any]:
        h = H / n
        before, now = y, [a + h * b for a, b in zip(y, rates(y, omega, f), strict=True)]
        for _ in range(n - 1):
            then = [a + 2 * h * b for a, b in zip(before, rates(now, omega, f), strict=True)]
            before, now = now, then
        last = rates(now, omega, f)
        return [(a + b + h * c) / 2 for a, b, c in zip(now, before, last, strict=True)]

    for _ in range(seconds * steps):
        rows: list[list[list[Any]]] = []
        for k in range(columns):
            row = [midpoint(y, 2 * (k + 1))]
            for j in range(k):
                ratio = (mp.mpf(k + 1) / (k - j)) ** 2 - 1
                row.append([a + (a - b) / ratio for a, b in zip(row[j], rows[-1][j], strict=True)])
            rows.append(row)
        y = rows[-1][-1]
    return y


def in_level_of_start(start: Sequence[Any], y: Sequence[Any]) -> tuple[Matrix, Matrix, Matrix]:
    """Displacement (m), velocity (m/s) and C of body axes, all in the east, north and up of the start."""

    def placed(y: Sequence[Any]) -> tuple[Matrix, Matrix]:
        lon, lat, height = map(mp.mpf, y[:3])
        _, N = radii(lat)
        f = 1 / mp.mpf(FLATTENING)
        r, z = (N + height) * mp.cos(lat), (N * (1 - f) ** 2 + height) * mp.sin(lat)
        (sa, ca), (sb, cb) = (mp.sin(lon), mp.cos(lon)), (mp.sin(lat), mp.cos(lat))
        C_n2e = mp.matrix([[-sa, -sb * ca, cb * ca], [ca, -sb * sa, cb * sa], [0, cb, sb]])
        return mp.matrix([r * ca, r * sa, z]), C_n2e

    (p0, C0), (p, C) = placed(start), placed(y)
    turn = C0.T * C
    rows = mp.matrix([list(map(mp.mpf, y[6 + 3 * i : 9 + 3 * i])) for i in range(3)])
    return C0.T * (p - p0), turn * mp.matrix(list(map(mp.mpf, y[3:6]))), turn * rows


# ---------------------------------------------------------------- filters


def discrete(F: Any, Qc: Any, dt: Any) -> tuple[Matrix, Matrix]:
    """exp(F dt) and the covariance of the noise over dt: a series of the exponential of one matrix."""
    F, Qc = mp.matrix(F), mp.matrix(Qc)
    n = F.rows
    both = mp.matrix(2 * n, 2 * n)
    for i in range(n):
        for j in range(n):
            both[i, j], both[i, n + j], both[n + i, n + j] = -F[i, j] * dt, Qc[i, j] * dt, F[j, i] * dt
    made = mp.expm(both, method="taylor")
    Phi = made[n:, n:].T
    return Phi, Phi * made[:n, n:]


def filtered(x: Any, P: Any, steps: Sequence[tuple[Any, ...]]) -> tuple[Matrix, Matrix, Any]:
    """x, P and the last NIS after steps of (Phi, Q, H, R, z)."""
    x, P, nis = mp.matrix(x), mp.matrix(P), None
    for step in steps:
        Phi, Q, H, R, z = map(mp.matrix, step)
        x, P = Phi * x, Phi * P * Phi.T + Q
        nu, S = z - H * x, H * P * H.T + R
        K = P * H.T * S**-1
        nis = (nu.T * S**-1 * nu)[0]
        x, P = x + K * nu, P - K * H * P
    return x, P, nis


def smoothed(P0: Any, steps: Sequence[tuple[Any, ...]]) -> tuple[Matrix, Matrix]:
    """The first state and its covariance, of a start of mean zero, given all of z at once."""
    P0 = mp.matrix(P0)
    n = P0.rows
    now, through, rows = P0, mp.eye(n), []
    for Phi, Q, H, R, z in steps:
        Phi = mp.matrix(Phi)
        now, through = Phi * now * Phi.T + mp.matrix(Q), Phi * through
        rows.append((Phi, now, through, mp.matrix(H), mp.matrix(R), mp.matrix(z)))
    m = rows[0][3].rows
    S, across = mp.matrix(m * len(rows), m * len(rows)), mp.matrix(n, m * len(rows))
    for j, (_, P, through, H, R, _) in enumerate(rows):
        across[:, j * m : (j + 1) * m] = P0 * through.T * H.T
        column = P * H.T
        for i in range(j, len(rows)):
            column = rows[i][0] * column if i > j else column
            block = rows[i][3] * column + (R if i == j else mp.zeros(m))
            S[i * m : (i + 1) * m, j * m : (j + 1) * m] = block
            S[j * m : (j + 1) * m, i * m : (i + 1) * m] = block.T
    z = mp.matrix([value for row in rows for value in row[5]])
    inverse = S**-1
    return across * (inverse * z), P0 - across * inverse * across.T


def settled(Phi: Any, Q: Any, H: Any, R: Any) -> Matrix:
    """The covariance before an update that no further step changes."""
    Phi, Q, H, R = map(mp.matrix, (Phi, Q, H, R))
    P = Q
    while True:
        K = P * H.T * (H * P * H.T + R) ** -1
        new = Phi * (P - K * H * P) * Phi.T + Q
        if mp.mnorm(new - P) < mp.mpf(10) ** -45 * mp.mnorm(P):
            return new
        P = new


def allan(rates: Any, m: int) -> Any:
    """Overlapping Allan variance of averages of m samples: half the mean square of the difference of neighbours."""
    values = [mp.mpf(rate) for rate in rates]
    mean = [mp.fsum(values[k : k + m]) / m for k in range(len(values) - m + 1)]
    return mp.fsum((mean[k + m] - mean[k]) ** 2 for k in range(len(mean) - m)) / (len(mean) - m) / 2
