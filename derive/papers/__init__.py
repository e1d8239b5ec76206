"""The papers, one module each, named as the ledger names them."""
