"""Song and Lee 2001: transfer alignment by Euler-angle matching, equation by equation."""
