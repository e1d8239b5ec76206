# ruff: noqa: E501  verbatim displays are not wrapped
"""The 28 numbered equations of Song and Lee 2001 and two without a number, verbatim, and the letters in which they are written."""

from functools import cache

from boresight.derive.ledger.equation import Quantity
from boresight.derive.ledger.equation import letter as made

# number: ((first line, last line) in the source text counted from 1, its displays without the number)
PRINTED: dict[str, tuple[tuple[int, int], tuple[str, ...]]] = {
    "1": ((46, 46), (r"\hat{\phi} = \phi + \delta\phi",)),
    "2": ((48, 48), (r"\hat{\theta} = \theta + \delta\theta",)),
    "3": ((50, 50), (r"\hat{\psi} = \psi + \delta\psi",)),
    "4": ((54, 54), (r"\hat{C}_b^n(\hat{\phi}, \hat{\theta}, \hat{\psi}) = C_n^{n'} C_b^n",)),
    "5": (
        (58, 58),
        (
            r"\hat{C}_b^n(\hat{\phi}, \hat{\theta}, \hat{\psi}) = C_b^n + \Delta C[(\phi, \theta, \psi), (\delta\phi, \delta\theta, \delta\psi)]",
        ),
    ),
    "6": ((62, 62), (r"C_n^{n'} C_b^n = (I - E) C_b^n",)),
    "7": ((66, 66), (r"E = -\Delta C[(\phi, \theta, \psi), (\delta\phi, \delta\theta, \delta\psi)] C_b^n",)),
    "8": (
        (70, 70),
        (
            r"\begin{bmatrix} \epsilon_n \\ \epsilon_e \\ \epsilon_d \end{bmatrix} = \begin{bmatrix} -\cos\theta\cos\phi & \sin\phi & 0 \\ -\cos\theta\sin\phi & -\cos\phi & 0 \\ \sin\theta & 0 & -1 \end{bmatrix} \begin{bmatrix} \delta\phi \\ \delta\theta \\ \delta\psi \end{bmatrix}",
        ),
    ),
    "9": (
        (74, 74),
        (
            r"\begin{bmatrix} \delta\phi \\ \delta\theta \\ \delta\psi \end{bmatrix} = \begin{bmatrix} -\cos\phi/\cos\theta & -\sin\phi/\cos\theta & 0 \\ \sin\phi & -\cos\phi & 0 \\ -\tan\theta\cos\phi & -\tan\theta\sin\phi & -1 \end{bmatrix} \begin{bmatrix} \epsilon_n \\ \epsilon_e \\ \epsilon_d \end{bmatrix}",
        ),
    ),
    "10": (
        (78, 78),
        (
            r"\begin{aligned} \hat{C}_b^{b'} &\equiv C_b^{b'} = C_b^{b'} C_b^b = C_b^{n'}(I+B) \\ &\equiv C_b^{n'} = C_n^{n'} C_b^n = (I-E)C_b^n \end{aligned}",
        ),
    ),
    "B": ((80, 80), (r"B = -C_n^{n'} E C_b^n",)),
    "11": ((82, 82), (r"\beta^b = -C_n^{n'} \epsilon^n",)),
    "12": (
        (86, 86),
        (
            r"\begin{bmatrix} \beta_x \\ \beta_y \\ \beta_z \end{bmatrix} = \begin{bmatrix} 1 & 0 & -\sin\theta \\ 0 & \cos\phi & \sin\phi\cos\theta \\ 0 & -\sin\phi & \cos\phi\cos\theta \end{bmatrix} \begin{bmatrix} \delta\phi \\ \delta\theta \\ \delta\psi \end{bmatrix}",
        ),
    ),
    "13": (
        (90, 90),
        (
            r"\begin{bmatrix} \delta\phi \\ \delta\theta \\ \delta\psi \end{bmatrix} = \begin{bmatrix} 1 & \sin\phi\tan\theta & \cos\phi\tan\theta \\ 0 & \cos\phi & -\sin\phi \\ 0 & \sin\phi/\cos\theta & \cos\phi/\cos\theta \end{bmatrix} \begin{bmatrix} \beta_x \\ \beta_y \\ \beta_z \end{bmatrix}",
        ),
    ),
    "14": (
        (102, 102),
        (
            r"\begin{bmatrix} \Delta\phi \\ \Delta\theta \\ \Delta\psi \end{bmatrix} = \begin{bmatrix} \phi_b \\ \theta_b \\ \psi_b \end{bmatrix} - \begin{bmatrix} \phi_r \\ \theta_r \\ \psi_r \end{bmatrix}",
        ),
    ),
    "15": (
        (106, 106),
        (
            r"\begin{bmatrix} \Delta\phi \\ \Delta\theta \\ \Delta\psi \end{bmatrix} = \begin{bmatrix} 1 & \sin\phi_r \tan\theta_r & \cos\phi_r \tan\theta_r \\ 0 & \cos\phi_r & -\sin\phi_r \\ 0 & \sin\phi_r/\cos\theta_r & \cos\phi_r/\cos\theta_r \end{bmatrix} \begin{bmatrix} \mu_x \\ \mu_y \\ \mu_z \end{bmatrix}",
        ),
    ),
    "16": (
        (112, 112),
        (
            r"Z = \begin{bmatrix} \hat{\phi}_b \\ \hat{\theta}_b \\ \hat{\psi}_b \end{bmatrix} - \begin{bmatrix} \hat{\phi}_r \\ \hat{\theta}_r \\ \hat{\psi}_r \end{bmatrix} - \begin{bmatrix} \hat{\Delta\phi} \\ \hat{\Delta\theta} \\ \hat{\Delta\psi} \end{bmatrix}",
        ),
    ),
    "17": (
        (116, 116),
        (
            r"Z = \begin{bmatrix} \delta\phi_b \\ \delta\theta_b \\ \delta\psi_b \end{bmatrix} + \begin{bmatrix} \phi_b \\ \theta_b \\ \psi_b \end{bmatrix} - \begin{bmatrix} \phi_r \\ \theta_r \\ \psi_r \end{bmatrix} - \begin{bmatrix} \hat{\Delta\phi} \\ \hat{\Delta\theta} \\ \hat{\Delta\psi} \end{bmatrix} - \begin{bmatrix} \delta\phi_r \\ \delta\theta_r \\ \delta\psi_r \end{bmatrix}",
        ),
    ),
    "18": (
        (120, 120),
        (
            r"\begin{bmatrix} \hat{\Delta\phi} \\ \hat{\Delta\theta} \\ \hat{\Delta\psi} \end{bmatrix} = \begin{bmatrix} 1 & \sin\phi_r \tan\theta_r & \cos\phi_r \tan\theta_r \\ 0 & \cos\phi_r & -\sin\phi_r \\ 0 & \sin\phi_r/\cos\theta_r & \cos\phi_r/\cos\theta_r \end{bmatrix} \begin{bmatrix} \hat{\mu}_x \\ \hat{\mu}_y \\ \hat{\mu}_z \end{bmatrix}",
        ),
    ),
    "19": (
        (124, 124),
        (
            r"Z = \begin{bmatrix} -\cos\psi_b/\cos\theta_b & -\sin\psi_b/\cos\theta_b & 0 \\ \sin\psi_b & -\cos\psi_b & 0 \\ -\tan\theta_b \cos\psi_b & -\tan\theta_b \sin\psi_b & -1 \end{bmatrix} \begin{bmatrix} \varepsilon_n \\ \varepsilon_e \\ \varepsilon_d \end{bmatrix} - \begin{bmatrix} 1 & \sin\phi_r \tan\theta_r & \cos\phi_r \tan\theta_r \\ 0 & \cos\phi_r & -\sin\phi_r \\ 0 & \sin\phi_r/\cos\theta_r & \cos\phi_r/\cos\theta_r \end{bmatrix} \begin{bmatrix} \delta\mu_x \\ \delta\mu_y \\ \delta\mu_z \end{bmatrix} - \begin{bmatrix} \delta\phi_r \\ \delta\theta_r \\ \delta\psi_r \end{bmatrix}",
        ),
    ),
    "δμ": (
        (126, 126),
        (
            r"\delta\mu_x = \hat{\mu}_x - \mu_x",
            r"\delta\mu_y = \hat{\mu}_y - \mu_y",
            r"\delta\mu_z = \hat{\mu}_z - \mu_z",
        ),
    ),
    "20": ((134, 134), (r"\dot{\varepsilon}^n = -\Omega_{in}^n \varepsilon^n - C_b^n \delta\omega^b",)),
    "21": ((138, 138), (r"\delta\dot{\mu}^r = 0",)),
    "22": (
        (142, 142),
        (r"X = [\varepsilon_n \ \varepsilon_e \ \varepsilon_d \ \delta\mu_x \ \delta\mu_y \ \delta\mu_z]^T",),
    ),
    "23": (
        (153, 155),
        (
            r"\Delta Q_b^n = \begin{bmatrix} \Delta q_0 \\ \Delta q_1 \\ \Delta q_2 \\ \Delta q_3 \end{bmatrix} = \begin{bmatrix} \cos \frac{\epsilon_o}{2} \\ \frac{\epsilon_n}{\epsilon_o} \sin \frac{\epsilon_o}{2} \\ \frac{\epsilon_e}{\epsilon_o} \sin \frac{\epsilon_o}{2} \\ \frac{\epsilon_d}{\epsilon_o} \sin \frac{\epsilon_o}{2} \end{bmatrix},",
            r"\epsilon_o = \sqrt{\epsilon_n^2 + \epsilon_e^2 + \epsilon_d^2}",
        ),
    ),
    "24": ((159, 159), (r"\hat{Q}_b^n(k^+) = \Delta Q_b^n(k) \hat{Q}_b^n(k^-)",)),
    "25": ((163, 163), (r"\mu^r(k^+) = \mu^r(k^-) + \delta\mu^r(k)",)),
    "26": (
        (173, 177),
        (
            r"Z_{roll} = \hat{\phi}_b - \hat{\phi}_r - \Delta\phi",
            r"= \begin{bmatrix} -\cos\phi_b/\cos\theta_b & -\sin\phi_b/\cos\theta_b & 0 \end{bmatrix} \begin{bmatrix} \epsilon_n \\ \epsilon_e \\ \epsilon_d \end{bmatrix}",
            r"- \begin{bmatrix} 1 & \sin\phi_r \tan\theta_r & \cos\phi_r \tan\theta_r \end{bmatrix} \begin{bmatrix} \delta\mu_x \\ \delta\mu_y \\ \delta\mu_z \end{bmatrix} - \delta\phi_r",
        ),
    ),
    "27": (
        (181, 185),
        (
            r"Z_{pitch} = \hat{\theta}_b - \hat{\theta}_r - \Delta\theta",
            r"= \begin{bmatrix} \sin\phi_b & -\cos\phi_b & 0 \end{bmatrix} \begin{bmatrix} \epsilon_n \\ \epsilon_e \\ \epsilon_d \end{bmatrix}",
            r"- \begin{bmatrix} 0 & \cos\phi_r & -\sin\phi_r \end{bmatrix} \begin{bmatrix} \delta\mu_x \\ \delta\mu_y \\ \delta\mu_z \end{bmatrix} - \delta\theta_r",
        ),
    ),
    "28": (
        (189, 193),
        (
            r"Z_{yaw} = \hat{\psi}_b - \hat{\psi}_r - \Delta\psi",
            r"= \begin{bmatrix} -\tan\theta_b \cos\phi_b & -\tan\theta_b \sin\phi_b & -1 \end{bmatrix} \begin{bmatrix} \epsilon_n \\ \epsilon_e \\ \epsilon_d \end{bmatrix}",
            r"- \begin{bmatrix} 0 & \sin\phi_r/\cos\theta_r & \cos\phi_r/\cos\theta_r \end{bmatrix} \begin{bmatrix} \delta\mu_x \\ \delta\mu_y \\ \delta\mu_z \end{bmatrix} - \delta\psi_r",
        ),
    ),
}

