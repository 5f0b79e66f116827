"""How partial sums travel: as the drain meets them, so that the array needs no memory to put them in pixel order.

Result slot s of group g belongs to output column ``4 g - 1 + s`` of the group's row, slot 0 of a row's first group to
the last column of the row before, if the width is a multiple of 4; then one more group follows the last row. Groups
come in that order, in each of them the tiles of ``units`` output channels, in each tile the words of ``drain``
channels. A word is ``drain`` x 4 sums, slot 0 of the first channel in the low bits, each a signed field of whole bytes;
it is padded with zeros to whole beats. Channels and columns that the layer does not have are fields like others:
what they hold means nothing, and what comes in there changes no output.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from macram.spec.array import ArrayConfig
from macram.spec.fixed import GROUP
from macram.spec.formats import IntFormat
from macram.spec.layer import ConvSpec


@dataclass(frozen=True, slots=True)
class SumLayout:
    """Layout of the partial sums of ``layer`` on the streams of ``array``."""

    layer: ConvSpec
    array: ArrayConfig

    @property
    def groups(self) -> int:
        """Groups of 4 slots."""
        per_row, tail = divmod(self.layer.out_width, GROUP)
        return self.layer.out_height * (per_row + bool(tail)) + (not tail)

    @property
    def beats(self) -> int:
        """Beats of an image."""
        tiles = self.array.tiles(self.layer.c_out)
        return self.groups * tiles * self.array.drain_cycles * self.array.sum_word_beats

    def pack(self, sums: NDArray[np.integer]) -> NDArray[np.uint8]:
        """Sums ``[c_out, out_height, out_width]`` -> ``[beats, stream_bits // 8]`` bytes, low byte first.

        Raises:
            ValueError: wrong shape, or a sum that the array's format does not hold.
        """
        layer, array = self.layer, self.array
        shape = (layer.c_out, layer.out_height, layer.out_width)
        if sums.shape != shape:
            raise ValueError(f"partial sums must be {list(shape)}, not {list(sums.shape)}")
        if not array.sum.holds(sums):
            raise ValueError(f"partial sums must fit {array.sum}, not {int(sums.min())}..{int(sums.max())}")
        rows = np.zeros((array.tiles(layer.c_out) * array.units, layer.out_height, self._row_slots), np.int64)
        rows[: layer.c_out, :, : layer.out_width] = sums
        slots = np.zeros((len(rows), self.groups * GROUP + 1), np.int64)
        slots[:, 1 : 1 + layer.out_height * self._row_slots] = rows.reshape(len(rows), -1)
        words = slots[:, :-1].reshape(*self._channel_axes, self.groups, GROUP).transpose(3, 0, 1, 2, 4)
        fields = np.ascontiguousarray(words, "<i8")[..., None].view(np.uint8)[
            ..., : array.sum_field_bits // 8
        ]
        raw = fields.reshape(-1, array.drain * GROUP * array.sum_field_bits // 8)
        beats = np.zeros((len(raw), array.sum_word_beats * array.stream_bits // 8), np.uint8)
        beats[:, : raw.shape[1]] = raw
        return beats.reshape(self.beats, -1)

    def unpack(self, beats: NDArray[np.uint8]) -> NDArray[np.int64]:
        """Inverse of `pack`.

        Raises:
            ValueError: another number of beats.
        """
        layer, array = self.layer, self.array
        if beats.shape != (self.beats, array.stream_bits // 8):
            raise ValueError(f"partial sums are {self.beats} beats, not {len(beats)}")
        size = array.sum_field_bits // 8
        words = beats.reshape(-1, array.sum_word_beats * array.stream_bits // 8)
        fields = words[:, : array.drain * GROUP * size].reshape(self.groups, *self._channel_axes, GROUP, size)
        wide = np.zeros((*fields.shape[:-1], 8), np.uint8)
        wide[..., :size] = fields
        signed = IntFormat(array.sum_field_bits, signed=True).from_field(wide.view("<u8")[..., 0])
        slots = signed.transpose(1, 2, 3, 0, 4).reshape(-1, self.groups * GROUP)
        # The last column of a row is never in the row's own last slot.
        slots = np.pad(slots, ((0, 0), (0, 1)))[:, 1 : 1 + layer.out_height * self._row_slots]
        rows = slots.reshape(-1, layer.out_height, self._row_slots)
        return np.ascontiguousarray(rows[: layer.c_out, :, : layer.out_width])

    @property
    def _row_slots(self) -> int:
        return GROUP * self.array.groups(self.layer.out_width)

    @property
    def _channel_axes(self) -> tuple[int, int, int]:
        return self.array.tiles(self.layer.c_out), self.array.drain_cycles, self.array.drain
