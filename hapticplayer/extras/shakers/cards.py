"""Whether a sound card is there: `python -m hapticplayer.extras.shakers.cards TEXT`.

In a process of its own: PortAudio knows only the cards of when it was loaded, and hangs
where its sound server does. Prints "" or what is wrong, as a message in JSON.
"""

import json
import os
import subprocess
import sys

from hapticplayer.clock import SystemClock
from hapticplayer.devices.checks import Check
from hapticplayer.devices.options import divided
from hapticplayer.errors import DeviceError, Message, from_json, message_of, to_json
from hapticplayer.extras.shakers.driver import CardStream
from hapticplayer.extras.shakers.settings import ShakerSettings, shaker_settings

ANSWER_S = 5.0


def main(text: str) -> int:
    """Look for the card of some settings."""
    said: Message | str = ""
    try:
        own, _ = divided(f"shaker:{text}")  # without the gain
        CardStream(shaker_settings(own), lambda *_: None, SystemClock())
    except DeviceError as problem:
        said = message_of(problem)
    sys.stdout.write(json.dumps(to_json(said)))
    return 0


def check_card(settings: ShakerSettings) -> Check:
    """Return whether the card of some settings has its channels."""
    channels = "+".join(map(str, settings.channels))
    what = Message(
        "Sound output {card} with the channels {channels}",
        card=repr(settings.address) if settings.address else Message("(default)"),
        channels=channels,
    )
    try:
        asked = subprocess.run(
            [sys.executable, "-P", "-m", __name__, settings.text()],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
            timeout=ANSWER_S,
            check=True,
            text=True,
        )
        said = from_json(json.loads(asked.stdout))
    except (OSError, ValueError, subprocess.SubprocessError):
        said = Message("The sound system does not answer: restart it.")
    return Check(what, not said, said)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
