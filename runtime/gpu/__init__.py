"""An experiment as C: flown one run after the other on a host, and each in its thread on a GPU, with the same bits."""
