"""Equations, derivations, papers and models as SymPy values.

Nothing here writes files, but for `render.pdf_from_latex`, which runs pdflatex in a folder that it removes again.
"""

from boresight.errors import need

need("derive")
