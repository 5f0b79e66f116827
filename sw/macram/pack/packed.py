"""A layer as memory words for one array, and its way into streams and files."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from macram.golden import ShiftRequant, ThresholdRequant, derive_requant
from macram.layer_file import LayerCase
from macram.pack.bits import Words, words_to_ints
from macram.pack.files import read_folder, write_folder
from macram.pack.layout import (
    absent_requant,
    pack_requant,
    pack_weights,
    unpack_borders,
    unpack_requant,
    unpack_weights,
)
from macram.pack.signed import Rise
from macram.spec import ArrayConfig, ConvSpec, LayerPass, layer_passes, words_to_beats


@dataclass(frozen=True, eq=False)
class PackedLayer:
    """The words of one layer, only as many as the layer needs; `macram.pack.layout` says what is where.

    Attributes:
        spec: the layer.
        array: the array it is packed for.
        weights: uint8 ``[units, weight_words, bytes]``, low byte first.
        requant: uint8 ``[requant_words, bytes]``, low byte first.
        sums_in, sums_out: as of `macram.spec.LayerPass`, for a pass of a layer in blocks of input channels. What gives
            sums has a requantiser that is not used.

    Raises:
        ValueError: the array does not admit the layer, or the number or size of the words does not fit.
    """

    spec: ConvSpec
    array: ArrayConfig
    weights: Words
    requant: Words
    sums_in: bool = False
    sums_out: bool = False

    def __post_init__(self) -> None:
        array, spec = self.array, self.spec
        array.check_admits(spec)
        if (self.sums_in or self.sums_out) and not array.partial_sum_c_in:
            raise ValueError(f"array {array.name!r} has no partial sums; build one with partial_sum_c_in")
        for name, width, depth in (
            ("weights", array.weight_word_bits, (array.units, array.weight_words(spec))),
            ("requant", array.requant_word_bits, (array.requant_words(spec),)),
        ):
            words: Words = getattr(self, name)
            shape = (*depth, -(-width // 8))
            if words.dtype != np.uint8 or words.shape != shape:
                raise ValueError(f"{name} must be uint8 {list(shape)}, not {words.dtype} {list(words.shape)}")
            if (words[..., -1] >> ((width - 1) % 8 + 1)).any():
                raise ValueError(f"{name} words must have at most {width} bits")

    @property
    def requantiser(self) -> str:
        """``"threshold"`` or ``"shift"``."""
        return "threshold" if self.array.thresholds else "shift"

    @property
    def weight_words(self) -> int:
        """Weight words of each unit: the value of PARAM_WORDS for loading weights."""
        return int(self.weights.shape[1])

    @property
    def requant_words(self) -> int:
        """Requantiser words: the value of PARAM_WORDS for loading the requantiser."""
        return len(self.requant)

    def unit_words(self, unit: int) -> list[int]:
        """Weight words of one unit in address order."""
        return words_to_ints(self.weights[unit])

    def requant_ints(self) -> list[int]:
        """Requantiser words in address order."""
        return words_to_ints(self.requant)

    def load_beats(self) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
        """Beats of the parameter stream that load this layer.

        Returns:
            Weights (all words of unit 0 in address order, then of unit 1, ...) and requantiser words in
            address order, each ``[beats, stream_bits // 8]`` bytes, low byte first.
        """
        array = self.array
        weights = words_to_ints(self.weights.reshape(-1, self.weights.shape[2]))
        return (
            words_to_beats(weights, array.weight_word_bits, array.stream_bits),
            words_to_beats(self.requant_ints(), array.requant_word_bits, array.stream_bits),
        )

    def write(self, folder: Path, *, comments: bool = True) -> None:
        """Write ``unit_000.mem`` ..., ``requant.mem``, the same as ``.coe``, and ``manifest.json``.

        Every memory is filled to its full depth: weights with zeros, the requantiser with entries that give
        the code field 0. The files are complete before the first of them appears in ``folder``, the
        manifest comes last, and files of an earlier layer in the same folder go.

        Args:
            folder: made if missing.
            comments: begin each ``.mem`` file with two lines of comment, which not every tool reads.

        Raises:
            ValueError: the folder cannot be written.
        """
        array = self.array
        deep = np.zeros((array.units, array.weight_depth, self.weights.shape[2]), np.uint8)
        deep[:, : self.weight_words] = self.weights
        memories = {f"unit_{unit:03d}": (deep[unit], array.weight_word_bits) for unit in range(array.units)}
        rest = absent_requant(array, array.requant_depth - self.requant_words)
        memories["requant"] = (np.concatenate([self.requant, rest]), array.requant_word_bits)
        roles = {"sums_in": self.sums_in, "sums_out": self.sums_out}
        write_folder(Path(folder), self.spec, array, self.requantiser, memories, roles, comments=comments)


def pack_layer(case: LayerCase, array: ArrayConfig) -> PackedLayer:
    """Weights and requantisation of a layer as the memory words of ``array``.

    Raises:
        ValueError: the array does not admit the layer; the line names the limit.
    """
    spec = case.spec
    array.check_admits(spec)
    whole = LayerPass(spec, range(spec.c_in), range(spec.c_out), sums_in=False, sums_out=False)
    return _pack_pass(case, whole, array)


def pack_passes(case: LayerCase, array: ArrayConfig) -> list[PackedLayer]:
    """Every pass over parts of the output channels and blocks of the input's, see `macram.spec.layer_passes`.

    Raises:
        ValueError: the array does not admit even one tile of the layer; the line names the limit.
    """
    return [_pack_pass(case, part, array) for part in layer_passes(case.spec, array)]


def _pack_pass(case: LayerCase, part: LayerPass, array: ArrayConfig) -> PackedLayer:
    """Weights of the pass; the requantiser takes the sums of all input channels."""
    channels = slice(part.c_out.start, part.c_out.stop)
    weights = case.weights[channels]
    words = array.requant_words(part.layer)
    if part.sums_out:
        requant = absent_requant(array, words)
    else:
        whole = dataclasses.replace(part.layer, c_in=case.spec.c_in)
        rule = derive_requant(whole, case.scale[channels], case.offset[channels])
        requant = pack_requant(rule, Rise.of(weights, whole, array), array, words)
    block = weights[:, part.c_in.start : part.c_in.stop]
    return PackedLayer(
        part.layer, array, pack_weights(block, part.layer, array), requant, part.sums_in, part.sums_out
    )


def unpack(packed: PackedLayer) -> tuple[NDArray[np.int64], ThresholdRequant | ShiftRequant]:
    """Weights ``[c_out, c_in, kernel, kernel]`` and requantiser back from the words: the inverse of `pack_layer`.

    Of raised input codes (`macram.pack.signed`) the requantiser is rid again; its thresholds are those of
    `pack_layer` for every sum that the weights can give.

    Raises:
        ValueError: the words hold requantiser parameters that no layer can have, or are one block of a layer.
    """
    spec, array = packed.spec, packed.array
    if packed.sums_in or packed.sums_out:
        raise ValueError("one block of a layer has no requantiser to its weights; unpack whole layers")
    weights = unpack_weights(packed.weights, spec, array)
    rise = Rise.of(weights, spec, array)
    for name, found, wanted in zip(
        ("left", "right"), unpack_borders(packed.requant, spec, array), (rise.left, rise.right), strict=False
    ):
        if (found != wanted).any():
            raise ValueError(f"the {name} border terms do not follow from the weights; pack the layer again")
    return weights, unpack_requant(packed.requant, rise, spec, array)


def read_packed(folder: Path) -> PackedLayer:
    """Read what `PackedLayer.write` wrote, after checking the SHA-256 of every file.

    Raises:
        ValueError: one line naming the file: missing, changed, not listed, or not what the manifest says.
    """
    folder = Path(folder)
    spec, array, memories, roles = read_folder(folder)
    weights = np.stack([memories[f"unit_{unit:03d}"] for unit in range(array.units)])
    try:
        return PackedLayer(
            spec,
            array,
            np.ascontiguousarray(weights[:, : array.weight_words(spec)]),
            np.ascontiguousarray(memories["requant"][: array.requant_words(spec)]),
            **roles,
        )
    except ValueError as error:
        raise ValueError(f"{folder}: {error}") from error
