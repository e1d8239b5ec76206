# ruff: noqa: E501  verbatim displays are not wrapped
"""The 32 equations of Kim 2018 and one without a number, verbatim, and the letters in which they are written.

(21), which the text under it cites, is the last row of the block that is tagged (20).
"""

from dataclasses import replace
from functools import cache
from unicodedata import normalize

from boresight.derive.ledger.equation import Quantity
from boresight.derive.ledger.equation import letter as made

# number: ((first line, last line) in the source text counted from 1, its displays without the number)
PRINTED: dict[str, tuple[tuple[int, int], tuple[str, ...]]] = {
    "1": (
        (52, 52),
        (
            r"X = [\delta v_e \ \delta v_n \ \delta v_u \ \phi_e \ \phi_n \ \phi_u \ \theta_x \ \theta_y \ \theta_z \ \Delta t]^T",
        ),
    ),
    "2": (
        (54, 54),
        (
            r"\begin{aligned} \dot{\delta v}^n &= -(2\omega_{ie}^n + \omega_{en}^n)\delta v^n + f^n \phi^n \\ \dot{\phi}^n &= -(\omega_{ie}^n + \omega_{en}^n)\phi^n \\ \dot{\theta} &= 0 \\ \dot{\Delta t} &= 0 \end{aligned}",
        ),
    ),
    "3": (
        (58, 58),
        (
            r"F = \begin{bmatrix} -(2\omega_{ie}^n + \omega_{en}^n)_{3 \times 3} & f_{3 \times 3}^n & 0_{3 \times 4} \\ 0_{3 \times 3} & -(\omega_{ie}^n + \omega_{en}^n)_{3 \times 3} & 0_{3 \times 4} \\ 0_{4 \times 3} & 0_{4 \times 3} & 0_{4 \times 4} \end{bmatrix}",
        ),
    ),
    "4": (
        (62, 62),
        (
            r"\begin{aligned} Z_v(k) &= \hat{v}_{SINS}^n - \hat{v}_{MINS}^n \\ &= (v^n + \delta v^n) - (v^n + \Delta v_{MINS}) \\ &= \delta v^n(k) + \nu_v(k) \end{aligned}",
        ),
    ),
    "5": (
        (64, 64),
        (
            r"\begin{aligned} Z_{dcm}(k) &= \hat{C}_r^x \hat{C}_b^y \hat{C}_n^z \\ &= \phi(k) - C_r^n(k - \delta t)\theta(k) + d(k)\delta t + \nu_{dcm}(k) \end{aligned}",
        ),
    ),
    "6": (
        (66, 66),
        (
            r"H = \begin{bmatrix} I_{3 \times 3} & 0_{3 \times 3} & 0_{3 \times 3} & -f \\ 0_{3 \times 3} & I_{3 \times 3} - C_r^n & -d & 0 \end{bmatrix}",
        ),
    ),
    "7": (
        (84, 84),
        (r"\dot{x}_k = F_k x_k + w_k",),
    ),
    "8": (
        (86, 86),
        (r"x = [x_p \quad x_v \quad x_\phi \quad x_{Cb} \quad x_{Ab}]^T",),
    ),
    "9": (
        (90, 94),
        (
            r"\delta \dot{l} = \left(\frac{\rho_e \tan L}{\cos L} - \frac{\rho_n}{(R_E + h) \cos L} R_{EE} \right) \delta L - \frac{\rho_n}{(R_E + h) \cos L} \delta h + \frac{1}{(R_E + h) \cos L} \delta v_e",
            r"\delta \dot{L} = \frac{\rho_e}{(R_E + h)} R_{NN} \delta L - \frac{\rho_e}{(R_N + h)} \delta h + \frac{1}{(R_N + h)} \delta v_n",
            r"\delta \dot{h} = \delta v_u",
        ),
    ),
    "10": (
        (96, 96),
        (
            r"\delta \dot{v}^n = f^n \phi^n - (2\omega_{ie}^n + \omega_{en}^n) \delta v^n - (2\delta \omega_{ie}^n + \delta \omega_{en}^n) v^n + \delta g^n + C_b^n \delta f^b",
        ),
    ),
    "11": (
        (98, 98),
        (
            r"\dot{\phi}^n = -(\omega_{ie}^n + \omega_{en}^n) \phi^n - (\delta \omega_{ie}^n + \delta \omega_{en}^n) - C_b^n \delta \omega_{ib}^b",
        ),
    ),
    "12": (
        (104, 104),
        (r"\Phi_k = 1 + F_k \Delta T",),
    ),
    "13": (
        (106, 106),
        (r"x_k^- = \Phi_{k-1} x_{k-1}^+",),
    ),
    "14": (
        (108, 108),
        (r"P_k^- = \Phi_{k-1} P_{k-1}^+ \Phi_{k-1}^T + Q",),
    ),
    "15": (
        (116, 116),
        (r"z_k = H_k x_k + \nu_k",),
    ),
    "16": (
        (122, 122),
        (r"z_k = [\hat{v}_e \quad \hat{v}_n \quad \hat{v}_u]^T",),
    ),
    "17": (
        (124, 124),
        (r"H_k = [O_{3 \times 3} \quad I_{3 \times 3} \quad O_{3 \times 18}]",),
    ),
    "18": (
        (132, 134),
        (
            r"\begin{bmatrix} X^p \\ Y^p \\ Z^p \end{bmatrix} = (I - \begin{bmatrix} 0 & -\phi_u & \phi_n \\ \phi_u & 0 & -\phi_e \\ -\phi_n & \phi_e & 0 \end{bmatrix}) (C_b^n \begin{bmatrix} X^b \\ Y^b \\ Z^b \end{bmatrix})",
            r"= C_b^p \begin{bmatrix} X^b \\ Y^b \\ Z^b \end{bmatrix}",
        ),
    ),
    "19": (
        (140, 142),
        (
            r"C_b^p = (I - \check{\Phi}) C_b^n",
            r"\check{\Phi} = \begin{bmatrix} 0 & -\phi_u & \phi_n \\ \phi_u & 0 & -\phi_e \\ -\phi_n & \phi_e & 0 \end{bmatrix}",
        ),
    ),
    "20": (
        (146, 146),
        (
            r"C_b^p \overline{C}_n^b &= (I - \check{\Phi}) C_b^n \overline{C}_n^b",
            r"&= (I - \check{\Phi}) \begin{bmatrix} 1 & \phi_u & -\phi_n \\ -\phi_u & 1 & \phi_e \\ \phi_n & -\phi_e & 1 \end{bmatrix}",
        ),
    ),
    "21": (
        (146, 146),
        (r"\therefore \phi_u &= (C_b^p \overline{C}_n^b(1,2) - C_b^n \overline{C}_n^b(2,1))/2",),
    ),
    "22": (
        (150, 150),
        (r"\therefore z_k = [\hat{v}_e \quad \hat{v}_n \quad \hat{v}_u \quad \phi_u]^T",),
    ),
    "23": (
        (152, 152),
        (
            r"H_k = \begin{bmatrix} \mathbf{0}_{3 \times 3} & \mathbf{I}_{3 \times 3} & \mathbf{0}_{3 \times 3} & \mathbf{0}_{3 \times 15} \\ \mathbf{0}_{1 \times 3} & \mathbf{0}_{1 \times 3} & 0 \ 0 \ 1 & \mathbf{0}_{1 \times 15} \end{bmatrix}",
        ),
    ),
    "24": (
        (158, 158),
        (r"K_k = P_k^- H^T (H P_k^- H^T + R)^{-1}",),
    ),
    "25": (
        (166, 166),
        (r"x_k^+ = x_k^- + K_k(z_k - H_k x_k^-)",),
    ),
    "26": (
        (168, 168),
        (r"P_k^+ = [I - K_k H_k] P_k^-",),
    ),
    "27": (
        (172, 172),
        (r"l = \hat{l} - \delta, \quad L = \hat{L} - \delta L, \quad h = \hat{h} - \delta h",),
    ),
    "28": (
        (176, 176),
        (r"v_e = \hat{v}_e - \delta v_e, \quad v_n = \hat{v}_n - \delta v_n, \quad v_u = \hat{v}_u - \delta v_u",),
    ),
    "29": (
        (182, 184),
        (
            r"Q = \Delta Q \cdot \hat{Q}",
            r"\Delta Q = -\frac{1}{2} \begin{bmatrix} q_0 & -q_1 & -q_2 & -q_3 \\ q_1 & q_0 & q_3 & -q_2 \\ q_2 & -q_3 & q_0 & q_1 \\ q_3 & q_2 & -q_1 & q_0 \end{bmatrix} \begin{bmatrix} \phi_e \\ \phi_n \\ \phi_u \end{bmatrix}",
        ),
    ),
    "30": (
        (190, 192),
        (
            r"y_k = s_k(\theta) + \nu_k",
            r"s_k(\theta) = \begin{bmatrix} s_k^a(\theta) \\ s_k^\omega(\theta) \end{bmatrix}, \quad \nu_k = \begin{bmatrix} \nu_k^a \\ \nu_k^\omega \end{bmatrix}",
        ),
    ),
    "31": (
        (200, 200),
        (r"T_a = \sqrt{\frac{1}{N} \sum_{k \in \Omega_n} \|y_k^a - \bar{y}_n^a\|^2} < \gamma_a",),
    ),
    "32": (
        (202, 204),
        (
            r"T_w = \frac{1}{N} \sum_{k \in \Omega_n} y_k^w < \gamma_w",
            r"\bar{y}_n^a = \frac{1}{N} \sum_{k \in \Omega_n} y_k^a",
        ),
    ),
    "Ω_n": ((204, 204), (r"\Omega_n = \{n \leq l \leq N-1\}",)),
}

