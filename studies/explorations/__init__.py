"""What decides the results of the papers' studies, one assumption at a time.  In the checkout, not in the wheel."""
