"""The heading error of a transfer alignment that does not know the age of its data: a derivation of our own."""