# The text between the equations: line, and what it says.
DETECTORS = (198, "각속도 이동평균값과 각속도의 이동표준편차")  # the moving mean of the rate and its moving deviation
CITED = ("21",)  # numbers that the text cites and no display is tagged with

# Table 1, lines 217 to 224: repeatability of bias, stability of scale factor, misalignment, random walk.
TABLE_1_LINES = (217, 224)
TABLE_1 = {"gyro": ("1", "150", "100", "0.125"), "accelerometer": ("1", "300", "100", "0.065")}
TABLE_1_UNITS = {"gyro": ("deg/hr", "ppm", "urad", "deg/√hr"), "accelerometer": ("mg", "ppm", "urad", "ft/sec/√hr")}

# One spelling of the page can be several letters: which of them an equation means, by number.
MEANT = {
    "3": ("F_X",),
    "6": ("f_n", "H_X"),
    "10": ("[δω_ie_n x]", "[δω_en_n x]"),
    "14": ("Q_k",),
    "16": ("z_v",),
    "17": ("H_v",),
    "26": ("I_15x15",),
    "29": ("Q_b2n",),
    "30": ("ν_y",),
    "Ω_n": ("index",),
}
# Other spellings of a letter.
SPELLINGS = {
    "Δt": (r"\delta t",),
    "[f_n x]": (r"f_{3 \times 3}^n",),
    "δv": (r"\delta v^n(k)",),
    "φ": (r"\phi(k)",),
    "θ": (r"\theta(k)",),
    "d": ("d(k)",),
    "H_k": ("H",),
    "f_n": ("f",),
    "0_3x3": (r"O_{3 \times 3}", r"\mathbf{0}_{3 \times 3}"),
    "0_1x3": (r"\mathbf{0}_{1 \times 3}",),
    "0_3x15": (r"\mathbf{0}_{3 \times 15}",),
    "0_1x15": (r"\mathbf{0}_{1 \times 15}",),
    "0_3x18": (r"O_{3 \times 18}",),
    "I_3x3": (r"\mathbf{I}_{3 \times 3}",),
}


