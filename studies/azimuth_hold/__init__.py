"""Kim (2018): how long a unit at rest keeps the attitude that a transfer alignment gave it."""
