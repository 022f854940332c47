"""Command-line options of the processes of simulated devices."""

import argparse
import math

from hapticplayer.devices.dynamics import HANDS, Mechanism
from hapticplayer.simulation.falcon.parameters import Electronics
from hapticplayer.simulation.falcon.simulation import Simulation


def device_parser(program: str) -> argparse.ArgumentParser:
    """Return the options of every simulated device; it may get more."""
    parser = argparse.ArgumentParser(prog=program)
    parser.add_argument("--line", type=int, required=True, help="descriptor")
    parser.add_argument("--control", type=int, help="descriptor, for faults only")
    parser.add_argument("--record", type=int, help="descriptor of a file or memfd")
    parser.add_argument("--hand", choices=HANDS, default="relaxed")
    parser.add_argument(
        "--grip-mass-kg", type=float, help="mass of the free grip, sideways"
    )
    parser.add_argument("--hold-s", type=float, default=math.inf)
    parser.add_argument("--delay-s", type=float, default=0.0)
    return parser


def simulation_of(options: argparse.Namespace) -> Simulation:
    """Return the grip and the hand that the options say."""
    mechanism = Mechanism()
    if options.grip_mass_kg is not None:
        mechanism = mechanism.with_lateral_mass(options.grip_mass_kg)
    return Simulation(
        HANDS[options.hand],
        mechanism=mechanism,
        electronics=Electronics(options.hold_s, options.delay_s),
    )
