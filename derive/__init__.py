"""Equations, derivations, papers and models as SymPy values."""

from boresight import need

need("derive")
