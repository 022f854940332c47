"""The command `render`: another mapping for a sequence that exists."""

import argparse
import json
from functools import partial
from pathlib import Path

from hapticplayer.cli.common import (
    described_figures,
    say,
    say_figures,
    shown_progress,
)
from hapticplayer.cli.mapping_options import (
    FIT,
    add_mapping,
    add_preset,
    chosen_mapping,
    mapping_text,
)
from hapticplayer.errors import InputError
from hapticplayer.model import rendered_feedback
from hapticplayer.sequence import open_sequence, store
from hapticplayer.sequence.description import written
from hapticplayer.sequence.editing import copy_changed, fitted_gain, set_mapping
from hapticplayer.sequence.effects_file import read_effects
from hapticplayer.sequence.excursion import excursion_texts
from hapticplayer.sequence.figures import sequence_figures
from hapticplayer.sequence.presets import preset_of
from hapticplayer.storage import FOLDER, refuse_existing


def add_options(command: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    command.set_defaults(run=run)
    command.add_argument(
        "sequence",
        metavar="SEQUENCE",
        help="what is not given stays as it is; added force tracks stay too",
    )
    add_mapping(command)
    add_preset(command, default=None)
    command.add_argument(
        "--effects",
        metavar="FILE",
        help="a list of effects in place of the sequence's own, such as an effects.json",
    )
    where = command.add_mutually_exclusive_group(required=True)
    where.add_argument("-o", "--output", metavar="DIR", help="a new sequence")
    where.add_argument(
        "--in-place", action="store_true", help="change the sequence itself"
    )
    command.add_argument("--json", action="store_true", help="print a report as JSON")


def run(options: argparse.Namespace, _open_window: object) -> int:
    """Render the force tracks of a sequence again, or of a copy of it."""
    folder = Path(options.sequence)
    target = folder if options.in_place else Path(options.output)
    if not options.in_place:
        refuse_existing(target, FOLDER)
    sequence = open_sequence(folder)
    before = sequence_figures(sequence)
    mapping, fits_gain = chosen_mapping(options, sequence.mapping)
    change = partial(
        set_mapping,
        mapping=mapping,
        fits_gain=fits_gain,
        preset=options.preset,
        effects=read_effects(Path(options.effects)) if options.effects else None,
    )
    with shown_progress() as progress:
        if options.in_place:
            change(folder, progress=progress)
        else:
            copy_changed(folder, target, change, progress=progress)
    made = open_sequence(target)
    after = sequence_figures(made)
    if options.json:
        content = {
            "sequence": str(target),
            **written(made.description),
            "figures": described_figures(before, after),
        }
        say(json.dumps(content, ensure_ascii=False))
        return 0
    rendered = made.description.feedbacks[rendered_feedback(made.tracks)]
    offer = _offer(made, fits_gain=fits_gain)
    say(
        f"{target}: {mapping_text(made.mapping)} ({offer}); "
        f"preset {preset_of(made.rendered)}"
    )
    say_figures(before, after)
    for note in excursion_texts(rendered.excursion) if rendered.excursion else []:
        say(f"note: {note}")
    return 0


def _offer(made: store.Sequence, *, fits_gain: bool) -> str:
    if fits_gain:
        return FIT
    try:
        return f"--gain fit: {fitted_gain(made, made.mapping):.4g}"
    except InputError:  # no valid motion while the clip plays
        return "no motion to fit a gain to"
