"""The one name for arrays in signatures: a docstring says their shape, unit and frame."""

import numpy as np

Array = np.ndarray
