"""What a firmware image is made of, so that a wrong file is refused before it runs.

The Falcon's processor, a TMS320R2811, loads its program through the serial boot
loader of TI's C28x family (boot ROM manuals, "SCI boot"): little endian words of 16
bits: the key, eight reserved words, the entry point (high word first), then blocks of
{count, address (high word first), words}, and a count of 0. All four files that are
known parse to their last byte. No image comes with this program.
"""

import hashlib
import struct
from dataclasses import dataclass

from hapticplayer.errors import DeviceError, Message

KEY = 0x08AA
MAX_IMAGE_BYTES = 1 << 20
_HEADER_WORDS = 11
_ADDRESSES = 1 << 22
_MEMORY_WORDS = 20 * 1024  # of on-chip RAM; a program cannot be larger

KNOWN_IMAGES = {
    "1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1": (
        "nvent_firmware.bin"
    ),
    "ae838730af34b5822c9c3949859b446614af0410730b832cc17a6ad627ea64a4": "novint_T0.bin",
    "e0ae3598670fa1c8d9277bd6943c99b3152b97c400c46c1c42c60de77ff4e816": "novint_T2.bin",
    "b2700d5cd5ca217e48565fb4de5a502a636c53f6e01ebd0cad193e9f84856c6a": (
        "test_firmware.bin"
    ),
}
"""SHA-256 of the images that libnifalcon passes on, and its names for them."""


@dataclass(frozen=True, slots=True)
class MemoryBlock:
    """Words for consecutive addresses of the processor."""

    address: int
    words: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class FirmwareImage:
    """A boot stream that has been checked; `entry` is where the program begins."""

    data: bytes
    entry: int
    blocks: tuple[MemoryBlock, ...]
    sha256: str

    @property
    def known_name(self) -> str:
        """Its name among the known images; "" for any other."""
        return KNOWN_IMAGES.get(self.sha256, "")


def parse_image(data: bytes) -> FirmwareImage:
    """Return the image in these bytes; raises DeviceError that says where it breaks."""
    if len(data) % 2 or not 0 < len(data) <= MAX_IMAGE_BYTES:
        raise _no_image(
            Message(
                "{count} bytes are not a whole number of words, or too many",
                count=len(data),
            )
        )
    words = struct.unpack(f"<{len(data) // 2}H", data)
    if words[0] != KEY:
        raise _no_image(Message("it does not begin with the boot loader's key 08AA"))
    if len(words) <= _HEADER_WORDS:
        raise _no_image(Message("it ends in its header"))
    entry = words[9] << 16 | words[10]
    blocks, end = _blocks(words)
    if end != len(words):
        raise _no_image(
            Message("{count} bytes follow its end", count=2 * (len(words) - end))
        )
    if not blocks:
        raise _no_image(Message("there is nothing in it"))
    if entry >= _ADDRESSES or not any(_holds(block, entry) for block in blocks):
        raise _no_image(
            Message(
                "its entry point {entry:06X} lies in none of its blocks", entry=entry
            )
        )
    return FirmwareImage(data, entry, tuple(blocks), hashlib.sha256(data).hexdigest())


def build_image(entry: int, blocks: tuple[MemoryBlock, ...]) -> bytes:
    """Return the boot stream of a program; for simulators and tests."""
    words = [KEY, *[0] * 8, entry >> 16, entry & 0xFFFF]
    for block in blocks:
        words += [len(block.words), block.address >> 16, block.address & 0xFFFF]
        words += block.words
    return struct.pack(f"<{len(words) + 1}H", *words, 0)


def _blocks(words: tuple[int, ...]) -> tuple[list[MemoryBlock], int]:
    """Return the blocks and the place after the count that ends them."""
    blocks: list[MemoryBlock] = []
    at, total = _HEADER_WORDS, 0
    while at < len(words):
        count = words[at]
        if count == 0:
            return blocks, at + 1
        first = at + 3
        if first + count > len(words):
            break
        address = words[at + 1] << 16 | words[at + 2]
        total += count
        if address + count > _ADDRESSES or total > _MEMORY_WORDS:
            raise _no_image(
                Message(
                    "a block of {count} words at {address:X} fits nowhere",
                    count=count,
                    address=address,
                )
            )
        blocks.append(MemoryBlock(address, words[first : first + count]))
        at = first + count
    raise _no_image(Message("it is cut off"))


def _holds(block: MemoryBlock, address: int) -> bool:
    return block.address <= address < block.address + len(block.words)


def _no_image(why: str) -> DeviceError:
    return DeviceError(
        "not valid firmware for the Falcon: {reason}; choose the file "
        "nvent_firmware.bin of a libnifalcon source archive",
        reason=why,
    )
