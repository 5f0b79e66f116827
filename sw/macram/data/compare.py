"""Frames of a rendered data set beside Mitsuba's picture of the same scenes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from macram.data.files import Picture, read_json
from macram.data.frame import Frame
from macram.data.open import open_dataset
from macram.data.render.cubesat import DIAMETER_MM, SIZE_MM
from macram.data.render.earth import Earth
from macram.data.render.mitsuba_scene import scene_of, silhouette_of, trace
from macram.data.render.plan import Plan, View, plan_sequence
from macram.data.render.sensor import Stars, develop, gain, grain
from macram.data.render.sequence import STAR_LIGHT
from macram.data.spec import SPLITS, RenderSpec
from macram.data.write import first_number

OURS_ONLY = (255, 70, 70)
MITSUBA_ONLY = (70, 130, 255)
BOTH = (70, 70, 70)


@dataclass(frozen=True, eq=False)
class Compared:
    """One frame, twice.

    Attributes:
        name: of the frame.
        ours: ``[H, W, 3]`` the picture of the data set.
        theirs: ``[H, W, 3]`` Mitsuba's, through the same sensor.
        our_mask: ``[H, W]`` of the data set.
        their_mask: ``[H, W]`` where Mitsuba's target covers half a pixel or more.
    """

    name: str
    ours: Picture
    theirs: Picture
    our_mask: NDArray[np.bool_]
    their_mask: NDArray[np.bool_]

    @property
    def overlap(self) -> float:
        """Intersection over union of the silhouettes; 1 where neither shows the target."""
        union = int((self.our_mask | self.their_mask).sum())
        return float((self.our_mask & self.their_mask).sum() / union) if union else 1.0

    @property
    def row(self) -> Picture:
        """``[H, 3 W, 3]``: ours, Mitsuba's, difference of the silhouettes."""
        difference = np.zeros_like(self.ours)
        difference[self.our_mask & self.their_mask] = BOTH
        difference[self.our_mask & ~self.their_mask] = OURS_ONLY
        difference[~self.our_mask & self.their_mask] = MITSUBA_ONLY
        return np.concatenate([self.ours, self.theirs, difference], axis=1)


def chosen_frames(root: Path, split: str | None, number: int) -> tuple[RenderSpec, list[Frame]]:
    """The specification of a rendered data set and ``number`` frames spread over one split.

    Raises:
        ValueError: not rendered by this program in SwissCube's layout, or the split is empty.
    """
    if number < 1:
        raise ValueError(f"--frames must be 1 or more, not {number}")
    about = read_json(root / "dataset.json")
    table: dict[str, Any] = dict(about.get("spec", {})) if isinstance(about, dict) else {}
    table.pop("generator", None)
    fields: dict[str, Any] = {n: tuple(v) if isinstance(v, list) else v for n, v in table.items()}
    try:
        spec = RenderSpec(**fields)
    except TypeError:
        raise ValueError(f"{root / 'dataset.json'}: not from `macram data render`") from None
    if about.get("spec_sha256") != spec.fingerprint() or spec.format != "bop":
        raise ValueError(
            f"{root}: only data sets of this version's `macram data render --format bop` can be compared"
        )
    dataset = open_dataset(root)
    frames = dataset.frames(split or dataset.splits[0])
    if not frames:
        raise ValueError(f"{root}: split {split or dataset.splits[0]} is empty")
    places = np.linspace(0, len(frames) - 1, min(number, len(frames))).round().astype(int)
    return spec, [frames[place] for place in np.unique(places)]


def compare(spec: RenderSpec, frame: Frame, samples: int) -> Compared:
    """Render one frame again with Mitsuba.

    Args:
        spec: of the data set.
        frame: of it.
        samples: rays per pixel.

    Raises:
        ValueError: Mitsuba is not installed, or the frame is not what ``spec`` makes.
    """
    view = View(*spec.size, spec.focal)
    plan, number = _plan_of(spec, frame, view)
    scene = scene_of(plan, Earth(plan), number, view, samples)
    light = trace(scene)[..., :3]
    coverage = trace(silhouette_of(scene))[..., 3]
    mask = coverage >= 0.5
    exposure = gain(light, light[mask]) * float(plan.gains[number])
    starry, grid = light.copy(), np.array([[1, 0, -0.5], [0, 1, -0.5], [0, 0, 1.0]]) @ view.matrix
    Stars(plan.weather).add(starry, plan.cameras[number], grid, STAR_LIGHT / exposure)
    light = light + (starry - light) * (1 - coverage[..., None])
    return Compared(
        name=frame.name,
        ours=frame.read_image(),
        theirs=develop(light, exposure, grain(light.shape[:2], plan.grain[number])),
        our_mask=frame.read_mask(),
        their_mask=mask,
    )


def comparison_sheet(rows: list[Compared]) -> Picture:
    """``[sum of H, 3 W, 3]`` one row per frame, with captions."""
    pictures = []
    for compared in rows:
        picture = np.ascontiguousarray(compared.row)
        width = picture.shape[1] // 3
        captions = ("macram", "Mitsuba", f"overlap {100 * compared.overlap:.1f} %")
        for place, caption in enumerate(captions):
            for colour, thick in (((0, 0, 0), 3), ((255, 255, 255), 1)):
                where = (place * width + 5, 15)
                cv2.putText(
                    picture, caption, where, cv2.FONT_HERSHEY_SIMPLEX, 0.42, colour, thick, cv2.LINE_AA
                )
        pictures.append(picture)
    return np.concatenate(pictures)


def _plan_of(spec: RenderSpec, frame: Frame, view: View) -> tuple[Plan, int]:
    """The plan that made a frame, and the frame's number in it."""
    split, folder, _, name = frame.name.split("/")
    place, number = SPLITS.index(split), int(name)
    sequence = int(folder.removeprefix("seq_")) - first_number(spec, place)
    depth = (spec.depth[0] * DIAMETER_MM, spec.depth[1] * DIAMETER_MM)
    plan = plan_sequence((spec.seed, place, sequence), spec.frames, view, depth, float(SIZE_MM.max()))
    if not np.allclose(plan.translations[number], frame.translation, atol=1e-3):
        raise ValueError(f"{frame.image}: its pose is not the one that dataset.json's seed gives")
    return plan, number
