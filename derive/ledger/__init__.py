"""The machine of a ledger: equations as values, the reader of prints, witnesses, judges of forms and of steps."""
