"""Truth and sensors that are simulated.  Nothing that flies imports from here."""
