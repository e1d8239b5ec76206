"""Kang and others 2025: transfer alignment at sea by velocity and attitude, with lever arm, misalignment and delay."""