@cache
def quantities() -> tuple[Quantity, ...]:
    """Every letter of the paper, and those which the derived forms need, with LaTeX, kind and meaning."""
    table: list[Quantity] = []

    def add(name, latex, kind, meaning, shape=(), function=False):
        table.append(made(name, latex, kind, meaning, shape, function))

    # Position, velocity, and their errors.
    for letter, word in (("l", "longitude"), ("L", "latitude"), ("h", "height")):
        kind, unit = ("height", "m") if letter == "h" else ("angle", "rad")
        add(letter, letter, kind, f"true {word}, {unit}")
        add(f"{letter}\u0302", rf"\hat{{{letter}}}", kind, f"computed {word}, {unit}")
        add(f"δ{letter}", rf"\delta {letter}", f"{kind} error", f"error of the {word}, {unit}")
        add(f"δ{letter}\u0307", rf"\delta \dot{{{letter}}}", f"{kind} error rate", f"its rate, {unit}/s")
    add("δ", r"\delta", "nothing", "a letter that the paper does not define")
    for axis in "enu":
        add(f"v_{axis}", f"v_{axis}", "speed", "component of the true velocity, m/s")
        add(f"v\u0302_{axis}", rf"\hat{{v}}_{axis}", "speed", "component of the computed velocity, m/s")
        add(f"δv_{axis}", rf"\delta v_{axis}", "speed error", "component of the velocity error, m/s")
        add(f"φ_{axis}", rf"\phi_{axis}", "rotation", "component of the attitude error, rad")
        add(f"ρ_{axis}", rf"\rho_{axis}", "transport rate", "component of ω_en_n, rad/s")
    for axis in "xyz":
        add(f"θ_{axis}", rf"\theta_{axis}", "rotation", "component of the error of the mounting, rad")
    add("R_E", "R_E", "radius", "transverse radius of curvature, m")
    add("R_N", "R_N", "radius", "meridian radius of curvature, m")
    add("R_EE", "R_{EE}", "radius slope", "dR_E/dL, m")
    add("R_NN", "R_{NN}", "radius slope", "dR_N/dL, m")
    add("Δt", r"\Delta t", "delay", "by how much the master's data is old, s")
    add("ΔT", r"\Delta T", "step", "time step, s")
    # The detector.
    add("N", "N", "count", "samples in a window")
    add("n", "n", "count", "first sample of a window")
    add("index", "l", "index", "number of a sample")
    add("T_a", "T_a", "deviation", "moving deviation of the specific force, m/s^2")
    add("T_w", "T_w", "mean", "moving mean of the angular rate, rad/s")
    add("γ_a", r"\gamma_a", "limit of a deviation", "threshold, m/s^2")
    add("γ_w", r"\gamma_w", "limit of a mean", "threshold, rad/s")
    for i in range(4):
        add(f"q_{i}", f"q_{i}", "quaternion part", "component of the computed attitude")

    vectors = (
        ("v", "v^n", "velocity", "true velocity, m/s"),
        ("v\u0302_SINS", r"\hat{v}_{SINS}^n", "velocity", "velocity of the slave, m/s"),
        ("v\u0302_MINS", r"\hat{v}_{MINS}^n", "velocity", "velocity of the master as it arrives, m/s"),
        ("δv", r"\delta v^n", "velocity error", "error of the slave's velocity, m/s"),
        ("Δv_MINS", r"\Delta v_{MINS}", "velocity error", "error of the master's velocity, m/s"),
        ("Z_v", "Z_v(k)", "velocity error", "measurement, m/s"),
        ("ν_v", r"\nu_v(k)", "velocity error", "measurement noise, m/s"),
        ("δv\u0307_c", r"\dot{\delta v}^n", "acceleration", "rate of the velocity error in the psi model, m/s^2"),
        ("δv\u0307", r"\delta \dot{v}^n", "acceleration", "rate of the velocity error, m/s^2"),
        ("v\u0307", r"\dot{v}^n", "acceleration", "rate of the velocity, m/s^2"),
        ("f_n", "f^n", "acceleration", "specific force, m/s^2"),
        ("δg_n", r"\delta g^n", "acceleration", "error of gravity, m/s^2"),
        ("δf_b", r"\delta f^b", "acceleration", "error of the accelerometers, m/s^2"),
        ("φ", r"\phi^n", "rotation vector", "attitude error, rad"),
        ("θ", r"\theta", "rotation vector", "error of the mounting, rad"),
        ("Z_dcm", r"Z_{dcm}(k)", "rotation vector", "measurement, rad"),
        ("ν_dcm", r"\nu_{dcm}(k)", "rotation vector", "measurement noise, rad"),
        ("φ\u0307", r"\dot{\phi}^n", "rate", "rate of the attitude error against the true axes, rad/s"),
        ("ψ\u0307", r"\dot{\psi}^n", "rate", "rate of the attitude error against the computed axes, rad/s"),
        ("θ\u0307", r"\dot{\theta}", "rate", "rate of θ, rad/s"),
        ("d", "d", "rate", "change of the attitude measurement with the delay, rad/s"),
        ("δω_ie_n", r"\delta \omega_{ie}^n", "rate", "error of the Earth's rate, rad/s"),
        ("δω_en_n", r"\delta \omega_{en}^n", "rate", "error of the transport rate, rad/s"),
        ("δω_ib_b", r"\delta \omega_{ib}^b", "rate", "error of the gyros, rad/s"),
        ("x_p", "x_p", "part", "position error"),
        ("x_v", "x_v", "part", "velocity error"),
        ("x_φ", r"x_\phi", "part", "attitude error"),
        ("x_Cb", "x_{Cb}", "part", "gyro bias"),
        ("x_Ab", "x_{Ab}", "part", "accelerometer bias"),
        ("s_a", r"s_k^a(\theta)", "force", "true specific force, m/s^2"),
        ("ν_a", r"\nu_k^a", "force", "noise of the accelerometers, m/s^2"),
        ("y_a", "y_k^a", "force", "output of the accelerometers, m/s^2"),
        ("ȳ_a", r"\bar{y}_n^a", "force", "its mean over the window, m/s^2"),
        ("s_w", r"s_k^\omega(\theta)", "turn", "true angular rate, rad/s"),
        ("ν_w", r"\nu_k^\omega", "turn", "noise of the gyros, rad/s"),
        ("y_w", "y_k^w", "turn", "output of the gyros, rad/s"),
        ("z_v", "z_k", "measured velocity", "zero-velocity measurement, m/s"),
        ("ν_z", r"\nu_k", "measured velocity", "noise of the zero-velocity measurement, m/s"),
    )
    for name, latex, kind, meaning in vectors:
        add(name, latex, kind, meaning, (3,))
    add("Δt\u0307", r"\dot{\Delta t}", "delay rate", "rate of Δt")
    for name in "XYZ":
        for frame in "pb":
            add(f"{name}_{frame}", f"{name}^{frame}", "component", f"component of one vector in {frame}")

    matrices = (
        ("C_b2n", "C_b^n", "attitude", "true attitude: b to n"),
        ("C_b2p", "C_b^p", "attitude", "computed attitude: b to the computed axes p"),
        ("C\u0304_n2b", r"\overline{C}_n^b", "attitude", "attitude from the transfer alignment, transposed"),
        ("C_r2n", "C_r^n", "attitude", "true attitude of the master: r to n"),
        ("C_r2n(k-δt)", r"C_r^n(k - \delta t)", "attitude", "the same when the master's data was taken"),
        ("C\u0302_r2n", r"\hat{C}_r^n", "computed attitude", "attitude of the master as it arrives"),
        ("C\u0302_b2r", r"\hat{C}_b^r", "computed attitude", "estimated mounting: b to r"),
        ("C\u0302_n2b", r"\hat{C}_n^b", "computed attitude", "computed attitude of the slave, transposed"),
        ("C\u0302_r2x", r"\hat{C}_r^x", "unknown", "a matrix to a frame x that the paper does not define"),
        ("C\u0302_b2y", r"\hat{C}_b^y", "unknown", "a matrix to a frame y that the paper does not define"),
        ("C\u0302_n2z", r"\hat{C}_n^z", "unknown", "a matrix to a frame z that the paper does not define"),
        ("Φ\u030c", r"\check{\Phi}", "turning", "[φ x], rad"),
        ("[ω_ie_n x]", r"\omega_{ie}^n", "rate matrix", "the Earth's rate as a matrix, 1/s"),
        ("[ω_en_n x]", r"\omega_{en}^n", "rate matrix", "the transport rate as a matrix, 1/s"),
        ("[δω_ie_n x]", r"\delta \omega_{ie}^n", "rate matrix", "its error as a matrix, 1/s"),
        ("[δω_en_n x]", r"\delta \omega_{en}^n", "rate matrix", "its error as a matrix, 1/s"),
        ("[f_n x]", "f^n", "force matrix", "the specific force as a matrix, m/s^2"),
        ("I", "I", "identity", "identity"),
    )
    for name, latex, kind, meaning in matrices:
        add(name, latex, kind, meaning, (3, 3))
    for rows, columns in ((3, 3), (3, 4), (4, 3), (4, 4), (3, 9), (3, 18), (3, 6), (3, 15), (1, 3), (1, 6), (1, 15)):
        add(f"0_{rows}x{columns}", rf"0_{{{rows} \times {columns}}}", "block", "zeros", (rows, columns))
    add("I_3x3", r"I_{3 \times 3}", "block", "identity", (3, 3))
    add("I_15x15", "I", "15x15", "identity", (15, 15))
    filter_letters = (
        ("X", "X", "ten states", "the ten states of the transfer alignment", (10,)),
        ("X\u0307", r"\dot{X}", "ten states", "their rates", (10,)),
        ("F_X", "F", "10x10", "system matrix of the ten states, 1/s", (10, 10)),
        ("H_X", "H", "6x10", "measurement matrix of the ten states", (6, 10)),
        ("x", "x", "states", "the fifteen states", (15,)),
        ("x_k", "x_k", "states", "the fifteen states at step k", (15,)),
        ("x\u0307_k", r"\dot{x}_k", "state rates", "their rates", (15,)),
        ("w_k", "w_k", "state rates", "process noise", (15,)),
        ("x(k-)", "x_k^-", "states", "prediction", (15,)),
        ("x(k+)", "x_k^+", "states", "estimate", (15,)),
        ("x(k-1+)", "x_{k-1}^+", "states", "estimate of the step before", (15,)),
        ("F_k", "F_k", "15x15", "system matrix, 1/s", (15, 15)),
        ("Φ_k", r"\Phi_k", "15x15", "transition matrix over ΔT", (15, 15)),
        ("Φ_k-1", r"\Phi_{k-1}", "15x15", "transition matrix of the step before", (15, 15)),
        ("P(k-)", "P_k^-", "covariance", "predicted covariance", (15, 15)),
        ("P(k+)", "P_k^+", "covariance", "covariance after the update", (15, 15)),
        ("P(k-1+)", "P_{k-1}^+", "covariance", "covariance of the step before", (15, 15)),
        ("Q_k", "Q", "covariance", "covariance of the process noise over ΔT", (15, 15)),
        ("H_v", "H_k", "3x15", "measurement matrix of zero velocity", (3, 15)),
        ("H_k", "H_k", "4x15", "measurement matrix with the azimuth", (4, 15)),
        ("K_k", "K_k", "15x4", "gain", (15, 4)),
        ("R", "R", "4x4", "covariance of the measurement noise", (4, 4)),
        ("z", "z_k", "measurement", "zero velocity and azimuth, m/s and rad", (4,)),
        ("ν", r"\nu_k", "measurement", "their noise", (4,)),
        ("Q_b2n", "Q", "quaternion", "true attitude", (4,)),
        ("Q\u0302_b2n", r"\hat{Q}", "quaternion", "computed attitude", (4,)),
        ("ΔQ", r"\Delta Q", "quaternion", "error of the quaternion", (4,)),
        ("y_k", "y_k", "outputs", "sensor outputs at sample k", (6,)),
        ("s_k", r"s_k(\theta)", "outputs", "true inputs of the sensors", (6,)),
        ("ν_y", r"\nu_k", "outputs", "noise of the sensors", (6,)),
        ("Ω_n", r"\Omega_n", "window", "the samples of a window", (6,)),
    )
    for name, latex, kind, meaning, shape in filter_letters:
        add(name, latex, kind, meaning, shape)
    add("Σ", r"\sum_{k \in \Omega_n}", "function", "sum over the window", function=True)
    add("norm", r"\operatorname{norm}", "function", "length of a vector", function=True)
    add("samples", r"\operatorname{samples}", "function", "the samples between two numbers", function=True)
    add("entry", r"\operatorname{entry}", "function", "one entry of a matrix", function=True)
    add("vee", r"\operatorname{vee}", "function", "vector of the skew-symmetric part", function=True)
    add("row", r"\operatorname{row}", "function", "numbers in a row", function=True)
    return tuple(table)


def letters_of(number: str) -> tuple[Quantity, ...]:
    """The letters as this equation means them: later ones take precedence where the page spells two alike."""
    by_name = {quantity.symbol.name: quantity for quantity in quantities()}
    spelled = (replace(by_name[normalize("NFC", n)], latex=text) for n, texts in SPELLINGS.items() for text in texts)
    return (
        *(q for q in quantities() if not q.function),
        *spelled,
        *(by_name[name] for name in DEFAULT),
        *(by_name[normalize("NFC", name)] for name in MEANT.get(number, ())),
    )


# What a spelling means unless MEANT says otherwise.
DEFAULT = ("[f_n x]", "δω_ie_n", "δω_en_n", "z", "H_k", "ν", "l", "I")
