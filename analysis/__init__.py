"""What a designer asks of a model: consistency, observability, error budget, smoother, noise.

It flies the compiled C and knows no symbols; what reads equations stands in `symbolic`, which the command line imports.
"""
