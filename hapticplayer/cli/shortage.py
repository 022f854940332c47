"""Too little memory, too few open files: one sentence instead of a traceback."""

import errno
import os
import resource

from hapticplayer.errors import HapticPlayerError

LEAST_ADDRESS_SPACE_BYTES = 1 << 30
"""Drawing needs 0.7 GB. With less, libraries end the process or wait for ever."""

LEAST_FILES = 64
"""Playing needs 25, and the window more; usual are 1024."""

_MEMORY = "not enough memory; close other programs, or raise the limit (ulimit -v)"
_FILES = "too many open files; close other programs, or raise the limit (ulimit -n)"
_WORDS = {
    "failed to map segment": _MEMORY,
    "annot allocate memory": _MEMORY,
    "can't start new thread": _MEMORY,
    "oo many open files": _FILES,
}
_ERRNO = {errno.ENOMEM: _MEMORY, errno.EMFILE: _FILES, errno.ENFILE: _FILES}


def refuse_small_limits() -> None:
    """Check the limits of this process before anything is loaded."""
    space, files = (
        resource.getrlimit(which)[0]
        for which in (resource.RLIMIT_AS, resource.RLIMIT_NOFILE)
    )
    if space != resource.RLIM_INFINITY:
        # each of its threads reserves memory, and there is one for each core
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
        if space < LEAST_ADDRESS_SPACE_BYTES:
            raise HapticPlayerError(
                f"the memory of a process is limited to {space >> 20} MB; "
                f"raise the limit to {LEAST_ADDRESS_SPACE_BYTES >> 20} MB or more "
                f"(ulimit -v {LEAST_ADDRESS_SPACE_BYTES >> 10})"
            )
    if files != resource.RLIM_INFINITY and files < LEAST_FILES:
        raise HapticPlayerError(
            f"the number of open files is limited to {files}; raise the limit to "
            f"{LEAST_FILES} or more (ulimit -n {LEAST_FILES})"
        )


def shortage_of(problem: BaseException | None) -> str:
    """The shortage that caused a problem, else ""."""
    while problem is not None:
        if isinstance(problem, MemoryError):
            return _MEMORY
        if isinstance(problem, OSError) and problem.errno in _ERRNO:
            return _ERRNO[problem.errno]
        if isinstance(problem, (ImportError, OSError, RuntimeError)):
            text = str(problem)
            for words, sentence in _WORDS.items():
                if words in text:
                    return sentence
        problem = problem.__cause__ or problem.__context__
    return ""
