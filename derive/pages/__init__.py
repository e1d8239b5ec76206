"""What a person reads of a derivation: LaTeX, MathML, text, and the pages made of them."""
