"""Studies: from consent to data that a reviewer accepts.

Design and orders, the trial runner, the store of answers, and their analysis. No Qt.
"""
