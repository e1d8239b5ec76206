"""From a model to CasADi functions, to C, and to the proof that the C is right."""

from boresight.errors import need

need("derive")
