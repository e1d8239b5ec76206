"""From a model to numbers that are checked: CasADi functions, instruction lists, points of their boxes, 50 digits."""
