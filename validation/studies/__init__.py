"""Studies of the validation: one module each, with a function study()."""
