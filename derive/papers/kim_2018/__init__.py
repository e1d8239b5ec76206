"""Kim 2018: holding the azimuth of a tactical-grade inertial unit at rest, after transfer alignment."""
