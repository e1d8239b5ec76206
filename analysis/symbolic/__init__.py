"""What of analysis/ needs SymPy: the command line alone imports it."""
