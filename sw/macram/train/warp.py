"""Views as tensors: pictures warped, toned and normalised on the device where the network runs."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor
from torch.nn import functional

from macram.data.erase import GROWTH
from macram.model import Levels
from macram.model.anchors import cell_centres, map_sizes
from macram.pose.warp import BORDER
from macram.train.pack import PART, PackedFrames
from macram.train.pictures import DEVIATION, MEAN, draw_pictures, pictures_compiled, seen_mask
from macram.train.views import Views

NOISE_BANK = 1 << 22
NOISE_STRIDE = 64
"""Noise of a view is cut out of one bank of normal numbers: drawing a new one would cost more than the warp."""
RESIDENT_SHARE = 0.6
"""Packed frames go to the GPU as a whole if they fill at most this share of its free memory."""


class Cells:
    """Cells of all levels in one row, P3 first.

    Attributes:
        counts: of each level.
        centres: ``[cells, 2]`` pixels.
        sampled: ``[cells, 2]``, centre of the pixel that decides whether a cell lies on the target.
        anchors: ``[cells]`` pixels.
    """

    def __init__(self, levels: Levels, size: tuple[int, int], device: torch.device) -> None:
        maps = map_sizes(*size, len(levels.strides))
        self.counts = [rows * columns for rows, columns in maps]
        centres = [
            cell_centres(*m, stride).flatten(0, 1) for m, stride in zip(maps, levels.strides, strict=True)
        ]
        self.centres = torch.cat(centres).to(device)
        last = torch.tensor([size[1] - 1, size[0] - 1], device=device)
        self.sampled = torch.minimum(self.centres.floor(), last) + 0.5
        anchors = [torch.full((n,), float(a)) for n, a in zip(self.counts, levels.anchors, strict=True)]
        self.anchors = torch.cat(anchors).to(device)

    def __len__(self) -> int:
        return sum(self.counts)


class Batch(NamedTuple):
    """What a training step reads.

    Attributes:
        image: ``[B, 3, H, W]`` normalised.
        erased: the same without the target; None where no path needs it.
        inside: bool ``[B, cells]``, cells that may be positive.
        keys: float32 ``[B, cells]``.
        quota: int64 ``[B, levels]``.
        camera: float32 ``[B, 3, 3]``.
        rotation: float32 ``[B, 3, 3]``.
        translation: float32 ``[B, 3]``.
        points: float32 ``[B, K, 3]``.
        pixels: float32 ``[B, K, 2]``.
    """

    image: Tensor
    erased: Tensor | None
    inside: Tensor
    keys: Tensor
    quota: Tensor
    camera: Tensor
    rotation: Tensor
    translation: Tensor
    points: Tensor
    pixels: Tensor


class Warper:
    """Makes batches of views.

    Args:
        frames: packed; kept in GPU memory as a whole where they fit.
        device: where to.
        seed: of the noise bank.
        counterfactual: make the pictures without the target too.
    """

    def __init__(
        self, frames: PackedFrames, device: torch.device, seed: int, *, counterfactual: bool
    ) -> None:
        self.frames, self.device, self.counterfactual = frames, device, counterfactual
        self.in_one_pass = device.type == "cpu" and not counterfactual and pictures_compiled()
        bank = torch.randn(NOISE_BANK, generator=torch.Generator().manual_seed(seed))
        self.bank = bank.to(device)
        self.mean, self.deviation = (value.to(device).reshape(3, 1, 1) for value in (MEAN, DEVIATION))
        height, width = frames.size
        self.scale = torch.tensor([2 / width, 2 / height], device=device)
        self.resident = None
        self.resident_filled = None
        if device.type == "cuda":
            filled = frames.filled if counterfactual else None
            total = frames.pixels.nbytes + (0 if filled is None else filled.nbytes)
            if total <= RESIDENT_SHARE * torch.cuda.mem_get_info(device)[0]:
                self.resident = _moved(frames.pixels, device)
                self.resident_filled = None if filled is None else _moved(filled, device)

    @staticmethod
    def noise_places(size: tuple[int, int]) -> int:
        """In how many places the noise of a view of this size may start.

        Raises:
            ValueError: there is not enough of it for a single view.
        """
        if 3 * size[0] * size[1] > NOISE_BANK:
            raise ValueError(
                f"views of {size[1]}x{size[0]} pixels are too large to train on, {NOISE_BANK // 3:,} pixels at most; "
                "set data.shrink or crops.sizes"
            )
        return (NOISE_BANK - 3 * size[0] * size[1]) // NOISE_STRIDE + 1

    def batch(self, views: Views, cells: Cells, size: tuple[int, int]) -> Batch:
        """Pictures and targets of ``views`` of ``size`` (height, width)."""
        image, erased, inside = (self._drawn if self.in_one_pass else self._warped)(views, cells, size)
        arrays = (views.camera, views.rotation, views.translation, views.points, views.pixels)
        return Batch(
            image,
            erased,
            inside,
            self._sent(views.keys),
            self._sent(views.quota),
            *(self._sent(array.astype(np.float32)) for array in arrays),
        )

    def _drawn(self, views: Views, cells: Cells, size: tuple[int, int]) -> tuple[Tensor, None, Tensor]:
        """As `_warped`, up to single grey levels of single pixels, in a third of the time."""
        image = torch.empty((len(views.frame), 3, *size), memory_format=torch.channels_last)
        draw_pictures(self.frames.pixels, views, self.bank, NOISE_STRIDE, image)
        return image, None, seen_mask(self.frames.pixels, views, cells.sampled) > PART

    def _warped(
        self, views: Views, cells: Cells, size: tuple[int, int]
    ) -> tuple[Tensor, Tensor | None, Tensor]:
        """Pictures, erased pictures where wanted, and which cells may be positive."""
        source = self._read(self.frames.pixels, self.resident, views)
        colour, mask = source[:, :3], source[:, 3:]
        grid = self._grid(views.matrix, size)
        apart = views.other is not views.matrix and not np.array_equal(views.other, views.matrix)
        image = self._toned(_sampled(colour, grid), views)
        erased = None
        if self.counterfactual:
            other = self._grid(views.other, size) if apart else grid
            if self.frames.filled is not None:
                erased = _sampled(self._read(self.frames.filled, self.resident_filled, views), other)
                erased = self._toned(erased, views)
            else:
                erased = self._toned(_sampled(colour, other), views) if apart else image
                grown = functional.max_pool2d(mask, 2 * GROWTH + 1, 1, GROWTH)
                erased = erased * (functional.grid_sample(grown, other, "nearest", align_corners=False) < 0.5)
        erased = None if erased is None else self._normalised(erased)
        return self._normalised(image), erased, self._inside(mask, views, cells)

    def _sent(self, array: NDArray[Any]) -> Tensor:
        """On the device. From ordinary memory the copy would wait for all that the GPU still has to do."""
        tensor = torch.from_numpy(array)
        if self.device.type != "cuda":
            return tensor
        return tensor.pin_memory().to(self.device, non_blocking=True)

    def _read(self, packed: NDArray[np.uint8], resident: Tensor | None, views: Views) -> Tensor:
        """Float ``[B, channels, H, W]``, 0..255."""
        rows = self._sent(packed[views.frame]) if resident is None else resident[self._sent(views.frame)]
        return rows.permute(0, 3, 1, 2).contiguous().float()  # bytes are moved faster than floats

    def _grid(self, matrix: NDArray[np.float64], size: tuple[int, int]) -> Tensor:
        """Sampling grid ``[B, H, W, 2]``: pixel centres of the view, in the frame, -1..1 from edge to edge."""
        height, width = self.frames.size
        frame = np.array([[2 / width, 0, -1], [0, 2 / height, -1], [0, 0, 1]])
        theta = (frame @ np.linalg.inv(matrix))[:, :2].astype(np.float32)
        # As functional.affine_grid, whose matrix product with three columns takes twice as long.
        across, down, shift = self._sent(theta)[:, None, None].unbind(-1)
        rows, columns = (torch.arange(0.5, n, device=self.device) for n in size)
        return across * columns[:, None] + (down * rows[:, None, None] + shift)

    def _inside(self, mask: Tensor, views: Views, cells: Cells) -> Tensor:
        back = self._sent(np.linalg.inv(views.matrix).astype(np.float32))
        places = cells.sampled @ back[:, :2, :2].mT + back[:, None, :2, 2]
        grid = (places * self.scale - 1)[:, None]
        return functional.grid_sample(mask, grid, "nearest", align_corners=False)[:, 0, 0] > PART

    def _toned(self, image: Tensor, views: Views) -> Tensor:
        """Brightness and noise; rounded and clipped to what 8 bits hold."""
        if (views.tone == (1.0, 1.0, 0.0)).all():
            return image.round_()
        gamma, gain, level = self._sent(views.tone.astype(np.float32))[:, :, None, None, None].unbind(1)
        # Interpolation may leave -1e-6, whose power is no number.
        image = image.clamp_min_(0).div_(255).pow_(gamma).mul_(255 * gain)
        if (views.tone[:, 2] > 0).any():
            count = image[0].numel()
            places = self.bank.unfold(0, count, NOISE_STRIDE)
            noise = places[self._sent(views.noise)].reshape(image.shape)
            image.addcmul_(noise, level.expand_as(image))
        return image.round_().clamp_(0, 255)

    def _normalised(self, image: Tensor) -> Tensor:
        """0..255 -> ImageNet's mean 0 and deviation 1, channels last."""
        return (image - self.mean).div_(self.deviation).contiguous(memory_format=torch.channels_last)


def _moved(array: NDArray[np.uint8], device: torch.device) -> Tensor:
    """A memory map on the device, copied in pieces so that the host never holds it twice."""
    result = torch.empty(array.shape, dtype=torch.uint8, device=device)
    for start in range(0, len(array), 256):
        result[start : start + 256] = torch.from_numpy(np.array(array[start : start + 256]))
    return result


def _sampled(image: Tensor, grid: Tensor) -> Tensor:
    """Bilinear, with the border's grey outside."""
    inner = functional.grid_sample(image - BORDER, grid, "bilinear", "zeros", align_corners=False)
    return inner.add_(BORDER)