# Table 1, lines 210 to 216: a row for each set of matched angles, a column for each motion, both in the order of AXES;
# o: estimable, X: not, for the errors about n, e, d.
AXES = ("roll", "pitch", "yaw", "roll pitch", "roll yaw", "pitch yaw", "roll pitch yaw")
TABLE_1 = (
    "XXX XXo XoX XXo XoX Xoo Xoo",
    "XXo XXX oXX XXo oXo oXX oXo",
    "XoX oXX XXX ooX XoX oXX ooX",
    "XXo XXo ooX XXo ooo ooo ooo",
    "XoX oXo XoX ooo XoX ooo ooo",
    "Xoo oXX oXX ooo ooo oXX ooo",
    "Xoo oXo ooX ooo ooo ooo ooo",
)
TABLE_1_LINES = (210, 216)
# Line 224 and 262: cells with three, two, one, none estimable; cells with d estimable.
TABLE_1_COUNTS = ((13, 12, 21, 3), 28)


@cache
def quantities() -> tuple[Quantity, ...]:
    """Every letter of the paper, with its LaTeX, its kind and what it means."""
    table: list[Quantity] = []

    def add(name, latex, kind, meaning, shape=(), function=False):
        table.append(made(name, latex, kind, meaning, shape, function))

    greek = (("φ", r"\phi", "roll"), ("θ", r"\theta", "pitch"), ("ψ", r"\psi", "yaw"))
    owners = (("", "", ""), ("_b", "_b", " of the slave"), ("_r", "_r", " of the master"))
    for script, tex_script, owner in owners:
        for letter, tex, word in greek:
            add(letter + script, tex + tex_script, "angle", f"true {word}{owner}, rad")
            add(
                f"{letter}\u0302{script}",
                rf"\hat{{{tex}}}{tex_script}",
                "angle",
                f"computed {word}{owner}, rad",
            )
            add(f"δ{letter}{script}", rf"\delta{tex}{tex_script}", "angle error", f"error of the {word}{owner}, rad")
    for letter, tex, word in greek:
        add(f"Δ{letter}", rf"\Delta{tex}", "angle error", f"true {word}, slave minus master, rad")
        add(f"Δ{letter}\u0302", rf"\hat{{\Delta{tex}}}", "angle error", f"computed {word}, slave minus master, rad")
    for axis in "ned":
        add(f"ε_{axis}", rf"\epsilon_{axis}", "rotation", "rotation vector from n to n', in n, rad")
    for axis in "xyz":
        add(f"β_{axis}", rf"\beta_{axis}", "rotation", "rotation vector from b to b', in b, rad")
        add(f"μ_{axis}", rf"\mu_{axis}", "rotation", "true misalignment from r to b, in r, rad")
        add(f"μ\u0302_{axis}", rf"\hat{{\mu}}_{axis}", "rotation", "estimated misalignment, rad")
        add(f"δμ_{axis}", rf"\delta\mu_{axis}", "rotation", "error of the estimated misalignment, rad")
    add("ε_o", r"\epsilon_o", "rotation", "angle of the rotation, rad")
    for i in range(4):
        add(f"Δq_{i}", rf"\Delta q_{i}", "quaternion part", "component of the error quaternion")
    matrices = (
        ("C_b2n", "C_b^n", "true attitude: b to n"),
        ("C_n2b", "C_n^b", "true attitude: n to b"),
        ("C\u0302_b2n", r"\hat{C}_b^n", "computed attitude"),
        ("C_n2n'", "C_n^{n'}", "true navigation axes to computed ones"),
        ("C_b2n'", "C_b^{n'}", "b to the computed navigation axes"),
        ("C_b'2n", "C_{b'}^n", "perturbed body axes to n"),
        ("C_b2b'", "C_b^{b'}", "b to the perturbed body axes"),
        ("C\u0302_b2b'", r"\hat{C}_b^{b'}", "computed C_b2b'"),
        ("C_b'2b", "C_{b'}^b", "perturbed body axes to b"),
        ("C_b2b", "C_b^b", "b to b"),
        ("I", "I", "identity"),
        ("E", "E", "[ε x]"),
        ("B", "B", "[β x]"),
        ("Ω_in_n", r"\Omega_{in}^n", "[ω_in_n x], 1/s"),
    )
    for name, latex, meaning in matrices:
        add(name, latex, "3x3", meaning, (3, 3))
    add("C\u0302", r"\hat{C}_b^n", "function", "C_b2n of three angles", (3, 3), True)
    add("ΔC", r"\Delta C", "function", "first-order change of C_b2n(angles) under errors", (3, 3), True)
    vectors = (
        ("ε", r"\epsilon^n", "rotation vector from n to n', in n, rad"),
        ("β", r"\beta^b", "rotation vector from b to b', in b, rad"),
        ("ε\u0307", r"\dot{\epsilon}^n", "rate of ε, rad/s"),
        ("δω_b", r"\delta\omega^b", "gyro error, computed - true, rad/s"),
        ("δμ\u0307", r"\delta\dot{\mu}^r", "rate of δμ, rad/s"),
        ("μ(k+)", r"\mu^r(k^+)", "misalignment after the correction, rad"),
        ("μ(k-)", r"\mu^r(k^-)", "misalignment before the correction, rad"),
        ("μ\u0302(k+)", r"\hat{\mu}^r(k^+)", "estimated misalignment after the correction, rad"),
        ("μ\u0302(k-)", r"\hat{\mu}^r(k^-)", "estimated misalignment before the correction, rad"),
        ("δμ(k)", r"\delta\mu^r(k)", "estimated error of the misalignment, rad"),
        ("Z", "Z", "measurement, rad"),
    )
    for name, latex, meaning in vectors:
        add(name, latex, "vector", meaning, (3,))
    for name, latex in (("Z_roll", "Z_{roll}"), ("Z_pitch", "Z_{pitch}"), ("Z_yaw", "Z_{yaw}")):
        add(name, latex, "measured angle", "one row of Z, rad")
    add("ΔQ", r"\Delta Q_b^n", "quaternion", "rotation by ε", (4,))
    add("ΔQ(k)", r"\Delta Q_b^n(k)", "quaternion", "rotation by ε at step k", (4,))
    add("Q\u0302(k+)", r"\hat{Q}_b^n(k^+)", "quaternion", "attitude after the correction", (4,))
    add("Q\u0302(k-)", r"\hat{Q}_b^n(k^-)", "quaternion", "attitude before the correction", (4,))
    add("X", "X", "state", "the six states", (6,))
    for i in range(1, 7):
        add(f"X_{i}", f"X_{i}", "state part", "component of X")
    return tuple(table)
