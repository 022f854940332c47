"""The windows of extras, in folders of the same names."""
