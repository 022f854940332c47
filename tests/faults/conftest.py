"""The cases are plain modules beside the tests, so that the benchmark can use them."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
