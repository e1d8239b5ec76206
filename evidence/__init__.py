"""What is known about each generated C unit, beyond that it computes the right numbers on the host."""
