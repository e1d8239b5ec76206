"""What \flown{name} stands for in the derivations: the functions that the models use."""

from collections.abc import Mapping

from sympy import ImmutableMatrix, Matrix, Symbol, symbols

from boresight.derive.papers.kim_2018 import results


def flown(letters: Mapping[str, Symbol]) -> dict[str, object]:
    quaternion, units = [letters[f"q_{i}"] for i in range(4)], symbols("e n u")
    by_phi = results.quaternion_error(quaternion, units).jacobian(Matrix(units)) * -2
    return {
        "quaternion_error": ImmutableMatrix(by_phi),
        "zero_velocity_matrix": ImmutableMatrix(results.zero_velocity_matrix()),
        "hold_measurement_matrix": ImmutableMatrix(results.hold_measurement_matrix()),
    }
