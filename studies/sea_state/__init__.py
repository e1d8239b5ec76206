"""Kang and others (2025): transfer alignment in sea states 1 to 6, with and without the delay."""
