"""Flights to try the transfer alignment on, made by means that it does not share."""
