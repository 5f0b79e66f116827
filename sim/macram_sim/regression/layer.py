"""What one run of a case takes and what it must give, by the golden model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from macram.driver import Beats
from macram.golden import ResidualRule, random_case, run_layer
from macram.golden.conv import conv2d
from macram.layer_file import LayerCase
from macram.pack import PackedLayer, pack_passes
from macram.pack.signed import Rise
from macram.spec import RESIDUAL, ArrayConfig, ConvSpec, LayerPass, StreamLayout, SumLayout, layer_passes
from macram_sim.regression.plan import Case
from macram_sim.regression.settings import BLOCKS

Codes = NDArray[np.int64]


def draw_layer(case: Case, other: int = 0) -> LayerCase:
    """The case's layer, or with ``other`` above 0 another one of its shape."""
    layer = random_case(case.spec, case.seed + other, "uniform" if other else case.kind)
    if not case.bias_alone:
        return layer
    sums = conv2d(layer.input, layer.weights, stride=case.spec.stride, padding=case.spec.padding)
    middle = (case.spec.output.lo + case.spec.output.hi + 1) // 2
    offset = middle - np.rint(np.median(sums.reshape(len(sums), -1), axis=1))
    return replace(layer, scale=np.ones(case.spec.c_out), offset=offset)


@dataclass(frozen=True, eq=False)
class ResidualSum:
    """A residual sum: its rule, and the stream to add to, codes ``[c_out, out_height, out_width]``."""

    rule: ResidualRule
    stream: Codes


@dataclass(frozen=True, eq=False)
class LayerRun:
    """One run over an image: a whole layer, or one of its passes.

    Attributes:
        layer: the whole layer.
        part: the channels of this run, and whether sums come in and go out.
        packed: its words.
        residual: the sum behind it, or None.
    """

    layer: LayerCase
    part: LayerPass
    packed: PackedLayer
    residual: ResidualSum | None

    @classmethod
    def of(cls, layer: LayerCase, case: Case, array: ArrayConfig) -> LayerRun:
        """The run of ``layer`` that ``case`` takes; of several alike one that its seed draws."""
        passes = zip(layer_passes(layer.spec, array), pack_passes(layer, array), strict=True)
        alike = [
            (part, packed) for part, packed in passes if (part.sums_in, part.sums_out) == BLOCKS[case.block]
        ]
        part, packed = alike[case.seed % len(alike)]
        residual = draw_residual(part.layer, case.seed) if case.residual else None
        return cls(layer, part, packed, residual)

    @property
    def spec(self) -> ConvSpec:
        """The run's shape."""
        return self.part.layer

    @property
    def array(self) -> ArrayConfig:
        """What it is packed for."""
        return self.packed.array

    @property
    def image(self) -> Codes:
        """The run's input channels."""
        return self.layer.input[self.part.c_in.start : self.part.c_in.stop]

    @cached_property
    def addends(self) -> Codes | None:
        """What the array must be given to start from: its sums over the input channels before this run's."""
        before = self.part.c_in.start
        return self._on_array(self._sums_over(before), before) if self.part.sums_in else None

    @cached_property
    def sums(self) -> Codes:
        """Sums over the input channels up to this run's last."""
        return self._sums_over(self.part.c_in.stop)

    def _sums_over(self, channels: int) -> Codes:
        codes, weights = self.layer.input[:channels], self._weights(channels)
        return conv2d(codes, weights, stride=self.spec.stride, padding=self.spec.padding).astype(np.int64)

    def _on_array(self, sums: Codes, channels: int) -> Codes:
        """``sums`` as the array has them: signed codes on unsigned inputs are raised, and so is most of the padding."""
        rise = Rise.of(self._weights(channels), self.spec, self.array)
        raised = sums + rise.total[:, None, None]
        raised[:, :, 0] -= rise.left[:, None]
        raised[:, :, -1] -= rise.right[:, None]
        return raised

    def _weights(self, channels: int) -> Codes:
        return self.layer.weights[self.part.c_out.start : self.part.c_out.stop, :channels]

    @cached_property
    def branch(self) -> Codes:
        """What the requantiser gives."""
        return run_layer(self.layer)[self.part.c_out.start : self.part.c_out.stop]

    @cached_property
    def wanted(self) -> dict[str, Codes]:
        """What must leave on each output: ``output``, with a residual sum ``residual sums`` too."""
        if self.part.sums_out:
            return {"output": self._on_array(self.sums, self.part.c_in.stop)}
        if self.residual is None:
            return {"output": self.branch}
        sums, codes = self.residual.rule.apply(self.branch, self.residual.stream)
        return {"output": codes, "residual sums": sums}

    @cached_property
    def beats(self) -> Mapping[str, Beats]:
        """Beats of every input that takes part: ``image``, ``params`` (partial sums), ``residual``."""
        array = self.array
        beats = {"image": StreamLayout(self.spec.c_in, self.spec.input, array.stream_bits).pack(self.image)}
        if self.addends is not None:
            beats["params"] = SumLayout(self.spec, array).pack(self.addends)
        if self.residual is not None:
            beats["residual"] = self._wide.pack(self.residual.stream)
        return beats

    @property
    def beats_out(self) -> dict[str, int]:
        """Number of beats of every output that takes part."""
        pixels = self.spec.out_height * self.spec.out_width
        if self.part.sums_out:
            return {"output": SumLayout(self.spec, self.array).beats}
        counts = {"output": pixels * self._narrow.beats_per_pixel}
        if self.residual is not None:
            counts["residual sums"] = pixels * self._wide.beats_per_pixel
        return counts

    def unpack(self, name: str, beats: Beats) -> Codes:
        """Codes or sums of an output's beats."""
        if name == "output" and self.part.sums_out:
            return SumLayout(self.spec, self.array).unpack(beats)
        layout = self._narrow if name == "output" else self._wide
        return layout.unpack(beats, self.spec.out_height, self.spec.out_width)

    @property
    def _narrow(self) -> StreamLayout:
        return StreamLayout(self.spec.c_out, self.array.output, self.array.stream_bits)

    @property
    def _wide(self) -> StreamLayout:
        return StreamLayout(self.spec.c_out, RESIDUAL, self.array.residual_stream_bits)


def draw_residual(spec: ConvSpec, seed: int) -> ResidualSum:
    """A rule and a stream behind a layer; every fourth stream lies at the ends of its range."""
    rng = np.random.default_rng(seed)
    codes = 1 << spec.output.bits
    rule = ResidualRule(spec.output, rng.integers(0, 256, codes), np.sort(rng.integers(0, 256, codes - 1)))
    shape = (spec.c_out, spec.out_height, spec.out_width)
    ends = np.array([RESIDUAL.lo, RESIDUAL.hi])
    stream = rng.choice(ends, shape) if seed % 4 == 0 else rng.integers(0, 256, shape)
    return ResidualSum(rule, stream)
