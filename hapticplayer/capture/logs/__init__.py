"""Readers of the logs of loggers and phones, one module for each."""
