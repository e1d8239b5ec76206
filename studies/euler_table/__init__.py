"""Table 1 of Song and Lee (2001): which attitude error can be estimated from which angle under which motion."""
