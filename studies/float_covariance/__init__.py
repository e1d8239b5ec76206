"""Which forms of the covariance live in single precision."""
