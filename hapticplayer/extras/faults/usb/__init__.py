"""A Falcon that answers byte for byte, below the USB library.

`Mechanics` move, `Board` is the processors with boot loader and firmware, `Chip` the
FT232R with its timing, and `SimulatedBus` (in `backend`, which needs pyusb) a bus
for an unmodified pyusb. The driver on top is the one for real Falcons.
"""
