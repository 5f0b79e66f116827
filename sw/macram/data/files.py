"""Reading and writing files so that an error names the file and nothing is left half-written."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]


def read_json(path: Path) -> Any:
    """Parsed JSON.

    Raises:
        ValueError: no such file, or not JSON; one line that names it.
    """
    try:
        return json.loads(path.read_text())
    except FileNotFoundError:
        raise ValueError(f"{path}: file is missing") from None
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"{path}: not valid JSON ({error})") from None
    except RecursionError:
        raise ValueError(f"{path}: not valid JSON here (nested too deep)") from None


def read_object(path: Path) -> dict[str, Any]:
    """Parsed JSON whose outermost value is an object.

    Raises:
        ValueError: no such file, not JSON, or something else; one line that names it.
    """
    table = read_json(path)
    if not isinstance(table, dict):
        raise ValueError(f"{path}: expected a JSON object")
    return table


def read_lines(path: Path) -> list[str]:
    """Lines of a text file.

    Raises:
        ValueError: not text; one line that names it.
    """
    try:
        return path.read_text().splitlines()
    except UnicodeDecodeError as error:
        raise ValueError(f"{path}: not a text file ({error})") from None


def read_picture(path: Path, colour: bool, size: tuple[int, int] | None) -> Picture:
    """Decode a picture: ``[H, W, 3]`` RGB or ``[H, W]`` grey.

    Args:
        path: JPEG or PNG.
        colour: three channels, or one.
        size: width and height that it must have; None accepts any.

    Raises:
        ValueError: missing, not a picture, or another size; one line that names the file.
    """
    try:
        packed = np.fromfile(path, np.uint8)
    except FileNotFoundError:
        raise ValueError(f"{path}: file is missing") from None
    flags = (cv2.IMREAD_COLOR if colour else cv2.IMREAD_GRAYSCALE) | cv2.IMREAD_IGNORE_ORIENTATION
    picture = cv2.imdecode(packed, flags) if packed.size else None
    if picture is None:
        raise ValueError(f"{path}: not a readable picture; it may be cut off")
    height, width = picture.shape[:2]
    if size is not None and (width, height) != size:
        raise ValueError(f"{path}: {width}x{height} pixels, but this data set has {size[0]}x{size[1]}")
    if colour:
        picture = cv2.cvtColor(picture, cv2.COLOR_BGR2RGB)
    return np.asarray(picture, np.uint8)


def write_picture(path: Path, picture: Picture, quality: int = 95) -> None:
    """Encode ``[H, W, 3]`` RGB or ``[H, W]`` grey; the name's suffix picks the format."""
    content = cv2.cvtColor(picture, cv2.COLOR_RGB2BGR) if picture.ndim == 3 else picture
    options = (
        [cv2.IMWRITE_JPEG_QUALITY, quality] if path.suffix == ".jpg" else [cv2.IMWRITE_PNG_COMPRESSION, 6]
    )
    done, packed = cv2.imencode(path.suffix, content, options)
    if not done:
        raise ValueError(f"{path}: cannot write {path.suffix} pictures")
    path.write_bytes(packed.tobytes())


def write_text(path: Path, text: str) -> None:
    """Replace ``path`` in one step."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        temporary.write_text(text)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def write_json(path: Path, table: Any) -> None:
    """`write_text` of indented JSON with a final newline."""
    write_text(path, json.dumps(table, indent=1, allow_nan=False) + "\n")
