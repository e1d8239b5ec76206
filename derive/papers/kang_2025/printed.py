# ruff: noqa: E501  verbatim displays are not wrapped
"""The six equations of Kang and others 2025, verbatim, their two tables, and the letters in which they are written."""

from functools import cache

from boresight.derive.ledger.equation import Quantity, letter

# number: ((first line, last line) in the source text counted from 1, its displays without the number)
PRINTED: dict[str, tuple[tuple[int, int], tuple[str, ...]]] = {
    "1": (
        (76, 76),
        (
            r"\begin{aligned} v_m^n &= v_s^n - \frac{dL}{dt} \Big|_n \\ &= v_s^n + [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L \end{aligned}",
        ),
    ),
    "2": (
        (90, 90),
        (r"v_{s,k+\alpha} = v_{s,k} \frac{dt - \delta t_d}{dt} + v_{s,k-1} \frac{\delta t_d}{dt}",),
    ),
    "3": (
        (98, 98),
        (
            r"z_v = v_S^n + [w_{in}^n \times] C_S^n L - C_S^n [w_{ib}^b \times] L + \frac{v_{s,k-1} - v_{s,k}}{dt} \delta t_d - v_M^n",
        ),
    ),
    "4": (
        (100, 100),
        (r"A = \left(C_S^n C_M^S C_M^{nT} - eye(3) \right) - \left(C_S^n C_M^S C_M^{nT} - eye(3) \right)^T / 2",),
    ),
    "5": (
        (102, 102),
        (r"z_{DCM} = [-A(2,3); A(1,3); -A(1,2)] + C_S^n w_{nb}^n \delta t_d",),
    ),
    "6": (
        (113, 113),
        (r"Seawave = asin(2\pi ft)",),
    ),
}

# The text beside the equations: line, and what it says.
RATE_OF_N = (78, "지구 자전 각속도와 transport rate의 합")  # w_in: the Earth's rate and the transport rate together
WHEN = (88, r"그 이전인 $k - \delta t_d$ 시점에 측정된 값")  # the master's data is that of k - dt_d
BETWEEN = (88, "이전 측정치 정합인 $k-1$ 사이")  # k and k-1 are updates of the filter
RESIDUALS = (104, r"z_v, z_{DCM} 은 각각 필터의 측정치로 사용되는 속도 오차, 자세 오차이다")
HEIGHT = (115, "a, f 는 각각 파도의 파고와 주기를 의미하며, 주기는 0.1 Hz로")  # a: wave height; f: "period", 0.1 Hz
GRADES_RUN = (115, "해상상태 1등급부터 6등급까지")  # simulated: 1 to 6
GRADES_READ = (162, "등급 0~2에서는")  # read off Fig. 3: 0 to 2
AT_REST, ROLLING = (173, "1.90°"), (173, "0.15°")  # heading error left on the bench, of 2 deg

TABLE_1_LINES = (120, 125)
TABLE_1 = (
    ("1", "0.01", "0.1", "Calm(rippled)"),
    ("2", "0.1", "0.1", "Smooth(wavelets)"),
    ("3", "0.5", "0.1", "Slight"),
    ("4", "1.25", "0.1", "Moderate"),
    ("5", "2.5", "0.1", "Rough"),
    ("6", "4", "0.1", "Very rough"),
)
TABLE_2_LINES = (130, 135)
TABLE_2 = (
    ("Monte #", "times", "20"),
    ("Misalignment error", "deg", "2"),
    ("Navigation update rate", "Hz", "100"),
    ("Filter update rate", "Hz", "1"),
    ("Time delay", "ms", "5-10 (random)"),
    ("Simulation time", "min", "1"),
)


@cache
def quantities() -> tuple[Quantity, ...]:
    """Every letter of the paper, and those which the derived forms need, with LaTeX, kind and meaning."""
    vectors = (
        ("v_m", "v_m^n", "velocity", "velocity at the master, m/s"),
        ("v_s", "v_s^n", "velocity", "velocity of the slave, m/s"),
        ("v_S", "v_S^n", "velocity", "velocity of the slave, m/s"),
        ("v_M", "v_M^n", "velocity", "velocity that the master reports, as it was δt_d ago, m/s"),
        ("v_s(k)", "v_{s,k}", "velocity", "velocity of the slave, m/s"),
        ("v_s(k-1)", "v_{s,k-1}", "velocity", "velocity of the slave dt before, m/s"),
        ("v_s(k+α)", r"v_{s,k+\alpha}", "velocity", "velocity of the slave δt_d before, m/s"),
        ("dL/dt", r"\frac{dL}{dt} \Big|_n", "velocity", "rate of change of the lever arm as seen from n, m/s"),
        ("u(k)", "u_k", "velocity", "[ω_in_n x] C_S2n L - C_S2n [ω_ib_b x] L, m/s"),
        ("u(k-1)", "u_{k-1}", "velocity", "the same dt before, m/s"),
        ("z_v", "z_v", "velocity", "velocity expected of the master less the reported one, at one time, m/s"),
        ("L", "L", "lever arm", "from the master to the slave, in slave body axes, m"),
        ("ω_nb_n", "w_{nb}^n", "rate", "rate of the body against n, in n, rad/s"),
        ("ω_nb_b", "w_{nb}^b", "rate", "the same in body axes, rad/s"),
        ("z_DCM", "z_{DCM}", "rotation vector", "turn of the expected attitude from the reported, at one time, rad"),
    )
    matrices = (
        ("[ω_in_n x]", r"[w_{in}^n \times]", "rate matrix", "rate of n against inertial space, 1/s"),
        ("[ω_ib_b x]", r"[w_{ib}^b \times]", "rate matrix", "gyro output, 1/s"),
        ("C_S2n", "C_S^n", "attitude", "attitude of the slave"),
        ("C_M2S", "C_M^S", "attitude", "estimated misalignment: master to slave"),
        ("C_M2n", "C_M^n", "attitude", "attitude that the master reports, as it was δt_d ago"),
        ("C_n2M", "C_M^{nT}", "attitude", "the same, transposed"),
        ("A", "A", "turn", "matrix of the turn of the slave now from the master δt_d ago"),
        ("I", "eye(3)", "identity", "identity"),
    )
    scalars = (
        ("dt", "dt", "time", "time between k-1 and k, s"),
        ("δt_d", r"\delta t_d", "time", "by how much the master's data is old, s"),
        ("t", "t", "time", "time, s"),
        ("Seawave", "Seawave", "length", "elevation of the surface, m"),
        ("a", "a", "length", "height of the wave, crest to trough, m"),
        ("f", "f", "frequency", "frequency of the wave, Hz"),
        ("π", r"\pi", "number", "pi"),
    )
    return (
        *(letter(*one, (3,)) for one in vectors),
        *(letter(*one, (3, 3)) for one in matrices),
        *(letter(*one) for one in scalars),
        letter("asin", "asin", "function", "arcsine, if read as it stands", function=True),
    )
