"""One convolution layer with its data, in memory and as an ``.npz`` file."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from macram.spec import ConvSpec, IntFormat

ARRAYS = ("weights", "input", "scale", "offset")
SCALARS = ("weight_bits", "input_bits", "output_bits", "stride", "padding")
SWITCHES = ("input_signed", "output_signed")
KEYS = ARRAYS + SCALARS + SWITCHES
PLAIN = "save plain arrays with numpy.savez"
"""The fix for every file that is not what it should be."""


@dataclass(frozen=True, eq=False)
class LayerCase:
    """A layer, its codes and its requantisation, checked against each other.

    The output code of channel c is ``clip(rint(scale[c] * acc + offset[c]), lo, hi)`` in float64, half to
    even, where ``acc`` is the exact integer convolution. The arrays are kept as read-only copies.

    Attributes:
        spec: shapes and formats.
        weights: integer codes ``[c_out, c_in, kernel, kernel]`` in ``spec.weight``, kept as int64.
        input: integer codes ``[c_in, height, width]`` in ``spec.input``, kept as int64.
        scale: finite, of any floating-point type, ``[c_out]``, kept as float64; may be negative or zero.
        offset: likewise.

    Raises:
        ValueError: an array has the wrong shape, is not of integers (or floats), or holds a value outside
            its format; the line names the array, the value and the fix.
    """

    spec: ConvSpec
    weights: NDArray[np.int64]
    input: NDArray[np.int64]
    scale: NDArray[np.float64]
    offset: NDArray[np.float64]

    def __post_init__(self) -> None:
        spec = self.spec
        kernel = (spec.c_out, spec.c_in, spec.kernel, spec.kernel)
        checked = {
            "weights": _codes("weights", self.weights, kernel, spec.weight),
            "input": _codes("input", self.input, (spec.c_in, spec.height, spec.width), spec.input),
            "scale": _reals("scale", self.scale, spec.c_out),
            "offset": _reals("offset", self.offset, spec.c_out),
        }
        for name, array in checked.items():
            array.flags.writeable = False
            object.__setattr__(self, name, array)

    @classmethod
    def load(cls, path: Path) -> LayerCase:
        """Read a layer file.

        Keys: ``weights``, ``input``, ``scale``, ``offset``; integer scalars ``weight_bits``, ``input_bits``,
        ``output_bits`` (2 to 8), ``stride``, ``padding``; optional ``input_signed`` and ``output_signed``
        (0 or 1, 0 when absent). Weights are always signed.

        Raises:
            ValueError: one line naming the file, the key, the value and the fix.
        """
        try:
            return cls._from_arrays(_read(Path(path)))
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error

    @classmethod
    def _from_arrays(cls, arrays: dict[str, NDArray[np.generic]]) -> LayerCase:
        if unknown := sorted(set(arrays) - set(KEYS)):
            raise ValueError(f"unknown key {unknown[0]!r}; remove it, known keys are {', '.join(KEYS)}")
        if missing := [key for key in ARRAYS + SCALARS if key not in arrays]:
            raise ValueError(
                f"key {missing[0]!r} is missing; add it, needed are {', '.join(ARRAYS + SCALARS)}"
            )
        for key, axes in (("weights", "c_out, c_in, k, k"), ("input", "c_in, height, width")):
            if arrays[key].ndim != axes.count(",") + 1:
                raise ValueError(f"{key} must have the shape [{axes}], not {list(arrays[key].shape)}")
        c_out, c_in, kernel, across = arrays["weights"].shape
        if kernel != across:
            raise ValueError(f"weights must have a square kernel, not {kernel}x{across}")
        number = {key: _scalar(key, arrays[key]) for key in SCALARS + SWITCHES if key in arrays}
        for key in ("weight_bits", "input_bits", "output_bits"):
            if not 2 <= number[key] <= 8:
                raise ValueError(f"{key} must be in 2..8, not {number[key]}")
        for key in SWITCHES:
            if number.get(key, 0) not in (0, 1):
                raise ValueError(f"{key} must be 0 or 1, not {number[key]}")
        spec = ConvSpec(
            c_in=c_in,
            c_out=c_out,
            height=arrays["input"].shape[1],
            width=arrays["input"].shape[2],
            kernel=kernel,
            stride=number["stride"],
            padding=number["padding"],
            weight=IntFormat(number["weight_bits"], signed=True),
            input=IntFormat(number["input_bits"], signed=bool(number.get("input_signed", 0))),
            output=IntFormat(number["output_bits"], signed=bool(number.get("output_signed", 0))),
        )
        return cls(spec, **{key: arrays[key] for key in ARRAYS})  # type: ignore[arg-type]

    def save(self, path: Path) -> None:
        """Write a layer file that `load` reads back unchanged; codes are stored as int8 where they fit.

        The file appears under its name only when it is complete.

        Raises:
            ValueError: the folder does not exist or cannot be written.
        """
        path, spec = Path(path), self.spec
        entries = {
            "weights": self.weights.astype(np.int8 if spec.weight.bits <= 8 else np.int64),
            "input": self.input.astype(np.int8 if spec.input.hi <= 127 else np.int64),
            "scale": self.scale,
            "offset": self.offset,
            "weight_bits": spec.weight.bits,
            "input_bits": spec.input.bits,
            "output_bits": spec.output.bits,
            "stride": spec.stride,
            "padding": spec.padding,
            "input_signed": int(spec.input.signed),
            "output_signed": int(spec.output.signed),
        }
        try:
            with tempfile.TemporaryDirectory(dir=path.parent, prefix=f".{path.name}-") as folder:
                complete = Path(folder) / "layer.npz"
                np.savez_compressed(complete, **entries)  # type: ignore[arg-type]
                complete.replace(path)
        except OSError as error:
            raise ValueError(f"{path}: cannot be written, {error.strerror}; choose another path") from error


def _read(path: Path) -> dict[str, NDArray[np.generic]]:
    """Every array of the file by its key; a `ValueError` of one line whatever the file holds."""
    try:
        loaded = np.load(path, allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            raise ValueError("one array, no archive")
        with loaded as archive:
            arrays = {key: archive[key] for key in archive.files}
    except FileNotFoundError as error:
        raise ValueError("no such file") from error
    except OSError as error:
        raise ValueError(f"cannot be read, {error.strerror or error}; {PLAIN}") from error
    except MemoryError as error:
        raise ValueError(f"claims arrays that do not fit into memory; {PLAIN}") from error
    except Exception as error:
        # Beneath are zipfile, four decompressors and NumPy's header parser, each with errors of its own, and
        # nobody promises a closed list. Nothing but reading this file happens here.
        raise ValueError(f"is not a whole .npz file of plain arrays; {PLAIN}") from error
    for key, array in arrays.items():
        # NumPy hands out a member that is no array as its raw bytes.
        if not isinstance(array, np.ndarray):
            raise ValueError(f"key {key!r} is not an array; {PLAIN}")
    return arrays


def _scalar(key: str, value: NDArray[np.generic]) -> int:
    if value.ndim or value.dtype.kind not in "iu":
        raise ValueError(f"{key} must be one integer, not {value.dtype} of shape {list(value.shape)}")
    return int(value)


def _codes(key: str, value: object, shape: tuple[int, ...], form: IntFormat) -> NDArray[np.int64]:
    array = np.asarray(value)
    if array.shape != shape:
        raise ValueError(f"{key} must have the shape {list(shape)}, not {list(array.shape)}")
    if array.dtype.kind not in "iu":
        raise ValueError(f"{key} must hold integer codes, not {array.dtype}; round and cast them first")
    if not form.holds(array):
        wrong = int(array.min()) if array.min() < form.lo else int(array.max())
        raise ValueError(
            f"{key} codes must lie in {form.lo}..{form.hi} ({form}), not {wrong}; "
            f"clip them or set more {'weight' if key == 'weights' else key}_bits"
        )
    return np.array(array, np.int64)


def _reals(key: str, value: object, channels: int) -> NDArray[np.float64]:
    array = np.asarray(value)
    if array.shape != (channels,):
        raise ValueError(
            f"{key} must have the shape [{channels}], one per output channel, not {list(array.shape)}"
        )
    if array.dtype.kind != "f":
        raise ValueError(f"{key} must hold floating-point numbers, not {array.dtype}; use astype(float)")
    with np.errstate(over="ignore"):
        kept = np.array(array, np.float64)
    bad = np.flatnonzero(~np.isfinite(kept))
    if bad.size:
        raise ValueError(
            f"{key} must be finite, not {kept[bad[0]]} in channel {bad[0]}; mend the layer it came from"
        )
    return kept
