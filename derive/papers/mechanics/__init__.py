"""Our own derivations, of nobody's print: strapdown navigation and its errors, from exact kinematics."""
