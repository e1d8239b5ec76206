"""NumPy and the compiled library: what flies.  Neither SymPy nor CasADi is imported here."""
