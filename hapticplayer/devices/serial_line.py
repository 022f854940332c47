"""A serial port, opened as it is."""

import os


def open_serial(path: str, baud: int) -> int:
    """A descriptor that does not wait: raw, 8N1, without flow control.

    DTR and RTS are not touched, and closing does not lower them, which would restart many
    boards. What came before is thrown away.

    Raises:
        OSError: when it cannot be opened, or is not a serial port.
        ValueError: for a rate that ports do not have.
    """
    import termios  # not on Windows

    speed = getattr(termios, f"B{baud}", None)
    if speed is None:
        raise ValueError(f"a port has no {baud} baud")
    descriptor = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    try:
        state = termios.tcgetattr(descriptor)
        control = termios.CS8 | termios.CREAD | termios.CLOCAL
        state[:6] = [0, 0, control, 0, speed, speed]
        state[6][termios.VMIN] = 1  # so that nothing read means unplugged
        termios.tcsetattr(descriptor, termios.TCSANOW, state)
        termios.tcflush(descriptor, termios.TCIFLUSH)
    except termios.error as problem:
        os.close(descriptor)
        raise OSError(*problem.args) from problem
    return descriptor
