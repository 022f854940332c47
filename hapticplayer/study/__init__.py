"""The study: from consent to the figures of the paper."""
