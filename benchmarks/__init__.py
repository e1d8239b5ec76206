"""Side by side in one run, reported as ratios: nothing here is a test."""
