"""Contact sheets: pictures with box, mask outline and depth."""

from __future__ import annotations

import cv2
import numpy as np

from macram.data.files import Picture
from macram.data.frame import Frame
from macram.data.geometry import BOX_EDGES

BOX_COLOUR = (60, 255, 60)
MASK_COLOUR = (255, 60, 200)


def contact_sheet(frames: list[Frame], columns: int, cell: int = 256) -> Picture:
    """``[rows * cell, columns * cell, 3]`` RGB; each picture is fitted into a square cell.

    Raises:
        ValueError: no frames, or a file is missing or malformed.
    """
    if not frames or columns < 1:
        raise ValueError("a contact sheet needs at least one frame and one column")
    rows = -(-len(frames) // columns)
    sheet = np.zeros((rows * cell, columns * cell, 3), np.uint8)
    for number, frame in enumerate(frames):
        y, x = divmod(number, columns)
        picture = annotated(frame, cell)
        height, width = picture.shape[:2]
        sheet[y * cell : y * cell + height, x * cell : x * cell + width] = picture
    return sheet


def annotated(frame: Frame, longest: int) -> Picture:
    """The picture, longer side ``longest``, with mask outline, box or points, depth and bucket."""
    image, mask = frame.read_image(), frame.read_mask()
    factor = longest / max(image.shape[:2])
    size = (round(image.shape[1] * factor), round(image.shape[0] * factor))
    picture = np.ascontiguousarray(
        cv2.resize(image, size, interpolation=cv2.INTER_AREA if factor < 1 else cv2.INTER_LINEAR), np.uint8
    )
    large = cv2.resize(mask.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST)
    outlines, _ = cv2.findContours(large, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    cv2.drawContours(picture, outlines, -1, MASK_COLOUR, 1, cv2.LINE_AA)
    # Far outside the picture, or behind the camera, a point has no place that could be drawn.
    points = frame.points * factor - 0.5
    drawable = np.isfinite(points).all(axis=1) & (np.abs(points) < 8000).all(axis=1)
    places = [
        tuple(int(v) for v in np.rint(p * 16)) if ok else None for p, ok in zip(points, drawable, strict=True)
    ]
    if frame.model.is_box:
        for a, b in BOX_EDGES:
            start, end = places[a], places[b]
            if start is not None and end is not None:
                cv2.line(picture, start, end, BOX_COLOUR, 1, cv2.LINE_AA, 4)
    for place in places:
        if place is not None:
            cv2.circle(picture, place, 2 * 16, BOX_COLOUR, -1, cv2.LINE_AA, 4)
    text = f"{frame.translation[2] / frame.model.diameter:.1f}d {frame.bucket}"
    for colour, thick in (((0, 0, 0), 3), ((255, 255, 255), 1)):
        cv2.putText(picture, text, (5, 15), cv2.FONT_HERSHEY_SIMPLEX, 0.42, colour, thick, cv2.LINE_AA)
    return picture
