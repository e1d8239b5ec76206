"""Boresight: from the equations of an inertial-navigation filter to C that can be flown.

The conventions, said once; every generated artefact prints them, docs/conventions.md explains them.

- Error = computed - true.  ``C_hat = (I - [e x]) C``: the small rotation ``e`` is what must be applied to remove it.
- ``C_b2n`` takes body components to navigation components: ``v_n = C_b2n @ v_b``.  NED with front-right-down,
  or ENU with right-front-up; never mixed.  A rate names all its frames: ``omega_ie_n``.
- SI and radians inside and in C.  Where another unit enters or leaves, it is in the name: ``gyro_bias_deg_h``.
- Quaternions are Hamilton, scalar first, body to navigation: ``q_b2n_wxyz``.
- A master's data is old by ``tau > 0``; a lever arm runs from master to slave in slave body axes.
- Matrices are row-major.
"""

__version__ = "0.1.0"


class BoresightError(Exception):
    """One line for the user: what is wrong, where, and what to do about it."""
