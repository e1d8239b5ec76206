"""The papers' experiments and the replays: scenario, run, table and figures."""
