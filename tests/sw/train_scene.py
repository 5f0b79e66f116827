"""A small data set in SwissCube layout, drawn flat with OpenCV: made in milliseconds, exact labels."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np

from macram.data.geometry import project, turn

HALF = np.array([50.0, 50.0, 54.4])
CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * HALF
DIAMETER = float(np.linalg.norm(2 * HALF))
FACES = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
COLOURS = ((220, 60, 60), (60, 220, 60), (60, 60, 220), (220, 220, 60), (60, 220, 220), (220, 60, 220))


def write_scene(root: Path, counts=(8, 4), *, size=64, focal=76.0, seed=0) -> Path:
    """Splits training and validation of so many frames; a box with coloured faces on a grey gradient."""
    rng = np.random.default_rng(seed)
    camera = np.array([[focal, 0, size / 2], [0, focal, size / 2], [0, 0, 1]])
    for split, count in zip(("training", "validation"), counts, strict=True):
        folder = root / split / "seq_000000/000000"
        for part in ("rgb", "mask_visib", "background"):
            (folder / part).mkdir(parents=True)
        gt, cameras, names = {}, {}, []
        for number in range(count):
            axis = rng.normal(size=3)
            rotation = turn(axis / np.linalg.norm(axis), rng.uniform(0, np.pi))
            depth = rng.uniform(2.0, 4.0) * DIAMETER
            translation = np.array([*rng.uniform(-0.15, 0.15, 2) * depth, depth])
            image, mask, back = _draw(camera, rotation, translation, size)
            for part, picture in (("rgb", image), ("background", back)):
                cv2.imwrite(str(folder / part / f"{number:06d}.png"), picture[..., ::-1])
            (folder / f"background/{number:06d}.png").rename(folder / f"background/{number:06d}.jpg")
            cv2.imwrite(str(folder / f"mask_visib/{number:06d}_000000.png"), mask)
            gt[str(number)] = [
                {"cam_R_m2c": rotation.ravel().tolist(), "cam_t_m2c": translation.tolist(), "obj_id": 1}
            ]
            cameras[str(number)] = {"cam_K": camera.ravel().tolist()}
            names.append(f"{split}/seq_000000/000000/rgb/{number:06d}.png")
        (folder / "scene_gt.json").write_text(json.dumps(gt))
        (folder / "scene_camera.json").write_text(json.dumps(cameras))
        (root / f"{split}.txt").write_text("\n".join(names) + "\n")
    (root / "box_bbox.json").write_text(json.dumps([CORNERS.tolist()]))
    return root


def _draw(camera, rotation, translation, size):
    scale = 8
    ramp = np.linspace(20, 90, size, dtype=np.uint8)
    back = np.repeat(np.repeat(ramp[None, :, None], size, 0), 3, 2)
    big = cv2.resize(back, None, fx=scale, fy=scale, interpolation=cv2.INTER_NEAREST)
    mask = np.zeros(big.shape[:2], np.uint8)
    pixels = project(camera, rotation, translation[:, None], CORNERS) * scale - 0.5
    depth = (CORNERS @ rotation.T + translation)[:, 2]
    for face in sorted(range(6), key=lambda f: -depth[list(FACES[f])].mean()):
        polygon = np.rint(pixels[list(FACES[face])]).astype(np.int32)
        cv2.fillPoly(big, [polygon], COLOURS[face])
        cv2.fillPoly(mask, [polygon], 255)
    shrink = {"dsize": (size, size), "interpolation": cv2.INTER_AREA}
    return (
        cv2.resize(big, **shrink),
        np.where(cv2.resize(mask, **shrink) > 127, 255, 0).astype(np.uint8),
        back,
    )
