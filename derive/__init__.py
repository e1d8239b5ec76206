"""Equations, derivations, papers and models as SymPy values.  Nothing here writes files."""
