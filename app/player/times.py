"""Times as people read them."""

import math


def position_text(media_s: float, duration_s: float) -> str:
    """Return "mm:ss.s / mm:ss.s", with hours when the clip has them."""
    with_hours = duration_s >= 3600.0
    both = (media_s, duration_s)
    return " / ".join(time_text(value, with_hours=with_hours) for value in both)


def time_text(media_s: float, *, with_hours: bool = False, digits: int = 1) -> str:
    """Return a time, rounded down: the end shows only when it is reached."""
    parts = 10**digits
    count = max(0, math.floor(parts * media_s + 1e-6))
    minutes, count = divmod(count, 60 * parts)
    seconds = f"{count // parts:02}.{count % parts:0{digits}}"
    if not with_hours:
        return f"{minutes:02}:{seconds}"
    return f"{minutes // 60}:{minutes % 60:02}:{seconds}"
