"""The process that sends packets to a motion rig: state machine, loop, guard."""
